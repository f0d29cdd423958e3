//! The executive: what a cell does, cycle by cycle, from switching on to the end of a weld and after everything that goes wrong.
//!
//! [`Mode`] and [`Event`] are one table of transitions. [`Executive`] runs in one thread, a cycle a servo period: orders go
//! to the devices and reports come back ([`Devices::exchange`], the only place where it waits), reports are judged
//! against conditions and alarms, commands are taken, and the cycle is shown to the outside ([`Port`]). A cycle neither
//! allocates nor locks.
//!
//! Between the planned set-point of a pass and the orders of a cycle a [`Guide`] may correct: that is where tracking enters.
//!
//! Nothing starts by itself: power, motion and process each come from a command, the process only if it was armed for that
//! start. The process is off within one cycle of what takes it away.

mod alarm;
mod alarm_list;
mod bus;
mod command;
mod core;
mod guide;
mod guiding;
mod homing;
mod interlocks;
mod jogging;
mod mode;
mod process;
mod program;
mod readiness;
mod shutdown;
mod state;
mod supervision;
mod work;

pub use alarm::{Alarm, Entry, Reaction, catalogue};
pub use alarm_list::{AlarmList, AlarmState, MOST_ALARMS, Place, Raised};
pub use bus::{Devices, DriveReport, Orders, ProcessOrders, Reports, SensorReport, Slack, SourceReport, VALUES};
pub use command::{Ask, Command, Origin};
pub use core::{End, Executive};
pub use guide::{Guide, Guided, Planned, SeamOrders, Seen, Tracked, Trouble};
pub use interlocks::{Interlocks, MOST_INPUTS};
pub use jogging::REDUCED_MM_S;
pub use mode::{Event, Mode, Refused, table};
pub use process::ProcessState;
pub use state::{Cycle, Missing, Note, Port, Status};
pub use work::{Start, Work};
