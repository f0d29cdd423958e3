//! Teaching from recorded frames: the moves were made when they were.

use super::session::Session;
use super::setup::start;
use crate::args::teach::TeachArgs;
use crate::refusals::in_file;
use glam::DVec3;
use seamwright_frames::{FrameError, FrameSource, Recorded, TimedFrame};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_project::load::Loaded;
use seamwright_teaching::{CameraPose, Outcome, Rig, SeamLine};
use std::path::Path;

pub(super) fn teach(args: &TeachArgs, folder: &Path, loaded: &Loaded, nominal: &SeamLine) -> Result<Outcome, Failure> {
    let axes: Vec<&str> = loaded.machine.axes.iter().map(|a| a.name.as_str()).collect();
    let session = Session::new(args, loaded, nominal)?;
    let frames = Recorded::open(folder, &axes)?;
    play(&session, frames, &folder.display().to_string())
}

/// Teaches from frames in their order; the joint starts in the middle of the first one. `what` names them in errors.
pub(super) fn play(session: &Session, mut frames: impl FrameSource, what: &str) -> Result<Outcome, Failure> {
    let first = frames.next()?.ok_or_else(|| Failure::input(in_file(what, Message::new("cli-teach-no-frames"))))?;
    let begin = start(session.args, session.nominal, middle(session, &first))?;
    session.crawl(begin, &mut Played(Box::new(Again { first: Some(first), rest: frames })))
}

/// Point at which the camera looks in a frame.
pub(super) fn middle(session: &Session, frame: &TimedFrame) -> DVec3 {
    let axes = session.machine.joints_from_file(frame.axes.as_deref().unwrap_or_default());
    let camera = session.machine.camera_frame(session.sensor, &axes);
    camera.transform_point3(DVec3::Z * frame.height_mm.unwrap_or(0.0))
}

/// The first frame again, then the others.
struct Again<S> {
    first: Option<TimedFrame>,
    rest: S,
}

impl<S: FrameSource> FrameSource for Again<S> {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        match self.first.take() {
            Some(frame) => Ok(Some(frame)),
            None => self.rest.next(),
        }
    }
}

/// Frames of moves that another party makes, or has made.
struct Played<'a>(Box<dyn FrameSource + 'a>);

impl Rig for Played<'_> {
    fn go(&mut self, _eye: &CameraPose) -> Result<(), Message> {
        Ok(())
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        self.0.next()
    }
}
