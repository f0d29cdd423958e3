//! What the process asks of the motion while the arc is on: no stop on the way, no speed below the procedure's least.

use crate::SpeedLaw;
use crate::law::{Bound, Certificate, Interval};
use crate::limits::Binding;
use seamwright_machine::Machine;
use seamwright_program::{Finding, Pass};

/// A tip as fast as the procedure's least speed but for rounding is not too slow.
const ROUNDING: f64 = 1e-9;

/// A stretch of the path on which the tip is too slow.
struct Slow {
    from: f64,
    to: f64,
    /// Least speed in it, mm/s, and where that is.
    least: (f64, f64),
}

/// Places inside the pass (path length, axis) at which the torch has to stop since that axis would jump there.
pub(crate) fn stop_findings(machine: &Machine, stops: &[(f64, usize)], number: usize) -> Vec<Finding> {
    let finding = |&(s, axis): &(f64, usize)| Finding {
        kind: "stop",
        message: format!(
            "the torch stops at s = {s:.3} mm with the arc on: the speed or acceleration of axis {} would jump there",
            machine.axes[axis].name
        ),
        pass: number,
        from_mm: s,
        to_mm: s,
        cure: "round the seam off there; or end the weld there and begin another after it".to_owned(),
        allowed: false,
    };
    stops.iter().map(finding).collect()
}

/// Where the tip is slower than the procedure lets it be with the arc on: findings between run-up and run-down, notes
/// in them.
pub(crate) fn least_speed_findings(
    machine: &Machine,
    certificate: &Certificate,
    law: &SpeedLaw,
    (pass, length): (&Pass, f64),
    number: usize,
) -> Vec<Finding> {
    let Some(least) = pass.least_speed_mm_s else { return Vec::new() };
    let least = least.get();
    let band = law.report();
    let (up, down) = (band.run_up_end, band.run_down_start);
    if up >= down && too_slow(band.greatest, least) {
        let all = Slow { from: 0.0, to: length, least: (band.greatest, up) };
        return vec![too_slow_in(machine, None, least, &all, number)];
    }
    let binds = |s: f64| certificate.intervals.iter().find(|i| i.from <= s && s <= i.to && i.bound != Bound::Asked);
    let slow = slow_between(law, (up, down), least);
    let mut findings: Vec<Finding> =
        slow.iter().map(|slow| too_slow_in(machine, binds(slow.least.1), least, slow, number)).collect();
    findings.push(slow_end("starts from rest", (0.0, crossing(law, 0.0, up, least)), least, number));
    findings.push(slow_end("comes to rest", (crossing(law, length, down, least), length), least, number));
    findings
}

fn too_slow(v: f64, least: f64) -> bool {
    v < least * (1.0 - ROUNDING)
}

/// The stretches between run-up and run-down on which the tip is slower than `least`, cell by cell of the law.
fn slow_between(law: &SpeedLaw, (up, down): (f64, f64), least: f64) -> Vec<Slow> {
    let mut all: Vec<Slow> = Vec::new();
    let (mut open, mut before) = (false, up);
    for cell in 0..law.cells() {
        let points = [0.0, 0.25, 0.5, 0.75, 1.0].map(|part| law.in_cell(cell, part));
        let between = points[0].s >= up && points[4].s <= down;
        for p in points {
            let slow = between && too_slow(p.v, least);
            match all.last_mut().filter(|_| open) {
                Some(run) if slow => {
                    run.to = p.s;
                    run.least = if p.v < run.least.0 { (p.v, p.s) } else { run.least };
                }
                Some(run) if between => run.to = crossing(law, run.to, p.s, least),
                None if slow => {
                    all.push(Slow { from: crossing(law, p.s, before, least), to: p.s, least: (p.v, p.s) });
                }
                _ => {}
            }
            (open, before) = (slow, p.s.max(up));
        }
    }
    all
}

/// Where the speed passes `least` on the way from `slow`, where it is less, to `fast`; `fast` if it is less there too.
fn crossing(law: &SpeedLaw, mut slow: f64, mut fast: f64, least: f64) -> f64 {
    if too_slow(law.speed(fast), least) {
        return fast;
    }
    for _ in 0..60 {
        let middle = 0.5 * (slow + fast);
        if too_slow(law.speed(middle), least) { slow = middle } else { fast = middle }
    }
    slow
}

/// A finding: a stretch below the procedure's `least` speed, and what `binds` there.
fn too_slow_in(machine: &Machine, binds: Option<&Interval>, least: f64, slow: &Slow, pass: usize) -> Finding {
    let (why, cure) = match binds.and_then(|i| Binding::new(machine, i.bound)) {
        Some(binding) => (
            format!("{} with {} does not allow more", binding.whose(), binding.limit()),
            match &binding.axis {
                Some(name) => format!("place the work or turn the torch so that axis {name} has less to do there"),
                None => "allow the tip more in the machine file, if the torch can bear it".to_owned(),
            },
        ),
        None => ("the weld is too short to go faster".to_owned(), "make the weld longer".to_owned()),
    };
    let (reached, at) = slow.least;
    Finding {
        kind: "least_speed",
        message: format!(
            "the tip goes at {reached:.3} mm/s at s = {at:.3} mm with the arc on, the procedure's least speed is {least:.3} mm/s: {why}"
        ),
        pass,
        from_mm: slow.from,
        to_mm: slow.to,
        cure: format!(
            "{cure}; or end the weld before it and begin another after it; or lower least_speed_mm_s if the procedure is qualified for that"
        ),
        allowed: false,
    }
}

/// A note: the end of the weld on which the torch, which `does` that with the arc on, is too slow.
fn slow_end(does: &str, (from_mm, to_mm): (f64, f64), least: f64, pass: usize) -> Finding {
    Finding {
        kind: "least_speed",
        message: format!(
            "the torch {does} with the arc on: over {:.3} mm it is slower than the procedure's least speed of {least:.3} mm/s",
            to_mm - from_mm
        ),
        pass,
        from_mm,
        to_mm,
        cure: "none needed: run-up and run-down are not held against the least speed; if they may not be part of the weld, \
               begin and end on run-on and run-off plates"
            .to_owned(),
        allowed: true,
    }
}
