//! Passes that are tracked: the pace follows what tracking allows, the axes carry its corrections out.

use super::cell::SimulatedCell;
use crate::tracking::LiveHead;
use crate::tracking::carrier::{Carrier, Wanted};
use crate::{Error, Sample};
use arrayvec::ArrayVec;
use glam::DVec3;
use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_motion::pace::{Limits, Order, Pace, Run, RunPhase};
use seamwright_motion::{LawPoint, PassMotion, Phase, SetPoint};
use seamwright_tracking::actuator::{OverAxes, RESERVE, Slide};

/// Changes of the pace smaller than this are not worth an order.
const WORTH: f64 = 0.02;
/// The longest that a move to where the start can be seen may take, s.
const PATIENCE_S: f64 = 120.0;

/// Set-points with their rates, by differences: what comes on top of a plan has no other.
struct Differences {
    period: f64,
    last: Option<(Joints, Joints)>,
}

impl Differences {
    fn rates(&mut self, q: &Joints) -> (Joints, Joints) {
        let (before, speed) = self.last.unwrap_or((*q, [0.0; MAX_AXES]));
        let v: Joints = std::array::from_fn(|i| (q[i] - before[i]) / self.period);
        let a: Joints = std::array::from_fn(|i| (v[i] - speed[i]) / self.period);
        self.last = Some((*q, v));
        (v, a)
    }
}

/// Plays a pass with its heads' tracking: first the torch goes back along the seam's extension and forward again, so that
/// the sensors see its start, then it welds.
pub(super) fn play_tracked<E: From<Error>, F: FnMut(&Sample) -> Result<(), E>>(
    cell: &mut SimulatedCell<'_, F>,
    machine: &Machine,
    (number, planned): (usize, &PassMotion),
    (heads, carrier): (&mut [LiveHead<'_>], &mut Carrier<'_>),
) -> Result<(), E> {
    let period = machine.servo_period_s;
    let mut rates = Differences { period, last: None };
    sight(cell, machine, planned, (&mut *heads, &mut *carrier), &mut rates)?;
    let timed = planned.timed(machine);
    let limits = Limits::of(&machine.with_reserve(RESERVE));
    let pace = Pace::new(&limits, period, &timed).map_err(Error::from)?;
    let mut run = Run::new(pace, planned.sequence.clone(), &[]);
    run.order(Order::Resume).map_err(Error::from)?;
    let (mut asked, mut ending) = (1.0, false);
    let mut off: Joints = [0.0; MAX_AXES];
    loop {
        let now = run.step().map_err(Error::from)?;
        if now.phase == RunPhase::Ended {
            return Ok(());
        }
        let (tip, t) = (now.played.rates.tip, cell.count() as f64 * period);
        let (wanted, mut allowed) = cycle(heads, t, tip.s, tip.v);
        // What cannot be reached any more stays as far off as it was, and the torch stops.
        let planned_q = now.played.rates.q;
        if let Some(q) = carrier.shifted(&planned_q, &wanted) {
            off = std::array::from_fn(|i| q[i] - planned_q[i]);
        } else {
            allowed = 0.0;
            heads.iter_mut().for_each(|head| head.out_of_reach(tip.s));
        }
        let q: Joints = std::array::from_fn(|i| planned_q[i] + off[i]);
        let law = LawPoint { s: tip.s, v: tip.v, a: tip.a, j: tip.j };
        let set = SetPoint { t, phase: phase(now.phase), law, q };
        cell.show(number, set, &rates.rates(&q), heads)?;
        feel(cell, machine, tip.s, heads);
        if allowed <= 0.0 && !ending {
            ending = true;
            run.order(Order::Abort).map_err(Error::from)?;
            heads.iter_mut().for_each(|head| head.stopped(tip.s));
        } else if !ending && (allowed - asked).abs() > WORTH {
            asked = allowed;
            run.order(Order::Override(asked)).map_err(Error::from)?;
        }
    }
}

/// One cycle of all heads: where each is to be, and the pace that all allow.
fn cycle(heads: &mut [LiveHead<'_>], t: f64, s: f64, speed: f64) -> (ArrayVec<Wanted, 2>, f64) {
    let mut allowed = 1.0f64;
    let wanted = heads.iter_mut().map(|head| {
        let (wanted, pace) = head.cycle(t, s, speed);
        allowed = allowed.min(pace);
        wanted
    });
    (wanted.take(2).collect(), allowed)
}

fn feel<F>(cell: &SimulatedCell<'_, F>, machine: &Machine, s: f64, heads: &mut [LiveHead<'_>]) {
    if let Some(q) = cell.positions() {
        heads.iter_mut().for_each(|head| head.feel(machine, s, q));
    }
}

fn phase(run: RunPhase) -> Phase {
    match run {
        RunPhase::Preflow => Phase::Preflow,
        RunPhase::TravelDelay => Phase::TravelDelay,
        RunPhase::Travel => Phase::Travel,
        RunPhase::Crater => Phase::Crater,
        RunPhase::Postflow => Phase::Postflow,
        RunPhase::Held | RunPhase::RunOut | RunPhase::Move | RunPhase::Ended => Phase::Air,
    }
}

/// Goes back as far as the sensors need and forward again with the arc off. Where the axes cannot, the start is welded
/// as planned until what the sensors have seen comes.
fn sight<E: From<Error>, F: FnMut(&Sample) -> Result<(), E>>(
    cell: &mut SimulatedCell<'_, F>,
    machine: &Machine,
    planned: &PassMotion,
    (heads, carrier): (&mut [LiveHead<'_>], &mut Carrier<'_>),
    rates: &mut Differences,
) -> Result<(), E> {
    let wanted = heads.iter().filter_map(LiveHead::sighting_mm);
    let Some((way, speed)) = wanted.reduce(|a, b| (a.0.max(b.0), a.1.min(b.1))) else { return Ok(()) };
    let period = machine.servo_period_s;
    let start = planned.path.at(0.0);
    let frame = heads[0].frame(0.0);
    let around = [frame.along, frame.height];
    let mut over = if heads.len() > 1 { OverAxes::carrying_all(machine) } else { OverAxes::new(machine) };
    let Ok(limits) = over.limits(std::iter::once((start, around)), 2.0 * way) else { return Ok(()) };
    let Ok(mut mover) = Slide::new(limits, period) else { return Ok(()) };
    let (mut target, mut back, mut forward) = (-way, false, 0.0);
    for _ in 0..(PATIENCE_S / period) as u64 {
        let before = forward;
        forward = mover.step(target);
        back |= forward <= -way + 1e-6;
        if back {
            target = (target + speed.min(0.5 * limits.speed) * period).min(0.0);
        }
        let by: DVec3 = heads[0].frame(forward).point - frame.point;
        let Ok(mut q) = over.shifted(&start, by) else { return Ok(()) };
        let t = cell.count() as f64 * period;
        if back {
            let (wanted, _) = cycle(heads, t, forward, (forward - before) / period);
            q = carrier.shifted(&q, &wanted).unwrap_or(q);
        }
        let nowhere = LawPoint { s: f64::NAN, v: f64::NAN, a: f64::NAN, j: f64::NAN };
        cell.show(0, SetPoint { t, phase: Phase::Air, law: nowhere, q }, &rates.rates(&q), &mut [])?;
        feel(cell, machine, forward, heads);
        if back && forward.abs() < 1e-9 {
            return Ok(());
        }
    }
    Ok(())
}
