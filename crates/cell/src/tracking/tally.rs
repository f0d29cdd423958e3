use glam::DVec2;
use seamwright_machine::AxisLimits;
use seamwright_tracking::actuator::SlideLimits;

/// Distances of a weld from its seam, weighted by path length.
#[derive(Debug, Clone, Default)]
pub(super) struct Tally {
    misses: Vec<(f64, f64)>,
}

impl Tally {
    /// Adds a miss over this stretch of the way, mm.
    pub(super) fn add(&mut self, miss: DVec2, way: f64) {
        self.misses.push((miss.length(), way));
    }

    /// Returns the distance within which this part of the way lies; infinite if empty.
    pub(super) fn quantile(&mut self, part: f64) -> f64 {
        self.misses.sort_by(|a, b| a.0.total_cmp(&b.0));
        let whole: f64 = self.misses.iter().map(|m| m.1).sum();
        let mut way = 0.0;
        for (miss, by) in &self.misses {
            way += by;
            if way >= part * whole {
                return *miss;
            }
        }
        self.misses.last().map_or(f64::INFINITY, |m| m.0)
    }

    /// Returns the welded distance, mm.
    pub(super) fn way(&self) -> f64 {
        self.misses.iter().map(|m| m.1).sum()
    }
}

/// Monitors the set-points of one axis of a slide, by differences.
#[derive(Debug, Clone, Copy)]
pub(super) struct Watch {
    limits: SlideLimits,
    cycle_s: f64,
    last: [f64; 4],
    /// Maximum used share of each limit: stroke, speed, acceleration, jerk.
    pub(super) used: [f64; 4],
}

impl Watch {
    pub(super) fn new(limits: SlideLimits, cycle_s: f64) -> Self {
        Self { limits, cycle_s, last: [0.0; 4], used: [0.0; 4] }
    }

    pub(super) fn add(&mut self, position: f64) {
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

/// Reversals of a set-point below this are noise, mm.
const NOISE_MM: f64 = 0.05;

/// Counts reversals of set-points: oscillations reverse again and again.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Turns {
    extreme: Option<f64>,
    sense: f64,
    pub(super) count: u32,
}

impl Turns {
    pub(super) fn add(&mut self, position: f64) {
        let extreme = *self.extreme.get_or_insert(position);
        let way = position - extreme;
        if self.sense * way > 0.0 {
            self.extreme = Some(position);
        } else if way.abs() > NOISE_MM {
            self.count += u32::from(self.sense != 0.0);
            (self.extreme, self.sense) = (Some(position), way.signum());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_of_a_sine_and_of_noise() {
        let count = |position: &dyn Fn(f64) -> f64| {
            let mut turns = Turns::default();
            (0..10_000).for_each(|i| turns.add(position(1e-3 * f64::from(i))));
            turns.count
        };
        assert_eq!(count(&|t| (std::f64::consts::TAU * t).sin()), 20);
        assert_eq!(count(&|t| 0.02 * (300.0 * t).sin()), 0);
        assert_eq!(count(&|t| 0.3 * t + 0.02 * (300.0 * t).sin()), 0);
    }

    #[test]
    fn quantiles_by_way() {
        let mut tally = Tally::default();
        for i in 0..100 {
            tally.add(DVec2::new(f64::from(i), 0.0), if i == 99 { 1.0 } else { 2.0 });
        }
        assert!((tally.quantile(0.5) - 49.0).abs() < 1e-12 && (tally.quantile(1.0) - 99.0).abs() < 1e-12);
        assert!((tally.way() - 199.0).abs() < 1e-9);
        assert!(Tally::default().quantile(0.5).is_infinite());
    }

    #[test]
    fn limits_by_differences() {
        let limits =
            SlideLimits { stroke_mm: 10.0, motion: AxisLimits { speed: 5.0, acceleration: 20.0, jerk: 100.0 } };
        let mut watch = Watch::new(limits, 1e-3);
        // A cubic from rest: t^3 has a third derivative of 6, at t = 1 3 mm/s and 6 mm/s^2.
        for i in 1..=1000 {
            watch.add((1e-3 * f64::from(i)).powi(3));
        }
        for (used, part) in watch.used.iter().zip([0.1, 0.6, 0.3, 0.06]) {
            assert!((used - part).abs() < 0.01 * part + 1e-3, "{:?}", watch.used);
        }
    }
}
