use crate::lead::Error;
use glam::DVec2;
use seamwright_machine::BeamDeflection;

/// Beam deflection: without inertia, limited in range and slew rate.
#[derive(Debug, Clone)]
pub struct Deflection {
    limits: BeamDeflection,
    cycle_s: f64,
    at: DVec2,
}

impl Deflection {
    /// Creates an undeflected beam.
    ///
    /// # Errors
    /// [`Error::Value`] for invalid limits.
    pub fn new(limits: BeamDeflection, cycle_s: f64) -> Result<Self, Error> {
        for (key, value) in [("range_mm", limits.range_mm), ("speed", limits.speed), ("cycle_s", cycle_s)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::not_positive(key, value));
            }
        }
        if !(0.0..=1.0).contains(&limits.latency_s) {
            return Err(Error::not_between("latency_s", limits.latency_s, [0.0, 1.0]));
        }
        Ok(Self { limits, cycle_s, at: DVec2::ZERO })
    }

    /// Returns the time from a command to its effect, s.
    #[must_use]
    pub fn lag_s(&self) -> f64 {
        self.limits.latency_s
    }

    /// Returns the deflection commanded in the next cycle towards `target`, mm.
    pub fn step(&mut self, target: DVec2) -> DVec2 {
        if target.is_finite() {
            let within = target.clamp_length_max(self.limits.range_mm);
            self.at += (within - self.at).clamp_length_max(self.limits.speed * self.cycle_s);
        }
        self.at
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn range_and_slew_hold_and_the_rest_is_exact() {
        let limits = BeamDeflection { range_mm: 5.0, speed: 1000.0, latency_s: 75e-6, pivot_mm: 400.0 };
        let mut beam = Deflection::new(limits, 1e-3).unwrap();
        let mut last = DVec2::ZERO;
        for i in 0..20_000 {
            let t = f64::from(i);
            let wild = i % 500 < 100;
            let target = DVec2::new((0.02 * t).sin(), (0.013 * t).cos()) * if wild { 9.0 } else { 2.0 };
            let at = beam.step(if i % 997 == 0 { DVec2::NAN } else { target });
            assert!(at.length() <= 5.0 + 1e-12 && at.distance(last) <= 1.0 + 1e-12);
            assert!(wild || i % 500 < 120 || i % 997 == 0 || at.distance(target) < 1e-12, "{i}");
            last = at;
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let good = BeamDeflection { range_mm: 5.0, speed: 1000.0, latency_s: 75e-6, pivot_mm: 400.0 };
        for (name, limits) in [
            ("range_mm", BeamDeflection { range_mm: -5.0, ..good }),
            ("speed", BeamDeflection { speed: f64::NAN, ..good }),
            ("latency_s", BeamDeflection { latency_s: -1.0, ..good }),
        ] {
            assert!(matches!(Deflection::new(limits, 1e-3), Err(Error::Value { key, .. }) if key == name), "{name}");
        }
    }
}
