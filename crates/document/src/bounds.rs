//! Bounds of numbers in a file, by the unit at the end of their key.
//!
//! A typing mistake (8000 for 8, a key held down) must be refused at its key, before anything is computed from it:
//! counts of beads, cells, triangles and set-points are quotients of such numbers. The bounds are wider than any
//! machine or part that is welded, so that no sensible file meets them.

use crate::document::error_at;
use crate::error::DocumentError;
use crate::key_path::with_key;
use seamwright_message::{Message, Unit};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Bounds of a number with a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Ending of the key.
    pub suffix: &'static str,
    /// Unit of the bounds.
    pub unit: Unit,
    /// Smallest magnitude other than 0; 0 if unbounded.
    pub min: f64,
    /// Largest magnitude.
    pub max: f64,
    /// Code of the reason.
    pub reason: &'static str,
}

const fn bound(suffix: &'static str, unit: Unit, range: [f64; 2], reason: &'static str) -> Bound {
    Bound { suffix, unit, min: range[0], max: range[1], reason }
}

/// All bounds, the longer suffix first where one ends in another.
pub static BOUNDS: [Bound; 21] = [
    bound("_deg_s3", Unit::DegPerS3, [1e-3, 1e11], "document-bound-scanner-jerk"),
    bound("_deg_s2", Unit::DegPerS2, [1e-3, 1e8], "document-bound-scanner-acceleration"),
    bound("_deg_s", Unit::DegPerS, [1e-4, 1e5], "document-bound-turns"),
    bound("_mm_s3", Unit::MmPerS3, [1e-3, 1e11], "document-bound-scanner-jerk"),
    bound("_mm_s2", Unit::MmPerS2, [1e-3, 1e8], "document-bound-gravity"),
    bound("_mm_s", Unit::MmPerS, [1e-4, 1e5], "document-bound-speed"),
    bound("_mm_min", Unit::MmPerMin, [6e-3, 6e6], "document-bound-speed"),
    bound("_m_min", Unit::MPerMin, [0.0, 1e3], "document-bound-wire-feeder"),
    bound("_mm2", Unit::Mm2, [0.0, 1e6], "document-bound-square-metre"),
    bound("_deg", Unit::Deg, [0.0, 1e6], "document-bound-many-turns"),
    bound("_mm", Unit::Mm, [0.0, 1e6], "document-bound-kilometre"),
    bound("_um", Unit::Um, [0.0, 1e9], "document-bound-kilometre"),
    bound("_ms", Unit::Ms, [0.0, 3.6e6], "document-bound-hour"),
    bound("_us", Unit::Us, [0.0, 3.6e9], "document-bound-hour"),
    bound("_hz", Unit::Hz, [0.0, 1e8], "document-bound-pulses"),
    bound("_percent", Unit::Percent, [0.0, 1e4], "document-bound-hundredfold"),
    bound("_ma", Unit::MilliA, [0.0, 1e8], "document-bound-process-source"),
    bound("_kv", Unit::KiloV, [0.0, 1e3], "document-bound-beam-generator"),
    bound("_s", Unit::S, [0.0, 3600.0], "document-bound-hour"),
    bound("_a", Unit::A, [0.0, 1e5], "document-bound-process-source"),
    bound("_v", Unit::V, [0.0, 1e6], "document-bound-beam-generator"),
];

/// Tables whose keys are names chosen by the user, of axes and of variables: such a name may end like a unit without
/// being one. Positions are checked against the axis' range, variables where they are used.
const NAMED: [&str; 2] = ["hold", "variables"];

/// Largest coordinate of a point, mm: parts may stand far from an origin, as in a plant's coordinates.
pub(crate) const FARTHEST_MM: f64 = 1e7;

/// Bound of millimetres in rows: coordinates of points, ranges of axes.
static COORDINATE: Bound = bound("_mm", Unit::Mm, [0.0, FARTHEST_MM], "document-bound-10-km");

impl Bound {
    /// The bound of the values of `key`, if it ends in a unit that has one.
    pub fn of(key: &str) -> Option<&'static Self> {
        BOUNDS.iter().find(|bound| key.ends_with(bound.suffix))
    }

    /// The bound of numbers in the column `name` of a table, or in an array at the key `name`.
    pub fn of_column(name: &str) -> Option<&'static Self> {
        Self::of(name).map(Self::in_rows)
    }

    fn in_rows(&'static self) -> &'static Self {
        if self.suffix == COORDINATE.suffix { &COORDINATE } else { self }
    }

    /// True if `value` is within the bound, or not finite: that is refused elsewhere.
    pub fn allows(&self, value: f64) -> bool {
        let size = value.abs();
        !value.is_finite() || size == 0.0 || (self.min..=self.max).contains(&size)
    }

    /// Allowed values, with the reason.
    pub fn allowed(&self) -> Message {
        let allowed = match self.min > 0.0 {
            true => Message::new("document-within").value("min", self.min, self.unit),
            false => Message::new("document-up-to"),
        };
        allowed.value("max", self.max, self.unit).message("reason", Message::new(self.reason))
    }
}

/// Refuses the first number below `root` of a text that is out of the bound of its unit.
///
/// # Errors
/// With the number's address.
pub(crate) fn check(file: &str, text: &str, root: &Spanned<DeValue>) -> Result<(), DocumentError> {
    Check { file, text, path: String::new() }.value(root, None)
}

/// A walk over all numbers of a text.
struct Check<'a> {
    file: &'a str,
    text: &'a str,
    /// Path of the current key.
    path: String,
}

impl Check<'_> {
    /// Checks the content of a table, whose own key has the bound `above`.
    fn table(&mut self, table: &DeTable, above: Option<&'static Bound>) -> Result<(), DocumentError> {
        for (key, value) in table {
            let (key, length): (&str, usize) = (key.get_ref(), self.path.len());
            if NAMED.contains(&key) && matches!(value.get_ref(), DeValue::Table(_)) {
                continue;
            }
            self.path = with_key(&self.path, key);
            // The ends of a ramp have the unit of its key.
            let bound = if matches!(key, "from" | "to") { above } else { Bound::of(key) };
            self.value(value, bound)?;
            self.path.truncate(length);
        }
        Ok(())
    }

    fn value(&mut self, value: &Spanned<DeValue>, bound: Option<&'static Bound>) -> Result<(), DocumentError> {
        match value.get_ref() {
            DeValue::Table(table) => self.table(table, bound),
            DeValue::Array(items) => {
                for (i, item) in items.iter().enumerate() {
                    let length = self.path.len();
                    self.path.push_str(&format!("[{i}]"));
                    self.value(item, bound.map(Bound::in_rows))?;
                    self.path.truncate(length);
                }
                Ok(())
            }
            other => match (bound, number(other)) {
                (Some(bound), Some(number)) if !bound.allows(number) => {
                    let too_large = number.abs() > bound.max;
                    let code = if too_large { "document-too-large" } else { "document-too-small" };
                    Err(error_at(self.file, self.text, &self.path, Message::new(code), bound.allowed()))
                }
                _ => Ok(()),
            },
        }
    }
}

fn number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Integer(n) => i128::from_str_radix(n.as_str(), n.radix()).ok().map(|n| n as f64),
        DeValue::Float(n) => n.as_str().parse().ok(),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longer_suffix_is_found_first() {
        for (i, bound) in BOUNDS.iter().enumerate() {
            assert!(BOUNDS[..i].iter().all(|before| !bound.suffix.ends_with(before.suffix)), "{}", bound.suffix);
            assert!(bound.min < bound.max);
            assert_eq!(Bound::of(&format!("speed{}", bound.suffix)), Some(bound));
        }
        assert_eq!(Bound::of("title"), None);
    }

    #[test]
    fn bounds_hold_for_magnitudes_and_leave_zero() {
        let speed = Bound::of("speed_mm_s").unwrap();
        for (value, allowed) in [(0.0, true), (1e5, true), (-1e5, true), (1.1e5, false), (1e-5, false), (1e20, false)] {
            assert_eq!(speed.allows(value), allowed, "{value}");
        }
    }
}
