//! A crawl along the joint from its start to its end.

use crate::crawl::Crawl;
use crate::events::{Answer, Command, End, Event, Seen};
use crate::rig::Rig;
use crate::work_shape::{Aim, FrameEnd, Row, View};
use seamwright_frames::{Field, FrameError, TimedFrame};
use seamwright_machine::{Joints, Machine, Sensor};
use seamwright_message::Message;
use seamwright_vision::Frame;

/// Finds the joint's midline in a frame.
pub trait Midline {
    /// Finds the midline from `aim` on.
    fn find(&mut self, frame: &Frame, aim: &Aim) -> Found;
}

/// A midline.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Rows of the midline in order.
    pub rows: Vec<Row>,
    /// Reason for their end.
    pub end: FrameEnd,
}

impl Found {
    /// Creates an empty result.
    pub fn nothing() -> Self {
        Self { rows: Vec::new(), end: FrameEnd::Lost }
    }
}

/// Answers when the joint is lost.
pub trait Operator {
    /// Returns the answer to `why` the joint is lost, given the crawl so far.
    fn answer(&mut self, why: &Message, crawl: &Crawl) -> Answer;
}

/// Absent operator: the crawl ends with the joint found so far.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoOperator {
    /// True if an answer was requested.
    pub asked: bool,
}

impl Operator for NoOperator {
    fn answer(&mut self, _why: &Message, _crawl: &Crawl) -> Answer {
        self.asked = true;
        Answer::End
    }
}

/// Result of a crawl.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaughtRun {
    /// Reason for its end; `None`: there were no more frames.
    pub end: Option<End>,
    /// Axis positions at each frame, in order.
    pub axes: Vec<Joints>,
    /// Reason for each question to the operator.
    pub asked: Vec<Message>,
    /// Time of the last frame, s.
    pub seconds: f64,
}

/// A frame that was evaluated.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// The frame.
    pub frame: &'a TimedFrame,
    /// Pose from which it was taken.
    pub view: View,
    /// Start of the search for the midline; `None` if the work is outside the camera's view.
    pub aim: Option<Aim>,
    /// Midline found.
    pub found: &'a Found,
    /// The crawl after the frame.
    pub crawl: &'a Crawl<'a>,
    /// Its next command.
    pub next: &'a Command,
}

/// Equipment of a crawl.
pub struct Setup<'a> {
    /// The machine that the camera belongs to.
    pub machine: &'a Machine,
    /// The camera.
    pub sensor: &'a Sensor,
    /// Finder of the joint in frames.
    pub midline: &'a mut dyn Midline,
    /// Answers when the joint is lost.
    pub operator: &'a mut dyn Operator,
}

/// Crawls along a joint with the camera of `setup`, which `rig` carries. `each` gets every frame.
///
/// # Errors
/// A frame that is not available or lacks the machine's axis positions; errors of `each`.
pub fn teach<E: From<FrameError>>(
    setup: Setup<'_>,
    crawl: &mut Crawl,
    rig: &mut dyn Rig,
    each: &mut dyn FnMut(&Look) -> Result<(), E>,
) -> Result<TaughtRun, E> {
    let Setup { machine, sensor, midline, operator } = setup;
    let mut run = TaughtRun::default();
    let mut command = crawl.next(Event::Start);
    loop {
        command = match command {
            Command::Move(pose) => match rig.go(&pose) {
                Ok(()) => crawl.next(Event::Reached),
                Err(why) => crawl.next(Event::Refused(why)),
            },
            Command::Look => {
                let Some(frame) = rig.frame()? else { return Ok(run) };
                let axes = positions(machine, &frame, run.axes.len())?;
                run.axes.push(axes);
                run.seconds = frame.t_s;
                let view = View { camera: machine.camera_frame(sensor, &axes), height: frame.height_mm };
                let aim = crawl.aim(&view).ok();
                let found = match (&aim, frame.image.frame()) {
                    (Some(aim), Ok(picture)) => midline.find(&picture, aim),
                    _ => Found::nothing(),
                };
                let next = crawl.next(Event::Seen(Seen { view, rows: &found.rows, end: found.end }));
                each(&Look { frame: &frame, view, aim, found: &found, crawl, next: &next })?;
                next
            }
            Command::Ask(why) => {
                let answer = operator.answer(&why, crawl);
                run.asked.push(why);
                crawl.next(Event::Operator(answer))
            }
            Command::Done(end) => {
                run.end = Some(end);
                return Ok(run);
            }
        };
    }
}

fn positions(machine: &Machine, frame: &TimedFrame, number: usize) -> Result<Joints, FrameError> {
    let given = frame.axes.as_deref().unwrap_or_default();
    if given.len() != machine.axes.len() {
        return Err(FrameError::Header {
            frame: number,
            field: Field::Axes,
            found: Message::verbatim(given.len().to_string()),
            allowed: Message::new("cell-frame-machine-axes").count("n", machine.axes.len()),
        });
    }
    Ok(machine.joints_from_file(given))
}
