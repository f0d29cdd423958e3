use schemars::JsonSchema;
use seamwright_document::{Finite, NonNegative};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Redundancy resolution: use of the axes beyond those that a torch pose needs. Without redundant axes the weights have
/// no effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct SpareAxes {
    /// Requested welding position, if redundant axes can turn or tilt the work.
    pub position: Position,
    /// The flat position is good enough within this angle, degrees; 5 if missing.
    pub flat_within_deg: NonNegative,
    /// Positions of redundant axes that stand still, by name, mm or degrees.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub hold: BTreeMap<String, Finite>,
    /// Weights of the criteria against each other.
    pub weights: Weights,
}

impl Default for SpareAxes {
    fn default() -> Self {
        Self {
            position: Position::default(),
            flat_within_deg: weight(5.0),
            hold: BTreeMap::new(),
            weights: Weights::default(),
        }
    }
}

impl SpareAxes {
    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

/// Welding position wanted (ISO 6947).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Position {
    /// The joint's face up.
    #[default]
    Flat,
    /// No matter which.
    Any,
}

/// Weights of the criteria for redundant axes: factors of squares that are 1 at the axis' limit, or as stated.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Weights {
    /// Speed of each axis, against its highest; 1 if missing.
    pub motion: NonNegative,
    /// Acceleration of each axis, against its highest; 1 if missing.
    pub acceleration: NonNegative,
    /// Closeness to the ends of ranges, from 0 a tenth of the range before an end to 1 at it; 1 if missing.
    pub limits: NonNegative,
    /// Closeness to singular attitudes, from 0 at 20 degrees to 1 there; 1 if missing.
    pub singularity: NonNegative,
    /// Angle from the wanted position, beyond what is good enough, in tens of degrees; 1 if missing.
    pub position: NonNegative,
    /// Turns of axes that can turn without end, or by more than one turn, away from home; 0.01 if missing.
    pub wind_up: NonNegative,
    /// Distance to obstacles, from 0 at the clearance wanted, growing as 1 / distance below it; 1 if missing.
    pub clearance: NonNegative,
}

impl Default for Weights {
    fn default() -> Self {
        let one = weight(1.0);
        Self {
            motion: one,
            acceleration: one,
            limits: one,
            singularity: one,
            position: one,
            wind_up: weight(0.01),
            clearance: one,
        }
    }
}

fn weight(value: f64) -> NonNegative {
    NonNegative::new(value).unwrap_or_default()
}
