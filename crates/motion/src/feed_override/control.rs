mod search;

use super::Command;
use super::course::{Course, Return, Segment, State};
use super::error::FeedOverrideError;
use super::limit_check::Shield;
use super::timed_motion::{Pacing, Rates, Timed};
use crate::tip_channels::ChannelLimits;

const MAX_OVERRIDE: f64 = 1.5;
/// Maximum use of the axes' limits by a course on its return to a steady override, since the speed profile may change
/// meanwhile.
const BOLDEST: f64 = 0.98;
/// Rounding of the override, for example at a change of the speed profile.
const ROUNDING: f64 = 1e-12;

/// State of the played motion at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Played {
    /// Profile time, s.
    pub theta: f64,
    /// Actual override: profile time per real time; negative in reverse.
    pub phi: f64,
    /// True while the faster profile is played.
    pub faster: bool,
    /// Positions and rates of axes and tip as played.
    pub rates: Rates,
}

/// Plays a speed profile with a feed override that changes as fast as the axes allow.
///
/// The profile L(theta) is exact on the path, and so is L(theta(t)). At a steady override phi in [-1, 1] every
/// symmetric limit holds, because it holds for L. Each period tries the second derivative of phi that approaches the
/// wanted override fastest, followed by a return to a steady override. The whole course is checked against the limits
/// of all axes. If it holds it is followed, else smaller derivatives are tried, else the last valid course continues:
/// the next period always has a valid course. (A safety filter with a backup, as in predictive control; the return to
/// steady is the backup.)
///
/// Guarantee: every played course was checked at close samples and on both sides of the profile's borders, against
/// 0.9999 of the limits. A period never allocates, and does not search while the override is the wanted one.
#[derive(Debug)]
pub struct FeedOverride<'a, L: Timed + ?Sized> {
    base: &'a L,
    /// The profile for a higher speed, and the factor of speed.
    faster: Option<(&'a L, f64)>,
    on_faster: bool,
    shield: Shield,
    period: f64,
    course: Course,
    /// Played time of the course, s.
    elapsed: f64,
    /// Wanted override, and its sign or 0: forward, backward or hold.
    wanted: f64,
    sense: f64,
    /// Requested stop, if any.
    stop: Option<Stop>,
    /// Strength of the return to steady, as a fraction of the axes' current limits: adapted from the courses that held.
    boldness: f64,
    /// Periods to wait before the next search for a better course.
    pause: u32,
}

#[derive(Debug, Clone, Copy)]
struct Stop {
    s: f64,
    /// Profile time of the stop, s.
    theta: f64,
    /// True once the stop has begun; the course is then final.
    begun: bool,
}

impl<'a, L: Timed + ?Sized> FeedOverride<'a, L> {
    /// Plays `base` from its start, initially held. `period` (0.25 to 4 ms) is that of the set-points, s.
    ///
    /// # Errors
    /// A period outside that range.
    pub fn new(limits: &ChannelLimits, period: f64, base: &'a L) -> Result<Self, FeedOverrideError> {
        if !(0.00025..=0.004).contains(&period) {
            return Err(FeedOverrideError::Period { value: period });
        }
        Ok(Self {
            base,
            faster: None,
            on_faster: false,
            shield: Shield::new(limits.clone(), period),
            period,
            course: Course::steady(0.0, 0.0),
            elapsed: 0.0,
            wanted: 1.0,
            sense: 0.0,
            stop: None,
            boldness: BOLDEST,
            pause: 0,
        })
    }

    /// Adds a profile of the same path planned for `factor` (more than 1, up to 1.5) times the requested speeds:
    /// overrides up to `factor` are then possible.
    ///
    /// # Errors
    /// A factor outside that range.
    pub fn with_faster(mut self, profile: &'a L, factor: f64) -> Result<Self, FeedOverrideError> {
        if !(factor > 1.0 && factor <= MAX_OVERRIDE) {
            return Err(FeedOverrideError::Faster { value: factor });
        }
        self.faster = Some((profile, factor));
        Ok(self)
    }

    /// Starts at path length `s` (mm), at rest, instead of the start of the path: to continue after an abort.
    ///
    /// # Errors
    /// A path length outside the path.
    pub fn from_place(mut self, s: f64) -> Result<Self, FeedOverrideError> {
        let length = self.length();
        if !(0.0..=length).contains(&s) {
            return Err(FeedOverrideError::Place { value: s, length });
        }
        self.course = Course::steady(self.base.time_of(s), 0.0);
        Ok(self)
    }

    /// Length of the path, mm.
    pub fn length(&self) -> f64 {
        self.base.at(self.base.duration(), true).tip.s
    }

    /// Period of the set-points, s.
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Takes a command for the next period and later.
    ///
    /// # Errors
    /// An override that is not a number, below 0 or above the maximum of the profiles; a path length off the path. The
    /// state is then unchanged.
    pub fn command(&mut self, command: Command) -> Result<(), FeedOverrideError> {
        match command {
            Command::Override(value) => {
                let greatest = self.faster.map_or(1.0, |(_, factor)| factor);
                if !(0.0..=greatest).contains(&value) {
                    return Err(FeedOverrideError::Override { value, greatest });
                }
                self.wanted = value;
                return Ok(());
            }
            Command::StopAt(s) => {
                let length = self.length();
                if !(0.0..=length).contains(&s) {
                    return Err(FeedOverrideError::Place { value: s, length });
                }
                let (now, place) = (self.now(), self.profile().time_of(s));
                self.sense = if place < now.theta { -1.0 } else { 1.0 };
                let there = now.feed_override.phi.abs() <= 0.0 && (place - now.theta).abs() <= 1e-12;
                // The profile rests at both ends anyway.
                let inside = s > 0.0 && s < length;
                self.stop = (inside || there).then_some(Stop { s, theta: place, begun: there });
                return Ok(());
            }
            Command::Hold => self.sense = 0.0,
            Command::Resume => self.sense = 1.0,
            Command::Reverse => self.sense = -1.0,
        }
        self.stop = None;
        self.pause = 0;
        Ok(())
    }

    /// True if the motion rests and stays at rest without a command.
    pub fn at_rest(&self) -> bool {
        let now = self.now();
        let steady = (self.over() || self.elapsed >= self.course.duration()) && now.feed_override.phi.abs() <= 0.0;
        steady && (self.goal().abs() <= 0.0 || self.at_end_of(self.sense))
    }

    /// True if the followed course has reached an end of the profile.
    fn over(&self) -> bool {
        self.course.at(self.elapsed) != self.now()
    }

    fn at_end_of(&self, sense: f64) -> bool {
        let theta = self.now().theta;
        if sense > 0.0 { theta >= self.profile().duration() } else { theta <= 0.0 }
    }

    /// True if the end of the path is reached.
    pub fn at_end(&self) -> bool {
        self.now().theta >= self.profile().duration()
    }

    /// Path length of the requested stop, mm, and true if the motion already slows down for it. A stop that is too near
    /// is dropped.
    pub fn stop(&self) -> Option<(f64, bool)> {
        self.stop.map(|s| (s.s, s.begun))
    }

    fn profile(&self) -> &'a L {
        match self.faster {
            Some((profile, _)) if self.on_faster => profile,
            _ => self.base,
        }
    }

    fn now(&self) -> State {
        self.resting(self.course.at(self.elapsed))
    }

    /// Replaces a state at an end of the profile by rest there.
    fn resting(&self, state: State) -> State {
        let duration = self.profile().duration();
        let over = (state.theta >= duration && state.feed_override.phi > 0.0)
            || (state.theta <= 0.0 && state.feed_override.phi < 0.0);
        if over { State { theta: state.theta.clamp(0.0, duration), feed_override: Pacing::default() } } else { state }
    }

    fn goal(&self) -> f64 {
        let scale = self.faster.filter(|_| self.on_faster).map_or(1.0, |(_, factor)| factor);
        // Rest at a requested stop counts as a hold.
        let sense = if self.stop.is_some_and(|s| s.begun) { 0.0 } else { self.sense };
        sense * (self.wanted / scale).min(1.0)
    }

    /// Plays the next period. Returns the state at its end.
    pub fn step(&mut self) -> Played {
        self.change_profile();
        let mut now = self.now();
        let over = self.over();
        if over || (self.elapsed >= self.course.duration() && !self.course.segments.is_empty()) {
            self.follow(Course::steady(now.theta, now.feed_override.phi));
        }
        if over {
            self.stop = self.stop.map(|s| Stop { begun: true, ..s });
        }
        let goal = self.goal();
        // A difference to the goal of rounding size is removed: rest is exactly zero.
        let rounding = (now.feed_override.phi - goal).abs();
        if self.course.segments.is_empty() && rounding > 0.0 && rounding <= ROUNDING {
            now.feed_override.phi = goal;
            self.follow(Course::steady(now.theta, goal));
        }
        let settled = now.feed_override.d1.abs() <= 0.0 && (now.feed_override.phi - goal).abs() <= 0.0;
        let stopping = self.stop.is_some_and(|s| !s.begun);
        if (!settled || stopping || self.elapsed < self.course.duration())
            && !self.at_end_of(now.feed_override.phi + goal)
        {
            self.decide(now, goal);
        }
        self.elapsed += self.period;
        self.played(self.now())
    }

    /// State `before` s before the end of the last played period (0 to a period).
    pub fn earlier(&self, before: f64) -> Played {
        self.played(self.resting(self.course.at(self.elapsed - before)))
    }

    fn played(&self, state: State) -> Played {
        let profile = self.profile();
        let theta = state.theta.clamp(0.0, profile.duration());
        let rates = profile.at(theta, state.feed_override.phi > 0.0);
        let rates = rates.paced(self.shield.limits.len(), state.feed_override);
        Played { theta, phi: state.feed_override.phi, faster: self.on_faster, rates }
    }

    fn follow(&mut self, course: Course) {
        self.course = course;
        self.elapsed = 0.0;
    }

    /// Switches to the other profile if the override requires it and both allow the same path length, speed and
    /// acceleration.
    fn change_profile(&mut self) {
        let Some((faster, _)) = self.faster else { return };
        if self.on_faster == (self.wanted > 1.0) || self.stop.is_some() {
            return;
        }
        let now = self.now();
        let other = if self.on_faster { self.base } else { faster };
        let here = self.profile().at(now.theta, now.feed_override.phi < 0.0).tip;
        let theta = other.time_of(here.s);
        let there = other.at(theta, now.feed_override.phi < 0.0).tip;
        let (v, a, _) = now.feed_override.played(here.v, here.a, here.j);
        let still = now.feed_override.phi.abs() <= 0.0 && now.feed_override.d1.abs() <= 0.0;
        let mut phi = if still { 0.0 } else { v / there.v };
        if (1.0..1.0 + ROUNDING).contains(&phi.abs()) {
            phi = 1f64.copysign(phi);
        }
        let d1 = if still { 0.0 } else { (a - there.a * phi * phi) / there.v };
        if !(phi.abs() <= 1.0 && d1.is_finite()) {
            return;
        }
        let state = State { theta, feed_override: Pacing { phi, d1, d2: 0.0 } };
        let back = self.shield.strength(&other.at(theta, false)) * self.boldness;
        let at_once = Segment { d2: 0.0, duration: 0.0 };
        let course = Course::heading(state, at_once, Return { delay: 0.0, d2: back }, None);
        if course.steady.abs() <= 1.0 && self.shield.check(other, &course).is_ok() {
            self.on_faster = !self.on_faster;
            self.follow(course);
        }
    }
}
