use crate::tip_channels::CHANNELS;
use seamwright_machine::Joints;

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
