use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use seamwright_document::{Finite, fault_in_serde};
use seamwright_message::{Message, Unit};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;

/// Relative excess that still counts as on the limit, because of rounding: a part of the window's larger limit, or of 1
/// in its unit if that is more.
const ROUNDING: f64 = 1e-6;

/// Halvings of a stretch in which a limit is crossed: to the last digit.
const HALVINGS: usize = 60;

/// A range of values that a procedure allows, both ends included: `[minimum, maximum]` in a file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(into = "[Finite; 2]")]
pub struct Window {
    least: Finite,
    greatest: Finite,
}

impl From<Window> for [Finite; 2] {
    fn from(window: Window) -> Self {
        [window.least, window.greatest]
    }
}

impl<'de> Deserialize<'de> for Window {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let [least, greatest] = <[Finite; 2]>::deserialize(deserializer)?;
        if least > greatest {
            let fault = Message::new("program-window-order").value("min", least.get(), Unit::One);
            let fault = fault.value("max", greatest.get(), Unit::One);
            return Err(D::Error::custom(fault_in_serde(&fault, &Message::new("program-window"))));
        }
        Ok(Self { least, greatest })
    }
}

impl JsonSchema for Window {
    fn schema_name() -> Cow<'static, str> {
        "Window".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "Least and greatest value allowed, both included.",
            "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 2
        })
    }
}

/// A stretch of a pass on which a value is outside its window, on one side of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Outside {
    /// Path length at which it leaves the window, mm.
    pub from_mm: f64,
    /// Path length at which it is back, mm.
    pub to_mm: f64,
    /// The value farthest outside, in the window's unit; infinite for the heat input of a torch at rest.
    pub found: f64,
    /// Path length at which that is, mm.
    pub at_mm: f64,
    /// True if it is above the window.
    pub above: bool,
}

impl Window {
    /// Minimum and maximum value allowed.
    pub fn ends(self) -> (f64, f64) {
        (self.least.get(), self.greatest.get())
    }

    /// The stretches on which `value`, a function of path length, is outside the window, those below it first.
    ///
    /// `places` increase. Between two of them the value is continuous and its extremes are at or near the `places`. A
    /// linear value is judged exactly, another one as well as the `places` are close. A crossing of a limit is found by
    /// halving, to rounding. A value on a limit, or a millionth beyond, is within.
    pub fn outside(self, places: &[f64], value: impl Fn(f64) -> f64) -> Vec<Outside> {
        let (least, greatest) = self.ends();
        let rounding = ROUNDING * least.abs().max(greatest.abs()).max(1.0);
        let values: Vec<f64> = places.iter().map(|s| value(*s)).collect();
        let mut all = Vec::new();
        for above in [false, true] {
            let beyond = |v: f64| if above { v - greatest } else { least - v };
            let crossing = |inside: f64, outside: f64| halve(inside, outside, |s| beyond(value(s)) > 0.0);
            let mut open: Option<Outside> = None;
            let worth = |stretch: &Outside| beyond(stretch.found) > rounding;
            for (i, (&s, &v)) in places.iter().zip(&values).enumerate() {
                match &mut open {
                    None if beyond(v) > 0.0 => {
                        let from_mm = i.checked_sub(1).map_or(s, |before| crossing(places[before], s));
                        open = Some(Outside { from_mm, to_mm: s, found: v, at_mm: s, above });
                    }
                    Some(stretch) if beyond(v) > 0.0 => {
                        stretch.to_mm = s;
                        if beyond(v) > beyond(stretch.found) {
                            (stretch.found, stretch.at_mm) = (v, s);
                        }
                    }
                    Some(stretch) => {
                        stretch.to_mm = crossing(s, stretch.to_mm);
                        all.extend(open.take().filter(worth));
                    }
                    None => {}
                }
            }
            all.extend(open.filter(worth));
        }
        all
    }
}

/// The position between `no`, where `holds` is false, and `yes`, where it is true, at which that changes.
pub(crate) fn halve(mut no: f64, mut yes: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (no + yes);
        if holds(middle) { yes = middle } else { no = middle }
    }
    yes
}
