use super::beam_authority::{BeamAuthority, SOON_S};
use super::error::Error;
use super::picture::{Course, Picture, located};
use super::record::{DeviationRecord, Row};
use super::schedule::{Allowed, Beam, Schedule};
use super::tracking::{Faults, Orders, judge};
use crate::actuator::{Alarm, Following, SlideLimits};
use crate::lead::{Estimate, History, Moment, Sight};
use arrayvec::ArrayVec;
use seamwright_machine::BeamDeflection;
use seamwright_message::{Message, Unit, display_by_message};

/// Stored deviation applied to another pass over the same seam.
#[derive(Debug, Clone, PartialEq)]
pub struct Replay {
    record: DeviationRecord,
    shift_mm: f64,
    length_mm: f64,
    noise_mm: f64,
}

/// Maximum distance of a pass beyond the stored range, mm.
const BEYOND_MM: f64 = 2.0;

impl Replay {
    /// Creates a replay for a pass of `length_mm` that starts at `shift_mm` of the stored path length. A stored
    /// confidence of 1 means standard deviation `noise_mm`.
    ///
    /// # Errors
    /// [`Error::NotCovered`] unless [`Self::covers`] is true.
    pub fn new(record: DeviationRecord, shift_mm: f64, length_mm: f64, noise_mm: f64) -> Result<Self, Error> {
        if Self::covers(&record, shift_mm, length_mm) {
            return Ok(Self { record, shift_mm, length_mm, noise_mm });
        }
        let ([first_mm, last_mm], from_mm, to_mm) = (record.range(), shift_mm, shift_mm + length_mm);
        Err(Error::NotCovered { from_mm, to_mm, first_mm, last_mm })
    }

    /// Returns whether `record` covers a pass of `length_mm` that starts at `from_mm` of its path length, within 2 mm.
    #[must_use]
    pub fn covers(record: &DeviationRecord, from_mm: f64, length_mm: f64) -> bool {
        let [first_mm, last_mm] = record.range();
        from_mm >= first_mm - BEYOND_MM && from_mm + length_mm <= last_mm + BEYOND_MM
    }

    /// Returns the deviation with the torch at `s_mm` of the pass.
    #[must_use]
    pub fn at(&self, s_mm: f64) -> Estimate {
        let Row { deviation, confidence, .. } = self.record.at(s_mm + self.shift_mm);
        let sight = if confidence > 0.0 { Sight::Seen } else { Sight::Coasted };
        Estimate { value: deviation, sigma_mm: self.noise_mm / confidence, sight }
    }
}

/// Settings of a replay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReplaySettings {
    /// Allowed interruptions of the weld.
    pub allowed: Allowed,
    /// Frame period during the check, s.
    pub period_s: f64,
    /// Duration of a frame, s.
    pub scan_s: f64,
    /// Maximum age of a frame at its arrival, s.
    pub oldest_s: f64,
    /// The cell's cycle, s.
    pub cycle_s: f64,
    /// Number of frames at the start of the pass that are compared with the record; 0 if the joint is no longer
    /// visible.
    pub frames: usize,
    /// Maximum distance of nine of ten points from the record, mm.
    pub most_mm: f64,
}

impl ReplaySettings {
    /// Usual settings: three frames, 0.15 mm.
    pub const USUAL: Self = Self {
        allowed: Allowed::EBW_2004,
        period_s: 0.3,
        scan_s: 0.005,
        oldest_s: 0.06,
        cycle_s: 1e-3,
        frames: 3,
        most_mm: 0.15,
    };
}

/// Difference between the detected joint and the record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Number of compared points.
    pub points: usize,
    /// Median difference, mm: the displacement of the part.
    pub median_mm: f64,
    /// Distance from the record within which nine of ten points lie, mm.
    pub within_mm: f64,
}

/// Reason for refusing a replay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Misfit {
    /// The joint has moved.
    Moved {
        /// Number of compared points.
        points: usize,
        /// Median difference, mm.
        median_mm: f64,
        /// Distance from the record within which nine of ten points lie, mm.
        within_mm: f64,
        /// Maximum allowed distance, mm.
        most_mm: f64,
    },
    /// Too few points were detected.
    Unseen {
        /// Number of detected points.
        points: usize,
        /// Number of frames taken.
        frames: usize,
    },
}

display_by_message!(Misfit);

impl Misfit {
    /// Returns the description of the reason.
    pub fn message(&self) -> Message {
        match *self {
            Self::Moved { points, median_mm, within_mm, most_mm } => Message::new("tracking-stored-deviation-moved")
                .quantity("within", within_mm, Unit::Mm, 3)
                .count("points", points)
                .quantity("median", median_mm, Unit::Mm, 3)
                .value("max", most_mm, Unit::Mm),
            Self::Unseen { points, frames } => Message::new("tracking-stored-deviation-unseen")
                .count("points", points)
                .count("frames", frames)
                .count("min", FEWEST),
        }
    }
}

/// Minimum number of points for a judgement, and maximum number stored.
const FEWEST: usize = 12;
const MAX_POINTS: usize = 512;

/// Corrects a pass by the record of an earlier one, without a sensor except for a check at its start.
#[derive(Clone)]
pub struct BeamReplay<'a> {
    settings: ReplaySettings,
    replay: Replay,
    seam: Course<'a>,
    schedule: Schedule,
    authority: BeamAuthority,
    following: Following,
    history: History,
    differences: ArrayVec<f64, MAX_POINTS>,
    /// Start time, s.
    begun_s: Option<f64>,
    frames: usize,
    judged: Option<Result<Fit, Misfit>>,
    carried: f64,
}

impl<'a> BeamReplay<'a> {
    /// Starts `replay` on the nominal `seam` of the pass.
    ///
    /// # Errors
    /// Interruptions beyond the allowed ones, or invalid values.
    pub fn new(
        settings: ReplaySettings,
        replay: Replay,
        seam: Course<'a>,
        deflection: BeamDeflection,
        axes: SlideLimits,
    ) -> Result<Self, Error> {
        let ReplaySettings { most_mm, oldest_s, cycle_s, .. } = settings;
        for (key, value) in [("most_mm", most_mm), ("oldest_s", oldest_s), ("cycle_s", cycle_s)] {
            if !(value > 0.0 && value <= 10.0) {
                let allowed = Message::new("document-more-than-up-to");
                let allowed = allowed.value("min", 0.0, Unit::One).value("max", 10.0, Unit::One);
                return Err(crate::lead::Error::Value { key, value, allowed }.into());
            }
        }
        Ok(Self {
            schedule: Schedule::new(settings.allowed, settings.period_s, settings.scan_s)?,
            authority: BeamAuthority::new(deflection, axes, settings.cycle_s)?,
            following: Following::default(),
            history: History::new((oldest_s / cycle_s).ceil() as usize + 2),
            differences: ArrayVec::new(),
            frames: 0,
            begun_s: None,
            judged: None,
            carried: 0.0,
            settings,
            replay,
            seam,
        })
    }

    /// Returns the result of the check, once known; a misfit stops the weld.
    #[must_use]
    pub fn judged(&self) -> Option<Result<Fit, Misfit>> {
        self.judged
    }

    /// Returns the stored lateral deviation at `s_mm` of the pass, mm.
    #[must_use]
    pub fn expected(&self, s_mm: f64) -> f64 {
        self.replay.at(s_mm).value.x
    }

    /// Processes the midline of a frame that arrived at time `now_s`. A frame that is late or has an invalid time
    /// counts as empty.
    pub fn take(&mut self, picture: &Picture<'_>, now_s: f64) {
        if self.judged.is_some() {
            return;
        }
        self.frames += 1;
        let fresh = (0.0..=self.settings.oldest_s).contains(&(now_s - picture.exposed_s));
        if let Some(then) = self.history.at(picture.exposed_s).filter(|_| fresh) {
            for point in picture.points.iter().filter(|point| point.confidence > 0.0) {
                let (s, seen) = located(self.seam, &then, point, picture.height_mm);
                let difference = seen.x - self.replay.at(s).value.x;
                // Beyond the ends of the pass points are not comparable.
                let within = (0.0..=self.replay.length_mm).contains(&s);
                if within && difference.is_finite() && !self.differences.is_full() {
                    self.differences.push(difference);
                }
            }
        }
        if self.frames >= self.settings.frames {
            self.judged = Some(self.fit());
        }
    }

    fn fit(&mut self) -> Result<Fit, Misfit> {
        let (points, frames, most_mm) = (self.differences.len(), self.frames, self.settings.most_mm);
        if points < FEWEST {
            return Err(Misfit::Unseen { points, frames });
        }
        self.differences.sort_unstable_by(f64::total_cmp);
        let median_mm = self.differences[points / 2];
        self.differences.iter_mut().for_each(|d| *d = d.abs());
        self.differences.sort_unstable_by(f64::total_cmp);
        let within_mm = self.differences[(points * 9 / 10).min(points - 1)];
        if within_mm > most_mm {
            return Err(Misfit::Moved { points, median_mm, within_mm, most_mm });
        }
        Ok(Fit { points, median_mm, within_mm })
    }

    /// Runs one cycle, like [`super::BeamTracking::cycle`].
    pub fn cycle(&mut self, now: Moment, speed: f64) -> Orders {
        self.history.push(now);
        let there = now.s_mm + speed * (self.authority.lag_s() + self.settings.cycle_s);
        let estimate = self.replay.at(now.s_mm);
        let stuck = self.following.is_stuck(now.t_s, (now.slide.x - self.carried).abs());
        let to = [there, there + speed * SOON_S].map(|s| self.expected(s));
        let shares = self.authority.step(to, now.slide.x, now.t_s);
        self.carried = shares.carried;
        let (feed_override, alarm) = match self.judged {
            Some(Err(_)) => (0.0, Some(Alarm::Misfit)),
            _ => judge(&shares, &estimate, Faults { stuck, ..Faults::default() }),
        };
        let looks = self.judged.is_none() && self.settings.frames > 0;
        let beam = if looks { self.schedule.at(now.t_s, true) } else { Beam::Weld };
        // A silent camera counts as one that sees no joint.
        let since = *self.begun_s.get_or_insert(now.t_s);
        let every = (self.settings.frames + 1) as f64 * self.settings.period_s + self.settings.oldest_s;
        if looks && now.t_s - since > every {
            self.judged = Some(self.fit());
        }
        let (deflection_mm, carried_mm) = (shares.deflection, shares.carried);
        Orders { beam, deflection_mm, carried_mm, feed_override, alarm, estimate }
    }
}
