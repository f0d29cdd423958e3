use crate::args::teach::TeachArgs;
use crate::rows::{json_text, print_json};
use seamwright_machine::Machine;
use seamwright_message::{Language, Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_simulation::teaching::Truth;
use seamwright_teaching::{Curves, Figures, Outcome, Reduced, SeamLine, TaughtPoint, bridged};
use serde_json::{Value, json};
use std::io::{self, Write as _};

pub(super) struct Report<'a> {
    args: &'a TeachArgs,
    machine: &'a Machine,
    pub(super) outcome: &'a Outcome,
    pub(super) reduced: &'a Reduced,
    pub(super) figures: Figures,
    pub(super) tolerance: f64,
    /// True distance from the seam; known in a simulation only.
    truth: Option<Truth>,
}

impl<'a> Report<'a> {
    pub(super) fn new(
        args: &'a TeachArgs,
        machine: &'a Machine,
        nominal: &SeamLine,
        outcome: &'a Outcome,
        reduced: &'a Reduced,
        truth: Option<Truth>,
    ) -> Self {
        let figures = Figures::new(nominal, outcome, reduced);
        Self { args, machine, outcome, reduced, figures, tolerance: args.tolerance_mm, truth }
    }

    fn value(&self) -> Value {
        let Outcome { line, smooth, notes, asked, seconds, ended, gap_mm, finding, .. } = self.outcome;
        let [lines, arcs, pieces] = self.reduced.curves.counts();
        let least = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::min);
        let most = |values: &mut dyn Iterator<Item = f64>| values.reduce(f64::max);
        let overlaps = || notes.iter().filter_map(|n| n.overlap_mm);
        let row = |p: &TaughtPoint| {
            let source = if p.operator { "operator" } else { "eye" };
            let (across, above) = p.from_nominal.unzip();
            json!({ "s_mm": p.way, "x_mm": p.point.x, "y_mm": p.point.y, "z_mm": p.point.z, "confidence": p.confidence,
                "frame": p.frame, "source": source, "from_program_mm": p.from_program,
                "across_nominal_mm": across, "above_nominal_mm": above })
        };
        let english = |message: &Message| message.in_language(Language::English);
        let frame = |n: &seamwright_teaching::CameraNote| {
            json!({ "s_mm": n.way, "rows": n.rows, "confidence": n.confidence, "overlap_mm": n.overlap_mm,
                "ended": format!("{:?}", n.end), "believed": n.agrees })
        };
        json!({
            "seamwright": env!("CARGO_PKG_VERSION"),
            "job": self.args.job.display().to_string(),
            "machine": self.machine.name,
            "frames": self.args.frames,
            "ended": ended,
            "finding": finding.as_ref().map(english),
            "asked": asked.iter().map(english).collect::<Vec<_>>(),
            "seconds": seconds,
            "looked_at": notes.len(),
            "raw_points": line.points().len(),
            "length_mm": smooth.windows(2).map(|w| w[0].point.distance(w[1].point)).sum::<f64>(),
            "closure_gap_mm": gap_mm,
            "least_confidence": least(&mut line.points().iter().map(|p| p.confidence)),
            "greatest_overlap_error_mm": most(&mut overlaps()),
            "bridged_mm": bridged(self.outcome),
            "program": {
                "lines": lines,
                "arcs": arcs,
                "spline_pieces": pieces,
                "at_least": match &self.reduced.curves {
                    Curves::Arcs(arcs) => Some(arcs.at_least),
                    Curves::Spline(_) => None,
                },
                "tolerance_mm": self.tolerance,
                "greatest_error_mm": self.reduced.curves.max_error(),
                "greatest_from_raw_mm": self.figures.raw_error(),
            },
            "truth": self.truth.as_ref().map(|t| json!({
                "across_rms_mm": t.across_rms, "across_max_mm": t.across_max,
                "height_rms_mm": t.height_rms, "height_max_mm": t.height_max,
                "bridged_max_mm": t.bridged_max, "start_mm": t.start, "end_mm": t.end,
            })),
            "looks": notes.iter().map(frame).collect::<Vec<_>>(),
            "points": self.figures.raw.iter().map(row).collect::<Vec<_>>(),
        })
    }

    pub(super) fn to_json(&self) -> Result<String, Failure> {
        json_text(&self.value())
    }

    /// To standard output: the report, or a summary.
    pub(super) fn print(&self, json: bool) -> Result<(), Failure> {
        if json {
            return print_json(&self.value());
        }
        let mut out = io::stdout().lock();
        let Outcome { line, notes, asked, ended, gap_mm, seconds, .. } = self.outcome;
        if notes.is_empty() {
            writeln!(out, "{}", Message::new("cli-teach-by-points"))?;
        } else {
            let done = Message::new("cli-teach-done")
                .text("ended", *ended)
                .quantity("way", line.length(), Unit::Mm, 1)
                .count("frames", notes.len())
                .quantity("time", *seconds, Unit::S, 1)
                .count("points", line.points().len());
            writeln!(out, "{done}")?;
        }
        if let Some(gap) = gap_mm {
            writeln!(out, "{}", Message::new("cli-teach-closes").quantity("gap", *gap, Unit::Mm, 3))?;
        }
        for why in asked {
            writeln!(out, "{}", Message::new("cli-teach-asked").message("why", why.clone()))?;
        }
        writeln!(out, "{}", self.program())?;
        if let Some(t) = &self.truth {
            let truth = Message::new("cli-teach-truth")
                .quantity("across", t.across_rms, Unit::Mm, 3)
                .quantity("across-max", t.across_max, Unit::Mm, 3)
                .quantity("height", t.height_rms, Unit::Mm, 3)
                .quantity("height-max", t.height_max, Unit::Mm, 3);
            writeln!(out, "{truth}")?;
        }
        Ok(())
    }
    /// The curves of the program, and their distance from the line.
    fn program(&self) -> Message {
        let curves = match self.reduced.curves.counts() {
            [0, 0, pieces] => Message::new("cli-teach-spline").count("pieces", pieces),
            [lines, arcs, _] => Message::new("cli-teach-lines-and-arcs").count("lines", lines).count("arcs", arcs),
        };
        let program = match self.figures.raw_error() {
            Some(raw) => Message::new("cli-teach-program-of-raw").quantity("raw", raw, Unit::Mm, 3),
            None => Message::new("cli-teach-program"),
        };
        program.message("curves", curves).quantity("error", self.reduced.curves.max_error(), Unit::Mm, 3)
    }
}
