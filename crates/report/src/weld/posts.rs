//! Verification of each part program written with the plan.

use super::page::{number, table};
use crate::Phrases as _;
use crate::{Block, Language, said};
use seamwright_post::{Dialect, Verification};
use serde::Serialize;

/// A part program written with the plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PostFigures {
    /// Name of the control's language.
    pub dialect: &'static str,
    /// File name.
    pub file: String,
    /// Maximum allowed distance between the path of the blocks and the planned path of the torch tip, mm.
    pub tolerance_mm: f64,
    /// Comparison of the text, read back, with the plan.
    pub proof: Verification,
}

impl PostFigures {
    /// Creates the figures of a part program in the file `file`.
    pub fn new(dialect: Dialect, file: &str, tolerance_mm: f64, proof: Verification) -> Self {
        Self { dialect: dialect.name(), file: file.to_owned(), tolerance_mm, proof }
    }

    /// Returns text and table for the page.
    pub(super) fn blocks(&self, language: Language) -> [Block; 2] {
        let text = language.fill(
            "{0} for {1}: {2} moves, read back, played by the control's own rules for interpolation and feeds, taken \
             through the machine's forward kinematics and compared with the plan; {3} mm are allowed.",
            &[&self.file, self.dialect, &self.proof.moves.to_string(), &number(self.tolerance_mm)],
        );
        let worst = |worst: &Option<(f64, String)>, unit: &str| match worst {
            Some((off, name)) => format!("{name} {} {}", small(*off), language.unit(unit)),
            None => "–".to_owned(),
        };
        let process = |(off, name): &(f64, String)| (*off, said::value_title(language, name));
        let rows = self.proof.passes.iter().map(|pass| {
            if pass.as_it_stands {
                let none = || language.say("as in the program").to_owned();
                return vec![pass.name.clone(), none(), none(), none(), none(), number(pass.arc_s), none()];
            }
            vec![
                pass.name.clone(),
                small(pass.tip_mm),
                worst(&pass.linear, "mm"),
                worst(&pass.rotary, "deg"),
                format!("{:.2} %", pass.speed_percent.max(pass.speed_inside_percent)),
                format!("{} ({:+.4} %)", number(pass.arc_s), pass.time_percent),
                worst(&pass.process.as_ref().map(process), "%"),
            ]
        });
        let head = ["pass", "Tip, mm", "Linear axis", "Rotary axis", "Tip speed", "Arc on, s", "Process value"];
        let caption = language.fill("Greatest deviations of {0}", &[&self.file]);
        let table = table(&caption, &head.map(|head| language.say(head)), rows.collect(), 1..7);
        [Block::Paragraph(text), table]
    }
}

fn small(value: f64) -> String {
    format!("{value:.5}")
}
