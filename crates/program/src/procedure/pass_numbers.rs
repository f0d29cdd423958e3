use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use seamwright_document::fault_in_serde;
use seamwright_message::Message;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::ops::RangeInclusive;

/// Passes by number, counted from 1: `"1"`, `"2-5"` or `"1, 3-4"` in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PassNumbers(Vec<RangeInclusive<usize>>);

impl PassNumbers {
    /// True if pass `number` is among them.
    pub fn has(&self, number: usize) -> bool {
        self.0.iter().any(|range| range.contains(&number))
    }

    /// The first number that is in both.
    pub fn first_in_both(&self, other: &Self) -> Option<usize> {
        self.0.iter().flat_map(|a| other.0.iter().filter_map(|b| common(a, b))).min()
    }

    fn parse(text: &str) -> Result<Self, Message> {
        let mut ranges: Vec<RangeInclusive<usize>> = Vec::new();
        for part in text.split(',').map(str::trim) {
            let (first, last) = part.split_once('-').unwrap_or((part, part));
            let number = |word: &str| word.trim().parse::<usize>().ok().filter(|n| *n > 0);
            let range = number(first).zip(number(last)).filter(|(first, last)| first <= last);
            let (first, last) = range.ok_or_else(|| Message::new("program-no-pass-numbers").text("text", part))?;
            if let Some(twice) = ranges.iter().find_map(|other| common(other, &(first..=last))) {
                return Err(Message::new("program-pass-named-twice").pass("pass", twice));
            }
            ranges.push(first..=last);
        }
        Ok(Self(ranges))
    }
}

fn common(a: &RangeInclusive<usize>, b: &RangeInclusive<usize>) -> Option<usize> {
    let first = *a.start().max(b.start());
    (first <= *a.end().min(b.end())).then_some(first)
}

impl fmt::Display for PassNumbers {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, range) in self.0.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            match (range.start(), range.end()) {
                (first, last) if first == last => write!(f, "{comma}{first}")?,
                (first, last) => write!(f, "{comma}{first}-{last}")?,
            }
        }
        Ok(())
    }
}

impl<'de> Deserialize<'de> for PassNumbers {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::parse(&String::deserialize(deserializer)?)
            .map_err(|wrong| D::Error::custom(fault_in_serde(&wrong, &Message::new("program-pass-numbers"))))
    }
}

impl Serialize for PassNumbers {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl JsonSchema for PassNumbers {
    fn schema_name() -> Cow<'static, str> {
        "PassNumbers".into()
    }
    fn inline_schema() -> bool {
        true
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "pattern": "^ *[1-9][0-9]*( *- *[1-9][0-9]*)? *(, *[1-9][0-9]*( *- *[1-9][0-9]*)? *)*$" })
    }
}
