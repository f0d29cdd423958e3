use seamwright_vision::FrameError as Shape;
use std::path::Path;
use thiserror::Error;

/// Why there is no frame.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FrameError {
    /// A file or folder cannot be read or written, or a connection fails.
    #[error("{what}: {why}")]
    Io {
        /// The file, folder or address.
        what: String,
        /// What the system says.
        why: String,
    },
    /// A file or folder that was named is missing, of another kind, or may not be used.
    #[error("{what}: {why}\n   allowed: a folder of frames that is there, with frames.csv in it")]
    Named {
        /// The file or folder.
        what: String,
        /// What the system says.
        why: String,
    },
    /// An image that is none.
    #[error("{file}: {why}")]
    Image {
        /// The file.
        file: String,
        /// What is wrong with it.
        why: String,
    },
    /// A list of frames with something wrong in it.
    #[error("{file}:{line}: {message}\n   allowed: {allowed}")]
    List {
        /// The list.
        file: String,
        /// Line, counted from 1.
        line: usize,
        /// What is wrong.
        message: String,
        /// What would be right.
        allowed: String,
    },
    /// A frame's header with something wrong in it.
    #[error("frame {frame}: {field} {found}: not allowed\n   allowed: {allowed}")]
    Header {
        /// Counted from 0.
        frame: usize,
        /// The header's field.
        field: &'static str,
        /// What it holds.
        found: String,
        /// What it may hold.
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
    /// A time that is none, or not after the one before.
    #[error("frame {frame}: taken at {t_s} s{}: times are finite and increase", before.map_or(String::new(), |b| format!(", after one at {b} s")))]
    Time {
        /// Counted from 0.
        frame: usize,
        /// Its time, s.
        t_s: f64,
        /// That of the frame before.
        before: Option<f64>,
    },
    /// Pixels that do not make a picture.
    #[error("frame {frame}: {shape}")]
    Shape {
        /// Counted from 0.
        frame: usize,
        /// What is wrong with them.
        shape: Shape,
    },
}

impl FrameError {
    pub(super) fn io(what: impl Into<String>, error: &std::io::Error) -> Self {
        Self::Io { what: what.into(), why: error.to_string() }
    }

    /// A file or folder that the user named: one that is not there is another mistake than a disk that fails.
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

    /// True if the surroundings failed and not the data.
    pub fn is_environment(&self) -> bool {
        matches!(self, Self::Io { .. })
    }
}
