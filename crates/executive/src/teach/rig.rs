//! Machines that carry the camera and take its frames.

use super::Carrier;
use crate::frames::{FrameError, FrameSource, FrameStream, TimedFrame};
use seamwright_machine::{Joints, Machine};
use seamwright_message::Message;
use seamwright_tracking::teach::CameraPose;
use std::net::TcpStream;

/// A machine with a camera.
pub trait Rig {
    /// Moves the camera to a pose.
    ///
    /// # Errors
    /// The reason why the machine cannot go there.
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message>;

    /// Returns a frame from the camera's pose; `None` if there are no more.
    ///
    /// # Errors
    /// The reason why it is not available.
    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError>;
}

/// Converts the axis positions of a frame, mm or degrees in the machine file's order, to those of the machine.
pub fn joints(machine: &Machine, given: &[f64]) -> Joints {
    let mut joints = Joints::default();
    for (value, (axis, given)) in joints.iter_mut().zip(machine.axes.iter().zip(given)) {
        *value = axis.from_file(*given);
    }
    joints
}

/// Frames of moves that another party makes, or has made.
pub struct Played<'a>(pub Box<dyn FrameSource + 'a>);

impl Rig for Played<'_> {
    fn go(&mut self, _eye: &CameraPose) -> Result<(), Message> {
        Ok(())
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        self.0.next()
    }
}

/// A machine at the other end of a connection, which gets a target before each frame.
pub struct DistantRig<'a> {
    machine: &'a Machine,
    carrier: Carrier<'a>,
    stream: FrameStream<TcpStream>,
}

impl<'a> DistantRig<'a> {
    /// Creates the rig for the `machine` that answers on `stream`; `carrier` has the current axis positions.
    pub fn new(machine: &'a Machine, carrier: Carrier<'a>, stream: FrameStream<TcpStream>) -> Self {
        Self { machine, carrier, stream }
    }
}

impl Rig for DistantRig<'_> {
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message> {
        self.carrier.to(pose)
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let axes = self.machine.axes.iter().zip(self.carrier.axes());
        let words: Vec<String> = axes.map(|(axis, at)| format!("{}={}", axis.name, axis.to_file(*at))).collect();
        self.stream.say(&format!("look {}", words.join(" ")))?;
        let frame = self.stream.next()?;
        if let Some(given) =
            frame.as_ref().and_then(|f| f.axes.as_deref()).filter(|a| a.len() == self.machine.axes.len())
        {
            // The next way starts at the true positions.
            self.carrier.stands(joints(self.machine, given));
        }
        Ok(frame)
    }
}
