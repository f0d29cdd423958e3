use super::picture::Picture;
use seamwright_cell::teach::{TaughtRun, Truth};
use seamwright_program::Finding;
use seamwright_tracking::teach::{Crawl, End, EyeNote, LinePoint, TaughtLine};

/// What teaching has found.
#[derive(Default)]
pub(super) struct Outcome {
    pub(super) line: TaughtLine,
    pub(super) smooth: Vec<LinePoint>,
    pub(super) notes: Vec<EyeNote>,
    pub(super) asked: Vec<String>,
    pub(super) seconds: f64,
    /// Why it ended, in a word.
    pub(super) ended: &'static str,
    pub(super) gap_mm: Option<f64>,
    /// Why the joint was not taught to its end.
    pub(super) finding: Option<String>,
    pub(super) truth: Option<Truth>,
    /// The last frame.
    pub(super) picture: Option<Picture>,
}

impl Outcome {
    /// Of a crawl; `finding` if it did not come to its end.
    pub(super) fn of(crawl: &Crawl, run: &TaughtRun, finding: Option<String>) -> Self {
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
            smooth: super::smooth(&line, run.end.as_ref()),
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

/// Why the joint was not taught to its end, `way` mm along it.
pub(super) fn finding(why: String, way: f64) -> Finding {
    Finding {
        kind: "teach",
        message: why,
        pass: 1,
        from_mm: way,
        to_mm: way,
        cure: "teach on from there with --start, allow a longer --longest-tack-mm, or take the points by hand"
            .to_owned(),
        allowed: false,
    }
}
