use crate::events::CameraPose;
use seamwright_frames::{FrameError, TimedFrame};
use seamwright_message::Message;

/// A machine with a camera.
pub trait Rig {
    /// Moves the camera to a pose. Errors: the reason why the machine cannot go there.
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message>;

    /// Returns a frame from the camera's pose; `None` if there are no more. Errors: the reason why it is not available.
    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError>;
}
