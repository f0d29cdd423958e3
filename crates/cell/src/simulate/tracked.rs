//! Passes that are tracked: the pace follows what tracking allows, the axes carry its corrections out.

use super::cell::SimulatedCell;
use super::off_path::OffPath;
use crate::tracking::LiveHead;
use crate::tracking::carrier::{Carrier, Wanted};
use crate::{Error, Sample};
use arrayvec::ArrayVec;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::pace::{Limits, Order, Pace, Run, RunPhase};
use seamwright_motion::{LawPoint, PassMotion, Phase, SetPoint};
use seamwright_tracking::actuator::{RESERVE, Slide};

/// Changes of the pace smaller than this are not worth an order.
const WORTH: f64 = 0.02;
/// Slowest pace that is asked for; less is a stop.
const SLOWEST: f64 = 0.01;
/// Time for a move to where the start can be seen beyond that at its speed, s.
const SLACK_S: f64 = 60.0;

/// A pass that is tracked, with what it is played on.
pub(super) struct TrackedPass<'a, 'b, F> {
    pub(super) cell: &'a mut SimulatedCell<'b, F>,
    pub(super) machine: &'a Machine,
    /// Counted from 1.
    pub(super) number: usize,
    pub(super) planned: &'a PassMotion,
}

impl<E: From<Error>, F: FnMut(&Sample) -> Result<(), E>> TrackedPass<'_, '_, F> {
    /// Plays it: first the torch goes back along the seam's extension and forward again, so that the sensors see its start,
    /// then it welds, then it goes back to the planned path with the arc off. False if it was stopped on the way: then
    /// the torch stands there.
    pub(super) fn play(&mut self, heads: &mut [LiveHead<'_>], carrier: &mut Carrier<'_>) -> Result<bool, E> {
        let mut off = OffPath::new(self.machine);
        self.sight(heads, carrier, &mut off)?;
        let period = self.machine.servo_period_s;
        let timed = self.planned.timed(self.machine);
        let limits = Limits::of(&self.machine.with_reserve(RESERVE));
        let pace = Pace::new(&limits, period, &timed).map_err(Error::from)?;
        let mut run = Run::new(pace, self.planned.sequence.clone(), &[]);
        run.order(Order::Resume).map_err(Error::from)?;
        let (mut asked, mut stopped, mut end) = (1.0, false, self.planned.path.at(0.0));
        loop {
            let now = run.step().map_err(Error::from)?;
            if now.phase == RunPhase::Ended {
                break;
            }
            let (tip, planned_q) = (now.played.rates.tip, now.played.rates.q);
            let (wanted, mut allowed) = self.cycle(heads, tip.s, tip.v);
            if !off.follow(&planned_q, || carrier.shifted(&planned_q, &wanted)) {
                allowed = 0.0;
                heads.iter_mut().for_each(|head| head.out_of_reach(tip.s));
            }
            let law = LawPoint { s: tip.s, v: tip.v, a: tip.a, j: tip.j };
            self.show(self.number, (phase(now.phase), law), off.positions(&planned_q), heads, &mut off)?;
            self.feel(tip.s, heads);
            end = planned_q;
            if allowed < SLOWEST && !stopped {
                stopped = true;
                run.order(Order::Abort).map_err(Error::from)?;
                heads.iter_mut().for_each(|head| head.stopped(tip.s));
            } else if !stopped && (allowed < asked || allowed > asked + WORTH || allowed >= 1.0 && asked < 1.0) {
                asked = allowed;
                run.order(Order::Override(asked)).map_err(Error::from)?;
            }
        }
        if !stopped {
            self.settle(&end, &mut off)?;
        }
        Ok(!stopped)
    }

    /// One cycle of all heads: where each is to be, and the pace that all allow.
    fn cycle(&self, heads: &mut [LiveHead<'_>], s: f64, speed: f64) -> (ArrayVec<Wanted, 2>, f64) {
        let t = self.now();
        let mut allowed = 1.0f64;
        let wanted = heads.iter_mut().map(|head| {
            let (wanted, pace) = head.cycle(t, s, speed);
            allowed = allowed.min(pace);
            wanted
        });
        (wanted.take(2).collect(), allowed)
    }

    fn now(&self) -> f64 {
        self.cell.count() as f64 * self.machine.servo_period_s
    }

    fn show(
        &mut self,
        pass: usize,
        (phase, law): (Phase, LawPoint),
        q: Joints,
        heads: &mut [LiveHead<'_>],
        off: &mut OffPath,
    ) -> Result<(), E> {
        let set = SetPoint { t: self.now(), phase, law, q };
        self.cell.show(pass, set, &off.rates(&q), heads)
    }

    fn feel(&self, s: f64, heads: &mut [LiveHead<'_>]) {
        if let Some(q) = self.cell.positions() {
            heads.iter_mut().for_each(|head| head.feel(self.machine, s, q));
        }
    }

    /// Back to the planned positions `q`, with the arc off.
    fn settle(&mut self, q: &Joints, off: &mut OffPath) -> Result<(), E> {
        off.begin_return();
        while off.returns() {
            let there = off.positions(q);
            self.show(0, (Phase::Air, NOWHERE), there, &mut [], off)?;
        }
        Ok(())
    }

    /// Goes back as far as the sensors need and forward again with the arc off, as far as the axes reach; heads that do not
    /// see the start are told so by their tracking.
    fn sight(&mut self, heads: &mut [LiveHead<'_>], carrier: &mut Carrier<'_>, off: &mut OffPath) -> Result<(), E> {
        let wanted = heads.iter().filter_map(LiveHead::sighting_mm);
        let Some((way, speed)) = wanted.reduce(|a, b| (a.0.max(b.0), a.1.min(b.1))) else { return Ok(()) };
        let period = self.machine.servo_period_s;
        let start = self.planned.path.at(0.0);
        let frame = heads[0].frame(0.0);
        let mut over = carrier.carrying();
        let directions = [frame.along, frame.height];
        let Ok(limits) = over.limits(std::iter::once((start, directions)), 2.0 * way) else { return Ok(()) };
        let Ok(mut mover) = Slide::new(limits, period) else { return Ok(()) };
        let by = |heads: &[LiveHead<'_>], s: f64| heads[0].frame(s).point - frame.point;
        // What is out of reach is known before anything moves.
        let mut probe = carrier.carrying();
        let steps = (1..=way.ceil() as u32).map(|k| way * f64::from(k) / way.ceil());
        let way = steps.take_while(|mm| probe.shifted(&start, by(heads, -mm)).is_ok()).last().unwrap_or(0.0);
        let speed = speed.min(0.5 * limits.speed);
        let (mut target, mut back, mut at) = (-way, way <= 0.0, 0.0);
        let mut there = start;
        for _ in 0..((2.0 * way / speed + SLACK_S) / period) as u64 {
            let before = at;
            at = mover.step(target);
            back |= at <= -way + 1e-6;
            if back {
                target = (target + speed * period).min(0.0);
            }
            // Reached on the way as when it was probed.
            there = over.shifted(&start, by(heads, at)).unwrap_or(there);
            if back {
                let (wanted, _) = self.cycle(heads, at, (at - before) / period);
                off.follow(&there, || carrier.shifted(&there, &wanted));
            }
            self.show(0, (Phase::Air, NOWHERE), off.positions(&there), &mut [], off)?;
            self.feel(at, heads);
            if back && at.abs() < 1e-9 && target >= 0.0 {
                break;
            }
        }
        debug_assert!(there.iter().zip(&start).all(|(there, start)| (there - start).abs() < 1e-6), "back at the start");
        Ok(())
    }
}

/// Not on the seam.
const NOWHERE: LawPoint = LawPoint { s: f64::NAN, v: f64::NAN, a: f64::NAN, j: f64::NAN };

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
