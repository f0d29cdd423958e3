//! Report of a placement: text and JSON.

use super::touched::Touched;
use crate::args::machine::{PlaceArgs, PlaceMethod};
use clap::ValueEnum;
use glam::{DAffine3, DVec3};
use seamwright_document::Transform;
use seamwright_geometry::fit::{Deviation, Motion, RunOut, outliers, rms};
use seamwright_project::offset::fragment;
use serde::Serialize;
use std::fmt::Write;
use std::path::Path;

/// Result of a method.
pub(super) struct Fitted {
    /// Maps the part's frame to the work frame.
    pub(super) offset: DAffine3,
    /// Of the points, in the order of the table, mm.
    pub(super) residuals: Vec<f64>,
    pub(super) free: Vec<Motion>,
    pub(super) deviation: Option<Deviation>,
    pub(super) sides: Option<[f64; 3]>,
    pub(super) axis: Option<Axis>,
    pub(super) warnings: Vec<String>,
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
    cure: Option<String>,
    rms_mm: f64,
    largest_mm: f64,
    residuals: Vec<Residual>,
    side_errors_mm: Option<[f64; 3]>,
    run_out: Option<Axis>,
    /// One standard deviation; `None` without redundant points.
    uncertainty: Option<Uncertainty>,
    /// Motions of the part that the points do not see.
    free: Vec<String>,
    warnings: Vec<String>,
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
            free: fitted.free.iter().map(ToString::to_string).collect(),
            warnings: fitted.warnings,
            toml: fragment(&args.name, &offset),
            offset,
        }
    }

    /// For people; `written` is the job with the offset in it.
    pub(super) fn text(&self, written: Option<&Path>) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let mut line = |word: &str, what: String| _ = writeln!(text, "{word:<13}{what}");
        line("method", format!("{}, {} points", self.method, self.residuals.len()));
        line("offset", format!("{}: {}", self.name, words(&self.offset)));
        line("residuals", format!("{:.4} mm RMS, {:.4} mm largest", self.rms_mm, self.largest_mm));
        if let Some([a, b, c]) = self.side_errors_mm {
            line("sides", format!("1-2 {a:+.4} mm, 2-3 {b:+.4} mm, 3-1 {c:+.4} mm longer than nominal"));
        }
        if let Some(r) = &self.run_out {
            let radius = r.radius_error_mm.map_or(String::new(), |e| format!(", radius {e:+.4} mm"));
            let (off, at) = (vector(r.eccentricity_xyz_mm, 4), vector(r.at_mm, 3));
            line("run-out", format!("{:.4} mm {off} at {at} mm{radius}", r.eccentricity_mm));
            line("tilt", format!("{:.5} degrees towards {}", r.tilt_deg, vector(r.leans_to, 4)));
        }
        if let Some(u) = &self.uncertainty {
            let (xyz, about) = (vector(u.xyz_mm, 4), vector(u.about_xyz_deg, 5));
            line("uncertainty", format!("{xyz} mm, {about} degrees about x, y, z at {} mm", vector(u.at_mm, 1)));
        }
        for free in &self.free {
            line("not seen", format!("{free}: left as the job has it"));
        }
        for warning in &self.warnings {
            line("warning", warning.clone());
        }
        text.push_str("\nline  feature  residual_mm\n");
        for r in &self.residuals {
            let mark = if r.outlier { "  outlier" } else { "" };
            _ = writeln!(text, "{:>4}  {:<7}  {:>11.4}{mark}", r.line, r.feature, r.residual_mm);
        }
        match (&self.cure, written) {
            (Some(cure), _) => _ = writeln!(text, "\nnot accepted: {cure}"),
            (None, Some(path)) => _ = writeln!(text, "\nwrote {}", path.display()),
            (None, None) => _ = write!(text, "\n# for the job file, `offset` at its top\n{}", self.toml),
        }
        text
    }
}

/// A method as on the command line.
fn method_name(method: PlaceMethod) -> String {
    method.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned())
}

fn cure(args: &PlaceArgs, three: bool) -> String {
    let what = match args.method {
        PlaceMethod::ThreePoint if three => "touch the points again; the sides tell which one is off.",
        PlaceMethod::Chuck => "touch the points with the largest residuals again; is the tube round?",
        _ => {
            "touch the points with the largest residuals again; were they taken on the feature they name, with this probe radius, and near where the job has the part?"
        }
    };
    let largest = args.largest_mm;
    format!("a residual is larger than {largest} mm: {what} If the part is no better, allow more with --largest-mm")
}

fn vector(v: [f64; 3], digits: usize) -> String {
    // `+ 0.0` turns a rounded negative zero into zero.
    let scale = 10f64.powi(i32::try_from(digits).unwrap_or(0));
    let [x, y, z] = v.map(|c| (c * scale).round() / scale + 0.0);
    format!("({x:.digits$}, {y:.digits$}, {z:.digits$})")
}

fn words(offset: &Transform) -> String {
    let moved = format!("moved {} mm", vector(offset.move_mm.get().to_array(), 4));
    match offset.turn {
        Some(turn) => {
            format!(
                "turned {:.5} degrees about {}, then {moved}",
                offset.angle_deg.get(),
                vector(turn.unit().to_array(), 4)
            )
        }
        None => moved,
    }
}
