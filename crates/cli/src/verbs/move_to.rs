use super::{period, positive};
use crate::args::move_to::MoveArgs;
use crate::refusals::{in_file, not_allowed, refused, unit_of};
use crate::rows::{Cell, Rows};
use seamwright_machine::{Axis, AxisSet, Clamped, Joints, Machine, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::jog::{PointToPoint, State};
use seamwright_project::failure::Failure;
use seamwright_project::load;
use std::io::{self, Write};

/// Maximum number of set-points; more are a mistake in the period.
const MAX_SET_POINTS: f64 = 1e9;

pub(crate) fn run(args: &MoveArgs) -> Result<(), Failure> {
    let machine = load::machine(&args.machine)?;
    let period = period(args.period_ms, &machine)?;
    let percent = positive("--override-percent", args.override_percent)?;
    if percent > 100.0 {
        let allowed = Message::new("document-more-than-up-to").value("min", 0.0, Unit::One);
        return Err(not_allowed("--override-percent", percent, allowed.value("max", 100.0, Unit::One)));
    }
    let from = positions(&machine, "--from", &args.from, &machine.home())?;
    let to = positions(&machine, "--to", &args.to, &from)?;
    let mut plan = PointToPoint::new(&machine);
    let planned = plan.plan(&State::at_rest(&from), &to, percent / 100.0);
    planned.map_err(|e| Failure::refused(e.message(), Message::new("cli-motions-up-to-two-hours")))?;
    let count = (plan.duration() / period).ceil();
    if count > MAX_SET_POINTS {
        let fault = Message::new("cli-move-set-points").text("count", format!("{count:.1e}"));
        let allowed = Message::new("cli-longer-period").text("max", format!("{MAX_SET_POINTS:.0e}"));
        return Err(refused("--period-ms", period * 1e3, fault, allowed));
    }
    let clearance = clearance(&machine, &args.machine, &plan)?;
    write(&machine, &plan, period, count as u64, args.json)?;
    let done = Message::new("cli-move-done").quantity("time", plan.duration(), Unit::S, 3);
    let done = done.count("count", count as usize + 1).message("clearance", clearance);
    let _ = writeln!(io::stderr(), "{done}");
    Ok(())
}

/// The positions of `words`, `others` for axes that they do not name.
fn positions(machine: &Machine, option: &str, words: &[String], others: &Joints) -> Result<Joints, Failure> {
    let (mut q, mut said) = (*others, AxisSet::default());
    for word in words {
        let names = || machine.axes.iter().map(|a| a.name.as_str()).collect::<Vec<_>>().join(", ");
        let (name, value) = word.split_once('=').unwrap_or((word, ""));
        let Some(i) = machine.axis(name.trim()) else {
            let allowed = Message::new("cli-axis-value-of").text("axes", names());
            return Err(refused(option, word, Message::new("cli-no-such-axis"), allowed));
        };
        let axis = &machine.axes[i];
        let allowed = allowed_positions(axis);
        if said.has(i) {
            let fault = Message::new("cli-axis-twice").axis("axis", &axis.name);
            return Err(refused(option, word, fault, Message::new("cli-each-axis-once")));
        }
        said = said.with(i);
        q[i] = match value.trim().parse::<f64>() {
            Ok(value) if value.is_finite() => axis.from_file(value),
            _ => {
                let fault = Message::new("cli-axis-position-not-a-number").axis("axis", &axis.name);
                return Err(refused(option, word, fault, allowed));
            }
        };
        if axis.outside(q[i]).is_some() {
            return Err(refused(option, word, Message::new("cli-axis-outside").axis("axis", &axis.name), allowed));
        }
    }
    Ok(q)
}

fn allowed_positions(axis: &Axis) -> Message {
    match axis.range {
        Some((low, high)) => {
            let allowed = Message::new("cli-range").value("from", axis.to_file(low), Unit::One);
            allowed.value("to", axis.to_file(high), unit_of(axis.unit()))
        }
        None => Message::new("cli-any-number-of").text("unit", axis.unit()),
    }
}

/// Reports the distances; fails if something comes too near.
fn clearance(machine: &Machine, file: &str, plan: &PointToPoint) -> Result<Message, Failure> {
    let wrong = |e: &dyn std::fmt::Display| Failure::input(in_file(file, Message::outside(e)));
    let around = Surroundings::new(machine, &Clamped::default()).map_err(|e| wrong(&e))?;
    if around.is_empty() {
        return Ok(Message::new("cli-move-no-shapes"));
    }
    let found = plan.clearance(&around).map_err(|e| wrong(&e))?;
    if found.too_near.is_empty() {
        return Ok(match found.nearest {
            Some((mm, t, [first, second])) => {
                let distance = Message::new("cli-move-min-distance").quantity("distance", mm, Unit::Mm, 2);
                distance.quantity("time", t, Unit::S, 3).message("first", first).message("second", second)
            }
            None => Message::new("cli-move-clear").value("distance", found.cutoff_mm, Unit::Mm),
        });
    }
    let mut err = io::stderr().lock();
    let _ = writeln!(err, "{}", Message::new("cli-move-impossible").count("findings", found.too_near.len()));
    for (from, to, what) in found.too_near {
        let finding = Message::new("project-finding").message("severity", Message::new("project-severity-error"));
        let finding = finding.text("kind", "clearance").message("finding", what);
        let times = Message::new("cli-move-times").number("from", from, 3).quantity("to", to, Unit::S, 3);
        let place = Message::new("project-where").message("places", times);
        let cure = Message::new("project-cure").message("cure", Message::new("cli-move-in-parts"));
        let _ = writeln!(err, "{finding}\n   {place}\n   {cure}");
    }
    Err(Failure::Printed)
}

fn write(machine: &Machine, plan: &PointToPoint, period: f64, count: u64, json: bool) -> Result<(), Failure> {
    let mut columns = vec!["t_s".to_owned()];
    columns.extend(machine.axes.iter().map(|a| a.name.clone()));
    columns.push("speed_mm_s".to_owned());
    let mut rows = Rows::new(columns, json);
    let mut cells = Vec::new();
    for i in 0..=count {
        // The last one is at rest at the target, up to a period after it is reached.
        let t = i as f64 * period;
        let state = plan.at(t);
        let columns = machine.jacobian(&state.q);
        let tip: glam::DVec3 = columns.iter().zip(&state.speed).map(|(c, v)| *v * c.0).sum();
        cells.clear();
        cells.push(Cell::Number(t));
        cells.extend(machine.axes.iter().zip(&state.q).map(|(axis, q)| Cell::Number(axis.to_file(*q))));
        cells.push(Cell::Number(tip.length()));
        rows.row(&cells)?;
    }
    rows.finish()
}
