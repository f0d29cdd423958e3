//! Results of a simulated pass in words and numbers.

use super::blocks::{small, table};
use super::chart_parts::units;
use super::figures::ClearanceFigures;
use crate::block::Block;
use crate::number::{Significant as _, significant};
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_simulation::Summary;

/// Describes the simulation and its result.
pub(super) fn simulation_text(s: &Summary, assumed: &[String], language: Language) -> String {
    let mut text = vec![Message::new("report-simulation").text("seed", s.seed.to_string())];
    text.extend(s.axes.iter().max_by(|a, b| a.current.total_cmp(&b.current)).map(|a| {
        Message::new("report-highest-load").axis("axis", &a.axis).significant(
            "load",
            100.0 * a.current,
            Unit::Percent,
            3,
        )
    }));
    if !assumed.is_empty() {
        text.push(Message::new("report-assumed-drives").text("axes", assumed.join(", ")));
    }
    let text: Vec<String> = text.iter().map(|message| message.in_language(language)).collect();
    language.sentences(&text)
}

pub(super) fn following_table(summary: &Summary, language: Language) -> Block {
    let rows = summary.axes.iter().map(|a| {
        let e = &a.following_error;
        vec![
            a.axis.clone(),
            language.symbol(units(a.unit)[0]),
            small(e.min, language),
            small(e.max, language),
            small(e.rms, language),
            significant(100.0 * a.current, 3, language),
        ]
    });
    let head = [
        "report-column-axis",
        "report-column-unit",
        "report-column-min",
        "report-column-max",
        "report-column-rms",
        "report-column-peak-load",
    ];
    let head = head.map(|head| language.words(head));
    table(&language.words("report-caption-following-table"), &head, rows.collect(), 2..6)
}

impl ClearanceFigures {
    /// Describes the minimum distance and its position.
    pub(super) fn nearest_text(&self, language: Language) -> Option<String> {
        let message = Message::new("report-nearest")
            .text("objects", self.between_text(language)?)
            .significant("distance", self.nearest_mm, Unit::Mm, 5)
            .significant("s", self.at_mm?, Unit::Mm, 5);
        Some(message.in_language(language))
    }

    /// Names the two objects with the minimum distance.
    pub(super) fn between_text(&self, language: Language) -> Option<String> {
        let [first, second] = self.nearest.clone()?;
        let pair = Message::new("report-pair").message("first", first).message("second", second);
        Some(pair.in_language(language))
    }
}
