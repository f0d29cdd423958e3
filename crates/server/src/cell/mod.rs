//! The running cell behind the panel: the desk that handles the messages of its process, and the clients' view.

mod alarms;
mod archive;
mod archive_queue;
mod audit_entry;
mod cell_reports;
mod chattering;
mod desk;
mod display_distances;
mod event;
mod hub;
mod names;
mod notes;
mod own_connection;
mod progress;
mod recorder;
mod refusals;
mod standstill;
mod start;
mod stored_message;
mod supervisor;
mod tally;
mod unavailable_commands;
mod urgent;

pub(crate) use audit_entry::{Change, hides, plain};
pub(crate) use desk::{Loading, NotLoaded, ToDesk};
pub(crate) use display_distances::Around;
pub(crate) use event::happening;
pub(crate) use hub::{Connected, Hub, Refusal, Text};
pub(crate) use names::{WHY, mode as mode_name};
pub(crate) use start::Cell;
pub(crate) use stored_message::from_stored;
pub(crate) use unavailable_commands::executive_command;
