//! Data of the job.

use super::figures::WeldReport;
use super::overview::{extremes, range};
use super::page::{number, table};
use crate::Phrases as _;
use crate::{Block, Language, said};
use seamwright_program::{Sequence, Slope, WeldDirection};

/// Kinds of seams that do not go around a tube.
const STRAIGHT: [&str; 3] = ["line", "T-joint", "spline"];

/// A slope of process values: labels of its values and of its time, and its accessor.
type SlopeRows = (&'static str, &'static str, fn(&Sequence) -> Option<&Slope>);

const SLOPES: [SlopeRows; 2] = [
    ("Upslope from {0}", "Upslope from: time", |sequence| sequence.upslope.as_ref()),
    ("Downslope to {0}", "Downslope to: time", |sequence| sequence.downslope.as_ref()),
];

impl WeldReport {
    /// Returns the requested values of the job.
    pub(super) fn data_table(&self, language: Language) -> Block {
        let mut rows = self.seam_rows(language);
        let row = |label, value: f64, unit| said_row(language, label, number(value), unit);
        let several = self.passes.len() > 1;
        if !several {
            rows.extend([row("Run-up", self.plan.run_up_mm, "mm"), row("Run-down", self.plan.run_down_mm, "mm")]);
        }
        let start = &self.plan.start;
        if self.seam.as_ref().is_some_and(|s| !STRAIGHT.contains(&s.kind)) {
            let direction = match start.direction {
                WeldDirection::CounterClockwise => "counter-clockwise",
                WeldDirection::Clockwise => "clockwise",
            };
            rows.push(row("Start angle", start.phi_deg.get(), "deg"));
            rows.push(said_row(language, "Direction of welding", language.say(direction).to_owned(), ""));
            rows.push(row("Overlap", start.overlap_mm.get(), "mm"));
        }
        rows.extend(self.sequence_rows(language));
        // With several passes the table of passes shows their process values.
        let process = self.plan.process.iter().filter(|_| !several);
        rows.extend(process.map(|(name, value)| {
            let [title, unit] = said::value_parts(language, name);
            let (from, to) = value.ends();
            let ramp = || language.fill("{0} to {1}", &[&number(from), &number(to)]);
            vec![title, if value.is_ramp() { ramp() } else { number(from) }, unit]
        }));
        let head = ["", "Value", "Unit"].map(|head| language.say(head));
        table(language.say("Job data"), &head, rows, 1..2)
    }

    /// Returns the times and slopes before and after the travel, as a range where passes differ.
    fn sequence_rows(&self, language: Language) -> Vec<Vec<String>> {
        let sequences = || self.passes.iter().map(|pass| &pass.plan.sequence);
        let row = |label, of: &dyn Fn(&Sequence) -> Option<f64>| {
            let values = extremes(sequences().filter_map(of));
            values.1.is_finite().then(|| said_row(language, label, range(values, language), "s"))
        };
        let mut rows: Vec<Vec<String>> = Vec::new();
        rows.extend(row("Gas before the arc", &|sequence| Some(sequence.preflow_s.get())));
        rows.extend(row("Arc on before travel", &|sequence| Some(sequence.travel_delay_s.get())));
        for (what, time, slope) in SLOPES {
            let slopes = || sequences().filter_map(slope);
            let mut names: Vec<&String> = slopes().flat_map(|slope| slope.process.keys()).collect();
            names.sort_unstable();
            names.dedup();
            rows.extend(names.into_iter().map(|name| {
                let values = slopes().filter_map(|slope| slope.process.get(name)).map(|value| value.get());
                let [title, unit] = said::value_parts(language, name);
                vec![language.fill(what, &[&title]), range(extremes(values), language), unit]
            }));
            rows.extend(row(time, &|sequence| slope(sequence).map(|slope| slope.time_s.get())));
        }
        rows.extend(row("Crater fill", &|sequence| Some(sequence.crater_s.get())));
        rows.extend(row("Gas after the arc", &|sequence| Some(sequence.postflow_s.get())));
        rows
    }

    fn seam_rows(&self, language: Language) -> Vec<Vec<String>> {
        let Some(s) = &self.seam else { return Vec::new() };
        let row = |label, value: f64, unit| said_row(language, label, number(value), unit);
        vec![
            said_row(language, "Seam", language.say(s.kind).to_owned(), ""),
            row("Seam length", s.length_mm, "mm"),
            row("Weld length", s.weld_length_mm, "mm"),
            row("Dihedral angle, least", s.dihedral_min_deg, "deg"),
            row("Dihedral angle, greatest", s.dihedral_max_deg, "deg"),
        ]
    }
}

fn said_row(language: Language, label: &'static str, value: String, unit: &'static str) -> Vec<String> {
    vec![language.say(label).to_owned(), value, language.say(unit).to_owned()]
}
