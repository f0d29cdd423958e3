use super::error::Error;

/// Detection zone of a frame, mm ahead of the beam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zone {
    /// Start: beyond the pool with its light and heat, and early enough for the correction.
    pub from_mm: f64,
    /// End.
    pub to_mm: f64,
}

/// Requirements of a detection zone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ZoneNeeds {
    /// Distance from the beam to the front of the molten pool, mm.
    pub pool_mm: f64,
    /// Thermal diffusivity of the work, mm^2/s: stainless steel 4, other steels 8 to 14, aluminium 60 and more.
    pub diffusivity_mm2_s: f64,
    /// Time from an exposure to the effect of its correction, s.
    pub known_s: f64,
    /// Frame period, s.
    pub period_s: f64,
    /// Number of frames in which each station is to be seen.
    pub looks: f64,
    /// Reach of the frame ahead of the beam, less its margin, mm.
    pub reach_mm: f64,
}

/// Minimum length of a zone, mm, to detect a direction.
const SHORTEST_MM: f64 = 5.0;
/// Decay lengths to the zone: ahead of a source moving at v, temperature falls by e over a/v (Rosenthal), so to 5 %.
const DECAYS: f64 = 3.0;
/// Speed range searched for valid zones, mm/s, and its number of steps.
const SPEEDS: [f64; 2] = [0.1, 1000.0];
const STEPS: u32 = 800;

impl ZoneNeeds {
    /// Returns the distance ahead of the beam in which the work is molten or too hot, mm. It grows as the speed falls.
    #[must_use]
    pub fn heat_mm(&self, speed: f64) -> f64 {
        self.pool_mm + DECAYS * self.diffusivity_mm2_s / speed
    }

    /// Returns the zone at `speed` (mm/s). It starts beyond pool and heat, early enough for the correction, and is long
    /// enough for each station to appear in [`Self::looks`] frames.
    ///
    /// # Errors
    /// [`Error::ZoneOutside`] if the zone exceeds the frame, with the speeds at which it fits.
    pub fn zone(&self, speed: f64) -> Result<Zone, Error> {
        let zone = self.placed(speed);
        if self.fits(&zone) {
            return Ok(zone);
        }
        let Zone { from_mm, to_mm } = zone;
        let (reach_mm, speeds_that_work) = (self.reach_mm, self.speeds_that_work());
        Err(Error::ZoneOutside { speed_mm_s: speed, from_mm, to_mm, reach_mm, speeds_that_work })
    }

    fn placed(&self, speed: f64) -> Zone {
        let from_mm = self.heat_mm(speed).max(speed * self.known_s);
        Zone { from_mm, to_mm: from_mm + (self.looks * self.period_s * speed).max(SHORTEST_MM) }
    }

    fn fits(&self, zone: &Zone) -> bool {
        zone.to_mm <= self.reach_mm
    }

    /// Returns the valid speeds, rounded inwards to 0.1 mm/s: one range, as the zone's end is a convex function of
    /// speed.
    fn speeds_that_work(&self) -> Option<[f64; 2]> {
        let [low, high] = SPEEDS;
        let speed = |i: u32| low * (high / low).powf(f64::from(i) / f64::from(STEPS));
        let works = |i: &u32| self.fits(&self.placed(speed(*i)));
        let slowest = speed((0..=STEPS).find(works)?);
        let fastest = speed((0..=STEPS).rev().find(works)?);
        let range = [(10.0 * slowest).ceil() / 10.0, (10.0 * fastest).floor() / 10.0];
        (range[0] <= range[1]).then_some(range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEEL: ZoneNeeds =
        ZoneNeeds { pool_mm: 3.0, diffusivity_mm2_s: 8.0, known_s: 0.06, period_s: 0.3, looks: 3.0, reach_mm: 25.0 };

    #[test]
    fn beyond_the_heat_in_time_and_often_enough() {
        for i in 0..200 {
            let v = 2.0 * 1.012f64.powi(i);
            let Ok(zone) = STEEL.zone(v) else { continue };
            // Rosenthal's exponent at the zone's start, from the pool's front.
            assert!((-(zone.from_mm - 3.0) * v / 8.0).exp() <= 0.0498);
            assert!(zone.from_mm >= v * 0.06);
            // A station that enters the zone stays in it for three frames.
            assert!(((zone.to_mm - zone.from_mm) / (v * 0.3) + 1e-9).floor() >= 3.0 && zone.to_mm <= 25.0);
        }
        let [slow, fast] = [2.0, 20.0].map(|v| STEEL.zone(v).unwrap());
        assert!(slow.from_mm > fast.from_mm && slow.to_mm < fast.to_mm);
    }

    /// The speeds named in the error message work, and no others.
    #[test]
    fn outside_of_the_frame_it_is_refused() {
        for reach_mm in [13.0, 18.0, 25.0] {
            let needs = ZoneNeeds { reach_mm, ..STEEL };
            let refused = [0.2, 200.0].map(|v| needs.zone(v).unwrap_err());
            for error in refused {
                let Error::ZoneOutside { speeds_that_work: Some([slow, fast]), to_mm, .. } = error.clone() else {
                    panic!("{error}")
                };
                assert!(to_mm > reach_mm && error.message().code == "tracking-zone-outside");
                for v in [slow, 0.5 * (slow + fast), fast] {
                    assert!(needs.zone(v).is_ok(), "{v}");
                }
                assert!(needs.zone(0.98 * slow - 0.1).is_err() && needs.zone(1.02 * fast + 0.1).is_err());
            }
        }
        let error = ZoneNeeds { reach_mm: 7.0, ..STEEL }.zone(10.0).unwrap_err();
        assert_eq!(error.message().code, "tracking-zone-outside-at-any-speed", "{error}");
    }
}
