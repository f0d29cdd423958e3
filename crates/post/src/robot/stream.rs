//! A weld as a stream of set-points: positions of the arm's axes at the control's period (`servoj`).
//!
//! # Method
//!
//! Set-point k is the planned position at k periods after the start, so that the planned path, its weaving and its speed are
//! kept without lines and corners. The last one is the planned end; it comes up to a period later than planned. It is
//! repeated for the look-ahead time, because the arm follows the set-points that much later. Between two set-points the
//! axes are taken to move evenly.

use super::cutter::Course;
use super::language::RobotLanguage;
use super::program::{RobotProgram, RobotStep};
use super::weld_values::WeldValues;
use crate::error::Error;
use seamwright_motion::WeldMotion;
use seamwright_program::Pass;

/// Maximum number of set-points of a program. Universal Robots states no limit: this is a text of about 12 MB.
pub const MAX_SET_POINTS: usize = 100_000;

/// Settings of a stream of set-points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ServoStream {
    /// Time between two set-points, s: a multiple of [`ServoStream::CYCLE_S`].
    pub period_s: f64,
    /// Look-ahead time of the control, s.
    pub lookahead_s: f64,
    /// Proportional gain of the control.
    pub gain: f64,
}

impl ServoStream {
    /// Cycle of the control, s: e-Series; it is 8 ms on CB3.
    pub const CYCLE_S: f64 = 0.002;
    /// Maximum period, s: longer ones make a path of straight pieces in axis space.
    pub const MAX_PERIOD_S: f64 = 0.04;
    /// Range of the look-ahead time, s (URScript manual, `servoj`).
    pub const LOOKAHEAD_S: [f64; 2] = [0.03, 0.2];
    /// Range of the gain (URScript manual, `servoj`).
    pub const GAIN: [f64; 2] = [100.0, 2000.0];

    /// The usual settings of `servoj` for a period.
    pub fn with_period(period_s: f64) -> Self {
        Self { period_s, lookahead_s: 0.1, gain: 300.0 }
    }

    /// Number of periods for a motion of `seconds`.
    pub(super) fn count(&self, seconds: f64) -> usize {
        (seconds / self.period_s - 1e-6).ceil().max(1.0) as usize
    }

    /// Number of periods for which the end of a weld is held.
    pub(super) fn hold(&self) -> usize {
        self.count(self.lookahead_s)
    }
}

/// Positions of the arm's axes, one each period.
#[derive(Debug, Clone, PartialEq)]
pub struct SetPoints {
    /// Settings of the stream.
    pub stream: ServoStream,
    /// Positions of the arm's axes at the ends of the periods, degrees.
    pub positions: Vec<[f64; 6]>,
}

/// Refuses a language without streams, and more set-points than a program takes.
pub(super) fn check(language: RobotLanguage, motion: &WeldMotion, stream: &ServoStream) -> Result<(), Error> {
    if language != RobotLanguage::Urscript {
        return Err(Error::NoStream { language });
    }
    let counts = motion.passes.iter().map(|pass| stream.count(pass.profile.duration()) + stream.hold());
    let count: usize = counts.sum();
    if count > MAX_SET_POINTS {
        return Err(Error::TooManySetPoints { count, period_ms: 1e3 * stream.period_s });
    }
    Ok(())
}

/// The set-points of a pass with its process values, which change at the times `breaks`.
pub(super) fn set_points(pass: &Pass, course: &Course, breaks: &[f64], stream: ServoStream) -> Vec<RobotStep> {
    let duration = course.motion.profile.duration();
    let count = stream.count(duration);
    let times = (1..=count).map(|k| (k as f64 * stream.period_s).min(duration));
    let mut steps = Vec::new();
    let mut points = SetPoints { stream, positions: Vec::new() };
    let mut ends = breaks.iter().copied().chain([duration]).peekable();
    let mut from = 0.0;
    let mut values = values_between(pass, course, from, ends.peek().copied().unwrap_or(duration));
    for time in times {
        // The values of an interval are those at its middle.
        while let Some(end) = ends.next_if(|end| time - 0.5 * stream.period_s > *end) {
            from = end;
        }
        let now = values_between(pass, course, from, ends.peek().copied().unwrap_or(duration));
        if pass.has_arc() && now != values {
            values = now;
            if !points.positions.is_empty() {
                let positions = std::mem::take(&mut points.positions);
                steps.push(RobotStep::SetPoints(SetPoints { stream, positions }));
            }
            steps.push(RobotStep::Values(now));
        }
        points.positions.push(course.arm.arm_deg(&course.at(time).q));
    }
    let end = course.arm.arm_deg(&course.at(duration).q);
    points.positions.extend(std::iter::repeat_n(end, stream.hold()));
    steps.push(RobotStep::SetPoints(points));
    steps
}

/// Process values in the middle between two times.
pub(super) fn values_between(pass: &Pass, course: &Course, from: f64, to: f64) -> WeldValues {
    let [from, to] = [from, to].map(|time| course.motion.profile.at(time, &mut 0).s);
    WeldValues::of(pass, 0.5 * (from + to))
}

impl RobotProgram {
    /// True if the program has a stream of set-points.
    pub(super) fn has_stream(&self) -> bool {
        self.steps.iter().any(|step| matches!(step, RobotStep::SetPoints(_)))
    }
}
