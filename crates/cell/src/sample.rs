use crate::executive::{Mode, VALUES};
use crate::tracking::HeadSample;
use seamwright_machine::Joints;
use seamwright_motion::{LawPoint, Phase, SetPoint};

/// What the simulated cell was at one servo period; mm, rad, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// The pass, counted from 1; 0 in an air move, where everything along the seam is no number.
    pub pass: usize,
    /// The set-point of this period.
    pub set: SetPoint,
    /// True axis positions.
    pub q: Joints,
    /// Following error of each axis: set-point less true position.
    pub following_error: Joints,
    /// Current of each drive as a part of its peak, -1 to 1.
    pub current: Joints,
    /// Place nearest to the true tip on the planned path, by path length along the seam, mm.
    pub tip_s: f64,
    /// Speed of the true tip along the planned path since the period before, mm/s.
    pub tip_speed: f64,
    /// Planned speed over the same period, mm/s: how far the set-point's tip moved in it.
    pub planned_speed: f64,
    /// Distance of the true tip from the seam, normal to it, mm; of two torches that weld at once the greater.
    pub path_error: f64,
    /// Angle between the true torch direction and the one asked for there, rad.
    pub attitude_error: f64,
    /// What each head that welds did, where the seam may lie elsewhere than planned.
    pub heads: [Option<HeadSample>; 2],
    /// What the cell was doing.
    pub mode: Mode,
    /// Process values that were asked for, by their names in alphabetic order; 0 while the arc is off.
    pub values: [f64; VALUES],
}

impl Sample {
    /// A sample of nothing: no numbers along the seam, everything else at 0.
    pub(crate) fn nowhere() -> Self {
        let law = LawPoint { s: f64::NAN, v: f64::NAN, a: f64::NAN, j: f64::NAN };
        let none = Joints::default();
        Self {
            pass: 0,
            set: SetPoint { t: 0.0, phase: Phase::Air, law, q: none },
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

    /// True while the arc (or beam) is on.
    pub fn arc(&self) -> bool {
        self.set.phase.arc()
    }

    /// True while the torch is to travel.
    pub fn travels(&self) -> bool {
        self.set.phase == Phase::Travel
    }
}
