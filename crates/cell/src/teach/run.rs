//! A crawl from its start to its end.

use super::Carrier;
use crate::eyes::Eye;
use crate::frames::{FrameError, FrameSource, TimedFrame};
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
#[derive(Debug, Clone, PartialEq)]
pub struct TaughtRun {
    /// Why it ended.
    pub end: End,
    /// Axis positions at each frame, in their order.
    pub axes: Vec<Joints>,
    /// Why the operator was asked, each time.
    pub asked: Vec<String>,
    /// Time of the last frame, s.
    pub seconds: f64,
}

/// Seconds from a frame to the next one: the eye's period, and the slowest axis' way at half its speed.
fn pause(machine: &Machine, sensor: &Sensor, from: &Joints, to: &Joints) -> f64 {
    let axes = machine.axes.iter().zip(from.iter().zip(to));
    let slowest = axes.map(|(axis, (a, b))| 2.0 * (b - a).abs() / axis.max_speed).fold(0.0, f64::max);
    sensor.period_s * (slowest / sensor.period_s).ceil().max(1.0)
}

/// Crawls on a simulated machine, from frame to frame of its eye. `each` gets every frame.
///
/// # Errors
/// A frame that cannot be had; what `each` says.
pub fn crawl<E: From<FrameError>>(
    (machine, sensor): (&Machine, &Sensor),
    (crawl, carrier, eye): (&mut Crawl, &mut Carrier, &mut Eye),
    (midline, operator): (&mut dyn Midline, &mut dyn Operator),
    each: &mut dyn FnMut(&TimedFrame, &Crawl) -> Result<(), E>,
) -> Result<TaughtRun, E> {
    let mut run = TaughtRun { end: End::Operator, axes: Vec::new(), asked: Vec::new(), seconds: 0.0 };
    let mut command = crawl.next(Event::Start);
    loop {
        command = match command {
            Command::Move(pose) => {
                let before = *carrier.axes();
                match carrier.to(&pose) {
                    Ok(()) => {
                        if !run.axes.is_empty() {
                            run.seconds += pause(machine, sensor, &before, carrier.axes()) - sensor.period_s;
                        }
                        crawl.next(Event::Reached)
                    }
                    Err(why) => crawl.next(Event::Refused(why)),
                }
            }
            Command::Look => {
                run.seconds += sensor.period_s;
                eye.expose(run.seconds, carrier.axes());
                let Some(frame) = eye.next()? else {
                    run.end = End::Operator;
                    return Ok(run);
                };
                run.axes.push(*carrier.axes());
                each(&frame, crawl)?;
                look(machine, sensor, crawl, &frame, carrier.axes(), midline)
            }
            Command::Ask(why) => {
                let answer = operator.answer(&why, crawl);
                run.asked.push(why);
                crawl.next(Event::Operator(answer))
            }
            Command::Done(end) => {
                run.end = end;
                return Ok(run);
            }
        };
    }
}

/// A frame through the follower into the crawl.
fn look(
    machine: &Machine,
    sensor: &Sensor,
    crawl: &mut Crawl,
    frame: &TimedFrame,
    axes: &Joints,
    midline: &mut dyn Midline,
) -> Command {
    let view = View { camera: machine.camera_frame(sensor, axes), height: frame.height_mm };
    let found = match (crawl.aim(&view), frame.image.frame()) {
        (Ok(aim), Ok(picture)) => midline.find(&picture, &aim),
        // The work is not where the camera could see it.
        _ => Found::nothing(),
    };
    crawl.next(Event::Seen(Seen { view, rows: &found.rows, end: found.end }))
}

/// What became of recorded frames.
#[derive(Debug, Clone, PartialEq)]
pub enum Replay {
    /// The crawl came to its end.
    Ended(End),
    /// There were no more frames.
    OutOfFrames,
    /// It was lost, and why.
    Lost(String),
}

/// Plays recorded frames to a crawl: the moves it asks for were made when they were recorded. `each` gets every frame.
///
/// # Errors
/// A frame that cannot be read, or without axis positions; what `each` says.
pub fn replay<E: From<FrameError>>(
    (machine, sensor): (&Machine, &Sensor),
    (crawl, source): (&mut Crawl, &mut dyn FrameSource),
    midline: &mut dyn Midline,
    each: &mut dyn FnMut(&TimedFrame, &Crawl) -> Result<(), E>,
) -> Result<(Replay, TaughtRun), E> {
    let mut run = TaughtRun { end: End::Operator, axes: Vec::new(), asked: Vec::new(), seconds: 0.0 };
    crawl.next(Event::Start);
    crawl.next(Event::Reached);
    while let Some(frame) = source.next()? {
        let mut axes = Joints::default();
        let given = frame.axes.as_deref().unwrap_or_default();
        if given.len() != machine.axes.len() {
            return Err(FrameError::Header {
                frame: run.axes.len(),
                field: "number of axes",
                found: given.len().to_string(),
                allowed: format!("{}, those of the machine", machine.axes.len()),
            }
            .into());
        }
        for (value, (axis, given)) in axes.iter_mut().zip(machine.axes.iter().zip(given)) {
            *value = axis.from_file(*given);
        }
        run.axes.push(axes);
        run.seconds = frame.t_s;
        each(&frame, crawl)?;
        match look(machine, sensor, crawl, &frame, &axes, midline) {
            Command::Done(end) => {
                run.end = end.clone();
                return Ok((Replay::Ended(end), run));
            }
            Command::Ask(why) => {
                run.asked.push(why.clone());
                return Ok((Replay::Lost(why), run));
            }
            Command::Move(_) => {
                crawl.next(Event::Reached);
            }
            Command::Look => {}
        }
    }
    Ok((Replay::OutOfFrames, run))
}
