//! Messages between a panel and its cell.
//!
//! Each message is one frame: its length in 4 bytes (little-endian), then MessagePack with named fields. Frames are
//! bounded by [`MAX_REQUEST`] and [`MAX_REPORT`]; a longer one, or one that does not decode, ends the connection. The
//! first message of each side carries [`VERSION`].

use crate::program::Program;
pub use crate::recorder::RecordStart;
use seamwright_executive::devices::Traffic;
use seamwright_executive::realtime::{Noted, QueueFill, RealtimeRights, Shown};
use seamwright_executive::{Command, Raised};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// Version of the protocol. Both sides must have the same: they are one program, but one may have been replaced.
pub const VERSION: u32 = 3;
/// Maximum size of a request, bytes: a program with its motion.
pub const MAX_REQUEST: usize = 64 << 20;
/// Maximum size of a report, bytes: the first one has a program.
pub const MAX_REPORT: usize = MAX_REQUEST + (1 << 20);
/// The panel counts as lost without a request for this long, s. It sends [`Request::Beat`] ten times as often.
pub const PANEL_LOST_S: f64 = 1.0;
/// The cell counts as frozen without a cycle for this long, s.
pub const CELL_SILENT_S: f64 = 1.0;

/// A message of the panel to its cell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// First message.
    Hello {
        /// See [`VERSION`].
        version: u32,
    },
    /// The panel lives.
    Beat,
    /// A command for the executive. Stops and holds also have a line of their own: [`crate::StopLine`].
    Command(Command),
    /// A program for the executive, which takes it at rest. Answered by [`Report::Prepared`]; if that is positive, the
    /// executive accepts or refuses [`seamwright_executive::Ask::Load`] in a note.
    Load(Box<Program>),
    /// A weld that has begun is to be recorded. Cycles from its start on are in the record.
    Record(Box<RecordStart>),
    /// A weld has no record: an alarm, while it runs.
    NoRecord {
        /// See [`Report::WeldBegins`].
        start: u64,
    },
    /// Process off, axes at rest, power off, devices safe; then the cell ends.
    Shutdown,
}

/// A message of a cell to its panel.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub enum Report {
    /// First message.
    Hello {
        /// See [`VERSION`].
        version: u32,
        /// Number of the cell's process.
        process: u32,
        /// See [`crate::fingerprint`].
        machine: String,
        /// The program of the cell, if it has one: only after the start of a second panel.
        program: Option<Box<Program>>,
        /// Alarms that are listed.
        alarms: Vec<Raised>,
        /// Number in the library of the last weld, while its files are open.
        recording: Option<i64>,
        /// The start of the weld that runs, if no panel has asked for its record.
        unrecorded: Option<u64>,
        /// Numbers of all welds whose files are open, or about to be.
        open: Vec<i64>,
    },
    /// A cycle, in order. Cycles that the panel does not read in time are left out: their numbers have gaps.
    Cycle(Box<Shown>),
    /// A note, in order.
    Note(Noted),
    /// Real-time rights of the cycle.
    Rights(RealtimeRights),
    /// Traffic with each real device, by name.
    Lines(Vec<(String, Traffic)>),
    /// Fill of the queues to and from the cycle: the maximum since the last report.
    Queues(Vec<QueueFill>),
    /// Outcome of preparing the program with this number.
    Prepared {
        /// See [`Program::number`].
        number: u32,
        /// Why it cannot be run.
        outcome: Result<(), Unprepared>,
    },
    /// A weld has begun; its note came before. Answered by [`Request::Record`] or [`Request::NoRecord`].
    WeldBegins {
        /// The cell's number of this start.
        start: u64,
    },
    /// Rows of a record are lost; reported once for each record.
    RecordFails {
        /// Why.
        why: Message,
    },
    /// The files of this weld are written and free: its record can be closed.
    Recorded {
        /// Its number in the library.
        weld: i64,
    },
    /// The real devices of the last program are released, so that others can be connected: until then the cell has the
    /// machine of the program that is being prepared, on simulated devices and without a program.
    DevicesReleased,
    /// A released device has confirmed its safe outputs, or has not.
    Released {
        /// Name of the device.
        device: String,
        /// Why its outputs may be on.
        outcome: Result<(), Message>,
    },
    /// The cycle has ended in order: devices are released and records saved next, which takes some seconds at most.
    Ending,
    /// The cell has ended: the cycle stands, all devices are released.
    Ended {
        /// True if the cycle panicked.
        failed: bool,
    },
}

/// Reasons why a program was not given to the executive.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Unprepared {
    /// Another program is being prepared.
    Busy,
    /// It needs other devices than those connected: the cell must be off.
    NeedsOff,
    /// The program or a file beside it is invalid, or has changed since it was planned.
    Invalid(Message),
    /// Its devices cannot be connected.
    Devices(Message),
}
