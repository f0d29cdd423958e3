use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// Filler metal, gas and flux of the weld, for the totals of a plan. Values with a default are usual ones of shops: put
/// your own in their place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Consumables {
    /// Diameter of the wire, mm; if missing that of `[beads]` or of the procedure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wire_mm: Option<Positive>,
    /// Density of the wire, g/cm^3: 7.85 of solid steel wire if missing, about 6.5 of flux cored wire, 2.7 of aluminium.
    pub wire_g_cm3: Positive,
    /// Part of the wire that becomes weld metal, up to 1; if missing that of `[beads]` or of the procedure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deposition: Option<Positive>,
    /// Flow of shielding gas from preflow to postflow, l/min; none if missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gas_l_min: Option<Positive>,
    /// Mass of flux consumed for that of the wire; none if missing. About 1 in submerged arc welding.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub flux_per_wire: Option<Positive>,
    /// Part of the energy from the mains that reaches the arc, up to 1; 0.85 if missing, of an inverter.
    pub source_efficiency: Positive,
}

impl Default for Consumables {
    fn default() -> Self {
        let positive = |value| Positive::new(value).unwrap_or(Positive::HALF);
        Self {
            wire_mm: None,
            wire_g_cm3: positive(7.85),
            deposition: None,
            gas_l_min: None,
            flux_per_wire: None,
            source_efficiency: positive(0.85),
        }
    }
}

impl Consumables {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// Checks the table `path` of a file.
    ///
    /// # Errors
    /// With the key's address: a part of a whole above 1.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let parts = [("deposition", self.deposition), ("source_efficiency", Some(self.source_efficiency))];
        match parts.iter().find(|(_, part)| part.is_some_and(|p| p.get() > 1.0)) {
            Some((key, _)) => {
                let allowed = Message::new("document-more-than-up-to").number("min", 0.0, 0).number("max", 1.0, 0);
                Err(file.error_at(&format!("{path}.{key}"), Message::new("program-part-above-one"), allowed))
            }
            None => Ok(()),
        }
    }
}

/// Rates for the cost of the weld; what has no rate is not counted.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Costs {
    /// Name of the currency, like `EUR`.
    pub currency: String,
    /// Labour, for each hour from home to home.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labour_per_h: Option<Positive>,
    /// Machine, for each hour from home to home.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine_per_h: Option<Positive>,
    /// Filler metal, for each kg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wire_per_kg: Option<Positive>,
    /// Shielding gas, for each m^3.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gas_per_m3: Option<Positive>,
    /// Flux, for each kg.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub flux_per_kg: Option<Positive>,
    /// Electric energy from the mains, for each kWh.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_per_kwh: Option<Positive>,
}
