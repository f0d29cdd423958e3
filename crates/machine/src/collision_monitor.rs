//! Collision monitor: proofs of the clearance of a short motion, cheap enough for every period of a control.

use crate::chain::{Joints, MAX_AXES};
use crate::lever::{Lever, travel};
use crate::surroundings::{Course, Surroundings};
use arrayvec::ArrayVec;
use glam::DAffine3;
use seamwright_clearance::Memory;

/// Cut-off of distances above the required one, mm: a proof from a larger distance holds longer.
const SEEN_MM: f64 = 500.0;

/// Proves for successive short motions that every watch of [`Surroundings`] holds along them.
///
/// A distance at some axis positions bounds the distances in their neighbourhood: points move at most by the axes'
/// deviations times their levers. So most motions are proven without a distance computation. Otherwise distances are
/// computed at the middle of the motion, and then along it.
#[derive(Debug)]
pub struct CollisionMonitor<'a> {
    surroundings: &'a Surroundings<'a>,
    watches: Vec<Watched>,
    frames: Vec<DAffine3>,
}

#[derive(Debug)]
struct Watched {
    least_mm: f64,
    groups: (usize, usize),
    memory: Memory,
    /// Axis positions of its last evaluation, and the distance there.
    at: Joints,
    distance: f64,
    /// Levers of the axes between the groups, in order from the first: the maximum displacement of the group's points
    /// per unit of each axis. That of a rotary axis grows with the displacement by the axes before it.
    levers: ArrayVec<Lever, MAX_AXES>,
}

impl<'a> CollisionMonitor<'a> {
    /// A collision monitor without any known distance; `at` are any positions of the axes. Allocates all its memory
    /// here.
    pub fn new(surroundings: &'a Surroundings<'a>, at: &Joints) -> Self {
        let scene = surroundings.scene();
        let mut frames = vec![DAffine3::IDENTITY; scene.groups().len()];
        surroundings.frames_into(at, &mut frames);
        let watched = scene.watches().iter().enumerate().map(|(watch, w)| {
            let mut memory = Memory::default();
            let _ = scene.evaluate_near(watch, &frames, f64::INFINITY, &mut memory);
            let (at, levers) = (*at, ArrayVec::new());
            Watched { least_mm: w.least_mm(), groups: w.groups(), memory, at, distance: f64::NEG_INFINITY, levers }
        });
        let watches = watched.collect();
        Self { surroundings, watches, frames }
    }

    /// Proves that every watch holds everywhere on `course`, whose positions are all within `low..=high`.
    ///
    /// Guarantee: `Ok` only if all distances (or margins) on the course meet the minimum of their watch. At most
    /// `looks` distances are computed for each watch, after those at the middle and both ends. No allocation, except on
    /// meshes.
    ///
    /// # Errors
    /// The index of the first watch that is violated, or unproven with this number of distances.
    pub fn prove(&mut self, course: &impl Course, low: &Joints, high: &Joints, looks: u32) -> Result<(), usize> {
        for watch in 0..self.watches.len() {
            if self.near_enough(watch, low, high) {
                continue;
            }
            let middle: Joints = std::array::from_fn(|i| 0.5 * (low[i] + high[i]));
            self.look_from(watch, &middle);
            if !self.near_enough(watch, low, high) {
                let (from, to) = course.range();
                let ends = (self.look(watch, course, from), self.look(watch, course, to));
                let mut left = looks;
                if !self.between(watch, course, (from, ends.0), (to, ends.1), &mut left) {
                    return Err(watch);
                }
            }
        }
        Ok(())
    }

    /// True if every watch holds at positions `q`. No allocation, except on meshes.
    pub fn holds_at(&mut self, q: &Joints) -> bool {
        (0..self.watches.len()).all(|watch| {
            self.near_enough(watch, q, q) || {
                self.look_from(watch, q);
                self.near_enough(watch, q, q)
            }
        })
    }

    /// True if the last distance proves the watch within `low..=high`.
    fn near_enough(&self, watch: usize, low: &Joints, high: &Joints) -> bool {
        let w = &self.watches[watch];
        let moved = travel(&w.levers, |i| (low[i] - w.at[i]).abs().max((high[i] - w.at[i]).abs()));
        w.distance - moved >= w.least_mm
    }

    /// Computes the distance at `q` and the levers for its neighbourhood.
    fn look_from(&mut self, watch: usize, q: &Joints) {
        let distance = self.distance(watch, q);
        let w = &mut self.watches[watch];
        (w.at, w.distance) = (*q, distance);
        let (a, b) = w.groups;
        w.levers = self.surroundings.levers(a, b, q);
    }

    fn look(&mut self, watch: usize, course: &impl Course, s: f64) -> f64 {
        self.distance(watch, &course.at(s))
    }

    fn distance(&mut self, watch: usize, q: &Joints) -> f64 {
        self.surroundings.frames_into(q, &mut self.frames);
        let w = &mut self.watches[watch];
        let limit = w.least_mm + SEEN_MM;
        self.surroundings.scene().evaluate_near(watch, &self.frames, limit, &mut w.memory).distance
    }

    /// True if the watch is proven between two samples `(s, distance)`: all distances between them are at least half
    /// their sum less half the possible displacement.
    fn between(&mut self, watch: usize, c: &impl Course, u: (f64, f64), v: (f64, f64), left: &mut u32) -> bool {
        let (least, (a, b)) = (self.watches[watch].least_mm, self.watches[watch].groups);
        if !(u.1 >= least && v.1 >= least) {
            return false;
        }
        let rates = c.greatest_rates(u.0, v.0);
        let levers = self.surroundings.levers(a, b, &c.at(u.0));
        let moved = travel(&levers, |i| rates[i] * (v.0 - u.0));
        if 0.5 * (u.1 + v.1 - moved) >= least {
            return true;
        }
        let middle = 0.5 * (u.0 + v.0);
        if *left == 0 || middle <= u.0 || middle >= v.0 {
            return false;
        }
        *left -= 1;
        let there = (middle, self.look(watch, c, middle));
        self.between(watch, c, u, there, left) && self.between(watch, c, there, v, left)
    }
}
