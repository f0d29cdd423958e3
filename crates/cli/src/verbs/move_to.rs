use super::positive;
use crate::args::move_to::MoveArgs;
use crate::failure::Failure;
use crate::load;
use crate::rows::{Cell, Rows};
use seamwright_machine::{AxisSet, Clamped, Joints, Machine, Surroundings};
use seamwright_motion::jog::{PointToPoint, State};
use std::io::{self, Write};

/// Maximum number of set-points; more are a mistake in the period.
const MAX_SET_POINTS: f64 = 1e9;

pub(crate) fn run(args: &MoveArgs) -> Result<(), Failure> {
    let machine = load::machine(&args.machine)?;
    let period = match args.period_ms {
        Some(ms) => positive("--period-ms", ms)? * 1e-3,
        None => machine.servo_period_s,
    };
    let percent = positive("--override-percent", args.override_percent)?;
    if percent > 100.0 {
        let message = format!("--override-percent {percent}: not allowed\n   allowed: above 0 and up to 100");
        return Err(Failure::input(message));
    }
    let from = positions(&machine, "--from", &args.from, &machine.home())?;
    let to = positions(&machine, "--to", &args.to, &from)?;
    let mut plan = PointToPoint::new(&machine);
    let planned = plan.plan(&State::at_rest(&from), &to, percent / 100.0);
    planned.map_err(|e| Failure::input(format!("{e}\n   allowed: motions of up to two hours")))?;
    let count = (plan.duration() / period).ceil();
    if count > MAX_SET_POINTS {
        let message = format!("--period-ms {}: {count:.1e} set-points", period * 1e3);
        return Err(Failure::input(format!("{message}\n   allowed: up to {MAX_SET_POINTS:.0e}; a longer period")));
    }
    let clearance = clearance(&machine, &args.machine, &plan)?;
    write(&machine, &plan, period, count as u64, args.json)?;
    let _ = writeln!(io::stderr(), "{:.3} s, {} set-points; {clearance}", plan.duration(), count as u64 + 1);
    Ok(())
}

/// The positions of `words`, `others` for axes that they do not name.
fn positions(machine: &Machine, option: &str, words: &[String], others: &Joints) -> Result<Joints, Failure> {
    let bad = |word: &str, what: String, allowed: String| {
        Failure::input(format!("{option} {word}: {what}\n   allowed: {allowed}"))
    };
    let (mut q, mut said) = (*others, AxisSet::default());
    for word in words {
        let names = || machine.axes.iter().map(|a| a.name.as_str()).collect::<Vec<_>>().join(", ");
        let (name, value) = word.split_once('=').unwrap_or((word, ""));
        let Some(i) = machine.axis(name.trim()) else {
            return Err(bad(word, "there is no such axis".to_owned(), format!("AXIS=VALUE with axis {}", names())));
        };
        let axis = &machine.axes[i];
        let range = axis.range.map(|(low, high)| (axis.to_file(low), axis.to_file(high)));
        let allowed = match range {
            Some((low, high)) => format!("{low} to {high} {}", axis.unit()),
            None => format!("any number of {}", axis.unit()),
        };
        if said.has(i) {
            return Err(bad(word, format!("axis {} is given twice", axis.name), "each axis once".to_owned()));
        }
        said = said.with(i);
        q[i] = match value.trim().parse::<f64>() {
            Ok(value) if value.is_finite() => axis.from_file(value),
            _ => return Err(bad(word, format!("the position of axis {} is not a number", axis.name), allowed)),
        };
        if axis.outside(q[i]).is_some() {
            return Err(bad(word, format!("axis {} cannot be there", axis.name), allowed));
        }
    }
    Ok(q)
}

/// Reports the distances; fails if something comes too near.
fn clearance(machine: &Machine, file: &str, plan: &PointToPoint) -> Result<String, Failure> {
    let wrong = |e: &dyn std::fmt::Display| Failure::input(format!("{file}: {e}"));
    let around = Surroundings::new(machine, &Clamped::default()).map_err(|e| wrong(&e))?;
    if around.is_empty() {
        return Ok("nothing to watch: the machine file has no shapes that could meet".to_owned());
    }
    let found = plan.clearance(&around).map_err(|e| wrong(&e))?;
    if found.too_near.is_empty() {
        return Ok(match found.nearest {
            Some((mm, t, [first, second])) => format!("least distance {mm:.2} mm at {t:.3} s: {first} and {second}"),
            None => format!("nothing comes nearer than {} mm", found.cutoff_mm),
        });
    }
    let mut err = io::stderr().lock();
    let count = found.too_near.len();
    let _ = writeln!(err, "the move cannot be made as asked: {count} finding{}", if count == 1 { "" } else { "s" });
    for (from, to, what) in &found.too_near {
        let _ = writeln!(err, "finding (clearance): {what}\n   where: t = {from:.3} to {to:.3} s");
        let _ = writeln!(err, "   cure: go by another place, in several moves");
    }
    Err(Failure::Printed)
}

fn write(machine: &Machine, plan: &PointToPoint, period: f64, count: u64, json: bool) -> Result<(), Failure> {
    let mut columns = vec!["t_s".to_owned()];
    columns.extend(machine.axes.iter().map(|a| a.name.clone()));
    columns.push("speed_mm_s".to_owned());
    let mut rows = Rows::new(columns, json)?;
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
