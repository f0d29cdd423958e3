//! A tracked pass: the move to see its start, the weld, the return to the plan.

use super::alarm_number::detail;
use super::carrier::Wanted;
use super::head_requests::Step;
use super::live_head::{AlarmAt, HeadOrders, HeadReport, LiveHead};
use super::pass_seams::Correction;
use super::path_offset::PathOffset;
use super::retreat::{Retreat, STEP_MM};
use crate::executive::{Guided, Planned, SeamOrders, Seen, Tracked, Trouble};
use arrayvec::ArrayVec;
use seamwright_machine::{Joints, Machine, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::PassMotion;
use seamwright_tracking::actuator::{Alarm, Lag, MAX_LAG_S, OverAxes, Slide, SlideLimits};
use std::collections::VecDeque;

/// Minimum feed override; below it the torch stops.
const SLOWEST: f64 = 0.01;
/// Time for the move to see the start, in addition to that at its speed, s.
const SLACK_S: f64 = 60.0;
/// Time in which corrections come to rest by themselves before they are braked, s.
const SETTLES_S: f64 = 0.1;

/// A pass, the guides of its heads, and the carrier of its corrections.
pub(super) struct TrackedPass<'a> {
    machine: &'a Machine,
    planned: &'a PassMotion,
    /// Counted from 1.
    number: usize,
    pub(super) heads: ArrayVec<LiveHead<'a>, 2>,
    correction: Correction<'a>,
    off: PathOffset,
    look: Look<'a>,
    /// Reason why the move to see the start is cut short, if it is.
    cut: Option<Message>,
    /// Start of the pass, mm.
    from_mm: f64,
    /// Last path lengths of the heads, and whether they wove there, the newest first.
    recent: VecDeque<(f64, bool)>,
    /// Number of cycles at rest.
    rested: u32,
    returns: bool,
    /// The pass was started before.
    pub(super) used: bool,
}

#[derive(Clone, Copy)]
pub(super) struct PassStart<'a> {
    pub(super) machine: &'a Machine,
    pub(super) planned: &'a PassMotion,
    /// Counted from 1.
    pub(super) number: usize,
    /// Start of the pass, mm.
    pub(super) from_mm: f64,
}

#[derive(Clone, Copy)]
struct PlannedAxes<'a> {
    q: &'a Joints,
    weaves: bool,
    /// The torch is to come to rest.
    rests: bool,
}

/// Preparation before a pass is run. It is dropped only with the pass: earlier would cost a cycle.
struct Look<'a> {
    /// The torch goes back along the seam or its extension and forward again, with the arc off.
    sight: Option<Box<Sight<'a>>>,
    /// The move is complete.
    sighted: bool,
    /// Remaining cycles at rest after the move.
    gaze: u64,
}

impl Look<'_> {
    fn gaze(gaze: u64) -> Self {
        Self { sight: None, sighted: false, gaze }
    }
}

/// A move to see the start.
struct Sight<'a> {
    mover: Slide,
    over: OverAxes<'a>,
    way: f64,
    speed: f64,
    target: f64,
    at: f64,
    back: bool,
    there: Joints,
    left: u64,
}

impl<'a> TrackedPass<'a> {
    /// Creates the pass that begins at `start`; the move to see the start keeps clear of `around`.
    pub(super) fn new(
        start: PassStart<'a>,
        heads: ArrayVec<LiveHead<'a>, 2>,
        correction: Correction<'a>,
        around: Option<&Surroundings<'_>>,
    ) -> Self {
        let PassStart { machine, planned, number, from_mm } = start;
        let off = PathOffset::new(machine);
        let look = Look::gaze(0);
        let cut = None;
        let recent = VecDeque::with_capacity((MAX_LAG_S / machine.servo_period_s).ceil() as usize + 2);
        let mut pass = Self {
            machine,
            planned,
            number,
            heads,
            correction,
            off,
            look,
            cut,
            from_mm,
            recent,
            rested: 0,
            returns: false,
            used: false,
        };
        pass.look = pass.first_look(around);
        pass
    }

    /// Returns the number of cycles that the beams need to look at the start.
    fn gaze(&self) -> u64 {
        let look_s = self.heads.iter().filter_map(LiveHead::look_s).fold(0.0, f64::max);
        (look_s / self.machine.servo_period_s).ceil() as u64
    }

    /// Prepares the first look: determines how far the torch can go back, and why no farther.
    fn first_look(&mut self, around: Option<&Surroundings<'_>>) -> Look<'a> {
        let wanted = self.heads.iter().filter_map(LiveHead::sighting_mm);
        let Some((way, speed)) = wanted.reduce(|a, b| (a.0.max(b.0), a.1.min(b.1))) else {
            return Look::gaze(self.gaze());
        };
        // The overlap, which is welded again, must be known too.
        let overlap = if self.from_mm > 0.0 { self.planned.sequence.overlap_mm.get() } else { 0.0 };
        let way = way + overlap;
        let period = self.machine.servo_period_s;
        let start = self.planned.path.at(self.from_mm);
        let frame = self.heads[0].frame(self.from_mm);
        let over = self.correction.carrier.carrying();
        let directions = [frame.along, frame.height];
        let Ok(most) = over.limits(std::iter::once((start, directions)), 2.0 * way) else { return Look::gaze(0) };
        // Half of the limits: the axes' share in the same motion changes along the way.
        let limits = SlideLimits { motion: most.motion.scaled(0.5), ..most };
        let Ok(mover) = Slide::new(limits, period) else { return Look::gaze(0) };
        let way = self.free_way(way, around);
        let speed = speed.min(limits.motion.speed);
        let left = ((2.0 * way / speed + SLACK_S) / period) as u64;
        let (target, back) = (-way, way <= 0.0);
        let sight = Sight { mover, over, way, speed, target, at: 0.0, back, there: start, left };
        Look { sight: Some(Box::new(sight)), ..Look::gaze(self.gaze()) }
    }

    /// Returns the part of `way` mm back from the start that the axes reach without collision. It is determined
    /// before any motion, and reported if it is shorter.
    fn free_way(&mut self, way: f64, around: Option<&Surroundings<'_>>) -> f64 {
        let start = self.planned.path.at(self.from_mm);
        let frame = |s: f64| self.heads[0].frame(self.from_mm + s).point;
        let mut probe = self.correction.carrier.carrying();
        let count = (way / STEP_MM).ceil();
        let step_mm = way / count;
        let place = |k: u32| probe.shifted(&start, frame(-step_mm * f64::from(k)) - frame(0.0)).ok();
        let reached = (1..=count as u32).map_while(place);
        let sighting = Retreat { step_mm, places: std::iter::once(start).chain(reached).collect() };
        let reach = sighting.way_mm();
        let (clear, near) = around.map_or((reach, None), |around| sighting.clear_mm(around));
        if clear < way - 1e-9 {
            let why = near.unwrap_or_else(|| Message::new("cell-end-of-reach"));
            let cut = Message::new("cell-sighting-length").quantity("clear", clear, Unit::Mm, 1);
            self.cut = Some(cut.quantity("wanted", way, Unit::Mm, 1).message("why", why));
        }
        clear
    }

    /// Runs a cycle of the look at the start; returns `None` when it is over. Does not allocate.
    pub(super) fn look(&mut self, seen: &Seen<'_>, goes: bool) -> Option<Guided> {
        let from = self.from_mm;
        let period = self.machine.servo_period_s;
        if let Some(sight) = self.look.sight.as_mut().filter(|_| !self.look.sighted) {
            let done = sight.back && sight.at.abs() < 1e-9 && sight.target >= 0.0;
            if sight.left > 0 && !done {
                let before = sight.at;
                sight.at = if goes { sight.mover.step(sight.target) } else { sight.mover.brake() };
                sight.back |= sight.at <= -sight.way + 1e-6;
                if goes {
                    sight.left -= 1;
                    if sight.back {
                        sight.target = (sight.target + sight.speed * period).min(0.0);
                    }
                }
                let (start, frame) = (self.planned.path.at(from), self.heads[0].frame(from));
                let by = self.heads[0].frame(from + sight.at).point - frame.point;
                // Reachable, as probed before.
                sight.there = sight.over.shifted(&start, by).unwrap_or(sight.there);
                let (at, there, back) = (sight.at, sight.there, sight.back);
                let speed = (at - before) / period;
                let step = self.step(seen, from + at, speed, false);
                let rests = !goes && step.speed == 0.0;
                if !back {
                    // The joint is not observed on the way back.
                    self.remember(step.s, false);
                    return Some(self.guided(&there, 1.0, None, SeamOrders::default()));
                }
                return Some(self.correct(seen, &step, PlannedAxes { q: &there, weaves: false, rests }).0);
            }
            self.look.sighted = true;
        }
        if self.look.gaze == 0 && goes {
            return None;
        }
        self.look.gaze = self.look.gaze.saturating_sub(u64::from(goes));
        let start = self.planned.path.at(from);
        let step = self.step(seen, from, 0.0, false);
        Some(self.correct(seen, &step, PlannedAxes { q: &start, weaves: false, rests: !goes }).0)
    }

    /// Describes a cycle with the set-point at `s`: the torch is where the drives' lag leaves it.
    fn step(&self, seen: &Seen<'_>, s: f64, speed: f64, welds: bool) -> Step {
        let drives = &seen.reports.drives;
        let shows_s = drives.lag_s.min(MAX_LAG_S);
        let follows_s = (shows_s - drives.age_s).max(0.0);
        let torch = self.recent(follows_s).filter(|_| shows_s > 0.0);
        let lag = torch.map_or(Lag::none(s), |(torch_mm, _)| Lag { torch_mm, follows_s, shows_s });
        Step { t: seen.t_s, s, speed, welds, lag }
    }

    /// Records the path length of a cycle.
    fn remember(&mut self, s: f64, weaves: bool) {
        if self.recent.len() == self.recent.capacity() {
            self.recent.pop_back();
        }
        self.recent.push_front((s, weaves));
    }

    /// Returns the path length `age_s` before the last cycle, and whether the heads wove there.
    fn recent(&self, age_s: f64) -> Option<(f64, bool)> {
        let last = self.recent.len().checked_sub(1)?;
        let age = (age_s / self.machine.servo_period_s).clamp(0.0, last as f64);
        let newer = age.floor() as usize;
        let (a, b) = (self.recent[newer], self.recent[(newer + 1).min(last)]);
        Some((a.0 + (b.0 - a.0) * (age - newer as f64), a.1))
    }

    /// Checks whether the pass may be run after the look.
    pub(super) fn ready(&mut self) -> Result<(), Trouble> {
        let (mut worst, from) = (None, self.from_mm);
        // Checks all heads, so that each reports its alarm.
        for (number, head) in self.heads.iter_mut().enumerate() {
            if let Err(alarm) = head.ready(from) {
                worst = worst.or(Some(Trouble::Stop(detail(number, alarm))));
            }
        }
        let Some(trouble) = worst else { return Ok(()) };
        self.heads.iter_mut().for_each(|head| head.stopped(Some(from)));
        Err(trouble)
    }

    /// Runs a cycle of the pass. Does not allocate.
    pub(super) fn follow(&mut self, seen: &Seen<'_>, planned: &Planned<'_>) -> Guided {
        let Planned { s_mm, speed, travels, rests, q } = *planned;
        let step = self.step(seen, s_mm, speed, travels);
        let (mut guided, stops) = self.correct(seen, &step, PlannedAxes { q, weaves: true, rests });
        if travels {
            let stopped = stops.then_some(s_mm);
            self.heads.iter_mut().for_each(|head| head.stopped(stopped));
        } else {
            // Only a pass that welds, or would weld, is slowed down and stopped.
            (guided.feed_override, guided.trouble) = (1.0, None);
        }
        guided
    }

    /// Runs a cycle of all heads and offsets the axes from their planned positions; true if the torch is to stop.
    fn correct(&mut self, seen: &Seen<'_>, step: &Step, axes: PlannedAxes<'_>) -> (Guided, bool) {
        let PlannedAxes { q, weaves, rests } = axes;
        if let Some((s, wove)) = self.recent(seen.reports.drives.lag_s) {
            let position = &seen.reports.drives.position;
            self.heads.iter_mut().for_each(|head| head.feel(self.machine, s, position, wove));
        }
        self.remember(step.s, weaves);
        let mut wanted: ArrayVec<Wanted, 2> = ArrayVec::new();
        let (mut feed_override, mut trouble) = (1.0f64, None);
        let mut seam = SeamOrders { pass: self.number, s_mm: step.s, weaves, ..SeamOrders::default() };
        for (number, head) in self.heads.iter_mut().enumerate() {
            let HeadOrders { wanted: here, requests, news } = head.cycle(seen, step);
            wanted.push(here);
            (seam.beam, seam.deflection_mm) = (requests.beam, requests.deflection_mm);
            feed_override = feed_override.min(requests.feed_override);
            if let Some((alarm, _)) = requests.alarm.filter(|_| requests.feed_override < SLOWEST) {
                trouble = Some(Trouble::Stop(detail(number, alarm)));
            } else if let Some(alarm) = news {
                trouble = trouble.or(Some(Trouble::Tell(detail(number, alarm))));
            }
        }
        self.rested = if rests { self.rested.saturating_add(1) } else { 0 };
        let settles = (SETTLES_S / self.machine.servo_period_s) as u32;
        let carrier = &mut self.correction.carrier;
        if self.rested > settles {
            self.off.rest(q, || carrier.shifted(q, &wanted));
        } else if !self.off.follow(q, || carrier.shifted(q, &wanted)) {
            feed_override = 0.0;
            for head in &mut self.heads {
                head.tell(step.s, Alarm::StrokeEnd, None);
            }
            trouble = Some(Trouble::Stop(detail(0, Alarm::StrokeEnd)));
        }
        let stops = feed_override < SLOWEST;
        (self.guided(q, feed_override, trouble, seam), stops)
    }

    /// Offsets the axes from the planned positions `q`.
    fn guided(&mut self, q: &Joints, feed_override: f64, trouble: Option<Trouble>, seam: SeamOrders) -> Guided {
        let q = self.off.positions(q);
        let (v, a) = self.off.rates(&q);
        Guided { q, v, a, feed_override, trouble, seam }
    }

    /// Runs a cycle of the return to the planned positions `q`; returns `None` once they are reached. Does not
    /// allocate.
    pub(super) fn settle(&mut self, q: &Joints, goes: bool) -> Option<Guided> {
        if !goes {
            self.returns = false;
            self.off.rest(q, || Some(*q));
        } else {
            if !self.returns {
                self.returns = true;
                self.off.begin_return();
            }
            if !self.off.returns() {
                return None;
            }
        }
        Some(self.guided(q, 1.0, None, SeamOrders::default()))
    }

    /// Returns the estimate of each head.
    pub(super) fn tracked(&self) -> [Option<Tracked>; 2] {
        std::array::from_fn(|i| self.heads.get(i).and_then(LiveHead::tracked))
    }

    pub(super) fn reports(&self) -> Vec<HeadReport> {
        let cut = self.cut.as_ref().map(|cause| AlarmAt {
            at_mm: self.from_mm,
            alarm: Message::new("cell-sighting-cut-short"),
            cause: Some(cause.clone()),
        });
        let report = |head: &LiveHead<'_>| {
            let mut report = head.report();
            report.alarms.splice(0..0, cut.clone());
            report
        };
        self.heads.iter().map(report).collect()
    }
}
