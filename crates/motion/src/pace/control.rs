use super::course::{Course, State};
use super::shield::{Breach, Shield};
use super::timed::{Limits, Pacing, Rates, Timed};
use super::{Command, PaceError};

/// Greatest override.
const GREATEST: f64 = 1.5;
/// Courses tried in a period; if none holds, the one before goes on.
const ATTEMPTS: usize = 8;
/// Periods before looking again when none held.
const PAUSE: u32 = 2;
/// A stop that may take this much longer than the axes need at least is not looked at yet.
const FAR: f64 = 3.0;
/// Most of what the axes allow that a course uses on its way back to steady: laws change while it is under way.
const BOLDEST: f64 = 0.98;
/// Paces this near to each other are the same.
const NEAR: f64 = 1e-15;
/// A border this near in the law's time is passed, s.
const BEYOND: f64 = 1e-9;
/// Longest time to wait for a border, s.
const LONGEST_DELAY: f64 = 0.2;
/// Durations of a hop that are tried, each twice the one before.
const HOPS: u32 = 12;
/// Rounding of a pace, as when one law takes over from another.
const ROUNDING: f64 = 1e-12;

/// What is played at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Played {
    /// The law's own time, s.
    pub theta: f64,
    /// Pace: the law's time per time; negative while going back.
    pub phi: f64,
    /// True while the faster law is played.
    pub faster: bool,
    /// Positions and rates of axes and tip as played.
    pub rates: Rates,
}

/// A law played at a pace that changes as fast as the axes allow.
///
/// The law L(theta) is exact on the path, and so is L(theta(t)). At a steady pace phi in [-1, 1] every symmetric limit
/// holds for ever, because it holds for L. In each period the second derivative of phi that heads fastest for the wanted
/// pace is tried, followed by a way back to a steady pace; the whole course is checked against the limits of all axes.
/// If it holds it is followed, else smaller ones are tried, else the last one that held goes on: the next period always
/// has a course that holds. (A safety filter with a backup, as in
/// predictive control; the course back to steady is the backup.)
///
/// Guarantee: every course played was checked at places close together and on both sides of the law's borders, against
/// 0.9999 of the limits. A period costs no allocation, and no search while the pace is the wanted one.
#[derive(Debug)]
pub struct Pace<'a, L: Timed + ?Sized> {
    base: &'a L,
    /// The law for a greater speed and how many times greater it is.
    faster: Option<(&'a L, f64)>,
    on_faster: bool,
    shield: Shield,
    period: f64,
    course: Course,
    /// Time played of the course, s.
    elapsed: f64,
    /// Wanted override, and its sign or 0: forward, backward or hold.
    wanted: f64,
    sense: f64,
    /// Path length at which to stop, if asked to.
    stop: Option<Stop>,
    /// How strongly a course goes back to steady, as part of what the axes allow just now: learned from what held.
    boldness: f64,
    /// Periods to wait before looking for a better course again.
    pause: u32,
}

/// A place to stop at.
#[derive(Debug, Clone, Copy)]
struct Stop {
    s: f64,
    /// The law's time there, s.
    theta: f64,
    /// Nothing is decided any more: the stop has begun.
    begun: bool,
}

impl<'a, L: Timed + ?Sized> Pace<'a, L> {
    /// Plays `base` from its start, held until told otherwise. `period` (0.25 to 4 ms) is that of the set-points, s.
    ///
    /// # Errors
    /// A period outside that range.
    pub fn new(limits: &Limits, period: f64, base: &'a L) -> Result<Self, PaceError> {
        if !(0.00025..=0.004).contains(&period) {
            return Err(PaceError::Period { value: period });
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

    /// With a law for the same path planned for `factor` (more than 1, up to 1.5) times the asked speeds: overrides up to
    /// it can be played.
    ///
    /// # Errors
    /// A factor outside that range.
    pub fn with_faster(mut self, law: &'a L, factor: f64) -> Result<Self, PaceError> {
        if !(factor > 1.0 && factor <= GREATEST) {
            return Err(PaceError::Faster { value: factor });
        }
        self.faster = Some((law, factor));
        Ok(self)
    }

    /// Standing at path length `s` (mm) instead of the start: to go on after an abort.
    ///
    /// # Errors
    /// A path length outside the path.
    pub fn from_place(mut self, s: f64) -> Result<Self, PaceError> {
        let length = self.length();
        if !(0.0..=length).contains(&s) {
            return Err(PaceError::Place { value: s, length });
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

    /// Takes a command; it works from the next period on.
    ///
    /// # Errors
    /// An override that is not a number, below 0 or above what the laws allow; a place off the path. Then everything
    /// goes on as before.
    pub fn command(&mut self, command: Command) -> Result<(), PaceError> {
        match command {
            Command::Override(value) => {
                let greatest = self.faster.map_or(1.0, |(_, factor)| factor);
                if !(0.0..=greatest).contains(&value) {
                    return Err(PaceError::Override { value, greatest });
                }
                self.wanted = value;
                return Ok(());
            }
            Command::StopAt(s) => {
                let length = self.length();
                if !(0.0..=length).contains(&s) {
                    return Err(PaceError::Place { value: s, length });
                }
                let (now, place) = (self.now(), self.law().time_of(s));
                self.sense = if place < now.theta { -1.0 } else { 1.0 };
                let there = now.pace.phi.abs() <= 0.0 && (place - now.theta).abs() <= 1e-12;
                // At both ends the law rests by itself.
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

    /// True if nothing moves and nothing will without a command.
    pub fn at_rest(&self) -> bool {
        let now = self.now();
        let steady = (self.over() || self.elapsed >= self.course.duration()) && now.pace.phi.abs() <= 0.0;
        steady && (self.goal().abs() <= 0.0 || self.at_end_of(self.sense))
    }

    /// True if the course followed has run into an end of the law.
    fn over(&self) -> bool {
        self.course.at(self.elapsed) != self.now()
    }

    /// True if the law cannot be played any further in the direction of `sense`.
    fn at_end_of(&self, sense: f64) -> bool {
        let theta = self.now().theta;
        if sense > 0.0 { theta >= self.law().duration() } else { theta <= 0.0 }
    }

    /// True if the end of the path is reached.
    pub fn at_end(&self) -> bool {
        self.now().theta >= self.law().duration()
    }

    /// The place inside the path at which it will stop, mm, and whether it slows down for it already. A place that is
    /// too near to stop at is given up.
    pub fn stop(&self) -> Option<(f64, bool)> {
        self.stop.map(|s| (s.s, s.begun))
    }

    fn law(&self) -> &'a L {
        match self.faster {
            Some((law, _)) if self.on_faster => law,
            _ => self.base,
        }
    }

    fn now(&self) -> State {
        self.resting(self.course.at(self.elapsed))
    }

    /// The law rests at both ends, whatever its pace there.
    fn resting(&self, state: State) -> State {
        let duration = self.law().duration();
        let over = (state.theta >= duration && state.pace.phi > 0.0) || (state.theta <= 0.0 && state.pace.phi < 0.0);
        if over { State { theta: state.theta.clamp(0.0, duration), pace: Pacing::default() } } else { state }
    }

    /// The wanted pace on the law that is played.
    fn goal(&self) -> f64 {
        let scale = self.faster.filter(|_| self.on_faster).map_or(1.0, |(_, factor)| factor);
        // Standing at a place asked for counts as being held there.
        let sense = if self.stop.is_some_and(|s| s.begun) { 0.0 } else { self.sense };
        sense * (self.wanted / scale).min(1.0)
    }

    /// Plays the next period and says what is reached at its end.
    pub fn step(&mut self) -> Played {
        self.change_law();
        let mut now = self.now();
        let over = self.over();
        if over || (self.elapsed >= self.course.duration() && !self.course.segments.is_empty()) {
            self.follow(Course::steady(now.theta, now.pace.phi));
        }
        if over {
            self.stop = self.stop.map(|s| Stop { begun: true, ..s });
        }
        let goal = self.goal();
        // What is left to the goal may be rounding alone: standing still is zero exactly.
        let rounding = (now.pace.phi - goal).abs();
        if self.course.segments.is_empty() && rounding > 0.0 && rounding <= ROUNDING {
            now.pace.phi = goal;
            self.follow(Course::steady(now.theta, goal));
        }
        let settled = now.pace.d1.abs() <= 0.0 && (now.pace.phi - goal).abs() <= 0.0;
        let stopping = self.stop.is_some_and(|s| !s.begun);
        if (!settled || stopping || self.elapsed < self.course.duration()) && !self.at_end_of(now.pace.phi + goal) {
            self.decide(now, goal);
        }
        self.elapsed += self.period;
        self.played(self.now())
    }

    /// What is played `before` s before the end of the period last played (0 to a period).
    pub fn earlier(&self, before: f64) -> Played {
        self.played(self.resting(self.course.at(self.elapsed - before)))
    }

    fn played(&self, state: State) -> Played {
        let law = self.law();
        let theta = state.theta.clamp(0.0, law.duration());
        let rates = law.at(theta, state.pace.phi > 0.0);
        let rates = rates.paced(self.shield.limits.0.len(), state.pace);
        Played { theta, phi: state.pace.phi, faster: self.on_faster, rates }
    }

    /// Looks for a better course than the one that is followed.
    fn decide(&mut self, now: State, goal: f64) {
        if self.stop.is_some_and(|s| s.begun) {
            return;
        }
        let place = self.stop.map(|s| s.theta);
        let follows = self.follows(now, goal);
        if place.is_none() && (follows || self.pause > 0) {
            self.pause = self.pause.saturating_sub(1);
            return;
        }
        let rates = self.law().at(now.theta, now.pace.phi < 0.0);
        let strength = self.shield.strength(&rates);
        let (mut part, mut delay) = (1.0, 0.0);
        for _ in 0..ATTEMPTS {
            let back = strength * self.boldness;
            let Some(course) = self.candidate(now, goal, &rates, (delay, back), part) else { break };
            let checked = self.check(&course, place);
            match checked {
                Ok(course) => {
                    self.follow(course);
                    self.boldness = (self.boldness * 1.25).min(BOLDEST);
                    return;
                }
                // The law's own jerk leaves no room for the way back: that can wait until the jerk jumps.
                Err(breach) if breach.jerk && breach.segment > 0 && delay <= 0.0 => {
                    delay = self.delay(&course, breach.t);
                }
                Err(breach) if breach.jerk && breach.segment > 0 => {
                    self.boldness = (self.boldness * 0.6).max(1e-3);
                    (part, delay) = (part * 0.8, 0.0);
                }
                Err(_) => part *= 0.4,
            }
        }
        // Nothing holds just now: looks again a little later.
        self.pause = PAUSE;
        if let Some(place) = place {
            self.wait_or_stop(place);
        }
    }

    /// How long after its first period a course must go straight on to be past the border after its time `t`, s.
    fn delay(&self, course: &Course, t: f64) -> f64 {
        let at = course.at(t);
        let forward = at.pace.phi > 0.0;
        // A border that it is at already is not the next one.
        let past = at.theta + if forward { BEYOND } else { -BEYOND };
        let border = self.law().next_border(past, forward);
        let wait = t - self.period + (border - at.theta) / at.pace.phi;
        // Beyond all sense it is better to try less.
        if wait.is_finite() && wait > 0.0 && wait < LONGEST_DELAY { wait + 0.5 * self.period } else { self.period }
    }

    /// True if the course followed already ends at the goal, and heading there again would hardly be quicker.
    fn follows(&self, now: State, goal: f64) -> bool {
        let ends = (self.course.steady - goal).abs() <= 0.0;
        let left = self.course.duration() - self.elapsed;
        let rates = self.law().at(now.theta, now.pace.phi < 0.0);
        ends && left <= now.pace.d1.abs() / (self.shield.strength(&rates) * self.boldness) + 2.0 * self.period
    }

    /// The course that heads for the goal for one period, as fast as the axes allow here (or `part` of that), and then
    /// back to steady `home` (after a delay, and how strongly), so that it does not end beyond the goal.
    fn candidate(&self, now: State, goal: f64, rates: &Rates, home: (f64, f64), part: f64) -> Option<Course> {
        let (delay, back) = home;
        let (period, Pacing { phi, d1, .. }) = (self.period, now.pace);
        // Where d1 must be at the end of the period to come out at the goal exactly.
        let way = goal - phi - 0.5 * period * d1;
        let straight = 0.5 * period + delay;
        let root = (straight * straight + 2.0 * way.abs() / back).sqrt() - straight;
        let exact = (back * root).copysign(way);
        let next = self.law().at(now.theta + phi * period, phi > 0.0);
        let steepest = self.shield.accelerations(&next, phi + period * d1);
        let range = self.shield.jerks(rates, now.pace);
        let wanted = (exact - d1) / period;
        let d2 = wanted.clamp(range.0.min(0.0), range.1.max(0.0));
        let d2 = (d1 + d2 * period).clamp(steepest.0.min(0.0), steepest.1.max(0.0)) / period - d1 / period;
        let cut = (d2 - wanted).abs() > 1e-9 * back || part < 1.0;
        // A part of the way from going back to steady at once.
        let straight_home = -back.min(d1.abs() / period).copysign(d1);
        let d2 = if part < 1.0 { straight_home + part * (d2 - straight_home) } else { d2 };
        let course = Course::heading(now, d2, period, home, (!cut).then_some(goal));
        (course.steady.abs() <= 1.0 && self.better(&course, phi, goal)).then_some(course)
    }

    /// True if a course from pace `phi` comes out nearer to the goal than the one followed, or as near and sooner; not
    /// beyond the goal if that can be helped: a hold does not go back.
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
        gained > NEAR || (gained > -NEAR && sooner)
    }

    /// The course if it holds; with a stop at `place` added if that is not far.
    fn check(&self, course: &Course, place: Option<f64>) -> Result<Course, Breach> {
        let mut course = course.clone();
        if let Some(place) = place {
            let end = course.end();
            let way = (place - end.theta) / end.pace.phi;
            if self.course.stop.is_some() || way <= FAR * self.shield.stop_time(end.pace.phi) + 4.0 * self.period {
                course = course.with_stop(place).ok_or(Breach { t: 0.0, segment: 0, jerk: false })?;
            }
        }
        self.shield.check(self.law(), &course).map(|()| course)
    }

    /// No quicker course can stop at `place`: waits a period at a steady pace if it can stop after that, else stops now;
    /// a place that cannot be stopped at any more is given up.
    fn wait_or_stop(&mut self, place: f64) {
        if let Some(rest) = self.course.rest_before_stop(self.elapsed)
            && let Ok(course) = self.check(&rest.then_steady(self.period), Some(place))
        {
            self.follow(course);
        } else if self.course.stop.is_some() {
            self.stop = self.stop.map(|s| Stop { begun: true, ..s });
        } else if self.now().pace.phi.abs() > 0.0 {
            self.stop = None;
        } else {
            self.hop(place);
        }
    }

    /// From standing to a place so near that there is no steady pace between: up and down, as quickly as holds.
    fn hop(&mut self, place: f64) {
        let here = self.now().theta;
        for doublings in 0..HOPS {
            let hop = Course::hop(here, place, self.period * f64::from(1 << doublings));
            if hop.peak() <= 1.0 && self.shield.check(self.law(), &hop).is_ok() {
                self.follow(hop);
                self.stop = self.stop.map(|s| Stop { begun: true, ..s });
                return;
            }
        }
    }

    fn follow(&mut self, course: Course) {
        self.course = course;
        self.elapsed = 0.0;
    }

    /// Moves the state onto the other law if the override asks for it, where both can go on from it alike: same path
    /// length, speed and acceleration.
    fn change_law(&mut self) {
        let Some((faster, _)) = self.faster else { return };
        if self.on_faster == (self.wanted > 1.0) || self.stop.is_some() {
            return;
        }
        let now = self.now();
        let other = if self.on_faster { self.base } else { faster };
        let here = self.law().at(now.theta, now.pace.phi < 0.0).tip;
        let theta = other.time_of(here.s);
        let there = other.at(theta, now.pace.phi < 0.0).tip;
        let (v, a, _) = now.pace.played(here.v, here.a, here.j);
        let still = now.pace.phi.abs() <= 0.0 && now.pace.d1.abs() <= 0.0;
        let mut phi = if still { 0.0 } else { v / there.v };
        if (1.0..1.0 + ROUNDING).contains(&phi.abs()) {
            phi = 1f64.copysign(phi);
        }
        let d1 = if still { 0.0 } else { (a - there.a * phi * phi) / there.v };
        if !(phi.abs() <= 1.0 && d1.is_finite()) {
            return;
        }
        let state = State { theta, pace: Pacing { phi, d1, d2: 0.0 } };
        let back = self.shield.strength(&other.at(theta, false)) * self.boldness;
        let course = Course::heading(state, 0.0, 0.0, (0.0, back), None);
        if course.steady.abs() <= 1.0 && self.shield.check(other, &course).is_ok() {
            self.on_faster = !self.on_faster;
            self.follow(course);
        }
    }
}
