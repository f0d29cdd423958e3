//! Figures of a trace: heat input and deviations along the seam, values against their windows.
//!
//! They are computed from the columns `t_s`, `pass`, `s_mm`, `arc`, `tip_s_mm` if it exists, and those that the
//! [`Basis`] names. Each row holds until the next. The same for a weld that ended well and for the remains of one after
//! a crash. If there is a column `steady`, values count only while it is 1: holds, ramps, starts and ends are no
//! travel.

mod tally;

use crate::error::Error;
use crate::trace::Trace;
use serde::{Deserialize, Serialize};
use tally::Tally;

/// Name of the value that is worked out and in no column.
pub const HEAT_INPUT: &str = "heat_input_kj_mm";

/// Inputs of the figures.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Basis {
    /// Sources of power, if known.
    pub power: Option<Power>,
    /// Values to be judged.
    pub judged: Vec<Judged>,
}

/// Power as a product of columns.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Power {
    /// Columns, with the factor of each to A, V or W.
    pub factors: Vec<(String, f64)>,
    /// Part of the power that counts as heat input.
    pub efficiency: f64,
}

/// A value of a pass, a column of the trace or [`HEAT_INPUT`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Judged {
    /// The pass, counted from 1.
    pub pass: u32,
    /// The column.
    pub name: String,
    /// Minimum and maximum value allowed.
    pub allowed: Option<(f64, f64)>,
    /// Stretches of path length (mm) in which it counts; empty: wherever the arc is on.
    pub along: Vec<(f64, f64)>,
}

/// Range of a value while the pass was travelled with the arc on.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Value {
    /// The pass, counted from 1.
    pub pass: u32,
    /// Its name, which ends in its unit.
    pub name: String,
    /// Minimum.
    pub least: f64,
    /// Mean over time; of the heat input over the way.
    pub mean: f64,
    /// Maximum.
    pub greatest: f64,
    /// Minimum and maximum value allowed.
    pub allowed: Option<(f64, f64)>,
    /// Time outside the window, s.
    pub outside_s: f64,
    /// Over how much of the way it was outside, mm.
    pub outside_mm: f64,
    /// From where to where on the seam it was outside, first and last, mm; unknown of values that the library has.
    #[serde(skip)]
    pub outside_along: Option<(f64, f64)>,
}

/// A curve over path length (mm) in one pass.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The pass, counted from 1.
    pub pass: u32,
    /// Quantity; the column's name.
    pub name: String,
    /// Path length, and the value there.
    pub points: Vec<(f64, f64)>,
}

/// The figures of a weld.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figures {
    /// Time with the arc on, s.
    pub arc_on_s: f64,
    /// Time of the last row, s.
    pub last_s: f64,
    /// Minimum, mean and maximum heat input, kJ/mm, over [`BIN_MM`] each.
    pub heat_input_kj_mm: Option<[f64; 3]>,
    /// Heat input along each pass.
    pub heat_input: Vec<Curve>,
    /// Maximum distance of the torch tip from the seam with the arc on (mm), and its position (mm).
    pub worst_deviation_mm: Option<(f64, f64)>,
    /// Deviations along each pass, the maximum of each [`BIN_MM`]: columns `path_error_mm`, `miss_lateral_mm..`,
    /// `miss_height_mm..`.
    pub deviations: Vec<Curve>,
    /// Values against their windows.
    pub values: Vec<Value>,
}

/// Way over which energy and deviations are gathered, mm.
pub const BIN_MM: f64 = 2.0;

impl Figures {
    /// The figures of a weld whose trace has these parts.
    pub fn of(parts: &[Trace], basis: &Basis) -> Result<Self, Error> {
        let Some(first) = parts.first() else { return Ok(Self::default()) };
        let tally = Tally::new(first, basis);
        let names: Vec<String> = tally.columns().to_vec();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let mut tally = tally;
        for part in parts {
            part.read(&names, |row| tally.row(row))?;
        }
        Ok(tally.finish())
    }
}
