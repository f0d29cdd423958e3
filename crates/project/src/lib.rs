//! From files to a planned weld and its recording: the functions common to the command line and the panel.

pub mod csv;
pub mod devices;
pub mod examples;
pub mod failure;
pub mod files;
pub mod load;
pub mod offset;
mod outside;
pub mod overlay;
pub mod own_machine;
pub mod part;
pub mod planning;
pub mod posting;
pub mod power_loss;
pub mod recording;
pub mod run_rows;
mod steps;
pub mod teaching;
pub mod weld_events;
mod within;

pub use failure::Failure;
