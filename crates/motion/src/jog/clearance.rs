use super::point_to_point::PointToPoint;
use crate::transfer::{nearest, too_near};
use seamwright_clearance::{ClearanceError, Limits};
use seamwright_machine::{Course, Joints, Surroundings};
use seamwright_message::Message;

/// Clearance along a point-to-point motion; times in s from its start.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionClearance {
    /// Minimum distance found (mm), its time, and the two solids; none if all distances exceed the cut-off.
    pub nearest: Option<(f64, f64, [Message; 2])>,
    /// Time intervals in which a watch fails or cannot be proved: start, end, and the solids that are too near.
    pub too_near: Vec<(f64, f64, Message)>,
    /// Maximum distance that is reported, mm.
    pub cutoff_mm: f64,
}

const STATIONS: usize = 200;
const CUTOFF_MM: f64 = 200.0;

/// Positions over time, s.
impl Course for PointToPoint {
    fn range(&self) -> (f64, f64) {
        (0.0, self.duration())
    }

    fn at(&self, s: f64) -> Joints {
        PointToPoint::at(self, s).q
    }

    /// Bounds a speed between two times by its values there and the maximum acceleration.
    fn greatest_rates(&self, from: f64, to: f64) -> Joints {
        let (first, last) = (PointToPoint::at(self, from), PointToPoint::at(self, to));
        let mut rates = Joints::default();
        for (i, limits) in self.limits().iter().enumerate() {
            let ends = first.speed[i].abs() + last.speed[i].abs();
            rates[i] = 0.5 * (ends + limits.acceleration * (1.0 + 1e-9) * (to - from));
        }
        rates
    }
}

impl PointToPoint {
    /// Computes the distances along the planned motion: every violation of a watch is listed.
    ///
    /// # Errors
    /// Those of [`Surroundings::along`]; not expected in practice.
    pub fn clearance(&self, around: &Surroundings) -> Result<MotionClearance, ClearanceError> {
        let smallest = (1e-5 * self.duration()).max(1e-9);
        let limits = Limits { cutoff_mm: CUTOFF_MM, precision_mm: 0.2, smallest };
        let profile = around.along(self, STATIONS, &limits)?;
        let stretches = profile.stretches.iter();
        let too_near = stretches.map(|s| (s.from, s.to, too_near(around, s.watch, &s.nearest, None))).collect();
        Ok(MotionClearance { nearest: nearest(around, &profile), too_near, cutoff_mm: CUTOFF_MM })
    }
}
