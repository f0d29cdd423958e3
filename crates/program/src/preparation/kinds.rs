//! Sizes of each preparation, as a file gives them.

use schemars::JsonSchema;
use seamwright_document::{Finite, NonNegative, Positive};
use serde::{Deserialize, Serialize};

/// One of the two parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Member {
    /// The first part: nozzle, tube, wall.
    #[default]
    First,
    /// The second part: body, plate.
    Second,
}

/// Square butt preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Square {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
}

/// Single V preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SingleV {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Groove angle between the faces, degrees.
    pub angle_deg: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Double V preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DoubleV {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Groove angle between the faces, degrees.
    pub angle_deg: Positive,
    /// Groove angle on the back, degrees; as on the face if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub back_angle_deg: Option<Positive>,
    /// Depth of the preparation on the face, mm; if missing half of the thickness without the root face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<Positive>,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Single bevel preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bevel {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle from the square edge, degrees.
    pub angle_deg: Positive,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// The part that is bevelled.
    #[serde(default)]
    pub prepared: Member,
}

/// Double bevel preparation of a butt joint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DoubleBevel {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle from the square edge, degrees.
    pub angle_deg: Positive,
    /// Bevel angle on the back, degrees; as on the face if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub back_angle_deg: Option<Positive>,
    /// Depth of the preparation on the face, mm; if missing half of the thickness without the root face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<Positive>,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// The part that is bevelled.
    #[serde(default)]
    pub prepared: Member,
}

/// Single U preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct U {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle of each face, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius on each side, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Double U preparation: the same U on both sides.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DoubleU {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle of each face, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius on each side, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Depth of the preparation on the face, mm; if missing half of the thickness without the root face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<Positive>,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
}

/// Single J preparation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct J {
    /// Thickness, mm.
    pub thickness_mm: Positive,
    /// Bevel angle from the square edge, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// The part that is prepared.
    #[serde(default)]
    pub prepared: Member,
}

/// Corner joint: the square ends of two walls that touch, or nearly, along their inner edges. The seam is the line where
/// their outsides would meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Corner {
    /// Thickness of both walls, mm.
    pub thickness_mm: Positive,
    /// Root gap between the inner edges, mm.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
}

/// Fillet: give `leg_mm`, or both legs apart, or `throat_mm`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Fillet {
    /// Leg length on both parts, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub leg_mm: Option<Positive>,
    /// Leg length on the first part, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_leg_mm: Option<Positive>,
    /// Leg length on the second part, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_leg_mm: Option<Positive>,
    /// Throat, mm: equal legs that change with the dihedral angle so that the throat stays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub throat_mm: Option<Positive>,
    /// Root gap between the parts, mm, along the part that stands; the leg on that part is longer by it.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// The part that stands on the other.
    #[serde(default)]
    pub prepared: Member,
}

/// Lap joint: a plate lies on another, and a fillet joins its edge to that one's face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Lap {
    /// Thickness of the plate that lies on the other, mm.
    pub thickness_mm: Positive,
    /// Leg length on both parts, mm; up to the thickness.
    pub leg_mm: Positive,
    /// Gap between the plates, mm; the leg on the edge is longer by it.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// The part that lies on the other.
    #[serde(default)]
    pub prepared: Member,
}

/// Flare bevel: a round part that touches a flat one, filled to the line square to the flat one that touches the round
/// one. The seam is the line where those two meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlareBevel {
    /// Radius of the round part, mm.
    pub radius_mm: Positive,
    /// Depth next to the line of contact that is not filled, mm.
    #[serde(default)]
    pub unfilled_mm: NonNegative,
    /// The round part.
    #[serde(default)]
    pub round: Member,
}

/// Flare V: two round parts that touch, filled to the line that touches both. The seam lies on that line, above the
/// contact.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlareV {
    /// Radius of both parts, mm.
    pub radius_mm: Positive,
    /// Depth next to the line of contact that is not filled, mm.
    #[serde(default)]
    pub unfilled_mm: NonNegative,
}

/// Single bevel T: give the angle of the groove, or that of the cut.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TBevel {
    /// Thickness of the part whose edge is prepared, mm.
    pub thickness_mm: Positive,
    /// Groove angle between its bevel and the other part's face, degrees: the same all along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Positive>,
    /// Angle of the cut from the square edge, degrees: the same all along, so that the groove angle follows the
    /// dihedral angle, groove = cut + (dihedral - 90).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cut_deg: Option<Finite>,
    /// Root gap, mm, along the wall of the part whose edge is prepared: so far it is lifted off the other.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm: the part of the wall's thickness that is not bevelled.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// Leg of the cover fillet on the other part's face, mm.
    #[serde(default)]
    pub leg_mm: NonNegative,
    /// The part whose edge is prepared: `first` for a nozzle set on, `second` for one let into its shell.
    #[serde(default)]
    pub prepared: Member,
}

/// Double bevel T: an edge bevelled on both sides, that stands on a face. The back has a seam of its own, beyond the
/// standing part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TDoubleBevel {
    /// Thickness of the part whose edge is prepared, mm.
    pub thickness_mm: Positive,
    /// Groove angle between its bevel and the other part's face, degrees: the same all along the seam.
    pub angle_deg: Positive,
    /// Groove angle on the back, degrees; as on the face if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub back_angle_deg: Option<Positive>,
    /// Depth of the preparation on the face, mm; if missing half of the thickness without the root face.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<Positive>,
    /// Root gap, mm, along the wall of the part whose edge is prepared: so far it is lifted off the other.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm: the part of the wall's thickness that is not bevelled.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// Leg of the cover fillet on the other part's face, mm.
    #[serde(default)]
    pub leg_mm: NonNegative,
    /// The part whose edge is prepared.
    #[serde(default)]
    pub prepared: Member,
}

/// Single J on a face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TJ {
    /// Thickness of the part whose edge is prepared, mm.
    pub thickness_mm: Positive,
    /// Angle between the J's straight part and the other part's face, degrees.
    pub angle_deg: NonNegative,
    /// Radius at the bottom, mm.
    pub radius_mm: Positive,
    /// Land: level part between root face and radius, mm.
    #[serde(default)]
    pub land_mm: NonNegative,
    /// Root gap, mm, along the wall of the part whose edge is prepared: so far it is lifted off the other.
    #[serde(default)]
    pub root_gap_mm: NonNegative,
    /// Root face, mm: the part of the wall's thickness that is not prepared.
    #[serde(default)]
    pub root_face_mm: NonNegative,
    /// Leg of the cover fillet on the other part's face, mm.
    #[serde(default)]
    pub leg_mm: NonNegative,
    /// The part whose edge is prepared.
    #[serde(default)]
    pub prepared: Member,
}
