//! Data of a machine for the running cell besides its motion: interlocks and the process source.

use schemars::JsonSchema;
use seamwright_document::{NonNegative, Positive};
use serde::Deserialize;

/// A condition that the cell watches in every cycle.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InterlockFile {
    /// Name for people: `chamber door`.
    pub name: String,
    /// The input that says so.
    pub input: String,
    /// Required state of the input; true if missing.
    #[serde(default = "yes")]
    pub is: bool,
    /// Level that needs the interlock.
    #[serde(rename = "for")]
    pub level: Level,
}

/// Reaction of a running program to the loss of its panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PanelLost {
    /// It is held on its path, as by the operator: the crater is filled.
    #[default]
    Hold,
    /// It goes on to its end. Nothing of it is recorded until there is a panel again.
    Continue,
}

fn yes() -> bool {
    true
}

/// Level that needs an interlock. Each level also needs the interlocks of those before it: no motion without power, no
/// process without motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Level {
    /// The drives: without it they lose power at once.
    Power,
    /// Moving: without it everything stops on its path, then the drives lose power.
    Motion,
    /// Arc or beam: without it the process goes off at once and the torch is held.
    Process,
}

impl Level {
    /// In one word, as in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Power => "power",
            Self::Motion => "motion",
            Self::Process => "process",
        }
    }
}

/// Start and supervision of the process source.
#[derive(Debug, Clone, PartialEq, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SourceFile {
    /// Longest time from switching on until arc or beam burns, s; 1.5 if missing.
    pub strike_s: Option<Positive>,
    /// Number of tries; 3 if missing.
    pub tries: Option<u8>,
    /// Time with everything off between tries, s; 0.5 if missing.
    pub pause_s: Option<NonNegative>,
    /// Maximum time for which arc or beam may be out before it counts as lost, s; 0.02 if missing. An electron beam
    /// comes back after a discharge.
    pub out_s: Option<NonNegative>,
    /// Longest time from switching off until arc or beam is out, s; 0.3 if missing.
    pub off_s: Option<Positive>,
    /// Maximum relative difference of a process value from the requested one; 0.1 if missing.
    pub within: Option<Positive>,
    /// For how long, s; 1 if missing.
    pub within_s: Option<Positive>,
}

/// Start and supervision of the process source; s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Source {
    /// Maximum time from switching on until it burns.
    pub strike_s: f64,
    /// Maximum number of strikes.
    pub tries: u8,
    /// Time off between strikes.
    pub pause_s: f64,
    /// Maximum interruption before it counts as lost.
    pub out_s: f64,
    /// Maximum time from switching off until it is out.
    pub off_s: f64,
    /// Maximum relative deviation of a process value.
    pub within: f64,
    /// Maximum duration of a larger deviation.
    pub within_s: f64,
}

impl SourceFile {
    pub(crate) fn source(&self) -> Source {
        let or = |value: Option<Positive>, usual: f64| value.map_or(usual, Positive::get);
        let or_none = |value: Option<NonNegative>, usual: f64| value.map_or(usual, NonNegative::get);
        Source {
            strike_s: or(self.strike_s, 1.5),
            tries: self.tries.unwrap_or(3).max(1),
            pause_s: or_none(self.pause_s, 0.5),
            out_s: or_none(self.out_s, 0.02),
            off_s: or(self.off_s, 0.3),
            within: or(self.within, 0.1),
            within_s: or(self.within_s, 1.0),
        }
    }
}
