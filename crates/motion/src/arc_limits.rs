//! Requirements of the process on the motion while the arc is on: no stop, no speed below the procedure's minimum.

use crate::corners::Left;
use crate::planned::Planned;
use crate::speed_findings::Binding;
use crate::speed_profile::{Bound, Interval};
use crate::stretch::Stretch;
use seamwright_geometry::numeric::bisect;
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use seamwright_program::{AtCorner, Finding, Pass, PathRange};

/// Relative tolerance of the comparison with the procedure's minimum speed.
const ROUNDING: f64 = 1e-9;

struct Slow {
    from: f64,
    to: f64,
    /// Minimum speed in it, mm/s, and its path length, mm.
    least: (f64, f64),
}

/// Corners that the torch stops at: findings, unless the pass asks for stops.
pub(crate) fn stop_findings(machine: &Machine, corners: &[Left], pass: &Pass, number: usize) -> Vec<Finding> {
    let cure = match pass.corner {
        // The torch stops at corners, as requested: a note.
        AtCorner::Stop => None,
        _ if pass.weave.is_some() => Some(Message::new("motion-cure-stop-weave")),
        AtCorner::Refuse => Some(Message::new("motion-cure-stop-or-blend")),
        AtCorner::BlendMm(_) => Some(Message::new("motion-cure-stop")),
    };
    let message = |corner: &Left| {
        let stops = |code| {
            let axis = machine.axes[corner.axis].name.as_str();
            Message::new(code).quantity("s", corner.s, Unit::Mm, 3).axis("axis", axis)
        };
        match &corner.why {
            None => stops("motion-stop"),
            Some(why) => stops("motion-stop-because").message("reason", why.clone()),
        }
    };
    let (cure, allowed) = (&cure, pass.corner == AtCorner::Stop);
    let finding = |corner: &Left| {
        let note = Finding::note("stop", message(corner), number, PathRange::at(corner.s));
        Finding { cure: cure.clone(), allowed, ..note }
    };
    corners.iter().map(finding).collect()
}

/// Reports stretches below the procedure's minimum speed with the arc on: findings between acceleration and
/// deceleration phase, notes within them.
pub(crate) fn least_speed_findings(planned: Planned, pass: &Pass, number: usize) -> Vec<Finding> {
    let Some(least) = pass.least_speed_mm_s else { return Vec::new() };
    let least = least.get();
    let length = planned.joints.length();
    let band = planned.profile.report();
    let (up, down) = (band.run_up_end, band.run_down_start);
    let at_up = planned.tip_speed_at(up);
    if up >= down && too_slow(at_up, least) {
        let all = Slow { from: 0.0, to: length, least: (at_up, up) };
        return vec![too_slow_in(planned, least, &all, number)];
    }
    let slow = slow_between(planned, Stretch { from: up, to: down }, least);
    let mut findings: Vec<Finding> = slow.iter().map(|slow| too_slow_in(planned, least, slow, number)).collect();
    let start = Stretch { from: 0.0, to: crossing(planned, 0.0, up, least) };
    let end = Stretch { from: crossing(planned, length, down, least), to: length };
    findings.push(slow_end("motion-least-speed-start", start, least, number));
    findings.push(slow_end("motion-least-speed-end", end, least, number));
    findings
}

fn too_slow(v: f64, least: f64) -> bool {
    v < least * (1.0 - ROUNDING)
}

/// Stretches with a tip speed below `least` in `between`, the path between acceleration and deceleration phase; cell by
/// cell of the speed profile.
fn slow_between(planned: Planned, between: Stretch, least: f64) -> Vec<Slow> {
    let Stretch { from: up, to: down } = between;
    let mut all: Vec<Slow> = Vec::new();
    let (mut open, mut before) = (false, up);
    for cell in 0..planned.profile.cells() {
        let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| planned.profile.in_cell(cell, part));
        let between = points[0].s >= up && points[4].s <= down;
        for p in points {
            let v = planned.tip_speed(p);
            let slow = between && too_slow(v, least);
            match all.last_mut().filter(|_| open) {
                Some(run) if slow => {
                    run.to = p.s;
                    run.least = if v < run.least.0 { (v, p.s) } else { run.least };
                }
                Some(run) if between => run.to = crossing(planned, run.to, p.s, least),
                None if slow => {
                    all.push(Slow { from: crossing(planned, p.s, before, least), to: p.s, least: (v, p.s) });
                }
                _ => {}
            }
            (open, before) = (slow, p.s.max(up));
        }
    }
    all
}

/// Path length at which the speed crosses `least` between `slow`, where it is lower, and `fast`; `fast` if it is lower
/// there too.
fn crossing(planned: Planned, slow: f64, fast: f64, least: f64) -> f64 {
    let is_slow = |s: f64| too_slow(planned.tip_speed_at(s), least);
    if is_slow(fast) { fast } else { bisect(slow, fast, 60, is_slow).0 }
}

/// Finding for a stretch below the procedure's `least` speed, with the limit that binds there.
fn too_slow_in(planned: Planned, least: f64, slow: &Slow, pass: usize) -> Finding {
    let (reached, at) = slow.least;
    let Planned { machine, certificate, legs, .. } = planned;
    let binds = |i: &&Interval| i.from <= at && at <= i.to && i.bound != Bound::Asked;
    let bound =
        certificate.intervals.iter().find(binds).filter(|_| slow.from > 0.0 || slow.to < planned.joints.length());
    let stops = legs.iter().skip(1).any(|leg| slow.from <= leg.from && leg.from <= slow.to);
    let (message, cure) = match bound.and_then(|i| Binding::new(machine, i.bound)) {
        _ if stops => (Message::new("motion-least-speed-stop"), Message::new("motion-cure-least-speed-blend")),
        Some(binding) => (
            binding.message("motion-least-speed-axis", "motion-least-speed-tip"),
            match &binding.axis {
                Some(name) => Message::new("motion-cure-least-speed-axis").axis("axis", name.as_str()),
                None => Message::new("motion-cure-least-speed-tip"),
            },
        ),
        None => (Message::new("motion-least-speed-short"), Message::new("motion-cure-least-speed-longer")),
    };
    let message = message.quantity("reached", reached, Unit::MmPerS, 3).quantity("at", at, Unit::Mm, 3);
    let message = message.quantity("minimum", least, Unit::MmPerS, 3);
    Finding::error("least_speed", message, pass, Stretch { from: slow.from, to: slow.to }, cure)
}

fn slow_end(code: &'static str, slow: Stretch, least: f64, pass: usize) -> Finding {
    let Stretch { from: from_mm, to: to_mm } = slow;
    let over = to_mm - from_mm;
    let message = Message::new(code).quantity("over", over, Unit::Mm, 3).quantity("minimum", least, Unit::MmPerS, 3);
    Finding::note("least_speed", message, pass, PathRange { from_mm, to_mm })
}
