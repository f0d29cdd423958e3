use super::error::Error;
use crate::lead;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// Allowed interruptions of a weld.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowed {
    /// Minimum time between the starts of two interruptions, s.
    pub every_s: f64,
    /// Maximum duration, s.
    pub longest_s: f64,
}

impl Allowed {
    /// As in EBW-2004: 5 ms every 300 ms.
    pub const EBW_2004: Self = Self { every_s: 0.3, longest_s: 0.005 };
}

/// Action of the beam in a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Beam {
    /// Weld.
    Weld,
    /// Scan the work, focused and at low power.
    Scan,
    /// Weld again; the frame is complete, with this mean exposure time, s.
    Seen(f64),
}

/// Decides by time when the beam scans.
///
/// Late cycles lengthen the time between frames and never shorten it. A clock that goes back delays the next frame by a
/// whole period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Schedule {
    period_s: f64,
    scan_s: f64,
    /// Start time of the last frame, s, and whether it is still being taken.
    begun_s: Option<f64>,
    scans: bool,
}

/// Rounding tolerance of cycle times, which are sums, s.
const ROUNDING_S: f64 = 1e-9;

impl Schedule {
    /// Creates a schedule with a frame of `scan_s` every `period_s`.
    ///
    /// # Errors
    /// More or longer interruptions than allowed; invalid times.
    pub fn new(allowed: Allowed, period_s: f64, scan_s: f64) -> Result<Self, Error> {
        let Allowed { every_s, longest_s } = allowed;
        for (key, value) in [("every_s", every_s), ("longest_s", longest_s), ("period_s", period_s), ("scan_s", scan_s)]
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(lead::Error::not_positive(key, value).into());
            }
        }
        if period_s < every_s {
            return Err(Error::TooOften { period_s, every_s });
        }
        if scan_s > longest_s {
            return Err(Error::TooLong { scan_s, longest_s });
        }
        if scan_s >= period_s {
            let allowed = Message::new("tracking-scan-allowed");
            return Err(lead::Error::Value { key: "scan_s", value: scan_s, allowed }.into());
        }
        Ok(Self { period_s, scan_s, begun_s: None, scans: false })
    }

    /// Returns the beam's action in the cycle that starts at `t_s`; a new frame starts only if frames are `wanted`.
    pub fn at(&mut self, t_s: f64, wanted: bool) -> Beam {
        let since = self.begun_s.map_or(f64::INFINITY, |begun| t_s - begun);
        if since < 0.0 {
            (self.begun_s, self.scans) = (Some(t_s), false);
            return Beam::Weld;
        }
        if self.scans {
            if since + ROUNDING_S < self.scan_s {
                return Beam::Scan;
            }
            self.scans = false;
            return Beam::Seen(t_s - since + 0.5 * self.scan_s);
        }
        if wanted && since + ROUNDING_S >= self.period_s {
            (self.begun_s, self.scans) = (Some(t_s), true);
            return Beam::Scan;
        }
        Beam::Weld
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    #[test]
    fn what_is_not_allowed_is_refused() {
        let new = |period, scan| Schedule::new(Allowed::EBW_2004, period, scan);
        assert!(new(0.3, 0.005).is_ok());
        assert_eq!(new(0.299, 0.005), Err(Error::TooOften { period_s: 0.299, every_s: 0.3 }));
        assert_eq!(new(0.3, 0.0051), Err(Error::TooLong { scan_s: 0.0051, longest_s: 0.005 }));
        for (period, scan) in [(f64::NAN, 0.005), (0.3, 0.0), (0.3, -1.0), (f64::INFINITY, 0.005)] {
            assert!(matches!(new(period, scan), Err(Error::Value(_))), "{period} {scan}");
        }
        assert!(matches!(
            Schedule::new(Allowed { every_s: 0.1, longest_s: 1.0 }, 0.3, 0.3),
            Err(Error::Value(lead::Error::Value { key: "scan_s", .. }))
        ));
    }

    /// Holds for any cycle times and requests for frames. Starts are a period apart, a scan ends with the first cycle
    /// after its time, and the exposure time is its middle.
    #[test]
    fn never_more_often_nor_longer() {
        let mut random = Random::new(3);
        for case in 0..200 {
            let mut schedule = Schedule::new(Allowed::EBW_2004, 0.3, 0.005).unwrap();
            let even = case % 2 == 0;
            let (mut t, mut begins, mut scanning, mut frames) = (0.0f64, Vec::new(), false, 0);
            for _ in 0..5000 {
                let late = if even || !random.one_in(50) { 1.0 } else { random.below(400) as f64 };
                t += 1e-3 * late;
                let wanted = even || random.chance(0.3);
                match schedule.at(t, wanted) {
                    Beam::Scan if !scanning => {
                        assert!(wanted);
                        begins.push(t);
                        scanning = true;
                    }
                    Beam::Scan => assert!(t - begins.last().unwrap() < 0.005),
                    Beam::Seen(exposed) => {
                        let begun = begins.last().unwrap();
                        assert!(scanning && (exposed - begun - 0.0025).abs() < 1e-12 && t - begun > 0.005 - 1e-6);
                        (scanning, frames) = (false, frames + 1);
                    }
                    Beam::Weld => assert!(!scanning),
                }
            }
            assert!(begins.windows(2).all(|w| w[1] - w[0] >= 0.3 - 1e-6));
            // With even cycles frames reach the full rate.
            assert!(!even || begins.len() == 17 && frames >= 16, "{} {frames}", begins.len());
        }
    }

    #[test]
    fn a_clock_that_goes_back_costs_a_period() {
        let mut schedule = Schedule::new(Allowed::EBW_2004, 0.3, 0.005).unwrap();
        assert_eq!(schedule.at(10.0, true), Beam::Scan);
        assert_eq!(schedule.at(9.0, true), Beam::Weld);
        assert_eq!(schedule.at(9.299, true), Beam::Weld);
        assert_eq!(schedule.at(9.301, true), Beam::Scan);
    }
}
