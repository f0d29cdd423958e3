use crate::camera_simulator::CameraSimulator;
use seamwright_frames::{FrameError, FrameSource as _, TimedFrame};
use seamwright_machine::Joints;
use seamwright_message::Message;
use seamwright_teaching::{CameraPose, Carrier, Rig};

/// A simulated machine over a simulated work.
pub struct SimulatedRig<'a, 'b> {
    carrier: Carrier<'b>,
    camera: CameraSimulator<'a>,
    /// Positions of the axes at the previous frame; `None` before the first.
    before: Option<Joints>,
    seconds: f64,
}

impl<'a, 'b> SimulatedRig<'a, 'b> {
    /// Creates the rig of a camera, carried by `carrier`.
    pub fn new(carrier: Carrier<'b>, camera: CameraSimulator<'a>) -> Self {
        Self { carrier, camera, before: None, seconds: 0.0 }
    }
}

impl Rig for SimulatedRig<'_, '_> {
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message> {
        self.carrier.to(pose)
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let axes = *self.carrier.axes();
        self.seconds += self.carrier.pause_s(&self.before.replace(axes).unwrap_or(axes));
        self.camera.expose(self.seconds, &axes);
        self.camera.next()
    }
}
