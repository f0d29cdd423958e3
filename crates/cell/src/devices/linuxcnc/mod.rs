//! LinuxCNC's HAL as the real-time engine of the drives: its `streamer` takes our set-points from a store, its `sampler` says
//! what became of them.
//!
//! LinuxCNC is run as a set of programs and talked to through pipes. What HAL does, and which of its signals the hardware is
//! connected to, is in `docs/linuxcnc.md`.

mod attendant;
mod engine;
mod error;
mod line;
mod programs;
mod script;
mod store;

pub use error::LinuxCncError;

use super::Drives;
use crate::executive::{DriveReport, Orders, Slack};
use attendant::Attendant;
use engine::{Link, Plan};
use line::LONGEST;
pub use line::Sample;
use rtrb::{Consumer, Producer, RingBuffer};
use seamwright_machine::{Axis, Joints, LinuxCnc, Machine};
use std::io::Write as _;
use std::path::Path;
use std::time::{Duration, Instant};
use store::Store;

/// Positions that are remembered until their sample comes.
const SENT: usize = 1024;
/// Age of a report that is still fresh, s, as with other devices beside the cycle: they come every 10 ms, and when HAL, which may
/// have no real-time priority, and the reader get round to it.
const LATE_S: f64 = 0.1;
/// What HAL did in a period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taken {
    /// What it said.
    pub sample: Sample,
    /// The positions that counted, mm and rad.
    pub set: Joints,
    /// When they were ordered.
    pub ordered: Instant,
}

/// What was ordered under a number.
#[derive(Debug, Clone, Copy)]
struct Sent {
    positions: Joints,
    ordered: Instant,
    /// The positions count: with power, and not while references are looked for.
    counts: bool,
}

/// The drives of a machine, by LinuxCNC's HAL. They wait for nothing: whoever exchanges keeps the period.
#[derive(Debug)]
pub struct LinuxCncDrives {
    axes: Vec<Axis>,
    period_s: f64,
    level: u32,
    store: Store,
    buffer: [u8; LONGEST],
    /// What was ordered, by its number: to compare with what was measured.
    sent: Box<[Sent; SENT]>,
    tap: Option<Producer<Taken>>,
    link: Option<Link>,
    /// Set-points find nobody any more.
    broken: bool,
    /// Starvations before the first set-point count for nothing.
    underruns: Option<u32>,
    /// How often HAL was started.
    starts: u32,
    attendant: Attendant,
}

impl LinuxCncDrives {
    /// Starts HAL with the streams, and with the hardware of the user's HAL file, looked for in `folder`, or axes without any.
    /// Takes about a second. If it ends, by whatever, it is started again, without power; `tell` is told in words.
    ///
    /// # Errors
    /// LinuxCNC is not installed, runs already, does not take the file, or does not run; all says what is allowed.
    pub fn start(
        machine: &Machine,
        device: &LinuxCnc,
        folder: &Path,
        tell: impl Fn(&str) + Send + 'static,
    ) -> Result<Self, LinuxCncError> {
        let (attendant, link) = Attendant::start(Plan::new(machine, device, folder)?, tell)?;
        Ok(Self {
            axes: machine.axes.clone(),
            period_s: machine.servo_period_s,
            level: device.store,
            store: Store::new(device.store, machine.servo_period_s),
            buffer: [0; LONGEST],
            sent: Box::new([Sent { positions: Joints::default(), ordered: Instant::now(), counts: false }; SENT]),
            tap: None,
            link: Some(link),
            broken: false,
            underruns: None,
            starts: 1,
            attendant,
        })
    }

    /// Everything that HAL did from now on, period by period; lost if nobody takes it while there is no room for `room` of it.
    pub fn tap(&mut self, room: usize) -> Consumer<Taken> {
        let (to, taken) = RingBuffer::new(room);
        self.tap = Some(to);
        taken
    }

    /// HAL that was started again counts as soon as nobody wants power: nothing comes on by itself.
    fn take_started(&mut self, power: bool) {
        if power {
            return;
        }
        while let Ok(link) = self.attendant.started.pop() {
            if let Some(old) = self.link.replace(link) {
                // They are dropped as soon as they come: there is room.
                let _ = self.attendant.ended.push(old);
            }
            self.store = Store::new(self.level, self.period_s);
            (self.broken, self.underruns, self.starts) = (false, None, self.starts + 1);
        }
    }

    /// Gives the orders of a period.
    fn order(&mut self, orders: &Orders) {
        let Self { store, buffer, sent, link, axes, broken, .. } = self;
        store.feed(&orders.set, |number, positions| {
            let counts = orders.power && !orders.home;
            sent[number as usize % SENT] = Sent { positions: *positions, ordered: Instant::now(), counts };
            let line = line::write(buffer, axes, number, orders, positions);
            // All of it or nothing: it is shorter than what a pipe takes at once. One that does not fit is missing in store,
            // which is noticed there; a pipe without a reader is the end.
            let written = link.as_mut().filter(|_| !*broken).map_or(Ok(0), |link| link.stream.write(line));
            *broken |= written.is_err_and(|error| error.kind() != std::io::ErrorKind::WouldBlock);
        });
    }

    fn report(&mut self, report: &mut DriveReport) {
        report.age_s += self.period_s;
        let mut newest = None;
        while let Some(Ok(sample)) = self.link.as_mut().map(|link| link.samples.pop()) {
            self.store.seen(sample.number, sample.level);
            newest = Some(sample);
            if let Some(tap) = &mut self.tap {
                let Sent { positions: set, ordered, .. } = self.sent[sample.number as usize % SENT];
                // Without room it is lost, as said.
                let _ = tap.push(Taken { sample, set, ordered });
            }
        }
        // Drives that take no orders are none.
        let Some(sample) = newest.filter(|_| !self.broken) else { return };
        report.age_s = sample.read.elapsed().as_secs_f64();
        report.powered = sample.powered;
        (report.fault, report.limit_switch, report.referenced) = (sample.fault, sample.limit, sample.homed);
        report.position = sample.position;
        let sent = &self.sent[sample.number as usize % SENT];
        for i in 0..self.axes.len() {
            // Without power, and while references are looked for, nobody follows.
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

    /// What is in store, but for the one that counts and the one on its way.
    fn rides_out(&self) -> Slack {
        Slack::stored(self.level - 1)
    }

    fn late_s(&self) -> f64 {
        LATE_S
    }
}

impl Drop for LinuxCncDrives {
    /// Without power, then everything stopped and cleared up.
    fn drop(&mut self) {
        // Nobody can be told if it fails; HAL's watchdog takes the power then.
        self.order(&Orders { set: self.store.last(), ..Orders::default() });
        if self.link.is_some() && !self.broken {
            std::thread::sleep(Duration::from_secs_f64(f64::from(self.level + 5) * self.period_s));
        }
        self.attendant.end(self.link.take());
    }
}
