use crate::weave::{Dwells, Figure};
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Oscillation of a beam by its deflection: no axis moves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Oscillation {
    /// The figure.
    #[serde(default)]
    pub figure: Figure,
    /// Width from side to side, mm.
    pub across_mm: Positive,
    /// Length along the seam of a circle or an eight, mm; as long as it is wide if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub along_mm: Option<Positive>,
    /// Periods a second.
    pub frequency_hz: Positive,
    /// Diameter of the beam on the work, mm: if it goes on by more than this in a period it leaves gaps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spot_mm: Option<Positive>,
}

impl Oscillation {
    /// Checks the oscillation at `path` of a file.
    ///
    /// # Errors
    /// With the key's address: a length of a figure that has no length.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        if self.along_mm.is_some() && !self.figure.is_round() {
            let message = Message::new("program-figure-without-length");
            let allowed = Message::new("program-figures-with-length");
            return Err(file.error_at(&format!("{path}.along_mm"), message, allowed));
        }
        Ok(())
    }

    /// Deflection at `phase` (1 is a period), mm: across towards the first part, and along in the direction of travel.
    pub fn at(&self, phase: f64) -> (f64, f64) {
        let swing = self.figure.at(phase, Dwells::NONE);
        let long = self.along_mm.unwrap_or(self.across_mm).get();
        (0.5 * self.across_mm.get() * swing.across, 0.5 * long * swing.along)
    }

    /// Advance of the beam in a period at `speed` mm/s, mm.
    pub fn advance(&self, speed: f64) -> f64 {
        speed / self.frequency_hz.get()
    }

    /// Position of the beam on the work after `periods` at `speed` mm/s, mm: across, and along from its start.
    pub fn on_work(&self, periods: f64, speed: f64) -> (f64, f64) {
        let (across, along) = self.at(periods);
        (across, along + periods * self.advance(speed))
    }

    /// Describes gaps that the oscillation leaves at `fastest` mm/s, with the operator action.
    pub fn gaps(&self, fastest: f64) -> Option<(Message, Message)> {
        let spot = self.spot_mm?.get();
        let advance = self.advance(fastest);
        (advance > spot).then(|| {
            let frequency = (1e4 * fastest / spot).ceil() * 1e-4;
            let gaps = Message::new("program-oscillation-gaps").quantity("advance", advance, Unit::Mm, 4);
            let cure = Message::new("program-cure-oscillation-gaps").quantity("frequency", frequency, Unit::Hz, 4);
            (gaps.value("spot", spot, Unit::Mm), cure)
        })
    }
}
