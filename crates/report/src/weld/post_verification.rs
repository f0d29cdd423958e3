//! Verification of each part program written with the plan.

use crate::number::{NONE, Significant as _, fixed, number};
use crate::{Block, Language, Table, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_post::Verification;
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
    /// Creates the figures of a program in the file `file`, in the language `dialect`.
    pub fn new(dialect: &'static str, file: &str, tolerance_mm: f64, proof: Verification) -> Self {
        Self { dialect, file: file.to_owned(), tolerance_mm, proof }
    }

    pub(super) fn blocks(&self, language: Language) -> [Block; 2] {
        let text = Message::new("report-program")
            .text("file", &self.file)
            .text("dialect", self.dialect)
            .count("n", self.proof.moves)
            .significant("tolerance", self.tolerance_mm, Unit::Mm, 5)
            .in_language(language);
        let caption = Message::new("report-caption-program").text("file", &self.file).in_language(language);
        let worst = |worst: &Option<(f64, String)>, unit| match worst {
            Some((off, name)) => format!("{name} {}", quantity(*off, unit, 5).in_language(language)),
            None => NONE.to_owned(),
        };
        let process = |(off, name): &(f64, String)| (*off, value_names::value_title(language, name));
        let rows = self.proof.passes.iter().map(|pass| {
            let arc = number(pass.arc_s, language);
            if pass.as_it_stands {
                let none = || language.words("report-as-in-program");
                return [pass.name.clone(), none(), none(), none(), none(), arc, none()];
            }
            let speed = pass.speed_percent.max(pass.speed_inside_percent);
            [
                pass.name.clone(),
                fixed(pass.tip_mm, 5, language),
                worst(&pass.linear, Unit::Mm),
                worst(&pass.rotary, Unit::Deg),
                quantity(speed, Unit::Percent, 2).in_language(language),
                format!("{arc} ({})", signed_percent(pass.time_percent, language)),
                worst(&pass.process.as_ref().map(process), Unit::Percent),
            ]
        });
        let table = Table::of(language, rows)
            .text("report-column-pass", |row| row[0].clone())
            .number("report-column-tip-mm", |row| row[1].clone())
            .number("report-column-linear-axis", |row| row[2].clone())
            .number("report-column-rotary-axis", |row| row[3].clone())
            .number("report-column-tip-speed", |row| row[4].clone())
            .number("report-column-arc-on-s", |row| row[5].clone())
            .number("report-column-process-value", |row| row[6].clone());
        [Block::Paragraph(text), Block::Table(table.table(caption))]
    }
}

fn quantity(value: f64, unit: Unit, decimals: u8) -> Message {
    Message::new("quantity").quantity("value", value, unit, decimals)
}

/// Formats a percentage with its sign, also of positive ones.
fn signed_percent(percent: f64, language: Language) -> String {
    let sign = if percent < 0.0 { "" } else { "+" };
    format!("{sign}{}", quantity(percent, Unit::Percent, 4).in_language(language))
}
