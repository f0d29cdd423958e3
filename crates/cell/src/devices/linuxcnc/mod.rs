//! LinuxCNC's HAL as the real-time engine of the drives: its `streamer` takes our set-points from a store, its `sampler` says
//! what became of them.
//!
//! LinuxCNC is run as a set of programs and talked to through pipes. What HAL does, and which of its signals the hardware is
//! connected to, is in `docs/linuxcnc.md`.

mod error;
mod line;
mod programs;
mod script;
mod store;

pub use error::LinuxCncError;

use super::Drives;
use crate::executive::{DriveReport, Orders};
use crate::realtime::Footing;
use line::LONGEST;
pub use line::Sample;
use programs::{Commands, Keeper, Program, User};
use rtrb::{Consumer, Producer, RingBuffer};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use seamwright_machine::{Axis, Joints, LinuxCnc, Machine};
use std::io::{BufRead as _, BufReader, Write as _};
use std::path::Path;
use std::process::{ChildStdin, ChildStdout};
use std::time::{Duration, Instant};
use store::Store;

/// Samples that fit between the reader and the cycle.
const SAMPLES: usize = 1024;
/// Positions that are remembered until their sample comes.
const SENT: usize = 1024;
/// Age of a report that is still fresh, s, as with other devices beside the cycle: they come every 10 ms, and when HAL, which may
/// have no real-time priority, and the reader get round to it.
const LATE_S: f64 = 0.1;
/// Longest time until the first sample.
const FIRST: Duration = Duration::from_secs(3);

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
    samples: Consumer<Sample>,
    tap: Option<Producer<Taken>>,
    /// Set-points go in here; none once it has failed.
    stream: Option<ChildStdin>,
    /// Starvations before the first set-point count for nothing.
    underruns: Option<u32>,
    streamer: Program,
    sampler: Program,
    keeper: Keeper,
}

impl LinuxCncDrives {
    /// Starts HAL with the streams, and with the hardware of the user's HAL file, looked for in `folder`, or axes without any.
    /// Takes about a second.
    ///
    /// # Errors
    /// LinuxCNC is not installed, runs already, does not take the file, or does not run; all says what is allowed.
    pub fn start(machine: &Machine, device: &LinuxCnc, folder: &Path) -> Result<Self, LinuxCncError> {
        let user = User::find()?;
        programs::alone(&user)?;
        let keeper = Keeper::start(&user)?;
        let owner = programs::owner(std::process::id());
        programs::take(&user, Commands::Ours(&script::before(machine, device, &owner)))?;
        match &device.hal {
            None => programs::take(&user, Commands::Ours(&script::simulated(machine)))?,
            Some(hal) => {
                let path = std::path::absolute(folder.join(hal))?;
                programs::take(&user, Commands::File(&path))?;
            }
        }
        programs::take(&user, Commands::Ours(script::AFTER))?;
        let mut streamer = programs::start(&user, "halstreamer", &[], true)?;
        // It would keep what it says until there are 4 KB of it.
        let mut sampler = programs::start(&user, "stdbuf", &["-oL", "halsampler"], true)?;
        let stream = streamer.stdin();
        if let Some(stream) = &stream {
            fcntl_setfl(stream, fcntl_getfl(stream).map_err(std::io::Error::from)? | OFlags::NONBLOCK)
                .map_err(std::io::Error::from)?;
        }
        let (to, samples) = RingBuffer::new(SAMPLES);
        if let Some(stdout) = sampler.stdout() {
            let axes = machine.axes.clone();
            std::thread::spawn(move || listen(stdout, &axes, to));
        }
        let drives = Self {
            axes: machine.axes.clone(),
            period_s: machine.servo_period_s,
            level: device.store,
            store: Store::new(device.store, machine.servo_period_s),
            buffer: [0; LONGEST],
            sent: Box::new([Sent { positions: Joints::default(), ordered: Instant::now(), counts: false }; SENT]),
            samples,
            tap: None,
            stream,
            underruns: None,
            streamer,
            sampler,
            keeper,
        };
        drives.wait_for_samples()?;
        Ok(drives)
    }

    /// Everything that HAL did from now on, period by period; lost if nobody takes it while there is no room for `room` of it.
    pub fn tap(&mut self, room: usize) -> Consumer<Taken> {
        let (to, taken) = RingBuffer::new(room);
        self.tap = Some(to);
        taken
    }

    fn wait_for_samples(&self) -> Result<(), LinuxCncError> {
        let begun = Instant::now();
        while self.samples.is_empty() {
            if self.samples.is_abandoned() || begun.elapsed() > FIRST {
                let said = format!("{}; {}", self.sampler.said(), self.keeper.said());
                return Err(LinuxCncError::Failed { what: "does not run: no sample comes", said });
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(())
    }

    /// Gives the orders of a period.
    fn order(&mut self, orders: &Orders) {
        let Self { store, buffer, sent, stream, axes, .. } = self;
        let mut lost = stream.is_none();
        store.feed(&orders.set, |number, positions| {
            let counts = orders.power && !orders.home;
            sent[number as usize % SENT] = Sent { positions: *positions, ordered: Instant::now(), counts };
            let line = line::write(buffer, axes, number, orders, positions);
            // All of it or nothing: it is shorter than what a pipe takes at once. One that does not fit is missing in store,
            // which is noticed there; a pipe without a reader is the end.
            let written = stream.as_mut().map_or(Ok(0), |stream| stream.write(line));
            lost |= written.is_err_and(|error| error.kind() != std::io::ErrorKind::WouldBlock);
        });
        if lost {
            *stream = None;
        }
    }

    fn report(&mut self, report: &mut DriveReport) {
        report.age_s += self.period_s;
        let mut newest = None;
        while let Ok(sample) = self.samples.pop() {
            self.store.seen(sample.number, sample.level);
            newest = Some(sample);
            if let Some(tap) = &mut self.tap {
                let Sent { positions: set, ordered, .. } = self.sent[sample.number as usize % SENT];
                // Without room it is lost, as said.
                let _ = tap.push(Taken { sample, set, ordered });
            }
        }
        // Drives that take no orders are none.
        let Some(sample) = newest.filter(|_| self.stream.is_some()) else { return };
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
        report.starts = 1;
        if sample.number > 0 {
            let before = *self.underruns.get_or_insert(sample.underruns);
            report.starved = sample.underruns.wrapping_sub(before);
        }
    }
}

impl Drives for LinuxCncDrives {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        self.order(orders);
        self.report(report);
    }

    /// What is in store, but for the one that counts and the one on its way.
    fn rides_out(&self) -> u32 {
        self.level - 1
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
        if self.stream.take().is_some() {
            std::thread::sleep(Duration::from_secs_f64(f64::from(self.level + 5) * self.period_s));
        }
        self.streamer.end(Duration::from_secs(1));
        self.keeper.end();
        self.sampler.end(Duration::from_millis(100));
    }
}

/// Reads what HAL says until it ends.
fn listen(from: ChildStdout, axes: &[Axis], mut to: Producer<Sample>) {
    Footing::ask_below_cycle();
    let mut from = BufReader::new(from);
    let mut text = String::new();
    while !to.is_abandoned() {
        text.clear();
        match from.read_line(&mut text) {
            Ok(1..) => {
                if let Some(sample) = line::read(&text, axes, Instant::now()) {
                    // Nobody took the last second of them: a newer one comes.
                    let _ = to.push(sample);
                }
            }
            _ => break,
        }
    }
}
