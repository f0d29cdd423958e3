//! An operator who brings a cell into a situation, and a witness of what follows.

use super::case::{Case, Outcome, Situation};
use crate::devices::{Device, FaultKind};
use crate::executive::{Alarm, Ask, Command, Cycle, Mode, Note, Place, Port, ProcessState, Reaction};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::jog;
use seamwright_motion::pace::RunPhase;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// What the operator is to do.
pub(super) struct Orders {
    pub(super) case: Case,
    /// The fault comes at any moment of a weld, not soon.
    pub(super) anywhere: bool,
    /// Tells the fault to begin.
    pub(super) told: Arc<AtomicBool>,
    pub(super) seed: u64,
}

/// How long the witness watches after the fault, s; of a sensor whose loss the weld rides out for a while.
const WATCHES_S: f64 = 2.5;
const WATCHES_TRACKED_S: f64 = 45.0;
/// Longest time to reach a situation, s.
const REACHES_S: f64 = 60.0;
/// Longest time from a fault that is over to axes with power again, s.
const RECOVERS_S: f64 = 3.0;
/// Cycles within which the fault comes that may come anywhere.
const ANYWHERE: u64 = 20_000;
/// Cycles from an alarm to the first set-point that brakes.
const REACTS: f64 = 3.0;
/// The pace keeps a way back to a steady pace at every moment: it needs at most so much more than the shortest stop.
const CAREFUL: f64 = 2.0;
/// Path length after which a dry run or a weld has come far enough, mm.
const UNDER_WAY_MM: f64 = 3.0;
/// At the end of the watch everything has been at rest for so long, s.
const RESTS_S: f64 = 0.5;
/// Commands come no faster than this, cycles.
const HAND: u64 = 25;

/// Sees every cycle of a trial, and is its operator.
pub struct Witness {
    orders: Orders,
    period: f64,
    /// Greatest speed and acceleration of each axis.
    limits: Vec<[f64; 3]>,
    /// What a stop from here needs at least, mm.
    stop_needs: f64,
    /// What the stop may need, and the part of it that was needed.
    stop_bound: Option<f64>,
    stop_part: f64,
    /// Since when the cell is brought back after the fault, and if it came.
    recovers: Option<u64>,
    recovered: bool,
    powered: bool,
    cycles: u64,
    mode: Mode,
    phase: Option<RunPhase>,
    place: Place,
    armed: bool,
    process: ProcessState,
    /// Cycle in which the situation was there first, and in which the fault began.
    there: Option<u64>,
    began: Option<u64>,
    /// Cycle of the first alarm after the fault that takes the process away.
    alarmed: Option<(u64, f64)>,
    first_alarm: Option<Alarm>,
    off_cycles: u32,
    was_on: bool,
    stop_mm: f64,
    /// Positions of the last two set-points with power.
    sets: Vec<Joints>,
    still: u64,
    violations: Vec<String>,
    /// The mode at the end of the watch, and if everything has been at rest for a while.
    mode_then: Option<Mode>,
    rests_then: bool,
    /// The operator has asked for something in this cycle.
    asked: bool,
}

impl Witness {
    pub(super) fn new(machine: &Machine, orders: Orders) -> Self {
        Self {
            orders,
            period: machine.servo_period_s,
            limits: machine.axes.iter().map(|a| [a.max_speed, a.max_acceleration, a.jerk()]).collect(),
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
            violations.push("it cannot be switched on again".to_owned());
        }
        if self.mode_then.is_some_and(|m| !m.moves()) && !self.rests_then {
            violations.push("it does not rest".to_owned());
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

    fn violated(&mut self, what: &str) {
        if self.violations.len() < 4 {
            self.violations.push(format!("{:.3} s: {what}", self.cycles as f64 * self.period));
        }
    }

    /// True in the situation that was asked for.
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

    /// Cycles in the situation before the fault comes.
    fn delay(&self) -> u64 {
        let most = match self.orders.case.situation {
            Situation::Strike => 20,
            Situation::Preflow | Situation::Homing | Situation::Crater => 150,
            _ => 300,
        };
        let most = if self.orders.anywhere { ANYWHERE } else { most };
        (self.orders.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 33) % most
    }

    /// The fault is over by itself, and took the cell down: then it can be switched on again.
    fn comes_back(&self) -> bool {
        let Case { device, kind, .. } = self.orders.case;
        let over = matches!(kind, FaultKind::Reboot | FaultKind::Reconnect) || device == Device::Cycle;
        over && self.mode_then == Some(Mode::Fault)
    }

    /// How long it watches after the fault, s.
    fn watches_s(&self) -> f64 {
        let Case { device, situation, .. } = self.orders.case;
        let runs = situation == Situation::DryRun || situation.welds() && situation != Situation::Crater;
        if device == Device::Sensors && runs { WATCHES_TRACKED_S } else { WATCHES_S }
    }

    /// What brings the cell back after a fault that is over; none once it has power again, or does not come.
    fn recover(&mut self) -> Option<Ask> {
        let since = *self.recovers.get_or_insert(self.cycles);
        if self.recovered || (self.cycles - since) as f64 * self.period > RECOVERS_S {
            return None;
        }
        match self.mode {
            // What is on the list is known, then looked at.
            Mode::Fault | Mode::Off if (self.cycles / HAND).is_multiple_of(2) => Some(Ask::Acknowledge),
            Mode::Fault => Some(Ask::Reset),
            Mode::Off => Some(Ask::SwitchOn),
            _ => {
                self.recovered = self.powered;
                (!self.recovered).then_some(Ask::Acknowledge)
            }
        }
    }

    /// What the operator does next.
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

    /// To and fro with the first axis.
    fn jog_speeds(&self) -> Joints {
        let mut speeds = Joints::default();
        let forth = (self.cycles as f64 * self.period / 2.0).fract() < 0.5;
        speeds[0] = if forth { 0.2 } else { -0.2 } * self.limits[0][0];
        speeds
    }

    fn check(&mut self, cycle: &Cycle<'_>) {
        let on = cycle.orders.process.on;
        // The mode is the one before this cycle: orders were given then.
        if on && !matches!(self.mode, Mode::Weld | Mode::Hold) {
            self.violated(&format!("the process is on in mode {}", self.mode));
        }
        if let Some((at, s)) = self.alarmed {
            // Orders of the alarm's own cycle were given before it.
            let since = (self.cycles - at) as u32;
            if on && since > 0 {
                self.off_cycles = since + 1;
                self.violated("the process is on after the alarm");
            } else if !on && self.was_on {
                self.off_cycles = self.off_cycles.max(since);
            }
            if cycle.phase.is_some() && !cycle.mode.moves() && self.mode_then.is_none() {
                self.stop_mm = self.stop_mm.max((cycle.place.s_mm - s).abs());
                if let Some(bound) = self.stop_bound {
                    self.stop_part = self.stop_mm / bound;
                    if self.stop_part > 1.0 {
                        self.violated(&format!("{:.3} mm to rest, {bound:.3} mm allowed", self.stop_mm));
                    }
                }
            }
        }
        // These orders were given with what was known before this cycle's reports.
        let powered = cycle.orders.power && self.powered && cycle.reports.drives.powered && self.mode != Mode::Homing;
        let q: Joints = std::array::from_fn(|i| cycle.orders.set[i].position);
        self.still = if self.sets.last() == Some(&q) { self.still + 1 } else { 0 };
        if !powered {
            self.sets.clear();
        } else if self.began.is_none() && !cycle.orders.home {
            // What is followed is where the axes are.
            for i in 0..self.limits.len() {
                let away = (cycle.orders.set[i].position - cycle.reports.drives.position[i]).abs();
                if away > 0.2 + 0.02 * cycle.orders.set[i].velocity.abs() {
                    self.violated(&format!("axis {i} is told to be {away:.3} from where it is"));
                }
            }
        }
        if self.sets.len() > 2 {
            self.sets.remove(0);
        }
        self.sets.push(q);
        if let [a, b, c] = self.sets[..] {
            for i in 0..self.limits.len() {
                let [speed, acceleration, _] = self.limits[i];
                let v = (c[i] - b[i]) / self.period;
                let dv = (c[i] - 2.0 * b[i] + a[i]) / (self.period * self.period);
                if v.abs() > speed * 1.001 || dv.abs() > acceleration * 1.01 + 1e-6 {
                    self.violated(&format!("axis {i}: speed {v:.3}, acceleration {dv:.2}"));
                }
            }
        }
    }
}

impl Witness {
    /// Path length that the axes' limits need to come to rest from here, mm: as if the path went straight on.
    fn shortest_stop(&self, cycle: &Cycle<'_>) -> f64 {
        let v = cycle.speed.abs();
        if v <= 0.0 {
            return 0.0;
        }
        let (mut a, mut j) = (f64::INFINITY, f64::INFINITY);
        for (set, [_, acceleration, jerk]) in cycle.orders.set.iter().zip(&self.limits) {
            let by = set.velocity.abs() / v;
            if by > 1e-9 {
                (a, j) = (a.min(acceleration / by), j.min(jerk / by));
            }
        }
        // Deceleration grows to a and falls again, or does not come so far.
        let time = if v * j >= a * a { v / a + a / j } else { 2.0 * (v / j).sqrt() };
        0.5 * v * time + REACTS * self.period * v
    }
}

impl Port for Witness {
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
