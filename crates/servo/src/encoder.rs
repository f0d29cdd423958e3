//! Position feedback in whole counts.

use crate::error::{Error, positive};

/// An encoder that reads the true position rounded to the nearest count.
///
/// Guarantee: a reading is within half a count of the true position (plus rounding in `f64`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Encoder {
    counts_per_unit: f64,
}

impl Encoder {
    /// Creates an encoder with `counts_per_unit` counts per mm or rad (edges after quadrature decoding).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless `counts_per_unit` is above 0 and at most 1e12.
    pub fn new(counts_per_unit: f64) -> Result<Self, Error> {
        Ok(Self { counts_per_unit: positive("encoder_counts_per_unit", counts_per_unit)? })
    }

    /// Returns the reading (u) for a true `position` (u).
    pub fn read(&self, position: f64) -> f64 {
        (position * self.counts_per_unit).round() / self.counts_per_unit
    }

    /// Returns the length or angle of one count (u).
    pub fn count(&self) -> f64 {
        1.0 / self.counts_per_unit
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reading_is_within_half_a_count_and_on_the_grid() {
        let encoder = Encoder::new(750.0).unwrap();
        for i in -5000..5000 {
            let position = f64::from(i) * 0.000_377;
            let reading = encoder.read(position);
            assert!((reading - position).abs() <= 0.5 * encoder.count() + 1e-12);
            let counts = reading * 750.0;
            assert!((counts - counts.round()).abs() < 1e-9);
        }
    }

    #[test]
    fn nonsense_is_refused() {
        for counts in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Encoder::new(counts).is_err());
        }
    }
}
