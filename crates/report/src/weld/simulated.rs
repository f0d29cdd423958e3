//! Results of a simulated pass in words and numbers.

use super::figures::ClearanceFigures;
use super::page::{number, small, table};
use crate::Phrases as _;
use crate::{Block, Language, format_number, said};
use seamwright_cell::Summary;

/// Describes the simulation and its result.
pub(super) fn simulation_text(s: &Summary, assumed: &[String], language: Language) -> String {
    let mut text = vec![language.fill(
        "Every axis on its position loop at the servo period, with inertia, friction, cogging, encoder steps and current limit (seed {0}). It is the nominal part: no misplacement, no distortion, no fit-up error, no wire cast. Speed ripple is the greatest deviation of the tip's speed from the planned one, from half a second after the run-up to the run-down.",
        &[&s.seed.to_string()],
    )];
    text.extend(s.axes.iter().max_by(|a, b| a.current.total_cmp(&b.current)).map(|a| {
        let load = format_number(100.0 * a.current, 3);
        language.fill("The drive with the highest load is {0}: {1} % of its peak.", &[&a.axis, &load])
    }));
    if !assumed.is_empty() {
        let said = "The machine file describes no drive for {0}: assumed ones were used.";
        text.push(language.fill(said, &[&assumed.join(", ")]));
    }
    text.join(language.between_sentences())
}

pub(super) fn following_table(summary: &Summary, language: Language) -> Block {
    let rows = summary.axes.iter().map(|a| {
        let e = &a.following_error;
        vec![
            a.axis.clone(),
            language.unit(a.unit).to_owned(),
            small(e.min),
            small(e.max),
            small(e.rms),
            format_number(100.0 * a.current, 3),
        ]
    });
    let head = ["Axis", "Unit", "least", "greatest", "RMS", "Peak load, %"].map(|head| language.unit(head));
    table(language.say("Following error while the arc is on"), &head, rows.collect(), 2..6)
}

impl ClearanceFigures {
    /// Describes the minimum distance and its position.
    pub(super) fn nearest_text(&self, language: Language) -> Option<String> {
        let of = [self.between_text(language)?, number(self.nearest_mm), number(self.at_mm?)];
        Some(language.fill("Nearest: {0}, {1} mm apart at s = {2} mm.", &of.each_ref().map(String::as_str)))
    }

    /// Names the two objects with the minimum distance.
    pub(super) fn between_text(&self, language: Language) -> Option<String> {
        let between = self.between.as_ref()?;
        let pair = between
            .split_once(" and ")
            .map(|(a, b)| language.fill("{0} and {1}", &[&said::watched(language, a), &said::watched(language, b)]));
        Some(pair.unwrap_or_else(|| between.clone()))
    }
}
