//! Records of welds, for years: plain data in, plain data out.
//!
//! - [`trace`]: rows of a weld, written while it runs and readable after a crash; Parquet in the end.
//! - [`journal`]: position of the weld, for a power failure.
//! - [`library`]: jobs, programs, machines, procedures, welders, welds, alarms, events and the audit log, in SQLite.
//! - [`figures`]: figures of a trace: heat input and deviations along the seam, values against their windows.
//! - [`DataFolder`] combines them: a weld is started, recorded ([`Recording`]) and ended in it.
//! - [`VcdWriter`]: pulses as a value change dump.
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

mod backup;
mod data_folder;
mod disk;
mod error;
pub mod figures;
mod hash;
pub mod journal;
pub mod library;
mod moment;
mod private_files;
mod recording;
mod replace;
mod replacement_steps;
mod stored_message;
pub mod trace;
mod vcd;
mod waiting_file;
mod whole_file;

pub use backup::restore;
pub use data_folder::{DataFolder, Recovered, Verified};
pub use disk::{DiskRoom, SPARE_BYTES, disk_room, probe_disk};
pub use error::{Doing, Error};
pub use hash::{sha256, sha256_of_file};
pub use moment::{InvalidMoment, Moment};
pub use recording::{Outcome, Plan, Recording};
pub use replace::{Contents, check_archive, discard_checked, has_checked, replace_by_checked};
pub use replacement_steps::finish_replacing;
pub use stored_message::joined;
pub use vcd::{VcdAxis, VcdWriter, Wire};
pub use waiting_file::WaitingFile;
pub use whole_file::{ClosedFile, WholeFile};
