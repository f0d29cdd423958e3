use super::ramp::Ramp;
use super::state::{AxisState, State};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisLimits, Joints, Machine};
use serde::{Deserialize, Serialize};

/// Frame of the directions of a tip jog.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum TipFrame {
    /// The work's.
    Work,
    /// The torch's: z along its axis from the torch to the work, x across it as near to the work's x as possible (the
    /// work's y if the torch lies along x), y across both.
    Torch,
}

impl TipFrame {
    /// Transforms a vector of this frame to the work frame.
    pub fn to_work(self, pose: &Pose, v: DVec3) -> DVec3 {
        if self == Self::Work {
            return v;
        }
        let z = pose.direction;
        let across = |u: DVec3| (u - z * z.dot(u)).try_normalize();
        let near = if z.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
        let x = across(near).unwrap_or(DVec3::Z);
        v.x * x + v.y * z.cross(x) + v.z * z
    }
}

/// The torch tip on a straight line in the work frame, its direction kept as well as the machine can. The positions are
/// those of the inverse, so the line is exact; the speed along it is chosen period by period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TipLine {
    start: Pose,
    along: DVec3,
    /// State along it: mm and s.
    at: AxisState,
}

/// Step of the differences for derivatives along the line, mm: rounding is then some 1e-9 of a mm per mm^2, and the
/// fourth derivative is negligible.
const APART_MM: f64 = 0.02;

impl TipLine {
    pub(super) fn new(machine: &Machine, q: &Joints, along: DVec3) -> Self {
        Self { start: machine.forward(q), along, at: AxisState::default() }
    }

    /// Advances a period towards the speed `wanted` (mm/s), within the limits of the axes at `now`. Returns the new
    /// state; none if the inverse has no solution.
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

    fn inverse(&self, machine: &Machine, near: &Joints, s: f64) -> Option<Joints> {
        let pose = Pose { point: self.start.point + s * self.along, direction: self.start.direction };
        machine.inverse_near(pose, near).ok().map(|solution| solution.joints)
    }

    fn derivatives(&self, machine: &Machine, near: &Joints, s: f64) -> Option<(Joints, Joints)> {
        let h = APART_MM;
        let [a, b, c] = [s - h, s, s + h].map(|s| self.inverse(machine, near, s));
        let (a, b, c) = (a?, b?, c?);
        let first = std::array::from_fn(|i| (c[i] - a[i]) / (2.0 * h));
        let second = std::array::from_fn(|i| (c[i] - 2.0 * b[i] + a[i]) / (h * h));
        Some((first, second))
    }
}

/// Limits of the tip along a line from those of the axes: half of their acceleration and jerk for its own changes of
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
