use super::wire::{CellRange, Trouble, Wire};
use crate::devices::traffic::TrafficLog;
use crate::executive::Watchdog;
use seamwright_machine::{ModbusDevice, Table};
use seamwright_message::Message;
use std::cell::{Cell, RefCell};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use tokio::sync::Mutex;

/// Interval at which the client checks for changed orders between polls.
pub(super) const LOOK: Duration = Duration::from_millis(1);

/// Shared state of the cycle, its supervisor and the client.
#[derive(Debug, Default)]
pub(super) struct Life {
    /// Number of cycles so far.
    pub(super) cycles: AtomicU64,
    pub(super) ended: AtomicBool,
    /// See [`Punctuality`].
    punctuality: AtomicU8,
    /// The safe outputs were written since the process was cut off.
    safe: AtomicBool,
}

/// Punctuality of the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Punctuality {
    OnTime,
    /// A cycle was late: the watchdog output stands still until the cell is reset.
    Late,
    /// The supervisor has found the cycle stopped: all outputs are safe until the cycle knows that it was late.
    CutOff,
}

impl Life {
    /// Counts a cycle.
    pub(super) fn count_cycle(&self, watchdog: Watchdog) {
        self.cycles.fetch_add(1, Ordering::Release);
        if watchdog.late {
            self.set(Punctuality::Late);
        } else {
            // It fails if the cycle is on time already, or is cut off: its orders then date from before the gap.
            let [late, on_time] = [Punctuality::Late, Punctuality::OnTime].map(|state| state as u8);
            let _ = self.punctuality.compare_exchange(late, on_time, Ordering::AcqRel, Ordering::Relaxed);
        }
    }

    fn set(&self, punctuality: Punctuality) {
        self.punctuality.store(punctuality as u8, Ordering::Release);
    }

    /// Takes the process off until the cycle knows that it was late.
    pub(super) fn cut_off(&self) {
        self.safe.store(false, Ordering::Release);
        self.set(Punctuality::CutOff);
    }

    pub(super) fn is_cut_off(&self) -> bool {
        self.punctuality.load(Ordering::Acquire) == Punctuality::CutOff as u8
    }

    /// Returns true while the watchdog output stands still.
    pub(super) fn is_late(&self) -> bool {
        self.punctuality.load(Ordering::Acquire) != Punctuality::OnTime as u8
    }

    /// Records that the safe outputs were written.
    pub(super) fn confirm_safe(&self) {
        self.safe.store(true, Ordering::Release);
    }

    /// Returns true if the safe outputs were written since the process was cut off.
    pub(super) fn is_safe(&self) -> bool {
        self.safe.load(Ordering::Acquire)
    }
}

/// Shared state of a device's orders and reports; both run in one thread.
#[derive(Debug)]
pub(super) struct Link {
    pub(super) device: ModbusDevice,
    pub(super) life: Arc<Life>,
    pub(super) traffic: TrafficLog,
    /// Connections for orders so far: the best estimate of the device's starts.
    pub(super) starts: Cell<u32>,
    /// Reason why orders are not written; reports do not reflect the orders then.
    pub(super) unordered: RefCell<Option<Trouble>>,
    /// Lost report connections, and how many of them were followed by a rewrite of the orders.
    pub(super) lost: Cell<u32>,
    pub(super) rewritten: Cell<u32>,
}

impl Link {
    pub(super) fn new(device: &ModbusDevice, life: Arc<Life>, traffic: TrafficLog) -> Self {
        Self {
            device: device.clone(),
            life,
            traffic,
            starts: Cell::new(0),
            unordered: RefCell::new(None),
            lost: Cell::new(0),
            rewritten: Cell::new(0),
        }
    }

    pub(super) fn ended(&self) -> bool {
        self.life.ended.load(Ordering::Acquire)
    }

    /// Records trouble.
    pub(super) fn failed(&self, trouble: &Trouble) {
        self.traffic.change(|t| {
            t.failed += 1;
            t.trouble = Some(trouble.message());
        });
    }

    /// Waits for `pause`, or until the end.
    pub(super) async fn rest(&self, pause: Duration) {
        let until = Instant::now() + pause;
        while Instant::now() < until && !self.ended() {
            tokio::time::sleep(LOOK).await;
        }
    }
}

/// A connection that may be lost and that orders and reports may share, served in the order of arrival, request by
/// request.
#[derive(Debug, Clone, Default)]
pub(super) struct Line(Arc<Mutex<Option<Wire>>>);

impl Line {
    pub(super) async fn connect(&self, device: &ModbusDevice) -> Result<(), Trouble> {
        let wire = Wire::connect(device).await?;
        *self.0.lock().await = Some(wire);
        Ok(())
    }

    /// Waits for the answer to the request in transit, if there is one: left on a connection, it would be taken for the
    /// answer to the next request.
    pub(super) async fn answered(&self) {
        drop(self.0.lock().await);
    }

    /// Also true while a request waits for its answer.
    pub(super) fn is_connected(&self) -> bool {
        self.0.try_lock().map_or(true, |wire| wire.is_some())
    }

    /// See [`Wire::read`]. Drops a broken connection.
    pub(super) async fn read(&self, range: CellRange, cells: &mut Vec<u16>) -> Result<(), Trouble> {
        let mut wire = self.0.lock().await;
        let Some(open) = wire.as_mut() else { return Err(unconnected()) };
        let done = open.read(range, cells).await;
        if matches!(done, Err(Trouble::Gone(_))) {
            *wire = None;
        }
        done
    }

    /// See [`Wire::write`]. Drops a broken connection.
    pub(super) async fn write(&self, table: Table, at: u16, cells: &[u16]) -> Result<(), Trouble> {
        let mut wire = self.0.lock().await;
        let Some(open) = wire.as_mut() else { return Err(unconnected()) };
        let done = open.write(table, at, cells).await;
        if matches!(done, Err(Trouble::Gone(_))) {
            *wire = None;
        }
        done
    }
}

fn unconnected() -> Trouble {
    Trouble::Gone(Message::new("cell-modbus-not-connected"))
}
