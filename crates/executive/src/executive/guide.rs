//! Seam tracking interface: corrections between the planned set-point of a pass and the orders of a cycle.

use super::device_interface::{Reports, SeamOrders};
use seamwright_machine::Joints;
use seamwright_tracking::beam::Picture;
use seamwright_tracking::lead::Sight;
use serde::{Deserialize, Serialize};

/// Tracking state of a head; lateral and height in the torch's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Tracked {
    /// Estimated joint position relative to the planned path.
    pub deviation_mm: [f64; 2],
    /// Offset of the torch from the planned path, by its encoders.
    pub correction_mm: [f64; 2],
    /// Standard deviation of the deviation; infinite if it is unknown.
    pub sigma_mm: f64,
    /// Confidence, 0 to 1: 1 as after a single good measurement, 0 without measurements.
    pub confidence: f64,
    /// Source of the estimate.
    pub sight: Sight,
}

/// Inputs of a guide in a cycle.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    /// The cell's clock at the start of the cycle, s.
    pub t_s: f64,
    /// Device reports at the end of the last cycle.
    pub reports: &'a Reports,
    /// The picture that came with them.
    pub picture: Option<Picture<'a>>,
}

/// Planned set-point of a pass in a cycle.
#[derive(Debug, Clone, Copy)]
pub struct Planned<'a> {
    /// Path length, mm.
    pub s_mm: f64,
    /// Path speed, mm/s; negative backwards.
    pub speed: f64,
    /// The torch travels at welding speed, with or without the process: a lost joint stops it.
    pub travels: bool,
    /// The torch is to come to rest.
    pub rests: bool,
    /// Positions of the axes.
    pub q: &'a Joints,
}

/// Tracking fault, as a number that [`super::Alarm::Tracking`] carries; the guide defines the text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trouble {
    /// Reported; the weld goes on.
    Tell(u8),
    /// The weld stops.
    Stop(u8),
}

impl Trouble {
    pub(super) fn detail(self) -> u8 {
        match self {
            Self::Tell(detail) | Self::Stop(detail) => detail,
        }
    }
}

/// Orders of a guide for a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Guided {
    /// Positions of the axes, mm or rad, within every limit.
    pub q: Joints,
    /// Their speeds.
    pub v: Joints,
    /// Their accelerations.
    pub a: Joints,
    /// Maximum feed override of the next cycle.
    pub feed_override: f64,
    /// Tracking fault.
    pub trouble: Option<Trouble>,
    /// Orders to the joint sensors.
    pub seam: SeamOrders,
}

impl Guided {
    /// Orders without a correction.
    pub fn as_planned(planned: &Planned<'_>) -> Self {
        let (v, a) = (Joints::default(), Joints::default());
        Self { q: *planned.q, v, a, feed_override: 1.0, trouble: None, seam: SeamOrders::default() }
    }
}

/// Corrects the set-points of passes, cycle by cycle. Corrections are a function of path length, so that speed changes,
/// holds and reverse motion need no special treatment. They come to rest with the torch. They never step, and respect
/// the part of every axis limit that the plan leaves.
///
/// No call may lock; only [`Guide::begin`] may allocate.
pub trait Guide {
    /// Prepares pass `pass` (from 0), run from `from_mm` on, with the process or without. Returns false if it is run
    /// uncorrected.
    fn begin(&mut self, pass: usize, from_mm: f64, welds: bool) -> bool;
    /// Runs one cycle of the search before the pass, from its start and back to it; `None` when the search is over.
    /// Comes to rest unless it `goes`, and ends only while it `goes`.
    fn look(&mut self, seen: &Seen<'_>, goes: bool) -> Option<Guided>;
    /// Returns whether the pass may be run after the search. Errors: the tracking fault.
    fn ready(&mut self) -> Result<(), Trouble>;
    /// Runs one cycle of the pass.
    fn follow(&mut self, seen: &Seen<'_>, planned: &Planned<'_>) -> Guided;
    /// Runs one cycle of the return to the planned positions `q` after the pass; `None` on arrival. Comes to rest
    /// unless it `goes`.
    fn settle(&mut self, seen: &Seen<'_>, q: &Joints, goes: bool) -> Option<Guided>;
    /// Returns the tracking state of each head; `None` outside guided passes.
    fn tracked(&self) -> [Option<Tracked>; 2];
}
