//! The session with a control: what goes out for every report that comes in. It has neither clock nor socket.

use super::clock_map::ClockMap;
use super::latency_estimate::{LatencyEstimate, MAX_LATENCY_S, MeasuredLatency};
use super::playback::{Playback, Sampled};
use super::protocol::{Hindrance, RobotOrder, RobotReport, RobotState};
use crate::executive::DriveReport;
use seamwright_machine::{AxisKind, Joints, MAX_AXES, Machine, RobotDevice};
use seamwright_servo::SetPoint;
use std::collections::VecDeque;

/// Samples that are kept for the latency: twice the longest one at 1 kHz.
const SENT: usize = 512;
/// Time in which the robot goes from where it stands to the first set-points, s.
const BLEND_S: f64 = 0.5;
/// Maximum distance from where the robot stands to the first set-point: rad, and mm of linear joints. A servo's droop
/// is less; more means that positions are not those of the robot.
const MAX_BLEND: [f64; 2] = [0.02, 2.0];
/// Speed of set-points, relative to the axis' maximum, from which they jump.
const JUMP_SPEED: f64 = 1.5;
/// Distance between two set-points that is no jump at any speed: rad, and mm of linear joints.
const NO_JUMP: [f64; 2] = [2e-3, 1.0];
/// Periods of the control after which playback stands still instead of leaping.
const MAX_STEP_PERIODS: f64 = 2.5;

/// An order of the cycle.
#[derive(Debug, Clone, Copy)]
pub struct CycleOrder {
    /// Number, counted up by 1 from 1.
    pub number: u64,
    /// Time at which it was given, s.
    pub at_s: f64,
    /// Set-points of the machine's axes.
    pub set: [SetPoint; MAX_AXES],
    /// The drives are to have power.
    pub power: bool,
    /// Homing: set-points are ignored.
    pub home: bool,
}

/// State of the robot for the cycle, by axes of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RobotShown {
    /// Time of the report, s; none before the first.
    pub read_s: Option<f64>,
    /// Measured positions.
    pub position: Joints,
    /// Difference between the set-point that the report should show, and the position.
    pub following_error: Joints,
    /// The robot follows set-points.
    pub follows: bool,
    /// Axes with a fault, one bit each.
    pub fault: u16,
    /// Place of the set-point that the report shows, in orders; none if the robot does not follow.
    pub place: Option<f64>,
    /// Number of sessions with the control.
    pub starts: u32,
    /// Number of times that set-points were missing.
    pub starved: u32,
    /// Measured latency.
    pub latency: Option<MeasuredLatency>,
    /// Reason why the robot does not follow.
    pub hindrance: Option<Hindrance>,
}

impl RobotShown {
    /// Writes the report of drives with these `axes`, one bit each; age and lag stay as they are.
    pub fn report(&self, axes: u16, report: &mut DriveReport) {
        (report.powered, report.fault) = (self.follows, self.fault);
        (report.position, report.following_error) = (self.position, self.following_error);
        // A robot always knows its positions.
        report.referenced = if self.read_s.is_some() { axes } else { 0 };
        (report.starts, report.starved) = (self.starts, self.starved);
    }
}

/// Phase of a session.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// Without power.
    Off,
    /// Power is ordered; the control does not follow yet.
    Starting,
    /// The control follows the set-points.
    Following,
    /// The control has stopped following: power must be ordered off before it may start again.
    Stopped(Hindrance),
}

/// Offset of the first set-points from where the robot stands; it fades out.
#[derive(Debug, Clone, Copy)]
struct Blend {
    by: Joints,
    since_s: f64,
}

/// Turns orders of the cycle and reports of the control into set-points of the control.
#[derive(Debug)]
pub struct Session {
    /// Axis of the machine by joint of the control.
    axes: Vec<usize>,
    period_s: f64,
    /// Period of the cycle.
    cycle_s: f64,
    max_speeds: Joints,
    /// 0 for rotary, 1 for linear, by axis.
    kinds: [usize; MAX_AXES],
    holds_last: bool,
    playback: Playback,
    clock: ClockMap,
    latency: LatencyEstimate,
    /// Times of set-points sent, and their places; NaN beside the path.
    sent: VecDeque<(f64, f64)>,
    /// Last positions sent, by axis, and their time.
    last: Option<(Joints, f64)>,
    phase: Phase,
    blend: Option<Blend>,
    power: bool,
    home: bool,
    /// The robot was held for homing.
    was_home: bool,
    number: u32,
    shown: RobotShown,
}

impl Session {
    /// Creates a session without a connection; `holds_last` as [`super::RobotProtocol::holds_last`].
    #[must_use]
    pub fn new(machine: &Machine, device: &RobotDevice, holds_last: bool) -> Self {
        let (mut accelerations, mut max_speeds, mut kinds) = ([0.0; MAX_AXES], [0.0; MAX_AXES], [0; MAX_AXES]);
        for (i, axis) in machine.axes.iter().enumerate() {
            (accelerations[i], max_speeds[i]) = (axis.max_acceleration, axis.max_speed);
            kinds[i] = usize::from(axis.kind == AxisKind::Linear);
        }
        Self {
            axes: device.axes.clone(),
            period_s: device.period_s,
            cycle_s: machine.servo_period_s,
            max_speeds,
            kinds,
            holds_last,
            playback: Playback::new(machine.servo_period_s, device.store, accelerations),
            clock: ClockMap::default(),
            latency: LatencyEstimate::new(device.latency_s, |i| kinds[i] == 1),
            sent: VecDeque::with_capacity(SENT),
            last: None,
            phase: Phase::Off,
            blend: None,
            power: false,
            home: false,
            was_home: false,
            number: 0,
            shown: RobotShown::default(),
        }
    }

    /// Takes an order of the cycle.
    pub fn take(&mut self, order: &CycleOrder) {
        self.playback.take(order.number, &order.set, order.at_s);
        if (order.power && !self.power) || (self.home && !order.home) {
            self.playback.forget();
        }
        (self.power, self.home) = (order.power, order.home);
        if !order.power {
            self.phase = Phase::Off;
        }
    }

    /// Forgets a lost connection: the robot counts as stopped until power is ordered off.
    pub fn disconnect(&mut self) {
        if self.phase != Phase::Off {
            self.phase = Phase::Stopped(Hindrance::Disconnected);
        }
        (self.clock, self.last, self.blend) = (ClockMap::default(), None, None);
        self.sent.clear();
        (self.shown.follows, self.shown.place) = (false, None);
        self.shown.hindrance = Some(Hindrance::Disconnected);
    }

    /// Counts a new connection.
    pub fn connect(&mut self) {
        self.shown.starts += 1;
    }

    /// State for the cycle.
    #[must_use]
    pub fn shown(&self) -> &RobotShown {
        &self.shown
    }

    /// Takes a report that arrived at `now_s`; returns the order to send.
    pub fn report(&mut self, report: &RobotReport, now_s: f64) -> RobotOrder {
        let position = self.by_axis(&report.joints);
        if report.begins {
            self.disconnect();
            self.connect();
        }
        // Set-points are for the grid of the control's clock, without the jitter of packets.
        let read_s = self.clock.map(report.clock_s, now_s).min(now_s);
        self.go_on(report, &position, read_s);
        self.compare(&position, read_s);
        let positions = self.positions(&position, read_s);
        self.show(report, position, read_s);
        self.number = self.number.wrapping_add(1) & 0x7fff_ffff;
        let mut joints = [0.0; MAX_AXES];
        joints.iter_mut().zip(&self.axes).for_each(|(joint, axis)| *joint = positions[*axis]);
        let follows = matches!(self.phase, Phase::Starting | Phase::Following);
        RobotOrder { joints, follows, number: self.number }
    }

    /// Returns the order of a robot that stops, at the end.
    pub fn stop(&mut self) -> Option<RobotOrder> {
        self.number = self.number.wrapping_add(1) & 0x7fff_ffff;
        let (positions, _) = self.last?;
        let mut joints = [0.0; MAX_AXES];
        joints.iter_mut().zip(&self.axes).for_each(|(joint, axis)| *joint = positions[*axis]);
        Some(RobotOrder { joints, follows: false, number: self.number })
    }

    fn by_axis(&self, joints: &Joints) -> Joints {
        let mut positions = [0.0; MAX_AXES];
        self.axes.iter().zip(joints).for_each(|(axis, joint)| positions[*axis] = *joint);
        positions
    }

    /// Changes the phase by the orders and the state of the control.
    fn go_on(&mut self, report: &RobotReport, position: &Joints, now_s: f64) {
        self.phase = match (self.phase, report.state) {
            _ if !self.power => Phase::Off,
            (Phase::Off, RobotState::Follows | RobotState::Ready) => Phase::Starting,
            (Phase::Starting, RobotState::Follows) => {
                self.playback.restart(now_s);
                self.begin_blend(position, now_s)
            }
            (Phase::Following, RobotState::Ready) => Phase::Stopped(Hindrance::ProgramStopped),
            (Phase::Following | Phase::Starting, RobotState::Hindered(why)) => Phase::Stopped(why),
            (phase, _) => phase,
        };
        if self.phase == Phase::Following && self.was_home && !self.home {
            self.playback.restart(now_s);
            self.phase = self.begin_blend(position, now_s);
        }
        self.was_home = self.home && self.phase == Phase::Following;
    }

    /// Starts the way from where the robot is held to the set-points.
    fn begin_blend(&mut self, position: &Joints, now_s: f64) -> Phase {
        let held = self.last.filter(|_| self.holds_last || self.phase == Phase::Following);
        let held = held.map_or(*position, |(held, _)| held);
        let Some(first) = self.playback.at(self.playback.place()) else { return Phase::Starting };
        let by: Joints = std::array::from_fn(|i| held[i] - first.positions[i]);
        // A position that is not a number is far, too.
        let is_near = self.axes.iter().all(|i| by[*i].abs() <= MAX_BLEND[self.kinds[*i]]);
        self.blend = Some(Blend { by, since_s: now_s });
        if is_near { Phase::Following } else { Phase::Stopped(Hindrance::Jump) }
    }

    /// Returns the positions to send at `now_s`, by axis, for a robot at `position`.
    fn positions(&mut self, position: &Joints, now_s: f64) -> Joints {
        let stays = self.last.filter(|_| self.holds_last || self.phase == Phase::Following);
        let stays = stays.map_or(*position, |(last, _)| last);
        let mut place = f64::NAN;
        let mut positions = stays;
        if self.phase == Phase::Following && !self.home {
            match self.playback.sample(now_s, MAX_STEP_PERIODS * self.period_s) {
                Sampled::OnPath(on_path, at) => (positions, place) = (on_path, at),
                Sampled::Brakes(braking) => positions = braking,
                Sampled::Stands(standing) => {
                    positions = standing;
                    self.shown.starved += 1;
                    self.phase = Phase::Stopped(Hindrance::Starved);
                }
            }
            if let Some(Blend { by, since_s }) = self.blend {
                let u = (now_s - since_s) / BLEND_S;
                if u < 1.0 {
                    let left = 1.0 - u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
                    positions.iter_mut().zip(by).for_each(|(position, by)| *position += left * by);
                    place = f64::NAN;
                } else {
                    self.blend = None;
                }
            }
            if self.jumps(&positions, now_s) {
                (positions, place) = (stays, f64::NAN);
                self.phase = Phase::Stopped(Hindrance::Jump);
            }
        }
        if self.sent.len() == SENT {
            self.sent.pop_front();
        }
        self.sent.push_back((now_s, place));
        self.last = Some((positions, now_s));
        positions
    }

    /// Returns true if an axis cannot reach `positions` from the last ones, or a position is not a number.
    fn jumps(&self, positions: &Joints, now_s: f64) -> bool {
        let Some((last, at_s)) = self.last else { return false };
        let passed_s = (now_s - at_s).max(self.period_s);
        let is_reached = |i: &usize| {
            let most = JUMP_SPEED * self.max_speeds[*i] * passed_s + NO_JUMP[self.kinds[*i]];
            (positions[*i] - last[*i]).abs() <= most
        };
        !self.axes.iter().all(is_reached)
    }

    /// Returns the place that was sent at `t_s`; `None` if the robot was not on the path then.
    fn place_at(&self, t_s: f64) -> Option<f64> {
        let after = self.sent.partition_point(|(at_s, _)| *at_s <= t_s);
        let (t0, p0) = *self.sent.get(after.checked_sub(1)?)?;
        let place = match self.sent.get(after) {
            Some((t1, p1)) => p0 + (p1 - p0) * (t_s - t0) / (t1 - t0),
            // Less than a period of the control ago.
            None if t_s - t0 <= MAX_STEP_PERIODS * self.period_s => p0 + (t_s - t0) / self.cycle_s,
            None => return None,
        };
        place.is_finite().then_some(place)
    }

    /// Compares a report with the set-point that it should show.
    fn compare(&mut self, position: &Joints, read_s: f64) {
        let place = self.place_at(read_s - self.latency.latency_s());
        let place = place.filter(|_| self.phase == Phase::Following);
        self.shown.place = place;
        self.shown.following_error = [0.0; MAX_AXES];
        let Some(set) = place.and_then(|place| self.playback.at(place)) else { return };
        self.latency.add(position, &set.positions, &set.velocities);
        self.shown.following_error = std::array::from_fn(|i| set.positions[i] - position[i]);
    }

    fn show(&mut self, report: &RobotReport, position: Joints, read_s: f64) {
        let mut fault = 0;
        for (joint, axis) in self.axes.iter().enumerate() {
            fault |= (report.fault >> joint & 1) << axis;
        }
        self.shown = RobotShown {
            read_s: Some(read_s),
            position,
            follows: self.phase == Phase::Following,
            fault,
            latency: self.latency.measured(),
            hindrance: match (self.phase, report.state) {
                (_, RobotState::Hindered(why)) | (Phase::Stopped(why), _) => Some(why),
                _ => None,
            },
            ..self.shown
        };
    }
}

// The longest latency is within the samples that are kept, at the highest rate of a control.
const _: () = assert!(SENT as f64 * 2e-3 > 2.0 * MAX_LATENCY_S);
