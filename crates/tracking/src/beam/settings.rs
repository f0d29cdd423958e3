use super::error::Error;
use super::schedule::{Allowed, Schedule};
use super::zone::{Zone, ZoneNeeds};
use crate::lead;
use glam::DVec2;
use seamwright_message::Message;

/// Settings of beam tracking.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Allowed interruptions of the weld.
    pub allowed: Allowed,
    /// Frame period, s.
    pub period_s: f64,
    /// Duration of a frame, s.
    pub scan_s: f64,
    /// Minimum and maximum age of a frame's midline at its arrival, s.
    pub age_s: [f64; 2],
    /// The cell's cycle, s.
    pub cycle_s: f64,
    /// Minimum and maximum welding speed, mm/s.
    pub speed_mm_s: [f64; 2],
    /// Distance from the beam to the front of the molten pool, mm.
    pub pool_mm: f64,
    /// Thermal diffusivity of the work, mm^2/s.
    pub diffusivity_mm2_s: f64,
    /// Number of frames in which each station is to be seen.
    pub looks: f64,
    /// Reach of the frame from its middle, less its margin, mm: along and across.
    pub reach_mm: DVec2,
    /// Standard deviation of a point of confidence 1, mm; divided by c for confidence c.
    pub noise_mm: f64,
    /// Minimum confidence of a point.
    pub least_confidence: f64,
    /// Maximum length of a tack weld on the seam, mm.
    pub tack_mm: f64,
}

/// Time from a known correction to its effect, s: three cycles and the deflection.
const NOTICE_S: f64 = 0.005;

impl Settings {
    /// Typical values on steel: frames as often as EBW-2004 allows, detection within 60 ms, 512 pixels of 0.1 mm.
    #[must_use]
    pub fn usual(speed_mm_s: f64) -> Self {
        Self {
            allowed: Allowed::EBW_2004,
            period_s: 0.3,
            scan_s: 0.005,
            age_s: [0.0, 0.06],
            cycle_s: 1e-3,
            speed_mm_s: [0.5 * speed_mm_s, speed_mm_s],
            pool_mm: 3.0,
            diffusivity_mm2_s: 8.0,
            looks: 4.0,
            reach_mm: DVec2::splat(24.0),
            noise_mm: 0.03,
            least_confidence: 0.4,
            tack_mm: 5.0,
        }
    }

    /// Returns the detection zone at `speed` (mm/s), clamped to the speed range.
    ///
    /// # Errors
    /// [`Error::ZoneOutside`] if the zone exceeds the frame.
    pub fn zone(&self, speed: f64) -> Result<Zone, Error> {
        let needs = ZoneNeeds {
            pool_mm: self.pool_mm,
            diffusivity_mm2_s: self.diffusivity_mm2_s,
            known_s: self.age_s[1] + NOTICE_S,
            period_s: self.period_s,
            looks: self.looks,
            reach_mm: self.reach_mm.x,
        };
        let [slow, fast] = self.speed_mm_s;
        needs.zone(speed.clamp(slow, fast))
    }

    /// Checks the values. Returns the schedule and the tracker's settings, with the look-ahead distance of the farthest
    /// zone.
    ///
    /// # Errors
    /// Invalid values, interruptions beyond the allowed ones, a zone outside the frame, a frame that is too late.
    pub fn check(&self) -> Result<(Schedule, lead::Settings), Error> {
        let positive = [
            ("pool_mm", self.pool_mm),
            ("diffusivity_mm2_s", self.diffusivity_mm2_s),
            ("reach_mm", self.reach_mm.min_element()),
        ];
        for (key, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(lead::Error::not_positive(key, value).into());
            }
        }
        let [slow, fast] = self.speed_mm_s;
        if !(slow > 0.0 && slow <= fast && fast.is_finite()) {
            let allowed = Message::new("tracking-speeds-allowed");
            return Err(lead::Error::Value { key: "speed_mm_s", value: slow, allowed }.into());
        }
        if !(1.0..=100.0).contains(&self.looks) {
            return Err(lead::Error::not_between("looks", self.looks, [1.0, 100.0]).into());
        }
        let schedule = Schedule::new(self.allowed, self.period_s, self.scan_s)?;
        // The zone's end is a convex function of speed: its maximum is at one end of the speed range.
        let lead_mm = self.zone(slow)?.to_mm.max(self.zone(fast)?.to_mm);
        let lead = self.lead(lead_mm);
        lead.check()?;
        Ok((schedule, lead))
    }

    fn lead(&self, lead_mm: f64) -> lead::Settings {
        lead::Settings {
            cycle_s: self.cycle_s,
            period_s: self.period_s,
            age_s: self.age_s,
            notice_s: NOTICE_S,
            noise_mm: self.noise_mm,
            least_confidence: self.least_confidence,
            field_mm: DVec2::splat(self.reach_mm.y),
            tack_mm: self.tack_mm,
            wander: 1e-3,
            ..lead::Settings::usual(lead_mm, self.speed_mm_s[1])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_cannot_work_is_refused() {
        let good = Settings::usual(10.0);
        let (_, lead) = good.check().unwrap();
        assert!((good.zone(10.0).unwrap().to_mm - lead.lead_mm).abs() < 1e-12);
        assert_eq!(good.zone(0.0), good.zone(5.0));
        let bad = [
            ("pool_mm", Settings { pool_mm: 0.0, ..good }),
            ("diffusivity_mm2_s", Settings { diffusivity_mm2_s: -1.0, ..good }),
            ("reach_mm", Settings { reach_mm: DVec2::new(20.0, f64::NAN), ..good }),
            ("speed_mm_s", Settings { speed_mm_s: [11.0, 10.0], ..good }),
            ("looks", Settings { looks: 0.5, ..good }),
            ("noise_mm", Settings { noise_mm: 0.0, ..good }),
        ];
        for (name, settings) in bad {
            let error = settings.check().unwrap_err();
            assert!(matches!(error, Error::Value(lead::Error::Value { key, .. }) if key == name), "{name}: {error}");
        }
        let refused = |settings: Settings| settings.check().unwrap_err();
        assert!(matches!(refused(Settings { period_s: 0.2, ..good }), Error::TooOften { .. }));
        assert!(matches!(refused(Settings { scan_s: 0.01, ..good }), Error::TooLong { .. }));
        for v in [60.0, 0.5] {
            let error = refused(Settings::usual(v));
            let Error::ZoneOutside { speeds_that_work: Some([_, fast]), .. } = error else { panic!("{error}") };
            assert!(Settings::usual(fast).check().is_ok(), "{fast}");
        }
        let late = refused(Settings { age_s: [0.0, 1.5], ..good });
        assert!(matches!(late, Error::ZoneOutside { .. } | Error::Value(lead::Error::LeadTooShort { .. })), "{late}");
    }
}
