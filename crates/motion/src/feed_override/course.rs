use super::timed_motion::Pacing;
use arrayvec::ArrayVec;

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct State {
    /// Profile time, s.
    pub(crate) theta: f64,
    pub(crate) feed_override: Pacing,
}

impl State {
    pub(crate) fn after(&self, dt: f64, d2: f64) -> Self {
        let Pacing { phi, d1, .. } = self.feed_override;
        Self {
            theta: self.theta + dt * (phi + dt * (0.5 * d1 + dt * d2 / 6.0)),
            feed_override: Pacing { phi: phi + dt * (d1 + 0.5 * dt * d2), d1: d1 + dt * d2, d2 },
        }
    }
}

/// A time interval with constant second derivative of the override.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Segment {
    pub(crate) d2: f64,
    pub(crate) duration: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Return {
    /// Time before it, s.
    pub(crate) delay: f64,
    /// Its second derivative, of either sign.
    pub(crate) d2: f64,
}

/// Maximum number of segments of a course: one period, straight on, back to steady, a few periods steady, two of a
/// stop, and a spare one.
pub(crate) const SEGMENTS: usize = 8;

/// Rest of a segment below which it is rounding, s.
const BRIEF: f64 = 1e-12;

/// Course of the override from a state: a few segments, then steady. All times count from its start.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Course {
    pub(crate) start: State,
    pub(crate) segments: ArrayVec<Segment, SEGMENTS>,
    pub(crate) steady: f64,
    /// Number of segments before its final stop, and the profile time of that stop, if any.
    pub(crate) stop: Option<(usize, f64)>,
}

impl Course {
    pub(crate) fn steady(theta: f64, phi: f64) -> Self {
        let feed_override = Pacing { phi, ..Default::default() };
        Self { start: State { theta, feed_override }, segments: ArrayVec::new(), steady: phi, stop: None }
    }

    /// Builds a course with a `first` segment, straight on until the return `home`, then back to a steady override;
    /// steady at exactly `end` if it arrives there within rounding.
    pub(crate) fn heading(start: State, first: Segment, home: Return, end: Option<f64>) -> Self {
        let Return { delay, d2: back } = home;
        let mut segments = ArrayVec::new();
        let mut now = start;
        if first.duration > 0.0 {
            segments.push(first);
            now = start.after(first.duration, first.d2);
        }
        if delay > 0.0 {
            segments.push(Segment { d2: 0.0, duration: delay });
            now = now.after(delay, 0.0);
        }
        let rest = now.feed_override.d1.abs() / back;
        if rest > 0.0 {
            let d2 = -back.copysign(now.feed_override.d1);
            segments.push(Segment { d2, duration: rest });
            now = now.after(rest, d2);
        }
        Self { start, segments, steady: end.unwrap_or(now.feed_override.phi), stop: None }
    }

    /// Builds a course from rest at `from` to rest at `to` (profile times) in four segments of `quarter` s.
    pub(crate) fn hop(from: f64, to: f64, quarter: f64) -> Self {
        let d2 = (to - from) / (2.0 * quarter * quarter * quarter);
        let mut course = Self::steady(from, 0.0);
        course.segments.extend([(d2, 1.0), (-d2, 2.0), (d2, 1.0)].map(|(d2, n)| Segment { d2, duration: n * quarter }));
        course.stop = Some((0, to));
        course
    }

    /// Maximum absolute override of a hop: after its first half.
    pub(crate) fn peak(&self) -> f64 {
        self.segments.first().map_or(0.0, |s| (s.d2 * s.duration * s.duration).abs())
    }

    /// The steady override at its end, or before its stop.
    pub(crate) fn cruise(&self) -> f64 {
        let Some((first, _)) = self.stop else { return self.steady };
        self.segments[..first].iter().fold(self.start, |s, g| s.after(g.duration, g.d2)).feed_override.phi
    }

    /// Time until the override is steady, s.
    pub(crate) fn duration(&self) -> f64 {
        self.segments.iter().map(|s| s.duration).sum()
    }

    pub(crate) fn at(&self, t: f64) -> State {
        let mut state = self.start;
        let mut left = t;
        for s in &self.segments {
            if left < s.duration {
                return state.after(left, s.d2);
            }
            state = state.after(s.duration, s.d2);
            left -= s.duration;
        }
        self.settled(state).after(left, 0.0)
    }

    /// The state where the segments end, without their rounding.
    fn settled(&self, end: State) -> State {
        let theta = self.stop.map_or(end.theta, |(_, place)| place);
        State { theta, feed_override: Pacing { phi: self.steady, ..Default::default() } }
    }

    pub(crate) fn end(&self) -> State {
        let mut state = self.start;
        for s in &self.segments {
            state = state.after(s.duration, s.d2);
        }
        self.settled(state)
    }

    /// Remainder of the course at time `t` without its stop; none if the stop has begun.
    pub(crate) fn rest_before_stop(&self, t: f64) -> Option<Self> {
        let count = self.stop.map_or(self.segments.len(), |(first, _)| first);
        let mut left = Self { start: self.at(t), segments: ArrayVec::new(), steady: self.cruise(), stop: None };
        let mut passed = t;
        for s in &self.segments[..count] {
            if passed < s.duration - BRIEF {
                left.segments.push(Segment { d2: s.d2, duration: s.duration - passed });
            }
            passed = (passed - s.duration).max(0.0);
        }
        // Beyond the segments the course is steady, or the stop has begun.
        let begun = self.stop.is_some() && t > self.segments[..count].iter().map(|s| s.duration).sum::<f64>();
        (!begun).then_some(left)
    }

    pub(crate) fn then_steady(mut self, duration: f64) -> Self {
        self.segments.try_push(Segment { d2: 0.0, duration }).ok();
        self
    }

    /// Adds a stop exactly at the profile time `place`; none if that is behind. The override falls from steady phi to
    /// zero in two equal halves of opposite d2. This advances the profile by phi T / 2, so T follows from the remaining
    /// profile time.
    pub(crate) fn with_stop(mut self, place: f64) -> Option<Self> {
        let end = self.end();
        let duration = 2.0 * (place - end.theta) / end.feed_override.phi;
        if !(duration > 0.0 && duration.is_finite()) || self.segments.len() + 2 > SEGMENTS {
            return None;
        }
        let d2 = 4.0 * end.feed_override.phi / (duration * duration);
        self.stop = Some((self.segments.len(), place));
        self.segments.push(Segment { d2: -d2, duration: 0.5 * duration });
        self.segments.push(Segment { d2, duration: 0.5 * duration });
        self.steady = 0.0;
        Some(self)
    }
}
