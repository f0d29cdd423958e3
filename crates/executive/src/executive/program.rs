//! Execution of a program from its first transfer move to its last, with or without the process.

use super::activity::Doing;
use super::alarm::Alarm;
use super::alarm_list::Place;
use super::core::Executive;
use super::device_interface::{Devices, SeamOrders, VALUES};
use super::guide::Planned;
use super::mode::{Event, Mode};
use super::port::{Note, Port};
use super::process::ProcessState;
use super::work::Work;
use seamwright_motion::feed_override::{FeedOverride, Instant, Order, Run, RunPhase, Timed};
use seamwright_motion::transfer::Leg;
use seamwright_program::{ArcTime, Sequence};
use std::mem::take;

/// Tolerance of the feed override.
const PACED: f64 = 1e-3;
/// Settling time of process values and of the averaged tip speed after a start or a ramp, s.
const SETTLES_S: f64 = 0.25;

/// A part of a program with one speed profile.
struct Stretch<'a, L> {
    profile: &'a L,
    sequence: Sequence,
    /// The pass, counted from 0; `None` for a transfer move.
    pass: Option<usize>,
    /// Path length up to which it is welded already, mm.
    from_mm: f64,
}

struct Progress<'a> {
    now: &'a Instant,
    /// The pass, counted from 0; `None` for a transfer move.
    pass: Option<usize>,
    /// True if the pass is welded.
    welds: bool,
    /// Path length up to which the pass is welded, mm.
    welded_mm: f64,
    /// Time since arc or beam came on, s.
    burnt_s: f64,
}

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Runs the program until it ends or is aborted.
    pub(super) fn run(&mut self, work: &Work<'_>) {
        self.activity.busy = true;
        let before = Place { pass: work.start.pass + 1, s_mm: work.start.welded_mm };
        self.leave(None);
        // The axes are near the start of the approach: move there without a step.
        let here = self.io.positions();
        let first = work.start.approach.legs.first().map(|leg| Leg::new(self.machine, &here, leg.start()));
        let there = self.fly(work, first.as_slice()) && self.fly(work, &work.start.approach.legs);
        if !there && self.activity.welds && before.s_mm > 0.0 {
            self.leave(Some(before));
        }
        let done = there && self.weld(work);
        (self.activity.busy, self.guide.corrects) = (false, false);
        self.heed(None);
        if done {
            self.event(Event::Finish);
        }
    }

    /// Runs all passes from the start on, each with its later transfer move; false if aborted.
    fn weld(&mut self, work: &Work<'_>) -> bool {
        for i in work.start.pass..work.passes.len() {
            let from_mm = if i == work.start.pass { work.start.welded_mm } else { 0.0 };
            let one = &work.passes[i];
            let welds = self.activity.welds && one.planned.arc;
            if !self.look(work, i, from_mm) {
                let before = Place { pass: i + 1, s_mm: from_mm };
                self.leave((welds && (i > 0 || from_mm > 0.0)).then_some(before));
                return false;
            }
            let stretch = Stretch { profile: &one.timed, sequence: one.times(welds), pass: Some(i), from_mm };
            if !self.play(work, &stretch) {
                self.leave(welds.then_some(Place { pass: i + 1, s_mm: self.activity.doing.welded_mm }));
                return false;
            }
            self.port.note(self.now(), Note::PassEnds(Place { pass: i + 1, s_mm: self.activity.doing.welded_mm }));
            let next = work.air.get(i + 1).map_or(&[][..], |air| &air.legs);
            if !(self.settle(work) && self.fly(work, next)) {
                self.leave((welds && i + 1 < work.passes.len()).then_some(Place { pass: i + 2, s_mm: 0.0 }));
                return false;
            }
        }
        true
    }

    /// Runs transfer moves; false if aborted.
    fn fly(&mut self, work: &Work<'_>, legs: &[Leg]) -> bool {
        legs.iter().all(|leg| {
            let sequence = Sequence::default();
            leg.duration() <= 0.0 || self.play(work, &Stretch { profile: leg, sequence, pass: None, from_mm: 0.0 })
        })
    }

    /// Runs a stretch under the operator's orders; false if it was aborted or lost power.
    fn play<L: Timed>(&mut self, work: &Work<'_>, stretch: &Stretch<'_, L>) -> bool {
        let feed_override = FeedOverride::new(&work.limits, self.machine.servo_period_s, stretch.profile);
        let Ok(feed_override) = feed_override.and_then(|feed_override| feed_override.from_place(stretch.from_mm))
        else {
            self.happened(Alarm::MotionStuck, 0);
            self.event(Event::Abort);
            return false;
        };
        let mut run = Run::new(feed_override, stretch.sequence.clone(), &[]);
        let welds = self.activity.welds && stretch.pass.is_some_and(|i| work.passes[i].planned.arc);
        // A welded stretch starts without an arc.
        run.set_burning(!welds);
        let mut asked = 1.0;
        self.steer(&mut run, &mut asked);
        let mut seen = Mode::Hold;
        let mut burnt_s = 0.0;
        let mut steady_s = 0.0;
        loop {
            seen = self.order(&mut run, seen);
            self.steer(&mut run, &mut asked);
            let Ok(now) = run.step() else {
                // The run waits in hold.
                self.happened(Alarm::MotionStuck, 0);
                self.event(Event::Hold);
                continue;
            };
            if now.phase == RunPhase::Ended {
                break;
            }
            if now.phase == RunPhase::Held && self.mode.moves() {
                // At an override of 0 it stops by itself.
                self.event(Event::Hold);
                seen = self.mode;
            }
            let burns = self.process.state() == ProcessState::Burns;
            burnt_s = if burns { burnt_s + self.machine.servo_period_s } else { 0.0 };
            let paced = now.phase == RunPhase::Travel && (now.played.phi - asked).abs() < PACED;
            steady_s = if burns && paced { steady_s + self.machine.servo_period_s } else { 0.0 };
            let progress = Progress { now: &now, pass: stretch.pass, welds, welded_mm: run.welded_to(), burnt_s };
            let mut doing = self.doing(work, &progress);
            doing.steady = steady_s > SETTLES_S;
            match self.follow(&planned(&now)) {
                Some(guided) => doing.seam = guided.seam,
                None => self.io.set(&now.played.rates.q, &now.played.rates.v, &now.played.rates.a),
            }
            self.tick(doing, Some(work));
            run.set_burning(!welds || self.process.state() == ProcessState::Burns);
            self.drop_power_at_rest();
            if !self.io.power {
                self.activity.doing.welded_mm = run.welded_to();
                return false;
            }
        }
        self.activity.doing.welded_mm = run.welded_to();
        matches!(self.mode, Mode::DryRun | Mode::Weld | Mode::Hold)
    }

    /// Stores the position at which the program was left with the weld unfinished.
    fn leave(&mut self, place: Option<Place>) {
        self.activity.left = place;
        if let Some(place) = place {
            self.port.note(self.now(), Note::Left(place));
        }
    }

    /// Gives the run the orders that follow from the change of mode; returns the current mode.
    fn order<L: Timed>(&mut self, run: &mut Run<'_, L>, seen: Mode) -> Mode {
        let order = match (seen, self.mode) {
            (Mode::Hold, Mode::DryRun | Mode::Weld) => Order::Resume,
            (Mode::DryRun | Mode::Weld, Mode::Hold) => Order::Hold,
            (Mode::Hold, Mode::Hold) if take(&mut self.requests.halt) => Order::Hold,
            (Mode::Hold, Mode::Hold) if take(&mut self.requests.reverse) => Order::Reverse,
            (Mode::DryRun | Mode::Weld | Mode::Hold, Mode::Ready | Mode::Fault) => Order::Abort,
            _ => return self.mode,
        };
        if run.order(order).is_err() {
            // A resume at an override of 0 stays in hold until the override changes.
            self.event(Event::Hold);
        }
        self.mode
    }

    /// Passes the requested feed override to the run.
    fn steer<L: Timed>(&mut self, run: &mut Run<'_, L>, asked: &mut f64) {
        let wanted = self.guide.allowed_override(*asked, self.requests.feed_override);
        if (wanted - *asked).abs() > 0.0 && run.order(Order::Override(wanted)).is_ok() {
            *asked = wanted;
        }
    }

    /// Returns the process state.
    fn doing(&self, work: &Work<'_>, progress: &Progress<'_>) -> Doing {
        let Progress { now, pass, welds, welded_mm, burnt_s } = *progress;
        let welded = pass.filter(|_| welds);
        let tip = now.played.rates.tip;
        let asked = welded.is_some() && now.phase.arc();
        let until_off_s = if now.phase == RunPhase::Crater { now.left_s } else { f64::INFINITY };
        let time = ArcTime { since_on_s: burnt_s, until_off_s };
        let gas = !matches!(now.phase, RunPhase::Held | RunPhase::Move | RunPhase::Ended);
        let values = welded.filter(|_| asked).map_or([0.0; VALUES], |i| work.process_at(i, tip.s, time));
        let place = pass.map_or_else(Place::default, |i| Place { pass: i + 1, s_mm: tip.s });
        let in_pass = pass.is_some();
        Doing {
            seam: SeamOrders::default(),
            asked,
            gas: welded.is_some() && gas,
            values,
            phase: in_pass.then_some(now.phase),
            place,
            speed: if in_pass { tip.v } else { 0.0 },
            steady: false,
            welded_mm: if in_pass { welded_mm } else { 0.0 },
        }
    }
}

/// Returns the guide's view of a cycle.
fn planned(now: &Instant) -> Planned<'_> {
    let (tip, travels) = (now.played.rates.tip, now.phase.arc());
    Planned { s_mm: tip.s, speed: tip.v, travels, rests: tip.v == 0.0 && !travels, q: &now.played.rates.q }
}
