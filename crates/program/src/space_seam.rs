//! Seams that curve through space.

use crate::joint::FilletOrButt;
use crate::plane_seam::WallFaces;
use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, Finite, NonNegative, Point, Positive};
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
    /// Direction in which the weld starts and the angle phi about the axis is 0, made perpendicular to `direction`. If
    /// missing: x, or y for an axis along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero_direction: Option<Vector>,
    /// `fillet`: a strip stands on the cylinder, square to it; `butt`: both parts are the cylinder's wall.
    #[serde(default)]
    pub joint: FilletOrButt,
    /// The side that the strip of a fillet turns to the weld.
    #[serde(default)]
    pub wall_faces: WallFaces,
}

/// A free seam: a cubic spline through points, or near them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Spline {
    /// The points in the order of welding, mm; at least two, or three of a closed seam.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub points_mm: Vec<Point>,
    /// A CSV file with the points instead: columns `x_mm,y_mm,z_mm`, and, if wanted, the faces' outward normals
    /// `n1x,n1y,n1z,n2x,n2y,n2z`, or `n1x,n1y,n1z` alone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// Maximum distance of the seam from a point, mm, which saves knots; 0: through all points.
    #[serde(default)]
    pub tolerance_mm: NonNegative,
    /// Whether the weld goes on from the last point to the first.
    #[serde(default)]
    pub closed: bool,
    /// Direction at the first point; without it the seam has no curvature there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_tangent: Option<Vector>,
    /// Direction at the last point.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_tangent: Option<Vector>,
    /// Outward normal of the plate, made square to the seam; z if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Vector>,
    /// A normal for each point: with `second_normals` those of the first part's face, alone those of the plate.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub first_normals: Vec<Vector>,
    /// The second part's outward normals, one for each point.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub second_normals: Vec<Vector>,
    /// `fillet`: a wall stands on the plate along the seam; `butt`: both parts lie in the plate.
    #[serde(default)]
    pub joint: FilletOrButt,
    /// The side that the wall of a fillet turns to the weld.
    #[serde(default)]
    pub wall_faces: WallFaces,
}
