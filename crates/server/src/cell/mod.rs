//! The running cell behind the panel: the cycle in its thread, the desk that handles its messages, the clients' view.

mod alarms;
mod archive;
mod audit_entry;
mod base;
mod commands;
mod connection;
mod cycle;
mod desk;
mod display_distances;
mod guiding;
mod happening;
mod hub;
mod names;
mod notes;
mod prepared;
mod progress;
mod recorder;
mod refusals;
mod safe_outputs;
mod start;
mod stillness;
mod stored;

pub(crate) use audit_entry::{Change, hides};
pub(crate) use base::{Planned, Task};
pub(crate) use commands::executive_command;
pub(crate) use connection::{CellDevices, Connection};
pub(crate) use desk::{Loading, ToDesk};
pub(crate) use display_distances::Around;
pub(crate) use happening::happening;
pub(crate) use hub::{Connected, Hub, Refusal, Text};
pub(crate) use names::WHY;
pub(crate) use prepared::{Prepared, fingerprint};
pub(crate) use start::Cell;
pub(crate) use stored::from_stored;
