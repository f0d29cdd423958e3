use seamwright_message::{Message, display_by_message};
use std::io;
use std::path::{Path, PathBuf};

/// Reason why data cannot be recorded or read. Every message names the file and the operator action.
#[derive(Debug)]
pub enum Error {
    /// The disk is full.
    Full {
        /// The file.
        path: PathBuf,
        /// Reason: the disk is full, or how much is missing.
        why: Message,
    },
    /// The folder or file is read-only.
    ReadOnly {
        /// The file or folder.
        path: PathBuf,
        /// Message of the system.
        why: String,
    },
    /// The system refuses for another reason.
    Io {
        /// The file.
        path: PathBuf,
        /// Action that failed.
        doing: Doing,
        /// Error of the system.
        cause: io::Error,
    },
    /// A file is damaged.
    Damaged {
        /// The file.
        path: PathBuf,
        /// Description of the damage.
        why: Message,
        /// Operator action.
        allowed: Message,
    },
    /// A library of a later version.
    Newer {
        /// The library.
        path: PathBuf,
        /// Its schema version.
        found: i64,
        /// Ours.
        known: i64,
    },
    /// Something else holds it.
    Busy {
        /// The file.
        path: PathBuf,
    },
    /// A search was ended because it took too long: see `library::Interrupt`.
    Interrupted {
        /// The library.
        path: PathBuf,
    },
    /// The request is invalid: its object is missing, or it is not allowed.
    Wrong {
        /// Description of the fault.
        what: Message,
        /// Operator action.
        allowed: Message,
    },
    /// The database refuses for another reason.
    #[cfg(feature = "library")]
    Database {
        /// The library.
        path: PathBuf,
        /// Error of SQLite.
        cause: rusqlite::Error,
    },
}

/// Action on a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Doing {
    /// Read it.
    Read,
    /// Write it.
    Write,
    /// Create it.
    Create,
    /// Remove it.
    Remove,
    /// Rename or move it.
    Move,
    /// Put it into an archive.
    Archive,
    /// Unpack it.
    Unpack,
}

impl Error {
    /// Returns its message.
    pub fn message(&self) -> Message {
        let at = |code, path: &Path| Message::new(code).text("path", path.display().to_string());
        match self {
            Self::Full { path, why } => at("record-full", path).message("why", why.clone()),
            Self::ReadOnly { path, why } => at("record-read-only", path).text("why", why),
            Self::Io { path, doing, cause } => at(doing.code(), path).text("why", cause.to_string()),
            Self::Damaged { path, why, allowed } => {
                at("record-damaged", path).message("why", why.clone()).message("allowed", allowed.clone())
            }
            Self::Newer { path, found, known } => {
                at("record-newer", path).number("found", *found as f64, 0).number("known", *known as f64, 0)
            }
            Self::Busy { path } => at("record-busy", path),
            Self::Interrupted { path } => at("record-search-ended", path),
            Self::Wrong { what, allowed } => {
                Message::new("record-invalid").message("what", what.clone()).message("allowed", allowed.clone())
            }
            #[cfg(feature = "library")]
            Self::Database { path, cause } => at("record-database", path).text("why", cause.to_string()),
        }
    }

    /// A failure of the system at `path` during the action `doing`.
    pub(crate) fn io(path: &Path, doing: Doing, cause: io::Error) -> Self {
        use io::ErrorKind::{PermissionDenied, QuotaExceeded, ReadOnlyFilesystem, StorageFull};
        let path = path.to_owned();
        match cause.kind() {
            StorageFull | QuotaExceeded => Self::full(&path),
            PermissionDenied | ReadOnlyFilesystem => Self::ReadOnly { path, why: cause.to_string() },
            _ => Self::Io { path, doing, cause },
        }
    }

    fn full(path: &Path) -> Self {
        Self::Full { path: path.to_owned(), why: Message::new("record-disk-full") }
    }

    #[cfg(feature = "library")]
    pub(crate) fn parquet(path: &Path, cause: &parquet::errors::ParquetError) -> Self {
        if let parquet::errors::ParquetError::External(inner) = cause
            && let Some(io) = inner.downcast_ref::<io::Error>()
        {
            return Self::io(path, Doing::Write, io::Error::new(io.kind(), io.to_string()));
        }
        let why = Message::new("record-no-trace").text("why", cause.to_string());
        Self::damaged(path, why, Message::new("record-own-parquet"))
    }

    pub(crate) fn damaged(path: &Path, why: Message, allowed: Message) -> Self {
        Self::Damaged { path: path.to_owned(), why, allowed }
    }

    pub(crate) fn wrong(what: Message, allowed: Message) -> Self {
        Self::Wrong { what, allowed }
    }

    #[cfg(feature = "library")]
    pub(crate) fn database(path: &Path, cause: rusqlite::Error) -> Self {
        use rusqlite::ErrorCode::{
            CannotOpen, DatabaseBusy, DatabaseCorrupt, DatabaseLocked, DiskFull, NotADatabase, OperationInterrupted,
            PermissionDenied, ReadOnly,
        };
        let known = path.to_owned();
        match cause.sqlite_error_code() {
            Some(DiskFull) => Self::full(path),
            Some(ReadOnly | PermissionDenied | CannotOpen) => Self::ReadOnly { path: known, why: cause.to_string() },
            Some(DatabaseBusy | DatabaseLocked) => Self::Busy { path: known },
            Some(OperationInterrupted) => Self::Interrupted { path: known },
            Some(DatabaseCorrupt | NotADatabase) => Self::Damaged {
                path: known,
                why: Message::new("record-library-damaged").text("why", cause.to_string()),
                allowed: Message::new("record-library-from-copy"),
            },
            _ => Self::Database { path: known, cause },
        }
    }

    #[cfg(feature = "library")]
    /// True if a table of the library refuses the row itself: another disk or another time would not help.
    pub fn is_constraint(&self) -> bool {
        use rusqlite::ErrorCode::{ConstraintViolation, TooBig, TypeMismatch};
        matches!(self, Self::Database { cause, .. }
            if matches!(cause.sqlite_error_code(), Some(ConstraintViolation | TooBig | TypeMismatch)))
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
            Self::Full { .. } | Self::Damaged { .. } | Self::Busy { .. } | Self::Interrupted { .. } => false,
            #[cfg(feature = "library")]
            Self::Database { .. } => false,
        }
    }
}

display_by_message!(Error);

impl Doing {
    fn code(self) -> &'static str {
        match self {
            Self::Read => "record-not-read",
            Self::Write => "record-not-written",
            Self::Create => "record-not-created",
            Self::Remove => "record-not-removed",
            Self::Move => "record-not-moved",
            Self::Archive => "record-not-archived",
            Self::Unpack => "record-not-unpacked",
        }
    }
}
