//! Bounds of numbers in a file, by the unit at the end of their key.
//!
//! A typing mistake (8000 for 8, a key held down) must be refused at its key, before anything is computed from it:
//! counts of beads, cells, triangles and set-points are quotients of such numbers. The bounds are wider than any
//! machine or part that is welded, so that no sensible file meets them.

use crate::{Document, DocumentError};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Bounds of a number with a unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Ending of the key.
    pub suffix: &'static str,
    /// The unit in words.
    pub unit: &'static str,
    /// Smallest magnitude other than 0; 0 if unbounded.
    pub min: f64,
    /// Largest magnitude.
    pub max: f64,
    /// The reason, for people.
    pub reason: &'static str,
}

const fn bound(suffix: &'static str, unit: &'static str, range: [f64; 2], reason: &'static str) -> Bound {
    Bound { suffix, unit, min: range[0], max: range[1], reason }
}

/// All bounds, the longer suffix first where one ends in another.
pub static BOUNDS: [Bound; 21] = [
    bound("_deg_s3", "deg/s^3", [1e-3, 1e11], "jerk of the fastest scanner"),
    bound("_deg_s2", "deg/s^2", [1e-3, 1e8], "acceleration of the fastest scanner"),
    bound("_deg_s", "deg/s", [1e-4, 1e5], "one turn in 40 days to 280 turns a second"),
    bound("_mm_s3", "mm/s^3", [1e-3, 1e11], "jerk of the fastest scanner"),
    bound("_mm_s2", "mm/s^2", [1e-3, 1e8], "10,000 times gravity"),
    bound("_mm_s", "mm/s", [1e-4, 1e5], "0.36 mm an hour to 100 m a second"),
    bound("_mm_min", "mm/min", [6e-3, 6e6], "0.36 mm an hour to 100 m a second"),
    bound("_m_min", "m/min", [0.0, 1e3], "ten times the fastest wire feeder"),
    bound("_mm2", "mm^2", [0.0, 1e6], "a square metre"),
    bound("_deg", "degrees", [0.0, 1e6], "2,700 turns"),
    bound("_mm", "mm", [0.0, 1e6], "a kilometre"),
    bound("_um", "um", [0.0, 1e9], "a kilometre"),
    bound("_ms", "ms", [0.0, 3.6e6], "an hour"),
    bound("_us", "us", [0.0, 3.6e9], "an hour"),
    bound("_hz", "Hz", [0.0, 1e8], "the fastest pulse generator"),
    bound("_percent", "percent", [0.0, 1e4], "a hundredfold"),
    bound("_ma", "mA", [0.0, 1e8], "the largest process source"),
    bound("_kv", "kV", [0.0, 1e3], "the largest beam generator"),
    bound("_s", "s", [0.0, 3600.0], "an hour"),
    bound("_a", "A", [0.0, 1e5], "the largest process source"),
    bound("_v", "V", [0.0, 1e6], "the largest beam generator"),
];

/// Tables whose keys are names chosen by the user, of axes and of variables: such a name may end like a unit without
/// being one. Positions are checked against the axis' range, variables where they are used.
const NAMED: [&str; 2] = ["hold", "variables"];

/// Largest coordinate of a point, mm: parts may stand far from an origin, as in a plant's coordinates.
pub(crate) const FARTHEST_MM: f64 = 1e7;

/// Bound of millimetres in rows: coordinates of points, ranges of axes.
static COORDINATE: Bound = bound("_mm", "mm", [0.0, FARTHEST_MM], "10 km");

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

    /// The bound in words.
    pub fn allowed(&self) -> String {
        let least = if self.min > 0.0 { format!("at least {}, ", self.min) } else { String::new() };
        format!("{least}up to {} {} ({})", self.max, self.unit, self.reason)
    }
}

/// Refuses the first number of `document` that is out of the bound of its unit.
///
/// # Errors
/// With the number's address.
pub(crate) fn check<T>(document: &Document<T>) -> Result<(), DocumentError> {
    // Text with wrong syntax has been refused before.
    let Ok(table) = DeTable::parse(document.text()) else { return Ok(()) };
    Check { document, path: String::new() }.table(table.get_ref(), None)
}

/// A walk over all numbers of a document.
struct Check<'a, T> {
    document: &'a Document<T>,
    /// Path of the current key.
    path: String,
}

impl<T> Check<'_, T> {
    /// Checks the content of a table, whose own key has the bound `above`.
    fn table(&mut self, table: &DeTable, above: Option<&'static Bound>) -> Result<(), DocumentError> {
        for (key, value) in table {
            let (key, length): (&str, usize) = (key.get_ref(), self.path.len());
            if NAMED.contains(&key) && matches!(value.get_ref(), DeValue::Table(_)) {
                continue;
            }
            if !self.path.is_empty() {
                self.path.push('.');
            }
            self.path.push_str(key);
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
                    let message = if number.abs() > bound.max { "this is too large" } else { "this is too small" };
                    Err(self.document.error_at(&self.path, message, bound.allowed()))
                }
                _ => Ok(()),
            },
        }
    }
}

/// The number that a value is.
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
