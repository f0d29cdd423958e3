use super::error::{AxisName, AxisValue, JogError, JogSetting};
use super::point_to_point::{Goal, PointToPoint};
use super::state::{AxisState, State};
use super::stop::{Commitment, Stop};
use super::tip::{TipFrame, TipLine, TipMotion, same_way};
use glam::DVec3;
use rsruckig::prelude::Synchronization;
use seamwright_machine::{CollisionMonitor, Joints, MAX_AXES, Machine, RangeViolation, Surroundings};
use serde::{Deserialize, Serialize};

/// Command of the operator; replaces the previous one.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Command {
    /// Come to rest by the fastest stop. Acknowledges a halt.
    Rest,
    /// Every axis at its speed (mm or rad per s, of either sign) up to the end of its range: keys or a joystick.
    Speeds(Joints),
    /// One axis by a distance (mm or rad, of either sign) from its target, or from its position of rest.
    Step { axis: usize, by: f64 },
    /// Synchronised point-to-point move of all axes.
    To(Joints),
    /// The tip of the first head's torch along a straight line at a velocity (mm/s) against the work, its direction
    /// kept.
    Tip { frame: TipFrame, velocity: DVec3 },
    /// The first head's torch turns about its resting tip at an angular velocity (rad/s) against the work.
    Turn { frame: TipFrame, velocity: DVec3 },
}

/// Input signals of a period.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signals {
    /// The enabling switch is held.
    pub enabled: bool,
    /// The stream of commands is alive: the panel has sent a message since the previous period.
    pub alive: bool,
    /// Feed hold: stop, and continue when this is false again.
    pub hold: bool,
}

/// Reason why the jog halted. It stays at rest until [`Command::Rest`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Halt {
    /// The enabling switch was released.
    NotEnabled,
    /// No sign of life from the panel for the time of [`JogSettings::silence_s`].
    Silent,
    /// Further motion would violate a watch, or cannot be proved to keep it: its index in the surroundings' scene.
    TooNear(usize),
    /// Further motion would exceed the speed, acceleration, jerk or range of this axis.
    Limit(usize),
    /// No motion to the target, or no axis positions for the tip's line, exist.
    NoMotion,
}

/// One set-point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JogPoint {
    /// Set positions, speeds and accelerations of the axes.
    pub state: State,
    /// Reason of a halt, if any.
    pub halt: Option<Halt>,
}

/// Fixed settings of a jog.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JogSettings {
    /// Period of the set-points, s.
    pub period_s: f64,
    /// The jog halts after this long without a sign of life, s: 0.1 is usual.
    pub silence_s: f64,
    /// Maximum number of distances computed for a watch in one period if the neighbourhood of the last one does not
    /// suffice: 16 is ample.
    pub looks: u32,
}

impl Default for JogSettings {
    fn default() -> Self {
        Self { period_s: 1e-3, silence_s: 0.1, looks: 16 }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    Rest,
    Speeds(Joints),
    To(Joints),
    Tip { motion: TipMotion, frame: TipFrame, velocity: DVec3, line: Option<TipLine> },
}

/// Jogging behind a safety shield.
///
/// Guarantee, if the start is at rest, in range and clear: every set-point, the straight move from the previous one to
/// it, and the fastest stop of every axis from it are within all ranges and clear of everything watched. Speeds,
/// accelerations and jerks are within their limits. A set-point without this proof is rejected; the stop from the last
/// one is then followed, in the same period. A released switch or a silent panel has the same effect: a stop needs no
/// computation. No step allocates (exceptions: distances of meshes, and if no motion is found) or reads a clock.
#[derive(Debug)]
pub struct Jog<'a> {
    machine: &'a Machine,
    monitor: Option<CollisionMonitor<'a>>,
    settings: JogSettings,
    plan: PointToPoint,
    /// Time since the start of the planned motion; none if planning is due.
    planned_for: Option<f64>,
    mode: Mode,
    override_share: f64,
    state: State,
    /// The verified stop, and the time it has been followed.
    stop: Stop,
    stopped_for: f64,
    silent_for: f64,
    halt: Option<Halt>,
}

impl<'a> Jog<'a> {
    /// Creates a jog at rest at positions `start`. Without surroundings no distances are watched.
    ///
    /// # Errors
    /// A start that is out of range or not clear; invalid settings.
    pub fn new(
        machine: &'a Machine,
        surroundings: Option<&'a Surroundings<'a>>,
        start: &Joints,
        settings: JogSettings,
    ) -> Result<Self, JogError> {
        let mut jog = Self::prepared(machine, surroundings, settings)?;
        check_positions(machine, start)?;
        if !jog.begin(start)
            && let Some(around) = surroundings
            && let Some((watch, found)) = around.nearest(start, around.greatest_least_mm() + 1.0)
        {
            let ((first, second), least_mm) = (around.bodies(watch), around.scene().watches()[watch].least_mm());
            return Err(JogError::NotClear { first, second, distance_mm: found.distance, least_mm });
        }
        Ok(jog)
    }

    /// Allocates all memory of a jog without a start position: call [`Jog::begin`] first.
    ///
    /// # Errors
    /// Invalid settings.
    pub fn prepared(
        machine: &'a Machine,
        surroundings: Option<&'a Surroundings<'a>>,
        settings: JogSettings,
    ) -> Result<Self, JogError> {
        for (what, value) in [(JogSetting::Period, settings.period_s), (JogSetting::Silence, settings.silence_s)] {
            if !(value > 0.0 && value <= 1.0) {
                return Err(JogError::Setting { what, value });
            }
        }
        let home = machine.home();
        let (plan, state) = (PointToPoint::new(machine), State::at_rest(&home));
        let stop = Stop::new(plan.limits(), &state);
        Ok(Self {
            machine,
            monitor: surroundings.map(|s| CollisionMonitor::new(s, &home)),
            settings,
            plan,
            planned_for: None,
            mode: Mode::Rest,
            override_share: 1.0,
            state,
            stop,
            stopped_for: 0.0,
            silent_for: 0.0,
            halt: None,
        })
    }

    /// Restarts at rest at positions `start`, without a command and with the full override. Returns false, with the jog
    /// unchanged, if they are out of range or not clear. No allocation, except on meshes.
    pub fn begin(&mut self, start: &Joints) -> bool {
        let stands = check_positions(self.machine, start).is_ok()
            && self.monitor.as_mut().is_none_or(|monitor| monitor.holds_at(start));
        if stands {
            self.state = State::at_rest(start);
            self.stop = Stop::new(self.plan.limits(), &self.state);
            (self.planned_for, self.mode, self.override_share, self.halt) = (None, Mode::Rest, 1.0, None);
            (self.stopped_for, self.silent_for) = (0.0, 0.0);
        }
        stands
    }

    /// The last set-point.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Reason of the current halt, until it is acknowledged.
    pub fn halt(&self) -> Option<Halt> {
        self.halt
    }

    /// Sets the override: the maximum used fraction of the axes' speeds, above 0 and up to 1. It multiplies commanded
    /// speeds.
    ///
    /// # Errors
    /// Other values; the override is then unchanged.
    pub fn set_override(&mut self, share: f64) -> Result<(), JogError> {
        if !(share > 0.0 && share <= 1.0) {
            return Err(JogError::Setting { what: JogSetting::Override, value: share });
        }
        if (share - self.override_share).abs() > 0.0 {
            (self.override_share, self.planned_for) = (share, None);
        }
        Ok(())
    }

    /// Replaces the command. Between two commands of the same kind the motion continues; a tip's line starts at rest.
    ///
    /// # Errors
    /// Values that are not finite, targets out of range, and commands other than [`Command::Rest`] after a halt; the
    /// previous command then stays. Refusing does not allocate.
    pub fn command(&mut self, command: &Command) -> Result<(), JogError> {
        let mode = match *command {
            Command::Rest => {
                self.halt = None;
                Mode::Rest
            }
            _ if self.halt.is_some() => return Err(JogError::Halted),
            Command::Speeds(speeds) => Mode::Speeds(self.checked_speeds(&speeds)?),
            Command::To(target) => {
                check_positions(self.machine, &target)?;
                Mode::To(target)
            }
            Command::Step { axis, by } => {
                let axes = self.machine.axes.len();
                if axis >= axes {
                    return Err(JogError::NoSuchAxis { axis, axes });
                }
                let mut target = if let Mode::To(target) = self.mode { target } else { self.stop.end() };
                target[axis] += by;
                check_positions(self.machine, &target)?;
                Mode::To(target)
            }
            Command::Tip { frame, velocity } => self.tip(TipMotion::Line, frame, velocity)?,
            Command::Turn { frame, velocity } => self.tip(TipMotion::Turn, frame, velocity)?,
        };
        if mode != self.mode {
            (self.mode, self.planned_for) = (mode, None);
        }
        Ok(())
    }

    fn checked_speeds(&self, speeds: &Joints) -> Result<Joints, JogError> {
        let mut checked = Joints::default();
        for (i, axis) in self.machine.axes.iter().enumerate() {
            if !speeds[i].is_finite() {
                return Err(JogError::NotFinite { what: AxisValue::Speed, axis: short(&axis.name) });
            }
            checked[i] = speeds[i].clamp(-axis.max_speed, axis.max_speed);
        }
        Ok(checked)
    }

    /// Mode of a tip jog: a line or turn continues if only its speed changes.
    fn tip(&self, motion: TipMotion, frame: TipFrame, velocity: DVec3) -> Result<Mode, JogError> {
        if !velocity.is_finite() {
            return Err(JogError::TipNotFinite);
        }
        let line = match self.mode {
            Mode::Tip { motion: m, frame: f, velocity: v, line }
                if (m, f) == (motion, frame) && same_way(v, velocity) =>
            {
                line
            }
            _ => None,
        };
        Ok(Mode::Tip { motion, frame, velocity, line })
    }

    /// Adds time without a step to the silence of the panel, s.
    pub fn add_silence(&mut self, time_s: f64) {
        self.silent_for += time_s;
    }

    /// Computes the next set-point, a period after the last.
    pub fn step(&mut self, signals: &Signals) -> JogPoint {
        self.silent_for = if signals.alive { 0.0 } else { self.silent_for + self.settings.period_s };
        let moves = self.mode != Mode::Rest;
        if moves && !signals.enabled {
            self.stop_for(Halt::NotEnabled);
        } else if moves && self.silent_for >= self.settings.silence_s {
            self.stop_for(Halt::Silent);
        }
        if signals.hold {
            self.planned_for = None;
            self.forget_line();
        }
        let next = if signals.hold { Ok(None) } else { self.candidate() };
        match next.and_then(|next| next.map(|next| self.verified(&next).map(|stop| (next, stop))).transpose()) {
            Ok(Some((state, stop))) => (self.state, self.stop, self.stopped_for) = (state, stop, 0.0),
            Ok(None) => self.follow_stop(),
            Err(halt) => {
                self.stop_for(halt);
                self.follow_stop();
            }
        }
        JogPoint { state: self.state, halt: self.halt }
    }

    fn stop_for(&mut self, halt: Halt) {
        (self.mode, self.planned_for) = (Mode::Rest, None);
        self.halt = self.halt.or(Some(halt));
    }

    fn follow_stop(&mut self) {
        self.stopped_for += self.settings.period_s;
        self.state = self.stop.at(self.stopped_for);
    }

    fn forget_line(&mut self) {
        if let Mode::Tip { line, .. } = &mut self.mode {
            *line = None;
        }
    }

    /// Candidate state of the command after a period; none for the stop.
    fn candidate(&mut self) -> Result<Option<State>, Halt> {
        match self.mode {
            Mode::Rest => Ok(None),
            Mode::Tip { .. } => self.on_line(),
            Mode::Speeds(_) | Mode::To(_) => {
                let time = match self.planned_for.filter(|t| *t < Goal::RENEW_S) {
                    Some(time) => time,
                    None => {
                        self.plan().map_err(|_| Halt::NoMotion)?;
                        0.0
                    }
                };
                let time = time + self.settings.period_s;
                self.planned_for = Some(time);
                Ok(Some(self.plan.at(time)))
            }
        }
    }

    fn plan(&mut self) -> Result<(), JogError> {
        let speeds = match self.mode {
            Mode::To(target) => return self.plan.plan(&self.state, &target, self.override_share),
            Mode::Speeds(speeds) => speeds,
            _ => Joints::default(),
        };
        let mut goals = [Goal::Speed(0.0); MAX_AXES];
        for (i, (limits, range)) in self.plan.limits().iter().zip(&self.plan.ranges).enumerate() {
            goals[i] = Goal::jog(limits, *range, self.state.q[i], self.override_share * speeds[i]);
        }
        self.plan.plan_goals(&self.state, &goals, Synchronization::None)
    }

    /// Candidate state on the tip's line or turn.
    fn on_line(&mut self) -> Result<Option<State>, Halt> {
        let Mode::Tip { motion, frame, velocity, line } = self.mode else { return Ok(None) };
        let speed = self.override_share * velocity.length();
        let mut line = match line {
            Some(line) => line,
            // A line starts at rest.
            None if speed <= 0.0 || !self.state.rests() => return Ok(None),
            None => {
                let along = frame.to_work(self.machine, &self.state.q, velocity).normalize_or_zero();
                TipLine::new(self.machine, &self.state.q, motion, along)
            }
        };
        let next = line.next(self.machine, self.plan.limits(), &self.state, speed, self.settings.period_s);
        self.mode = Mode::Tip { motion, frame, velocity, line: Some(line) };
        next.map(Some).ok_or(Halt::NoMotion)
    }

    fn verified(&mut self, next: &State) -> Result<Stop, Halt> {
        let period = self.settings.period_s;
        let stop = Stop::new(self.plan.limits(), next);
        for (i, (limits, range)) in self.plan.limits().iter().zip(&self.plan.ranges).enumerate() {
            let fits = follows(self.state.axis(i), next.axis(i), limits.jerk, period)
                && next.acceleration[i].abs() <= limits.acceleration * (1.0 + SLACK)
                && stop.ramps()[i].greatest_speed(0.0, stop.duration) <= limits.speed * (1.0 + SLACK);
            let (low, high) = stop.ramps()[i].reach();
            if !(fits && low >= range.0 && high <= range.1) {
                return Err(Halt::Limit(i));
            }
        }
        if let Some(monitor) = &mut self.monitor {
            let way = Commitment { before: &self.state.q, period, stop: &stop };
            let (low, high) = way.reach();
            monitor.prove(&way, &low, &high, self.settings.looks).map_err(Halt::TooNear)?;
        }
        Ok(stop)
    }
}

/// Relative tolerance of limits for rounding.
const SLACK: f64 = 1e-9;

/// True if `next` can follow `now` after a period within the jerk limit.
fn follows(now: AxisState, next: AxisState, jerk: f64, t: f64) -> bool {
    let a = now.acceleration;
    let (q, v) = (now.q + t * (now.speed + 0.5 * t * a), now.speed + t * a);
    let near = |x: f64, y: f64, share: f64, size: f64| {
        (x - y).abs() <= share * (1.0 + 1e-6) + 1e-12 * (size.abs() + now.q.abs())
    };
    near(next.acceleration, a, jerk * t, a)
        && near(next.speed, v, jerk * t * t / 2.0, v)
        && near(next.q, q, jerk * t.powi(3) / 6.0, q)
}

fn short(name: &str) -> AxisName {
    let mut short = AxisName::new();
    // The first character that does not fit ends it.
    let _ = name.chars().try_for_each(|c| short.try_push(c));
    short
}

fn check_positions(machine: &Machine, q: &Joints) -> Result<(), JogError> {
    if let Some(axis) = machine.axes.iter().zip(q).find(|(_, q)| !q.is_finite()).map(|(axis, _)| axis) {
        return Err(JogError::NotFinite { what: AxisValue::Position, axis: short(&axis.name) });
    }
    match machine.outside(q) {
        None => Ok(()),
        Some(RangeViolation { axis, value, .. }) => {
            let axis = &machine.axes[axis];
            let (low, high) = axis.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            let [value, low, high] = [value, low, high].map(|v| axis.to_file(v));
            Err(JogError::Range { axis: short(&axis.name), value, low, high, unit: axis.position_unit() })
        }
    }
}
