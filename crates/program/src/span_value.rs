use schemars::JsonSchema;
use seamwright_document::in_serde;
use seamwright_message::Message;
use serde::de::value::MapAccessDeserializer;
use serde::de::{IntoDeserializer, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use std::fmt;
use std::marker::PhantomData;

/// A value over a span: a number, or a ramp.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SpanValue<T> {
    /// The same all along.
    Steady(T),
    /// From one value to another, linear in path length.
    Ramp(Ramp<T>),
}

/// A value that changes evenly with path length over a span.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ramp<T> {
    /// Value at the start of the span.
    pub from: T,
    /// Value at the end of the span.
    pub to: T,
}

impl<T> SpanValue<T> {
    /// Whether it is given as a ramp.
    pub fn is_ramp(&self) -> bool {
        matches!(self, Self::Ramp(_))
    }
}

impl<T: Into<f64>> SpanValue<T> {
    /// Values at the start and at the end of the span.
    pub fn ends(self) -> (f64, f64) {
        match self {
            Self::Steady(value) => {
                let value = value.into();
                (value, value)
            }
            Self::Ramp(Ramp { from, to }) => (from.into(), to.into()),
        }
    }

    /// At a part of the span's length from 0 to 1.
    pub fn at(self, part: f64) -> f64 {
        let (from, to) = self.ends();
        from + part * (to - from)
    }
}

impl<T> From<T> for SpanValue<T> {
    fn from(value: T) -> Self {
        Self::Steady(value)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for SpanValue<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Value<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Value<T> {
            type Value = SpanValue<T>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str(&in_serde(&Message::new("program-number-or-ramp")))
            }
            fn visit_f64<E: serde::de::Error>(self, v: f64) -> Result<SpanValue<T>, E> {
                T::deserialize(v.into_deserializer()).map(SpanValue::Steady)
            }
            fn visit_i64<E: serde::de::Error>(self, v: i64) -> Result<SpanValue<T>, E> {
                T::deserialize(v.into_deserializer()).map(SpanValue::Steady)
            }
            fn visit_u64<E: serde::de::Error>(self, v: u64) -> Result<SpanValue<T>, E> {
                T::deserialize(v.into_deserializer()).map(SpanValue::Steady)
            }
            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<SpanValue<T>, A::Error> {
                Ramp::deserialize(MapAccessDeserializer::new(map)).map(SpanValue::Ramp)
            }
        }
        deserializer.deserialize_any(Value(PhantomData))
    }
}
