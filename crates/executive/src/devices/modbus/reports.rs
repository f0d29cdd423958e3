//! Reports of a device: polled, checked for the heart-beat, passed to the cycle with their time.

use super::batches::{Batch, batches};
use super::coding;
use super::link::{LOOK, Line, Link};
use super::orders::BACK_OFF;
use super::wire::Trouble;
use crate::devices::InputBits;
use crate::executive::{SourceReport, VALUES};
use crate::realtime::SteadyTime;
use seamwright_machine::{ModbusDevice, Role};
use seamwright_message::{Message, Unit};
use std::time::{Duration, Instant};
use tokio_modbus::ExceptionCode;
use triple_buffer::Input;

/// A report with its time of reading.
pub(super) type Stamped<T> = Option<(T, SteadyTime)>;

/// Polls all registers.
#[derive(Debug)]
pub(super) struct ReportReader {
    line: Line,
    /// The connection is shared with the orders, which open it.
    shared: bool,
    source: Input<Stamped<SourceReport>>,
    inputs: Input<Stamped<InputBits>>,
    batches: Vec<Batch>,
    bridged: bool,
    /// Value of each register that is read.
    values: Vec<f64>,
    /// Index among the job's process values, for each register of a measured one.
    slots: Vec<Option<usize>>,
    /// Time of the last change of the device's heart-beat.
    heartbeat: SteadyTime,
}

impl ReportReader {
    pub(super) fn new(
        device: &ModbusDevice,
        values: &[String],
        line: Line,
        source: Input<Stamped<SourceReport>>,
        inputs: Input<Stamped<InputBits>>,
    ) -> Self {
        let slot = |role: &Role| match role {
            Role::Actual(name) => values.iter().position(|v| v == name),
            _ => None,
        };
        Self {
            line,
            shared: device.connections == 1,
            source,
            inputs,
            batches: batches(&device.registers, |r| !r.role.is_output(), true),
            bridged: true,
            values: vec![f64::NAN; device.registers.len()],
            slots: device.registers.iter().map(|r| slot(&r.role)).collect(),
            heartbeat: SteadyTime::now(),
        }
    }

    /// Connects, and reads everything once.
    pub(super) async fn connect(&mut self, link: &Link) -> Result<(), Trouble> {
        if !self.shared {
            self.line.connect(&link.device).await?;
        }
        self.heartbeat = SteadyTime::now();
        self.poll(link).await
    }

    /// Polls for ever.
    pub(super) async fn run(&mut self, link: &Link) {
        let period = Duration::from_secs_f64(link.device.poll_s);
        let mut next = Instant::now() + period;
        let mut pause = BACK_OFF.0;
        loop {
            if self.line.is_connected() {
                tokio::time::sleep_until(next.into()).await;
                let polled = self.poll(link).await;
                self.outcome(polled, link);
                next = after(next, period, link);
                continue;
            }
            if self.shared {
                tokio::time::sleep(LOOK).await;
                (next, self.heartbeat) = (Instant::now() + period, SteadyTime::now());
                continue;
            }
            let connected = self.connect(link).await;
            if self.outcome(connected, link) {
                (pause, next) = (BACK_OFF.0, Instant::now() + period);
            } else {
                link.rest(pause).await;
                pause = (2 * pause).min(BACK_OFF.1);
            }
        }
    }

    /// Returns true if the connection works; a lost one is counted for the order writer.
    fn outcome(&self, done: Result<(), Trouble>, link: &Link) -> bool {
        let Err(trouble) = done else { return true };
        link.failed(&trouble);
        let gone = matches!(trouble, Trouble::Gone(_));
        if gone {
            link.lost.set(link.lost.get().wrapping_add(1));
        }
        !gone
    }

    /// Reads everything, and passes it to the cycle if all of it is trustworthy.
    async fn poll(&mut self, link: &Link) -> Result<(), Trouble> {
        let begun = Instant::now();
        let beat = self.heartbeat_value(link);
        match self.read(link).await {
            // A request across a gap may touch missing addresses.
            Err(Trouble::Refused { code: ExceptionCode::IllegalDataAddress, .. }) if self.bridged => {
                self.bridged = false;
                self.batches = batches(&link.device.registers, |r| !r.role.is_output(), false);
                self.read(link).await?;
            }
            other => other?,
        }
        let took = u64::try_from(begun.elapsed().as_nanos()).unwrap_or(u64::MAX);
        if let Some(trouble @ Trouble::Refused { .. }) = link.unordered.borrow().clone() {
            return Err(trouble);
        }
        if self.heartbeat_value(link).map(f64::to_bits) != beat.map(f64::to_bits) {
            self.heartbeat = SteadyTime::now();
        }
        if beat.is_some() && self.heartbeat.elapsed_s() > link.device.heartbeat_s {
            return Err(Trouble::Lifeless(Message::new("cell-modbus-no-heartbeat").value(
                "time",
                link.device.heartbeat_s,
                Unit::S,
            )));
        }
        link.traffic.change(|t| {
            t.polls += 1;
            t.round.add(took, 0);
        });
        // After trouble with orders, reports do not reflect them until they are written anew.
        if link.unordered.borrow().is_none() && link.lost.get() == link.rewritten.get() {
            self.tell(link);
        }
        Ok(())
    }

    async fn read(&mut self, link: &Link) -> Result<(), Trouble> {
        let registers = &link.device.registers;
        let mut cells = Vec::new();
        for batch in &self.batches {
            let read = self.line.read(batch.range, &mut cells).await;
            read.map_err(|trouble| trouble.about(&link.device, batch.registers.iter().map(|(i, _)| *i)))?;
            for (i, from) in &batch.registers {
                self.values[*i] = coding::value(registers[*i].place.word, &cells[*from..]);
            }
        }
        Ok(())
    }

    fn heartbeat_value(&self, link: &Link) -> Option<f64> {
        Some(self.values[link.device.registers.iter().position(|r| r.role == Role::Heartbeat)?])
    }

    /// Passes the values read to the cycle.
    fn tell(&mut self, link: &Link) {
        let starts = link.starts.get();
        let mut inputs = InputBits { bits: 0, starts, age_s: 0.0 };
        let mut source = SourceReport { ready: true, values: [f64::NAN; VALUES], starts, ..SourceReport::default() };
        for ((register, value), slot) in link.device.registers.iter().zip(&self.values).zip(&self.slots) {
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
        let now = SteadyTime::now();
        self.source.write(Some((source, now)));
        self.inputs.write(Some((inputs, now)));
    }
}

/// Returns the next time on the grid of polls; counts those that have passed as missed.
fn after(next: Instant, period: Duration, link: &Link) -> Instant {
    let late = next.elapsed().as_nanos() / period.as_nanos().max(1);
    let late = u32::try_from(late).unwrap_or(u32::MAX);
    link.traffic.change(|t| t.missed += u64::from(late));
    next + period * late.saturating_add(1)
}
