use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Quality of the seam estimate at a position, from best to worst.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Sight {
    /// Measured.
    Seen,
    /// Interpolated between measurements before and behind.
    Bridged,
    /// Extrapolated with the decaying last slope.
    Coasted,
    /// Extrapolated for too long: the correction fades out to the taught path.
    Fading,
    /// Unknown: the taught path.
    Unseen,
    /// The correction has faded out: the torch stops.
    Lost,
}

/// Deviation of the seam from the taught path at a position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// Lateral and height, mm.
    pub value: DVec2,
    /// Standard deviation, mm; infinite where the seam is unknown.
    pub sigma_mm: f64,
    /// Quality of the estimate.
    pub sight: Sight,
}

/// Estimate at the border of two cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Node {
    pub(super) value: DVec2,
    /// Slope over path length.
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

    /// Interpolates to the next node, `way` mm away, at fraction `part` of the distance (cubic Hermite).
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
