use glam::DVec2;

/// How well the seam is known at a place; each is worse than the one before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sight {
    /// The joint was seen there.
    Seen,
    /// Nothing was seen there, but before and behind it.
    Bridged,
    /// Nothing has been seen since: the last slope is followed, less and less.
    Coasted,
    /// The same for too long: back to the taught path.
    Fading,
    /// There is nothing to go by: the taught path.
    Unseen,
    /// The correction has faded out. Stop.
    Lost,
}

/// Deviation of the seam from the taught path at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Lateral and height, mm.
    pub value: DVec2,
    /// Standard deviation, mm; infinite where nothing is known.
    pub sigma_mm: f64,
    /// How it is known.
    pub sight: Sight,
}

/// What is known at the border of two cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    pub(super) value: DVec2,
    /// By path length.
    pub(super) slope: DVec2,
    pub(super) variance: f64,
    pub(super) sight: Sight,
}

impl Node {
    pub(super) const UNSEEN: Self =
        Self { value: DVec2::ZERO, slope: DVec2::ZERO, variance: f64::INFINITY, sight: Sight::Unseen };

    pub(super) fn estimate(&self) -> Estimate {
        Estimate { value: self.value, sigma_mm: self.variance.sqrt(), sight: self.sight }
    }

    /// Between two nodes that lie `way` mm apart, `part` of the way from the first: Hermite's cubic.
    pub(super) fn between(&self, next: &Self, way: f64, part: f64) -> Estimate {
        let (p, q) = (part, 1.0 - part);
        let value = q * q * (1.0 + 2.0 * p) * self.value
            + p * p * (1.0 + 2.0 * q) * next.value
            + way * p * q * (q * self.slope - p * next.slope);
        let variance = self.variance.max(next.variance);
        Estimate { value, sigma_mm: variance.sqrt(), sight: self.sight.max(next.sight) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_met() {
        let cubic = |s: f64| 0.3 - 0.2 * s + 0.5 * s * s - 0.7 * s * s * s;
        let slope = |s: f64| -0.2 + s - 2.1 * s * s;
        let node = |s: f64| Node {
            value: DVec2::new(cubic(s), -cubic(s)),
            slope: DVec2::new(slope(s), -slope(s)),
            variance: s,
            sight: if s > 1.0 { Sight::Bridged } else { Sight::Seen },
        };
        for i in 0..=100 {
            let part = f64::from(i) / 100.0;
            let found = node(0.5).between(&node(1.3), 0.8, part);
            let truth = cubic(0.5 + 0.8 * part);
            assert!(found.value.distance(DVec2::new(truth, -truth)) < 1e-12);
            assert_eq!((found.sight, found.sigma_mm), (Sight::Bridged, 1.3f64.sqrt()));
        }
    }
}
