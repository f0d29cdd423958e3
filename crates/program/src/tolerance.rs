use schemars::JsonSchema;
use seamwright_document::Positive;
use serde::{Deserialize, Serialize};

/// Tolerances of a finished weld. The defaults suit arc welding with a 1 mm wire (half a wire diameter, and the alarm
/// bands of common sources); a procedure may require less.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Tolerance {
    /// Distance of the torch tip from the seam, mm; 0.5 if missing.
    pub path_mm: Positive,
    /// Deviation of the tip's speed from the planned one, percent; 10 if missing.
    pub speed_percent: Positive,
    /// Deviation of the torch's direction from the one asked for, degrees; 10 if missing.
    pub attitude_deg: Positive,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { path_mm: Positive::HALF, speed_percent: Positive::TEN, attitude_deg: Positive::TEN }
    }
}
