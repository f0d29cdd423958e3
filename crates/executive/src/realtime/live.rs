use super::Shutdown;
use crate::executive::{Ask, Command, Cycle, Note, Orders, Port, Reports, Status};
use rtrb::{Consumer, Producer, RingBuffer};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::ops::Deref;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// A cycle, copied for other threads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Shown {
    /// Status of the executive.
    pub status: Status,
    /// Orders to the devices.
    pub orders: Orders,
    /// Device reports.
    pub reports: Reports,
    /// Number of the cycle, from 1.
    pub cycle: u64,
    /// Number of cycles lost before this one, on a full queue.
    pub lost: u64,
}

impl Deref for Shown {
    type Target = Status;

    fn deref(&self) -> &Status {
        &self.status
    }
}

impl From<&Cycle<'_>> for Shown {
    fn from(c: &Cycle<'_>) -> Self {
        Self { status: c.status, orders: *c.orders, reports: *c.reports, cycle: 0, lost: 0 }
    }
}

/// A note with its time, s.
pub type Noted = (f64, Note);

/// The executive's end of the queues.
#[derive(Debug)]
pub struct LivePort {
    commands: Consumer<Command>,
    cycles: Producer<Shown>,
    notes: Producer<Noted>,
    /// The record has lost data, here or outside.
    failed: Arc<AtomicBool>,
    urgent: Urgent,
    shutdown: Shutdown,
    lost: u64,
    /// Number of the running cycle, from 1.
    cycle: u64,
}

/// A stop or a hold from any thread, ahead of all queues.
#[derive(Debug, Clone, Default)]
pub struct Urgent(Arc<UrgentState>);

#[derive(Debug, Default)]
struct UrgentState {
    /// Number of requests so far, above [`KIND_BITS`] bits of the most severe one that the cycle has not yet taken.
    requested: AtomicU64,
    /// Number of the last request that the cycle has taken, and the cycle in which it acted.
    taken: AtomicU64,
    cycle: AtomicU64,
}

/// Bits of the kind of an urgent request: 0 none, 1 hold, 2 stop.
const KIND_BITS: u32 = 2;
const KIND: u64 = (1 << KIND_BITS) - 1;

/// Number of an urgent request, to see when the cycle has acted on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UrgentRequest(u64);

impl Urgent {
    /// Requests a stop or a hold; `None` for other commands, which go through the queue.
    pub fn ask(&self, ask: &Ask) -> Option<UrgentRequest> {
        let kind = match ask {
            Ask::Stop => 2,
            Ask::Hold => 1,
            _ => return None,
        };
        let next = |before: u64| ((before >> KIND_BITS) + 1) << KIND_BITS | (before & KIND).max(kind);
        let mut before = self.0.requested.load(Ordering::Relaxed);
        loop {
            match self.0.requested.compare_exchange_weak(before, next(before), Ordering::SeqCst, Ordering::Relaxed) {
                Ok(_) => return Some(UrgentRequest(next(before) >> KIND_BITS)),
                Err(newer) => before = newer,
            }
        }
    }

    /// Returns the number of the cycle that acted on `request`, once it has.
    pub fn acted_in(&self, request: UrgentRequest) -> Option<u64> {
        let taken = self.0.taken.load(Ordering::Acquire) >= request.0;
        taken.then(|| self.0.cycle.load(Ordering::Relaxed))
    }

    /// Takes the request in cycle number `cycle`. Wait-free.
    fn take(&self, cycle: u64) -> Option<Command> {
        if self.0.requested.load(Ordering::Relaxed) & KIND == 0 {
            return None;
        }
        let requested = self.0.requested.fetch_and(!KIND, Ordering::SeqCst);
        self.0.cycle.store(cycle, Ordering::Relaxed);
        self.0.taken.store(requested >> KIND_BITS, Ordering::Release);
        match requested & KIND {
            0 => None,
            1 => Some(Command::of(Ask::Hold)),
            _ => Some(Command::of(Ask::Stop)),
        }
    }
}

/// The outside's end of the queues.
#[derive(Debug)]
pub struct Outside {
    /// Commands for the executive.
    pub commands: Producer<Command>,
    /// Its cycles, in order; unread ones fill the queue after two seconds of a 1 ms cycle, and later ones are lost.
    pub cycles: Consumer<Shown>,
    /// Its notes, in order.
    pub notes: Consumer<Noted>,
    failed: Arc<AtomicBool>,
    urgent: Urgent,
}

/// Fill of a queue between an executive and the outside.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct QueueFill {
    /// Its name: `cycles`, `notes`, `commands`.
    pub name: Cow<'static, str>,
    /// Number of items that wait to be read.
    pub waiting: usize,
    /// Maximum number of items.
    pub capacity: usize,
}

impl Outside {
    /// Returns the path for stops and holds ahead of the queue.
    pub fn urgent(&self) -> Urgent {
        self.urgent.clone()
    }

    /// Returns the fill of the queues.
    pub fn queues(&self) -> [QueueFill; 3] {
        let fill = |name: &'static str, waiting, capacity| QueueFill { name: name.into(), waiting, capacity };
        [
            fill("cycles", self.cycles.slots(), CYCLES),
            fill("notes", self.notes.slots(), NOTES),
            fill("commands", COMMANDS - self.commands.slots(), COMMANDS),
        ]
    }

    /// Reports to the executive that the record cannot be written any more.
    pub fn fail(&self) {
        self.failed.store(true, Ordering::Relaxed);
    }

    /// Reports to the executive that a new record has started, without losses so far.
    pub fn mend(&self) {
        self.failed.store(false, Ordering::Relaxed);
    }
}

/// Capacities of the queues.
const COMMANDS: usize = 64;
const CYCLES: usize = 2048;
const NOTES: usize = 1024;

/// Creates queues between an executive and the outside: of fixed size, without locks. `shutdown` ends the executive
/// ahead of all queues.
pub fn live(shutdown: &Shutdown) -> (LivePort, Outside) {
    let (to_executive, commands) = RingBuffer::new(COMMANDS);
    let (cycles, shown) = RingBuffer::new(CYCLES);
    let (notes, noted) = RingBuffer::new(NOTES);
    let failed = Arc::new(AtomicBool::new(false));
    let urgent = Urgent::default();
    let port = LivePort {
        commands,
        cycles,
        notes,
        failed: Arc::clone(&failed),
        urgent: urgent.clone(),
        shutdown: shutdown.clone(),
        lost: 0,
        cycle: 1,
    };
    (port, Outside { commands: to_executive, cycles: shown, notes: noted, failed, urgent })
}

impl LivePort {
    fn loses(&mut self) {
        self.lost += 1;
        self.failed.store(true, Ordering::Relaxed);
    }
}

impl Port for LivePort {
    fn command(&mut self, _t: f64) -> Option<Command> {
        self.urgent.take(self.cycle).or_else(|| self.commands.pop().ok())
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        let shown = Shown { cycle: self.cycle, lost: self.lost, ..Shown::from(cycle) };
        self.cycle += 1;
        if self.cycles.push(shown).is_err() {
            self.loses();
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        if self.notes.push((t, note)).is_err() {
            self.loses();
        }
    }

    fn record_fails(&self) -> bool {
        self.failed.load(Ordering::Relaxed)
    }

    fn shuts_down(&self) -> bool {
        self.shutdown.is_requested()
    }
}
