//! Times of the job before and after the travel.

use super::figures::WeldReport;
use super::range::Range;
use crate::number::number;
use crate::{Block, Language, Table, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_program::{Sequence, Slope};

/// A slope of process values: labels of its values and of its time, and its accessor.
type SlopeRows = (&'static str, &'static str, fn(&Sequence) -> Option<&Slope>);

const SLOPES: [SlopeRows; 2] = [
    ("report-row-upslope", "report-row-upslope-time", |sequence| sequence.upslope.as_ref()),
    ("report-row-downslope", "report-row-downslope-time", |sequence| sequence.downslope.as_ref()),
];

/// Label, value and unit.
type Row = [String; 3];

impl WeldReport {
    /// Returns times before and after the travel, and the process values of a weld in one pass.
    pub(super) fn data_table(&self, language: Language) -> Block {
        let mut rows = self.sequence_rows(language);
        if self.passes.len() == 1 {
            let value_row = |label, value: f64, unit| row(language, label, number(value, language), unit);
            rows.extend([
                value_row("report-row-acceleration-phase", self.plan.run_up_mm, Unit::Mm),
                value_row("report-row-deceleration-phase", self.plan.run_down_mm, Unit::Mm),
            ]);
        }
        Table::of(language, rows)
            .text("", |row| row[0].clone())
            .number("report-column-value", |row| row[1].clone())
            .text("report-column-unit", |row| row[2].clone())
            .captioned("report-caption-job")
    }

    /// Returns the times and slopes before and after the travel, as a range where passes differ.
    fn sequence_rows(&self, language: Language) -> Vec<Row> {
        let sequences = || self.passes.iter().map(|pass| &pass.plan.sequence);
        let time_row = |label, of: &dyn Fn(&Sequence) -> Option<f64>| {
            let values = Range::of(sequences().filter_map(of));
            values.max.is_finite().then(|| row(language, label, values.text(language), Unit::S))
        };
        let mut rows: Vec<Row> = Vec::new();
        rows.extend(time_row("report-row-preflow", &|sequence| Some(sequence.preflow_s.get())));
        rows.extend(time_row("report-row-travel-delay", &|sequence| Some(sequence.travel_delay_s.get())));
        for (what, time, slope) in SLOPES {
            let slopes = || sequences().filter_map(slope);
            let mut names: Vec<&String> = slopes().flat_map(|slope| slope.process.keys()).collect();
            names.sort_unstable();
            names.dedup();
            rows.extend(names.into_iter().map(|name| {
                let values = slopes().filter_map(|slope| slope.process.get(name)).map(|value| value.get());
                let [title, unit] = value_names::value_parts(language, name);
                let label = Message::new(what).text("value", title).in_language(language);
                [label, Range::of(values).text(language), unit]
            }));
            rows.extend(time_row(time, &|sequence| slope(sequence).map(|slope| slope.time_s.get())));
        }
        rows.extend(time_row("report-row-crater", &|sequence| Some(sequence.crater_s.get())));
        rows.extend(time_row("report-row-postflow", &|sequence| Some(sequence.postflow_s.get())));
        rows
    }
}

fn row(language: Language, label: &'static str, value: String, unit: Unit) -> Row {
    [language.words(label), value, language.symbol(unit)]
}
