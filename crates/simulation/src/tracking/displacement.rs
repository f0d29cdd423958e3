use crate::disturbance::uniform;
use glam::DVec2;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use std::f64::consts::TAU;

/// One cause of a seam's deviation from the taught seam; mm, lateral and height, by path length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Part {
    /// Constant offset of the whole seam.
    Shift(DVec2),
    /// Offset from a position on: plates that do not meet.
    Step {
        /// Position of the step.
        at_mm: f64,
        /// Offset after the step.
        by: DVec2,
    },
    /// Offset that grows linearly between two positions and stays constant after the second.
    Ramp {
        /// Start of the ramp.
        from_mm: f64,
        /// End of the ramp.
        to_mm: f64,
        /// Offset at the end.
        by: DVec2,
    },
    /// A wave: waviness, or a part out of round.
    Wave {
        /// Wavelength, mm.
        length_mm: f64,
        /// Amplitude.
        size: DVec2,
        /// Phase at the start of the seam, lateral and height, rad.
        phase: DVec2,
    },
    /// Parabolic sag between two supports, towards negative height.
    Sag {
        /// First support.
        from_mm: f64,
        /// Second support.
        to_mm: f64,
        /// Sag in the middle.
        by_mm: f64,
    },
    /// One of two edges moves away: the middle of the gap moves by half of it.
    Gap {
        /// Start of the gap.
        from_mm: f64,
        /// Growth of the gap per path length.
        slope: f64,
        /// Maximum gap.
        most_mm: f64,
    },
    /// Heat of the weld draws the part. Half of the movement is reached at the pool. It decays ahead of the pool and
    /// grows behind it, each with its own length.
    Heat {
        /// Total movement.
        by: DVec2,
        /// Decay length ahead of the pool, mm.
        ahead_mm: f64,
        /// Decay length behind the pool, mm.
        behind_mm: f64,
    },
}

impl Part {
    /// Returns the offset of the seam at `s` while the pool is at `pool`, mm.
    #[must_use]
    pub fn at(&self, s: f64, pool: f64) -> DVec2 {
        match *self {
            Self::Shift(by) => by,
            Self::Step { at_mm, by } => {
                if s < at_mm {
                    DVec2::ZERO
                } else {
                    by
                }
            }
            Self::Ramp { from_mm, to_mm, by } => by * ((s - from_mm) / (to_mm - from_mm)).clamp(0.0, 1.0),
            Self::Wave { length_mm, size, phase } => {
                let turn = TAU * s / length_mm;
                size * DVec2::new((turn + phase.x).sin(), (turn + phase.y).sin())
            }
            Self::Sag { from_mm, to_mm, by_mm } => {
                let u = ((s - from_mm) / (to_mm - from_mm)).clamp(0.0, 1.0);
                DVec2::new(0.0, -4.0 * by_mm * u * (1.0 - u))
            }
            Self::Gap { from_mm, slope, most_mm } => DVec2::new(0.5 * (slope * (s - from_mm)).clamp(0.0, most_mm), 0.0),
            Self::Heat { by, ahead_mm, behind_mm } => {
                let ahead = s - pool;
                by * if ahead > 0.0 { 0.5 * (-ahead / ahead_mm).exp() } else { 1.0 - 0.5 * (ahead / behind_mm).exp() }
            }
        }
    }

    /// Returns the part scaled by one factor per direction; scalars use the factor of their direction.
    pub(super) fn scaled(&self, by: DVec2) -> Self {
        let factor = by;
        match *self {
            Self::Shift(by) => Self::Shift(factor * by),
            Self::Step { at_mm, by } => Self::Step { at_mm, by: factor * by },
            Self::Ramp { from_mm, to_mm, by } => Self::Ramp { from_mm, to_mm, by: factor * by },
            Self::Wave { length_mm, size, phase } => Self::Wave { length_mm, size: factor * size, phase },
            Self::Sag { from_mm, to_mm, by_mm } => Self::Sag { from_mm, to_mm, by_mm: factor.y * by_mm },
            Self::Gap { from_mm, slope, most_mm } => Self::Gap { from_mm, slope, most_mm: factor.x.abs() * most_mm },
            Self::Heat { by, ahead_mm, behind_mm } => Self::Heat { by: factor * by, ahead_mm, behind_mm },
        }
    }
}

/// Deviation of a seam from the taught seam, and the tacks that cover it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Displacement {
    /// Parts, which add up.
    pub parts: Vec<Part>,
    /// Start and end of each tack, mm.
    pub tacks: Vec<(f64, f64)>,
}

impl Displacement {
    /// Creates a displacement of one part.
    #[must_use]
    pub fn of(part: Part) -> Self {
        Self { parts: vec![part], tacks: Vec::new() }
    }

    /// Adds a part.
    #[must_use]
    pub fn and(mut self, part: Part) -> Self {
        self.parts.push(part);
        self
    }

    /// Adds a tack.
    #[must_use]
    pub fn tacked(mut self, from_mm: f64, to_mm: f64) -> Self {
        self.tacks.push((from_mm, to_mm));
        self
    }

    /// Creates a slow bend of up to `size_mm` to each side over a seam of `length_mm`; the seed determines its shape.
    #[must_use]
    pub fn bend(length_mm: f64, size_mm: f64, seed: u64) -> Self {
        const WAVES: usize = 3;
        let mut random = Pcg64Mcg::seed_from_u64(seed ^ 0xbe4d_0000_0000_0001);
        let sizes: [f64; WAVES] = std::array::from_fn(|k| (0.3 + uniform(&mut random)) / (k + 1) as f64);
        let sum: f64 = sizes.iter().sum();
        let parts = sizes.iter().enumerate().map(|(k, size)| Part::Wave {
            length_mm: length_mm / (k as f64 + 0.3 + 0.7 * uniform(&mut random)),
            size: DVec2::splat(size_mm * size / sum),
            phase: DVec2::new(TAU * uniform(&mut random), TAU * uniform(&mut random)),
        });
        Self { parts: parts.collect(), tacks: Vec::new() }
    }

    /// Returns the offset of the seam at `s` while the pool is at `pool`, mm.
    #[must_use]
    pub fn at(&self, s: f64, pool: f64) -> DVec2 {
        self.parts.iter().map(|part| part.at(s, pool)).sum()
    }

    /// Returns true on a tack.
    #[must_use]
    pub fn is_tacked(&self, s: f64) -> bool {
        self.tacks.iter().any(|(from, to)| (*from..*to).contains(&s))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Heat moves the seam without jumps as the pool passes, and by the total movement in the end.
    #[test]
    fn heat_grows_evenly() {
        let heat = Part::Heat { by: DVec2::new(0.6, -0.2), ahead_mm: 60.0, behind_mm: 150.0 };
        let mut last = heat.at(500.0, -3000.0);
        assert!(last.length() < 1e-9);
        for pool in -2000..4000 {
            let now = heat.at(500.0, f64::from(pool));
            assert!(now.x >= last.x && now.distance(last) < 0.01);
            last = now;
        }
        assert!(last.distance(DVec2::new(0.6, -0.2)) < 1e-6);
        assert!(heat.at(500.0, 500.0).distance(DVec2::new(0.3, -0.1)) < 1e-12, "half of it at the pool");
    }

    #[test]
    fn parts_are_what_they_say() {
        let step = Part::Step { at_mm: 10.0, by: DVec2::X };
        let ramp = Part::Ramp { from_mm: 100.0, to_mm: 300.0, by: DVec2::new(4.0, 2.0) };
        let sag = Part::Sag { from_mm: 0.0, to_mm: 200.0, by_mm: 1.5 };
        let gap = Part::Gap { from_mm: 20.0, slope: 0.01, most_mm: 1.0 };
        let known = [
            (step, [(9.99, DVec2::ZERO), (10.0, DVec2::X), (99.0, DVec2::X)]),
            (ramp, [(50.0, DVec2::ZERO), (150.0, DVec2::new(1.0, 0.5)), (400.0, DVec2::new(4.0, 2.0))]),
            (sag, [(0.0, DVec2::ZERO), (100.0, -1.5 * DVec2::Y), (200.0, DVec2::ZERO)]),
            (gap, [(0.0, DVec2::ZERO), (70.0, 0.25 * DVec2::X), (500.0, 0.5 * DVec2::X)]),
        ];
        for (part, places) in known {
            for (s, by) in places {
                assert!(part.at(s, 0.0).distance(by) < 1e-12, "{part:?} at {s}");
            }
        }
        let bends = (0..200).map(|seed| Displacement::bend(600.0, 2.0, seed));
        for bend in bends {
            let most = (0..600).map(|s| bend.at(f64::from(s), 0.0).abs().max_element()).fold(0.0, f64::max);
            assert!((0.1..=2.0).contains(&most), "{most}");
        }
        let both = Displacement::of(step).and(ramp).tacked(5.0, 20.0);
        assert_eq!(both.at(200.0, 0.0), DVec2::new(3.0, 1.0));
        assert!(both.is_tacked(5.0) && !both.is_tacked(20.0));
    }
}
