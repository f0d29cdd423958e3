use crate::lead::Error;

/// Limits of one axis of a cross slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlideLimits {
    /// Stroke to each side of the middle, mm.
    pub stroke_mm: f64,
    /// Maximum speed, mm/s.
    pub speed: f64,
    /// Maximum acceleration, mm/s^2.
    pub acceleration: f64,
    /// Maximum jerk, mm/s^3.
    pub jerk: f64,
}

impl SlideLimits {
    /// Checks all limits.
    ///
    /// # Errors
    /// [`Error::Value`] for one that is not positive and finite.
    pub fn check(&self) -> Result<(), Error> {
        let values = [
            ("stroke_mm", self.stroke_mm),
            ("speed", self.speed),
            ("acceleration", self.acceleration),
            ("jerk", self.jerk),
        ];
        match values.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
            Some((key, value)) => Err(Error::not_positive(key, value)),
            None => Ok(()),
        }
    }
}
