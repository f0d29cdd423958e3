use super::control::{Pace, Played};
use super::order::{Instant, Order, RunPhase};
use super::timed::Timed;
use super::{Command, PaceError};
use seamwright_program::{AtHold, Sequence};

/// What follows when the torch rests with the process off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Then {
    Wait,
    Back,
    Start { step: bool },
    End,
}

/// A pass that runs under an operator's orders: the pace with the process around it.
///
/// The process follows what the tip really does, not the order: the crater is filled once the tip stands still; a beam is
/// off from the first set-point at which the pace falls. A restart goes to the place where the process went off less
/// the overlap, with the process off and stops there exactly; then gas, ignition and travel come as at the start.
/// Invariant: arc or beam is on at rest only in the phases that are meant for it, travel delay and crater.
#[derive(Debug)]
pub struct Run<'a, L: Timed + ?Sized> {
    pace: Pace<'a, L>,
    sequence: Sequence,
    places: Vec<f64>,
    phase: RunPhase,
    then: Then,
    /// True while the torch is to stop with the process on.
    stopping: bool,
    stepping: bool,
    /// Periods left in a phase at rest.
    left: u64,
    /// Path length welded to, mm.
    welded: f64,
    /// Override asked for; moves with the process off are no faster than [`MOVE`].
    asked: f64,
    zero: bool,
    /// True while a move heads for a place to stop at.
    seeks: bool,
    /// How often moves to one place have missed it.
    missed: u32,
    /// Periods that nothing has moved in although it should.
    still: u64,
    last: Played,
}

/// Greatest pace of moves with the process off: at this pace a law at its limits leaves half of its accelerations and more
/// of its jerks, so that a stop at a place always has room.
const MOVE: f64 = 0.6;
/// Overrides below it hold.
const LEAST: f64 = 0.001;
/// How long nothing may move that should, s: the search for a course pauses for a few periods at most.
const PATIENCE: f64 = 0.1;
/// Moves to one place, each at half the pace of the one before.
const MOVES: u32 = 6;

impl<'a, L: Timed + ?Sized> Run<'a, L> {
    /// A run of `pace` from where it stands, waiting for [`Order::Resume`] or [`Order::Step`]. Steps end at `places`
    /// (mm, those on the path count). A pace that stands inside the path goes back by the overlap first: with
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
            stepping: false,
            left: 0,
            welded: last.rates.tip.s,
            asked: 1.0,
            zero: false,
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

    /// What is played in the period last played, `before` s before its end.
    pub fn earlier(&self, before: f64) -> Played {
        self.pace.earlier(before)
    }

    /// Takes an order; it works from the next period on. Orders after the end, or while the end of the pass is being
    /// filled, have no effect; after an abort only its completion follows.
    ///
    /// # Errors
    /// An override that is not allowed; going on at an override of 0. Then everything goes on as before.
    pub fn order(&mut self, order: Order) -> Result<(), PaceError> {
        match order {
            Order::Override(value) if (0.0..LEAST).contains(&value) => {
                self.zero = true;
                self.stop_for(Then::Wait);
                return Ok(());
            }
            Order::Override(value) => {
                self.pace.command(Command::Override(value))?;
                (self.asked, self.zero) = (value, false);
                if self.phase == RunPhase::Move {
                    self.calm();
                }
                return Ok(());
            }
            Order::Resume | Order::Step if self.zero => return Err(PaceError::Zero),
            Order::Hold => self.stop_for(Then::Wait),
            Order::Reverse => self.stop_for(Then::Back),
            Order::Abort => self.stop_for(Then::End),
            Order::Resume => self.go(false)?,
            Order::Step => self.go(true)?,
        }
        Ok(())
    }

    /// True if no order can change what comes any more.
    fn closed(&self) -> bool {
        self.phase == RunPhase::Ended || self.then == Then::End
    }

    /// Stops, if anything moves, and does `then` when the torch rests with the process off.
    fn stop_for(&mut self, then: Then) {
        if self.closed() {
            return;
        }
        self.then = then;
        match self.phase {
            RunPhase::Travel => {
                self.stopping = true;
                self.halt();
            }
            RunPhase::Move => self.halt(),
            RunPhase::Preflow => self.rest(RunPhase::Postflow),
            RunPhase::TravelDelay => self.rest(RunPhase::Crater),
            RunPhase::Held => self.off_at_rest(),
            RunPhase::RunOut | RunPhase::Crater | RunPhase::Postflow | RunPhase::Ended => {}
        }
    }

    fn go(&mut self, step: bool) -> Result<(), PaceError> {
        if self.closed() {
            return Ok(());
        }
        match self.phase {
            // Still welding: it only has to go on.
            RunPhase::Travel => {
                self.then = Then::Wait;
                self.travel(step)?;
            }
            RunPhase::Preflow | RunPhase::TravelDelay => self.stepping = step,
            RunPhase::Move => {
                self.then = Then::Start { step };
                self.halt();
            }
            RunPhase::Held => {
                self.then = Then::Start { step };
                self.off_at_rest();
            }
            RunPhase::RunOut | RunPhase::Crater | RunPhase::Postflow => self.then = Then::Start { step },
            RunPhase::Ended => {}
        }
        Ok(())
    }

    /// Travels with the process on, to the end or to the next place.
    fn travel(&mut self, step: bool) -> Result<(), PaceError> {
        self.pace.command(Command::Override(self.asked))?;
        self.phase = RunPhase::Travel;
        self.stopping = false;
        self.stepping = step;
        let here = self.last.rates.tip.s.max(self.welded);
        match self.next_place(here).filter(|_| step) {
            Some(place) => self.pace.command(Command::StopAt(place)),
            None => self.pace.command(Command::Resume),
        }
    }

    fn next_place(&self, here: f64) -> Option<f64> {
        self.places.iter().copied().find(|s| *s > here + 1e-9 && *s < self.pace.length())
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
    /// [`PaceError::Stuck`] if the motion cannot go on: then the process goes off as at a hold, and the run waits, held.
    /// Never with a law that is planned for the limits of the pace.
    pub fn step(&mut self) -> Result<Instant, PaceError> {
        let before = self.last.phi;
        self.last = self.pace.step();
        self.watch()?;
        match self.phase {
            RunPhase::Held | RunPhase::Ended => {}
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
        Ok(Instant { phase: self.phase, played: self.last })
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

    /// A move cannot stop at its place any more: it stops where it can and comes again, slower, a few times.
    fn miss(&mut self) -> Result<(), PaceError> {
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
            } else if self.stepping && !self.stopping && self.pace.stop().is_none() {
                // The place was too near: the one after.
                if let Some(place) = self.next_place(s + 1e-6) {
                    self.pace.command(Command::StopAt(place)).ok();
                }
            }
        }
    }

    /// Goes through phases at rest that are over.
    fn pass_over(&mut self) -> Result<(), PaceError> {
        while self.left == 0 {
            match self.phase {
                RunPhase::Preflow => self.rest(RunPhase::TravelDelay),
                RunPhase::TravelDelay => return self.travel(self.stepping),
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
            Then::Start { step } => {
                let place = self.restart_place();
                self.calm();
                self.pace.command(Command::StopAt(place)).ok();
                if (s - place).abs() <= 1e-9 || self.pace.at_rest() {
                    (self.then, self.missed) = (Then::Wait, 0);
                    self.halt();
                    self.stepping = step;
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
