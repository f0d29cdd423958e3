//! Passes welded several times.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use seamwright_document::in_serde;
use seamwright_message::Message;
use serde::de::{Error as _, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;

/// Number of times that a pass is welded in a row: a whole number from 1 to 1000.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Repeat(u16);

impl Repeat {
    /// Maximum number of times.
    pub const MAX: u16 = 1000;

    /// The number `times`, if it is allowed.
    pub fn new(times: u16) -> Option<Self> {
        (1..=Self::MAX).contains(&times).then_some(Self(times))
    }

    /// Number of times.
    pub fn get(self) -> u16 {
        self.0
    }

    pub(crate) fn is_once(&self) -> bool {
        self.0 == 1
    }
}

impl Default for Repeat {
    fn default() -> Self {
        Self(1)
    }
}

impl<'de> Deserialize<'de> for Repeat {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let times = f64::deserialize(deserializer)?;
        let whole = times.fract() == 0.0 && (0.0..=f64::from(Self::MAX)).contains(&times);
        let wrong = || {
            let allowed = Message::new("document-whole-number").text("min", "1").text("max", Self::MAX.to_string());
            D::Error::invalid_value(Unexpected::Float(times), &in_serde(&allowed).as_str())
        };
        Some(times as u16).filter(|_| whole).and_then(Self::new).ok_or_else(wrong)
    }
}

impl JsonSchema for Repeat {
    fn schema_name() -> Cow<'static, str> {
        "Repeat".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "integer", "minimum": 1, "maximum": Self::MAX })
    }
}
