use glam::DVec2;

/// Distances of a weld from its seam, weighted by path length.
#[derive(Debug, Clone, Default)]
pub(in crate::tracking) struct MissDistribution {
    misses: Vec<(f64, f64)>,
}

impl MissDistribution {
    /// Adds a miss over this stretch of the way, mm.
    pub(in crate::tracking) fn add(&mut self, miss: DVec2, way: f64) {
        self.misses.push((miss.length(), way));
    }

    /// Returns the distance within which this part of the way lies; infinite if empty.
    pub(in crate::tracking) fn quantile(&mut self, part: f64) -> f64 {
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
    pub(in crate::tracking) fn way(&self) -> f64 {
        self.misses.iter().map(|m| m.1).sum()
    }
}

/// Reversals of a set-point below this are noise, mm.
const NOISE_MM: f64 = 0.05;

/// Counts reversals of set-points: oscillations reverse again and again.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::tracking) struct Turns {
    extreme: Option<f64>,
    sense: f64,
    pub(in crate::tracking) count: u32,
}

impl Turns {
    pub(in crate::tracking) fn add(&mut self, position: f64) {
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
        let mut misses = MissDistribution::default();
        for i in 0..100 {
            misses.add(DVec2::new(f64::from(i), 0.0), if i == 99 { 1.0 } else { 2.0 });
        }
        assert!((misses.quantile(0.5) - 49.0).abs() < 1e-12 && (misses.quantile(1.0) - 99.0).abs() < 1e-12);
        assert!((misses.way() - 199.0).abs() < 1e-9);
        assert!(MissDistribution::default().quantile(0.5).is_infinite());
    }
}
