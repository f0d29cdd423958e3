use crate::branch::Branch;
use crate::joint::RimJoint;
use crate::nozzle::Nozzle;
use crate::plane_seam::{Arc, Circle, Polyline, RoundedRectangle};
use crate::space_seam::{Helix, Spline};
use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, Finite, NonNegative, Point, Positive};
use serde::{Deserialize, Serialize};

/// Which seam to weld.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Seam {
    /// A tubular nozzle on a body: where its wall, outside or inside, meets the body's.
    Nozzle(Nozzle),
    /// A tube that branches off another: a T-, Y- or K-joint.
    Branch(Branch),
    /// An ellipse in a plane: a tube on a plate, or a butt joint in the plate.
    Ellipse(Ellipse),
    /// A circle in a plane: a round tube on a plate, or a butt joint in the plate.
    Circle(Circle),
    /// An arc in a plane, through three points.
    Arc(Arc),
    /// A rectangle in a plane, its corners rounded or sharp: a square tube on a plate, or a butt joint in the plate.
    RoundedRectangle(RoundedRectangle),
    /// Straight lines from point to point in a plane.
    Polyline(Polyline),
    /// A helix on a cylinder: the foot of a helical strip, or a butt joint such as that of a spiral-welded tube.
    Helix(Helix),
    /// A cubic spline through points, or near them.
    Spline(Spline),
    /// A straight seam between two flat faces.
    Line(Line),
    /// A web that stands on a skin, straight or along an arc: one fillet, or both at once (DUALBEAM-2013).
    TJoint(TJoint),
    /// A butt joint around a tube, cut square or obliquely.
    Girth(Girth),
}

impl Seam {
    /// Kind of seam, in words.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Nozzle(_) => "nozzle",
            Self::Branch(_) => "branch",
            Self::Ellipse(_) => "ellipse",
            Self::Circle(_) => "circle",
            Self::Arc(_) => "arc",
            Self::RoundedRectangle(_) => "rounded rectangle",
            Self::Polyline(_) => "polyline",
            Self::Helix(_) => "helix",
            Self::Spline(_) => "spline",
            Self::Line(_) => "line",
            Self::TJoint(_) => "T-joint",
            Self::Girth(_) => "girth",
        }
    }
}

/// An elliptic seam in a plane (ELLIPSE-2015).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ellipse {
    /// Semi-axis along `a_direction`, mm.
    pub a_mm: Positive,
    /// Semi-axis across it, mm.
    pub b_mm: Positive,
    /// Centre, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Outward normal of the plate; z if missing. Angles count counter-clockwise seen from its tip.
    #[serde(default = "Vector::z")]
    pub normal: Vector,
    /// Direction of semi-axis a, where the eccentric angle is 0; x if missing.
    #[serde(default = "Vector::x")]
    pub a_direction: Vector,
    /// `fillet`: a tube stands on the plate and is welded outside; `butt`: both parts lie in the plate's plane.
    #[serde(default)]
    pub joint: RimJoint,
}

/// A straight seam between two flat faces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Line {
    /// Start of the weld, mm.
    pub start_mm: Point,
    /// End of the weld, mm.
    pub end_mm: Point,
    /// Outward normal of the first part's face.
    pub first_normal: Vector,
    /// Outward normal of the second part's face.
    pub second_normal: Vector,
}

/// A T-joint: a web of constant thickness that stands on a skin along a line or an arc.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TJoint {
    /// Start of the web's middle line on the skin, mm.
    pub start_mm: Point,
    /// End of the middle line, mm.
    pub end_mm: Point,
    /// A point of the middle line between them: it is the arc through the three; a straight line if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub via_mm: Option<Point>,
    /// Outward normal of the skin at the start, where the web stands; it turns with the arc. Made perpendicular to the
    /// middle line.
    pub skin_normal: Vector,
    /// Thickness of the web, mm.
    pub web_mm: Positive,
    /// Which fillet is welded, seen along the weld with the skin below.
    #[serde(default)]
    pub fillet: Side,
}

/// Which fillet of a T-joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The one on the left.
    #[default]
    Left,
    /// The one on the right.
    Right,
    /// Both in one motion, on a machine with two heads: the first welds the left one, and `s` counts along it.
    Both,
}

/// A butt joint around a circular tube: two lengths of tube meet at a plane cut. The first part is the one on the side
/// that `direction` points to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Girth {
    /// Radius of the surface that is welded, mm: the outer one, or the inner one with `inside`.
    pub radius_mm: Positive,
    /// True if it is welded from inside, the torch in the tube.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub inside: bool,
    /// Point in which the cut meets the tube's axis, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub origin_mm: Point,
    /// Direction of the axis; z if missing.
    #[serde(default = "Vector::z")]
    pub direction: Vector,
    /// Direction in which the angle phi about the axis is 0, made perpendicular to `direction`. If missing: x, or y for
    /// a tube along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero_direction: Option<Vector>,
    /// Normal of the cut's plane, within 85 degrees of the axis; if missing `direction`: a square cut.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut_normal: Option<Vector>,
}

/// Direction of welding along a closed seam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// Seen from the tip of the nozzle's or tube's direction or the plate's normal.
    #[default]
    CounterClockwise,
    /// The other way.
    Clockwise,
}

/// Position on the seam at which the weld's path length `s` is zero, and the direction in which it grows.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeamStart {
    /// Angle phi of the start about the nozzle's or tube's axis or the normal of a circle or rectangle (the eccentric
    /// angle of an ellipse), degrees; 0 if missing.
    #[serde(default)]
    pub phi_deg: Finite,
    /// Direction of welding.
    #[serde(default)]
    pub direction: Direction,
    /// Overlap of the weld beyond its start on a closed seam, mm.
    #[serde(default)]
    pub overlap_mm: NonNegative,
    /// Weld only to this angle, degrees, in the direction of welding, instead of all round.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub end_phi_deg: Option<Finite>,
}
