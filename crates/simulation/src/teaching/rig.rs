use crate::camera_simulator::CameraSimulator;
use seamwright_frames::{FrameError, FrameSource as _, TimedFrame};
use seamwright_machine::{Joints, Machine, Sensor};
use seamwright_message::Message;
use seamwright_teaching::{CameraPose, Carrier, Rig};

/// A simulated machine over a simulated work.
pub struct SimulatedRig<'a, 'b> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    carrier: Carrier<'b>,
    camera: CameraSimulator<'a>,
    /// Positions of the axes at the previous frame; `None` before the first.
    before: Option<Joints>,
    seconds: f64,
}

impl<'a, 'b> SimulatedRig<'a, 'b> {
    /// Creates the rig of camera `sensor` of `machine`, carried by `carrier`.
    pub fn new(machine: &'a Machine, sensor: &'a Sensor, carrier: Carrier<'b>, camera: CameraSimulator<'a>) -> Self {
        Self { machine, sensor, carrier, camera, before: None, seconds: 0.0 }
    }

    /// Returns the time between frames, s: the camera's period, and the slowest axis' way at half its speed.
    fn pause(&self, from: &Joints, to: &Joints) -> f64 {
        let axes = self.machine.axes.iter().zip(from.iter().zip(to));
        let slowest = axes.map(|(axis, (a, b))| 2.0 * (b - a).abs() / axis.max_speed).fold(0.0, f64::max);
        let period = self.sensor.period_s;
        period * (slowest / period).ceil().max(1.0)
    }
}

impl Rig for SimulatedRig<'_, '_> {
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message> {
        self.carrier.to(pose)
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let axes = *self.carrier.axes();
        self.seconds += self.before.map_or(self.sensor.period_s, |before| self.pause(&before, &axes));
        self.before = Some(axes);
        self.camera.expose(self.seconds, &axes);
        self.camera.next()
    }
}
