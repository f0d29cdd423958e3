//! Minimum angle at the toes of a cap.

use crate::joint::FilletOrButt;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Quality level of ISO 5817: B is the highest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "UPPERCASE")]
pub enum QualityLevel {
    /// High.
    B,
    /// Medium: the usual level of steel structures and vessels.
    #[default]
    C,
    /// Low.
    D,
}

impl QualityLevel {
    /// True if it is the default.
    #[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// Name, as the standard writes it.
    pub fn name(self) -> &'static str {
        match self {
            Self::B => "B",
            Self::C => "C",
            Self::D => "D",
        }
    }

    /// Minimum weld toe angle alpha, degrees: between the surface of the part and the face of the weld at the toe,
    /// through the air. A weld flush with its part has 180.
    ///
    /// ISO 5817, imperfection 505 (incorrect weld toe). Trust: remembered, to be read again in the edition in force.
    pub fn min_toe_deg(self, joint: FilletOrButt) -> f64 {
        match (joint, self) {
            (FilletOrButt::Butt, Self::B) => 150.0,
            (FilletOrButt::Butt, Self::C) | (FilletOrButt::Fillet, Self::B) => 110.0,
            (FilletOrButt::Fillet, Self::C) => 100.0,
            (_, Self::D) => 90.0,
        }
    }
}
