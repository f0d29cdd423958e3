//! A simulated operator who brings a cell into a situation, and checks of the result.

use super::case::{Case, Situation};
use super::outcome::Outcome;
use crate::devices::fault::{Device, FaultKind};
use seamwright_executive::{Alarm, Ask, Command, Cycle, Mode, Note, Place, Port, ProcessState, Reaction};
use seamwright_machine::{Axis, AxisLimits, Joints, Machine};
use seamwright_message::{Message, Unit};
use seamwright_motion::feed_override::RunPhase;
use seamwright_motion::jog;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Task of the operator.
pub(super) struct Orders {
    pub(super) case: Case,
    /// The fault comes at any moment of a weld, not soon.
    pub(super) anywhere: bool,
    /// Flag that starts the fault.
    pub(super) told: Arc<AtomicBool>,
    pub(super) seed: u64,
}

/// Observation time after the fault, s; and that of a sensor, whose loss the weld tolerates for a while.
const WATCHES_S: f64 = 2.5;
const WATCHES_TRACKED_S: f64 = 45.0;
/// Maximum time to reach a situation, s.
const REACHES_S: f64 = 60.0;
/// Maximum time from the end of a fault to powered axes, s.
const RECOVERS_S: f64 = 3.0;
/// Range of the fault's delay with `anywhere`, cycles.
const ANYWHERE: u64 = 20_000;
/// Cycles from an alarm to the first decelerating set-point.
const REACTS: f64 = 3.0;
/// Maximum stop distance relative to the shortest one: the speed profile must be able to return to a constant feed
/// override at any moment.
const CAREFUL: f64 = 2.0;
/// Path length after which a dry run or a weld counts as under way, mm.
const UNDER_WAY_MM: f64 = 3.0;
/// Required time at rest at the end of the observation, s.
const RESTS_S: f64 = 0.5;
/// Minimum interval between commands, cycles.
const HAND: u64 = 25;

/// Checks every cycle of a trial, and acts as its operator.
pub struct TrialOperator {
    orders: Orders,
    period: f64,
    limits: Vec<AxisLimits>,
    /// Shortest stop distance from here, mm.
    stop_needs: f64,
    /// Allowed stop distance, mm, and the part of it that was needed.
    stop_bound: Option<f64>,
    stop_part: f64,
    /// Start of the recovery after the fault, in cycles, and whether it succeeded.
    recovers: Option<u64>,
    recovered: bool,
    powered: bool,
    cycles: u64,
    mode: Mode,
    phase: Option<RunPhase>,
    place: Place,
    armed: bool,
    process: ProcessState,
    /// First cycle of the situation, and first cycle of the fault.
    there: Option<u64>,
    began: Option<u64>,
    /// Cycle and path length (mm) of the first alarm after the fault that switches the process off.
    alarmed: Option<(u64, f64)>,
    first_alarm: Option<Alarm>,
    off_cycles: u32,
    was_on: bool,
    stop_mm: f64,
    /// Positions of the last two set-points with power.
    sets: Vec<Joints>,
    still: u64,
    violations: Vec<Message>,
    /// Mode at the end of the observation, and whether everything was at rest for a while.
    mode_then: Option<Mode>,
    rests_then: bool,
    /// The operator has been polled for a command in this cycle.
    asked: bool,
}

impl TrialOperator {
    pub(super) fn new(machine: &Machine, orders: Orders) -> Self {
        Self {
            orders,
            period: machine.servo_period_s,
            limits: machine.axes.iter().map(Axis::limits).collect(),
            stop_needs: 0.0,
            stop_bound: None,
            stop_part: 0.0,
            recovers: None,
            recovered: false,
            powered: false,
            cycles: 0,
            mode: Mode::Off,
            phase: None,
            place: Place::default(),
            armed: false,
            process: ProcessState::Off,
            there: None,
            began: None,
            alarmed: None,
            first_alarm: None,
            off_cycles: 0,
            was_on: false,
            stop_mm: 0.0,
            sets: Vec::with_capacity(3),
            still: 0,
            violations: Vec::new(),
            mode_then: None,
            rests_then: false,
            asked: false,
        }
    }

    pub(super) fn outcome(self, left: Option<Place>) -> Outcome {
        let case = self.orders.case;
        let down = self.comes_back() && !self.recovered;
        let mut violations = self.violations;
        if down {
            violations.push(Message::new("cell-violation-no-restart"));
        }
        if self.mode_then.is_some_and(|m| !m.moves()) && !self.rests_then {
            violations.push(Message::new("cell-violation-no-rest"));
        }
        Outcome {
            case,
            mode: self.mode_then.unwrap_or(self.mode),
            first_alarm: self.first_alarm,
            off_cycles: self.off_cycles,
            stop_mm: self.stop_mm,
            stop_part: self.stop_part,
            left,
            reached: self.began.is_some(),
            violations,
        }
    }

    fn violated(&mut self, what: Message) {
        if self.violations.len() < 4 {
            let message = Message::new("cell-violation").quantity("time", self.cycles as f64 * self.period, Unit::S, 3);
            self.violations.push(message.message("what", what));
        }
    }

    /// Returns true in the requested situation.
    fn is_there(&self) -> bool {
        use Situation as S;
        let weld = self.mode == Mode::Weld;
        match self.orders.case.situation {
            S::Off => self.mode == Mode::Off,
            S::Idle => self.mode == Mode::Idle,
            S::Homing => self.mode == Mode::Homing,
            S::Ready => self.mode == Mode::Ready,
            S::Jog => self.mode == Mode::Jog,
            S::DryRun => self.mode == Mode::DryRun && self.phase.is_some() && self.place.s_mm > UNDER_WAY_MM,
            S::Approach => weld && self.phase.is_none(),
            S::Preflow => weld && self.phase == Some(RunPhase::Preflow),
            S::Strike => weld && self.process == ProcessState::Strikes,
            S::Travel => weld && self.phase == Some(RunPhase::Travel) && self.place.s_mm > UNDER_WAY_MM,
            S::Crater => weld && self.phase == Some(RunPhase::Crater),
            S::Hold => self.mode == Mode::Hold && self.phase == Some(RunPhase::Held),
            S::Fault => self.mode == Mode::Fault,
        }
    }

    /// Returns the delay of the fault in the situation, cycles.
    fn delay(&self) -> u64 {
        let most = match self.orders.case.situation {
            Situation::Strike => 20,
            Situation::Preflow | Situation::Homing | Situation::Crater => 150,
            _ => 300,
        };
        let most = if self.orders.anywhere { ANYWHERE } else { most };
        (self.orders.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33) % most
    }

    /// Returns true if the fault ended by itself and tripped the cell: then a restart must be possible.
    fn comes_back(&self) -> bool {
        let Case { device, kind, .. } = self.orders.case;
        let over = matches!(kind, FaultKind::Reboot | FaultKind::Reconnect) || device == Device::Cycle;
        over && self.mode_then == Some(Mode::Fault)
    }

    /// Returns the observation time after the fault, s.
    fn watches_s(&self) -> f64 {
        let Case { device, situation, .. } = self.orders.case;
        let runs = situation == Situation::DryRun || situation.welds() && situation != Situation::Crater;
        if device == Device::Sensors && runs { WATCHES_TRACKED_S } else { WATCHES_S }
    }

    /// Returns the next command of the recovery after an ended fault; `None` once power is back, or after the time
    /// limit.
    fn recover(&mut self) -> Option<Ask> {
        let since = *self.recovers.get_or_insert(self.cycles);
        if self.recovered || (self.cycles - since) as f64 * self.period > RECOVERS_S {
            return None;
        }
        match self.mode {
            // Acknowledge the alarms first, then reset.
            Mode::Fault | Mode::Off if (self.cycles / HAND).is_multiple_of(2) => Some(Ask::Acknowledge),
            Mode::Fault => Some(Ask::Reset),
            Mode::Off => Some(Ask::SwitchOn),
            _ => {
                self.recovered = self.powered;
                (!self.recovered).then_some(Ask::Acknowledge)
            }
        }
    }

    /// Returns the operator's next command.
    fn wish(&self) -> Option<Ask> {
        use Situation as S;
        let goal = self.orders.case.situation;
        match self.mode {
            Mode::Jog => Some(Ask::Jog(jog::Command::Speeds(self.jog_speeds()))),
            _ if self.began.is_some() => None,
            Mode::Off if goal != S::Off => Some(Ask::SwitchOn),
            Mode::Idle if goal != S::Idle => Some(Ask::Home),
            Mode::Ready => match goal {
                S::Ready | S::Off | S::Idle | S::Homing | S::Fault => None,
                S::Jog => Some(Ask::StartJog),
                S::DryRun => Some(Ask::StartDryRun),
                _ if self.armed => Some(Ask::StartWeld),
                _ => Some(Ask::Arm),
            },
            Mode::Weld if goal == S::Hold && self.place.s_mm > UNDER_WAY_MM => Some(Ask::Hold),
            _ => None,
        }
    }

    /// Jogs the first axis back and forth.
    fn jog_speeds(&self) -> Joints {
        let mut speeds = Joints::default();
        let forth = (self.cycles as f64 * self.period / 2.0).fract() < 0.5;
        speeds[0] = if forth { 0.2 } else { -0.2 } * self.limits[0].speed;
        speeds
    }

    fn check(&mut self, cycle: &Cycle<'_>) {
        let on = cycle.orders.process.on;
        // Orders were given in the mode of the previous cycle.
        if on && !matches!(self.mode, Mode::Weld | Mode::Hold) {
            self.violated(Message::new("cell-violation-process-on").message("mode", self.mode.message()));
        }
        if let Some((at, s)) = self.alarmed {
            // Orders of the alarm's own cycle were given before it.
            let since = (self.cycles - at) as u32;
            if on && since > 0 {
                self.off_cycles = since + 1;
                self.violated(Message::new("cell-violation-process-after-alarm"));
            } else if !on && self.was_on {
                self.off_cycles = self.off_cycles.max(since);
            }
            if cycle.phase.is_some() && !cycle.mode.moves() && self.mode_then.is_none() {
                self.stop_mm = self.stop_mm.max((cycle.place.s_mm - s).abs());
                if let Some(bound) = self.stop_bound {
                    self.stop_part = self.stop_mm / bound;
                    if self.stop_part > 1.0 {
                        let message = Message::new("cell-violation-stop").quantity("length", self.stop_mm, Unit::Mm, 3);
                        self.violated(message.quantity("max", bound, Unit::Mm, 3));
                    }
                }
            }
        }
        // These orders were given before this cycle's reports.
        let powered = cycle.orders.power && self.powered && cycle.reports.drives.powered && self.mode != Mode::Homing;
        let q: Joints = std::array::from_fn(|i| cycle.orders.set[i].position);
        self.still = if self.sets.last() == Some(&q) { self.still + 1 } else { 0 };
        if !powered {
            self.sets.clear();
        } else if self.began.is_none() && !cycle.orders.home {
            // The set-points followed are the axis positions.
            for i in 0..self.limits.len() {
                let away = (cycle.orders.set[i].position - cycle.reports.drives.position[i]).abs();
                if away > 0.2 + 0.02 * cycle.orders.set[i].velocity.abs() {
                    let message = Message::new("cell-violation-jump").number("axis", (i + 1) as f64, 0);
                    self.violated(message.number("distance", away, 3));
                }
            }
        }
        if self.sets.len() > 2 {
            self.sets.remove(0);
        }
        self.sets.push(q);
        if let [a, b, c] = self.sets[..] {
            for i in 0..self.limits.len() {
                let AxisLimits { speed, acceleration, .. } = self.limits[i];
                let v = (c[i] - b[i]) / self.period;
                let dv = (c[i] - 2.0 * b[i] + a[i]) / (self.period * self.period);
                if v.abs() > speed * 1.001 || dv.abs() > acceleration * 1.01 + 1e-6 {
                    let message = Message::new("cell-violation-limits").number("axis", (i + 1) as f64, 0);
                    self.violated(message.number("speed", v, 3).number("acceleration", dv, 2));
                }
            }
        }
    }
}

impl TrialOperator {
    /// Returns the shortest stop distance within the axes' limits, mm, as if the path were straight.
    fn shortest_stop(&self, cycle: &Cycle<'_>) -> f64 {
        let v = cycle.speed.abs();
        if v <= 0.0 {
            return 0.0;
        }
        let by = cycle.orders.set.iter().map(|set| set.velocity.abs() / v).zip(&self.limits);
        let by = by.filter(|(by, _)| *by > 1e-9).map(|(by, limits)| limits.divided(by));
        let AxisLimits { acceleration: a, jerk: j, .. } = by.fold(AxisLimits::NONE, AxisLimits::min);
        // Trapezoidal deceleration up to a, or triangular below it.
        let time = if v * j >= a * a { v / a + a / j } else { 2.0 * (v / j).sqrt() };
        0.5 * v * time + REACTS * self.period * v
    }
}

impl Port for TrialOperator {
    fn command(&mut self, t: f64) -> Option<Command> {
        if self.asked || !self.cycles.is_multiple_of(HAND) {
            return None;
        }
        self.asked = true;
        let watched = self.began.is_some_and(|began| (self.cycles - began) as f64 * self.period > self.watches_s());
        let late = REACHES_S + self.watches_s() + ANYWHERE as f64 * self.period;
        if watched || t > late {
            if self.mode_then.is_none() {
                self.mode_then = Some(self.mode);
                self.rests_then = self.still as f64 * self.period > RESTS_S;
            }
            if self.comes_back()
                && let Some(ask) = self.recover()
            {
                return Some(Command::of(ask));
            }
            let ask = match self.mode {
                Mode::Off | Mode::Fault => Ask::Quit,
                Mode::Idle | Mode::Ready => Ask::SwitchOff,
                _ => Ask::Stop,
            };
            return Some(Command::of(ask));
        }
        self.wish().map(Command::of)
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.cycles += 1;
        self.asked = false;
        self.check(cycle);
        (self.mode, self.phase, self.place) = (cycle.mode, cycle.phase, cycle.place);
        (self.armed, self.process) = (cycle.armed, cycle.process);
        self.powered = cycle.reports.drives.powered;
        self.stop_needs = self.shortest_stop(cycle);
        self.was_on = cycle.orders.process.on;
        if self.began.is_none() && (self.there.is_some() || self.is_there()) {
            let there = *self.there.get_or_insert(self.cycles);
            if self.cycles - there >= self.delay() {
                self.began = Some(self.cycles);
                self.orders.told.store(true, Ordering::Relaxed);
            }
        }
    }

    fn note(&mut self, _t: f64, note: Note) {
        if let (Note::Alarm(raised), Some(_)) = (note, self.began) {
            self.first_alarm.get_or_insert(raised.alarm);
            if raised.reaction >= Reaction::ProcessOff && self.alarmed.is_none() {
                self.alarmed = Some((self.cycles + 1, self.place.s_mm));
                // Without power the brakes hold.
                let stops = raised.reaction < Reaction::PowerOff && self.phase.is_some();
                self.stop_bound = stops.then_some(CAREFUL * self.stop_needs + 1e-3);
            }
        }
    }
}
