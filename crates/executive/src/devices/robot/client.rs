//! The thread that talks with a control.

use super::protocol::{Hindrance, ProtocolError, RobotProtocol, RobotState};
use super::session::{CycleOrder, RobotShown, Session};
use super::socket::{Received, Socket};
use super::{RobotError, RobotFault};
use crate::devices::traffic::TrafficLog;
use crate::realtime::{RealtimeRights, SteadyTime};
use rtrb::Consumer;
use seamwright_machine::RobotDevice;
use seamwright_message::Message;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use triple_buffer::Input;

/// Maximum time until the first report, s.
const FIRST_S: f64 = 3.0;
/// Time without a report after which the connection counts as lost, s: the executive has reacted long before.
const SILENT_S: f64 = 0.5;
/// Maximum time of a handshake on a new connection, s.
const HANDSHAKE_S: f64 = 1.0;
/// Pause between attempts to connect.
const AGAIN: Duration = Duration::from_millis(500);
/// Maximum time in which the robot confirms its stop at the end, s.
const STOP_S: f64 = 0.5;
/// Time between updates of the traffic that others see, s.
const SHOWN_S: f64 = 0.1;
/// Largest datagram, and largest part of a stream read at once.
const READ: usize = 1 << 16;

/// The client's side of the data shared with the cycle.
pub(super) struct Ends {
    pub(super) orders: Consumer<CycleOrder>,
    pub(super) shown: Input<RobotShown>,
    pub(super) ended: Arc<AtomicBool>,
    pub(super) traffic: TrafficLog,
    /// Origin of all times.
    pub(super) origin: SteadyTime,
}

/// Client of a control, in a thread of its own. It answers every report with the set-point of that time.
pub(super) struct Client {
    device: RobotDevice,
    protocol: Box<dyn RobotProtocol>,
    session: Session,
    socket: Socket,
    ends: Ends,
    buffer: Vec<u8>,
    out: Vec<u8>,
    counts: Counts,
    is_connected: bool,
}

/// Counts of the traffic.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    reports: u64,
    lost: u64,
    failed: u64,
    away_s: f64,
    /// Time of the last report here, and on the control's clock.
    last_s: f64,
    last_clock_s: Option<f64>,
    shown_s: f64,
    stopped: bool,
}

impl Client {
    /// Connects, and waits for the first report.
    pub(super) fn connect(
        device: &RobotDevice,
        protocol: Box<dyn RobotProtocol>,
        session: Session,
        ends: Ends,
    ) -> Result<Self, RobotError> {
        let failed = |fault: RobotFault| RobotError::new(device, fault);
        let socket = Socket::open(&device.protocol).map_err(failed)?;
        let mut client = Self {
            device: device.clone(),
            protocol,
            session,
            socket,
            ends,
            buffer: vec![0; READ],
            out: Vec::new(),
            counts: Counts::default(),
            is_connected: false,
        };
        client.begin().map_err(failed)?;
        let since_s = client.now_s();
        while !client.is_connected {
            client.receive().map_err(failed)?;
            if client.now_s() - since_s > FIRST_S {
                return Err(failed(RobotFault::NoReports));
            }
        }
        Ok(client)
    }

    fn now_s(&self) -> f64 {
        self.ends.origin.elapsed_s()
    }

    /// Starts the protocol on a new connection.
    fn begin(&mut self) -> Result<(), RobotFault> {
        self.out.clear();
        self.protocol.begin(&mut self.out);
        self.counts.last_clock_s = None;
        self.socket.send(&self.out)
    }

    /// Waits a moment for data, and answers them.
    fn receive(&mut self) -> Result<(), RobotFault> {
        let received = self.socket.receive(&mut self.buffer)?;
        while let Ok(order) = self.ends.orders.pop() {
            self.session.take(&order);
        }
        let Received::Bytes(count) = received else { return Ok(()) };
        let arrived_s = self.now_s();
        self.out.clear();
        let is_stream = self.socket.is_stream();
        let done = self.answer(count, arrived_s);
        match done {
            // A datagram that is no message is refused; the next one may be.
            Err(ProtocolError::Malformed) if !is_stream => self.counts.failed += 1,
            other => other.map_err(RobotFault::Protocol)?,
        }
        self.socket.send(&self.out)
    }

    fn answer(&mut self, count: usize, arrived_s: f64) -> Result<(), ProtocolError> {
        self.protocol.feed(&self.buffer[..count])?;
        while let Some(report) = self.protocol.next(&mut self.out)? {
            if !self.is_connected {
                self.is_connected = true;
                self.session.connect();
                self.ends.traffic.change(|traffic| traffic.connections += 1);
            }
            let order = if self.ends.ended.load(Ordering::Acquire) {
                self.counts.stopped = !matches!(report.state, RobotState::Follows) || self.protocol.holds_last();
                self.session.stop()
            } else {
                Some(self.session.report(&report, arrived_s))
            };
            if let Some(order) = order {
                self.protocol.order(&order, &mut self.out);
            }
            self.counts.reports += 1;
            if let Some(last_s) = self.counts.last_clock_s.replace(report.clock_s) {
                let periods = ((report.clock_s - last_s) / self.device.period_s).round();
                self.counts.lost += if (2.0..1e6).contains(&periods) { periods as u64 - 1 } else { 0 };
            }
            self.counts.last_s = arrived_s;
            self.publish();
        }
        Ok(())
    }

    /// Gives the state to the cycle.
    fn publish(&mut self) {
        self.ends.shown.write(*self.session.shown());
        let now_s = self.now_s();
        if now_s - self.counts.shown_s > SHOWN_S {
            self.counts.shown_s = now_s;
            self.publish_traffic(None);
        }
    }

    fn publish_traffic(&self, trouble: Option<Message>) {
        let (counts, shown) = (self.counts, self.session.shown());
        self.ends.traffic.change(|traffic| {
            (traffic.polls, traffic.missed, traffic.failed) = (counts.reports, counts.lost, counts.failed);
            (traffic.away_s, traffic.latency) = (counts.away_s, shown.latency);
            let hindered = shown.hindrance.map(Hindrance::message);
            traffic.trouble = trouble.or(hindered).or(traffic.trouble.take());
        });
    }

    /// Talks until the cell ends; leaves the robot stopped.
    pub(super) fn run(mut self) {
        RealtimeRights::ask_below_cycle();
        while !self.ends.ended.load(Ordering::Acquire) {
            let fault = match self.receive() {
                Ok(()) => {
                    // A control that sends by itself is waited for.
                    let waits = !self.is_connected && !self.socket.is_stream();
                    let limit_s = if self.is_connected { SILENT_S } else { HANDSHAKE_S };
                    let is_silent = !waits && self.now_s() - self.counts.last_s > limit_s;
                    is_silent.then_some(RobotFault::NoReports)
                }
                Err(fault) => Some(fault),
            };
            if let Some(fault) = fault {
                self.reconnect(&fault);
            }
        }
        self.end();
    }

    /// Gives the connection up, and tries once to make it anew.
    fn reconnect(&mut self, fault: &RobotFault) {
        if self.is_connected {
            self.is_connected = false;
            self.session.disconnect();
            self.ends.shown.write(*self.session.shown());
        }
        self.publish_traffic(Some(fault.message()));
        let since_s = self.counts.last_s;
        let opened = Socket::open(&self.device.protocol).and_then(|socket| {
            self.socket = socket;
            self.begin()
        });
        if opened.is_err() && !self.ends.ended.load(Ordering::Acquire) {
            std::thread::sleep(AGAIN);
        }
        self.counts.last_s = self.now_s();
        self.counts.away_s += self.counts.last_s - since_s;
    }

    /// Orders the robot to stop, and waits for its confirmation.
    fn end(mut self) {
        let since_s = self.now_s();
        self.counts.stopped = false;
        while self.is_connected && !self.counts.stopped && self.now_s() - since_s < STOP_S {
            if self.receive().is_err() {
                break;
            }
        }
        // Once more, because the last answer ordered the stop before its confirmation was read.
        let _ = self.is_connected.then(|| self.receive());
        let stopped = self.counts.stopped;
        self.publish_traffic(None);
        self.ends.traffic.change(|traffic| {
            traffic.safe = Some(if stopped { Ok(()) } else { Err(Message::new("cell-robot-not-stopped")) });
        });
    }
}
