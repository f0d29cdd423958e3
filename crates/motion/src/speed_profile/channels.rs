use super::error::SpeedProfileError;
use crate::limit_kind::LimitKind;
use seamwright_machine::AxisLimits;

/// Input of a speed profile: the motion of everything with limits by the path's parameter `u`.
///
/// A channel is an axis, or anything else whose speed, acceleration and jerk are bounded (a coordinate of the torch
/// tip, say). The [module](super) has an example.
///
/// # Contract
///
/// - Positions are twice continuously differentiable by `u` between [`Channels::stops`].
/// - The third derivative is bounded, and may jump at [`Channels::breaks`].
/// - A feature shorter than a thousandth of the path has breaks around it, as the pieces of a spline have them.
///   Otherwise it may be missed: between breaks derivatives are sampled at five points of every cell, and cells are a
///   sixtieth of the path or less.
pub trait Channels {
    /// Returns the first and the last parameter.
    fn range(&self) -> (f64, f64);

    /// Returns the limits of every channel: always the same number of channels, in the same order.
    fn limits(&self) -> &[AxisLimits];

    /// Writes the first, second and third derivative of every channel at `u` to `out`, in the order of
    /// [`Channels::limits`]. At a break they are those of the piece before it if `before`, else of the piece behind it.
    ///
    /// Returns the travel of the tip by `u`: mm per unit of the parameter.
    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64;

    /// Returns the requested speed of the tip at `u`, mm/s; smooth between breaks, and only evaluated inside them.
    /// Infinite without a request.
    ///
    /// If it or the tip's travel by `u` changes, the profile stays below it by a thousandth, and by at most four where
    /// no limit binds. Without limits of jerk it is enforced at the ends of cells only.
    fn asked(&self, u: f64) -> f64;

    /// Returns the parameters inside the range at which a third derivative or the requested speed may jump or bend,
    /// increasing.
    fn breaks(&self) -> Vec<f64>;

    /// Returns the breaks at which the requested speed bends, increasing. The profile follows a listed bend even if
    /// missing it costs little time.
    fn bends(&self) -> Vec<Bend> {
        Vec::new()
    }

    /// Returns the parameters inside the range at which the motion comes to rest: corners and cusps, increasing. They
    /// are breaks too.
    fn stops(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// A break at which the requested speed by the parameter changes its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// The parameter.
    pub at: f64,
    /// Approximate range of the parameter on either side over which the profile rounds the bend off.
    pub rounded_over: f64,
}

/// Parameters of the start, stops and end of `path`.
pub(crate) fn ends(path: &dyn Channels) -> Result<Vec<f64>, SpeedProfileError> {
    let (from, to) = path.range();
    if !(from.is_finite() && to.is_finite() && to > from) {
        return Err(SpeedProfileError::Range { from, to });
    }
    for (channel, l) in path.limits().iter().enumerate() {
        for (kind, value) in
            [(LimitKind::Speed, l.speed), (LimitKind::Acceleration, l.acceleration), (LimitKind::Jerk, l.jerk)]
        {
            if !(value > 0.0 && (value.is_finite() || kind == LimitKind::Jerk)) {
                return Err(SpeedProfileError::Limit { channel, kind, value });
            }
        }
    }
    let mut ends = vec![from];
    ends.extend(path.stops().into_iter().filter(|u| *u > from && *u < to));
    ends.push(to);
    Ok(ends)
}
