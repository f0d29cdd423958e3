mod take;

use super::control::{Pace, Played};
use super::order::{Instant, RunPhase};
use super::timed::Timed;
use super::{Command, PaceError};
use seamwright_program::{AtHold, Sequence, is_before, is_beyond, is_same_position};

/// What follows when the torch rests with the process off.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Then {
    Wait,
    Back,
    Start(Goal),
    End,
}

/// How far to weld.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Goal {
    End,
    NextPlace,
    Place(f64),
}

/// A pass that runs under an operator's orders: the pace with the process around it.
///
/// The process follows what the tip really does, not the order: the crater is filled once the tip stands still; a
/// beam is off from the first set-point at which the pace falls. A restart goes to the place where the process went
/// off less the overlap, with the process off and stops there exactly; then gas, ignition and travel come as at the
/// start. Invariant: arc or beam is on at rest only in the phases that are meant for it, travel delay and crater.
#[derive(Debug)]
pub struct Run<'a, L: Timed + ?Sized> {
    pace: Pace<'a, L>,
    sequence: Sequence,
    places: Vec<f64>,
    phase: RunPhase,
    then: Then,
    /// True while the torch is to stop with the process on.
    stopping: bool,
    goal: Goal,
    /// Periods left in a phase at rest.
    left: u64,
    /// Path length welded to, mm.
    welded: f64,
    /// Override asked for; moves with the process off are no faster than [`MOVE`].
    asked: f64,
    zero: bool,
    /// False while arc or beam does not burn although it is asked for.
    burns: bool,
    /// True while a move heads for a place to stop at.
    seeks: bool,
    /// How often moves to one place have missed it.
    missed: u32,
    /// Periods that nothing has moved in although it should.
    still: u64,
    last: Played,
}

/// Greatest pace of moves with the process off: at this pace a law at its limits leaves half of its accelerations and
/// more of its jerks, so that a stop at a place always has room.
const MOVE: f64 = 0.6;
/// How long nothing may move that should, s: the search for a course pauses for a few periods at most.
const PATIENCE: f64 = 0.1;
/// Moves to one place, each at half the pace of the one before.
const MOVES: u32 = 6;

impl<'a, L: Timed + ?Sized> Run<'a, L> {
    /// A run of `pace` from where it stands, waiting for [`super::Order::Resume`] or [`super::Order::Step`]. Steps
    /// end at `places` (mm, those on the path count). A pace that stands inside the path goes back by the overlap
    /// first: with
    /// [`Pace::from_place`] at [`Run::welded_to`] an aborted run goes on. A pace that moves is stopped first; one that
    /// stands at the end leaves nothing to do, and the run has ended.
    pub fn new(mut pace: Pace<'a, L>, sequence: Sequence, places: &[f64]) -> Self {
        let mut places = places.to_vec();
        places.retain(|s| s.is_finite());
        places.sort_by(f64::total_cmp);
        // Hold is always allowed.
        pace.command(Command::Hold).ok();
        let last = pace.step();
        let phase = match (pace.at_end(), pace.at_rest()) {
            (true, _) => RunPhase::Ended,
            (_, true) => RunPhase::Held,
            _ => RunPhase::Move,
        };
        Self {
            pace,
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

    /// Path length welded to, mm: where an ended or held run can go on.
    pub fn welded_to(&self) -> f64 {
        self.welded
    }

    /// What it does just now.
    pub fn now(&self) -> Instant {
        Instant { phase: self.phase, left_s: self.left as f64 * self.pace.period(), played: self.last }
    }

    /// Tells whether arc or beam burns where the phase asks for it; true unless told otherwise. Without it the travel delay does not
    /// run down, the torch does not start, no crater is filled, and what is passed is not welded.
    pub fn set_burning(&mut self, burns: bool) {
        self.burns = burns;
        if !burns && self.phase == RunPhase::Crater {
            self.rest(RunPhase::Postflow);
        }
    }

    /// What is played in the period last played, `before` s before its end.
    pub fn earlier(&self, before: f64) -> Played {
        self.pace.earlier(before)
    }

    /// Travels with the process on, as far as asked.
    fn travel(&mut self, goal: Goal) -> Result<(), PaceError> {
        self.pace.command(Command::Override(self.asked))?;
        self.phase = RunPhase::Travel;
        self.stopping = false;
        self.goal = goal;
        let place = match goal {
            Goal::End => None,
            Goal::NextPlace => self.next_place(self.last.rates.tip.s.max(self.welded)),
            Goal::Place(s) => Some(s),
        };
        self.pace.command(place.map_or(Command::Resume, Command::StopAt))
    }

    fn next_place(&self, here: f64) -> Option<f64> {
        self.places.iter().copied().find(|s| is_beyond(*s, here) && *s < self.pace.length())
    }

    /// Moves without process at a pace that leaves room to stop anywhere; slower if that was not enough.
    fn calm(&mut self) {
        let pace = MOVE / f64::from(1u32 << self.missed.min(MOVES));
        self.pace.command(Command::Override(self.asked.min(pace))).ok();
    }

    /// Begins a phase at rest.
    fn rest(&mut self, phase: RunPhase) {
        let s = &self.sequence;
        let seconds = match phase {
            RunPhase::Preflow => s.preflow_s,
            RunPhase::TravelDelay => s.travel_delay_s,
            RunPhase::Crater => s.crater_s,
            _ => s.postflow_s,
        };
        self.phase = phase;
        self.left = (seconds.get() / self.pace.period() - 1e-9).ceil().max(0.0) as u64;
    }

    /// Plays the next period.
    ///
    /// # Errors
    /// [`PaceError::Stuck`] if the motion cannot go on: then the process goes off as at a hold, and the run waits,
    /// held. Never with a law that is planned for the limits of the pace.
    pub fn step(&mut self) -> Result<Instant, PaceError> {
        let before = self.last.phi;
        self.last = self.pace.step();
        self.watch()?;
        match self.phase {
            RunPhase::Held | RunPhase::Ended => {}
            RunPhase::TravelDelay if !self.burns => {}
            RunPhase::Preflow | RunPhase::TravelDelay | RunPhase::Crater | RunPhase::Postflow => {
                self.left = self.left.saturating_sub(1);
            }
            RunPhase::Travel => self.while_travelling(before),
            RunPhase::RunOut if self.pace.at_rest() => self.rest(RunPhase::Postflow),
            RunPhase::Move if self.pace.at_rest() => self.off_at_rest(),
            RunPhase::Move if self.seeks && self.pace.stop().is_none() => self.miss()?,
            RunPhase::RunOut | RunPhase::Move => {}
        }
        self.pass_over()?;
        Ok(self.now())
    }

    /// Stops what should move and does not.
    fn watch(&mut self) -> Result<(), PaceError> {
        let moves = matches!(self.phase, RunPhase::Travel | RunPhase::RunOut | RunPhase::Move);
        self.still = if moves && self.last.phi.abs() <= 0.0 { self.still + 1 } else { 0 };
        if (self.still as f64) * self.pace.period() <= PATIENCE {
            return Ok(());
        }
        self.still = 0;
        self.stop_for(Then::Wait);
        Err(PaceError::Stuck { s: self.last.rates.tip.s })
    }

    /// A move has given up its place. If that is still ahead it may hold now; else it stops where it can and comes
    /// again, slower, a few times.
    fn miss(&mut self) -> Result<(), PaceError> {
        let place = self.restart_place();
        if (place - self.last.rates.tip.s) * self.last.phi > 0.0 {
            return self.pace.command(Command::StopAt(place));
        }
        self.halt();
        self.missed += 1;
        if self.missed <= MOVES {
            return Ok(());
        }
        (self.missed, self.then) = (0, Then::Wait);
        Err(PaceError::Stuck { s: self.last.rates.tip.s })
    }

    /// Holds the pace, which is always allowed.
    fn halt(&mut self) {
        self.seeks = false;
        self.pace.command(Command::Hold).ok();
    }

    fn while_travelling(&mut self, before: f64) {
        let s = self.last.rates.tip.s;
        if !self.burns {
            // Nothing is welded any more: the torch stops here, or rests already.
            if !self.stopping {
                self.stop_for(Then::Wait);
            }
            self.phase = RunPhase::RunOut;
            return;
        }
        self.welded = self.welded.max(s);
        if self.pace.at_end() {
            // The end of the pass; an abort that comes too late is as good as done.
            self.then = Then::End;
            self.rest(RunPhase::Crater);
        } else if self.pace.at_rest() {
            self.rest(RunPhase::Crater);
        } else {
            let slows = self.stopping || self.pace.stop().is_some_and(|(_, begun)| begun);
            if slows && self.sequence.at_hold == AtHold::Off && self.last.phi < before {
                self.phase = RunPhase::RunOut;
            } else if !self.stopping && self.pace.stop().is_none() {
                self.after_missed_place(s);
            }
        }
    }

    /// The place to stop at has been given up, if there was one: while it is ahead a stop may hold now, then the one
    /// after counts, or as soon as can be.
    fn after_missed_place(&mut self, s: f64) {
        let next = match self.goal {
            Goal::End => return,
            Goal::NextPlace => self.next_place(s),
            Goal::Place(place) if !is_before(place, self.pace.length()) => return,
            Goal::Place(place) => Some(place).filter(|place| is_beyond(*place, s)),
        };
        match (next, self.goal) {
            (Some(place), _) => self.pace.command(Command::StopAt(place)).unwrap_or_default(),
            (None, Goal::Place(_)) => self.stop_for(Then::Wait),
            (None, _) => {}
        }
    }

    /// Goes through phases at rest that are over.
    fn pass_over(&mut self) -> Result<(), PaceError> {
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

    /// Where the process starts again, mm.
    fn restart_place(&self) -> f64 {
        (self.welded - self.sequence.overlap_mm.get()).max(0.0)
    }

    /// The torch rests and the process is off: what follows?
    fn off_at_rest(&mut self) {
        let s = self.last.rates.tip.s;
        match self.then {
            Then::Wait => self.phase = RunPhase::Held,
            Then::End => self.phase = RunPhase::Ended,
            Then::Back => {
                self.phase = RunPhase::Move;
                self.then = Then::Wait;
                self.calm();
                self.pace.command(Command::Reverse).ok();
            }
            Then::Start(goal) => {
                let place = self.restart_place();
                self.calm();
                self.pace.command(Command::StopAt(place)).ok();
                if is_same_position(s, place) || self.pace.at_rest() {
                    (self.then, self.missed) = (Then::Wait, 0);
                    self.halt();
                    self.goal = goal;
                    self.rest(RunPhase::Preflow);
                } else {
                    self.phase = RunPhase::Move;
                    // At both ends of the path it stops by itself.
                    self.seeks = self.pace.stop().is_some();
                }
            }
        }
    }
}
