//! The executive: runs a cell cycle by cycle, from power-on to the end of a weld and after every fault.
//!
//! - [`Executive`] runs in one thread, with one cycle per servo period: [`Executive::serve`].
//! - [`Mode`] and [`Event`] form one table of transitions: [`Mode::after`].
//! - [`Devices::exchange`] sends orders to the devices and gets reports. It is the only place that waits.
//! - [`Port`] is the outside: commands come in, and every cycle is shown.
//! - A [`Guide`] may correct the planned set-point of a pass before it becomes an order: seam tracking enters here.
//! - [`Work`], built before the weld, holds everything that allocates.
//!
//! # A cycle
//!
//! 1. Orders go out, reports come in.
//! 2. The reports are compared with conditions and alarms.
//! 3. Commands are taken, or refused with a reason ([`Missing`]).
//! 4. The cycle is shown to the outside ([`Cycle`]).
//!
//! # Guarantees
//!
//! - Every action needs a command: power, motion and process each come from one, the process only if it was armed for
//!   that start.
//! - The process is off within one cycle of its cause.
//! - A cycle neither allocates nor locks.
//!
//! # Structure
//!
//! One thread runs nested loops (a program, a stretch of it, cycles) instead of one state machine of everything. The
//! mode, one table, decides the next step of the loops. `simulate` runs the same code with simulated devices, an
//! operator who requests one weld, and a judge who knows the true positions (`Reports::truth`).
//!
//! The state is grouped by concern: devices, clock, alarms, supervision, process, activity, requests, guide. Above it are
//! the steps of a cycle (`cycle.rs`), then the activities that run cycles (`homing.rs`, `jogging.rs`, `program.rs`), then
//! the choice among them (`serve.rs`).

mod activity;
mod alarm;
mod alarm_list;
mod bus;
mod clock;
mod command;
mod command_handling;
mod core;
mod cycle;
mod device_io;
mod guide;
mod guide_state;
mod guiding;
mod homing;
mod interlocks;
mod jogging;
mod mode;
mod process;
mod program;
mod reaction;
mod readiness;
mod reduced_speed;
mod report_checks;
mod requests;
mod serve;
mod shutdown;
mod state;
mod supervision;
mod work;

pub use alarm::{Alarm, Entry, Reaction, catalogue};
pub use alarm_list::{AlarmList, AlarmState, MAX_ALARMS, Place, Raised};
pub use bus::{
    Devices, DriveReport, Orders, ProcessOrders, Reports, SeamOrders, SensorReport, Slack, SourceReport, VALUES,
};
pub use command::{Ask, Command, Origin};
pub use core::Executive;
pub use guide::{Guide, Guided, Planned, Seen, Tracked, Trouble};
pub use interlocks::{Interlocks, MAX_INPUTS};
pub use mode::{Event, Mode, Refused, table};
pub use process::ProcessState;
pub use reduced_speed::REDUCED_MM_S;
pub use requests::End;
pub use state::{Cycle, Missing, Note, Port, SilentDevice, Status};
pub use work::{Start, Work};
