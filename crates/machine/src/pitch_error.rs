use seamwright_geometry::CubicSpline;

/// What an axis really does against what its control believes: the table of its measured pitch error, mm or rad.
///
/// The error is the true position less the indicated one. Between the table's places it follows a cubic spline, so
/// that the compensation adds no jumps to an axis' acceleration; beyond them it stays as at the last.
#[derive(Debug, Clone, PartialEq)]
pub struct PitchError {
    error: CubicSpline,
}

/// Steepest error allowed: a tenth of the motion. Beyond it is no pitch error, and the way back would not be safe.
pub(crate) const STEEPEST: f64 = 0.1;

impl PitchError {
    pub(crate) fn new(error: CubicSpline) -> Self {
        Self { error }
    }

    /// The true position at the indicated one, and the derivative of it.
    pub fn true_at(&self, indicated: f64) -> (f64, f64) {
        let (error, slope, _) = self.error.at(indicated);
        (indicated + error, 1.0 + slope)
    }

    /// The indicated position at which the axis truly is at `position`, by Newton's method: the error's slope is small.
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
