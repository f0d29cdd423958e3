//! Search for the placement of the work, or of the machine's base, with the largest margin.

use super::question::JOB;
use super::{OnProgress, Progress};
use crate::http::Refused;
use crate::limits::PLAN_PROCESSOR_TIME;
use crate::wire::{ReachAnswer, ReachBest, ReachCell, ReachText};
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use seamwright_motion::reach::{Judged, Moved, PlacementMargin, ReachGrid, ReachSpan};
use seamwright_project::load::load_foreign;
use seamwright_project::reach::{JobText, ReachRequest, Reached, TriedPlacement, reach};
use std::path::Path;
use std::time::Duration;

/// Maximum number of places of the grid: more are smaller than a finger on the map.
const MAX_CELLS: usize = 2000;
/// Maximum displacement, mm.
const MAX_MOVE_MM: f64 = 10_000.0;
/// Maximum rotation, degrees.
const MAX_TURN_DEG: f64 = 360.0;
/// Minimum and maximum time for search and plans, s.
const BUDGET_S: [f64; 2] = [1.0, 240.0];
/// Part of the processor time of the process that the search may use on all cores.
const PROCESSOR_PART: f64 = 0.8;

/// Answers with everything that was judged, and the best placement that the planner has planned.
pub(super) fn reached(asked: &ReachText, jobs: &Path, progress: OnProgress) -> Result<ReachAnswer, Refused> {
    let grid = grid(asked)?;
    let moved = match asked.moved.as_str() {
        "work" => Moved::Work,
        "base" => Moved::Base,
        other => return Err(Message::new("server-reach-moved").text("moved", other).into()),
    };
    let loaded = load_foreign(JOB, &asked.text, jobs)?;
    let total = grid.count() as u64;
    let judged = |done: usize| progress(Progress { done: (done as u64).min(total), total, kept: 0 });
    let budget = Duration::from_secs_f64(budget_s(asked.budget_s)?);
    let request = ReachRequest { moved, grid, budget, cancel: None, progress: Some(&judged) };
    let reached = reach(&loaded, JobText { text: &asked.text, folder: jobs }, &request)?;
    Ok(answer(&loaded.machine, &grid, moved, &reached))
}

/// The budget within its bounds, and within the processor time of the process on all cores.
fn budget_s(asked: f64) -> Result<f64, Refused> {
    let [min, max] = BUDGET_S;
    if !(min..=max).contains(&asked) {
        let message = Message::new("server-reach-budget").value("value", asked, Unit::S);
        return Err(message.value("min", min, Unit::S).value("max", max, Unit::S).into());
    }
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    Ok(asked.min(PROCESSOR_PART * PLAN_PROCESSOR_TIME.as_secs_f64() / cores as f64))
}

fn grid(asked: &ReachText) -> Result<ReachGrid, Refused> {
    let mut spans = Vec::new();
    for (i, ([from, to], cells)) in asked.ranges.iter().zip(&asked.cells).enumerate() {
        let (max, unit) = if i < 3 { (MAX_MOVE_MM, 1.0) } else { (MAX_TURN_DEG, 1f64.to_radians()) };
        let refused = || {
            let message =
                Message::new("server-reach-range").value("max", max, if i < 3 { Unit::Mm } else { Unit::Deg });
            Refused::input(message)
        };
        if !(from.abs() <= max && to.abs() <= max) {
            return Err(refused());
        }
        spans.push(ReachSpan::new(from * unit, to * unit, *cells as usize).map_err(|_| refused())?);
    }
    let spans: [ReachSpan; 4] = spans.try_into().map_err(|_| Refused::server(Message::new("server-failed")))?;
    let grid = ReachGrid { spans };
    if grid.count() > MAX_CELLS {
        let message = Message::new("server-reach-cells").count("n", grid.count()).count("max", MAX_CELLS);
        return Err(message.into());
    }
    Ok(grid)
}

fn answer(machine: &Machine, grid: &ReachGrid, moved: Moved, reached: &Reached) -> ReachAnswer {
    let place = |i: usize, k: usize| if i < 3 { grid.spans[i].at(k) } else { grid.spans[i].at(k).to_degrees() };
    let tried = |tried: &TriedPlacement| {
        let found = tried.plan.as_ref().err()?.iter().find(|finding| !finding.allowed);
        let reason = found.map_or_else(Message::default, |finding| finding.message.clone());
        Some(ReachCell { margin: None, reason: Some(reason.into()), ..cell(machine, &tried.judged) })
    };
    ReachAnswer {
        machine: machine.name.clone(),
        moved: moved.name().to_owned(),
        grid: std::array::from_fn(|i| (0..grid.spans[i].cells()).map(|k| place(i, k)).collect()),
        places: reached.search.judged.iter().map(|judged| cell(machine, judged)).collect(),
        failed: reached.tried.iter().filter_map(tried).collect(),
        best: reached.best().map(|best| best_view(machine, best)),
        cut_off: reached.cut_off.is_some(),
    }
}

fn cell(machine: &Machine, judged: &Judged) -> ReachCell {
    let [x, y, z, turn] = judged.placement.coordinates();
    let (margin, fault) = (judged.judgement.margin(), judged.judgement.fault());
    let nearest = margin.and_then(|m| m.nearest);
    let axis = nearest.map(|n| n.axis).or(fault.and_then(|f| f.axis));
    ReachCell {
        at: [x, y, z, turn.to_degrees()],
        cell: judged.cell.map(|cell| cell.map(|k| k as u32)),
        margin: margin.map(|m| m.range),
        fault: fault.map(|f| f.kind.name().to_owned()),
        axis: axis.and_then(|i| machine.axes.get(i)).map(|axis| axis.name.clone()),
        pass: nearest.map(|n| n.pass).or(fault.map(|f| f.pass)).map(|pass| pass as u32),
        s_mm: nearest.map(|n| n.s).or(fault.map(|f| f.s)),
        reason: fault.map(|f| (&f.reason).into()),
    }
}

fn best_view(machine: &Machine, best: &TriedPlacement) -> ReachBest {
    let planned = best.plan.as_ref().map(|plan| PlacementMargin::of_plan(machine, plan)).unwrap_or_default();
    let transform = &best.placed.transform;
    ReachBest {
        place: cell(machine, &best.judged),
        planned_margin: planned.range,
        planned_axis: planned.nearest.map(|nearest| machine.axes[nearest.axis].name.clone()),
        clearance_mm: best.clearance_mm(),
        text: best.placed.text.clone(),
        key: best.placed.key.clone(),
        move_mm: transform.move_mm.get().to_array(),
        turn: transform.turn.map(|turn| turn.unit().to_array()),
        angle_deg: transform.angle_deg.get(),
    }
}
