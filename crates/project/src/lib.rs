//! From files to a planned weld and its recording: the functions common to the command line and the panel.
//!
//! - [`load`] reads a job with its machine, part and fixtures ([`load::Loaded`]), and plans it.
//! - [`planning`] limits the time of a plan, shows its progress and cancels it.
//! - [`reach`](mod@reach) searches the best placement of the work; [`placing`] writes it into the job.
//! - [`posting`] writes part programs, [`recording`] records welds.
//! - [`Failure`] is the reason why a command ends without its result, with its exit code.
//!
//! # Examples
//!
//! Load and plan an example:
//!
//! ```
//! use seamwright_project::load::load;
//! use std::path::Path;
//!
//! // Without a file of that name this is the example.
//! let loaded = load(Path::new("first-weld")).unwrap();
//! assert_eq!(loaded.machine.axes.len(), 4);
//! let motion = loaded.plan().unwrap();
//! assert_eq!(motion.passes.len(), 1);
//! ```

pub mod csv;
pub mod devices;
pub mod examples;
pub mod failure;
mod file_scope;
mod file_store;
pub mod files;
pub mod load;
mod outside_data;
pub mod own_machine;
pub mod placing;
pub mod planning;
pub mod posting;
pub mod power_loss;
mod pulse_file;
pub mod reach;
#[cfg(feature = "library")]
pub mod recording;
pub mod run_rows;
pub mod simulated_part;
pub mod torch_angles;
pub mod weld_events;
pub mod work_offset;

pub use failure::Failure;
pub use file_store::FileStore;
