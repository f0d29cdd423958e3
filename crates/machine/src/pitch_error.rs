use seamwright_geometry::CubicSpline;

/// Measured pitch error of an axis as a table, mm or rad: the true position against the indicated one.
///
/// The error is the true position less the indicated one. Between the table's positions it follows a cubic spline, so
/// that the compensation keeps an axis' acceleration continuous; beyond them it is constant.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchError {
    error: CubicSpline,
}

/// Maximum slope of the error: a tenth of the motion. Steeper tables are not pitch errors, and the inverse would not be
/// safe.
pub(crate) const STEEPEST: f64 = 0.1;

impl PitchError {
    pub(crate) fn new(error: CubicSpline) -> Self {
        Self { error }
    }

    /// The true position at the indicated one, and its derivative.
    pub fn true_at(&self, indicated: f64) -> (f64, f64) {
        let (error, slope, _) = self.error.at(indicated);
        (indicated + error, 1.0 + slope)
    }

    /// The indicated position for the true `position`, by Newton's method: the error's slope is small.
    pub fn indicated_at(&self, position: f64) -> f64 {
        let mut indicated = position - self.error.at(position).0;
        for _ in 0..8 {
            let (there, slope) = self.true_at(indicated);
            let step = (position - there) / slope;
            indicated += step;
            if step.abs() <= 1e-15 * indicated.abs().max(1.0) {
                break;
            }
        }
        indicated
    }
}
