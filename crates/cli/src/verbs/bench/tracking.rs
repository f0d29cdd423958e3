//! Tracking on simulated welds.

use super::Table;
use crate::args::bench::BenchTrackingArgs;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::rows::{print_json, print_text};
use seamwright_cell::tracking::gates::{GateRow, tracking_gates, weld_count};
use seamwright_cell::tracking::shows::{fault_rows, misplaced_rows, t_joint_rows};
use seamwright_machine::{Machine, shipped};
use seamwright_weld::Welding;
use serde::Serialize;
use std::fmt::Write as _;

/// Whose cross slides weld.
const MACHINE: &str = "dual-laser-10axis";
const SADDLE: &str = include_str!("../../../../../examples/saddle.toml");

/// One head of one kind of weld.
#[derive(Debug, Serialize)]
struct Row {
    speed_mm_s: f64,
    seam: String,
    head: usize,
    /// Distance that 99 % of the weld keep, mm.
    untracked_p99_mm: f64,
    one_step_p99_mm: f64,
    subdivided_p99_mm: f64,
    tracked_p99_mm: f64,
    limit_mm: f64,
    kept: bool,
}

impl From<&GateRow> for Row {
    fn from(row: &GateRow) -> Self {
        let [untracked_p99_mm, one_step_p99_mm, subdivided_p99_mm, tracked_p99_mm] = row.p99_mm;
        Self {
            speed_mm_s: row.speed_mm_s,
            seam: row.name.clone(),
            head: row.head,
            untracked_p99_mm,
            one_step_p99_mm,
            subdivided_p99_mm,
            tracked_p99_mm,
            limit_mm: row.limit_mm,
            kept: row.is_kept(),
        }
    }
}

pub(super) fn run(args: &BenchTrackingArgs) -> Result<(), Failure> {
    let shipped = shipped(MACHINE).ok_or_else(|| Failure::Environment(format!("{MACHINE} does not ship")))?;
    let machine = Machine::read(MACHINE, shipped.text)?;
    let saddle = Welding::read("saddle", SADDLE)?;
    let progress = Progress::new("simulated welds", weld_count(args.seeds));
    let gates = tracking_gates(&machine, args.seeds, || progress.all(1))?;
    drop(progress);
    let rows: Vec<Row> = gates.iter().map(Row::from).collect();
    let mut parts = t_joint_rows(&machine)?;
    parts.extend(misplaced_rows("saddle, 2 mm and 0.5 deg out of place, 1 mm oval", &saddle.path(0), &machine)?);
    let faults = fault_rows(&machine)?;
    let tables = [Table::new("Whole parts at 20 mm/s", &parts), Table::new("Faults while tracking", &faults)];
    if args.json {
        return print_json(&serde_json::json!({ "seeds": args.seeds, "gates": rows, "tables": tables }));
    }
    let rest = tables.iter().map(Table::markdown).collect::<Vec<_>>().join("\n");
    print_text(&format!("{}\n{rest}", markdown(&rows)))
}

fn markdown(rows: &[Row]) -> String {
    let mut text = "## Distance that 99 % of the weld keep from the seam, mm\n\n\
        | mm/s | seam | head | untracked | one step a sample | in parts | tracked | limit | kept |\n\
        |---:|---|---:|---:|---:|---:|---:|---:|---|\n"
        .to_owned();
    for row in rows {
        let kept = if row.kept { "yes" } else { "**no**" };
        // A text has room for everything.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.3} | {:.3} | {:.3} | {:.3} | {} | {kept} |",
            row.speed_mm_s,
            row.seam,
            row.head,
            row.untracked_p99_mm,
            row.one_step_p99_mm,
            row.subdivided_p99_mm,
            row.tracked_p99_mm,
            row.limit_mm
        );
    }
    let kept = rows.iter().filter(|r| r.kept).count();
    let _ = writeln!(text, "\n{kept} of {} gates are kept, without breaking a limit of a slide.", rows.len());
    text
}
