use seamwright_machine::Stepper;

/// Criterion that determined the microstepping.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bound {
    /// The resolution: it is met with the minimum number of microsteps.
    Resolution,
    /// The pulse frequency: the maximum number of microsteps within it does not meet the resolution.
    Frequency,
    /// The driver: its finest setting does not meet the resolution.
    Driver,
    /// No valid setting: even the coarsest one exceeds the pulse frequency.
    None,
}

/// The chosen microstepping of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Microstepping {
    /// Pulses of a full step.
    pub microsteps: u32,
    /// Pulses per mm or rad.
    pub steps_per_unit: f64,
    /// Pulse equivalent: travel per pulse, mm or rad.
    pub resolution: f64,
    /// Criterion that determined it.
    pub bound: Bound,
}

/// Fraction of the maximum frequency reserved for the rounding of positions.
const RESERVE: f64 = 1e-6;

impl Microstepping {
    /// Chooses the smallest setting of the driver that meets the requested resolution, if the axis at `speed` (mm/s or
    /// rad/s) then stays within `max_hz` pulses a second; otherwise the largest within `max_hz`.
    pub fn choose(stepper: &Stepper, speed: f64, max_hz: f64) -> Self {
        let full = stepper.full_steps_per_unit();
        let fits = |m: u32| speed * full * f64::from(m) <= max_hz * (1.0 - RESERVE);
        let settings = || stepper.microsteps.iter().copied();
        let (microsteps, bound) = match (stepper.least_microsteps(), settings().rfind(|m| fits(*m))) {
            (Some(enough), Some(most)) if enough <= most => (enough, Bound::Resolution),
            (None, Some(most)) if settings().next_back() == Some(most) => (most, Bound::Driver),
            (_, Some(most)) => (most, Bound::Frequency),
            (_, None) => (settings().next().unwrap_or(1), Bound::None),
        };
        let steps_per_unit = full * f64::from(microsteps);
        Self { microsteps, steps_per_unit, resolution: 1.0 / steps_per_unit, bound }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 200 steps and 10 mm a turn: 0.05 mm a full step.
    fn screw(resolution: f64, microsteps: &[u32]) -> Stepper {
        Stepper {
            full_steps_per_turn: 200,
            per_turn: 10.0,
            microsteps: microsteps.to_vec(),
            resolution,
            max_pulse_hz: 200e3,
            min_pulse_s: 2.5e-6,
            direction_setup_s: 5e-6,
            direction_hold_s: 5e-6,
            motor: None,
        }
    }

    #[test]
    fn smallest_that_meets_the_resolution() {
        let all = [1, 2, 4, 8, 16, 32, 64, 128, 256];
        for (resolution, expected) in [(0.1, 1), (0.05, 1), (0.049, 2), (0.005, 16), (0.003125, 16), (0.0002, 256)] {
            let m = Microstepping::choose(&screw(resolution, &all), 10.0, 200e3);
            assert_eq!((m.microsteps, m.bound), (expected, Bound::Resolution), "{resolution}");
            assert!((m.resolution * m.steps_per_unit - 1.0).abs() < 1e-15 && m.resolution <= resolution);
        }
    }

    #[test]
    fn greatest_that_the_frequency_or_the_driver_allows() {
        let all = [1, 2, 4, 8, 16, 32, 64, 128, 256];
        let at = |speed, max_hz, settings: &[u32]| Microstepping::choose(&screw(0.0005, settings), speed, max_hz);
        // 100 full steps of resolution wanted: 128. 2,000 full steps a second at 100 mm/s.
        let m = at(100.0, 200e3, &all);
        assert_eq!((m.microsteps, m.bound), (64, Bound::Frequency));
        assert_eq!((at(10.0, 200e3, &all).microsteps, at(10.0, 200e3, &all).bound), (128, Bound::Resolution));
        assert_eq!((at(10.0, 200e3, &[1, 10]).microsteps, at(10.0, 200e3, &[1, 10]).bound), (10, Bound::Driver));
        assert_eq!((at(100.0, 1999.0, &all).microsteps, at(100.0, 1999.0, &all).bound), (1, Bound::None));
        assert_eq!(at(100.0, 2001.0, &all).bound, Bound::Frequency);
        // At rest every setting is slow enough.
        assert_eq!(at(0.0, 200e3, &all).bound, Bound::Resolution);
    }
}
