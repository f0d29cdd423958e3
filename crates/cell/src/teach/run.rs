//! A crawl from its start to its end.

use super::Rig;
use super::rig::joints;
use crate::frames::{FrameError, TimedFrame};
use seamwright_machine::{Joints, Machine, Sensor};
use seamwright_tracking::teach::{Aim, Answer, Command, Crawl, End, Event, FrameEnd, Row, Seen, View};
use seamwright_vision::Frame;

/// What finds the joint's midline in a frame.
pub trait Midline {
    /// The midline from where `aim` says.
    fn find(&mut self, frame: &Frame, aim: &Aim) -> Found;
}

/// A midline.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Its rows in order.
    pub rows: Vec<Row>,
    /// Why they end.
    pub end: FrameEnd,
}

impl Found {
    /// Nothing.
    pub fn nothing() -> Self {
        Self { rows: Vec::new(), end: FrameEnd::Lost }
    }
}

/// Who is asked when the joint is lost.
pub trait Operator {
    /// What to do; `why` the eye is lost, and what was found so far.
    fn answer(&mut self, why: &str, crawl: &Crawl) -> Answer;
}

/// Nobody: what was found so far is all.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoOperator {
    /// Whether somebody was asked for.
    pub asked: bool,
}

impl Operator for NoOperator {
    fn answer(&mut self, _why: &str, _crawl: &Crawl) -> Answer {
        self.asked = true;
        Answer::End
    }
}

/// How a crawl went.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaughtRun {
    /// Why it ended; none: there were no more frames.
    pub end: Option<End>,
    /// Axis positions at each frame, in their order.
    pub axes: Vec<Joints>,
    /// Why the operator was asked, each time.
    pub asked: Vec<String>,
    /// Time of the last frame, s.
    pub seconds: f64,
}

/// A frame that was looked at.
#[derive(Clone, Copy)]
pub struct Look<'a> {
    /// The frame.
    pub frame: &'a TimedFrame,
    /// From where it was taken.
    pub view: View,
    /// Where the midline was looked for; none if the work is not where the camera could see it.
    pub aim: Option<Aim>,
    /// What was found.
    pub found: &'a Found,
    /// The crawl after it.
    pub crawl: &'a Crawl<'a>,
    /// What it wants next.
    pub next: &'a Command,
}

/// Crawls along a joint with the eye `sensor` of `machine`, which `rig` carries. `each` gets every frame.
///
/// # Errors
/// A frame that cannot be had, or without positions of the machine's axes; what `each` says.
pub fn teach<E: From<FrameError>>(
    (machine, sensor): (&Machine, &Sensor),
    crawl: &mut Crawl,
    rig: &mut dyn Rig,
    (midline, operator): (&mut dyn Midline, &mut dyn Operator),
    each: &mut dyn FnMut(&Look) -> Result<(), E>,
) -> Result<TaughtRun, E> {
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

/// Positions of the machine's axes with frame `number`.
fn positions(machine: &Machine, frame: &TimedFrame, number: usize) -> Result<Joints, FrameError> {
    let given = frame.axes.as_deref().unwrap_or_default();
    if given.len() != machine.axes.len() {
        return Err(FrameError::Header {
            frame: number,
            field: "number of axes",
            found: given.len().to_string(),
            allowed: format!("{}, those of the machine", machine.axes.len()),
        });
    }
    Ok(joints(machine, given))
}
