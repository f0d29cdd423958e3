use crate::joint_path::JointPath;
use crate::weld_motion::WeldMotion;
use seamwright_machine::{Joints, Machine};
use seamwright_message::Message;

/// Number of even samples along a pass at which margins are measured.
const SAMPLES: u32 = 360;

/// Distance from a singular attitude (sine of the angle) below which the score of a placement falls.
const SINGULAR_NEAR: f64 = 0.342;

/// Result of judging a placement.
#[derive(Debug, Clone, PartialEq)]
pub enum Judgement {
    /// The axes follow the whole seam.
    Weldable(PlacementMargin),
    /// They do not.
    Fails(PlacementFault),
}

impl Judgement {
    /// Rank of the placement: 0 to 1 if weldable, negative otherwise; larger is better.
    pub fn score(&self) -> f64 {
        match self {
            Self::Weldable(margin) => margin.score(),
            Self::Fails(fault) => -fault.shortfall.max(f64::MIN_POSITIVE),
        }
    }

    /// The margin of a weldable placement.
    pub fn margin(&self) -> Option<&PlacementMargin> {
        match self {
            Self::Weldable(margin) => Some(margin),
            Self::Fails(_) => None,
        }
    }

    /// The fault of a placement that fails.
    pub fn fault(&self) -> Option<&PlacementFault> {
        match self {
            Self::Weldable(_) => None,
            Self::Fails(fault) => Some(fault),
        }
    }
}

/// The axis nearest to an end of its range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MarginAxis {
    /// Index of the axis.
    pub axis: usize,
    /// Pass, from 1.
    pub pass: usize,
    /// Path length in the pass, mm.
    pub s: f64,
}

/// Distances of the axes from their limits over the whole seam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlacementMargin {
    /// Minimum distance of an axis from an end of its range, as a fraction of the range: 0 at an end, 0.5 in the middle.
    pub range: f64,
    /// The axis with it; none if no axis has a range.
    pub nearest: Option<MarginAxis>,
    /// Minimum distance from a singular attitude, 0 to 1: the sine of the angle; none if the machine has none.
    pub singular: Option<f64>,
    /// Maximum use of an axis' speed, as a fraction of its limit.
    pub speed_use: f64,
}

impl Default for PlacementMargin {
    /// Margin of axes that stand still in the middle of their ranges.
    fn default() -> Self {
        Self { range: 0.5, nearest: None, singular: None, speed_use: 0.0 }
    }
}

impl PlacementMargin {
    /// Margin of a planned motion of `machine`. Only the ranges are measured.
    pub fn of_plan(machine: &Machine, motion: &WeldMotion) -> Self {
        let mut margin = Self::default();
        for (pass, planned) in (1..).zip(&motion.passes) {
            places(&planned.path).into_iter().for_each(|s| margin.lower_range(machine, &planned.path.at(s), pass, s));
        }
        margin
    }

    /// Lowers the margin to the distance of the axes at `q` from the ends of their ranges.
    pub(super) fn lower_range(&mut self, machine: &Machine, q: &Joints, pass: usize, s: f64) {
        for (i, axis) in machine.axes.iter().enumerate() {
            let Some((low, high)) = axis.range else { continue };
            let part = (q[i] - low).min(high - q[i]) / (high - low);
            if part < self.range {
                self.range = part.max(0.0);
                self.nearest = Some(MarginAxis { axis: i, pass, s });
            }
        }
    }

    /// Rank among weldable placements, 0 to 1: twice the distance from the ends of the ranges, reduced by up to half
    /// within 20 degrees of a singular attitude.
    pub fn score(&self) -> f64 {
        let singular = self.singular.map_or(1.0, |distance| (distance / SINGULAR_NEAR).clamp(0.0, 1.0));
        2.0 * self.range * (0.5 + 0.5 * singular)
    }
}

/// Path lengths at which margins are measured: even samples and the ends of panels. Where an axis turns back, a panel is
/// short.
pub(super) fn places(path: &JointPath) -> Vec<f64> {
    let length = path.length();
    let mut places = path.edges();
    places.extend((0..=SAMPLES).map(|i| length * f64::from(i) / f64::from(SAMPLES)));
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Kind of reason why a placement fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FaultKind {
    /// No axis positions reach a station.
    Reach,
    /// An axis leaves its range, also on other whole turns.
    Range,
    /// Every station is reached, but no continuous motion leads along the path.
    Jump,
    /// An axis is too slow for the requested speed.
    Speed,
    /// The procedure does not allow the welding position.
    Position,
}

impl FaultKind {
    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reach => "reach",
            Self::Range => "range",
            Self::Jump => "jump",
            Self::Speed => "speed",
            Self::Position => "position",
        }
    }
}

/// Reason why a placement fails.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacementFault {
    /// Kind of the reason.
    pub kind: FaultKind,
    /// Pass, from 1.
    pub pass: usize,
    /// Path length in the pass, mm.
    pub s: f64,
    /// Index of the axis, if one is the reason.
    pub axis: Option<usize>,
    /// Description.
    pub reason: Message,
    /// Size of the fault, above 0: leads the local search towards weldable placements.
    pub shortfall: f64,
}
