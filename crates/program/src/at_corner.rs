use crate::Tolerance;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive};
use serde::{Deserialize, Serialize};

/// What to do at a corner: a place inside the weld where the speed or acceleration of an axis would jump.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AtCorner {
    /// Do not weld; list the corners.
    #[default]
    Refuse,
    /// Stop exactly there with the arc on.
    Stop,
    /// Go round it without a stop; the torch tip stays within this distance of the seam, mm. Not more than
    /// `tolerance.path_mm`.
    BlendMm(Positive),
}

impl AtCorner {
    /// Checks the choice at `path` of a file against the tolerance of the weld.
    ///
    /// # Errors
    /// With the key's address: a blend that leaves the tolerance.
    pub fn check<T>(
        &self,
        file: &Document<T>,
        path: &str,
        (from, tolerance): (&str, &Tolerance),
    ) -> Result<(), DocumentError> {
        let most = tolerance.path_mm;
        match self {
            Self::BlendMm(distance) if *distance > most => {
                let message = "the torch would leave the tolerance of the weld";
                let allowed = format!("more than 0, up to {from}.path_mm = {}", most.get());
                Err(file.error_at(&format!("{path}.blend_mm"), message, allowed))
            }
            _ => Ok(()),
        }
    }

    /// True if corners are refused.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
