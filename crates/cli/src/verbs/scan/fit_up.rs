//! The measured groove as `[[joint.fit_up]]` of a job.

use super::Station;
use crate::args::scan::ScanArgs;
use seamwright_document::{Change, TomlText};
use seamwright_project::examples::example;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::load_text;
use seamwright_weld::{GrooveScan, SeamJoint};
use std::fmt::Write as _;
use std::path::Path;

/// Tables for the stations that were measured, after so many layers.
pub(super) fn entries(after_layer: u16, stations: &[Station]) -> String {
    let mut text = String::new();
    for Station { row, found } in stations {
        if let Ok(scan) = found {
            text.push_str(&entry(row.s, after_layer, scan));
        }
    }
    text
}

/// A value rounded to 1/`parts`: far below what a stripe sensor resolves.
fn rounded(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts + 0.0
}

fn entry(s: f64, after_layer: u16, scan: &GrooveScan) -> String {
    let mut text = format!("\n[[joint.fit_up]]\ns_mm = {}\n", rounded(s, 1e4));
    // Errors are impossible: a text takes all.
    let _ = writeln!(text, "root_gap_mm = {}", rounded(scan.gap.value.max(0.0), 1e3));
    if scan.mismatch.uncertainty > 0.0 {
        let _ = writeln!(text, "mismatch_mm = {}", rounded(scan.mismatch.value, 1e3));
    }
    if let Some(angle) = scan.angle {
        let _ = writeln!(text, "angle_deg = {}", rounded(angle.value.to_degrees(), 1e3));
    }
    if after_layer > 0 {
        let remaining = rounded(scan.remaining.value, 1e2);
        let _ = writeln!(text, "after_layer = {after_layer}\nremaining_mm2 = {remaining}");
    }
    text
}

/// Writes the job with the measured groove: entries after as many layers, or more, are replaced.
pub(super) fn write_job(args: &ScanArgs, joint: &SeamJoint, stations: &[Station], path: &Path) -> Result<(), Failure> {
    let name = args.job.display().to_string();
    let text = match args.job.to_str().and_then(example) {
        Some(example) if !args.job.exists() => example.text.to_owned(),
        _ => files::read(&args.job)?,
    };
    let old = joint.joint().fit_up.iter().enumerate();
    let old = old.filter(|(_, at)| at.after_layer >= usize::from(args.after_layer)).map(|(i, _)| i);
    let remove = |i: usize| Change::Remove { path: format!("joint.fit_up[{i}]") };
    let changes: Vec<Change> = old.rev().map(remove).collect();
    let kept = TomlText::parse(&name, &text)?.changed(&name, &changes)?;
    let mut new = kept.text().trim_end().to_owned();
    new.push('\n');
    new.push_str(&entries(args.after_layer, stations));
    // The job is read as it will be: a groove that the drawing cannot have is refused before it is written.
    load_text(&path.display().to_string(), &new, args.job.parent().unwrap_or(Path::new(".")))?;
    files::write(path, &new)
}
