use seamwright_machine::AxisLimits;
use seamwright_tracking::actuator::SlideLimits;

/// Monitors the set-points of one axis of a slide, by differences.
#[derive(Debug, Clone, Copy)]
pub struct LimitUse {
    limits: SlideLimits,
    cycle_s: f64,
    last: [f64; 4],
    /// Maximum used share of each limit: stroke, speed, acceleration, jerk.
    pub used: [f64; 4],
}

impl LimitUse {
    /// Starts at rest at zero, with a position every `cycle_s`.
    #[must_use]
    pub fn new(limits: SlideLimits, cycle_s: f64) -> Self {
        Self { limits, cycle_s, last: [0.0; 4], used: [0.0; 4] }
    }

    /// Adds the next set-point.
    pub fn add(&mut self, position: f64) {
        let [_, a, b, c] = self.last;
        self.last = [a, b, c, position];
        let d = [c, b, a].map(|p| (position - p) / self.cycle_s);
        let v = [d[0], d[1] - d[0], d[2] - d[1]];
        let acceleration = (v[0] - v[1]) / self.cycle_s;
        let before = (v[1] - v[2]) / self.cycle_s;
        let SlideLimits { stroke_mm, motion: AxisLimits { speed, acceleration: most, jerk } } = self.limits;
        let parts = [
            position.abs() / stroke_mm,
            v[0].abs() / speed,
            acceleration.abs() / most,
            ((acceleration - before) / self.cycle_s).abs() / jerk,
        ];
        for (used, part) in self.used.iter_mut().zip(parts) {
            *used = used.max(part);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_by_differences() {
        let motion = AxisLimits { speed: 5.0, acceleration: 20.0, jerk: 100.0 };
        let limits = SlideLimits { stroke_mm: 10.0, motion };
        let mut limit_use = LimitUse::new(limits, 1e-3);
        // A cubic from rest: t^3 has a third derivative of 6, at t = 1 3 mm/s and 6 mm/s^2.
        for i in 1..=1000 {
            limit_use.add((1e-3 * f64::from(i)).powi(3));
        }
        for (used, part) in limit_use.used.iter().zip([0.1, 0.6, 0.3, 0.06]) {
            assert!((used - part).abs() < 0.01 * part + 1e-3, "{:?}", limit_use.used);
        }
    }
}
