use super::error::Error;
use glam::DVec2;
use seamwright_message::Message;

/// Smoothing reach to each side of a position, as a fraction of the look-ahead distance; measurements must extend that
/// far beyond the position.
pub(super) const REACH: f64 = 0.25;

/// Settings for tracking with a look-ahead sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Look-ahead distance of the sensor, mm.
    pub lead_mm: f64,
    /// Maximum speed along the seam, mm/s.
    pub speed_mm_s: f64,
    /// The cell's cycle, s.
    pub cycle_s: f64,
    /// Time between exposures, s.
    pub period_s: f64,
    /// Minimum and maximum age of a measurement at its arrival, s. Others are rejected because of a wrong clock.
    pub age_s: [f64; 2],
    /// Time before the torch reaches a position at which the actuator needs its deviation, s.
    pub notice_s: f64,
    /// Standard deviation of a measurement of confidence 1, mm; divided by c for confidence c.
    pub noise_mm: f64,
    /// Minimum confidence of a measurement.
    pub least_confidence: f64,
    /// Calibrated field of the sensor: maximum offsets to each side of its zero, lateral and height, mm.
    pub field_mm: DVec2,
    /// Random walk of the seam's slope against the taught path: variance of its change over 1 mm, 1/mm.
    pub wander: f64,
    /// Drift of the seam after its measurement: variance of its movement in 1 s, mm^2/s.
    pub drift: f64,
    /// Decay length of the last slope during extrapolation, mm.
    pub decay_mm: f64,
    /// Maximum length of a tack weld on the seam, mm.
    pub tack_mm: f64,
    /// Distance over which the correction fades out to the taught path after too long without measurements, mm.
    pub fade_mm: f64,
}

impl Settings {
    /// Typical values for a stripe sensor: 10 ms frame period, 15 ms latency give or take a period, 0.02 mm noise.
    #[must_use]
    pub fn usual(lead_mm: f64, speed_mm_s: f64) -> Self {
        Self {
            lead_mm,
            speed_mm_s,
            cycle_s: 1e-3,
            period_s: 0.01,
            age_s: [0.004, 0.03],
            notice_s: 0.07,
            noise_mm: 0.02,
            least_confidence: 0.4,
            field_mm: DVec2::splat(10.0),
            wander: 0.01,
            drift: 1e-3,
            decay_mm: 10.0,
            tack_mm: 10.0,
            fade_mm: 15.0,
        }
    }

    /// Distance without measurements after which the correction fades out, mm.
    #[must_use]
    pub fn coast_mm(&self) -> f64 {
        (1.5 * self.tack_mm).max(15.0)
    }

    /// Checks all values.
    ///
    /// # Errors
    /// [`Error::Value`] for an invalid value; [`Error::LeadTooShort`] if measurements would arrive too late.
    pub fn check(&self) -> Result<(), Error> {
        let positive = [
            ("lead_mm", self.lead_mm),
            ("speed_mm_s", self.speed_mm_s),
            ("cycle_s", self.cycle_s),
            ("period_s", self.period_s),
            ("noise_mm", self.noise_mm),
            ("field_mm", self.field_mm.min_element()),
            ("wander", self.wander),
            ("decay_mm", self.decay_mm),
            ("fade_mm", self.fade_mm),
        ];
        for (key, value) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::not_positive(key, value));
            }
        }
        let [young, old] = self.age_s;
        for (key, value) in
            [("age_s", young), ("notice_s", self.notice_s), ("drift", self.drift), ("tack_mm", self.tack_mm)]
        {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(Error::Value { key, value, allowed: Message::new("document-non-negative-number") });
            }
        }
        if !(old > young && old <= 10.0) {
            return Err(Error::Value { key: "age_s", value: old, allowed: Message::new("tracking-ages") });
        }
        if !(0.0..=1.0).contains(&self.least_confidence) {
            return Err(Error::not_between("least_confidence", self.least_confidence, [0.0, 1.0]));
        }
        self.check_lead()
    }

    fn check_lead(&self) -> Result<(), Error> {
        let notice_s = self.age_s[1] + self.period_s + self.notice_s;
        let free = 1.0 - REACH;
        if self.speed_mm_s * notice_s <= free * self.lead_mm {
            return Ok(());
        }
        Err(Error::LeadTooShort {
            lead_mm: self.lead_mm,
            speed_mm_s: self.speed_mm_s,
            notice_s,
            lead_that_works_mm: self.speed_mm_s * notice_s / free,
            speed_that_works_mm_s: free * self.lead_mm / notice_s,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The limits in the error message are tight: they pass, and slightly tighter values fail.
    #[test]
    fn a_lead_that_is_too_short_is_told_what_would_work() {
        for speed in [150.0, 400.0, 2000.0] {
            let settings = Settings::usual(20.0, speed);
            let Err(Error::LeadTooShort { lead_that_works_mm: lead, speed_that_works_mm_s: slower, .. }) =
                settings.check()
            else {
                panic!("{speed}: {:?}", settings.check())
            };
            for k in [1.001, 0.999] {
                assert_eq!(Settings { lead_mm: lead * k, ..settings }.check().is_ok(), k > 1.0);
                assert_eq!(Settings { speed_mm_s: slower / k, ..settings }.check().is_ok(), k > 1.0);
            }
        }
        assert_eq!(Settings::usual(20.0, 100.0).check(), Ok(()));
    }

    #[test]
    fn values_that_cannot_be_are_named() {
        let good = Settings::usual(20.0, 20.0);
        let cases: [(&str, Settings); 6] = [
            ("lead_mm", Settings { lead_mm: f64::NAN, ..good }),
            ("noise_mm", Settings { noise_mm: 0.0, ..good }),
            ("field_mm", Settings { field_mm: DVec2::new(5.0, -1.0), ..good }),
            ("age_s", Settings { age_s: [0.03, 0.02], ..good }),
            ("tack_mm", Settings { tack_mm: -1.0, ..good }),
            ("least_confidence", Settings { least_confidence: 1.5, ..good }),
        ];
        for (name, settings) in cases {
            assert!(matches!(settings.check(), Err(Error::Value { key, .. }) if key == name), "{name}");
        }
    }
}
