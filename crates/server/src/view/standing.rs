//! How the machine stands where something is wrong, also in a weld that could not be planned: so that a collision can be seen.

use super::near::near;
use crate::wire::NearView;
use seamwright_machine::{Joints, Machine, Surroundings, Target};
use seamwright_motion::WeldMotion;
use seamwright_program::{Finding, TorchPath};
use seamwright_project::load::Loaded;

/// Maximum number of findings that are looked at on the machine: without a motion each costs some inverses.
const MAX_PLACES: usize = 12;
/// Steps from the start of a pass to a place on it, so that the axes stay on one branch.
const STEPS: u32 = 12;
/// Pairs farther apart are not near, mm.
const NEAR_MM: f64 = 60.0;

/// Finds how the machine stands at findings.
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

    /// Positions of the axes at a finding (in the machine file's units; empty if they are not known), and the nearest pair there.
    pub(super) fn at(&mut self, finding: &Finding) -> (Vec<f64>, Option<NearView>) {
        // Air moves are beside their passes.
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
        let target = |s: f64| Target { first: path.pose(s), second: path.second(s) };
        let mut near_q = self.machine().home();
        for step in 0..STEPS {
            if let Ok(found) = self.machine().inverse_near(target(s * f64::from(step) / f64::from(STEPS)), &near_q) {
                near_q = found.joints;
            }
        }
        let branches = self.machine().inverse(target(s), &near_q).ok()?;
        let collides = |q: &Joints| self.collides(q, &finding.message);
        let colliding = branches.iter().map(|found| found.joints).find(|q| collides(q));
        colliding.or_else(|| self.machine().inverse_near(target(s), &near_q).ok().map(|found| found.joints))
    }

    /// True if the finding is about the pair that is nearest at `q`: then the planner stood on this branch.
    fn collides(&self, q: &Joints, message: &str) -> bool {
        let pair = self.around.and_then(|around| near(around, q, NEAR_MM));
        pair.is_some_and(|pair| pair.between.iter().all(|name| message.contains(name.as_str())))
    }
}
