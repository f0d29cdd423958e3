mod orders;

use super::Command;
use super::control::{FeedOverride, Played};
use super::error::FeedOverrideError;
use super::run_phase::{Instant, RunPhase};
use super::timed_motion::Timed;
use seamwright_program::{AtHold, Sequence, is_before, is_beyond, is_same_position};

/// Next action once the torch rests with the process off.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Then {
    Wait,
    Back,
    Start(Goal),
    End,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Goal {
    End,
    NextPlace,
    Place(f64),
}

/// A pass that runs under an operator's orders: the feed override with the process.
///
/// The process follows the actual motion of the tip, not the order: the crater is filled once the tip rests; a beam is
/// off from the first set-point with a falling override. A restart moves with the process off to the end of the weld
/// less the overlap and stops there exactly. Gas, ignition and travel follow as at the start. Invariant: arc or beam is
/// on at rest only in travel delay and crater.
#[derive(Debug)]
pub struct Run<'a, L: Timed + ?Sized> {
    feed_override: FeedOverride<'a, L>,
    sequence: Sequence,
    places: Vec<f64>,
    phase: RunPhase,
    then: Then,
    /// True while the torch must stop with the process on.
    stopping: bool,
    goal: Goal,
    /// Periods left in a phase at rest.
    left: u64,
    welded: f64,
    /// Requested override; moves with the process off are limited to [`MOVE`].
    asked: f64,
    zero: bool,
    /// False while arc or beam is requested but does not burn.
    burns: bool,
    /// True while a move heads for a stop.
    seeks: bool,
    /// Number of moves that missed the same stop.
    missed: u32,
    /// Consecutive periods without the required motion.
    still: u64,
    last: Played,
}

/// Maximum override of moves with the process off: at it a profile at its limits leaves half of the accelerations and
/// more of the jerks, enough for a stop anywhere.
const MOVE: f64 = 0.6;
/// Maximum time without the required motion, s: the search for a course pauses for a few periods at most.
const PATIENCE: f64 = 0.1;
/// Maximum number of moves to one stop, each at half the override of the previous one.
const MOVES: u32 = 6;

impl<'a, L: Timed + ?Sized> Run<'a, L> {
    /// Creates a run of `feed_override` from its position, waiting for [`super::Order::Resume`] or [`super::Order::Step`]. Steps
    /// end at `places` (mm, those on the path count). From a position inside the path the run goes back by the overlap
    /// first: [`FeedOverride::from_place`] at [`Run::welded_to`] continues an aborted run. A moving `feed_override` is stopped first; at
    /// the end of the path the run has ended.
    pub fn new(mut feed_override: FeedOverride<'a, L>, sequence: Sequence, places: &[f64]) -> Self {
        let mut places = places.to_vec();
        places.retain(|s| s.is_finite());
        places.sort_by(f64::total_cmp);
        // Hold is always allowed.
        feed_override.command(Command::Hold).ok();
        let last = feed_override.step();
        let phase = match (feed_override.at_end(), feed_override.at_rest()) {
            (true, _) => RunPhase::Ended,
            (_, true) => RunPhase::Held,
            _ => RunPhase::Move,
        };
        Self {
            feed_override,
            sequence,
            places,
            phase,
            then: Then::Wait,
            stopping: false,
            goal: Goal::End,
            left: 0,
            welded: last.rates.tip.s,
            asked: 1.0,
            zero: false,
            burns: true,
            seeks: false,
            missed: 0,
            still: 0,
            last,
        }
    }

    /// Path length welded to, mm: an ended or held run can continue there.
    pub fn welded_to(&self) -> f64 {
        self.welded
    }

    /// Current phase and state.
    pub fn now(&self) -> Instant {
        Instant { phase: self.phase, left_s: self.left as f64 * self.feed_override.period(), played: self.last }
    }

    /// Sets whether arc or beam burns in phases that require it; true by default. While false the travel delay does not
    /// elapse, the torch does not start, no crater is filled, and the passed part counts as not welded.
    pub fn set_burning(&mut self, burns: bool) {
        self.burns = burns;
        if !burns && self.phase == RunPhase::Crater {
            self.rest(RunPhase::Postflow);
        }
    }

    /// State in the last played period, `before` s before its end.
    pub fn earlier(&self, before: f64) -> Played {
        self.feed_override.earlier(before)
    }

    fn travel(&mut self, goal: Goal) -> Result<(), FeedOverrideError> {
        self.feed_override.command(Command::Override(self.asked))?;
        self.phase = RunPhase::Travel;
        self.stopping = false;
        self.goal = goal;
        let place = match goal {
            Goal::End => None,
            Goal::NextPlace => self.next_place(self.last.rates.tip.s.max(self.welded)),
            Goal::Place(s) => Some(s),
        };
        self.feed_override.command(place.map_or(Command::Resume, Command::StopAt))
    }

    fn next_place(&self, here: f64) -> Option<f64> {
        self.places.iter().copied().find(|s| is_beyond(*s, here) && *s < self.feed_override.length())
    }

    /// Limits the override of moves without process so that a stop is possible anywhere; lower after missed stops.
    fn calm(&mut self) {
        let feed_override = MOVE / f64::from(1u32 << self.missed.min(MOVES));
        self.feed_override.command(Command::Override(self.asked.min(feed_override))).ok();
    }

    fn rest(&mut self, phase: RunPhase) {
        let s = &self.sequence;
        let seconds = match phase {
            RunPhase::Preflow => s.preflow_s,
            RunPhase::TravelDelay => s.travel_delay_s,
            RunPhase::Crater => s.crater_s,
            _ => s.postflow_s,
        };
        self.phase = phase;
        self.left = (seconds.get() / self.feed_override.period() - 1e-9).ceil().max(0.0) as u64;
    }

    /// Plays the next period.
    ///
    /// # Errors
    /// [`FeedOverrideError::Stuck`] if the motion cannot go on: then the process goes off as at a hold, and the run waits,
    /// held. Impossible with a profile planned for the same limits.
    pub fn step(&mut self) -> Result<Instant, FeedOverrideError> {
        let before = self.last.phi;
        self.last = self.feed_override.step();
        self.watch()?;
        match self.phase {
            RunPhase::Held | RunPhase::Ended => {}
            RunPhase::TravelDelay if !self.burns => {}
            RunPhase::Preflow | RunPhase::TravelDelay | RunPhase::Crater | RunPhase::Postflow => {
                self.left = self.left.saturating_sub(1);
            }
            RunPhase::Travel => self.while_travelling(before),
            RunPhase::RunOut if self.feed_override.at_rest() => self.rest(RunPhase::Postflow),
            RunPhase::Move if self.feed_override.at_rest() => self.off_at_rest(),
            RunPhase::Move if self.seeks && self.feed_override.stop().is_none() => self.miss()?,
            RunPhase::RunOut | RunPhase::Move => {}
        }
        self.pass_over()?;
        Ok(self.now())
    }

    fn watch(&mut self) -> Result<(), FeedOverrideError> {
        let moves = matches!(self.phase, RunPhase::Travel | RunPhase::RunOut | RunPhase::Move);
        self.still = if moves && self.last.phi.abs() <= 0.0 { self.still + 1 } else { 0 };
        if (self.still as f64) * self.feed_override.period() <= PATIENCE {
            return Ok(());
        }
        self.still = 0;
        self.stop_for(Then::Wait);
        Err(FeedOverrideError::Stuck { s: self.last.rates.tip.s })
    }

    /// Handles a move that dropped its stop. If that is still ahead the stop is requested again, else the move stops
    /// and repeats, slower, a few times.
    fn miss(&mut self) -> Result<(), FeedOverrideError> {
        let place = self.restart_place();
        if (place - self.last.rates.tip.s) * self.last.phi > 0.0 {
            return self.feed_override.command(Command::StopAt(place));
        }
        self.halt();
        self.missed += 1;
        if self.missed <= MOVES {
            return Ok(());
        }
        (self.missed, self.then) = (0, Then::Wait);
        Err(FeedOverrideError::Stuck { s: self.last.rates.tip.s })
    }

    fn halt(&mut self) {
        self.seeks = false;
        self.feed_override.command(Command::Hold).ok();
    }

    fn while_travelling(&mut self, before: f64) {
        let s = self.last.rates.tip.s;
        if !self.burns {
            // Welding has ended: the torch stops here, or rests already.
            if !self.stopping {
                self.stop_for(Then::Wait);
            }
            self.phase = RunPhase::RunOut;
            return;
        }
        self.welded = self.welded.max(s);
        if self.feed_override.at_end() {
            // The end of the pass; a late abort needs no action.
            self.then = Then::End;
            self.rest(RunPhase::Crater);
        } else if self.feed_override.at_rest() {
            self.rest(RunPhase::Crater);
        } else {
            let slows = self.stopping || self.feed_override.stop().is_some_and(|(_, begun)| begun);
            if slows && self.sequence.at_hold == AtHold::Off && self.last.phi < before {
                self.phase = RunPhase::RunOut;
            } else if !self.stopping && self.feed_override.stop().is_none() {
                self.after_missed_place(s);
            }
        }
    }

    /// Handles a dropped stop: while it is ahead it is requested again, else the next one, or a stop as soon as
    /// possible.
    fn after_missed_place(&mut self, s: f64) {
        let next = match self.goal {
            Goal::End => return,
            Goal::NextPlace => self.next_place(s),
            Goal::Place(place) if !is_before(place, self.feed_override.length()) => return,
            Goal::Place(place) => Some(place).filter(|place| is_beyond(*place, s)),
        };
        match (next, self.goal) {
            (Some(place), _) => self.feed_override.command(Command::StopAt(place)).unwrap_or_default(),
            (None, Goal::Place(_)) => self.stop_for(Then::Wait),
            (None, _) => {}
        }
    }

    fn pass_over(&mut self) -> Result<(), FeedOverrideError> {
        while self.left == 0 {
            match self.phase {
                RunPhase::Preflow => self.rest(RunPhase::TravelDelay),
                RunPhase::TravelDelay if self.burns => return self.travel(self.goal),
                RunPhase::Crater => self.rest(RunPhase::Postflow),
                RunPhase::Postflow => {
                    self.off_at_rest();
                    if self.phase == RunPhase::Postflow {
                        return Ok(());
                    }
                }
                _ => return Ok(()),
            }
        }
        Ok(())
    }

    /// Path length at which the process restarts, mm.
    fn restart_place(&self) -> f64 {
        (self.welded - self.sequence.overlap_mm.get()).max(0.0)
    }

    fn off_at_rest(&mut self) {
        let s = self.last.rates.tip.s;
        match self.then {
            Then::Wait => self.phase = RunPhase::Held,
            Then::End => self.phase = RunPhase::Ended,
            Then::Back => {
                self.phase = RunPhase::Move;
                self.then = Then::Wait;
                self.calm();
                self.feed_override.command(Command::Reverse).ok();
            }
            Then::Start(goal) => {
                let place = self.restart_place();
                self.calm();
                self.feed_override.command(Command::StopAt(place)).ok();
                if is_same_position(s, place) || self.feed_override.at_rest() {
                    (self.then, self.missed) = (Then::Wait, 0);
                    self.halt();
                    self.goal = goal;
                    self.rest(RunPhase::Preflow);
                } else {
                    self.phase = RunPhase::Move;
                    // At both ends of the path the motion stops anyway.
                    self.seeks = self.feed_override.stop().is_some();
                }
            }
        }
    }
}
