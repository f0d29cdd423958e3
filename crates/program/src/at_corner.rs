use crate::keyed::Keyed;
use crate::tolerance::Tolerance;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive, in_serde};
use seamwright_message::{Message, Unit};
use serde::de::{Error, MapAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;

const KEY: &str = "blend_mm";

/// Behaviour at a corner: a position inside the weld at which the speed or acceleration of an axis would jump.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, JsonSchema)]
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

/// By hand, so that the error lists all allowed values for any other content.
impl<'de> Deserialize<'de> for AtCorner {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Choice;
        impl<'de> Visitor<'de> for Choice {
            type Value = AtCorner;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(&in_serde(&Message::new("program-corner-choice")))
            }
            fn visit_str<E: Error>(self, word: &str) -> Result<AtCorner, E> {
                match word {
                    "refuse" => Ok(AtCorner::Refuse),
                    "stop" => Ok(AtCorner::Stop),
                    _ => Err(E::invalid_value(Unexpected::Str(word), &self)),
                }
            }
            fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<AtCorner, M::Error> {
                let mut distance = None;
                while let Some(key) = map.next_key::<String>()? {
                    if key != KEY {
                        return Err(M::Error::unknown_field(&key, &[KEY]));
                    }
                    distance = Some(map.next_value()?);
                }
                distance.map(AtCorner::BlendMm).ok_or_else(|| M::Error::missing_field(KEY))
            }
        }
        deserializer.deserialize_any(Choice)
    }
}

impl AtCorner {
    /// Checks the choice at `path` of a file against the `tolerance` of the weld.
    ///
    /// # Errors
    /// With the key's address: a blend that leaves the tolerance.
    pub fn check<T>(&self, file: &Document<T>, path: &str, tolerance: Keyed<Tolerance>) -> Result<(), DocumentError> {
        let most = tolerance.value.path_mm;
        match self {
            Self::BlendMm(distance) if *distance > most => {
                let message = Message::new("program-corner-outside-tolerance");
                let allowed =
                    Message::new("program-positive-up-to-key").key("key", format!("{}.path_mm", tolerance.key));
                Err(file.error_at(&format!("{path}.blend_mm"), message, allowed.value("max", most.get(), Unit::One)))
            }
            _ => Ok(()),
        }
    }

    /// True if corners are refused.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}
