use super::error::SpeedProfileError;
use crate::LimitKind;

/// Input of a speed profile: the motion of everything with limits by the path's parameter `u`.
///
/// A channel is an axis, or anything else whose speed, acceleration and jerk are bounded (a coordinate of the torch
/// tip, say). Positions must be twice continuously differentiable by `u` between [`Channels::stops`] and have a
/// bounded third derivative, which may jump at [`Channels::breaks`]. Between breaks derivatives are sampled at five
/// points of every cell, and cells are a sixtieth of the path or less. A feature shorter than a thousandth of the path
/// needs breaks around it, as the pieces of a spline have them, or it may be missed.
pub trait Channels {
    /// First and last parameter.
    fn range(&self) -> (f64, f64);

    /// Limits of every channel, always the same number.
    fn limits(&self) -> &[Limits];

    /// First, second and third derivative of every channel at `u`, from the piece before it if `before`, into `out`;
    /// and the tip's speed by `u`, mm.
    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64;

    /// Requested speed of the tip at `u`, mm/s; smooth between breaks, and only evaluated inside them. Infinite without
    /// a request. If it or the tip's speed by `u` changes, the profile stays below it by a thousandth, and by at most
    /// four where no limit binds. Without limits of jerk it is enforced at the ends of cells only.
    fn asked(&self, u: f64) -> f64;

    /// Parameters inside the range at which a third derivative or the requested speed may jump or bend, increasing.
    fn breaks(&self) -> Vec<f64>;

    /// Breaks at which the requested speed bends, increasing. The profile follows a listed bend even if missing it
    /// costs little time.
    fn bends(&self) -> Vec<Bend> {
        Vec::new()
    }

    /// Parameters inside the range at which the motion comes to rest: corners and cusps, increasing. They are breaks
    /// too.
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

/// Symmetric limits of one channel, in its unit per s, s^2 and s^3. The jerk may be infinite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Highest speed.
    pub speed: f64,
    /// Highest acceleration.
    pub acceleration: f64,
    /// Highest jerk.
    pub jerk: f64,
}

/// Parameters of the start, stops and end of `path`.
///
/// # Errors
/// An invalid range or invalid limits.
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
