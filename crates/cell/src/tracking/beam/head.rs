use super::super::Error;
use super::{BeamEye, Glance, Shown};
use crate::eyes::Random;
use seamwright_tracking::beam::{BeamReplay, BeamTracking, Orders, Picture};
use seamwright_tracking::lead::Moment;
use std::collections::VecDeque;

/// What gives the orders.
pub enum BeamHead<'a> {
    /// What the beam sees.
    Tracking(Box<BeamTracking<'a>>),
    /// What an earlier pass has found.
    Replay(Box<BeamReplay<'a>>),
}

impl BeamHead<'_> {
    /// A cycle, as that of [`BeamTracking::cycle`].
    pub(crate) fn cycle(&mut self, now: Moment, speed: f64, welds: bool) -> Orders {
        match self {
            Self::Tracking(head) => head.cycle(now, speed, welds),
            Self::Replay(head) => head.cycle(now, speed),
        }
    }

    /// Where the joint is looked for in a frame that is taken at `s_mm`: how far ahead (mm), and how far aside of the taught
    /// seam it should be there, if that is known.
    pub(crate) fn looks_for(&self, s_mm: f64, speed: f64) -> (f64, Option<f64>) {
        match self {
            Self::Tracking(head) => {
                let from = head.zone().from_mm.max(-speed);
                (from, head.expected(s_mm + from))
            }
            Self::Replay(head) => (0.0, Some(head.expected(s_mm))),
        }
    }
}

/// Time at rest before the weld, s: the joint is looked at from its start on.
pub(crate) const LOOK_S: f64 = 1.5;
/// Way before the end of the seam in which nothing is said of what is not seen ahead, mm.
pub(crate) const END_MM: f64 = 1.0;
/// A row of the record every so often, mm.
pub(crate) const STEP_MM: f64 = 0.1;
/// By how much pictures are there sooner or later than usual, at most, s.
const LATE_S: f64 = 0.01;

/// Pictures on their way from the eye.
pub(crate) struct UnderWay {
    pictures: VecDeque<(f64, f64, Shown)>,
    random: Random,
    latency_s: f64,
}

impl UnderWay {
    /// None yet; they are `latency_s` late, give or take 10 ms.
    pub(crate) fn new(latency_s: f64, seed: u64) -> Self {
        Self { pictures: VecDeque::new(), random: Random::new(seed ^ 0xbea3), latency_s }
    }

    /// The oldest that a picture can be when it arrives, s.
    pub(crate) fn oldest_s(latency_s: f64) -> f64 {
        latency_s + 1.5 * LATE_S
    }

    /// A frame is taken.
    pub(crate) fn look(&mut self, eye: &mut dyn BeamEye, glance: &Glance<'_>) -> Result<(), Error> {
        let shown = eye.glance(glance)?;
        let late = self.latency_s + self.random.within(-LATE_S, LATE_S);
        self.pictures.push_back((glance.t_s + late.max(0.0), glance.t_s, shown));
        Ok(())
    }

    /// What has arrived by `t`.
    pub(crate) fn deliver(&mut self, head: &mut BeamHead<'_>, t: f64) {
        while self.pictures.front().is_some_and(|(due, ..)| *due <= t) {
            let Some((_, exposed_s, shown)) = self.pictures.pop_front() else { return };
            let picture = Picture { exposed_s, height_mm: shown.height_mm, points: &shown.points };
            match head {
                BeamHead::Tracking(head) => {
                    head.take(&picture, t);
                }
                BeamHead::Replay(head) => head.take(&picture, t),
            }
        }
    }
}
