//! The running cell behind the panel: the cycle in its thread, the desk that handles its messages, the clients' view.

mod alarms;
mod archive;
mod audit_entry;
mod connection;
mod cycle;
mod desk;
mod display_distances;
mod event;
mod guiding;
mod hub;
mod names;
mod notes;
mod prepared_task;
mod progress;
mod recorder;
mod refusals;
mod safe_outputs;
mod standstill;
mod start;
mod stored_message;
mod tally;
mod task;
mod unavailable_commands;

pub(crate) use audit_entry::{Change, hides};
pub(crate) use connection::{CellDevices, Connection};
pub(crate) use desk::{Loading, ToDesk};
pub(crate) use display_distances::Around;
pub(crate) use event::happening;
pub(crate) use hub::{Connected, Hub, Refusal, Text};
pub(crate) use names::{WHY, mode as mode_name};
pub(crate) use prepared_task::{Prepared, fingerprint};
pub(crate) use start::Cell;
pub(crate) use stored_message::from_stored;
pub(crate) use task::{Planned, Task};
pub(crate) use unavailable_commands::executive_command;
