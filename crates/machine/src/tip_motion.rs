//! Motion of the torch tip from that of the axes: derivatives up to the third.

use crate::axis::AxisKind;
use crate::chain::{Chain, Joints};
use crate::machine::Machine;
use glam::DVec3;

/// Coefficients of a power series, lowest power first.
type Series<T> = [T; 4];

impl Machine {
    /// First, second and third derivative of the point `ahead` (mm) of the first head's tip along its torch, in the work
    /// frame and by a parameter. They follow from positions (mm or rad) and the same derivatives of the indicated axes,
    /// with the slopes of pitch errors, but not their derivatives.
    pub fn tip_derivatives(&self, motion: &[Joints; 4], ahead: f64) -> [DVec3; 3] {
        let [q, d1, d2, d3] = motion;
        let start = self.true_positions(q);
        let axis = |i: usize| -> Series<f64> {
            let slope = self.axes[i].pitch_error.as_ref().map_or(1.0, |e| e.true_at(q[i]).1);
            [start[i], slope * d1[i], slope * d2[i] / 2.0, slope * d3[i] / 6.0]
        };
        let [_, c1, c2, c3] = tip(&self.heads[0].chain, ahead, axis);
        [c1, 2.0 * c2, 6.0 * c3]
    }
}

/// The point `ahead` of the tip as a power series, from those of the axes.
fn tip(chain: &Chain, ahead: f64, axis: impl Fn(usize) -> Series<f64>) -> Series<DVec3> {
    let mut p = [chain.zero.ahead(ahead).point, DVec3::ZERO, DVec3::ZERO, DVec3::ZERO];
    for screw in chain.screws.iter().rev() {
        let q = axis(screw.axis);
        match screw.kind {
            AxisKind::Linear => (0..4).for_each(|k| p[k] += q[k] * screw.direction),
            AxisKind::Rotary => {
                p[0] -= screw.at;
                let along = p.map(|p| screw.direction.dot(p) * screw.direction);
                let across: Series<DVec3> = std::array::from_fn(|k| p[k] - along[k]);
                let (sin, cos) = sin_cos(&q);
                let turned = across.map(|a| screw.direction.cross(a));
                p = std::array::from_fn(|k| {
                    (0..=k).fold(along[k], |sum, j| sum + cos[j] * across[k - j] + sin[j] * turned[k - j])
                });
                p[0] += screw.at;
            }
        }
    }
    p
}

/// Sine and cosine of a power series, by `sin' = cos q'` and `cos' = -sin q'`.
fn sin_cos(q: &Series<f64>) -> (Series<f64>, Series<f64>) {
    let (mut sin, mut cos) = ([0.0; 4], [0.0; 4]);
    (sin[0], cos[0]) = q[0].sin_cos();
    for k in 1..4 {
        for j in 1..=k {
            let slope = j as f64 * q[j] / k as f64;
            sin[k] += slope * cos[k - j];
            cos[k] -= slope * sin[k - j];
        }
    }
    (sin, cos)
}
