use schemars::JsonSchema;
use seamwright_clearance::SolidFile;
use seamwright_document::Positive;
use serde::{Deserialize, Serialize};

/// The part as a solid, for clearance: made from the seam, with solids that are given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Part {
    /// Length of nozzle, tube or web beyond the seam's highest point, mm; 100 if missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nozzle_length_mm: Option<Positive>,
    /// Length of a cylindrical or conical body along its axis, side of a plate, length of a welded tube, width of a
    /// skin, mm; from the seam's size if missing. Spheres and ellipsoids are whole.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_length_mm: Option<Positive>,
    /// Solids in the seam's frame, besides those made from the seam.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub solids: Vec<SolidFile>,
    /// True: the solids are the whole part, and none is made from the seam.
    #[serde(skip_serializing_if = "is_false")]
    pub replace: bool,
    /// False: the part is not watched.
    #[serde(skip_serializing_if = "is_true")]
    pub watched: bool,
}

fn is_false(v: &bool) -> bool {
    !*v
}

fn is_true(v: &bool) -> bool {
    *v
}

impl Default for Part {
    fn default() -> Self {
        Self { nozzle_length_mm: None, body_length_mm: None, solids: Vec::new(), replace: false, watched: true }
    }
}

impl Part {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

/// Minimum clearance of the machine from part and fixtures.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Clearance {
    /// Minimum distance, mm; 1 if missing.
    pub least_mm: Positive,
}

impl Default for Clearance {
    fn default() -> Self {
        Self { least_mm: Positive::new(1.0).unwrap_or(Positive::HALF) }
    }
}

impl Clearance {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
