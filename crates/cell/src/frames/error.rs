use seamwright_vision::FrameError as Shape;
use std::path::Path;
use thiserror::Error;

/// Reasons for a missing frame.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FrameError {
    /// A file or folder cannot be read or written, or a connection fails.
    #[error("{what}: {why}")]
    Io {
        /// The file, folder or address.
        what: String,
        /// Message of the system.
        why: String,
    },
    /// A named file or folder is missing, of another kind, or not accessible.
    #[error("{what}: {why}\n   allowed: a folder of frames that is there, with frames.csv in it")]
    Named {
        /// The file or folder.
        what: String,
        /// Message of the system.
        why: String,
    },
    /// An invalid image.
    #[error("{file}: {why}")]
    Image {
        /// The file.
        file: String,
        /// The defect.
        why: String,
    },
    /// An invalid list of frames.
    #[error("{file}:{line}: {message}\n   allowed: {allowed}")]
    List {
        /// The list.
        file: String,
        /// Line, counted from 1.
        line: usize,
        /// The defect.
        message: String,
        /// Allowed content.
        allowed: String,
    },
    /// An invalid frame header.
    #[error("frame {frame}: {field} {found}: not allowed\n   allowed: {allowed}")]
    Header {
        /// Counted from 0.
        frame: usize,
        /// The header's field.
        field: &'static str,
        /// Its value.
        found: String,
        /// Allowed values.
        allowed: String,
    },
    /// The stream ends within a frame.
    #[error("frame {frame}: the stream ends after {found} of its {wanted} bytes of {part}")]
    Truncated {
        /// Counted from 0.
        frame: usize,
        /// Header, axes or pixels.
        part: &'static str,
        /// Bytes there.
        found: usize,
        /// Bytes of that part.
        wanted: usize,
    },
    /// A time that is not finite, or not after the previous one.
    #[error("frame {frame}: taken at {t_s} s{}: times are finite and increase", before.map_or(String::new(), |b| format!(", after one at {b} s")))]
    Time {
        /// Counted from 0.
        frame: usize,
        /// Its time, s.
        t_s: f64,
        /// Time of the previous frame, s.
        before: Option<f64>,
    },
    /// Invalid pixels.
    #[error("frame {frame}: {shape}")]
    Shape {
        /// Counted from 0.
        frame: usize,
        /// The defect.
        shape: Shape,
    },
}

impl FrameError {
    pub(super) fn io(what: impl Into<String>, error: &std::io::Error) -> Self {
        Self::Io { what: what.into(), why: error.to_string() }
    }

    /// A file or folder that the user named: a wrong name is a different mistake from a failing disk.
    pub(super) fn path(path: &Path, error: &std::io::Error) -> Self {
        use std::io::ErrorKind::{
            AlreadyExists, IsADirectory, NotADirectory, NotFound, PermissionDenied, ReadOnlyFilesystem,
        };
        let what = path.display().to_string();
        match error.kind() {
            AlreadyExists | IsADirectory | NotADirectory | NotFound | PermissionDenied | ReadOnlyFilesystem => {
                Self::Named { what, why: error.to_string() }
            }
            _ => Self::io(what, error),
        }
    }

    /// Returns true if the environment failed and not the data.
    pub fn is_environment(&self) -> bool {
        matches!(self, Self::Io { .. })
    }
}
