//! Data of the job.

use super::figures::WeldReport;
use super::page::{number, table};
use super::range::Range;
use crate::Words as _;
use crate::number::from_to;
use crate::{Block, Language, names};
use seamwright_message::{Message, Unit};
use seamwright_program::{Sequence, Slope, WeldDirection};

/// Kinds of seams that do not go around a tube.
const STRAIGHT: [&str; 3] = ["line", "T-joint", "spline"];

/// A slope of process values: labels of its values and of its time, and its accessor.
type SlopeRows = (&'static str, &'static str, fn(&Sequence) -> Option<&Slope>);

const SLOPES: [SlopeRows; 2] = [
    ("report-row-upslope", "report-row-upslope-time", |sequence| sequence.upslope.as_ref()),
    ("report-row-downslope", "report-row-downslope-time", |sequence| sequence.downslope.as_ref()),
];

impl WeldReport {
    /// Returns the requested values of the job.
    pub(super) fn data_table(&self, language: Language) -> Block {
        let mut rows = self.seam_rows(language);
        let row = |label, value: f64, unit| said_row(language, label, number(value, language), unit);
        let several = self.passes.len() > 1;
        if !several {
            rows.extend([
                row("report-row-acceleration-phase", self.plan.run_up_mm, Unit::Mm),
                row("report-row-deceleration-phase", self.plan.run_down_mm, Unit::Mm),
            ]);
        }
        let start = &self.plan.start;
        if self.seam.as_ref().is_some_and(|s| !STRAIGHT.contains(&s.kind)) {
            let direction = match start.direction {
                WeldDirection::CounterClockwise => "report-counter-clockwise",
                WeldDirection::Clockwise => "report-clockwise",
            };
            rows.push(row("report-row-start-angle", start.phi_deg.get(), Unit::Deg));
            rows.push(said_row(language, "report-row-direction", language.words(direction), Unit::One));
            rows.push(row("report-row-overlap", start.overlap_mm.get(), Unit::Mm));
        }
        rows.extend(self.sequence_rows(language));
        // With several passes the table of passes shows their process values.
        let process = self.plan.process.iter().filter(|_| !several);
        rows.extend(process.map(|(name, value)| {
            let [title, unit] = names::value_parts(language, name);
            let (from, to) = value.ends();
            let [from, to] = [from, to].map(|value| number(value, language));
            vec![title, if value.is_ramp() { from_to(from, to, language) } else { from }, unit]
        }));
        let head = ["", "report-column-value", "report-column-unit"].map(|head| language.words(head));
        table(&language.words("report-caption-job"), &head, rows, 1..2)
    }

    /// Returns the times and slopes before and after the travel, as a range where passes differ.
    fn sequence_rows(&self, language: Language) -> Vec<Vec<String>> {
        let sequences = || self.passes.iter().map(|pass| &pass.plan.sequence);
        let row = |label, of: &dyn Fn(&Sequence) -> Option<f64>| {
            let values = Range::of(sequences().filter_map(of));
            values.max.is_finite().then(|| said_row(language, label, values.text(language), Unit::S))
        };
        let mut rows: Vec<Vec<String>> = Vec::new();
        rows.extend(row("report-row-preflow", &|sequence| Some(sequence.preflow_s.get())));
        rows.extend(row("report-row-travel-delay", &|sequence| Some(sequence.travel_delay_s.get())));
        for (what, time, slope) in SLOPES {
            let slopes = || sequences().filter_map(slope);
            let mut names: Vec<&String> = slopes().flat_map(|slope| slope.process.keys()).collect();
            names.sort_unstable();
            names.dedup();
            rows.extend(names.into_iter().map(|name| {
                let values = slopes().filter_map(|slope| slope.process.get(name)).map(|value| value.get());
                let [title, unit] = names::value_parts(language, name);
                let label = Message::new(what).text("value", title).in_language(language);
                vec![label, Range::of(values).text(language), unit]
            }));
            rows.extend(row(time, &|sequence| slope(sequence).map(|slope| slope.time_s.get())));
        }
        rows.extend(row("report-row-crater", &|sequence| Some(sequence.crater_s.get())));
        rows.extend(row("report-row-postflow", &|sequence| Some(sequence.postflow_s.get())));
        rows
    }

    fn seam_rows(&self, language: Language) -> Vec<Vec<String>> {
        let Some(s) = &self.seam else { return Vec::new() };
        let row = |label, value: f64, unit| said_row(language, label, number(value, language), unit);
        vec![
            said_row(
                language,
                "report-row-seam",
                language.named("key", s.kind).unwrap_or_else(|| s.kind.to_owned()),
                Unit::One,
            ),
            row("report-row-seam-length", s.length_mm, Unit::Mm),
            row("report-tile-weld-length", s.weld_length_mm, Unit::Mm),
            row("report-row-dihedral-min", s.dihedral_min_deg, Unit::Deg),
            row("report-row-dihedral-max", s.dihedral_max_deg, Unit::Deg),
        ]
    }
}

fn said_row(language: Language, label: &'static str, value: String, unit: Unit) -> Vec<String> {
    vec![language.words(label), value, language.symbol(unit)]
}
