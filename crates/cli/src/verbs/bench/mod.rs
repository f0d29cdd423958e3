//! This build on its own gates.

mod beam;
mod faults;
mod tracking;

use crate::args::bench::{BenchArgs, BenchVerb, BenchVisionArgs};
use crate::progress::Progress;
use crate::rows::{print_json, print_text};
use seamwright_project::failure::Failure;
use seamwright_simulation::acceptance::{Gate, Limit};
use seamwright_simulation::camera_simulator::acceptance::joint_gates;
use seamwright_simulation::camera_simulator::scene::Kind;
use seamwright_simulation::camera_simulator::stripe::{STEPS_A_SEED, stripe_gates};
use serde::Serialize;
use std::fmt::Write as _;

pub(crate) fn run(args: &BenchArgs) -> Result<(), Failure> {
    match &args.verb {
        BenchVerb::Vision(args) => vision(args),
        BenchVerb::Tracking(args) => tracking::run(args),
        BenchVerb::Faults(args) => faults::run(args),
    }
}

#[derive(Debug, Serialize)]
struct Table {
    title: String,
    rows: Vec<Line>,
}

/// A measured value beside its limit.
#[derive(Debug, Serialize)]
struct Line {
    what: String,
    /// `None` if the measurement failed.
    value: Option<f64>,
    unit: &'static str,
    /// Whether the limit is the minimum or the maximum of the value.
    limit_is: &'static str,
    limit: f64,
    kept: bool,
}

impl From<&Gate> for Line {
    fn from(gate: &Gate) -> Self {
        let (limit_is, limit) = match gate.limit {
            Limit::Most(limit) => ("most", limit),
            Limit::Least(limit) => ("least", limit),
        };
        let what = format!("{}: {}", gate.frames, gate.what);
        let value = Some(gate.value).filter(|v| v.is_finite());
        Self { what, value, unit: gate.unit, limit_is, limit, kept: gate.is_kept() }
    }
}

fn vision(args: &BenchVisionArgs) -> Result<(), Failure> {
    let frames = args.frames;
    let progress = Progress::new("cli-progress-frames", frames * (Kind::ALL.len() as u64 + STEPS_A_SEED));
    let follower = joint_gates(0..frames, |_, _, _| progress.all(1));
    let stripes = stripe_gates(0..frames, || progress.all(1));
    drop(progress);
    let tables = [follower, stripes].map(|table| Table::new(&table.title, &table.rows));
    if args.json {
        return print_json(&serde_json::json!({ "frames": frames, "tables": tables }));
    }
    print_text(&tables.iter().map(Table::markdown).collect::<Vec<_>>().join("\n"))
}

impl Table {
    fn new(title: &str, rows: &[Gate]) -> Self {
        Self { title: title.to_owned(), rows: rows.iter().map(Line::from).collect() }
    }

    fn markdown(&self) -> String {
        let mut text = format!("## {}\n\n| what | value | limit | kept |\n|---|---:|---:|---|\n", self.title);
        for row in &self.rows {
            let value = row.value.map_or("none".to_owned(), |v| format!("{v:.3} {}", row.unit));
            let sign = if row.limit_is == "most" { "<=" } else { ">=" };
            // Three decimals at most, as values have; smaller limits stay unrounded.
            let limit = if row.limit.abs() < 0.01 { row.limit } else { (1e3 * row.limit).round() / 1e3 };
            let kept = if row.kept { "yes" } else { "**no**" };
            // Writing to a String never fails.
            let _ = writeln!(
                text,
                "| {} | {} | {sign} {} | {kept} |",
                row.what,
                value.trim_end(),
                format!("{limit} {}", row.unit).trim_end()
            );
        }
        let kept = self.rows.iter().filter(|r| r.kept).count();
        let _ = writeln!(text, "\n{kept} of {} gates are kept.", self.rows.len());
        text
    }
}
