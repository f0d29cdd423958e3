//! Report of a placement: text and JSON.

use super::touched_points::Touched;
use crate::args::machine::{PlaceArgs, PlaceMethod};
use crate::labels::{columns, padded};
use crate::refusals::signed;
use crate::rows::in_english;
use clap::ValueEnum;
use glam::{DAffine3, DVec3};
use seamwright_document::Transform;
use seamwright_geometry::fit::{Deviation, Motion, RunOut, outliers, rms};
use seamwright_message::{Language, Message, Unit};
use seamwright_project::work_offset::fragment;
use serde::{Serialize, Serializer};
use std::fmt::Write;
use std::path::Path;

/// Width of the labels.
const LABEL: usize = 12;

pub(super) struct Fitted {
    /// Maps the part's frame to the work frame.
    pub(super) offset: DAffine3,
    /// Of the points, in the order of the table, mm.
    pub(super) residuals: Vec<f64>,
    pub(super) free: Vec<Motion>,
    pub(super) deviation: Option<Deviation>,
    pub(super) sides: Option<[f64; 3]>,
    pub(super) axis: Option<Axis>,
    pub(super) warnings: Vec<Message>,
}

impl Fitted {
    pub(super) fn new(offset: DAffine3, residuals: Vec<f64>) -> Self {
        let (free, warnings) = (Vec::new(), Vec::new());
        Self { offset, residuals, free, deviation: None, sides: None, axis: None, warnings }
    }
}

/// Run-out of the nozzle's axis.
#[derive(Debug, Serialize)]
pub(super) struct Axis {
    eccentricity_mm: f64,
    eccentricity_xyz_mm: [f64; 3],
    /// Position on the nominal axis to which the eccentricity refers: the middle of the seam.
    at_mm: [f64; 3],
    tilt_deg: f64,
    leans_to: [f64; 3],
    radius_error_mm: Option<f64>,
}

impl Axis {
    pub(super) fn new(found: &RunOut, at: DVec3) -> Self {
        Self {
            eccentricity_mm: found.eccentricity.length(),
            eccentricity_xyz_mm: found.eccentricity.to_array(),
            at_mm: at.to_array(),
            tilt_deg: found.tilt.to_degrees(),
            leans_to: found.leans_to.to_array(),
            radius_error_mm: found.growth,
        }
    }

    fn message(&self) -> Message {
        let run_out = Message::new("cli-place-run-out").quantity("eccentricity", self.eccentricity_mm, Unit::Mm, 4);
        let run_out = run_out.text("vector", vector(self.eccentricity_xyz_mm, 4)).text("at", vector(self.at_mm, 3));
        match self.radius_error_mm {
            Some(error) => {
                let both = Message::new("cli-place-run-out-radius").message("run-out", run_out);
                both.message("deviation", signed(error, Unit::Mm, 4))
            }
            None => run_out,
        }
    }
}

#[derive(Debug, Serialize)]
struct Uncertainty {
    at_mm: [f64; 3],
    xyz_mm: [f64; 3],
    about_xyz_deg: [f64; 3],
}

#[derive(Debug, Serialize)]
struct Residual {
    line: usize,
    feature: String,
    residual_mm: f64,
    outlier: bool,
}

/// The answer, as JSON has it.
#[derive(Debug, Serialize)]
pub(super) struct Placed {
    method: String,
    name: String,
    offset: Transform,
    pub(super) accepted: bool,
    /// Operator action if the placement is not accepted.
    #[serde(serialize_with = "in_english")]
    cure: Option<Message>,
    rms_mm: f64,
    largest_mm: f64,
    residuals: Vec<Residual>,
    side_errors_mm: Option<[f64; 3]>,
    run_out: Option<Axis>,
    /// One standard deviation; `None` without redundant points.
    uncertainty: Option<Uncertainty>,
    /// Motions of the part that the points do not see.
    #[serde(serialize_with = "all_in_english")]
    free: Vec<Message>,
    #[serde(serialize_with = "all_in_english")]
    warnings: Vec<Message>,
    toml: String,
}

impl Placed {
    pub(super) fn new(args: &PlaceArgs, rows: &[Touched], fitted: Fitted, offset: Transform) -> Self {
        let wild = outliers(&fitted.residuals);
        let of_row = |((row, residual), outlier): ((&Touched, &f64), bool)| Residual {
            line: row.line,
            feature: row.feature.clone(),
            residual_mm: *residual,
            outlier,
        };
        let worst = |values: &[f64]| values.iter().map(|v| v.abs()).fold(0.0, f64::max);
        let largest = worst(&fitted.residuals);
        let accepted = largest.max(fitted.sides.map_or(0.0, |s| worst(&s))) <= args.largest_mm;
        Self {
            method: method_name(args.method),
            name: args.name.clone(),
            accepted,
            cure: (!accepted).then(|| cure(args, fitted.sides.is_some())),
            rms_mm: rms(&fitted.residuals),
            largest_mm: largest,
            residuals: rows.iter().zip(&fitted.residuals).zip(wild).map(of_row).collect(),
            side_errors_mm: fitted.sides,
            run_out: fitted.axis,
            uncertainty: fitted.deviation.map(|d| Uncertainty {
                at_mm: d.at.to_array(),
                xyz_mm: d.shift.to_array(),
                about_xyz_deg: d.turn.to_array().map(f64::to_degrees),
            }),
            free: fitted.free.iter().map(Motion::message).collect(),
            warnings: fitted.warnings,
            toml: fragment(&args.name, &offset),
            offset,
        }
    }

    /// For people; `written` is the job with the offset in it.
    pub(super) fn text(&self, written: Option<&Path>) -> String {
        let mut text = String::new();
        self.lines(&mut text);
        text.push('\n');
        self.table(&mut text);
        // Writing to a String cannot fail.
        match (&self.cure, written) {
            (Some(cure), _) => {
                let refused = Message::new("cli-place-not-accepted").message("cure", cure.clone());
                _ = writeln!(text, "\n{refused}");
            }
            (None, Some(path)) => {
                let wrote = Message::new("cli-wrote").text("files", path.display().to_string());
                _ = writeln!(text, "\n{wrote}");
            }
            (None, None) => _ = write!(text, "\n{}\n{}", Message::new("cli-place-for-job"), self.toml),
        }
        text
    }

    fn lines(&self, text: &mut String) {
        let mut line = |code, value: Message| {
            _ = writeln!(text, "{} {value}", padded(&Message::new(code).to_string(), LABEL));
        };
        let method = Message::new("cli-place-method").text("method", &self.method);
        line("cli-label-method", method.count("points", self.residuals.len()));
        let offset = Message::new("cli-place-offset").text("name", &self.name);
        line("cli-label-offset", offset.message("offset", words(&self.offset)));
        let residuals = Message::new("cli-place-residuals").quantity("rms", self.rms_mm, Unit::Mm, 4);
        line("cli-label-residuals", residuals.quantity("max", self.largest_mm, Unit::Mm, 4));
        if let Some([a, b, c]) = self.side_errors_mm.map(|sides| sides.map(|v| signed(v, Unit::Mm, 4))) {
            let sides = Message::new("cli-place-sides").message("first", a).message("second", b);
            line("cli-label-sides", sides.message("third", c));
        }
        if let Some(r) = &self.run_out {
            line("cli-label-run-out", r.message());
            let tilt = Message::new("cli-place-tilt").quantity("angle", r.tilt_deg, Unit::Deg, 5);
            line("cli-label-tilt", tilt.text("direction", vector(r.leans_to, 4)));
        }
        if let Some(u) = &self.uncertainty {
            let uncertainty = Message::new("cli-place-uncertainty").text("xyz", vector(u.xyz_mm, 4));
            let uncertainty = uncertainty.text("turn", vector(u.about_xyz_deg, 5));
            line("cli-label-uncertainty", uncertainty.text("at", vector(u.at_mm, 1)));
        }
        for free in &self.free {
            line("cli-label-free", Message::new("cli-place-free").message("motion", free.clone()));
        }
        self.warnings.iter().for_each(|warning| line("cli-label-warning", warning.clone()));
    }

    fn table(&self, text: &mut String) {
        let heading = |code| Message::new(code).to_string();
        let [place, feature] = ["cli-place-column-line", "cli-place-column-feature"].map(heading);
        let residual = heading("cli-place-column-residual");
        let widths = [columns(&place).max(4), columns(&feature).max(7)];
        _ = writeln!(text, "{}  {}  {residual}", padded(&place, widths[0]), padded(&feature, widths[1]));
        for r in &self.residuals {
            let mark = if r.outlier { format!("  {}", Message::new("cli-place-outlier")) } else { String::new() };
            let value = Message::new("quantity").number("value", r.residual_mm, 4).to_string();
            let (place, feature) = (format!("{:>1$}", r.line, widths[0]), padded(&r.feature, widths[1]));
            _ = writeln!(text, "{place}  {feature}  {value:>11}{mark}");
        }
    }
}

fn method_name(method: PlaceMethod) -> String {
    method.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned())
}

fn cure(args: &PlaceArgs, three: bool) -> Message {
    let code = match args.method {
        PlaceMethod::ThreePoint if three => "cli-place-touch-again",
        PlaceMethod::Chuck => "cli-place-touch-again-round",
        _ => "cli-place-touch-again-features",
    };
    Message::new(code).value("max", args.largest_mm, Unit::Mm)
}

fn all_in_english<S: Serializer>(messages: &[Message], out: S) -> Result<S::Ok, S::Error> {
    out.collect_seq(messages.iter().map(|message| message.in_language(Language::English)))
}

fn vector(v: [f64; 3], digits: usize) -> String {
    // `+ 0.0` turns a rounded negative zero into zero.
    let scale = 10f64.powi(i32::try_from(digits).unwrap_or(0));
    let [x, y, z] = v.map(|c| (c * scale).round() / scale + 0.0);
    format!("({x:.digits$}, {y:.digits$}, {z:.digits$})")
}

fn words(offset: &Transform) -> Message {
    let moved = vector(offset.move_mm.get().to_array(), 4);
    match offset.turn {
        Some(turn) => Message::new("cli-place-turned")
            .quantity("angle", offset.angle_deg.get(), Unit::Deg, 5)
            .text("axis", vector(turn.unit().to_array(), 4))
            .text("vector", moved),
        None => Message::new("cli-place-moved").text("vector", moved),
    }
}
