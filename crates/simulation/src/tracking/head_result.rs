use glam::DVec2;
use seamwright_executive::Tracked;
use seamwright_executive::tracking::{AlarmAt, BeamSample, BeamSummary};
use seamwright_tracking::beam::DeviationRecord;
use serde::Serialize;

/// State of one head at one instant, lateral and height in the torch's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadSample {
    /// True position of the joint, from the planned path.
    pub seam: DVec2,
    /// Offset of the weld from the planned path: torch and deflection together.
    pub correction: DVec2,
    /// Deviation of the weld from the joint. A beam has no height: 0.
    pub miss: DVec2,
    /// State of the beam, if one corrects the pass.
    pub beam: Option<BeamSample>,
    /// Result of tracking.
    pub tracked: Option<Tracked>,
}

/// Distances of one head's weld from its joint; mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeadSummary {
    /// Name of the head.
    pub head: String,
    /// 99 % of the weld lie within this distance of the joint: lateral and height together, lateral only for a beam.
    pub miss_p99_mm: f64,
    /// Maximum distance of the weld.
    pub miss_most_mm: f64,
    /// 99 % of a weld along the planned path would lie within this distance.
    pub untracked_p99_mm: f64,
    /// Maximum distance of a weld along the planned path.
    pub untracked_most_mm: f64,
    /// True for a beam, which has no height: distances are lateral.
    pub lateral_only: bool,
    /// True if the pass was tracked.
    pub tracked: bool,
    /// Maximum used share of the limits of corrections: stroke, speed, acceleration, jerk.
    pub used: Option<[f64; 4]>,
    /// Position at which the torch was stopped before the end.
    pub stopped_mm: Option<f64>,
    /// Alarms reported during the pass.
    pub alarms: Vec<AlarmAt>,
    /// Corrections by the beam, if one corrected.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beam: Option<BeamSummary>,
    /// Deviations of the seam found by the beam, by path length from the start of the weld.
    #[serde(skip)]
    pub deviations: Option<DeviationRecord>,
}
