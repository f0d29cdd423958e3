use super::limits::SlideLimits;
use super::slide::Slide;
use crate::lead::Error;
use glam::DVec2;

/// Fraction of a slide's stroke that is used before the axes that carry it take over.
const OWN: f64 = 0.6;
/// Fraction of a slide's speed, acceleration and jerk reserved for compensating the axes.
const SHARE: f64 = 0.2;

/// Splits corrections between cross slides and the axes that carry them. Slides make quick corrections; the axes take
/// over the part that would bring a slide near its end.
///
/// The axes keep their own limits and a fifth of the slide's, so corrections within [`SlideAuthority::limits`] never
/// exceed a slide's limits. The axes rest until a slide has used 60 % of its stroke. A correction that then outruns the
/// axes brings the slide to its end, which [`SlideAuthority::has_room`] detects.
#[derive(Debug, Clone)]
pub struct SlideAuthority {
    slide: SlideLimits,
    axes: [Slide; 2],
    range_mm: f64,
}

impl SlideAuthority {
    /// Creates the split between slides with the limits `slide` and axes with the limits `axes`, at rest.
    ///
    /// # Errors
    /// Invalid limits or an invalid cycle.
    pub fn new(slide: SlideLimits, axes: SlideLimits, cycle_s: f64) -> Result<Self, Error> {
        slide.check()?;
        let one = Slide::new(SlideLimits { motion: axes.motion.min(slide.motion.scaled(SHARE)), ..axes }, cycle_s)?;
        Ok(Self { slide, axes: [one.clone(), one], range_mm: axes.stroke_mm })
    }

    /// Returns the combined limits of slides and axes.
    #[must_use]
    pub fn limits(&self) -> SlideLimits {
        let SlideLimits { stroke_mm, motion } = self.slide;
        SlideLimits { stroke_mm: stroke_mm + self.range_mm, motion: motion.scaled(1.0 - SHARE) }
    }

    /// Returns the part of `wanted` (mm) that a slide leaves to the axes in the long run.
    #[must_use]
    pub fn excess(&self, wanted: DVec2) -> DVec2 {
        let own = DVec2::splat(OWN * self.slide.stroke_mm);
        wanted - wanted.clamp(-own, own)
    }

    /// Returns the next set-points of the axes towards `excess`, mm.
    pub fn step(&mut self, excess: DVec2) -> DVec2 {
        let [x, y] = &mut self.axes;
        DVec2::new(x.step(excess.x), y.step(excess.y))
    }

    /// Returns whether a slide can be `left` (mm) off its middle.
    #[must_use]
    pub fn has_room(&self, left: DVec2) -> bool {
        left.abs().max_element() <= self.slide.stroke_mm
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::AxisLimits;
    use std::f64::consts::TAU;

    const SLIDE: SlideLimits =
        SlideLimits { stroke_mm: 10.0, motion: AxisLimits { speed: 50.0, acceleration: 1000.0, jerk: 20_000.0 } };
    const AXES: SlideLimits =
        SlideLimits { stroke_mm: 30.0, motion: AxisLimits { speed: 45.0, acceleration: 150.0, jerk: 1500.0 } };

    /// Corrections within the combined limits keep those of slide and axes, by differences of set-points, and the
    /// slide's stroke.
    #[test]
    fn each_keeps_its_limits() {
        for (size, hz) in [(9.0, 0.5), (18.0, 0.08), (30.0, 0.04), (3.0, 1.5)] {
            let mut authority = SlideAuthority::new(SLIDE, AXES, 1e-3).unwrap();
            let most = authority.limits().motion;
            let mut last = [[DVec2::ZERO; 2]; 4];
            let w = TAU * hz;
            assert!(size * w <= most.speed && size * w * w <= most.acceleration && size * w * w * w <= most.jerk);
            for i in 0..20_000 {
                let t = 1e-3 * f64::from(i);
                // A soft start: from rest to the wave within four seconds.
                let u = (0.25 * t).min(1.0);
                let rise = u.powi(4) * (35.0 - 84.0 * u + 70.0 * u * u - 20.0 * u * u * u);
                let wanted = rise * size * DVec2::new((w * t).sin(), 0.5 * (0.7 * w * t).sin());
                let axes = authority.step(authority.excess(wanted));
                let slide = wanted - axes;
                last = [last[1], last[2], last[3], [slide, axes]];
                if i < 3 {
                    continue;
                }
                for (k, limits) in [SLIDE.motion, AXES.motion].into_iter().enumerate() {
                    let p = |n: usize| last[n][k];
                    let (v, a) = ((p(3) - p(2)) / 1e-3, (p(3) - 2.0 * p(2) + p(1)) / 1e-6);
                    let j = (p(3) - 3.0 * p(2) + 3.0 * p(1) - p(0)) / 1e-9;
                    let most = |of: DVec2| of.abs().max_element();
                    assert!(most(v) <= limits.speed && most(a) <= limits.acceleration, "{size} {hz}: {v} {a}");
                    assert!(most(j) <= limits.jerk * (1.0 + 1e-3), "{size} {hz}: {j}");
                }
                assert!(authority.has_room(slide), "{size} {hz}: {slide}");
            }
        }
    }

    #[test]
    fn axes_rest_until_they_are_needed() {
        let mut authority = SlideAuthority::new(SLIDE, AXES, 1e-3).unwrap();
        let mut axes = DVec2::ZERO;
        for _ in 0..2000 {
            axes = authority.step(authority.excess(DVec2::new(5.9, -5.9)));
        }
        assert!(axes.length() < 1e-12);
        for _ in 0..3000 {
            axes = authority.step(authority.excess(DVec2::new(14.0, 0.0)));
        }
        assert!((axes.x - 8.0).abs() < 1e-6 && axes.y.abs() < 1e-12, "{axes}");
    }
}
