//! Orders to a device: those of the cycle, and safe states when the cycle stops.

use super::image::{Image, Ordered};
use super::link::{LOOK, Line, Link};
use super::wire::{Trouble, within};
use crate::realtime::SteadyTime;
use seamwright_machine::ModbusDevice;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};
use triple_buffer::Output;

/// First and last delay between attempts to connect; it doubles each time.
pub(super) const BACK_OFF: (Duration, Duration) = (Duration::from_millis(50), Duration::from_secs(1));
/// Time limit for safe outputs at the end; a failure is reported.
const END: Duration = Duration::from_secs(3);

/// Writes orders to the device.
#[derive(Debug)]
pub(super) struct OrderWriter {
    line: Line,
    ordered: Output<Ordered>,
    image: Image,
    /// The cycle count at its last change, and the time of that change.
    cycle: (u64, Option<SteadyTime>),
    /// Next time to retry refused outputs and to advance the watchdog.
    next: Instant,
}

impl OrderWriter {
    pub(super) fn new(device: &ModbusDevice, values: &[String], line: Line, ordered: Output<Ordered>) -> Self {
        let image = Image::new(&device.registers, values);
        Self { line, ordered, image, cycle: (0, None), next: Instant::now() }
    }

    /// Connects and brings all outputs to their safe states.
    pub(super) async fn connect(&mut self, link: &Link) -> Result<(), Trouble> {
        self.line.connect(&link.device).await?;
        let starts = link.starts.get() + 1;
        link.starts.set(starts);
        link.traffic.change(|t| t.connections = starts);
        self.image.forget(self.ordered.read().offs);
        self.write(link).await
    }

    /// Writes orders until the end; nothing is in transit on their connection then.
    pub(super) async fn run(&mut self, link: &Link) {
        let period = Duration::from_secs_f64(link.device.poll_s);
        let mut pause = BACK_OFF.0;
        while !link.ended() {
            if self.line.is_connected() {
                if let Err(trouble) = self.look(link, period).await {
                    link.failed(&trouble);
                    *link.unordered.borrow_mut() = Some(trouble);
                }
                tokio::time::sleep(LOOK).await;
                continue;
            }
            let begun = Instant::now();
            match self.connect(link).await {
                Ok(()) => pause = BACK_OFF.0,
                Err(trouble) => {
                    link.failed(&trouble);
                    *link.unordered.borrow_mut() = Some(trouble);
                    link.rest(pause).await;
                    pause = (2 * pause).min(BACK_OFF.1);
                }
            }
            link.traffic.change(|t| t.away_s += begun.elapsed().as_secs_f64());
        }
        self.line.answered().await;
    }

    /// Writes changed orders.
    async fn look(&mut self, link: &Link, period: Duration) -> Result<(), Trouble> {
        let is_cut_off = link.life.is_cut_off();
        let due = Instant::now() >= self.next;
        if due {
            self.next = Instant::now() + period;
            if self.cycle_lives(link) && !link.life.is_late() {
                self.image.beat();
            }
        }
        // Retry refused outputs with the next poll, not a thousand times a second.
        if !due && link.unordered.borrow().is_some() {
            return self.switch_off(link).await;
        }
        let lost = link.lost.get();
        if lost != link.rewritten.get() {
            // The device may have restarted; in that case this write shows that the connection is dead.
            self.image.rewrite();
        }
        self.write(link).await?;
        link.rewritten.set(lost);
        if is_cut_off && link.unordered.borrow().is_none() {
            link.life.confirm_safe();
        }
        Ok(())
    }

    /// Switches arc or beam off at once if ordered, while refused outputs wait for the next poll.
    async fn switch_off(&mut self, link: &Link) -> Result<(), Trouble> {
        self.order(link);
        let Some(run) = self.image.off() else { return Ok(()) };
        match self.line.write(run.table, run.at, &run.cells).await {
            Ok(()) => self.image.written(&run),
            Err(trouble @ Trouble::Refused { .. }) => {
                self.image.refused(&run);
                *link.unordered.borrow_mut() = Some(trouble);
            }
            Err(gone) => return Err(gone),
        }
        Ok(())
    }

    /// Takes the newest orders, or safe states if the cycle has stopped.
    fn order(&mut self, link: &Link) {
        let alive = self.cycle_lives(link);
        let ordered = self.ordered.read();
        if alive {
            self.image.order(ordered);
        } else {
            self.image.make_safe(ordered.offs);
        }
    }

    /// Returns true if the cycle count changed within the watchdog's time, and the supervisor has not cut it off.
    fn cycle_lives(&mut self, link: &Link) -> bool {
        let count = link.life.cycles.load(Ordering::Acquire);
        if count != self.cycle.0 {
            self.cycle = (count, Some(SteadyTime::now()));
        }
        let lives = self.cycle.1.is_some_and(|seen| seen.elapsed_s() <= link.device.watchdog_s);
        lives && !link.life.is_cut_off()
    }

    /// Writes changes, each output once, with the newest orders before each request, so that an off order waits for at
    /// most one answer. Refused outputs do not block the rest.
    async fn write(&mut self, link: &Link) -> Result<(), Trouble> {
        let (mut tried, mut refused) = (Vec::new(), None);
        loop {
            self.order(link);
            let Some(run) = self.image.changes().into_iter().find(|run| !tried.contains(&run.units)) else { break };
            match self.line.write(run.table, run.at, &run.cells).await {
                Ok(()) => self.image.written(&run),
                Err(trouble @ Trouble::Refused { .. }) => {
                    self.image.refused(&run);
                    refused = Some(trouble);
                }
                Err(gone) => return Err(gone),
            }
            tried.push(run.units);
        }
        *link.unordered.borrow_mut() = refused;
        Ok(())
    }

    /// Sets all outputs to their safe states, if the device can be reached, and reports the result.
    pub(super) async fn end(&mut self, link: &Link) {
        let safe = tokio::time::timeout(END, self.make_safe(link)).await;
        let safe = safe.unwrap_or_else(|_| Err(Trouble::Gone(within("cell-modbus-no-answer", END))));
        let refused = link.unordered.borrow().clone();
        let safe = safe.and(refused.map_or(Ok(()), Err)).map_err(|trouble| trouble.message());
        link.traffic.change(|t| {
            if let Err(why) = &safe {
                t.trouble = Some(why.clone());
            }
            t.safe = Some(safe);
        });
    }

    async fn make_safe(&mut self, link: &Link) -> Result<(), Trouble> {
        // From here on the cycle counts as stopped: orders are those of safe states.
        self.cycle = (link.life.cycles.load(Ordering::Acquire), None);
        if !self.line.is_connected() {
            self.line.connect(&link.device).await?;
        }
        // Everything once more: only an answer from now on is a confirmation.
        self.image.forget(self.ordered.read().offs);
        match self.write(link).await {
            // The connection was lost unnoticed: try once more on a new one.
            Err(Trouble::Gone(_)) => {
                self.line.connect(&link.device).await?;
                self.image.forget(self.ordered.read().offs);
                self.write(link).await
            }
            done => done,
        }
    }
}
