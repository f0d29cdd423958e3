use crate::curve::{Curve, Jet};
use crate::error::{Error, positive};
use crate::tube::Tube;
use std::f64::consts::TAU;

/// A helix on a tube: `u` is the angle in rad about its axis, from 0 over a number of turns; each turn climbs by the
/// pitch.
#[derive(Debug, Clone, PartialEq)]
pub struct Helix {
    tube: Tube,
    /// Climb per rad, mm.
    climb: f64,
    end: f64,
}

impl Helix {
    /// The helix on `tube` from its origin's height on, where its angle is 0: counter-clockwise about its direction
    /// over `turns`, climbing by `pitch` mm a turn (negative: left-handed).
    ///
    /// # Errors
    /// [`Error::Size`] if there are no turns or the pitch is not finite.
    pub fn new(tube: Tube, pitch: f64, turns: f64) -> Result<Self, Error> {
        if !pitch.is_finite() {
            return Err(Error::Size { what: "geometry-helix-pitch", value: pitch });
        }
        Ok(Self { tube, climb: pitch / TAU, end: TAU * positive("geometry-turns", turns)? })
    }
}

impl Curve for Helix {
    fn domain(&self) -> (f64, f64) {
        (0.0, self.end)
    }
    fn jet(&self, u: f64) -> Jet {
        let (sin, cos) = u.sin_cos();
        let t = &self.tube;
        let out = t.radius * (cos * t.e1 + sin * t.e2);
        let along = t.radius * (cos * t.e2 - sin * t.e1);
        Jet { point: t.origin + out + self.climb * u * t.e3, d1: along + self.climb * t.e3, d2: -out }
    }
    fn speed(&self, _u: f64) -> f64 {
        self.tube.radius.hypot(self.climb)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arc_length::{ByLength, DEFAULT_ACCURACY_MM};
    use glam::DVec3;

    #[test]
    fn derivatives_and_length() {
        let tube = Tube::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 1.0, 0.2), DVec3::Z, 40.0).unwrap();
        for (pitch, turns) in [(12.0, 3.5), (-7.0, 0.25), (0.0, 2.0)] {
            let helix = Helix::new(tube.clone(), pitch, turns).unwrap();
            crate::curve::testing::check_derivatives(&helix, 1000.0);
            let length = turns * (TAU * 40.0f64).hypot(pitch);
            let by_length = ByLength::new(&helix, DEFAULT_ACCURACY_MM).unwrap();
            assert!((by_length.length() - length).abs() < 1e-11);
            assert!((by_length.parameter(0.3 * length) - 0.3 * TAU * turns).abs() < 1e-12);
        }
        assert!(Helix::new(tube.clone(), 1.0, 0.0).is_err());
        assert!(Helix::new(tube, f64::NAN, 1.0).is_err());
    }
}
