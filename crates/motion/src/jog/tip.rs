use super::ramp::Ramp;
use super::state::{AxisState, State};
use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisLimits, Joints, Machine, Target};
use serde::{Deserialize, Serialize};

/// Frame of the directions of a tip jog.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum TipFrame {
    /// The work's.
    Work,
    /// The torch's: z along its axis from the torch to the work. On an arm x is that of the tool frame, as it lies
    /// across the torch ([`Machine::across`]). Else x lies across it as near to the work's x as possible (the work's y if
    /// the torch lies along x). y lies across both.
    Torch,
}

impl TipFrame {
    /// Transforms a vector of this frame, with the axes at `q`, to the work frame.
    pub fn to_work(self, machine: &Machine, q: &Joints, v: DVec3) -> DVec3 {
        if self == Self::Work {
            return v;
        }
        let z = machine.forward(q).direction;
        let across = |u: DVec3| (u - z * z.dot(u)).try_normalize();
        let near = if z.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
        let x = if machine.has_free_roll() { machine.across(q) } else { across(near).unwrap_or(DVec3::Z) };
        v.x * x + v.y * z.cross(x) + v.z * z
    }
}

/// Kind of a tip's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum TipMotion {
    /// The tip on a straight line, the torch's attitude kept as well as the machine can.
    Line,
    /// The torch turns about its tip, which rests.
    Turn,
}

/// The torch on a straight line of its tip, or on a turn about its tip, in the work frame. The positions are those of
/// the inverse, so the motion is exact; the speed along it is chosen period by period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TipLine {
    motion: TipMotion,
    start: Pose,
    /// Direction across the torch at the start, where the rotation about the torch is free.
    across: Option<DVec3>,
    /// Direction of the line, or axis of the turn.
    along: DVec3,
    /// State along it: mm or rad, and s.
    at: AxisState,
}

/// Step of the differences for derivatives along the line, mm: rounding is then some 1e-9 of a mm per mm^2, and the
/// fourth derivative is negligible.
const APART_MM: f64 = 0.02;
/// The same for turns, rad: positions of axes in mm are rounded to 1e-13 mm.
const APART_RAD: f64 = 1e-3;
/// Maximum angle between the wanted and the reached direction of a turn, rad: beyond it the machine lacks axes for it.
const TURN_ERROR: f64 = 1e-7;

impl TipLine {
    pub(super) fn new(machine: &Machine, q: &Joints, motion: TipMotion, along: DVec3) -> Self {
        let across = machine.has_free_roll().then(|| machine.across(q));
        Self { motion, start: machine.forward(q), across, along, at: AxisState::default() }
    }

    /// Advances a period towards the speed `wanted` (mm/s or rad/s), within the limits of the axes at `now`. Returns the
    /// new state; none if the inverse has no solution, or if no axis moves along it.
    pub(super) fn next(
        &mut self,
        machine: &Machine,
        limits: &[AxisLimits],
        now: &State,
        wanted: f64,
        period: f64,
    ) -> Option<State> {
        let (first, second) = self.derivatives(machine, &now.q, self.at.q)?;
        let most = along_limits(limits, &first, &second);
        if !most.acceleration.is_finite() {
            return None;
        }
        let ramp = Ramp::new(&most, self.at, wanted.min(most.speed));
        self.at = ramp.at(period);
        let AxisState { q: s, speed: v, acceleration: a } = self.at;
        let q = self.inverse(machine, &now.q, s)?;
        let (first, second) = self.derivatives(machine, &q, s)?;
        let mut state = State::at_rest(&q);
        for i in 0..limits.len() {
            state.speed[i] = first[i] * v;
            state.acceleration[i] = first[i] * a + second[i] * v * v;
        }
        Some(state)
    }

    /// The torch at `s` along the motion.
    fn target(&self, s: f64) -> Target {
        let (pose, across) = match self.motion {
            TipMotion::Line => (Pose { point: self.start.point + s * self.along, ..self.start }, self.across),
            TipMotion::Turn => {
                let turn = DQuat::from_axis_angle(self.along, s);
                let pose = Pose { direction: turn * self.start.direction, ..self.start };
                (pose, self.across.map(|across| turn * across))
            }
        };
        Target { across, ..Target::from(pose) }
    }

    fn inverse(&self, machine: &Machine, near: &Joints, s: f64) -> Option<Joints> {
        let solution = machine.inverse_near(self.target(s), near).ok()?;
        (self.motion == TipMotion::Line || solution.attitude_error < TURN_ERROR).then_some(solution.joints)
    }

    fn derivatives(&self, machine: &Machine, near: &Joints, s: f64) -> Option<(Joints, Joints)> {
        let h = match self.motion {
            TipMotion::Line => APART_MM,
            TipMotion::Turn => APART_RAD,
        };
        let [a, b, c] = [s - h, s, s + h].map(|s| self.inverse(machine, near, s));
        let (a, b, c) = (a?, b?, c?);
        let first = std::array::from_fn(|i| (c[i] - a[i]) / (2.0 * h));
        let second = std::array::from_fn(|i| (c[i] - 2.0 * b[i] + a[i]) / (h * h));
        Some((first, second))
    }
}

/// Limits of the tip along a line or turn from those of the axes: half of their acceleration and jerk for its own changes of
/// speed, a quarter of the acceleration for the curvature of the axes' path.
fn along_limits(limits: &[AxisLimits], first: &Joints, second: &Joints) -> AxisLimits {
    let mut most = AxisLimits::NONE;
    for (limits, (d, dd)) in limits.iter().zip(first.iter().zip(second)) {
        most.speed = most.speed.min(0.9 * limits.speed / d.abs()).min((0.25 * limits.acceleration / dd.abs()).sqrt());
        most.acceleration = most.acceleration.min(0.5 * limits.acceleration / d.abs());
        most.jerk = most.jerk.min(0.5 * limits.jerk / d.abs());
    }
    most
}

/// True if two velocities have the same direction within rounding. Uses the cross product, since small angles are
/// inaccurate.
pub(super) fn same_way(a: DVec3, b: DVec3) -> bool {
    a.dot(b) > 0.0 && a.cross(b).length() <= 1e-9 * a.length() * b.length()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scaled_velocity_goes_the_same_way_and_a_turned_one_does_not() {
        for k in 0..100_000 {
            let random = |n: f64| (f64::from(k) * 0.731 + n * 2.17).sin();
            let v = 100.0 * DVec3::new(random(1.0), random(2.0), random(3.0));
            let scale = 10f64.powf(3.0 * random(4.0));
            assert!(same_way(v, scale * v) && !same_way(v, -scale * v) && !same_way(v, DVec3::ZERO), "{v}");
            assert!(!same_way(v, v + 1e-7 * v.length() * v.any_orthonormal_vector()), "{v}");
        }
    }
}
