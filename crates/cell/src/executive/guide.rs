//! Where corrections enter: between the planned set-point of a pass and the orders of a cycle.

use super::Reports;
use seamwright_machine::Joints;
use seamwright_tracking::beam::{Beam, Picture};
use seamwright_tracking::lead::Sight;

/// What is asked of the sensors that see the joint, and of the beam that is deflected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamOrders {
    /// The cell's clock at the begin of the period, s: exposures are stamped with it.
    pub t_s: f64,
    /// The pass whose joint is looked at, counted from 1; 0: none.
    pub pass: usize,
    /// Path length of the torch's set-point in it, mm; less than 0 before its start.
    pub s_mm: f64,
    /// The torch is on its path, where it may weave.
    pub weaves: bool,
    /// What the beam does.
    pub beam: Beam,
    /// By how much it is deflected, lateral, mm.
    pub deflection_mm: f64,
}

impl Default for SeamOrders {
    fn default() -> Self {
        Self { t_s: 0.0, pass: 0, s_mm: 0.0, weaves: false, beam: Beam::Weld, deflection_mm: 0.0 }
    }
}

/// What is known of a head that is tracked; lateral and height in the torch's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tracked {
    /// Where the joint is believed to be, from the planned path.
    pub deviation_mm: [f64; 2],
    /// By how much the torch is off the planned path, as its encoders say.
    pub correction_mm: [f64; 2],
    /// Standard deviation of the deviation; infinite where nothing is known.
    pub sigma_mm: f64,
    /// How sure that is, 0 to 1: 1 as of a single good measurement, 0 where nothing was seen.
    pub confidence: f64,
    /// How it is known.
    pub sight: Sight,
}

/// What a guide may know in a cycle.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    /// The cell's clock at the begin of the cycle, s.
    pub t_s: f64,
    /// What the devices reported at the end of the last one.
    pub reports: &'a Reports,
    /// The picture that came with that.
    pub picture: Option<Picture<'a>>,
}

/// A cycle of a pass as it is planned.
#[derive(Debug, Clone, Copy)]
pub struct Planned<'a> {
    /// Path length, mm.
    pub s_mm: f64,
    /// Along the path, mm/s; less than 0 backwards.
    pub speed: f64,
    /// The torch travels as it welds, or would with the process: what is lost stops it.
    pub travels: bool,
    /// It is to be at rest.
    pub rests: bool,
    /// Positions of the axes.
    pub q: &'a Joints,
}

/// What is wrong, as a number that [`super::Alarm::Tracking`] carries; the guide knows the words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trouble {
    /// The weld goes on.
    Tell(u8),
    /// It does not.
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
    /// Greatest part of the planned speed that the torch may have next.
    pub pace: f64,
    /// What is wrong.
    pub trouble: Option<Trouble>,
    /// For what sees the joint.
    pub seam: SeamOrders,
}

impl Guided {
    /// Orders of a guide that corrects nothing.
    pub fn as_planned(planned: &Planned<'_>) -> Self {
        let (v, a) = (Joints::default(), Joints::default());
        Self { q: *planned.q, v, a, pace: 1.0, trouble: None, seam: SeamOrders::default() }
    }
}

/// Corrects the set-points of passes, cycle by cycle. Corrections belong to path length: speed changes, holds and going back
/// are nothing special to them. At rest they come to rest too. They never step, and keep within what the plan leaves of every
/// axis' limits.
///
/// No call may lock; none but [`Guide::begin`] may allocate.
pub trait Guide {
    /// Pass `pass` (from 0) is to be run from `from_mm` on, with the process or without; false if it is run as planned.
    fn begin(&mut self, pass: usize, from_mm: f64, welds: bool) -> bool;
    /// A cycle of what has to be seen before the pass is run, from and to the place where it begins; none when that is over.
    /// Comes to rest unless it `goes`, and is not over before it does.
    fn look(&mut self, seen: &Seen<'_>, goes: bool) -> Option<Guided>;
    /// Whether the pass may be run after that.
    ///
    /// # Errors
    /// What is wrong.
    fn ready(&mut self) -> Result<(), Trouble>;
    /// A cycle of the pass.
    fn follow(&mut self, seen: &Seen<'_>, planned: &Planned<'_>) -> Guided;
    /// A cycle of the way back to the planned positions `q` after the pass; none when they are there. Comes to rest unless it
    /// `goes`.
    fn settle(&mut self, seen: &Seen<'_>, q: &Joints, goes: bool) -> Option<Guided>;
    /// What is known of each head; none beside passes that are guided.
    fn tracked(&self) -> [Option<Tracked>; 2];
}
