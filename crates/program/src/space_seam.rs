//! Seams that curve through space.

use crate::{FilletOrButt, WallFaces};
use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, Finite, Point, Positive};
use serde::{Deserialize, Serialize};

/// A helix on a cylinder: the foot of a helical strip, or a butt joint such as that of a spiral-welded tube.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Helix {
    /// Radius of the cylinder, mm.
    pub radius_mm: Positive,
    /// Climb a turn along `direction`, mm; negative: left-handed.
    pub pitch_mm: Finite,
    /// Number of turns, counter-clockwise seen from the tip of `direction`.
    pub turns: Positive,
    /// The point of the axis at whose height the weld starts, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub origin_mm: Point,
    /// Direction of the axis; z if missing.
    #[serde(default = "Vector::z")]
    pub direction: Vector,
    /// Where the weld starts and the angle phi about the axis is 0, made perpendicular to `direction`; if missing x, or
    /// y with an axis along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero_direction: Option<Vector>,
    /// `fillet`: a strip stands on the cylinder, square to it; `butt`: both parts are the cylinder's wall.
    #[serde(default)]
    pub joint: FilletOrButt,
    /// The side that the strip of a fillet turns to the weld.
    #[serde(default)]
    pub wall_faces: WallFaces,
}
