//! Result of the search, and the reason why no angles are clear.

use super::steps::MAX_TURN_DEG;
use super::{AngleChange, AngleLimits, AngleTask, Nearest};
use crate::transfer::{RootAt, too_near};
use seamwright_clearance::Evaluation;
use seamwright_machine::Surroundings;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange, TorchPath};

/// Result of [`search_angles`](super::search_angles).
#[derive(Debug, Clone, PartialEq)]
pub enum AngleSearch {
    /// The pass is clear as it is, or the axes cannot follow it: nothing is changed.
    Unchanged,
    /// With these changes it is clear.
    Changed(Vec<AngleChange>),
    /// No angles within the limits are clear, or the search was stopped.
    Blocked(Vec<Finding>),
}

/// How far the search came with changes that are the same all along.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Progress {
    /// A station has no work angle that is clear.
    SomeStations,
    /// All stations have one.
    AllStations,
    /// One was chosen at each station, and fails between them.
    AnglesChosen,
}

/// Reason why no angles are clear.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reason {
    /// No angle is allowed.
    NoneAllowed,
    /// The nearest bodies of a watch.
    TooNear(usize, Evaluation),
    /// The angles that are clear change too fast along the seam.
    TurnsTooFast {
        /// Usual distance of stations, mm.
        within_mm: f64,
    },
}

/// Obstacle of the changes that came farthest, of those with the most room among equals.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Setback(Option<Known>);

#[derive(Debug, Clone, Copy)]
struct Known {
    progress: Progress,
    margin: f64,
    s: f64,
    reason: Reason,
}

impl Setback {
    pub(super) fn note(&mut self, progress: Progress, s: f64, reason: Reason) {
        self.note_known(Known { progress, margin: 0.0, s, reason });
    }

    /// Notes the smallest margin at `s`; without one no angle is allowed there.
    pub(super) fn note_nearest(&mut self, progress: Progress, s: f64, nearest: Option<Nearest>) {
        let (margin, s, at) =
            nearest.map_or((f64::NEG_INFINITY, s, None), |nearest| (nearest.margin, nearest.s, nearest.at));
        let reason = at.map_or(Reason::NoneAllowed, |(watch, found)| Reason::TooNear(watch, found));
        self.note_known(Known { progress, margin, s, reason });
    }

    fn note_known(&mut self, new: Known) {
        let is_farther = |old: &Known| new.progress.cmp(&old.progress).then(new.margin.total_cmp(&old.margin)).is_gt();
        if self.0.as_ref().is_none_or(is_farther) {
            self.0 = Some(new);
        }
    }

    /// The finding that no angles are clear.
    pub(super) fn finding(&self, around: &Surroundings, path: &dyn TorchPath, task: &AngleTask) -> Finding {
        let AngleLimits { work, travel, stick_out } = task.limits;
        let s = self.0.map_or(0.0, |known| known.s);
        let reason = match self.0.map_or(Reason::NoneAllowed, |known| known.reason) {
            Reason::NoneAllowed => Message::new("motion-angle-none-allowed"),
            Reason::TooNear(watch, found) => too_near(around, watch, &found, RootAt::of(path, s).as_ref()),
            Reason::TurnsTooFast { within_mm } => Message::new("motion-angle-turns-too-fast")
                .value("turn", MAX_TURN_DEG, Unit::Deg)
                .quantity("way", within_mm, Unit::Mm, 1),
        };
        let code = if stick_out > 0.0 { "motion-no-torch-angle-longer" } else { "motion-no-torch-angle" };
        let mut message = Message::new(code)
            .quantity("work", work.to_degrees(), Unit::Deg, 1)
            .quantity("travel", travel.to_degrees(), Unit::Deg, 1)
            .message("reason", reason);
        if stick_out > 0.0 {
            message = message.quantity("longer", stick_out, Unit::Mm, 1);
        }
        let cure = Message::new("motion-cure-torch-angle");
        Finding::error("clearance", message, task.number, PathRange::at(s), cure)
    }
}
