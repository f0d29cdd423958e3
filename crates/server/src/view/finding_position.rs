//! Axis positions at findings, also of a weld that could not be planned: the panel can then show a collision.

use super::clearance::near;
use crate::wire::NearView;
use seamwright_machine::{Joints, Machine, Surroundings, Target};
use seamwright_motion::WeldMotion;
use seamwright_motion::transfer::names_nearest;
use seamwright_program::{Finding, TorchPath};
use seamwright_project::load::Loaded;

/// Maximum number of findings evaluated on the machine: without a motion each needs some inverse solutions.
const MAX_PLACES: usize = 12;
/// Number of steps from the start of a pass to a position on it, so that the axes stay on one branch.
const STEPS: u32 = 12;
/// Maximum distance of pairs that are reported, mm.
const NEAR_MM: f64 = 60.0;

/// Finds the axis positions at findings.
pub(super) struct Standing<'a> {
    loaded: &'a Loaded,
    motion: Option<&'a WeldMotion>,
    around: Option<&'a Surroundings<'a>>,
    looked: usize,
}

impl<'a> Standing<'a> {
    pub(super) fn new(
        loaded: &'a Loaded,
        motion: Option<&'a WeldMotion>,
        around: Option<&'a Surroundings<'a>>,
    ) -> Self {
        Self { loaded, motion, around, looked: 0 }
    }

    /// Returns the axis positions at a finding (in the machine file's units; empty if unknown), and the nearest pair
    /// there.
    pub(super) fn at(&mut self, finding: &Finding) -> (Vec<f64>, Option<NearView>) {
        // Transfer moves are beside their passes.
        if finding.kind == "air" || self.looked >= MAX_PLACES {
            return (Vec::new(), None);
        }
        self.looked += 1;
        let Some(joints) = self.joints(finding) else { return (Vec::new(), None) };
        let axes = self.machine().axes.iter().zip(joints).map(|(axis, q)| axis.to_file(q)).collect();
        (axes, self.around.and_then(|around| near(around, &joints, NEAR_MM)))
    }

    fn machine(&self) -> &'a Machine {
        &self.loaded.machine
    }

    fn joints(&self, finding: &Finding) -> Option<Joints> {
        let index = finding.pass.checked_sub(1)?;
        let s = 0.5 * (finding.from_mm + finding.to_mm);
        if let Some(planned) = self.motion.and_then(|motion| motion.passes.get(index)) {
            return Some(planned.path.at(s.clamp(0.0, planned.path.length())));
        }
        self.loaded.welding.program.value.passes.get(index)?;
        let path = self.loaded.welding.path(index);
        let s = s.clamp(0.0, path.length());
        if let Some(joints) = path.axes(s) {
            return Some(joints);
        }
        let target = |s: f64| Target::new(path.pose(s), path.second(s));
        let mut near_q = self.machine().home();
        for step in 0..STEPS {
            if let Ok(found) = self.machine().inverse_near(target(s * f64::from(step) / f64::from(STEPS)), &near_q) {
                near_q = found.joints;
            }
        }
        let branches = self.machine().inverse(target(s), &near_q).ok()?;
        // A finding that names the nearest pair of a branch is about this branch.
        let collides =
            |q: &Joints| self.around.is_some_and(|around| names_nearest(&finding.message, around, q, NEAR_MM));
        let colliding = branches.iter().map(|found| found.joints).find(|q| collides(q));
        colliding.or_else(|| self.machine().inverse_near(target(s), &near_q).ok().map(|found| found.joints))
    }
}
