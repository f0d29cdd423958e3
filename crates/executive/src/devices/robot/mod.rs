//! Drives by a robot control that takes set-points: Universal Robots RTDE, ABB EGM, KUKA RSI.
//!
//! | task | item |
//! |---|---|
//! | drives of a machine file | [`RobotDrives::connect`] |
//! | what goes out for a report, without socket and clock | [`Session`] |
//! | bytes of a control | [`RobotProtocol`]: [`Rtde`], [`Egm`], [`Rsi`] |
//!
//! A client in a thread of its own answers each report of the control, at the control's rate, with the set-point of
//! that time. Set-points of the cycle come to it through a queue without locks, reports go back through a buffer. A
//! store of set-points (`playback.rs`) rides out late cycles; between two of them it follows the cubic of positions and
//! speeds. Times are those of the control's clock, mapped to ours (`clock_map.rs`), so that the jitter of packets does
//! not matter.
//!
//! **Latency.** A report shows a set-point that was sent some time ago. `latency_estimate.rs` measures how long.
//! [`DriveReport::lag_s`] is the age of the set-point that the report shows, from the order of the cycle on: store,
//! robot and packets together. Following errors and seam tracking refer to that set-point.
//!
//! **Stops.** Whatever ends the set-points, the robot stops: an order to switch off is an order to stop; missing
//! set-points end in a braking of all axes together; and when no packets come at all, the control stops by its own
//! watchdog. After any of them power must be ordered off before the robot follows again.
//!
//! # Limitations
//! No control was at hand: the protocols are tested against simulated controls and constructed packets.

mod client;
mod clock_map;
mod egm;
mod latency_estimate;
mod playback;
mod protobuf;
mod protocol;
mod rsi;
mod rtde;
mod session;
mod socket;

pub use egm::{Egm, RAPID};
pub use latency_estimate::MeasuredLatency;
pub use protocol::{Hindrance, ProtocolError, RobotOrder, RobotProtocol, RobotReport, RobotState};
pub use rsi::{KRL, Rsi};
pub use rtde::{Rtde, URSCRIPT};
pub use session::{CycleOrder, RobotShown, Session};

use super::Drives;
use super::traffic::{TrafficLog, TrafficView};
use crate::executive::{DriveReport, Orders, Slack};
use crate::realtime::SteadyTime;
use client::{Client, Ends};
use rtrb::{Producer, RingBuffer};
use seamwright_machine::{AxisKind, MAX_AXES, Machine, RobotDevice, RobotProtocolKind};
use seamwright_message::{Message, display_by_message};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use triple_buffer::{Output, triple_buffer};

/// Orders that wait for the client: a second of cycles of 1 ms.
const ORDERS: usize = 1024;
/// Maximum age of a fresh report, s, as with other devices beside the cycle.
const LATE_S: f64 = 0.1;

/// Reason why a control cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RobotFault {
    /// It cannot be reached.
    Unreachable(Message),
    /// Another program listens on the port.
    PortInUse,
    /// This computer does not listen on the address.
    NotListening(Message),
    /// It sends no reports.
    NoReports,
    /// It has closed the connection.
    Closed,
    /// The connection was lost.
    Lost(Message),
    /// Its messages are refused, or it refuses ours.
    Protocol(ProtocolError),
}

impl RobotFault {
    /// Returns its message.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Unreachable(why) | Self::Lost(why) => Message::new("cell-robot-lost").message("why", why.clone()),
            Self::PortInUse => Message::new("cell-robot-port-in-use"),
            Self::NotListening(why) => Message::new("cell-robot-not-listening").message("why", why.clone()),
            Self::NoReports => Message::new("cell-robot-no-reports"),
            Self::Closed => Message::new("cell-robot-closed"),
            Self::Protocol(error) => error.message(),
        }
    }
}

/// A control that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RobotError {
    /// Name of the device in the machine file.
    pub device: String,
    /// Address of the control, or ours.
    pub address: String,
    /// Key of its protocol.
    pub protocol: &'static str,
    /// The reason.
    pub fault: RobotFault,
}

impl RobotError {
    fn new(device: &RobotDevice, fault: RobotFault) -> Self {
        let protocol = &device.protocol;
        Self { device: device.name.clone(), address: protocol.address(), protocol: protocol.key(), fault }
    }

    /// Returns its message.
    #[must_use]
    pub fn message(&self) -> Message {
        Message::new("cell-robot-unusable")
            .text("device", &self.device)
            .text("protocol", self.protocol)
            .text("address", &self.address)
            .message("why", self.fault.message())
    }
}

display_by_message!(RobotError);

/// The drives of a machine, by a robot control. An exchange does not wait: the caller keeps the period.
#[derive(Debug)]
pub struct RobotDrives {
    axes: u16,
    period_s: f64,
    store: u32,
    origin: SteadyTime,
    number: u64,
    orders: Producer<CycleOrder>,
    shown: Output<RobotShown>,
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl RobotDrives {
    /// Connects the control of `device`, and waits up to 3 s for its first report. The robot does not move. The second
    /// result shows the traffic and the measured latency.
    ///
    /// # Errors
    /// The control is not reached, sends nothing, or refuses the protocol; each error names the cure.
    pub fn connect(machine: &Machine, device: &RobotDevice) -> Result<(Self, TrafficView), RobotError> {
        let protocol = protocol(machine, device);
        let session = Session::new(machine, device, protocol.holds_last());
        let (to_client, orders) = RingBuffer::new(ORDERS);
        let (shown_in, shown) = triple_buffer(&RobotShown::default());
        let (traffic, view) = TrafficLog::new();
        let (ended, origin) = (Arc::new(AtomicBool::new(false)), SteadyTime::now());
        let ends = Ends { orders, shown: shown_in, ended: Arc::clone(&ended), traffic, origin };
        let client = Client::connect(device, protocol, session, ends)?;
        let named = std::thread::Builder::new().name(format!("robot {}", device.name));
        let lost = |error: std::io::Error| RobotError::new(device, RobotFault::Lost(Message::outside(&error)));
        let thread = named.spawn(move || client.run()).map_err(lost)?;
        let drives = Self {
            axes: (1 << machine.axes.len()) - 1,
            period_s: machine.servo_period_s,
            store: device.store,
            origin,
            number: 0,
            orders: to_client,
            shown,
            ended,
            thread: Some(thread),
        };
        Ok((drives, view))
    }
}

/// Creates the protocol of `device`.
#[must_use]
pub fn protocol(machine: &Machine, device: &RobotDevice) -> Box<dyn RobotProtocol> {
    let mut linear = [false; MAX_AXES];
    for (joint, axis) in device.axes.iter().enumerate() {
        linear[joint] = machine.axes[*axis].kind == AxisKind::Linear;
    }
    match &device.protocol {
        RobotProtocolKind::Rtde { .. } => Box::new(Rtde::new(1.0 / device.period_s)),
        RobotProtocolKind::Egm(_) => Box::new(Egm::new(device.arm_joints, device.axes.len(), linear)),
        RobotProtocolKind::Rsi(_) => Box::new(Rsi::new(device.axes.len(), linear)),
    }
}

impl Drives for RobotDrives {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        self.number += 1;
        let Orders { set, power, home, .. } = *orders;
        let order = CycleOrder { number: self.number, at_s: self.origin.elapsed_s(), set, power, home };
        // Without room the client does not run: its reports age.
        let _ = self.orders.push(order);
        let shown = self.shown.read();
        shown.report(self.axes, report);
        report.age_s = shown.read_s.map_or(f64::INFINITY, |read_s| self.origin.elapsed_s() - read_s);
        let lag_s = shown.place.map_or(0.0, |place| (self.number as f64 - place) * self.period_s);
        report.lag_s = lag_s.max(0.0);
    }

    /// The stored set-points, except the active one.
    fn rides_out(&self) -> Slack {
        Slack::stored(self.store - 1)
    }

    fn late_s(&self) -> f64 {
        LATE_S
    }
}

impl Drop for RobotDrives {
    /// Stops the robot, and waits up to half a second for its confirmation.
    fn drop(&mut self) {
        self.ended.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            // A panicked client has dropped its connection: the control's own watchdog remains.
            let _ = thread.join();
        }
    }
}
