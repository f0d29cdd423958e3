use schemars::JsonSchema;
use seamwright_document::{Finite, Positive};
use serde::{Deserialize, Serialize};

/// A tube that branches off a larger one (the chord): a T-, Y- or, with another branch, a K-joint. The chord's axis is x
/// through the origin; the branch leans towards +x and its axis meets the plane z = 0 at x = 0. The angle phi about its
/// axis is 0 at the heel, where it leans over the chord, and 180 degrees at the toe.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Branch {
    /// Outer radius, mm.
    pub radius_mm: Positive,
    /// Thickness of its wall, mm; needed only for the inside of the cut.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wall_mm: Option<Positive>,
    /// Outer radius of the chord, mm.
    pub chord_radius_mm: Positive,
    /// Angle between its axis and the chord's, degrees, 10 to 170: 90 (a T-joint) if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Positive>,
    /// Distance of its axis from the chord's, towards +y, mm.
    #[serde(default)]
    pub eccentricity_mm: Finite,
    /// Another branch that is on the chord already. This branch ends at the other one: the seam lies partly on the
    /// chord and partly on the other branch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub other: Option<OtherBranch>,
}

/// The through branch of a K-joint, on the side of -x. It has exactly one of `gap_mm` and `offset_mm`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OtherBranch {
    /// Outer radius, mm.
    pub radius_mm: Positive,
    /// Angle between its axis and the chord's, degrees, 10 to 170: 90 if missing. It leans towards -x, away
    /// from the first branch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle_deg: Option<Positive>,
    /// Distance of the two toes along the chord, mm; negative where the branches overlap.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gap_mm: Option<Finite>,
    /// Distance along the chord between the places where the two axes meet the plane z = 0, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offset_mm: Option<Finite>,
    /// Distance of its axis from the chord's, towards +y, mm.
    #[serde(default)]
    pub eccentricity_mm: Finite,
}
