//! Records of welds, for years: plain data in, plain data out.
//!
//! - [`trace`]: rows of a weld, written while it runs and readable after a crash; Parquet in the end.
//! - [`journal`]: position of the weld, for a power failure.
//! - [`library`]: jobs, programs, machines, procedures, welders, welds, alarms, events and the audit log, in SQLite.
//! - [`figures`]: figures of a trace: heat input and deviations along the seam, values against their windows.
//! - [`DataFolder`] combines them: a weld is started, recorded ([`Recording`]) and ended in it.
//! - [`WeldWriter`] writes the files of a weld in a process that has no library: trace and [log](weld_log).
//! - [`VcdWriter`]: pulses as a value change dump.
//!
//! Without the feature `library` only the parts remain that write while a weld runs: no SQLite, no Parquet.
//!
//! `docs/reference/records.md` has the folder, the tables and the columns.
//!
//! # Examples
//!
//! Open a data folder, search the welds of a part, and verify the content:
//!
//! ```
//! use seamwright_record::DataFolder;
//! use seamwright_record::library::Query;
//!
//! let folder = tempfile::tempdir()?;
//! let data = DataFolder::open(folder.path())?;
//! let query = Query { part: Some("P-1".to_owned()), ..Query::default() };
//! assert!(data.library().find(&query)?.is_empty());
//! assert!(data.verify()?.problems.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

#[cfg(feature = "library")]
mod backup;
#[cfg(feature = "library")]
mod data_folder;
mod disk;
mod error;
mod event;
#[cfg(feature = "library")]
pub mod figures;
mod hash;
pub mod journal;
#[cfg(feature = "library")]
pub mod library;
mod moment;
mod private_files;
#[cfg(feature = "library")]
mod recording;
#[cfg(feature = "library")]
mod replace;
#[cfg(feature = "library")]
mod replacement_steps;
mod stored_message;
pub mod trace;
mod vcd;
#[cfg(feature = "library")]
mod waiting_file;
pub mod weld_log;
mod weld_writer;
mod whole_file;

#[cfg(feature = "library")]
pub use backup::restore;
#[cfg(feature = "library")]
pub use data_folder::{DataFolder, Recovered, Verified};
pub use disk::{DiskRoom, SPARE_BYTES, disk_room, probe_disk};
pub use error::{Doing, Error};
pub use event::{Event, Place};
pub use hash::{sha256, sha256_of_file};
pub use moment::{InvalidMoment, Moment};
#[cfg(feature = "library")]
pub use recording::{Outcome, Plan, Recording};
#[cfg(feature = "library")]
pub use replace::{Contents, check_archive, discard_checked, has_checked, replace_by_checked};
#[cfg(feature = "library")]
pub use replacement_steps::finish_replacing;
#[cfg(feature = "library")]
pub use stored_message::joined;
pub use vcd::{VcdAxis, VcdWriter, Wire};
#[cfg(feature = "library")]
pub use waiting_file::WaitingFile;
pub use weld_writer::{WeldFiles, WeldWriter};
pub use whole_file::{ClosedFile, WholeFile};
