use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Reason why data cannot be recorded or read. Every message names the file and the operator action.
#[derive(Debug, Error)]
pub enum Error {
    /// The disk is full.
    #[error(
        "{}: {why}\n   allowed: make room, or another data folder; what was written before is kept", path.display()
    )]
    Full {
        /// The file.
        path: PathBuf,
        /// Reason: the disk is full, or how much is missing.
        why: String,
    },
    /// The folder or file is read-only.
    #[error("{}: cannot be written: {why}\n   allowed: a folder that you may write", path.display())]
    ReadOnly {
        /// The file or folder.
        path: PathBuf,
        /// Message of the system.
        why: String,
    },
    /// The system refuses for another reason.
    #[error("{}: {doing}: {cause}\n   allowed: a file or folder that is there, on a disk that works", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Action that failed.
        doing: &'static str,
        /// Error of the system.
        cause: io::Error,
    },
    /// A file is damaged.
    #[error("{}: {why}\n   allowed: {allowed}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// Description of the damage.
        why: String,
        /// Operator action.
        allowed: String,
    },
    /// A library of a later version.
    #[error(
        "{}: written by a later version (schema {found}, this version knows up to {known})\n   allowed: that version of \
         Seamwright; nothing was changed", path.display()
    )]
    Newer {
        /// The library.
        path: PathBuf,
        /// Its schema version.
        found: i64,
        /// Ours.
        known: i64,
    },
    /// Something else holds it.
    #[error("{}: another program is using it\n   allowed: try again when that has ended", path.display())]
    Busy {
        /// The file.
        path: PathBuf,
    },
    /// The request is invalid: its object is missing, or it is not allowed.
    #[error("{what}\n   allowed: {allowed}")]
    Wrong {
        /// Description of the fault.
        what: String,
        /// Operator action.
        allowed: String,
    },
    /// The database refuses for another reason.
    #[error("{}: {cause}", path.display())]
    Database {
        /// The library.
        path: PathBuf,
        /// Error of SQLite.
        cause: rusqlite::Error,
    },
}

impl Error {
    /// A failure of the system at `path` during the action `doing`.
    pub(crate) fn io(path: &Path, doing: &'static str, cause: io::Error) -> Self {
        use io::ErrorKind::{PermissionDenied, QuotaExceeded, ReadOnlyFilesystem, StorageFull};
        let path = path.to_owned();
        match cause.kind() {
            StorageFull | QuotaExceeded => Self::full(&path),
            PermissionDenied | ReadOnlyFilesystem => Self::ReadOnly { path, why: cause.to_string() },
            _ => Self::Io { path, doing, cause },
        }
    }

    fn full(path: &Path) -> Self {
        Self::Full { path: path.to_owned(), why: "the disk is full".to_owned() }
    }

    /// A failure of the Parquet file at `path`.
    pub(crate) fn parquet(path: &Path, cause: &parquet::errors::ParquetError) -> Self {
        if let parquet::errors::ParquetError::External(inner) = cause
            && let Some(io) = inner.downcast_ref::<io::Error>()
        {
            return Self::io(path, "written", io::Error::new(io.kind(), io.to_string()));
        }
        Self::damaged(path, format!("not a trace: {cause}"), "a Parquet file that Seamwright wrote")
    }

    pub(crate) fn damaged(path: &Path, why: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self::Damaged { path: path.to_owned(), why: why.into(), allowed: allowed.into() }
    }

    pub(crate) fn wrong(what: impl Into<String>, allowed: impl Into<String>) -> Self {
        Self::Wrong { what: what.into(), allowed: allowed.into() }
    }

    /// A failure of the library at `path`.
    pub(crate) fn database(path: &Path, cause: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode::{
            CannotOpen, DatabaseBusy, DatabaseCorrupt, DatabaseLocked, DiskFull, NotADatabase, PermissionDenied,
            ReadOnly,
        };
        let known = path.to_owned();
        match cause.sqlite_error_code() {
            Some(DiskFull) => Self::full(path),
            Some(ReadOnly | PermissionDenied | CannotOpen) => Self::ReadOnly { path: known, why: cause.to_string() },
            Some(DatabaseBusy | DatabaseLocked) => Self::Busy { path: known },
            Some(DatabaseCorrupt | NotADatabase) => Self::Damaged {
                path: known,
                why: format!("the library is damaged ({cause})"),
                allowed: "put the last copy of it in its place, or move it away: a new one is begun, and traces stay \
                          as they are"
                    .to_owned(),
            },
            _ => Self::Database { path: known, cause },
        }
    }

    /// True if another request by the user avoids the error; false if the system or a disk failed.
    pub fn is_input(&self) -> bool {
        match self {
            Self::ReadOnly { .. } | Self::Newer { .. } | Self::Wrong { .. } => true,
            Self::Io { cause, .. } => {
                matches!(
                    cause.kind(),
                    io::ErrorKind::NotFound | io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists
                )
            }
            Self::Full { .. } | Self::Damaged { .. } | Self::Busy { .. } | Self::Database { .. } => false,
        }
    }
}
