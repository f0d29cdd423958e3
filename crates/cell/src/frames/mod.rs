//! Where frames come from: a folder of images, a socket, the simulated eye. All of them are [`FrameSource`]s.

mod decode;
mod error;
mod live;
mod recorded;
mod stream;

pub use decode::{DecodeError, decode};
pub use error::FrameError;
pub use live::LiveFrames;
pub use recorded::{LIST, Recorded, Recorder};
pub use stream::{FrameStream, HEADER_BYTES, MOST_AXES, VERSION, write_frame};

use seamwright_vision::Image;

/// A frame, when it was taken and where the machine was then.
#[derive(Debug, Clone, PartialEq)]
pub struct TimedFrame {
    /// Time of the exposure's middle, s; in one source it increases.
    pub t_s: f64,
    /// The picture.
    pub image: Image,
    /// Positions of the machine's axes then, in the machine file's order and units (mm or degrees), if the source knows.
    pub axes: Option<Vec<f64>>,
    /// Height of the work on the optical axis, mm in the camera's frame (greater is farther), if focus or a stripe
    /// measured it.
    pub height_mm: Option<f64>,
}

/// A source of frames.
pub trait FrameSource {
    /// The next frame; none when there are no more. Waits for it where frames come in time.
    ///
    /// # Errors
    /// A frame that cannot be had or is none, and why. After an error there is nothing more.
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError>;
}

/// The time of a frame, if it is one and later than that of the frame before.
fn checked_time(t_s: f64, before: &mut Option<f64>, frame: usize) -> Result<f64, FrameError> {
    if !t_s.is_finite() || before.is_some_and(|b| t_s <= b) {
        return Err(FrameError::Time { frame, t_s, before: *before });
    }
    *before = Some(t_s);
    Ok(t_s)
}
