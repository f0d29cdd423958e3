//! Drives by step and direction pulses: set-points become pulses; a simulated stepper for each axis counts them back.
//!
//! Steppers have no encoder, so the reported positions are those of the simulated steppers. A motor with a torque curve
//! loses steps when overloaded; a motor without one counts every pulse.

mod rotor;

use super::{Drives, LATE_PERIODS, PowerState, UNREFERENCED_ERROR};
use crate::Error;
use crate::executive::{DriveReport, Orders, Slack};
use rotor::Rotor;
use rtrb::{Consumer, Producer, RingBuffer};
use seamwright_machine::{Axis, Joints, Machine, Stepper, Steps};
use seamwright_message::Message;
use seamwright_motion::pulses::{Edge, Event, Lines, Timing};

/// Pulse state of an axis.
#[derive(Debug, Clone)]
struct Stepped {
    steps_per_unit: f64,
    /// Pulse count at axis zero, steps: nonzero after lost steps.
    zero: f64,
    /// Maximum travel of a period, steps.
    most: f64,
    /// Maximum travel of a period with a change of direction, steps.
    most_turning: f64,
    rotor: Rotor,
}

/// The drives of a machine, by step and direction pulses.
///
/// Guarantees, tested over random motion within the axes' limits: after every cycle the pulses count the set-point
/// rounded to whole steps. No two edges are closer than the driver allows. Set-points beyond the limits are followed at
/// the maximum pulse rate.
#[derive(Debug)]
pub struct StepDrives {
    axes: Vec<Stepped>,
    lines: Lines,
    power: PowerState,
    tick_s: f64,
    period_s: f64,
    holds: bool,
    q: Joints,
    tap: Option<Producer<Event>>,
    /// The stream has lost an edge.
    torn: bool,
}

impl StepDrives {
    /// Places the axes without power at the machine's home positions, to the nearest step, references unknown.
    ///
    /// # Errors
    /// Invalid motor values in the machine file.
    pub fn new(machine: &Machine, device: &Steps) -> Result<Self, Error> {
        let bad = |axis: &Axis, reason: Message| Error::Drive { axis: axis.name.clone(), reason };
        let (mut axes, mut lines) = (Vec::new(), Vec::new());
        let mut q = Joints::default();
        for (i, (axis, home)) in machine.axes.iter().zip(machine.home()).enumerate() {
            let stepper = axis.stepper.as_ref().ok_or_else(|| bad(axis, Message::new("cell-no-stepper")))?;
            let timing =
                Timing::new(stepper, device.tick_s(), device.period).map_err(|e| bad(axis, Message::outside(&e)))?;
            let stepped = stepped(axis, stepper, &timing, home)?;
            lines.push((timing, (home * stepped.steps_per_unit).round()));
            q[i] = stepped.rotor.position();
            axes.push(stepped);
        }
        let lines = Lines::new(&lines).map_err(|(i, e)| bad(&machine.axes[i], Message::outside(&e)))?;
        Ok(Self {
            axes,
            lines,
            power: PowerState::new(machine.servo_period_s),
            tick_s: device.tick_s(),
            period_s: machine.servo_period_s,
            holds: false,
            q,
            tap: None,
            torn: false,
        })
    }

    /// Returns a stream of all later line changes in time order; ticks start with the first cycle. If a change does not
    /// fit in `room` unread ones, all drives report a fault and stop: playback would lose steps.
    pub fn tap(&mut self, room: usize) -> Consumer<Event> {
        let (to, edges) = RingBuffer::new(room);
        self.tap = Some(to);
        edges
    }

    /// Pulses per mm or rad of each axis.
    pub fn steps_per_unit(&self) -> impl Iterator<Item = f64> {
        self.axes.iter().map(|axis| axis.steps_per_unit)
    }

    /// Generates the pulses of a period and passes them to the rotors.
    fn play(&mut self, set: Option<&Joints>) {
        let Self { axes, lines, tap, torn, tick_s, .. } = self;
        let mut to = Joints::default();
        for (i, (axis, generator)) in axes.iter().zip(lines.generators()).enumerate() {
            to[i] = match set {
                Some(set) if !*torn => axis.target(set[i], generator.position(), generator.positive()),
                _ => generator.position(),
            };
        }
        lines.advance_or_stay(to);
        while let Some(event) = lines.event() {
            let rotor = &mut axes[event.axis].rotor;
            match event.edge {
                Edge::Fall => {}
                Edge::Direction(positive) => rotor.turn(positive),
                Edge::Rise => rotor.pulse(event.tick, *tick_s),
            }
            if let Some(tap) = tap {
                *torn |= tap.push(event).is_err();
            }
        }
    }
}

fn stepped(axis: &Axis, stepper: &Stepper, timing: &Timing, home: f64) -> Result<Stepped, Error> {
    let bad = |reason: Message| Error::Drive { axis: axis.name.clone(), reason };
    let microsteps = stepper.least_microsteps().ok_or_else(|| bad(Message::new("cell-microsteps-too-coarse")))?;
    let steps_per_unit = stepper.full_steps_per_unit() * f64::from(microsteps);
    let start = (home * steps_per_unit).round();
    let rotor = Rotor::new(axis, stepper, microsteps, start).map_err(|e| bad(Message::outside(&e)))?;
    let room = |ticks: u64| ticks as f64 / timing.spacing as f64;
    let turn = timing.period.saturating_sub(timing.width + timing.hold + timing.setup);
    Ok(Stepped {
        steps_per_unit,
        zero: 0.0,
        most: room(timing.period) * (1.0 - 1e-6),
        most_turning: (room(turn) - 2.0).max(0.0),
        rotor,
    })
}

impl Stepped {
    /// Pulse target at the end of a period, steps: `set`, limited to the travel that pulses allow from `at`.
    fn target(&self, set: f64, at: f64, positive: Option<bool>) -> f64 {
        let way = set * self.steps_per_unit + self.zero - at;
        // The first pulse of all also needs a direction change.
        let turns = positive.is_none_or(|positive| positive != (way > 0.0));
        let most = if turns { self.most_turning } else { self.most };
        if way.is_finite() { at + way.clamp(-most, most) } else { at }
    }
}

impl Drives for StepDrives {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        let (powered, follows) = self.power.step(orders);
        if follows && !self.holds {
            // Shift zero by the lost steps, so that the axes do not jump after power-on.
            self.axes.iter_mut().for_each(|axis| axis.zero = axis.rotor.lost());
        }
        self.holds = follows;
        let unknown = if self.power.is_referenced() { 0.0 } else { UNREFERENCED_ERROR };
        let mut set = Joints::default();
        set.iter_mut().zip(&orders.set).for_each(|(set, order)| *set = order.position - unknown);
        self.play(follows.then_some(&set));
        let end_s = self.lines.end() as f64 * self.tick_s;
        for (i, axis) in self.axes.iter_mut().enumerate() {
            if powered {
                axis.rotor.advance(end_s);
            } else {
                axis.rotor.rest(end_s);
            }
            self.q[i] = axis.rotor.position();
            report.position[i] = self.q[i] + unknown;
            report.following_error[i] = if follows { set[i] - self.q[i] } else { 0.0 };
            report.current[i] = 0.0;
        }
        let all = (1 << self.axes.len()) - 1;
        report.powered = powered;
        report.referenced = if self.power.is_referenced() { all } else { 0 };
        report.fault = if self.torn { all } else { 0 };
        (report.limit_switch, report.age_s) = (0, 0.0);
        report.starts = report.starts.max(1);
    }

    /// The time of the pulses stands still between exchanges.
    fn rides_out(&self) -> Slack {
        Slack::standing(self.period_s)
    }

    fn late_s(&self) -> f64 {
        LATE_PERIODS * self.period_s
    }

    fn truth(&self) -> Option<&Joints> {
        Some(&self.q)
    }
}

impl Drop for StepDrives {
    /// Ends every step pulse, so that no step line stays high.
    fn drop(&mut self) {
        let Some(tap) = &mut self.tap else { return };
        while let Some(event) = self.lines.last_event() {
            // The reader may have gone.
            let _ = tap.push(event);
        }
    }
}
