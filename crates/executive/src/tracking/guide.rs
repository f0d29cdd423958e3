//! Tracking as the executive's guide.

use super::error::Error;
use super::live_head::HeadReport;
use super::pass_seams::{Correction, PassSeams};
use super::tracked_pass::{PassStart, TrackedPass};
use crate::executive::{Guide, Guided, Place, Planned, Seen, Tracked, Trouble};
use arrayvec::ArrayVec;
use seamwright_machine::{Joints, Machine, Surroundings};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::Role;
use seamwright_tracking::beam::{DeviationRecord, Replay};

/// Data for tracking beside the plan.
#[derive(Clone, Copy, Default)]
pub struct TrackingConditions<'a> {
    /// Stored deviations, which replace the view of a beam.
    pub replay: Option<&'a DeviationRecord>,
    /// Obstacles for the moves to see the start of a pass.
    pub around: Option<&'a Surroundings<'a>>,
}

/// Tracks the passes of a program: with leading sensors, the beam or stored deviations.
pub struct Tracking<'a> {
    machine: &'a Machine,
    seams: &'a [Option<PassSeams<'a>>],
    motion: &'a WeldMotion,
    conditions: TrackingConditions<'a>,
    passes: Vec<Option<TrackedPass<'a>>>,
    /// Current pass, counted from 0.
    now: Option<usize>,
}

impl<'a> Tracking<'a> {
    /// Creates the tracking of the passes that have `seams`; the program starts at `start`.
    ///
    /// # Errors
    /// A pass that tracking does not support.
    pub fn new(
        machine: &'a Machine,
        seams: &'a [Option<PassSeams<'a>>],
        motion: &'a WeldMotion,
        conditions: TrackingConditions<'a>,
        start: Place,
    ) -> Result<Self, Error> {
        let mut tracking = Self { machine, seams, motion, conditions, passes: Vec::new(), now: None };
        for i in 0..seams.len() {
            let from_mm = if start.pass == i + 1 { start.s_mm } else { 0.0 };
            tracking.passes.push(tracking.prepared(i, from_mm, conditions.replay)?);
        }
        Ok(tracking)
    }

    /// Prepares pass `i` to run from `from_mm` on.
    fn prepared(
        &self,
        i: usize,
        from_mm: f64,
        stored: Option<&DeviationRecord>,
    ) -> Result<Option<TrackedPass<'a>>, Error> {
        let Some((seams, planned)) = self.planned(i) else { return Ok(None) };
        let correction: Correction<'a> = seams.correction(self.machine, planned)?;
        let heads: ArrayVec<_, 2> = seams.heads(self.machine, planned, &correction, stored)?;
        let start = PassStart { machine: self.machine, planned, number: i + 1, from_mm };
        Ok(Some(TrackedPass::new(start, heads, correction, self.conditions.around)))
    }

    fn planned(&self, i: usize) -> Option<(&'a PassSeams<'a>, &'a PassMotion)> {
        Some((self.seams.get(i)?.as_ref()?, self.motion.passes.get(i)?))
    }

    /// Returns the latest deviations that earlier passes found of the seam of cosmetic pass `i`. Returns `None` for
    /// other passes, or if no record covers it.
    fn found_before(&self, i: usize) -> Option<DeviationRecord> {
        let pass = self.planned(i)?.0.pass();
        if pass.known_role() != Some(Role::Cosmetic) {
            return None;
        }
        let ends = [0.0, pass.length()].map(|s| pass.seam_s(s));
        let from = ends[0].min(ends[1]);
        let before = (0..i).rev().filter_map(|k| {
            let ((seams, _), tracked) = (self.planned(k)?, self.passes[k].as_ref()?);
            let same = seams.pass().copy == pass.copy;
            Some(seams.on_seam(&tracked.heads.first().filter(|_| same)?.found()?))
        });
        before.into_iter().find(|found| Replay::covers(found, from, pass.length()))
    }

    /// Returns the report of each head of pass `i`; empty for a pass that is not tracked or not started.
    #[must_use]
    pub fn reports(&self, i: usize) -> Vec<HeadReport> {
        let pass = self.passes.get(i).and_then(Option::as_ref);
        pass.filter(|pass| pass.used).map_or_else(Vec::new, TrackedPass::reports)
    }

    fn pass(&mut self) -> Option<&mut TrackedPass<'a>> {
        self.passes.get_mut(self.now?)?.as_mut()
    }
}

impl Guide for Tracking<'_> {
    fn begin(&mut self, pass: usize, from_mm: f64, welds: bool) -> bool {
        self.now = Some(pass).filter(|i| self.passes.get(*i).is_some_and(Option::is_some));
        let Some(tracked) = self.pass() else { return false };
        // A beam looks only where it may weld.
        if !welds && tracked.heads.iter().any(|head| head.look_s().is_some()) {
            self.now = None;
            return false;
        }
        let again = tracked.used;
        let stored = if self.conditions.replay.is_none() { self.found_before(pass) } else { None };
        if again || stored.is_some() {
            // Preparation succeeded before, so it succeeds again.
            if let Ok(anew) = self.prepared(pass, from_mm, stored.as_ref().or(self.conditions.replay)) {
                self.passes[pass] = anew;
            }
        }
        if let Some(tracked) = self.pass() {
            tracked.used = true;
        }
        true
    }

    fn look(&mut self, seen: &Seen<'_>, goes: bool) -> Option<Guided> {
        self.pass()?.look(seen, goes)
    }

    fn ready(&mut self) -> Result<(), Trouble> {
        self.pass().map_or(Ok(()), TrackedPass::ready)
    }

    fn follow(&mut self, seen: &Seen<'_>, planned: &Planned<'_>) -> Guided {
        match self.pass() {
            Some(pass) => pass.follow(seen, planned),
            // The executive does not ask: no pass has begun.
            None => Guided::as_planned(planned),
        }
    }

    fn settle(&mut self, _seen: &Seen<'_>, q: &Joints, goes: bool) -> Option<Guided> {
        self.pass()?.settle(q, goes)
    }

    fn tracked(&self) -> [Option<Tracked>; 2] {
        self.now.and_then(|i| self.passes.get(i)).and_then(Option::as_ref).map_or([None; 2], TrackedPass::tracked)
    }
}
