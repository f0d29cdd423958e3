use super::random::Random;
use crate::axis::AxisKind;
use crate::chain::Joints;
use crate::machine::Machine;
use serde::Serialize;

const POSES: u32 = 500;
/// Steps of the differences, mm and rad: a compromise between their curvature and rounding.
const STEP: (f64, f64) = (1e-2, 1e-4);
const LIMIT: f64 = 1e-6;

/// Comparison of the Jacobian with central differences of the forward kinematics.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct JacobianCheck {
    /// Positions compared.
    pub poses: u32,
    /// Worst relative difference of a column.
    pub relative: f64,
    /// Axis of the worst column.
    pub axis: String,
    /// True if all columns agree.
    pub passed: bool,
}

pub(super) fn check(machine: &Machine, seed: u64) -> JacobianCheck {
    let mut random = Random::new(seed, 3);
    let mut found = JacobianCheck { poses: POSES, ..JacobianCheck::default() };
    for _ in 0..POSES {
        let q = random.joints(machine);
        let columns = machine.jacobian(&q);
        for (i, axis) in machine.axes.iter().enumerate() {
            let h = if axis.kind == AxisKind::Linear { STEP.0 } else { STEP.1 };
            let at = |value: f64| {
                let mut q: Joints = q;
                q[i] = value;
                machine.forward(&q)
            };
            let (before, after) = (at(q[i] - h), at(q[i] + h));
            let width = (q[i] + h) - (q[i] - h);
            let point = ((after.point - before.point) / width - columns[i].0).length();
            let direction = ((after.direction - before.direction) / width - columns[i].1).length();
            // A zero or small column is compared with 1 mm per mm, or 1 mm per rad.
            let off = (point / columns[i].0.length().max(1.0)).max(direction);
            if off.is_nan() || off > found.relative {
                found.relative = if off.is_nan() { f64::INFINITY } else { off };
                found.axis.clone_from(&axis.name);
            }
        }
    }
    found.passed = found.relative <= LIMIT;
    found
}
