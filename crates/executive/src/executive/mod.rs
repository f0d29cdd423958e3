//! Runs a cell cycle by cycle, from power-on to the end of a weld and after every fault: see the front page of the crate.

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
pub use alarm_list::{AlarmList, AlarmState, MAX_ALARMS, Place, Raised};
pub use bus::{Devices, DriveReport, Orders, ProcessOrders, Reports, SensorReport, Slack, SourceReport, VALUES};
pub use command::{Ask, Command, Origin};
pub use core::{End, Executive};
pub use guide::{Guide, Guided, Planned, SeamOrders, Seen, Tracked, Trouble};
pub use interlocks::{Interlocks, MAX_INPUTS};
pub use jogging::REDUCED_MM_S;
pub use mode::{Event, Mode, Refused, table};
pub use process::ProcessState;
pub use state::{Cycle, Missing, Note, Port, SilentDevice, Status};
pub use work::{Start, Work};
