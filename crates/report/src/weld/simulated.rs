//! Results of a simulated pass in words and numbers.

use super::axis_units::units;
use super::figures::ClearanceFigures;
use crate::number::{Significant as _, significant, small};
use crate::{Block, Language, Table, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_simulation::Summary;

pub(super) fn simulation_text(s: &Summary, assumed: &[String], language: Language) -> String {
    let mut text = vec![Message::new("report-simulation").text("seed", s.seed.to_string())];
    text.extend(s.axes.iter().max_by(|a, b| a.current.total_cmp(&b.current)).map(|a| {
        let message = Message::new("report-highest-load").axis("axis", &a.axis);
        message.significant("load", 100.0 * a.current, Unit::Percent, 3)
    }));
    if !assumed.is_empty() {
        text.push(Message::new("report-assumed-drives").text("axes", assumed.join(", ")));
    }
    let text: Vec<String> = text.iter().map(|message| message.in_language(language)).collect();
    language.sentences(&text)
}

pub(super) fn following_table(summary: &Summary, language: Language) -> Block {
    Table::of(language, &summary.axes)
        .text("report-column-axis", |a| a.axis.clone())
        .text("report-column-unit", |a| language.symbol(units(a.unit)[0]))
        .number("report-column-min", |a| small(a.following_error.min, language))
        .number("report-column-max", |a| small(a.following_error.max, language))
        .number("report-column-rms", |a| small(a.following_error.rms, language))
        .number("report-column-peak-load", |a| significant(100.0 * a.current, 3, language))
        .captioned("report-caption-following-table")
}

impl ClearanceFigures {
    /// Names the two objects with the minimum distance.
    pub(super) fn between_text(&self, language: Language) -> Option<String> {
        let [first, second] = self.nearest.clone()?;
        let pair = Message::new("report-pair").message("first", first).message("second", second);
        Some(pair.in_language(language))
    }
}
