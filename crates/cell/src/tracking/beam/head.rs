use super::super::Error;
use super::camera::POINTS;
use super::{BeamCamera, Glance, Shown};
use crate::camera_simulator::Random;
use seamwright_tracking::beam::{BeamReplay, BeamTracking, Orders, Picture, Point};
use seamwright_tracking::lead::Moment;
use std::collections::VecDeque;

/// Source of the orders.
pub enum BeamHead<'a> {
    /// The beam's own view.
    Tracking(Box<BeamTracking<'a>>),
    /// The record of an earlier pass.
    Replay(Box<BeamReplay<'a>>),
}

impl BeamHead<'_> {
    /// Runs a cycle, as [`BeamTracking::cycle`].
    pub(crate) fn cycle(&mut self, now: Moment, speed: f64, welds: bool) -> Orders {
        match self {
            Self::Tracking(head) => head.cycle(now, speed, welds),
            Self::Replay(head) => head.cycle(now, speed),
        }
    }

    /// Returns the start of the search for the joint in a frame taken at `s_mm`: distance ahead (mm), and the
    /// expected distance aside of the taught seam, if known.
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

/// Time at rest before the weld, s: the beam looks at the joint from its start on.
pub(crate) const LOOK_S: f64 = 1.5;
/// Distance before the end of the seam in which an unseen joint ahead raises no alarm, mm.
pub(crate) const END_MM: f64 = 1.0;
/// Spacing of the record's rows, mm.
pub(crate) const STEP_MM: f64 = 0.1;
/// Maximum variation of the pictures' latency, s.
const LATE_S: f64 = 0.01;

/// Pictures in transit from the camera. Memory is allocated once.
pub(crate) struct UnderWay {
    pictures: VecDeque<(f64, f64, Shown)>,
    /// The last picture that arrived, and its exposure time.
    now: Option<(f64, Shown)>,
    /// Buffers for further pictures.
    free: Vec<Shown>,
    random: Random,
    latency_s: f64,
}

/// Maximum number of pictures in transit.
const PICTURES: usize = 8;

impl UnderWay {
    /// Creates an empty queue; pictures are `latency_s` late, give or take 10 ms.
    pub(crate) fn new(latency_s: f64, seed: u64) -> Self {
        let empty = || Shown { points: Vec::with_capacity(POINTS), height_mm: 0.0 };
        let free = std::iter::repeat_with(empty).take(PICTURES).collect();
        let pictures = VecDeque::with_capacity(PICTURES);
        Self { pictures, now: None, free, random: Random::new(seed ^ 0xbea3), latency_s }
    }

    /// Returns the maximum age of a picture at its arrival, s.
    pub(crate) fn oldest_s(latency_s: f64) -> f64 {
        latency_s + 1.5 * LATE_S
    }

    /// Takes a frame; it is lost if there is no room.
    pub(crate) fn look(&mut self, camera: &mut dyn BeamCamera, glance: &Glance<'_>) -> Result<(), Error> {
        let Some(mut shown) = self.free.pop() else { return Ok(()) };
        (shown.height_mm, shown.points) = (0.0, cleared(shown.points));
        camera.glance(glance, &mut shown)?;
        let late = self.latency_s + self.random.within(-LATE_S, LATE_S);
        self.pictures.push_back((glance.t_s + late.max(0.0), glance.t_s, shown));
        Ok(())
    }

    /// Takes in the next picture that has arrived by `t` and drops the one before; false without one.
    pub(crate) fn arrive(&mut self, t: f64) -> bool {
        self.free.extend(self.now.take().map(|(_, shown)| shown));
        if self.pictures.front().is_some_and(|(due, ..)| *due <= t) {
            self.now = self.pictures.pop_front().map(|(_, exposed_s, shown)| (exposed_s, shown));
        }
        self.now.is_some()
    }

    /// Returns the picture taken in last.
    pub(crate) fn picture(&self) -> Option<Picture<'_>> {
        let (exposed_s, shown) = self.now.as_ref()?;
        Some(Picture { exposed_s: *exposed_s, height_mm: shown.height_mm, points: &shown.points })
    }

    /// Delivers the pictures that have arrived by `t`.
    pub(crate) fn deliver(&mut self, head: &mut BeamHead<'_>, t: f64) {
        while self.arrive(t) {
            let Some(picture) = self.picture() else { return };
            match head {
                BeamHead::Tracking(head) => drop(head.take(&picture, t)),
                BeamHead::Replay(head) => head.take(&picture, t),
            }
        }
    }
}

fn cleared(mut points: Vec<Point>) -> Vec<Point> {
    points.clear();
    points
}
