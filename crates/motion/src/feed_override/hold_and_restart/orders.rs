//! Effects of orders, by the current phase.

use super::{Goal, Run, Then};
use crate::feed_override::Command;
use crate::feed_override::error::FeedOverrideError;
use crate::feed_override::run_phase::{Order, RunPhase};
use crate::feed_override::timed_motion::Timed;
use seamwright_program::is_beyond;

/// Minimum override; below it the run holds.
const MIN_OVERRIDE: f64 = 0.001;

impl<L: Timed + ?Sized> Run<'_, L> {
    /// Takes an order for the next period and later. Orders after the end, or while the end crater is filled, have no
    /// effect; an abort is completed first.
    ///
    /// # Errors
    /// An override that is not allowed; resuming at an override of 0. The state is then unchanged.
    pub fn order(&mut self, order: Order) -> Result<(), FeedOverrideError> {
        match order {
            Order::Override(value) if (0.0..MIN_OVERRIDE).contains(&value) => {
                self.zero = true;
                self.stop_for(Then::Wait);
                return Ok(());
            }
            Order::Override(value) => {
                self.feed_override.command(Command::Override(value))?;
                (self.asked, self.zero) = (value, false);
                if self.phase == RunPhase::Move {
                    self.calm();
                }
                return Ok(());
            }
            Order::Resume | Order::Reverse | Order::Step | Order::StepTo(_) if self.zero => {
                return Err(FeedOverrideError::Zero);
            }
            Order::Hold => self.stop_for(Then::Wait),
            Order::Reverse => self.stop_for(Then::Back),
            Order::Abort => self.stop_for(Then::End),
            Order::Resume => self.go(Goal::End)?,
            Order::Step => self.go(Goal::NextPlace)?,
            Order::StepTo(s) => {
                let length = self.feed_override.length();
                if !is_beyond(s, self.welded) || is_beyond(s, length) {
                    return Err(FeedOverrideError::StepTo { value: s, welded: self.welded, length });
                }
                self.go(Goal::Place(s.min(length)))?;
            }
        }
        self.pass_over()
    }

    fn closed(&self) -> bool {
        self.phase == RunPhase::Ended || self.then == Then::End
    }

    /// Stops, if anything moves, and does `then` when the torch rests with the process off.
    pub(super) fn stop_for(&mut self, then: Then) {
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
            RunPhase::TravelDelay => self.rest(if self.burns { RunPhase::Crater } else { RunPhase::Postflow }),
            RunPhase::Held => self.off_at_rest(),
            RunPhase::RunOut | RunPhase::Crater | RunPhase::Postflow | RunPhase::Ended => {}
        }
    }

    fn go(&mut self, goal: Goal) -> Result<(), FeedOverrideError> {
        if self.closed() {
            return Ok(());
        }
        match self.phase {
            // Still welding: it only has to go on.
            RunPhase::Travel => {
                self.then = Then::Wait;
                self.travel(goal)?;
            }
            RunPhase::Preflow | RunPhase::TravelDelay => self.goal = goal,
            RunPhase::Move => {
                self.then = Then::Start(goal);
                self.halt();
            }
            RunPhase::Held => {
                self.then = Then::Start(goal);
                self.off_at_rest();
            }
            RunPhase::RunOut | RunPhase::Crater | RunPhase::Postflow => self.then = Then::Start(goal),
            RunPhase::Ended => {}
        }
        Ok(())
    }
}
