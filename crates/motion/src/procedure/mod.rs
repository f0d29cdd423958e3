//! Comparison of a planned pass with the welding procedure specification: process values, speed, heat input, torch
//! angles and welding position along the path, and findings for values outside their windows.
//!
//! All values are those of the plan: the speed that the axes can keep, the torch angles that they reach, and gravity in
//! the frame of the part as the machine's axes turn it. Acceleration and deceleration phase are not compared with the
//! windows of speed and heat input; a stop on the path is.

mod findings;
mod inclination;
mod planned_pass;
mod plausibility;
pub(crate) mod pool_check;
mod window_check;

pub use planned_pass::{PlannedPass, Quantity};
use seamwright_message::Message;
use seamwright_program::{FilletOrButt, Finding, Inclination, PositionStretch, Procedure};
use serde::{Deserialize, Serialize};

/// Values of a planned pass, and the windows of its procedure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PassProcedure {
    /// Passes of the procedure's run for this pass; none if no run matches.
    pub run: Option<Message>,
    /// Kind of weld, which determines the limits of positions.
    pub joint: FilletOrButt,
    /// Values along the pass with their windows.
    pub quantities: Vec<Quantity>,
    /// Heat input over path length (mm, kJ/mm) between acceleration and deceleration phase, a pair of points at each
    /// jump; empty if the power is unknown.
    pub heat_input: Vec<(f64, f64)>,
    /// Slope and rotation over path length (mm).
    pub inclinations: Vec<(f64, Inclination)>,
    /// Welding positions, one after the other.
    pub positions: Vec<PositionStretch>,
    /// Findings for values outside the procedure.
    #[serde(with = "seamwright_program::finding_data")]
    pub findings: Vec<Finding>,
}

impl PassProcedure {
    /// Compares a planned pass with `procedure`.
    pub fn new(procedure: &Procedure, planned: PlannedPass) -> Self {
        let run = procedure.run_of(planned.number, planned.pass);
        let lies = inclination::along(planned);
        let (min_dihedral, max_dihedral) = inclination::dihedrals(planned.path, &lies);
        let joint = procedure.joint(min_dihedral, max_dihedral);
        let limits = &procedure.position_limits;
        let places: Vec<f64> = lies.iter().map(|lie| lie.s).collect();
        let at = |s: f64| inclination::at(planned, s).inclination;
        let mut held = Self {
            run: run.map(findings::label),
            joint,
            quantities: window_check::quantities(procedure, run, planned, &lies),
            heat_input: window_check::heat_input(procedure, planned),
            inclinations: lies.iter().map(|lie| (lie.s, lie.inclination)).collect(),
            positions: limits.along(joint, &places, at),
            findings: Vec::new(),
        };
        held.findings = findings::findings(&held, procedure, run, planned);
        held.findings.extend(plausibility::findings(procedure, planned));
        held
    }

    /// Minimum and maximum slope, and minimum and maximum rotation (rad), over the samples in a stretch; none without
    /// samples in it.
    pub fn inclination_in(&self, stretch: &PositionStretch) -> Option<((f64, f64), (f64, f64))> {
        let inside = self.inclinations.iter().filter(|(s, _)| *s >= stretch.from_mm && *s <= stretch.to_mm);
        let grow = |(least, greatest): (f64, f64), v: f64| (v.min(least), v.max(greatest));
        inside.map(|(_, at)| at).fold(None, |ends: Option<((f64, f64), (f64, f64))>, at| {
            let (slope, rotation) = ends.unwrap_or(((at.slope, at.slope), (at.rotation, at.rotation)));
            Some((grow(slope, at.slope), grow(rotation, at.rotation)))
        })
    }
}
