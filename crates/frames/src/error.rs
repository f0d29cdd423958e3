use seamwright_message::{Message, Unit, display_by_message};
use seamwright_vision::FrameError as Shape;
use std::path::Path;

/// Reasons for a missing frame. Frames count from 0, lines from 1; `what` is a file, a folder or an address.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum FrameError {
    /// A file or folder cannot be read or written, or a connection fails.
    Io { what: String, why: Message },
    /// A named file or folder is missing, of another kind, or not accessible.
    Named { what: String, why: Message },
    /// An invalid image.
    Image { file: String, why: Message },
    /// An invalid list of frames.
    List { file: String, line: usize, message: Message, allowed: Message },
    /// An invalid frame header.
    Header { frame: usize, field: Field, found: Message, allowed: Message },
    /// The stream ends within a part of a frame, with the bytes `found` of those `wanted`.
    Truncated { frame: usize, part: Part, found: usize, wanted: usize },
    /// A time that is not finite, or not after the previous one.
    Time { frame: usize, t_s: f64, before: Option<f64> },
    /// Invalid pixels.
    Shape { frame: usize, shape: Shape },
}

/// Field of a frame's header.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Field {
    /// The first bytes.
    Magic,
    /// Version of the format.
    Version,
    /// Bits of a pixel.
    Depth,
    /// Columns.
    Width,
    /// Rows.
    Height,
    /// Number of axes.
    Axes,
    /// Bytes that must be 0.
    Reserved,
    /// Height of the work.
    WorkHeight,
    /// Position of an axis.
    Position,
}

/// Part of a frame in a stream.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The header.
    Header,
    /// Positions of the axes.
    Axes,
    /// The pixels.
    Pixels,
}

impl Field {
    fn message(self) -> Message {
        Message::new(match self {
            Self::Magic => "cell-frame-magic",
            Self::Version => "cell-frame-version",
            Self::Depth => "cell-frame-depth",
            Self::Width => "cell-frame-width",
            Self::Height => "cell-frame-height",
            Self::Axes => "cell-frame-axes",
            Self::Reserved => "cell-frame-reserved",
            Self::WorkHeight => "cell-frame-work-height",
            Self::Position => "cell-frame-position",
        })
    }
}

impl FrameError {
    /// Returns its message.
    pub fn message(&self) -> Message {
        let of = |code, frame: &usize| Message::new(code).number("frame", *frame as f64, 0);
        match self {
            Self::Io { what, why } => Message::new("cell-frame-io").text("what", what).message("why", why.clone()),
            Self::Named { what, why } => {
                Message::new("cell-frames-missing").text("what", what).message("why", why.clone())
            }
            Self::Image { file, why } => Message::new("cell-frame-io").text("what", file).message("why", why.clone()),
            Self::List { file, line, message, allowed } => Message::new("cell-frame-list")
                .text("file", file)
                .number("line", *line as f64, 0)
                .message("why", message.clone())
                .message("allowed", allowed.clone()),
            Self::Header { frame, field, found, allowed } => of("cell-frame-header", frame)
                .message("field", field.message())
                .message("found", found.clone())
                .message("allowed", allowed.clone()),
            Self::Truncated { frame, part, found, wanted } => {
                let code = match part {
                    Part::Header => "cell-frame-header-truncated",
                    Part::Axes => "cell-frame-axes-truncated",
                    Part::Pixels => "cell-frame-pixels-truncated",
                };
                let message = of(code, frame).quantity("found", *found as f64, Unit::Byte, 0);
                message.quantity("wanted", *wanted as f64, Unit::Byte, 0)
            }
            Self::Time { frame, t_s, before: None } => of("cell-frame-time", frame).value("time", *t_s, Unit::S),
            Self::Time { frame, t_s, before: Some(before) } => {
                of("cell-frame-time-order", frame).value("time", *t_s, Unit::S).value("before", *before, Unit::S)
            }
            Self::Shape { frame, shape } => of("cell-frame-shape", frame).message("why", shape.message()),
        }
    }

    pub(super) fn io(what: impl Into<String>, error: &std::io::Error) -> Self {
        Self::Io { what: what.into(), why: Message::outside(&error) }
    }

    /// A file or folder that the user named: a wrong name is a different mistake from a failing disk.
    pub(super) fn path(path: &Path, error: &std::io::Error) -> Self {
        use std::io::ErrorKind::{
            AlreadyExists, IsADirectory, NotADirectory, NotFound, PermissionDenied, ReadOnlyFilesystem,
        };
        let what = path.display().to_string();
        match error.kind() {
            AlreadyExists | IsADirectory | NotADirectory | NotFound | PermissionDenied | ReadOnlyFilesystem => {
                Self::Named { what, why: Message::outside(&error) }
            }
            _ => Self::io(what, error),
        }
    }

    /// Returns true if the environment failed and not the data.
    pub fn is_environment(&self) -> bool {
        matches!(self, Self::Io { .. })
    }
}

display_by_message!(FrameError);
