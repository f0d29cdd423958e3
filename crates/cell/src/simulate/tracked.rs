//! Passes that are tracked: the pace follows what tracking allows, the axes carry its corrections out.

use super::cell::SimulatedCell;
use super::off_path::OffPath;
use super::sighting::{STEP_MM, Sighting};
use crate::tracking::carrier::{Carrier, Wanted};
use crate::tracking::{LiveHead, Step};
use crate::{Error, Sample};
use arrayvec::ArrayVec;
use seamwright_machine::{Joints, Machine, Surroundings};
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
    /// What it must keep clear of on the way to where the start is seen.
    pub(super) around: Option<&'a Surroundings<'a>>,
    /// Counted from 1.
    pub(super) number: usize,
    pub(super) planned: &'a PassMotion,
}

impl<E: From<Error>, F: FnMut(&Sample) -> Result<(), E>> TrackedPass<'_, '_, F> {
    /// Plays it: first the torch goes back along the seam's extension and forward again, so that the sensors see its start, or
    /// the beam looks at it; then it welds, then it goes back to the planned path with the arc off. False if it was stopped on
    /// the way, or never begun: then the torch stands there.
    pub(super) fn play(&mut self, heads: &mut [LiveHead<'_>], carrier: &mut Carrier<'_>) -> Result<bool, E> {
        let mut off = OffPath::new(self.machine);
        self.sight(heads, carrier, &mut off)?;
        self.look(heads, carrier, &mut off)?;
        // All of them: each tells what is wrong.
        let waiting = heads.iter_mut().map(LiveHead::is_ready).filter(|ready| !ready).count();
        if waiting > 0 {
            heads.iter_mut().for_each(|head| head.stopped(0.0));
            return Ok(false);
        }
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
            let phase = phase(now.phase);
            let (wanted, mut allowed) = self.cycle(heads, tip.s, tip.v, phase.arc());
            if !off.follow(&planned_q, || carrier.shifted(&planned_q, &wanted)) {
                allowed = 0.0;
                heads.iter_mut().for_each(|head| head.out_of_reach(tip.s));
            }
            let law = LawPoint { s: tip.s, v: tip.v, a: tip.a, j: tip.j };
            self.show(self.number, (phase, law), off.positions(&planned_q), heads, &mut off)?;
            self.feel(tip.s, heads, true);
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
    fn cycle(&self, heads: &mut [LiveHead<'_>], s: f64, speed: f64, welds: bool) -> (ArrayVec<Wanted, 2>, f64) {
        let step = Step { t: self.now(), s, speed, welds };
        let mut allowed = 1.0f64;
        let wanted = heads.iter_mut().map(|head| {
            let (wanted, pace) = head.cycle(&step);
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

    fn feel(&self, s: f64, heads: &mut [LiveHead<'_>], weaves: bool) {
        if let Some(q) = self.cell.positions() {
            // The cycle is over: the set-point that was shown is that of its begin.
            let t = self.now() - self.machine.servo_period_s;
            heads.iter_mut().for_each(|head| head.feel(self.machine, (t, s), q, weaves));
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

    /// Looks at the start with the torch at rest there, as long as the beams need.
    fn look(&mut self, heads: &mut [LiveHead<'_>], carrier: &mut Carrier<'_>, off: &mut OffPath) -> Result<(), E> {
        let Some(look_s) = heads.iter().filter_map(LiveHead::look_s).reduce(f64::max) else { return Ok(()) };
        let start = self.planned.path.at(0.0);
        for _ in 0..(look_s / self.machine.servo_period_s).ceil() as u64 {
            let (wanted, _) = self.cycle(heads, 0.0, 0.0, false);
            off.follow(&start, || carrier.shifted(&start, &wanted));
            self.show(0, (Phase::Air, NOWHERE), off.positions(&start), &mut [], off)?;
            self.feel(0.0, heads, false);
        }
        Ok(())
    }

    /// Of `way` mm back from the start as much as the axes reach and nothing stands in the way of: known before anything
    /// moves, and told if it is less.
    fn free_way(&self, heads: &mut [LiveHead<'_>], carrier: &Carrier<'_>, way: f64) -> f64 {
        let start = self.planned.path.at(0.0);
        let frame = heads[0].frame(0.0);
        let mut probe = carrier.carrying();
        let count = (way / STEP_MM).ceil();
        let step_mm = way / count;
        let place = |k: u32| probe.shifted(&start, heads[0].frame(-step_mm * f64::from(k)).point - frame.point).ok();
        let reached = (1..=count as u32).map_while(place);
        let sighting = Sighting { step_mm, places: std::iter::once(start).chain(reached).collect() };
        let reach = sighting.way_mm();
        let (clear, near) = self.around.map_or((reach, None), |around| sighting.clear_mm(around));
        if clear < way - 1e-9 {
            let why = near.unwrap_or_else(|| "the axes reach no farther".to_owned());
            let cause = format!("{clear:.1} of {way:.1} mm, {why}");
            heads.iter_mut().for_each(|head| head.tell(0.0, CUT_SHORT, Some(cause.clone())));
        }
        clear
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
        let way = self.free_way(heads, carrier, way);
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
                let (wanted, _) = self.cycle(heads, at, (at - before) / period, false);
                off.follow(&there, || carrier.shifted(&there, &wanted));
            }
            self.show(0, (Phase::Air, NOWHERE), off.positions(&there), &mut [], off)?;
            self.feel(at, heads, false);
            if back && at.abs() < 1e-9 && target >= 0.0 {
                break;
            }
        }
        debug_assert!(there.iter().zip(&start).all(|(there, start)| (there - start).abs() < 1e-6), "back at the start");
        Ok(())
    }
}

/// Told where the start of a pass may not be seen.
const CUT_SHORT: &str = "the move to see the start is cut short";

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
