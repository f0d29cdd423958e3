//! The job in numbers.

use super::figures::WeldReport;
use super::page::{number, table};
use crate::{Block, Language, said};
use seamwright_program::WeldDirection;

/// Seams that do not go around.
const STRAIGHT: [&str; 3] = ["line", "T-joint", "spline"];

impl WeldReport {
    /// What the job asks for.
    pub(super) fn data_table(&self, language: Language) -> Block {
        let mut rows = self.seam_rows(language);
        let row = |label, value: f64, unit| said_row(language, label, number(value), unit);
        rows.extend([row("Run-up", self.plan.run_up_mm, "mm"), row("Run-down", self.plan.run_down_mm, "mm")]);
        let (start, sequence) = (&self.plan.start, &self.plan.sequence);
        if self.seam.as_ref().is_some_and(|s| !STRAIGHT.contains(&s.kind)) {
            let direction = match start.direction {
                WeldDirection::CounterClockwise => "counter-clockwise",
                WeldDirection::Clockwise => "clockwise",
            };
            rows.push(row("Start angle", start.phi_deg.get(), "deg"));
            rows.push(said_row(language, "Direction of welding", language.say(direction).to_owned(), ""));
            rows.push(row("Overlap", start.overlap_mm.get(), "mm"));
        }
        rows.push(row("Gas before the arc", sequence.preflow_s.get(), "s"));
        rows.push(row("Arc on before travel", sequence.travel_delay_s.get(), "s"));
        let slopes = [
            ("Upslope from {0}", "Upslope from: time", &sequence.upslope),
            ("Downslope to {0}", "Downslope to: time", &sequence.downslope),
        ];
        for (what, time, slope) in slopes {
            for (name, value) in slope.iter().flat_map(|s| &s.process) {
                let [title, unit] = said::value_parts(language, name);
                rows.push(vec![language.fill(what, &[&title]), number(value.get()), unit]);
            }
            rows.extend(slope.iter().map(|s| row(time, s.time_s.get(), "s")));
        }
        rows.push(row("Crater fill", sequence.crater_s.get(), "s"));
        rows.push(row("Gas after the arc", sequence.postflow_s.get(), "s"));
        for (name, value) in &self.plan.process {
            let (from, to) = value.ends();
            let range = || language.fill("{0} to {1}", &[&number(from), &number(to)]);
            let [title, unit] = said::value_parts(language, name);
            rows.push(vec![title, if value.is_ramp() { range() } else { number(from) }, unit]);
        }
        let head = ["", "Value", "Unit"].map(|head| language.say(head));
        table(language.say("Job data"), &head, rows, 1..2)
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
