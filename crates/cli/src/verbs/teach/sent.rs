//! Teaching from frames that come over a connection, from a beam's scanner for one.

use super::recorded::{middle, play};
use super::session::Session;
use super::setup::{start, within};
use crate::args::teach::TeachArgs;
use crate::refusals::{in_file, refused};
use glam::DVec3;
use seamwright_cell::camera_simulator::SeamLine;
use seamwright_cell::frames::{FrameSource, FrameStream};
use seamwright_cell::teach::{DistantRig, joints};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_project::teaching::{Ground, Outcome};
use std::ops::RangeInclusive;
use std::time::Duration;

/// Shortest and longest time to wait for a frame, s.
const TIMEOUTS_S: RangeInclusive<f64> = 0.001..=3600.0;

/// The host and port in `frames`.
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
    let ground = Ground::new(loaded, nominal)?;
    let guide = |point: DVec3| ground.guide(point);
    let mut stream = connect()?;
    // The first frame comes unasked: it shows the camera's position.
    let first = stream.next()?.ok_or_else(|| Failure::input(in_file(address, Message::new("cli-teach-no-frames"))))?;
    let begin = start(args, nominal, middle(&session, &first))?;
    let axes = joints(session.machine, first.axes.as_deref().unwrap_or_default());
    let carrier = ground.carrier(session.machine, session.sensor, &guide, axes);
    session.crawl(begin, &mut DistantRig::new(session.machine, carrier, stream))
}
