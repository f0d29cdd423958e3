//! Execution of guided passes within the cell's cycle.

use super::activity::Doing;
use super::alarm::{Alarm, Reaction};
use super::alarm_list::Place;
use super::clock::{REST_S, StopTimer};
use super::core::Executive;
use super::device_interface::Devices;
use super::guide::{Guide, Guided, Planned, Seen, Trouble};
use super::mode::{Event, Mode};
use super::port::Port;
use super::work::Work;

impl<'a, D: Devices, P: Port> Executive<'a, D, P> {
    /// Calls the guide, if it corrects the pass, with the current reports.
    fn ask<T>(&mut self, ask: impl FnOnce(&mut (dyn Guide + 'a), &Seen<'_>) -> T) -> Option<T> {
        self.guide.ask(self.clock.now(), &self.io, ask)
    }

    fn take_guided(&mut self, guided: &Guided) {
        self.io.set(&guided.q, &guided.v, &guided.a);
        self.guide.take(guided);
        self.heed(guided.trouble);
    }

    /// Runs the guide's search at the start of pass `pass`, if it corrects that; false if the program was aborted.
    pub(super) fn look(&mut self, work: &Work<'_>, pass: usize, from_mm: f64) -> bool {
        let welds = self.activity.welds;
        self.guide.begin(pass, from_mm, welds);
        // A failed search is repeated when the program resumes after the hold.
        let mut failed = false;
        while self.guide.corrects {
            let goes = self.goes();
            if failed && goes {
                failed = false;
                self.guide.begin(pass, from_mm, welds);
            }
            match self.ask(|guide, seen| guide.look(seen, goes).ok_or_else(|| guide.ready())) {
                Some(Ok(guided)) => {
                    if !self.cycle(work, &guided) {
                        return false;
                    }
                }
                Some(Err(Err(trouble))) => {
                    self.activity.doing.place = Place { pass: pass + 1, s_mm: from_mm };
                    self.heed(Some(trouble));
                    self.heed(None);
                    self.event(Event::Hold);
                    failed = true;
                }
                Some(Err(Ok(()))) | None => break,
            }
        }
        true
    }

    /// Returns the axes to the plan after a pass; false if the program was aborted.
    pub(super) fn settle(&mut self, work: &Work<'_>) -> bool {
        let q = self.guide.planned_q;
        loop {
            let goes = self.goes();
            let Some(Some(guided)) = self.ask(|guide, seen| guide.settle(seen, &q, goes)) else { break };
            if !self.cycle(work, &guided) {
                return false;
            }
        }
        self.guide.corrects = false;
        self.heed(None);
        true
    }

    /// Takes the corrected set-points of a planned cycle; `None` if the pass is not corrected.
    pub(super) fn follow(&mut self, planned: &Planned<'_>) -> Option<Guided> {
        let guided = self.ask(|guide, seen| guide.follow(seen, planned))?;
        self.guide.planned_q = *planned.q;
        self.take_guided(&guided);
        Some(guided)
    }

    fn goes(&self) -> bool {
        matches!(self.mode, Mode::DryRun | Mode::Weld)
    }

    /// Runs one cycle outside of the pass; false once the program is aborted and at rest.
    fn cycle(&mut self, work: &Work<'_>, guided: &Guided) -> bool {
        self.take_guided(guided);
        self.tick(Doing { seam: guided.seam, ..Doing::default() }, Some(work));
        // There is no path for reverse motion.
        (self.requests.halt, self.requests.reverse) = (false, false);
        self.drop_power_at_rest();
        let goes_on = self.goes() || self.mode == Mode::Hold || !self.io.orders.rests();
        self.io.power && goes_on
    }

    /// After a fault the axes keep their power until they are at rest, but not longer than [`REST_S`]. The gas
    /// post-flow is skipped.
    pub(super) fn drop_power_at_rest(&mut self) {
        if self.mode != Mode::Fault {
            self.activity.fault = StopTimer::default();
            return;
        }
        let elapsed_s = self.activity.fault.elapsed(self.now());
        if (self.io.orders.rests() || elapsed_s > REST_S) && !self.process.on() {
            self.io.power = false;
        }
    }

    /// Raises an alarm while the guide reports this trouble.
    pub(super) fn heed(&mut self, trouble: Option<Trouble>) {
        if trouble != self.guide.trouble {
            if let Some(old) = self.guide.trouble {
                self.clear(Alarm::Tracking, old.detail());
            }
            self.guide.trouble = trouble;
        }
        let welds = self.activity.welds;
        match trouble {
            Some(Trouble::Tell(detail)) => self.raise(Alarm::Tracking, detail, Reaction::Tell),
            // Without the process the stop is only a hold.
            Some(Trouble::Stop(detail)) if welds => self.raise(Alarm::Tracking, detail, Reaction::ProcessOff),
            Some(Trouble::Stop(detail)) => self.raise(Alarm::Tracking, detail, Reaction::Hold),
            None => {}
        }
    }
}
