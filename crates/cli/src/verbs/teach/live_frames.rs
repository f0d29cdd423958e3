//! Teaching from frames that come over a connection, from a beam's scanner for one.

use super::recorded_frames::{middle, play};
use super::session::Session;
use super::setup::{start, within};
use crate::args::teach::TeachArgs;
use crate::refusals::{in_file, refused};
use glam::DVec3;
use seamwright_frames::{FrameError, FrameSource, FrameStream, TimedFrame};
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_teaching::{CameraPose, Carrier, Outcome, PlannedWeld, Rig, SeamLine};
use std::net::TcpStream;
use std::ops::RangeInclusive;
use std::time::Duration;

/// Shortest and longest time to wait for a frame, s.
const TIMEOUTS_S: RangeInclusive<f64> = 0.001..=3600.0;

pub(super) fn address<'a>(frames: &str, address: &'a str) -> Result<&'a str, Failure> {
    let named = address.rsplit_once(':').filter(|(host, _)| !host.is_empty());
    if named.is_some_and(|(_, port)| port.parse::<u16>().is_ok_and(|port| port > 0)) {
        return Ok(address);
    }
    Err(refused("--frames", frames, Message::new("cli-teach-no-address"), Message::new("cli-teach-address")))
}

pub(super) fn teach(args: &TeachArgs, address: &str, loaded: &Loaded, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let timeout = within("--timeout-s", args.timeout_s, TIMEOUTS_S)?;
    let session = Session::new(args, loaded, nominal)?;
    let connect = || FrameStream::connect(address, Duration::from_secs_f64(timeout));
    if !args.drive {
        return play(&session, connect()?, address);
    }
    let ground = PlannedWeld::new(&loaded.welding, &loaded.machine, &loaded.clamped, nominal)?;
    let guide = |point: DVec3| ground.guide(point);
    let mut stream = connect()?;
    // The first frame comes unasked: it shows the camera's position.
    let first = stream.next()?.ok_or_else(|| Failure::input(in_file(address, Message::new("cli-teach-no-frames"))))?;
    let begin = start(args, nominal, middle(&session, &first))?;
    let axes = session.machine.joints_from_file(first.axes.as_deref().unwrap_or_default());
    let carrier = ground.carrier(session.machine, session.sensor, &guide, axes);
    session.crawl(begin, &mut DistantRig::new(session.machine, carrier, stream))
}

/// A machine at the other end of a connection, which gets a target before each frame.
struct DistantRig<'a> {
    machine: &'a Machine,
    carrier: Carrier<'a>,
    stream: FrameStream<TcpStream>,
}

impl<'a> DistantRig<'a> {
    /// Creates the rig for the `machine` that answers on `stream`; `carrier` has the current axis positions.
    fn new(machine: &'a Machine, carrier: Carrier<'a>, stream: FrameStream<TcpStream>) -> Self {
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
            self.carrier.stands(self.machine.joints_from_file(given));
        }
        Ok(frame)
    }
}
