//! Seams in a plane.

use crate::joint::{FilletOrButt, RimJoint};
use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, NonNegative, Point, Positive};
use serde::{Deserialize, Serialize};

/// A circle in a plane: a round tube on a plate, or a butt joint in the plate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Circle {
    /// Radius, mm.
    pub radius_mm: Positive,
    /// Centre, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Outward normal of the plate; z if missing. Angles count counter-clockwise seen from its tip.
    #[serde(default = "Vector::z")]
    pub normal: Vector,
    /// Direction in which the angle phi about the normal is 0, made perpendicular to it. If missing: x, or y for a
    /// normal along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero_direction: Option<Vector>,
    /// `fillet`: a tube stands on the plate and is welded outside; `butt`: both parts lie in the plate's plane; `corner`:
    /// the plate closes the tube's end.
    #[serde(default)]
    pub joint: RimJoint,
}

/// An arc in a plane, through three points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Arc {
    /// Start of the weld, mm.
    pub start_mm: Point,
    /// A point between start and end, mm.
    pub via_mm: Point,
    /// End of the weld, mm.
    pub end_mm: Point,
    /// Outward normal of the plate, which the three points lie in; z if missing.
    #[serde(default = "Vector::z")]
    pub normal: Vector,
    /// `fillet`: a wall stands on the plate along the arc; `butt`: both parts lie in the plate's plane.
    #[serde(default)]
    pub joint: FilletOrButt,
    /// The side that the wall of a fillet turns to the weld.
    #[serde(default)]
    pub wall_faces: WallFaces,
}

/// Side to which the face of a wall on a plate points, seen along the weld with the plate below.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WallFaces {
    /// To the right: the outside of what the weld goes round counter-clockwise.
    #[default]
    Right,
    /// To the left.
    Left,
}

/// A rectangle in a plane, its corners rounded or sharp: a square tube on a plate, or a butt joint in the plate.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RoundedRectangle {
    /// Width along `width_direction`, mm.
    pub width_mm: Positive,
    /// Height across it, mm.
    pub height_mm: Positive,
    /// Radius of the corners, mm, up to half the smaller side; 0: sharp.
    pub corner_mm: NonNegative,
    /// Centre, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Outward normal of the plate; z if missing. Angles about it count counter-clockwise seen from its tip.
    #[serde(default = "Vector::z")]
    pub normal: Vector,
    /// Direction of the width, where the angle phi is 0, made perpendicular to the normal; if missing x, or y with a
    /// normal along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width_direction: Option<Vector>,
    /// `fillet`: a tube stands on the plate and is welded outside; `butt`: both parts lie in the plate's plane; `corner`:
    /// the plate closes the tube's end.
    #[serde(default)]
    pub joint: RimJoint,
}

/// Straight lines from point to point in a plane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Polyline {
    /// The points in the order of welding, mm; at least two, or three of a closed seam.
    pub points_mm: Vec<Point>,
    /// Whether the weld goes back from the last point to the first.
    #[serde(default)]
    pub closed: bool,
    /// Outward normal of the plate, which the points lie in; z if missing.
    #[serde(default = "Vector::z")]
    pub normal: Vector,
    /// `fillet`: a wall stands on the plate along the lines; `butt`: both parts lie in the plate's plane.
    #[serde(default)]
    pub joint: FilletOrButt,
    /// The side that the wall of a fillet turns to the weld.
    #[serde(default)]
    pub wall_faces: WallFaces,
}
