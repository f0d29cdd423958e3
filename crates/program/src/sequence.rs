use crate::process::{ProcessValues, check_process_value};
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Process sequence before and after the travel.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sequence {
    /// Gas flows before the arc (or beam) is switched on, s.
    #[serde(default)]
    pub preflow_s: NonNegative,
    /// The arc (or beam) is on before the torch travels, s.
    #[serde(default)]
    pub travel_delay_s: NonNegative,
    /// The torch rests at the end with the arc on, to fill the crater, s.
    #[serde(default)]
    pub crater_s: NonNegative,
    /// Gas flows after the arc is off, s.
    #[serde(default)]
    pub postflow_s: NonNegative,
    /// Process values that rise (or fall) to the weld's from the moment the arc is on, within the travel delay.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub upslope: Option<Slope>,
    /// Process values that fall (or rise) from the weld's until the arc goes off, within the crater fill.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub downslope: Option<Slope>,
    /// A restart after a hold begins this far before the end of the bead, mm.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub overlap_mm: NonNegative,
    /// Behaviour of the process when the torch is held on the seam.
    #[serde(default, skip_serializing_if = "AtHold::is_usual")]
    pub at_hold: AtHold,
}

/// Behaviour of the process when the torch is held on the seam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AtHold {
    /// The arc stays on until the torch stands still and fills the crater for `crater_s`.
    #[default]
    Crater,
    /// The beam goes off as soon as the torch slows down.
    Off,
}

impl AtHold {
    fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

fn is_zero(value: &NonNegative) -> bool {
    value.get() <= 0.0
}

/// A change of process values in time, with the torch at rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Slope {
    /// Duration, s.
    pub time_s: Positive,
    /// Values at its far end from the weld, by name: the first of an upslope, the last of a downslope. Others stay.
    pub process: BTreeMap<String, NonNegative>,
}

impl Slope {
    /// The value `name` when the far end of the slope is `away` s off and the weld's own value is `weld`.
    pub(crate) fn at(&self, name: &str, weld: f64, away: f64) -> f64 {
        let Some(far) = self.process.get(name).map(|v| v.get()) else { return weld };
        let part = (away / self.time_s.get()).clamp(0.0, 1.0);
        far + part * (weld - far)
    }
}

impl Sequence {
    /// Checks the slopes at `path` of a file: they fit into travel delay and crater fill, and their values are among
    /// those of the weld.
    ///
    /// # Errors
    /// With the key's address.
    pub fn check<T>(&self, file: &Document<T>, path: &str, weld: &ProcessValues) -> Result<(), DocumentError> {
        let slopes = [
            ("upslope", &self.upslope, "program-upslope-too-long", ("travel_delay_s", self.travel_delay_s)),
            ("downslope", &self.downslope, "program-downslope-too-long", ("crater_s", self.crater_s)),
        ];
        for (name, slope, too_long, (within, time)) in slopes {
            let Some(slope) = slope else { continue };
            if slope.time_s.get() > time.get() {
                let key = format!("{path}.{name}.time_s");
                let allowed = Message::new("program-up-to-key").key("key", within).value("max", time.get(), Unit::One);
                return Err(file.error_at(&key, Message::new(too_long), allowed));
            }
            if let Some(unknown) = slope.process.keys().find(|key| !weld.contains_key(*key)) {
                let key = format!("{path}.{name}.process.{unknown}");
                let names: Vec<&str> = weld.keys().map(String::as_str).collect();
                return Err(file.error_at(&key, Message::new("program-no-such-process-value"), names.join(", ")));
            }
            for (value_name, value) in &slope.process {
                let key = format!("{path}.{name}.process.{value_name}");
                check_process_value(file, &key, value_name, value.get(), weld.keys())?;
            }
        }
        Ok(())
    }
}
