use super::beam_authority::{BeamAuthority, SOON_S};
use super::picture::{Course, located};
use super::tracking::judge;
use super::{Allowed, Beam, DeviationRecord, Error, Orders, Picture, Row, Schedule};
use crate::actuator::{Alarm, DeflectionLimits, Following, SlideLimits};
use crate::lead::{Estimate, History, Moment, Sight};
use arrayvec::ArrayVec;

/// A stored deviation on another pass over the same seam.
#[derive(Debug, Clone, PartialEq)]
pub struct Replay {
    record: DeviationRecord,
    shift_mm: f64,
    length_mm: f64,
    noise_mm: f64,
}

/// A pass may go beyond what is stored by so much, mm.
const BEYOND_MM: f64 = 2.0;

impl Replay {
    /// For a pass of `length_mm` that begins at `shift_mm` of the stored path length; a stored confidence of 1 means a
    /// standard deviation of `noise_mm`.
    ///
    /// # Errors
    /// [`Error::NotCovered`] if the pass goes beyond what is stored.
    pub fn new(record: DeviationRecord, shift_mm: f64, length_mm: f64, noise_mm: f64) -> Result<Self, Error> {
        if Self::covers(&record, shift_mm, length_mm) {
            return Ok(Self { record, shift_mm, length_mm, noise_mm });
        }
        let ([first_mm, last_mm], from_mm, to_mm) = (record.range(), shift_mm, shift_mm + length_mm);
        Err(Error::NotCovered { from_mm, to_mm, first_mm, last_mm })
    }

    /// True if `record` is of all of a pass of `length_mm` that begins at `from_mm` of its path length, but for 2 mm.
    #[must_use]
    pub fn covers(record: &DeviationRecord, from_mm: f64, length_mm: f64) -> bool {
        let [first_mm, last_mm] = record.range();
        from_mm >= first_mm - BEYOND_MM && from_mm + length_mm <= last_mm + BEYOND_MM
    }

    /// The deviation with the torch at `s_mm` of the pass.
    #[must_use]
    pub fn at(&self, s_mm: f64) -> Estimate {
        let Row { deviation, confidence, .. } = self.record.at(s_mm + self.shift_mm);
        let sight = if confidence > 0.0 { Sight::Seen } else { Sight::Coasted };
        Estimate { value: deviation, sigma_mm: self.noise_mm / confidence, sight }
    }
}

/// How a replay is done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReplaySettings {
    /// Interruptions that the weld bears.
    pub allowed: Allowed,
    /// From frame to frame while it is checked, s.
    pub period_s: f64,
    /// Time that a frame takes, s.
    pub scan_s: f64,
    /// Oldest age of a frame when it arrives, s.
    pub oldest_s: f64,
    /// The cell's cycle, s.
    pub cycle_s: f64,
    /// Frames at the start of the pass that are compared with what is stored; 0: none, where there is no joint left to see.
    pub frames: usize,
    /// What nine of ten points may lie beside what is stored, mm.
    pub most_mm: f64,
}

impl ReplaySettings {
    /// Three frames, 0.15 mm.
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

/// How what is seen lies beside what is stored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// Points that were compared.
    pub points: usize,
    /// Half of them lie to either side of this, mm: by so much the part has moved.
    pub median_mm: f64,
    /// Nine of ten lie within this distance, mm.
    pub within_mm: f64,
}

/// Why a replay is refused.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Misfit {
    /// The joint lies elsewhere.
    #[error(
        "the stored deviation does not fit: {within_mm:.3} mm off in nine of ten of {points} points ({median_mm:+.3} mm in the \
         median), allowed is {most_mm} mm; track this pass instead"
    )]
    Moved {
        /// Points that were compared.
        points: usize,
        /// Half of them lie to either side of this, mm.
        median_mm: f64,
        /// Nine of ten lie within this, mm.
        within_mm: f64,
        /// What is allowed, mm.
        most_mm: f64,
    },
    /// There was too little to see.
    #[error(
        "the stored deviation could not be checked: {points} points in {frames} frames, allowed are {FEWEST} or more; check no \
         frames where there is no joint left to see"
    )]
    Unseen {
        /// Points that were seen.
        points: usize,
        /// Frames that were taken.
        frames: usize,
    },
}

/// Fewest points that a judgement is made from, and most that are kept.
const FEWEST: usize = 12;
const MOST: usize = 512;

/// A pass that is corrected by what an earlier one found, without a sensor but for a check at its start.
#[derive(Clone)]
pub struct BeamReplay<'a> {
    settings: ReplaySettings,
    replay: Replay,
    seam: Course<'a>,
    schedule: Schedule,
    authority: BeamAuthority,
    following: Following,
    history: History,
    differences: ArrayVec<f64, MOST>,
    /// When it was begun, s.
    begun_s: Option<f64>,
    frames: usize,
    judged: Option<Result<Fit, Misfit>>,
    carried: f64,
}

impl<'a> BeamReplay<'a> {
    /// Of `replay` on the nominal `seam` of the pass.
    ///
    /// # Errors
    /// Interruptions that are not allowed, values that cannot be.
    pub fn new(
        settings: ReplaySettings,
        replay: Replay,
        seam: Course<'a>,
        deflection: DeflectionLimits,
        axes: SlideLimits,
    ) -> Result<Self, Error> {
        let ReplaySettings { most_mm, oldest_s, cycle_s, .. } = settings;
        for (key, value) in [("most_mm", most_mm), ("oldest_s", oldest_s), ("cycle_s", cycle_s)] {
            if !(value > 0.0 && value <= 10.0) {
                return Err(crate::lead::Error::Value { key, value, allowed: "more than 0, at most 10" }.into());
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

    /// How it fits, once it is known: what is refused here stops the weld.
    #[must_use]
    pub fn judged(&self) -> Option<Result<Fit, Misfit>> {
        self.judged
    }

    /// How far aside the seam is stored to be at `s_mm` of the pass, mm.
    #[must_use]
    pub fn expected(&self, s_mm: f64) -> f64 {
        self.replay.at(s_mm).value.x
    }

    /// What was found in a frame has arrived at time `now_s`; too late or without a time that can be, it counts as one in
    /// which nothing was seen.
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
                // Beyond its ends the pass says nothing of the seam.
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

    /// A cycle, as that of [`super::BeamTracking`].
    pub fn cycle(&mut self, now: Moment, speed: f64) -> Orders {
        self.history.push(now);
        let there = now.s_mm + speed * (self.authority.lag_s() + self.settings.cycle_s);
        let estimate = self.replay.at(now.s_mm);
        let stuck = self.following.is_stuck(now.t_s, (now.slide.x - self.carried).abs());
        let to = [there, there + speed * SOON_S].map(|s| self.expected(s));
        let shares = self.authority.step(to, now.slide.x, now.t_s);
        self.carried = shares.carried;
        let (pace, alarm) = match self.judged {
            Some(Err(_)) => (0.0, Some(Alarm::Misfit)),
            _ => judge(stuck, &shares, &estimate, (false, false)),
        };
        let looks = self.judged.is_none() && self.settings.frames > 0;
        let beam = if looks { self.schedule.at(now.t_s, true) } else { Beam::Weld };
        // A camera that sends nothing shows nothing.
        let since = *self.begun_s.get_or_insert(now.t_s);
        let every = (self.settings.frames + 1) as f64 * self.settings.period_s + self.settings.oldest_s;
        if looks && now.t_s - since > every {
            self.judged = Some(self.fit());
        }
        let (deflection_mm, carried_mm) = (shares.deflection, shares.carried);
        Orders { beam, deflection_mm, carried_mm, pace, alarm, estimate }
    }
}
