use super::SimulatedControl;
use seamwright_executive::devices::Drives;
use seamwright_executive::devices::robot::{CycleOrder, MeasuredLatency, RobotProtocol, Session, protocol};
use seamwright_executive::{DriveReport, Orders, Slack};
use seamwright_machine::{AxisKind, Joints, MAX_AXES, Machine, RobotDevice, RobotProtocolKind};

/// Drives by a simulated control in simulated time: session and protocol of real drives, without socket and thread.
pub struct LoopedRobot<C> {
    /// The control.
    pub control: C,
    session: Session,
    protocol: Box<dyn RobotProtocol>,
    /// Axis of the machine by joint, and the factor from the control's unit to ours.
    joints: Vec<(usize, f64)>,
    axes: u16,
    cycle_s: f64,
    store: u32,
    number: u64,
    /// Time of the next report, s.
    next_s: f64,
    truth: Joints,
    /// Reports are as if the torch were at its set-point.
    hides_lag: bool,
}

impl<C: SimulatedControl> LoopedRobot<C> {
    /// Connects `control` as the drives of `machine`.
    #[must_use]
    pub fn new(machine: &Machine, device: &RobotDevice, mut control: C) -> Self {
        let mut protocol = protocol(machine, device);
        let mut session = Session::new(machine, device, protocol.holds_last());
        session.connect();
        control.connect();
        let in_degrees = !matches!(device.protocol, RobotProtocolKind::Rtde { .. });
        let factor = |axis: usize| {
            let turns = machine.axes[axis].kind == AxisKind::Rotary;
            if turns && in_degrees { 1f64.to_radians() } else { 1.0 }
        };
        let mut out = Vec::new();
        protocol.begin(&mut out);
        let mut robot = Self {
            control,
            session,
            protocol,
            joints: device.axes.iter().map(|axis| (*axis, factor(*axis))).collect(),
            axes: (1 << machine.axes.len()) - 1,
            cycle_s: machine.servo_period_s,
            store: device.store,
            number: 0,
            next_s: 0.0,
            truth: [0.0; MAX_AXES],
            hides_lag: false,
        };
        robot.answer(&out, 0.0);
        robot
    }

    /// Reports positions as old as the set-point that they show: the torch then seems to be at its set-point. Shows what
    /// it is worth to know the lag.
    #[must_use]
    pub fn without_lag(mut self) -> Self {
        self.hides_lag = true;
        self
    }

    /// Returns the measured latency.
    #[must_use]
    pub fn latency(&self) -> Option<MeasuredLatency> {
        self.session.shown().latency
    }

    /// Passes bytes to the control, and its answers to the client, until both are silent.
    fn answer(&mut self, bytes: &[u8], now_s: f64) {
        let mut answers = Vec::new();
        self.control.take(bytes, now_s, &mut answers);
        self.deliver(answers, now_s);
    }

    fn deliver(&mut self, messages: Vec<Vec<u8>>, now_s: f64) {
        for message in messages {
            let mut out = Vec::new();
            let fed = self.protocol.feed(&message);
            debug_assert!(fed.is_ok(), "{fed:?}");
            while let Ok(Some(report)) = self.protocol.next(&mut out) {
                let order = self.session.report(&report, now_s);
                self.protocol.order(&order, &mut out);
            }
            if !out.is_empty() {
                self.answer(&out, now_s);
            }
        }
    }
}

impl<C: SimulatedControl> Drives for LoopedRobot<C> {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        self.number += 1;
        let begun_s = self.cycle_s * self.number as f64;
        let Orders { set, power, home, .. } = *orders;
        self.session.take(&CycleOrder { number: self.number, at_s: begun_s, set, power, home });
        let ends_s = begun_s + self.cycle_s;
        while self.next_s < ends_s {
            let mut out = Vec::new();
            self.control.tick(self.next_s, &mut out);
            self.deliver(out, self.next_s);
            self.next_s += self.control.period_s();
        }
        let shown = self.session.shown();
        shown.report(self.axes, report);
        report.age_s = shown.read_s.map_or(f64::INFINITY, |read_s| (ends_s - read_s).max(0.0));
        let lag_s = shown.place.map_or(0.0, |place| (self.number as f64 - place) * self.cycle_s);
        report.lag_s = lag_s.max(0.0);
        if self.hides_lag {
            report.age_s = report.lag_s;
        }
        for (joint, (axis, factor)) in self.joints.iter().enumerate() {
            self.truth[*axis] = self.control.arm().positions()[joint] * factor;
        }
    }

    fn rides_out(&self) -> Slack {
        Slack::stored(self.store - 1)
    }

    fn late_s(&self) -> f64 {
        0.1
    }

    fn truth(&self) -> Option<&Joints> {
        Some(&self.truth)
    }
}
