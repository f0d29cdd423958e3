//! LinuxCNC's HAL as the real-time engine of the drives. Its `streamer` takes our set-points from a store, its
//! `sampler` reports the result.
//!
//! LinuxCNC runs as a set of programs, connected through pipes. `docs/reference/linuxcnc.md` describes HAL's task and the signals
//! for the hardware.
//!
//! The cycle writes a line and reads samples. `store.rs` alone decides the number of positions that go out in a cycle;
//! the level that it keeps is HAL's own count. The HAL session lives in a `halrun` that reads our pipe: if this program
//! ends in any way, the pipe closes and HAL ends too.

mod engine;
mod error;
mod programs;
mod script;
mod store;
mod stream_line;
mod supervisor;

pub use error::{LinuxCncError, Symptom};

use super::Drives;
use crate::executive::{DriveReport, Orders, Slack};
use crate::realtime::SteadyTime;
use engine::{Link, Plan};
use rtrb::{Consumer, Producer, RingBuffer};
use seamwright_machine::{Axis, Joints, LinuxCnc, Machine};
use seamwright_message::Message;
use std::io::Write as _;
use std::path::Path;
use std::time::Duration;
use store::Store;
use stream_line::LONGEST;
pub use stream_line::Sample;
use supervisor::Supervisor;

/// Number of sent positions that wait for their sample.
const SENT: usize = 1024;
/// Maximum age of a fresh report, s, as with other devices beside the cycle. Reports come every 10 ms, plus the delays
/// of HAL, which may have no real-time priority, and of the reader.
const LATE_S: f64 = 0.1;
/// HAL's state in a period, with its set-point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken {
    /// The sample from HAL.
    pub sample: Sample,
    /// The active set-point positions, mm and rad.
    pub set: Joints,
    /// Time of the order.
    pub ordered: SteadyTime,
}

/// Order with a given number.
#[derive(Debug, Clone, Copy)]
struct Sent {
    positions: Joints,
    ordered: SteadyTime,
    /// The drives follow the positions: with power, and not during homing.
    counts: bool,
}

/// The drives of a machine, by LinuxCNC's HAL. An exchange does not wait: the caller keeps the period.
#[derive(Debug)]
pub struct LinuxCncDrives {
    axes: Vec<Axis>,
    period_s: f64,
    level: u32,
    store: Store,
    buffer: [u8; LONGEST],
    /// Orders by number, to compare with the measured positions.
    sent: Box<[Sent; SENT]>,
    tap: Option<Producer<Taken>>,
    link: Option<Link>,
    /// The stream of set-points has no reader.
    broken: bool,
    /// Underruns before the first set-point, which are not reported.
    underruns: Option<u32>,
    /// Number of starts of HAL.
    starts: u32,
    /// Time of reading of the last report.
    read: Option<SteadyTime>,
    supervisor: Supervisor,
}

impl LinuxCncDrives {
    /// Starts HAL with the streams and the hardware of the user's HAL file, found in `folder`, or axes without
    /// hardware. Takes about a second. After any end HAL is restarted without power; the callback receives a message.
    ///
    /// # Errors
    /// LinuxCNC is not installed, runs already, rejects the file, or does not run; each error names the cure.
    pub fn start(
        machine: &Machine,
        device: &LinuxCnc,
        folder: &Path,
        tell: impl Fn(&Message) + Send + 'static,
    ) -> Result<Self, LinuxCncError> {
        let (supervisor, link) = Supervisor::start(Plan::new(machine, device, folder)?, tell)?;
        Ok(Self {
            axes: machine.axes.clone(),
            period_s: machine.servo_period_s,
            level: device.store,
            store: Store::new(device.store, machine.servo_period_s),
            buffer: [0; LONGEST],
            sent: Box::new([Sent { positions: Joints::default(), ordered: SteadyTime::now(), counts: false }; SENT]),
            tap: None,
            link: Some(link),
            broken: false,
            underruns: None,
            starts: 1,
            read: None,
            supervisor,
        })
    }

    /// Returns a stream of all later periods of HAL; periods that do not fit in `room` unread ones are lost.
    pub fn tap(&mut self, room: usize) -> Consumer<Taken> {
        let (to, taken) = RingBuffer::new(room);
        self.tap = Some(to);
        taken
    }

    /// Connects to a restarted HAL once power is ordered off: nothing switches on by itself.
    fn take_started(&mut self, power: bool) {
        if power {
            return;
        }
        while let Ok(link) = self.supervisor.started.pop() {
            if let Some(old) = self.link.replace(link) {
                // There is room: the thread drops them as soon as they come.
                let _ = self.supervisor.ended.push(old);
            }
            self.store = Store::new(self.level, self.period_s);
            (self.broken, self.underruns, self.starts) = (false, None, self.starts + 1);
        }
    }

    fn order(&mut self, orders: &Orders) {
        let Self { store, buffer, sent, link, axes, broken, .. } = self;
        store.feed(&orders.set, |number, positions| {
            let counts = orders.power && !orders.home;
            sent[number as usize % SENT] = Sent { positions: *positions, ordered: SteadyTime::now(), counts };
            let line = stream_line::write(buffer, axes, number, orders, positions);
            // Written whole or not at all: a line is shorter than the pipe's atomic write. The store detects a line
            // that did not fit. A pipe without a reader marks the link as broken.
            let written = link.as_mut().filter(|_| !*broken).map_or(Ok(0), |link| link.stream.write(line));
            *broken |= written.is_err_and(|error| error.kind() != std::io::ErrorKind::WouldBlock);
        });
    }

    fn report(&mut self, report: &mut DriveReport) {
        let mut newest = None;
        while let Some(Ok(sample)) = self.link.as_mut().map(|link| link.samples.pop()) {
            self.store.seen(sample.number, sample.level);
            newest = Some(sample);
            if let Some(tap) = &mut self.tap {
                let Sent { positions: set, ordered, .. } = self.sent[sample.number as usize % SENT];
                // Lost if there is no room, as documented.
                let _ = tap.push(Taken { sample, set, ordered });
            }
        }
        // A broken link counts as silent drives.
        let newest = newest.filter(|_| !self.broken);
        self.read = newest.map(|sample| sample.read).or(self.read);
        report.age_s = self.read.map_or(f64::INFINITY, SteadyTime::elapsed_s);
        let Some(sample) = newest else { return };
        report.powered = sample.powered;
        (report.fault, report.limit_switch, report.referenced) = (sample.fault, sample.limit, sample.homed);
        report.position = sample.position;
        let sent = &self.sent[sample.number as usize % SENT];
        for i in 0..self.axes.len() {
            // Without power, and during homing, there is no following error.
            report.following_error[i] =
                if sent.counts && sample.powered { sent.positions[i] - sample.position[i] } else { 0.0 };
        }
        report.starts = self.starts;
        if sample.number > 0 {
            let before = *self.underruns.get_or_insert(sample.underruns);
            report.starved = sample.underruns.wrapping_sub(before);
        }
    }
}

impl Drives for LinuxCncDrives {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        self.take_started(orders.power);
        self.order(orders);
        self.report(report);
    }

    /// The stored set-points, except the active one and the one in transit.
    fn rides_out(&self) -> Slack {
        Slack::stored(self.level - 1)
    }

    fn late_s(&self) -> f64 {
        LATE_S
    }
}

impl Drop for LinuxCncDrives {
    /// Switches the power off, then stops and clears up everything.
    fn drop(&mut self) {
        // A failure cannot be reported here; HAL's watchdog then switches the power off.
        self.order(&Orders { set: self.store.last(), ..Orders::default() });
        if self.link.is_some() && !self.broken {
            std::thread::sleep(Duration::from_secs_f64(f64::from(self.level + 5) * self.period_s));
        }
        self.supervisor.end(self.link.take());
    }
}
