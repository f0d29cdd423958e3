//! Tracking on simulated welds.

use super::{Table, beam};
use crate::args::bench::{BenchTrackingArgs, TrackingTable};
use crate::progress::Progress;
use crate::rows::{print_json, print_text};
use seamwright_executive::tracking::RESERVE;
use seamwright_machine::{Machine, shipped};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::load::load_text;
use seamwright_simulation::acceptance::Gate;
use seamwright_simulation::tracking::acceptance::{
    GateRow, cross_talk, fault_rows, heat_rows, misplaced_rows, stripe_rows, t_joint_rows, tracking_gates, weld_count,
};
use seamwright_weld::Welding;
use serde::Serialize;
use std::fmt::Write as _;
use std::path::Path;

/// Machine with cross slides.
const MACHINE: &str = "dual-laser-10axis";
const SADDLE: &str = include_str!("../../../../../examples/saddle.toml");

const T_JOINT: &str = include_str!("../../../../../examples/t-joint.toml");

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
    let wanted = |table: TrackingTable| args.table.is_none_or(|only| only == table);
    let shipped = shipped(MACHINE)
        .ok_or_else(|| Failure::environment(Message::new("cli-bench-not-shipped").text("machine", MACHINE)))?;
    let machine = Machine::read(MACHINE, shipped.text)?;
    let mut rows = Vec::new();
    if wanted(TrackingTable::Seams) {
        let progress = Progress::new("cli-progress-welds", weld_count(args.seeds));
        rows = tracking_gates(&machine, args.seeds, || progress.all(1))?.iter().map(Row::from).collect();
    }
    let mut tables = Vec::new();
    if wanted(TrackingTable::Parts) {
        let saddle = Welding::read("saddle", SADDLE)?;
        let mut parts = t_joint_rows(&machine)?;
        parts.extend(misplaced_rows("saddle, 2 mm and 0.5 deg out of place, 1 mm oval", &saddle.path(0), &machine)?);
        parts.extend(heat_rows(&machine)?);
        tables.push(Table::new("Whole parts at 20 mm/s", &parts));
        let mut eyes = stripe_rows(&machine)?;
        eyes.push(crossed(&machine)?);
        tables.push(Table::new("From images of stripes to the slide, and from one head to the other", &eyes));
    }
    if wanted(TrackingTable::Faults) {
        tables.push(Table::new("Faults while tracking", &fault_rows(&machine, args.seeds)?));
    }
    if wanted(TrackingTable::Beam) {
        tables.push(Table::new("Beam mode at 10 mm/s", &beam::rows(args.seeds)?));
    }
    if args.json {
        return print_json(&serde_json::json!({ "seeds": args.seeds, "gates": rows, "tables": tables }));
    }
    let mut texts: Vec<String> = tables.iter().map(Table::markdown).collect();
    if wanted(TrackingTable::Seams) {
        texts.insert(0, markdown(&rows));
    }
    print_text(&texts.join("\n"))
}

/// Correction by one head in the other's weld, on the T-joint that ships.
fn crossed(machine: &Machine) -> Result<Gate, Failure> {
    let loaded = load_text("t-joint", T_JOINT, Path::new("."))?;
    let motion = loaded.plan_on(&machine.with_reserve(RESERVE))?;
    let paths = loaded.paths();
    Ok(cross_talk(machine, &loaded.passes(&paths), &motion, 1)?)
}

fn markdown(rows: &[Row]) -> String {
    let mut text = "## Distance that 99 % of the weld keep from the seam, mm\n\n\
        | mm/s | seam | head | untracked | one step a sample | in parts | tracked | limit | kept |\n\
        |---:|---|---:|---:|---:|---:|---:|---:|---|\n"
        .to_owned();
    for row in rows {
        let kept = if row.kept { "yes" } else { "**no**" };
        // Writing to a String never fails.
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
