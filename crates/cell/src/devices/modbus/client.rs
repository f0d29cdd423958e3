use super::batches::{Batch, batches};
use super::coding;
use super::image::{Image, Ordered};
use super::traffic::TrafficView;
use super::wire::{Trouble, Wire};
use crate::devices::InputBits;
use crate::executive::{SourceReport, VALUES};
use crate::realtime::Footing;
use seamwright_machine::{ModbusDevice, Role};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tokio_modbus::ExceptionCode;
use triple_buffer::{Input, Output};

/// How often the client looks for changed orders between polls.
const LOOK: Duration = Duration::from_millis(1);
/// Time between tries to connect: the first, doubled each time up to the last.
const BACK_OFF: (Duration, Duration) = (Duration::from_millis(50), Duration::from_secs(1));

/// Signs of life between the cycle and the client.
#[derive(Debug, Default)]
pub(super) struct Life {
    /// Cycles so far.
    pub(super) cycles: AtomicU64,
    /// Nobody needs the client any more.
    pub(super) ended: AtomicBool,
}

/// The client's ends of what it shares with the cycle.
#[derive(Debug)]
pub(super) struct Ends {
    pub(super) orders: Output<Ordered>,
    pub(super) source: Input<SourceReport>,
    pub(super) inputs: Input<InputBits>,
    pub(super) life: Arc<Life>,
    pub(super) traffic: TrafficView,
}

/// What talks to the device, in a thread of its own.
#[derive(Debug)]
pub(super) struct Client {
    device: ModbusDevice,
    ends: Ends,
    wire: Option<Wire>,
    batches: Vec<Batch>,
    bridged: bool,
    image: Image,
    /// Of each register that is read, its value.
    values: Vec<f64>,
    /// Of each register of a measured process value, its place among the job's.
    slots: Vec<Option<usize>>,
    starts: u32,
    /// The cycle's count when it was last seen to change, and when that was.
    cycle: (u64, Option<Instant>),
    /// When the device's heart-beat was last seen to change.
    heartbeat: Instant,
    /// An output could not be written: what is reported would not be what was ordered.
    refused: Option<Trouble>,
}

impl Client {
    /// Not connected yet; `values` are the names of the job's process values.
    pub(super) fn new(device: &ModbusDevice, values: &[String], ends: Ends) -> Self {
        let slot = |role: &Role| match role {
            Role::Actual(name) => values.iter().position(|v| v == name),
            _ => None,
        };
        let now = Instant::now();
        Self {
            ends,
            wire: None,
            batches: batches(&device.registers, |r| !r.role.is_output(), true),
            bridged: true,
            image: Image::new(&device.registers, values),
            values: vec![f64::NAN; device.registers.len()],
            slots: device.registers.iter().map(|r| slot(&r.role)).collect(),
            starts: 0,
            cycle: (0, None),
            heartbeat: now,
            refused: None,
            device: device.clone(),
        }
    }

    /// Connects, brings all outputs to what they shall be, reads everything once.
    ///
    /// # Errors
    /// What went wrong; the connection is gone then.
    pub(super) fn connect(&mut self) -> Result<(), Trouble> {
        self.wire = Some(Wire::connect(&self.device)?);
        self.starts += 1;
        self.image.forget(self.ends.orders.read().offs);
        self.heartbeat = Instant::now();
        let starts = self.starts;
        self.ends.traffic.change(|t| t.connections = starts);
        self.write()?;
        self.refused.clone().map_or(Ok(()), Err)?;
        self.poll()
    }

    /// Polls until nobody needs it any more; leaves the outputs safe.
    pub(super) fn run(mut self) {
        Footing::ask_below_cycle();
        let period = Duration::from_secs_f64(self.device.poll_s);
        let mut next = Instant::now() + period;
        let mut pause = BACK_OFF.0;
        while !self.ends.life.ended.load(Ordering::Acquire) {
            if self.wire.is_none() {
                let begun = Instant::now();
                let connected = self.connect();
                if self.outcome(connected) {
                    (pause, next) = (BACK_OFF.0, Instant::now() + period);
                } else {
                    self.rest(pause);
                    pause = (2 * pause).min(BACK_OFF.1);
                }
                self.ends.traffic.change(|t| t.away_s += begun.elapsed().as_secs_f64());
                continue;
            }
            let due = Instant::now() >= next;
            let done = self.look(due);
            self.outcome(done);
            if due {
                next = self.after(next, period);
            }
            std::thread::sleep(LOOK.min(next.saturating_duration_since(Instant::now())));
        }
        self.end();
    }

    /// The next time on the grid of polls; those that have passed are missed.
    fn after(&self, next: Instant, period: Duration) -> Instant {
        let late = next.elapsed().as_nanos() / period.as_nanos().max(1);
        let late = u32::try_from(late).unwrap_or(u32::MAX);
        self.ends.traffic.change(|t| t.missed += u64::from(late));
        next + period * late.saturating_add(1)
    }

    /// True if all is well; drops the connection if it is not usable any more.
    fn outcome(&mut self, done: Result<(), Trouble>) -> bool {
        let Err(trouble) = done else { return true };
        if matches!(trouble, Trouble::Gone(_)) {
            self.wire = None;
        }
        self.ends.traffic.change(|t| {
            t.failed += 1;
            t.trouble = Some(trouble.to_string());
        });
        self.wire.is_some()
    }

    /// Waits, unless it is to end.
    fn rest(&self, pause: Duration) {
        let until = Instant::now() + pause;
        while Instant::now() < until && !self.ends.life.ended.load(Ordering::Acquire) {
            std::thread::sleep(LOOK);
        }
    }

    /// Passes changed orders on; polls if it is `due`.
    fn look(&mut self, due: bool) -> Result<(), Trouble> {
        let alive = self.cycle_lives();
        let ordered = self.ends.orders.read();
        if alive {
            self.image.order(ordered);
        } else {
            self.image.make_safe(ordered.offs);
        }
        if due && alive {
            self.image.beat();
        }
        // What the device refused is tried again with the next poll, not a thousand times a second.
        if due || self.refused.is_none() {
            self.write()?;
        }
        if due { self.poll() } else { Ok(()) }
    }

    /// True while the cycle was seen to go on within the watchdog's time.
    fn cycle_lives(&mut self) -> bool {
        let count = self.ends.life.cycles.load(Ordering::Acquire);
        if count != self.cycle.0 {
            self.cycle = (count, Some(Instant::now()));
        }
        self.cycle.1.is_some_and(|seen| seen.elapsed().as_secs_f64() <= self.device.watchdog_s)
    }

    /// Writes what changed. What the device refuses does not keep the rest from being written.
    fn write(&mut self) -> Result<(), Trouble> {
        let Some(wire) = &mut self.wire else { return Ok(()) };
        self.refused = None;
        for run in self.image.changes() {
            match wire.write(run.table, run.at, &run.cells) {
                Ok(()) => self.image.written(&run),
                Err(refused @ Trouble::Refused { .. }) => self.refused = Some(refused),
                Err(gone) => return Err(gone),
            }
        }
        Ok(())
    }

    /// Reads everything, and tells the cycle if all of it is to be believed.
    fn poll(&mut self) -> Result<(), Trouble> {
        let begun = Instant::now();
        let beat = self.heartbeat_value();
        match self.read() {
            // A request that goes over a gap may touch what is not there.
            Err(Trouble::Refused { code: ExceptionCode::IllegalDataAddress, .. }) if self.bridged => {
                self.bridged = false;
                self.batches = batches(&self.device.registers, |r| !r.role.is_output(), false);
                self.read()?;
            }
            other => other?,
        }
        let took = u64::try_from(begun.elapsed().as_nanos()).unwrap_or(u64::MAX);
        if let Some(trouble) = self.refused.clone() {
            return Err(trouble);
        }
        if self.heartbeat_value().map(f64::to_bits) != beat.map(f64::to_bits) {
            self.heartbeat = Instant::now();
        }
        if beat.is_some() && self.heartbeat.elapsed().as_secs_f64() > self.device.heartbeat_s {
            return Err(Trouble::Lifeless(format!("no heart-beat for {} s", self.device.heartbeat_s)));
        }
        self.ends.traffic.change(|t| {
            t.polls += 1;
            t.round.add(took, 0);
        });
        self.tell();
        Ok(())
    }

    fn read(&mut self) -> Result<(), Trouble> {
        let Some(wire) = &mut self.wire else { return Ok(()) };
        let mut cells = Vec::new();
        for batch in &self.batches {
            let read = wire.read(batch.table, batch.at, batch.count, &mut cells);
            read.map_err(|trouble| trouble.about(&self.device, batch.registers.iter().map(|(i, _)| *i)))?;
            for (i, from) in &batch.registers {
                self.values[*i] = coding::value(self.device.registers[*i].place.word, &cells[*from..]);
            }
        }
        Ok(())
    }

    fn heartbeat_value(&self) -> Option<f64> {
        let i = self.device.registers.iter().position(|r| r.role == Role::Heartbeat)?;
        Some(self.values[i])
    }

    /// What was read, for the cycle.
    fn tell(&mut self) {
        let mut inputs = InputBits { bits: 0, starts: self.starts };
        let mut source =
            SourceReport { ready: true, values: [f64::NAN; VALUES], starts: self.starts, ..SourceReport::default() };
        for ((register, value), slot) in self.device.registers.iter().zip(&self.values).zip(&self.slots) {
            let is = *value > 0.5;
            match register.role {
                Role::Input(condition) => inputs.bits |= u64::from(is) << condition,
                Role::Ready => source.ready = is,
                Role::Burning => source.burning = is,
                Role::Stuck => source.stuck = is,
                Role::Fault => source.fault = *value as u16,
                Role::Actual(_) => {
                    if let Some(slot) = slot {
                        source.values[*slot] = *value;
                    }
                }
                Role::Gas | Role::On | Role::Watchdog | Role::Set(_) | Role::Heartbeat => {}
            }
        }
        self.ends.source.write(source);
        self.ends.inputs.write(inputs);
    }

    /// Leaves all outputs safe, if the device can be reached.
    fn end(&mut self) {
        let offs = self.ends.orders.read().offs;
        self.image.make_safe(offs);
        if self.wire.is_none() {
            self.wire = Wire::connect(&self.device).ok();
            self.image.forget(offs);
        }
        if let Err(trouble) = self.write() {
            self.ends.traffic.change(|t| t.trouble = Some(trouble.to_string()));
        }
    }
}
