use crate::lead::Error;
use seamwright_machine::AxisLimits;

/// Limits of one axis of a cross slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlideLimits {
    /// Stroke to each side of the middle, mm.
    pub stroke_mm: f64,
    /// Limits of its motion, mm and s.
    pub motion: AxisLimits,
}

impl SlideLimits {
    /// Checks all limits.
    ///
    /// # Errors
    /// [`Error::Value`] for one that is not positive and finite.
    pub fn check(&self) -> Result<(), Error> {
        let AxisLimits { speed, acceleration, jerk } = self.motion;
        let values = [("stroke_mm", self.stroke_mm), ("speed", speed), ("acceleration", acceleration), ("jerk", jerk)];
        match values.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
            Some((key, value)) => Err(Error::not_positive(key, value)),
            None => Ok(()),
        }
    }
}
