//! Execution of guided passes within the cell's cycle.

use super::alarm_list::Place;
use super::bus::Devices;
use super::core::Doing;
use super::guide::{Guided, Planned, Seen, Trouble};
use super::mode::Event;
use super::shutdown::REST_S;
use super::state::Port;
use super::work::Work;
use super::{Alarm, Executive, Guide, Mode, Reaction};

impl<'a, D: Devices, P: Port> Executive<'a, D, P> {
    /// Calls the guide, if any, with the current reports.
    fn ask<T>(&mut self, ask: impl FnOnce(&mut (dyn Guide + 'a), &Seen<'_>) -> T) -> Option<T> {
        let t_s = self.now();
        let guide = self.guide.as_deref_mut().filter(|_| self.guided)?;
        Some(ask(guide, &Seen { t_s, reports: &self.reports, picture: self.devices.picture() }))
    }

    /// Takes the set-points of a guide.
    fn take_guided(&mut self, guided: &Guided) {
        self.set(&guided.q, &guided.v, &guided.a);
        self.guide_override = guided.feed_override;
        self.heed(guided.trouble);
    }

    /// Runs the guide's search at the start of pass `pass`, if it corrects that; false if the program was aborted.
    pub(super) fn look(&mut self, work: &Work<'_>, pass: usize, from_mm: f64) -> bool {
        let welds = self.welds;
        let begin = |guide: &mut (dyn Guide + 'a)| guide.begin(pass, from_mm, welds);
        self.guided = self.guide.as_deref_mut().is_some_and(begin);
        // A failed search is repeated when the program resumes after the hold.
        let mut failed = false;
        while self.guided {
            let goes = self.goes();
            if failed && goes {
                failed = false;
                self.guided = self.guide.as_deref_mut().is_some_and(begin);
            }
            match self.ask(|guide, seen| guide.look(seen, goes).ok_or_else(|| guide.ready())) {
                Some(Ok(guided)) => {
                    if !self.cycle(work, &guided) {
                        return false;
                    }
                }
                Some(Err(Err(trouble))) => {
                    self.doing.place = Place { pass: pass + 1, s_mm: from_mm };
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
        let q = self.planned_q;
        loop {
            let goes = self.goes();
            let Some(Some(guided)) = self.ask(|guide, seen| guide.settle(seen, &q, goes)) else { break };
            if !self.cycle(work, &guided) {
                return false;
            }
        }
        self.guided = false;
        self.heed(None);
        true
    }

    /// Takes the corrected set-points of a planned cycle; `None` if the pass is not corrected.
    pub(super) fn follow(&mut self, planned: &Planned<'_>) -> Option<Guided> {
        let guided = self.ask(|guide, seen| guide.follow(seen, planned))?;
        self.planned_q = *planned.q;
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
        (self.halt, self.reverse) = (false, false);
        self.drop_power_at_rest();
        let goes_on = self.goes() || self.mode == Mode::Hold || !self.rests();
        self.power && goes_on
    }

    /// Returns true if all set-points are at rest.
    pub(super) fn rests(&self) -> bool {
        /// Speed below which an axis is at rest, mm/s or rad/s. Corrected set-points come from an iteration, so that
        /// their differences are not exactly 0.
        const AT_REST: f64 = 1e-6;
        self.orders.set.iter().all(|set| set.velocity.abs() < AT_REST)
    }

    /// After a fault the axes keep their power until they are at rest, but not longer than [`REST_S`]. The gas
    /// post-flow is skipped.
    pub(super) fn drop_power_at_rest(&mut self) {
        if self.mode != Mode::Fault {
            self.fault_since = None;
            return;
        }
        let now = self.now();
        let since = *self.fault_since.get_or_insert(now);
        if (self.rests() || now - since > REST_S) && !self.process.on() {
            self.power = false;
        }
    }

    /// Raises an alarm while the guide reports this trouble.
    pub(super) fn heed(&mut self, trouble: Option<Trouble>) {
        if trouble != self.guide_trouble {
            if let Some(old) = self.guide_trouble {
                self.clear(Alarm::Tracking, old.detail());
            }
            self.guide_trouble = trouble;
        }
        match trouble {
            Some(Trouble::Tell(detail)) => self.raise(Alarm::Tracking, detail, Reaction::Tell),
            // Without the process the stop is only a hold.
            Some(Trouble::Stop(detail)) if self.welds => self.raise(Alarm::Tracking, detail, Reaction::ProcessOff),
            Some(Trouble::Stop(detail)) => self.raise(Alarm::Tracking, detail, Reaction::Hold),
            None => {}
        }
    }

    /// Returns the feed override to request: the operator's, or the guide's if that is lower.
    pub(super) fn allowed_override(&self, asked: f64) -> f64 {
        /// Minimum increase that is worth an order.
        const WORTH: f64 = 0.02;
        /// Minimum override taken from the guide: below it, its alarm stops the motion.
        const SLOWEST: f64 = 0.01;
        let guide = if self.guided { self.guide_override } else { 1.0 };
        if guide < SLOWEST {
            return asked;
        }
        let wanted = self.feed_override.min(guide);
        let whole = wanted >= self.feed_override;
        if wanted < asked || wanted > asked + WORTH || whole { wanted } else { asked }
    }
}
