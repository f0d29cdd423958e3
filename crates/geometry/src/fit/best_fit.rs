//! Best fit of a nominal part to touched points.
//!
//! The signed distances of the points from their surfaces are brought to their nominal values. The method is
//! Gauss-Newton with damping (Levenberg, 1944; Marquardt, 1963): translation first, then rotation. If the first fit is
//! poor, further starts follow. Singular values of the Jacobian show the motions that the points do not determine;
//! these are excluded from every step and keep their start values.

use super::free_motion::Motion;
use super::twist::{Deviation, Seen, Twists};
use crate::error::Error;
use crate::signed_distance::SignedDistance;
use glam::{DAffine3, DVec3};

/// A touched point.
#[derive(Clone, Copy)]
pub struct Touch<'a> {
    /// Position in the measuring frame, mm.
    pub point: DVec3,
    /// The nominal surface that was touched, in the part's frame.
    pub surface: &'a dyn SignedDistance,
    /// Nominal distance of the point outside the surface, mm: the radius of the probe's ball, or 0.
    pub outside: f64,
}

/// Least-squares fit of a part to touched points, by their distances from its surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct BestFit {
    /// Maps the part's frame to the measuring frame.
    pub transform: DAffine3,
    /// Distance of each point from its surface less the nominal one, mm: positive outside.
    pub residuals: Vec<f64>,
    /// Offset of the touched surfaces outside their nominal ones, mm; none if not requested or not determined by the
    /// points.
    pub growth: Option<f64>,
    /// Motions of the part that the points do not determine, in the measuring frame. They keep their start values.
    pub free: Vec<Motion>,
    /// Standard deviations; none if there are no more points than unknowns.
    pub deviation: Option<Deviation>,
}

/// Fits worse than this fraction of the points' spread are accepted only after other starts have been tried.
const SURE: f64 = 1e-3;
/// A part turned farther than this, rad, fits only by a symmetry.
const FARTHEST_TURN: f64 = 1.2;
/// Other starts are turned by this angle about the three directions, rad.
const OTHER_START: f64 = 0.4;
/// Longest step, as a fraction of the points' spread: surfaces are curved, and long steps lead to other minima.
const LONGEST_STEP: f64 = 0.3;
const MAX_ITERATIONS: usize = 200;
/// Steps below this fraction of the points' spread are rounding.
const ROUNDING: f64 = 1e-12;

/// The rigid motion, near `start`, that brings the nominal surfaces to the touched points (Gauss-Newton with
/// Levenberg-Marquardt damping; steps are the shortest possible, so that undetermined motions stay zero). With
/// `growing`, one more unknown lets all surfaces stand farther out by the same amount.
///
/// # Errors
/// [`Error::TooFewPoints`] without a point, [`Error::NoFit`] if points are not finite, or no fit is found within about
/// 70 degrees of the start.
pub fn best_fit(touches: &[Touch], start: &DAffine3, growing: bool) -> Result<BestFit, Error> {
    // The decomposition of a matrix that is not finite would not terminate.
    if !start.is_finite() || touches.iter().any(|t| !(t.point.is_finite() && t.outside.is_finite())) {
        return Err(Error::NoFit);
    }
    if touches.is_empty() {
        return Err(Error::TooFewPoints { what: "geometry-points-surfaces", given: 0, min: 1 });
    }
    if growing {
        let fit = anywhere_near::<7>(touches, start)?;
        let with = fit.seen::<7>(touches).rank();
        if with > fit.seen::<6>(touches).rank() {
            return Ok(fit.finish::<7>(touches));
        }
    }
    anywhere_near::<6>(touches, start).map(|fit| fit.finish::<6>(touches))
}

/// The best fit from `start` and, if that one is poor, from starts turned away from it.
fn anywhere_near<const N: usize>(touches: &[Touch], start: &DAffine3) -> Result<State, Error> {
    let twists = Twists::about(touches.iter().map(|t| t.point));
    let good = (SURE * twists.reach).powi(2) * touches.len() as f64;
    let mut best: Option<State> = None;
    let turns = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|e| [e, -e]);
    for turn in std::iter::once(DVec3::ZERO).chain(turns) {
        let turn = (turn * OTHER_START * twists.reach).to_array();
        let turned = twists.motion(&[0.0, 0.0, 0.0, turn[0], turn[1], turn[2]]) * *start;
        // Translate first, then rotate: otherwise a large offset would turn the part over.
        let (moved, _) = State::at(touches, turned, 0.0).descend::<3>(touches, &twists);
        let (found, at_rest) = moved.descend::<N>(touches, &twists);
        if at_rest && found.near(start) && best.as_ref().is_none_or(|b| found.cost < b.cost) {
            let done = found.cost < good;
            best = Some(found);
            if done {
                break;
            }
        }
    }
    best.ok_or(Error::NoFit)
}

/// A pose of the part with its residuals.
struct State {
    transform: DAffine3,
    growth: f64,
    residuals: Vec<f64>,
    /// Outward normals at the feet, in the measuring frame.
    normals: Vec<DVec3>,
    cost: f64,
}

impl State {
    fn at(touches: &[Touch], transform: DAffine3, growth: f64) -> Self {
        let back = transform.inverse();
        let (mut residuals, mut normals) = (Vec::new(), Vec::new());
        for touch in touches {
            let foot = touch.surface.foot(back.transform_point3(touch.point));
            residuals.push(foot.distance - touch.outside - growth);
            normals.push(transform.transform_vector3(foot.normal));
        }
        let cost = residuals.iter().map(|r| r * r).sum();
        Self { transform, growth, residuals, normals, cost }
    }

    /// True if the part is not turned far away from `start`.
    fn near(&self, start: &DAffine3) -> bool {
        let between = start.matrix3.transpose() * self.transform.matrix3;
        let trace = between.x_axis.x + between.y_axis.y + between.z_axis.z;
        trace > 1.0 + 2.0 * FARTHEST_TURN.cos()
    }

    /// Jacobian of the residuals by the part's motion: three unknowns for the translation, three for the rotation, the
    /// seventh for the growth.
    fn rows<const N: usize>(&self, touches: &[Touch], twists: &Twists) -> Vec<[f64; N]> {
        let row = |(touch, normal): (&Touch, &DVec3)| {
            // The part moves, the point stays.
            let six = twists.row(touch.point, -*normal);
            std::array::from_fn(|k| six.get(k).copied().unwrap_or(-1.0))
        };
        touches.iter().zip(&self.normals).map(row).collect()
    }

    fn seen<const N: usize>(&self, touches: &[Touch]) -> Seen {
        let twists = Twists::about(touches.iter().map(|t| t.point));
        Seen::new(&self.rows::<N>(touches, &twists))
    }

    /// Minimises the cost in the first `N` unknowns; true if it converged.
    fn descend<const N: usize>(mut self, touches: &[Touch], twists: &Twists) -> (Self, bool) {
        let mut damping = 0.0f64;
        let mut seen = Seen::new(&self.rows::<N>(touches, twists));
        for _ in 0..MAX_ITERATIONS {
            let mut step = seen.step(&self.residuals, damping);
            let size = step.iter().map(|v| v * v).sum::<f64>().sqrt();
            let shorter = (LONGEST_STEP * twists.reach / size).min(1.0);
            step.iter_mut().for_each(|v| *v *= shorter);
            let growth = self.growth + step.get(6).copied().unwrap_or(0.0);
            step.resize(N.max(6), 0.0);
            let next = Self::at(touches, orthonormal(twists.motion(&step) * self.transform), growth);
            if size <= ROUNDING * twists.reach {
                return (if next.cost < self.cost { next } else { self }, true);
            }
            // Near the minimum the cost is flat to rounding, but steps still improve the pose.
            if next.cost <= self.cost * (1.0 + 1e-12) {
                self = next;
                seen = Seen::new(&self.rows::<N>(touches, twists));
                damping = if damping < 1e-6 { 0.0 } else { 0.1 * damping };
            } else {
                damping = (10.0 * damping).max(1e-4);
            }
        }
        (self, false)
    }

    fn finish<const N: usize>(self, touches: &[Touch]) -> BestFit {
        let twists = Twists::about(touches.iter().map(|t| t.point));
        let seen = self.seen::<N>(touches);
        BestFit {
            free: seen.free(&twists),
            deviation: seen.deviation(&twists, &self.residuals),
            growth: (N == 7).then_some(self.growth),
            transform: self.transform,
            residuals: self.residuals,
        }
    }
}

/// Removes the accumulated rounding of a rigid motion.
fn orthonormal(motion: DAffine3) -> DAffine3 {
    let turn = glam::DQuat::from_mat3(&motion.matrix3).normalize();
    DAffine3::from_rotation_translation(turn, motion.translation)
}
