use super::camera::{BeamCamera, Glance, POINTS, Shown};
use crate::camera_simulator::Random;
use crate::error::Error;
use seamwright_executive::tracking::{BeamHead, LATENCY_VARIATION_S};
use seamwright_tracking::beam::{Picture, Point};
use std::collections::VecDeque;

/// Pictures in transit from the camera. Memory is allocated once.
pub(crate) struct PictureQueue {
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

impl PictureQueue {
    /// Creates an empty queue; pictures are `latency_s` late, give or take 10 ms.
    pub(crate) fn new(latency_s: f64, seed: u64) -> Self {
        let empty = || Shown { points: Vec::with_capacity(POINTS), height_mm: 0.0 };
        let free = std::iter::repeat_with(empty).take(PICTURES).collect();
        let pictures = VecDeque::with_capacity(PICTURES);
        Self { pictures, now: None, free, random: Random::new(seed ^ 0xbea3), latency_s }
    }

    /// Takes a frame; it is lost if there is no room.
    pub(crate) fn look(&mut self, camera: &mut dyn BeamCamera, glance: &Glance<'_>) -> Result<(), Error> {
        let Some(mut shown) = self.free.pop() else { return Ok(()) };
        (shown.height_mm, shown.points) = (0.0, cleared(shown.points));
        camera.glance(glance, &mut shown)?;
        let late = self.latency_s + self.random.within(-LATENCY_VARIATION_S, LATENCY_VARIATION_S);
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

    pub(crate) fn picture(&self) -> Option<Picture<'_>> {
        let (exposed_s, shown) = self.now.as_ref()?;
        Some(Picture { exposed_s: *exposed_s, height_mm: shown.height_mm, points: &shown.points })
    }

    /// Delivers the pictures that have arrived by `t`.
    pub(crate) fn deliver(&mut self, head: &mut BeamHead<'_>, t: f64) {
        while self.arrive(t) {
            let Some(picture) = self.picture() else { return };
            head.take(&picture, t);
        }
    }
}

fn cleared(mut points: Vec<Point>) -> Vec<Point> {
    points.clear();
    points
}
