//! Search for a course, in each period in which the override is not the wanted one.

use super::{BOLDEST, FeedOverride, Stop};
use crate::feed_override::course::{Course, Return, Segment, State};
use crate::feed_override::limit_check::Breach;
use crate::feed_override::timed_motion::{Pacing, Rates, Timed};

/// Maximum number of courses tried in a period; if none holds, the previous one continues.
const ATTEMPTS: usize = 10;
/// Periods until the next search if no course held.
const PAUSE: u32 = 2;
/// Ratio of available to minimum stopping time above which a stop is not considered yet.
const FAR: f64 = 3.0;
/// Overrides closer than this are equal.
const NEAR: f64 = 1e-15;
/// Distance in profile time within which a border counts as passed, s.
const BEYOND: f64 = 1e-9;
/// Maximum time to wait for a border, s.
const LONGEST_DELAY: f64 = 0.2;
/// Number of durations of a hop that are tried, each twice the previous one.
const HOPS: u32 = 12;

impl<L: Timed + ?Sized> FeedOverride<'_, L> {
    pub(super) fn decide(&mut self, now: State, goal: f64) {
        if self.stop.is_some_and(|s| s.begun) {
            return;
        }
        let place = self.stop.map(|s| s.theta);
        let follows = self.follows(now, goal);
        if place.is_none() && (follows || self.pause > 0) {
            self.pause = self.pause.saturating_sub(1);
            return;
        }
        let rates = self.profile().at(now.theta, now.feed_override.phi < 0.0);
        let strength = self.shield.strength(&rates);
        let (mut part, mut delay) = (1.0, 0.0);
        for _ in 0..ATTEMPTS {
            let home = Return { delay, d2: strength * self.boldness };
            let Some(course) = self.candidate(now, goal, &rates, home, part) else { break };
            let checked = self.check(&course, place);
            match checked {
                Ok(course) => {
                    self.follow(course);
                    self.boldness = (self.boldness * 1.25).min(BOLDEST);
                    return;
                }
                // The profile's own jerk leaves no room for the return: it waits until the jerk jumps.
                Err(breach) if breach.jerk && breach.segment > 0 && delay <= 0.0 => {
                    delay = self.delay(&course, breach.t);
                }
                Err(breach) if breach.jerk && breach.segment > 0 => {
                    self.boldness = (self.boldness * 0.6).max(1e-3);
                    (part, delay) = (part * 0.8, 0.0);
                }
                // Near the start of a profile its rates grow within the period: slightly less may hold.
                Err(_) => part *= if part > 0.6 { 0.8 } else { 0.4 },
            }
        }
        // No course holds now: the search pauses.
        self.pause = PAUSE;
        if let Some(place) = place {
            self.wait_or_stop(place);
        }
    }

    /// Delay after its first period that takes a course past the border after its time `t`, s.
    fn delay(&self, course: &Course, t: f64) -> f64 {
        let at = course.at(t);
        let forward = at.feed_override.phi > 0.0;
        // Skips a border at the current time.
        let past = at.theta + if forward { BEYOND } else { -BEYOND };
        let border = self.profile().next_border(past, forward);
        let wait = t - self.period + (border - at.theta) / at.feed_override.phi;
        // For an unreasonable delay a smaller step is tried instead.
        if wait.is_finite() && wait > 0.0 && wait < LONGEST_DELAY { wait + 0.5 * self.period } else { self.period }
    }

    /// True if the followed course already ends at the goal, and a new one would hardly be quicker.
    fn follows(&self, now: State, goal: f64) -> bool {
        let ends = (self.course.steady - goal).abs() <= 0.0;
        let left = self.course.duration() - self.elapsed;
        let rates = self.profile().at(now.theta, now.feed_override.phi < 0.0);
        ends && left <= now.feed_override.d1.abs() / (self.shield.strength(&rates) * self.boldness) + 2.0 * self.period
    }

    /// Builds the course that approaches the goal for one period, as fast as the axes allow here (or `part` of that).
    /// It then returns to steady by `home`, so that it does not end beyond the goal.
    fn candidate(&self, now: State, goal: f64, rates: &Rates, home: Return, part: f64) -> Option<Course> {
        let Return { delay, d2: back } = home;
        let (period, Pacing { phi, d1, .. }) = (self.period, now.feed_override);
        // Computes the d1 at the end of the period that leads exactly to the goal.
        let way = goal - phi - 0.5 * period * d1;
        let straight = 0.5 * period + delay;
        let root = (straight * straight + 2.0 * way.abs() / back).sqrt() - straight;
        let exact = (back * root).copysign(way);
        let next = self.profile().at(now.theta + phi * period, phi > 0.0);
        let steepest = self.shield.accelerations(&next, phi + period * d1);
        let range = self.shield.jerks(rates, now.feed_override);
        let wanted = (exact - d1) / period;
        let d2 = wanted.clamp(range.0.min(0.0), range.1.max(0.0));
        let d2 = (d1 + d2 * period).clamp(steepest.0.min(0.0), steepest.1.max(0.0)) / period - d1 / period;
        let cut = (d2 - wanted).abs() > 1e-9 * back || part < 1.0;
        // Scaled from the immediate return to steady.
        let straight_home = -back.min(d1.abs() / period).copysign(d1);
        let d2 = if part < 1.0 { straight_home + part * (d2 - straight_home) } else { d2 };
        let course = Course::heading(now, Segment { d2, duration: period }, home, (!cut).then_some(goal));
        (course.steady.abs() <= 1.0 && self.better(&course, phi, goal)).then_some(course)
    }

    /// True if a course from the override `phi` ends nearer to the goal than the followed one, or as near and sooner.
    /// Courses that end beyond the goal are avoided: a hold does not reverse.
    fn better(&self, course: &Course, phi: f64, goal: f64) -> bool {
        let beyond = |end: f64| (end - goal) * (phi - goal) < 0.0;
        if beyond(course.steady) && !beyond(self.course.cruise()) {
            return false;
        }
        if self.stop.is_some() {
            return (course.steady - goal).abs() <= (self.course.cruise() - goal).abs() + NEAR;
        }
        let gained = (self.course.steady - goal).abs() - (course.steady - goal).abs();
        let sooner = course.duration() < self.course.duration() - self.elapsed;
        // The followed course may end nearer to the goal only because its return to steady is slow.
        let after = |course: &Course, t: f64| (course.at(t + self.period).feed_override.phi - goal).abs();
        let ahead = after(course, 0.0) < after(&self.course, self.elapsed) - NEAR;
        gained > NEAR || (gained > -NEAR && sooner) || ahead
    }

    /// Returns the course if it holds, with a stop at `place` added if that is near.
    fn check(&self, course: &Course, place: Option<f64>) -> Result<Course, Breach> {
        let mut course = course.clone();
        if let Some(place) = place {
            let end = course.end();
            let way = (place - end.theta) / end.feed_override.phi;
            if self.course.stop.is_some()
                || way <= FAR * self.shield.stop_time(end.feed_override.phi) + 4.0 * self.period
            {
                course = course.with_stop(place).ok_or(Breach { t: 0.0, segment: 0, jerk: false })?;
            }
        }
        self.shield.check(self.profile(), &course).map(|()| course)
    }

    /// Handles a stop at `place` that no quicker course can make: waits a period at a steady override if a stop is
    /// possible after that, else stops now. An unreachable stop is dropped.
    fn wait_or_stop(&mut self, place: f64) {
        if let Some(rest) = self.course.rest_before_stop(self.elapsed)
            && let Ok(course) = self.check(&rest.then_steady(self.period), Some(place))
        {
            self.follow(course);
        } else if self.course.stop.is_some() {
            self.stop = self.stop.map(|s| Stop { begun: true, ..s });
        } else if self.now().feed_override.phi.abs() > 0.0 {
            self.stop = None;
        } else {
            self.hop(place);
        }
    }

    /// Moves from rest to a stop so near that no steady override fits between, by the quickest valid hop.
    fn hop(&mut self, place: f64) {
        let here = self.now().theta;
        for doublings in 0..HOPS {
            let hop = Course::hop(here, place, self.period * f64::from(1 << doublings));
            if hop.peak() <= 1.0 && self.shield.check(self.profile(), &hop).is_ok() {
                self.follow(hop);
                self.stop = self.stop.map(|s| Stop { begun: true, ..s });
                return;
            }
        }
    }
}
