use crate::crawl::Crawl;
use crate::events::End;
use crate::frame_note::CameraNote;
use crate::job::smooth;
use crate::picture::Picture;
use crate::run::TaughtRun;
use crate::smoothing::LinePoint;
use crate::taught_line::TaughtLine;
use seamwright_message::Message;
use seamwright_program::{Finding, PathRange};

/// Result of teaching. Without frames (the operator's points) there is only the smooth line.
#[derive(Default)]
pub struct Outcome {
    /// The line as it was seen.
    pub line: TaughtLine,
    /// The same smoothed, its points evenly spread.
    pub smooth: Vec<LinePoint>,
    /// A note of each frame.
    pub notes: Vec<CameraNote>,
    /// Reason of each question to the operator.
    pub asked: Vec<Message>,
    /// Time of the last frame, s.
    pub seconds: f64,
    /// Reason of the end, in a word.
    pub ended: &'static str,
    /// Distance of the end of a closed line from its start, mm.
    pub gap_mm: Option<f64>,
    /// Reason why the joint was not taught to its end.
    pub finding: Option<Message>,
    /// The last frame.
    pub picture: Option<Picture>,
}

impl Outcome {
    /// Of a joint following; `said_end`: the operator has ended the joint there.
    pub fn of(crawl: &Crawl, run: &TaughtRun, said_end: bool) -> Self {
        let finding = unfinished(run, said_end);
        let ended = match (&run.end, &finding) {
            (Some(End::Limit(_)), _) => "limit",
            (Some(End::TooLong), _) => "too-long",
            (Some(End::Closed { .. }), _) => "closed",
            (Some(End::JointEnd), _) => "joint-end",
            (Some(End::Operator), None) => "operator",
            (Some(End::Operator), Some(_)) => "lost",
            (None, _) => "out-of-frames",
        };
        let gap_mm = match &run.end {
            Some(End::Closed { gap_mm }) => Some(*gap_mm),
            _ => None,
        };
        let line = crawl.levelled();
        Self {
            smooth: smooth(&line, run.end.as_ref()),
            line,
            notes: crawl.notes().to_vec(),
            asked: run.asked.clone(),
            seconds: run.seconds,
            ended,
            gap_mm,
            finding,
            ..Self::default()
        }
    }
}

/// Reason why the joint following did not reach its end.
fn unfinished(run: &TaughtRun, said_end: bool) -> Option<Message> {
    match &run.end {
        Some(End::Closed { .. } | End::JointEnd) => None,
        Some(End::Limit(why)) => Some(Message::new("project-teach-machine-limit").message("why", why.clone())),
        Some(End::TooLong) => Some(Message::new("project-teach-joint-too-long")),
        Some(End::Operator) if said_end => None,
        Some(End::Operator) => {
            Some(run.asked.last().cloned().unwrap_or_else(|| Message::new("project-teach-joint-lost")))
        }
        None => Some(Message::new("project-teach-no-more-frames")),
    }
}

/// Finding that the joint was taught for `way` mm only.
pub fn finding(why: Message, way: f64) -> Finding {
    Finding::error("teach", why, 1, PathRange::at(way), Message::new("project-cure-teach"))
}
