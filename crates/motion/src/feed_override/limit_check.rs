use super::course::{Course, State};
use super::timed_motion::{Pacing, Rates, Timed};
use crate::tip_channels::{CHANNELS, ChannelLimits};
use seamwright_machine::AxisLimits;

/// Fraction of the machine's limits up to which a course is accepted at the samples. Profiles use slightly less; the
/// rest covers values between the samples.
const ACCEPTED: f64 = 0.9999;
/// Fraction of the limits that a new course uses: less than accepted, for rounding and changes within a period.
const AIMED: f64 = 0.9995;
/// Number of samples in the shortest time in which an axis can reach its maximum acceleration or speed from rest.
const PLACES: f64 = 16.0;
/// Newton steps for the time at which a border is crossed; the start value is good.
const CROSSING_STEPS: usize = 3;

/// Times closer than this are equal, s.
const BRIEF: f64 = 1e-10;

#[derive(Debug, Clone, Copy, Default)]
struct Seen {
    t: f64,
    a: [f64; CHANNELS],
    j: [f64; CHANNELS],
}

/// A smooth stretch: within a segment and between two borders of the profile.
#[derive(Debug, Clone)]
struct Piece {
    start: State,
    t: f64,
    /// Number of samples, and the last two of them.
    count: usize,
    seen: [Seen; 2],
}

impl Piece {
    fn new(start: State, t: f64) -> Self {
        Self { start, t, count: 0, seen: Default::default() }
    }

    fn add(&mut self, new: Seen) {
        self.seen = [self.seen[1], new];
        self.count += 1;
    }
}

/// First violation of a limit by a course.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Breach {
    /// Time from the start of the course, s.
    pub(crate) t: f64,
    pub(crate) segment: usize,
    /// True for the jerk, false for speed or acceleration.
    pub(crate) jerk: bool,
}

/// Checks that all axes stay within their limits along a course.
#[derive(Debug, Clone)]
pub(crate) struct Shield {
    pub(crate) limits: ChannelLimits,
    /// Time between samples, s.
    spacing: f64,
    /// Maximum first and second derivative of the override, if the axes do not limit them.
    most: (f64, f64),
}

pub(crate) type Interval = (f64, f64);

impl Shield {
    pub(crate) fn new(limits: ChannelLimits, period: f64) -> Self {
        let time = |l: &AxisLimits| {
            let of_jerk = if l.jerk.is_finite() { l.acceleration / l.jerk } else { f64::INFINITY };
            of_jerk.min(l.speed / l.acceleration)
        };
        let shortest = limits.iter().map(time).fold(f64::INFINITY, f64::min);
        let spacing = (shortest / PLACES).clamp(period / 8.0, 4.0 * period);
        // From rest to full override in sixteen periods if no axis limits it.
        Self { limits, spacing, most: (1.0 / (8.0 * period), 1.0 / (64.0 * period * period)) }
    }

    /// Checks a course until it is steady: at close samples, at both ends of its segments and on both sides of each
    /// border of the profile. A steady |phi| <= 1 is within the profile's own limits.
    pub(crate) fn check<L: Timed + ?Sized>(&self, profile: &L, course: &Course) -> Result<(), Breach> {
        let mut state = course.start;
        let mut t = 0.0;
        for (i, segment) in course.segments.iter().enumerate() {
            self.check_segment(profile, state, segment.d2, segment.duration).map_err(|b| Breach {
                t: t + b.t,
                segment: i,
                ..b
            })?;
            state = state.after(segment.duration, segment.d2);
            t += segment.duration;
        }
        Ok(())
    }

    fn check_segment<L: Timed + ?Sized>(
        &self,
        profile: &L,
        start: State,
        d2: f64,
        duration: f64,
    ) -> Result<(), Breach> {
        let step = duration / (duration / self.spacing).ceil().max(1.0);
        let first = start.after(0.0, d2);
        let mut piece = Piece::new(first, 0.0);
        self.see(profile, &mut piece, first, 0.0, false)?;
        let mut t = 0.0;
        while t < duration - BRIEF {
            let next = if t + 1.5 * step > duration { duration } else { t + step };
            let (mut now, then) = (start.after(t, d2), start.after(next, d2));
            while let Some((border, dt)) = self.crossing(profile, now, then, next - t) {
                t += dt;
                now = State { theta: border, ..now.after(dt, d2) };
                self.finish(profile, &mut piece, now, t)?;
                piece = Piece::new(now, t);
                self.see(profile, &mut piece, now, t, false)?;
            }
            if next < duration {
                self.see(profile, &mut piece, then, next, true)?;
            }
            t = next;
        }
        self.finish(profile, &mut piece, start.after(duration, d2), duration)
    }

    /// First border of the profile between two states `step` apart, and the time from the first state. If the motion
    /// reverses between them, the profile's acceleration and jerk are negligible, as they are multiplied by squares of
    /// the override.
    fn crossing<L: Timed + ?Sized>(&self, profile: &L, now: State, then: State, step: f64) -> Option<(f64, f64)> {
        let forward = then.theta > now.theta;
        let border = profile.next_border(now.theta, forward);
        let within = border.is_finite() && (border - then.theta).abs() > 0.0 && (border < then.theta) == forward;
        if !within || now.feed_override.phi * then.feed_override.phi < 0.0 {
            return None;
        }
        let mut dt = step * (border - now.theta) / (then.theta - now.theta);
        let mut at = now.after(dt, then.feed_override.d2);
        for _ in 0..CROSSING_STEPS {
            let to = dt + (border - at.theta) / at.feed_override.phi;
            // Newton's method is valid only between the two states.
            if !(to >= 0.0 && to <= step) {
                break;
            }
            dt = to;
            at = now.after(dt, then.feed_override.d2);
        }
        Some((border, dt))
    }

    /// Checks the last sample of a piece, and one between if it has only two.
    fn finish<L: Timed + ?Sized>(&self, profile: &L, piece: &mut Piece, end: State, t: f64) -> Result<(), Breach> {
        if piece.count == 1 && t - piece.t > BRIEF {
            let half = 0.5 * (t - piece.t);
            let middle = piece.start.after(half, piece.start.feed_override.d2);
            self.see(profile, piece, middle, piece.t + half, true)?;
        }
        self.see(profile, piece, end, t, true)
    }

    /// Checks one sample, as the end of the stretch before it (or the start of the next). Also bounds the values
    /// between it and the two previous samples of the same piece. A parabola exceeds the maximum of three samples by at
    /// most an eighth of its curvature times the square of their distance.
    fn see<L: Timed + ?Sized>(
        &self,
        profile: &L,
        piece: &mut Piece,
        state: State,
        t: f64,
        end: bool,
    ) -> Result<(), Breach> {
        let rates = profile.at(state.theta, end == (state.feed_override.phi > 0.0));
        let [t0, t1] = [piece.seen[0].t, piece.seen[1].t];
        let curved = piece.count >= 2 && t - t1 > BRIEF && t1 - t0 > BRIEF;
        let widest = (t - t1).max(t1 - t0);
        let eighth = 0.25 * widest * widest / (t - t0);
        let mut new = Seen { t, ..Seen::default() };
        for (i, l) in self.limits.iter().enumerate() {
            let (v, a, j) = state.feed_override.played(rates.v[i], rates.a[i], rates.j[i]);
            (new.a[i], new.j[i]) = (a, j);
            let between = |f0: f64, f1: f64, f2: f64| {
                if curved { eighth * ((f2 - f1) / (t - t1) - (f1 - f0) / (t1 - t0)).abs() } else { 0.0 }
            };
            let [p, q] = &piece.seen;
            let greatest = |f0: f64, f1: f64, f2: f64| {
                let all = if curved { f0.abs().max(f1.abs()).max(f2.abs()) } else { f2.abs() };
                all + between(f0, f1, f2)
            };
            let slow = v.abs() <= ACCEPTED * l.speed && greatest(p.a[i], q.a[i], a) <= ACCEPTED * l.acceleration;
            let smooth = greatest(p.j[i], q.j[i], j) <= ACCEPTED * l.jerk;
            if !(slow && smooth) {
                return Err(Breach { t, segment: 0, jerk: slow });
            }
        }
        piece.add(new);
        Ok(())
    }

    /// Range of second derivatives of the override that every axis' jerk allows at this instant (empty if the first is
    /// above the second).
    pub(crate) fn jerks(&self, rates: &Rates, feed_override: Pacing) -> Interval {
        let still = Pacing { d2: 0.0, ..feed_override };
        let mut range = (-self.most.1, self.most.1);
        for (i, l) in self.limits.iter().enumerate().filter(|(_, l)| l.jerk.is_finite()) {
            narrow(&mut range, still.played(rates.v[i], rates.a[i], rates.j[i]).2, rates.v[i], AIMED * l.jerk);
        }
        range
    }

    /// Range of first derivatives of the override that every axis' acceleration allows at the override `phi`.
    pub(crate) fn accelerations(&self, rates: &Rates, phi: f64) -> Interval {
        let mut range = (-self.most.0, self.most.0);
        for (i, l) in self.limits.iter().enumerate() {
            narrow(&mut range, rates.a[i] * phi * phi, rates.v[i], AIMED * l.acceleration);
        }
        range
    }

    /// Time of a stop from the override `phi` that the axes can make even at their maximum speeds, if the profile uses
    /// none of their accelerations, s.
    pub(crate) fn stop_time(&self, phi: f64) -> f64 {
        let of_axis = |l: &AxisLimits| {
            let v = phi.abs() * l.speed;
            2.0 * (v / l.jerk).sqrt() + v / l.acceleration
        };
        self.limits.iter().map(of_axis).fold(0.0, f64::max)
    }

    /// Second derivative of the override that every axis' jerk allows if the profile's own acceleration and jerk are
    /// zero.
    pub(crate) fn strength(&self, rates: &Rates) -> f64 {
        let of_axis = |(i, l): (usize, &AxisLimits)| AIMED * l.jerk / rates.v[i].abs();
        self.limits.iter().enumerate().map(of_axis).fold(self.most.1, f64::min)
    }
}

/// Narrows a range of x to |fixed + slope x| <= limit.
fn narrow(range: &mut Interval, fixed: f64, slope: f64, limit: f64) {
    if slope.abs() > 0.0 {
        let (a, b) = ((limit - fixed) / slope, (-limit - fixed) / slope);
        range.0 = range.0.max(a.min(b));
        range.1 = range.1.min(a.max(b));
    }
}
