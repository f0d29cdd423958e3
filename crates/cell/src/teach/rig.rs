//! What carries the eye and takes its frames.

use super::Carrier;
use crate::eyes::Eye;
use crate::frames::{FrameError, FrameSource, FrameStream, TimedFrame};
use seamwright_machine::{Joints, Machine, Sensor};
use seamwright_tracking::teach::EyePose;
use std::net::TcpStream;

/// A machine with an eye.
pub trait Rig {
    /// Brings the eye there.
    ///
    /// # Errors
    /// In words: why the machine cannot go there.
    fn go(&mut self, eye: &EyePose) -> Result<(), String>;

    /// A frame from where the eye is; none if there are no more.
    ///
    /// # Errors
    /// Why it cannot be had.
    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError>;
}

/// Positions of a machine's axes from those of a frame, mm or degrees in the machine file's order.
pub fn joints(machine: &Machine, given: &[f64]) -> Joints {
    let mut joints = Joints::default();
    for (value, (axis, given)) in joints.iter_mut().zip(machine.axes.iter().zip(given)) {
        *value = axis.from_file(*given);
    }
    joints
}

/// A simulated machine over a simulated work.
pub struct SimulatedRig<'a, 'b> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    carrier: Carrier<'b>,
    eye: Eye<'a>,
    /// Where the axes were at the frame before; none before the first.
    before: Option<Joints>,
    seconds: f64,
}

impl<'a, 'b> SimulatedRig<'a, 'b> {
    /// The eye `sensor` of `machine`, carried by `carrier`.
    pub fn new((machine, sensor): (&'a Machine, &'a Sensor), carrier: Carrier<'b>, eye: Eye<'a>) -> Self {
        Self { machine, sensor, carrier, eye, before: None, seconds: 0.0 }
    }

    /// Seconds from a frame to the next one: the eye's period, and the slowest axis' way at half its speed.
    fn pause(&self, from: &Joints, to: &Joints) -> f64 {
        let axes = self.machine.axes.iter().zip(from.iter().zip(to));
        let slowest = axes.map(|(axis, (a, b))| 2.0 * (b - a).abs() / axis.max_speed).fold(0.0, f64::max);
        let period = self.sensor.period_s;
        period * (slowest / period).ceil().max(1.0)
    }
}

impl Rig for SimulatedRig<'_, '_> {
    fn go(&mut self, eye: &EyePose) -> Result<(), String> {
        self.carrier.to(eye)
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let axes = *self.carrier.axes();
        self.seconds += self.before.map_or(self.sensor.period_s, |before| self.pause(&before, &axes));
        self.before = Some(axes);
        self.eye.expose(self.seconds, &axes);
        self.eye.next()
    }
}

/// Frames of moves that somebody else makes, or has made.
pub struct Played<'a>(pub Box<dyn FrameSource + 'a>);

impl Rig for Played<'_> {
    fn go(&mut self, _eye: &EyePose) -> Result<(), String> {
        Ok(())
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        self.0.next()
    }
}

/// A machine at the other end of a connection, which is told where to go before each frame.
pub struct DistantRig<'a> {
    machine: &'a Machine,
    carrier: Carrier<'a>,
    stream: FrameStream<TcpStream>,
}

impl<'a> DistantRig<'a> {
    /// The `machine` that answers on `stream`, `carrier` with the axes where they are.
    pub fn new(machine: &'a Machine, carrier: Carrier<'a>, stream: FrameStream<TcpStream>) -> Self {
        Self { machine, carrier, stream }
    }
}

impl Rig for DistantRig<'_> {
    fn go(&mut self, eye: &EyePose) -> Result<(), String> {
        self.carrier.to(eye)
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let axes = self.machine.axes.iter().zip(self.carrier.axes());
        let words: Vec<String> = axes.map(|(axis, at)| format!("{}={}", axis.name, axis.to_file(*at))).collect();
        self.stream.say(&format!("look {}", words.join(" ")))?;
        let frame = self.stream.next()?;
        if let Some(given) =
            frame.as_ref().and_then(|f| f.axes.as_deref()).filter(|a| a.len() == self.machine.axes.len())
        {
            // Where it truly is: the next way begins there.
            self.carrier.stands(joints(self.machine, given));
        }
        Ok(frame)
    }
}
