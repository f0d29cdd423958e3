use super::short_sequence::ShortSequence;
use super::steady_values::check_steady;
use crate::allowed::{between, rounded};
use crate::seam::SeamCurve;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{Oscillation, Pass, PathRange, ProcessValues, Role, Sequence, SpanValue, is_beyond};
use serde::{Deserialize, Serialize};

/// A last pass over the finished weld, on the seam's line, that smooths its surface with a weak or wide beam. Missing
/// values come from `[weld]`; it does not weave.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cosmetic {
    /// Path length at which it begins, mm from the start of the weld.
    #[serde(default)]
    pub from_mm: NonNegative,
    /// Speed, mm/s; that of `[weld]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Positive>,
    /// Process values that differ from those of `[weld.process]`.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub process: ProcessValues,
    /// Times before and after the travel.
    #[serde(default, skip_serializing_if = "ShortSequence::is_usual")]
    pub sequence: ShortSequence,
    /// Oscillation of the beam during travel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub oscillation: Option<Oscillation>,
}

/// The shortest that is worth a pass, mm.
const SHORTEST_MM: f64 = 1.0;

impl Cosmetic {
    /// Checks the settings that do not depend on the seam; `sequence` and `process` are those of the weld. Fails with
    /// the key's address: a process value that the weld does not have, or that is a ramp.
    pub(crate) fn check<T>(
        &self,
        file: &Document<T>,
        sequence: &Sequence,
        process: &ProcessValues,
    ) -> Result<(), DocumentError> {
        self.sequence.check(file, "cosmetic.sequence", sequence, process)?;
        check_steady(file, "cosmetic.process", &self.process, process, "weld-cosmetic-ramp")?;
        self.oscillation.as_ref().map_or(Ok(()), |oscillation| oscillation.check(file, "cosmetic.oscillation"))
    }

    /// The pass on `seam`; `weld` is the pass along the whole of it. Fails with the key's address: a start beyond the
    /// end of the weld.
    pub(crate) fn pass<T>(&self, file: &Document<T>, seam: &SeamCurve, weld: &Pass) -> Result<Pass, DocumentError> {
        let last = weld.length() - SHORTEST_MM;
        if is_beyond(self.from_mm.get(), last) {
            let message = Message::new("weld-cosmetic-beyond-end");
            return Err(file.error_at("cosmetic.from_mm", message, between(0.0, rounded(last), Unit::Mm)));
        }
        let turn = seam.all_round().then(|| seam.length());
        let range = PathRange { from_mm: self.from_mm.get(), to_mm: weld.length() };
        let mut pass = Pass {
            name: "cosmetic".to_owned(),
            role: Some(Role::Cosmetic),
            least_speed_mm_s: None,
            sequence: self.sequence.of(&weld.sequence),
            weave: None,
            oscillation: self.oscillation,
            ..weld.piece(range, turn)
        };
        for span in &mut pass.spans {
            span.speed_mm_s = self.speed_mm_s.map_or(span.speed_mm_s, SpanValue::Steady);
            span.process.extend(self.process.clone());
        }
        Ok(pass)
    }
}
