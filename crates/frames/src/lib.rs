//! Frames of cameras: image files, recorded folders, connections. All sources are [`FrameSource`]s; the camera simulator
//! of `seamwright-simulation` is one too. An [`Overlay`] draws on a frame.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod decode;
mod error;
mod live;
mod overlay;
mod pnm;
mod recorded;
mod stream;

pub use decode::{DecodeError, decode, decode_up_to};
pub use error::{Field, FrameError, Part};
pub use live::LiveFrames;
pub use overlay::{COASTED, CROSS, Colour, MOTION, Overlay, ZONE, sureness};
pub use recorded::{LIST, Recorded, Recorder};
pub use stream::{FrameStream, HEADER_BYTES, MAX_FRAME_AXES, VERSION, write_frame};

use seamwright_vision::Image;

/// A frame with its time and the axis positions at that time.
#[derive(Debug, Clone, PartialEq)]
pub struct TimedFrame {
    /// Time of the exposure's middle, s; increases within a source.
    pub t_s: f64,
    /// The picture.
    pub image: Image,
    /// Axis positions at that time, in the machine file's order and units (mm or degrees), if the source knows them.
    pub axes: Option<Vec<f64>>,
    /// Height of the work on the optical axis, mm in the camera's frame (greater is farther), if focus or a stripe
    /// measured it.
    pub height_mm: Option<f64>,
}

/// A source of frames.
pub trait FrameSource {
    /// Returns the next frame; `None` at the end. Waits for it if frames come in real time.
    ///
    /// # Errors
    /// A missing or invalid frame, with the reason. After an error the source is at its end.
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError>;
}

/// Returns the time of a frame, if it is finite and later than that of the previous frame.
fn checked_time(t_s: f64, before: &mut Option<f64>, frame: usize) -> Result<f64, FrameError> {
    if !t_s.is_finite() || before.is_some_and(|b| t_s <= b) {
        return Err(FrameError::Time { frame, t_s, before: *before });
    }
    *before = Some(t_s);
    Ok(t_s)
}
