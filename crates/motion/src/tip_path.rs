use crate::joint_path::{JointPath, JointPoint};
use crate::pass_motion::PassMotion;
use glam::DVec3;
use seamwright_machine::{Joints, Machine};
use seamwright_program::PathRange;

/// Path of the first torch as planned for the axes: that along the seam, or the bead beside it, except in blends at
/// corners. `s` is the station on the seam; beside it and in blends the tip's travel by `s` differs from 1.
#[derive(Debug, Clone, Copy)]
pub struct TipPath<'a> {
    machine: &'a Machine,
    joints: &'a JointPath,
}

impl PassMotion {
    /// The path of the torch of `machine`, whose motion this is.
    pub fn tip_path<'a>(&'a self, machine: &'a Machine) -> TipPath<'a> {
        TipPath { machine, joints: &self.path }
    }
}

impl TipPath<'_> {
    /// Travel by `s` of the line along which look-ahead distance and lag are measured: 1, or that of the tip with a
    /// weave.
    pub fn tip_rate(&self, s: f64) -> f64 {
        if self.joints.is_woven() { self.tip(s).1.length() } else { 1.0 }
    }

    fn tip(&self, s: f64) -> (DVec3, DVec3) {
        let JointPoint { q, d1, .. } = self.joints.point(s, false);
        let rest = Joints::default();
        (self.machine.forward(&q).point, self.machine.tip_derivatives(&[q, d1, rest, rest], 0.0)[0])
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        self.joints.length()
    }

    /// The `s` in the range `within` at which the tip is nearest to `point`, which must lie near the path at `guess`.
    /// Makes three Newton steps.
    pub fn foot(&self, point: DVec3, guess: f64, within: PathRange) -> f64 {
        (0..3).fold(guess, |s, _| {
            let (tip, d1) = self.tip(s);
            // A tip at rest cannot come nearer.
            if d1.length_squared() == 0.0 {
                return s;
            }
            (s + (point - tip).dot(d1) / d1.length_squared()).clamp(within.from_mm, within.to_mm)
        })
    }
}
