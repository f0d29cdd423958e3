use crate::joint_path::JointPoint;
use crate::pass_motion::PassMotion;
use crate::speed_profile::ProfilePoint;
use seamwright_machine::Joints;

/// Phase of the process at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Only gas flows.
    Preflow,
    /// The arc is on and the torch rests before it travels.
    TravelDelay,
    /// The torch travels with the arc on.
    Travel,
    /// The torch rests at the end with the arc on.
    Crater,
    /// The arc is off, gas still flows.
    Postflow,
    /// Transfer move: arc and gas are off, the torch moves from one weld to the next.
    Transfer,
}

impl Phase {
    /// True if arc or beam is on.
    pub fn arc(self) -> bool {
        matches!(self, Self::TravelDelay | Self::Travel | Self::Crater)
    }
}

/// Set positions of the axes at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SetPoint {
    /// Time from the first set-point, s.
    pub t: f64,
    /// Phase of the process.
    pub phase: Phase,
    /// Path length, speed and acceleration along the path.
    pub profile: ProfilePoint,
    /// Positions, mm or rad.
    pub q: Joints,
}

/// The set-points of a pass, one per period: computed on demand, so that memory is independent of the motion's length.
/// The tip's speed by set-points is the profile's: positions are those of the exact path at the profile's `s(t)`.
#[derive(Debug, Clone)]
pub struct SetPoints<'a> {
    motion: &'a PassMotion,
    period: f64,
    next: u64,
    count: u64,
    cursor: usize,
}

impl<'a> SetPoints<'a> {
    fn new(motion: &'a PassMotion, period: f64) -> Self {
        // The last set-point is the first at or after the end (less a rounding).
        let count = ((motion.total_s() / period - 1e-9).ceil().max(0.0) as u64).saturating_add(1);
        Self { motion, period, next: 0, count, cursor: 0 }
    }

    /// Profile point and phase at time `t` from the first set-point.
    fn instant(&mut self, t: f64) -> (Phase, ProfilePoint) {
        let m = self.motion;
        let travel = t - m.before_s();
        let profile = m.profile.at(travel, &mut self.cursor);
        let after = travel - m.profile.duration();
        let phase = if t < m.sequence.preflow_s.get() {
            Phase::Preflow
        } else if travel < 0.0 {
            if m.arc { Phase::TravelDelay } else { Phase::Preflow }
        } else if after < 0.0 {
            if m.arc { Phase::Travel } else { Phase::Transfer }
        } else if after < m.sequence.crater_s.get() {
            Phase::Crater
        } else {
            Phase::Postflow
        };
        if travel < 0.0 { (phase, ProfilePoint::default()) } else { (phase, profile) }
    }
}

impl PassMotion {
    /// Returns the set-points every `period` s, from the first gas to the last. The iterator does not allocate.
    ///
    /// For speeds and accelerations of the axes see [`SetPoint::rates`].
    pub fn set_points(&self, period: f64) -> SetPoints<'_> {
        SetPoints::new(self, period)
    }
}

impl Iterator for SetPoints<'_> {
    type Item = SetPoint;

    fn next(&mut self) -> Option<SetPoint> {
        if self.next >= self.count {
            return None;
        }
        let t = self.next as f64 * self.period;
        self.next += 1;
        let (phase, profile) = self.instant(t);
        Some(SetPoint { t, phase, profile, q: self.motion.path.at(profile.s) })
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = usize::try_from(self.count - self.next).unwrap_or(usize::MAX);
        (left, Some(left))
    }
}

impl SetPoint {
    /// Speeds and accelerations of the axes, mm or rad per s and s^2.
    pub fn rates(&self, motion: &PassMotion) -> (Joints, Joints) {
        let JointPoint { d1, d2, .. } = motion.path.point(self.profile.s, false);
        let (v, a) = (self.profile.v, self.profile.a);
        (std::array::from_fn(|i| d1[i] * v), std::array::from_fn(|i| d2[i] * v * v + d1[i] * a))
    }
}
