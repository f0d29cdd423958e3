//! Runs a cell cycle by cycle, from power-on to the end of a weld and after every fault: see the front page of the crate.

mod activity;
mod alarm;
mod alarm_list;
mod alarm_priority;
mod clock;
mod command;
mod command_handling;
mod core;
mod cut_off;
mod cycle;
mod device_interface;
mod device_io;
mod dispatch;
mod guide;
mod guide_state;
mod guiding;
mod homing;
mod interlocks;
mod jogging;
mod missing_permissive;
mod mode;
mod port;
mod process;
mod program;
mod reaction;
mod readiness;
mod reduced_speed;
mod report_checks;
mod requests;
mod shutdown;
mod supervision;
mod work;

pub use alarm::{Alarm, Entry, Reaction};
pub use alarm_list::{AlarmList, AlarmState, MAX_ALARMS, Place, Raised};
pub use alarm_priority::{Priority, Rationalisation, ResponseTime, Severity};
pub use command::{Ask, Command, Origin};
pub use core::Executive;
pub use cut_off::CutOff;
pub use device_interface::{
    Devices, DriveReport, Orders, ProcessOrders, Reports, SeamOrders, SensorReport, Slack, SourceReport, VALUES,
    Watchdog,
};
pub use guide::{Guide, Guided, Planned, Seen, Tracked, Trouble};
pub use interlocks::{Interlocks, MAX_INPUTS};
pub use missing_permissive::{Missing, SilentDevice};
pub use mode::{Event, Mode, Refused, table};
pub use port::{Cycle, Note, Port, Status};
pub use process::ProcessState;
pub use reduced_speed::{Foreseen, REDUCED_MM_S, REDUCED_RAD_S, foresee};
pub use requests::End;
pub use work::{Start, Work};
