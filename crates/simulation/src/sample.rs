use crate::tracking::head_result::HeadSample;
use seamwright_executive::{Mode, VALUES};
use seamwright_machine::Joints;
use seamwright_motion::{Phase, ProfilePoint, SetPoint};

/// State of the simulated cell at one servo period; mm, rad, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// The pass, counted from 1; 0 in a transfer move, where all values along the seam are NaN.
    pub pass: usize,
    /// The set-point of this period.
    pub set: SetPoint,
    /// True axis positions.
    pub q: Joints,
    /// Following error of each axis: set-point less true position.
    pub following_error: Joints,
    /// Current of each drive, relative to its peak, -1 to 1.
    pub current: Joints,
    /// Path length of the planned path's nearest point to the true tip, along the seam, mm.
    pub tip_s: f64,
    /// Speed of the true tip along the planned path since the previous period, mm/s.
    pub tip_speed: f64,
    /// Planned speed over the same period, mm/s: the travel of the set-point's tip in it.
    pub planned_speed: f64,
    /// Distance of the true tip from the seam, normal to it, mm; the larger one of two torches that weld at once.
    pub path_error: f64,
    /// Angle between the true torch direction and the planned one there, rad.
    pub attitude_error: f64,
    /// Result of each welding head, if the seam may differ from the plan.
    pub heads: [Option<HeadSample>; 2],
    /// Mode of the cell.
    pub mode: Mode,
    /// Requested process values, by their names in alphabetic order; 0 while the arc is off.
    pub values: [f64; VALUES],
}

impl Sample {
    /// A sample outside of all passes: NaN along the seam, zero elsewhere.
    pub(crate) fn nowhere() -> Self {
        let profile = ProfilePoint { s: f64::NAN, v: f64::NAN, a: f64::NAN, j: f64::NAN };
        let none = Joints::default();
        Self {
            pass: 0,
            set: SetPoint { t: 0.0, phase: Phase::Transfer, profile, q: none },
            q: none,
            following_error: none,
            current: none,
            tip_s: f64::NAN,
            tip_speed: f64::NAN,
            planned_speed: f64::NAN,
            path_error: f64::NAN,
            attitude_error: f64::NAN,
            heads: [None; 2],
            mode: Mode::Off,
            values: [0.0; VALUES],
        }
    }

    /// Returns true while the arc (or beam) is on.
    pub fn arc(&self) -> bool {
        self.set.phase.arc()
    }

    /// Returns true while the torch is to travel.
    pub fn travels(&self) -> bool {
        self.set.phase == Phase::Travel
    }
}
