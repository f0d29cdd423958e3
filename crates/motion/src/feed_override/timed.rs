use super::error::FeedOverrideError;
use crate::limit_kind::LimitKind;
use crate::pass_channels::limits;
pub use crate::speed_profile::Limits as AxisLimits;
use crate::tip_channels::{self, TipChannels};
use arrayvec::ArrayVec;
use seamwright_machine::{Joints, MAX_AXES, Machine};

/// A motion in time that can be played with a feed override.
///
/// From rest to rest: at 0 and at `duration` every speed and acceleration is zero, and so are they outside.
pub trait Timed {
    /// Time from rest to rest, s.
    fn duration(&self) -> f64;
    /// Positions and rates at time `t` (s); at a jump of the jerk, those of the side before or after.
    fn at(&self, t: f64, before: bool) -> Rates;
    /// First time after `t` (or last one before it, if not `forward`) at which the jerk (or the acceleration, if jerk
    /// is not limited) may jump. Positive (negative) infinity without such a time.
    fn next_border(&self, t: f64, forward: bool) -> f64;
    /// The time at which path length `s` (mm) is reached, as exact as doubles allow.
    fn time_of(&self, s: f64) -> f64;
}

/// Maximum number of channels with limits: axes, then directions with limits of the tip.
pub const CHANNELS: usize = MAX_AXES + tip_channels::COUNT;

/// Position, speed, acceleration and jerk at one instant: of the channels (mm or rad per s, s^2, s^3) and along the
/// path.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rates {
    /// Positions of the axes.
    pub q: Joints,
    /// Their speeds, then those of the tip's own channels.
    pub v: [f64; CHANNELS],
    /// Their accelerations.
    pub a: [f64; CHANNELS],
    /// Their jerks.
    pub j: [f64; CHANNELS],
    /// The same along the path.
    pub tip: Tip,
}

/// Path length and its rates, mm per s, s^2, s^3.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tip {
    /// Path length, mm.
    pub s: f64,
    /// Speed.
    pub v: f64,
    /// Acceleration.
    pub a: f64,
    /// Jerk.
    pub j: f64,
}

/// Override and its derivatives by time, 1, 1/s and 1/s^2.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Pacing {
    pub(crate) phi: f64,
    pub(crate) d1: f64,
    pub(crate) d2: f64,
}

impl Pacing {
    /// Speed, acceleration and jerk as played, from the profile's `v`, `a`, `j`: derivatives of L(theta(t)).
    pub(crate) fn played(self, v: f64, a: f64, j: f64) -> (f64, f64, f64) {
        let Self { phi, d1, d2 } = self;
        (v * phi, a * phi * phi + v * d1, j * phi * phi * phi + 3.0 * a * phi * d1 + v * d2)
    }
}

impl Rates {
    /// Rates of the first `channels` channels and of the tip at the override `feed_override`.
    pub(crate) fn paced(&self, channels: usize, feed_override: Pacing) -> Self {
        let mut out = *self;
        for i in 0..channels {
            (out.v[i], out.a[i], out.j[i]) = feed_override.played(self.v[i], self.a[i], self.j[i]);
        }
        (out.tip.v, out.tip.a, out.tip.j) = feed_override.played(self.tip.v, self.tip.a, self.tip.j);
        out
    }
}

/// Limits of all axes of a machine, then of its tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits(pub(crate) ArrayVec<AxisLimits, CHANNELS>);

impl Limits {
    /// Limits of the axes and the tip of `machine`, as used in planning.
    pub fn of(machine: &Machine) -> Self {
        let all = machine.axes.iter().map(limits).chain(TipChannels::limits(machine));
        Self(all.collect())
    }

    /// Limits of the axes in the machine's order.
    ///
    /// # Errors
    /// More axes than a machine may have; speed or acceleration that is not finite and positive; jerk that is not
    /// positive.
    pub fn new(axes: &[AxisLimits]) -> Result<Self, FeedOverrideError> {
        if axes.len() > MAX_AXES {
            return Err(FeedOverrideError::TooManyAxes { axes: axes.len(), most: MAX_AXES });
        }
        let mut limits = ArrayVec::new();
        for (axis, l) in axes.iter().enumerate() {
            for (kind, value) in
                [(LimitKind::Speed, l.speed), (LimitKind::Acceleration, l.acceleration), (LimitKind::Jerk, l.jerk)]
            {
                if value.is_nan() || value <= 0.0 || (value.is_infinite() && kind != LimitKind::Jerk) {
                    return Err(FeedOverrideError::Limit { axis, kind, value });
                }
            }
            limits.push(*l);
        }
        Ok(Self(limits))
    }
}
