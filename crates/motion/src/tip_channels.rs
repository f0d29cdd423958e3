//! Limits of the torch tip as channels of a speed profile.

use arrayvec::ArrayVec;
use glam::DVec3;
use seamwright_machine::{Axis, AxisLimits, Joints, MAX_AXES, Machine};
use std::f64::consts::{FRAC_PI_4, FRAC_PI_8};

/// Number of directions in the plane of curvature of the tip's path; one more is across it.
const IN_PLANE: usize = 4;
pub(crate) const COUNT: usize = IN_PLANE + 1;
/// Maximum number of channels with limits: axes, then directions with limits of the tip.
pub const CHANNELS: usize = MAX_AXES + COUNT;
/// Limits of all axes of a machine, then of its tip if it has any.
pub type ChannelLimits = ArrayVec<AxisLimits, CHANNELS>;

/// Limits of the axes and the tip of `machine` for planning.
pub fn channel_limits(machine: &Machine) -> ChannelLimits {
    machine.axes.iter().map(Axis::limits).chain(TipChannels::limits(machine)).collect()
}

/// Value of a missing limit, beyond any machine, in mm and s.
const UNBOUNDED: f64 = 1e12;
/// Fraction of the jerk for the direction across; the other directions get the rest, so that the norm is 1.
const ACROSS: f64 = 0.25;

/// Writes the derivatives of all channels to `out`, from the positions and derivatives `d` of the axes of `machine`.
/// Returns those of the tip, which is the arc of a torch that is `drawn_back` (mm).
pub(crate) fn channel_derivatives(
    machine: &Machine,
    drawn_back: f64,
    d: &[Joints; 4],
    out: &mut [[f64; 3]],
) -> [DVec3; 3] {
    let (axes, tip) = out.split_at_mut(machine.axes.len());
    axes.iter_mut().enumerate().for_each(|(i, out)| *out = [d[1][i], d[2][i], d[3][i]]);
    let motion = machine.tip_derivatives(d, drawn_back);
    if !tip.is_empty() {
        TipChannels::derivatives(motion, tip);
    }
    motion
}

/// The tip's acceleration and jerk along directions in its own frame: tangent and normal, and across both.
///
/// Acceleration lies in the plane of tangent and normal, the jerk nearly so. Four directions there, at 22.5 degrees
/// and every 45 from it, each bounded by the limit times cos 22.5 degrees, make an octagon with corners on tangent
/// and normal. So neither acceleration nor jerk exceeds its limit in any direction; speeding up and turning alone may
/// use all of the acceleration, both at once at least 92 % of it, and 89 % of the jerk.
pub(crate) struct TipChannels;

impl TipChannels {
    /// The channels' limits; none if the machine has no limits of the tip.
    fn limits(machine: &Machine) -> Vec<AxisLimits> {
        let AxisLimits { speed, acceleration, jerk } = machine.tip;
        if machine.tip == AxisLimits::NONE {
            return Vec::new();
        }
        let octagon = FRAC_PI_8.cos();
        let inside = (1.0 - ACROSS * ACROSS).sqrt();
        let limit = |value: f64| value.min(UNBOUNDED);
        let in_plane = AxisLimits {
            speed: UNBOUNDED,
            acceleration: limit(octagon * acceleration),
            jerk: limit(octagon * inside * jerk),
        };
        let across = AxisLimits { speed: UNBOUNDED, acceleration: UNBOUNDED, jerk: limit(ACROSS * jerk) };
        vec![AxisLimits { speed: limit(octagon * speed), ..in_plane }, in_plane, in_plane, in_plane, across]
    }

    /// The channels' derivatives, from those of the tip by the same parameter.
    pub(crate) fn derivatives([d1, d2, d3]: [DVec3; 3], out: &mut [[f64; 3]]) {
        let tangent = d1.normalize_or_zero();
        let aside = |v: DVec3| v - v.dot(tangent) * tangent;
        // On a straight path the third derivative gives the direction of the coming turn.
        let turning = aside(d2).try_normalize().unwrap_or_else(|| aside(d3).normalize_or_zero());
        let across = tangent.cross(turning);
        for (k, out) in out.iter_mut().enumerate() {
            let angle = FRAC_PI_8 + k as f64 * FRAC_PI_4;
            let direction = if k < IN_PLANE { angle.cos() * tangent + angle.sin() * turning } else { across };
            *out = [d1, d2, d3].map(|d| direction.dot(d));
        }
    }
}
