use schemars::JsonSchema;
use seamwright_document::{Finite, NonNegative, Point, Positive};
use serde::{Deserialize, Serialize};

/// Part of the seam replaced by taught points (SADDLE-2020): a cubic spline through them that leaves the nominal seam and
/// comes back to it smoothly.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Taught {
    /// Position at which the path leaves the nominal seam: path length, mm from the start of the weld.
    pub from_mm: NonNegative,
    /// Position at which the path is back on the nominal seam: path length, mm.
    pub to_mm: Positive,
    /// The points between, in the order of welding, in the seam's frame, mm.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points_mm: Vec<Point>,
    /// Recorded positions of the job's machine instead: a row of all axes a point, in the machine file's order, mm or
    /// degrees.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub axes: Vec<Vec<Finite>>,
    /// Maximum distance of a point from the nominal seam, mm; 10 if missing.
    #[serde(default = "usual", skip_serializing_if = "is_usual")]
    pub within_mm: Positive,
}

fn usual() -> Positive {
    Positive::new(10.0).unwrap_or(Positive::HALF)
}

fn is_usual(v: &Positive) -> bool {
    *v == usual()
}
