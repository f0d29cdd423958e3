use super::client::Life;
use super::traffic::TrafficLog;
use super::wire::{Trouble, Wire};
use seamwright_machine::{ModbusDevice, Table};
use std::cell::{Cell, RefCell};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};
use tokio::sync::Mutex;

/// How often the client looks for changed orders between polls.
pub(super) const LOOK: Duration = Duration::from_millis(1);

/// What orders and reports of a device tell each other; both are in one thread.
#[derive(Debug)]
pub(super) struct Link {
    pub(super) device: ModbusDevice,
    pub(super) life: Arc<Life>,
    pub(super) traffic: TrafficLog,
    /// Connections for orders so far: how often the device has started, as far as anybody can tell.
    pub(super) starts: Cell<u32>,
    /// Why the device has not got what was ordered: what it reports would not be what was ordered.
    pub(super) unordered: RefCell<Option<Trouble>>,
    /// Connections for reports that were lost, and for how many of them orders were written anew since.
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

    /// Nobody needs the client any more.
    pub(super) fn ended(&self) -> bool {
        self.life.ended.load(Ordering::Acquire)
    }

    /// Notes what went wrong.
    pub(super) fn failed(&self, trouble: &Trouble) {
        self.traffic.change(|t| {
            t.failed += 1;
            t.trouble = Some(trouble.to_string());
        });
    }

    /// Waits, unless it is to end.
    pub(super) async fn rest(&self, pause: Duration) {
        let until = Instant::now() + pause;
        while Instant::now() < until && !self.ended() {
            tokio::time::sleep(LOOK).await;
        }
    }
}

/// A connection that may be lost, and that orders and reports may share: who asks first is served first, request by request.
#[derive(Debug, Clone, Default)]
pub(super) struct Line(Arc<Mutex<Option<Wire>>>);

impl Line {
    /// Connects.
    pub(super) async fn connect(&self, device: &ModbusDevice) -> Result<(), Trouble> {
        let wire = Wire::connect(device).await?;
        *self.0.lock().await = Some(wire);
        Ok(())
    }

    /// True also while a request waits for its answer.
    pub(super) fn is_connected(&self) -> bool {
        self.0.try_lock().map_or(true, |wire| wire.is_some())
    }

    /// See [`Wire::read`]. A connection that cannot be used any more is dropped.
    pub(super) async fn read(
        &self,
        (table, at, count): (Table, u16, u16),
        cells: &mut Vec<u16>,
    ) -> Result<(), Trouble> {
        let mut wire = self.0.lock().await;
        let Some(open) = wire.as_mut() else { return Err(unconnected()) };
        let done = open.read(table, at, count, cells).await;
        if matches!(done, Err(Trouble::Gone(_))) {
            *wire = None;
        }
        done
    }

    /// See [`Wire::write`]. A connection that cannot be used any more is dropped.
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
    Trouble::Gone("not connected".to_owned())
}
