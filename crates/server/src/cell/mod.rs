//! The running cell behind the panel: the cycle in its thread, the desk that listens to it, what the panel's clients see.

mod alarms;
mod archive;
mod connected;
mod cycle;
mod desk;
mod guiding;
mod hub;
mod names;
mod prepared;
mod recorder;
mod start;

pub(crate) use connected::{Connected, Connection};
pub(crate) use desk::{Loading, ToDesk};
pub(crate) use hub::{Hub, Refusal};
pub(crate) use names::WHY;
pub(crate) use prepared::{Planned, Prepared, Task, fingerprint};
pub(crate) use start::Cell;
