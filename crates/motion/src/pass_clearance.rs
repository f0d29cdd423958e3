use crate::joint_path::JointPath;
use crate::transfer::{RootAt, nearest, too_near};
use seamwright_clearance::Limits;
use seamwright_machine::Surroundings;
use seamwright_message::Message;
use seamwright_program::{Finding, PathRange, TorchPath};
use serde::{Deserialize, Serialize};

/// Clearance along a pass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PassClearance {
    /// Minimum distance (mm) of everything watched at path lengths of the pass (mm), up to the cut-off.
    pub found: Vec<(f64, f64)>,
    /// For each stretch of the pass: its end (mm), and a proven lower bound (mm) of all watched distances in it, up to
    /// the cut-off. The bound is up to a tenth less than the distances found.
    pub at_least: Vec<(f64, f64)>,
    /// The minimum distance found: mm, path length, and the two solids.
    pub nearest: Option<(f64, f64, [Message; 2])>,
    /// Everything that is watched.
    pub watched: Vec<Message>,
    /// Maximum distance that is reported, mm.
    pub cutoff_mm: f64,
}

const STATIONS: usize = 400;
const CUTOFF_MM: f64 = 60.0;
/// Maximum length of the shortest cells, mm: in longer ones a clearance near its minimum is not proven. A spiral may be
/// hundreds of metres long.
const MAX_SMALLEST_MM: f64 = 1e-3;

/// Computes distances along the axes' `path` of pass `number`, whose torch follows `torch`, and findings for stretches
/// below a minimum clearance. None if nothing is watched.
pub(crate) fn pass_clearance(
    around: &Surroundings,
    path: &JointPath,
    torch: &dyn TorchPath,
    number: usize,
) -> (Option<PassClearance>, Vec<Finding>) {
    let smallest = (1e-6 * path.length()).min(MAX_SMALLEST_MM);
    let limits = Limits { cutoff_mm: CUTOFF_MM, precision_mm: 0.2, smallest };
    if around.is_empty() {
        return (None, Vec::new());
    }
    let finding = |message, from_mm, to_mm| {
        let cure = Message::new("motion-cure-clearance");
        Finding::error("clearance", message, number, PathRange { from_mm, to_mm }, cure)
    };
    let profile = match around.along(path, STATIONS, &limits) {
        Ok(profile) => profile,
        // An unchecked pass counts as not clear.
        Err(e) => return (None, vec![finding(e.message(), 0.0, path.length())]),
    };
    let findings = profile.stretches.iter().map(|s| {
        let root = RootAt::of(torch, s.s);
        finding(too_near(around, s.watch, &s.nearest, root.as_ref()), s.from, s.to)
    });
    let at_least = (0..STATIONS).filter_map(|i| {
        let (_, cell) = profile.nearest(i)?;
        Some((profile.edges[i + 1], cell.at_least_mm))
    });
    let nearest = nearest(around, &profile);
    let distances = around.at_edges(path, &profile, CUTOFF_MM);
    let found = profile.edges.iter().copied().zip(distances).collect();
    let clearance =
        PassClearance { found, at_least: at_least.collect(), nearest, watched: around.watched(), cutoff_mm: CUTOFF_MM };
    (Some(clearance), findings.collect())
}
