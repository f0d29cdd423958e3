use super::motion::Motion;
use super::twist::{Deviation, Seen, Twists};
use crate::{Error, SignedDistance};
use glam::{DAffine3, DVec3};

/// A touched point.
#[derive(Clone, Copy)]
pub struct Touch<'a> {
    /// Where, mm, in the measuring frame.
    pub point: DVec3,
    /// The nominal surface that was touched, in the part's frame.
    pub surface: &'a dyn SignedDistance,
    /// How far outside the surface the point is meant to be, mm: the radius of the probe's ball, or 0.
    pub outside: f64,
}

/// Where the part fits the touched points best, in the sense of least squares of their distances.
#[derive(Debug, Clone, PartialEq)]
pub struct BestFit {
    /// Maps the part's frame to the measuring frame.
    pub transform: DAffine3,
    /// Distance of each point from its surface less what it should be, mm: positive outside.
    pub residuals: Vec<f64>,
    /// By how much the touched surfaces stand farther out than their nominal ones, mm; none if it was not asked for or
    /// the points do not tell it.
    pub growth: Option<f64>,
    /// Motions of the part that the points do not see, in the measuring frame. They are left as they were at the start.
    pub free: Vec<Motion>,
    /// Standard deviations; none if there are no more points than unknowns.
    pub deviation: Option<Deviation>,
}

/// Fits worse than this part of the points' spread are not believed before other starts have been tried.
const SURE: f64 = 1e-3;
/// A part turned farther than this, rad, fits by a symmetry and not because it stands there.
const FARTHEST_TURN: f64 = 1.2;
/// Other starts are turned by this angle about the three directions, rad.
const OTHER_START: f64 = 0.4;
/// Longest step, as part of the points' spread: the surfaces bend, and long steps lead to other valleys.
const LONGEST_STEP: f64 = 0.3;
const MOST_STEPS: usize = 200;
/// Steps below this part of the points' spread are rounding.
const ROUNDING: f64 = 1e-12;

/// The rigid motion, near `start`, that brings the nominal surfaces to the touched points (Gauss-Newton with
/// Levenberg-Marquardt damping; steps are the shortest possible, so that motions which the points do not see stay out).
/// With `growing`, one more unknown lets all surfaces stand farther out by the same amount.
///
/// # Errors
/// [`Error::TooFewPoints`] without a point, [`Error::NoFit`] if points are not finite, or nothing
/// is found within about 70 degrees of the start.
pub fn best_fit(touches: &[Touch], start: &DAffine3, growing: bool) -> Result<BestFit, Error> {
    // A decomposition of what is not finite would not end.
    if !start.is_finite() || touches.iter().any(|t| !(t.point.is_finite() && t.outside.is_finite())) {
        return Err(Error::NoFit);
    }
    if touches.is_empty() {
        return Err(Error::TooFewPoints { what: "the surfaces", given: 0, least: 1 });
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

/// The best of the fits from `start` and, if that one is bad, from starts turned away from it.
fn anywhere_near<const N: usize>(touches: &[Touch], start: &DAffine3) -> Result<State, Error> {
    let twists = Twists::about(touches.iter().map(|t| t.point));
    let good = (SURE * twists.reach).powi(2) * touches.len() as f64;
    let mut best: Option<State> = None;
    let turns = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|e| [e, -e]);
    for turn in std::iter::once(DVec3::ZERO).chain(turns) {
        let turn = (turn * OTHER_START * twists.reach).to_array();
        let turned = twists.motion(&[0.0, 0.0, 0.0, turn[0], turn[1], turn[2]]) * *start;
        // Moved first and turned then: a part that is far off would be turned over by its own distance.
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

/// A place of the part with what the points say there.
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

    /// How the residuals change when the part moves; the first three unknowns are the move, three more the turn, and
    /// the seventh is the growth.
    fn rows<const N: usize>(&self, touches: &[Touch], twists: &Twists) -> Vec<[f64; N]> {
        let row = |(touch, normal): (&Touch, &DVec3)| {
            // The part moves under a point that stays.
            let six = twists.row(touch.point, -*normal);
            std::array::from_fn(|k| six.get(k).copied().unwrap_or(-1.0))
        };
        touches.iter().zip(&self.normals).map(row).collect()
    }

    fn seen<const N: usize>(&self, touches: &[Touch]) -> Seen {
        let twists = Twists::about(touches.iter().map(|t| t.point));
        Seen::new(&self.rows::<N>(touches, &twists))
    }

    /// Goes downhill in the first `N` unknowns, and says if the bottom was reached.
    fn descend<const N: usize>(mut self, touches: &[Touch], twists: &Twists) -> (Self, bool) {
        let mut damping = 0.0f64;
        let mut seen = Seen::new(&self.rows::<N>(touches, twists));
        for _ in 0..MOST_STEPS {
            let mut step = seen.step(&self.residuals, damping);
            let size = step.iter().map(|v| v * v).sum::<f64>().sqrt();
            let shorter = (LONGEST_STEP * twists.reach / size).min(1.0);
            step.iter_mut().for_each(|v| *v *= shorter);
            let growth = self.growth + step.get(6).copied().unwrap_or(0.0);
            step.resize(N.max(6), 0.0);
            let next = Self::at(touches, (twists.motion(&step) * self.transform).orthonormal(), growth);
            if size <= ROUNDING * twists.reach {
                return (if next.cost < self.cost { next } else { self }, true);
            }
            // Near the bottom the cost is flat to rounding while steps still go the right way.
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

/// Takes the rounding out of a rigid motion that is a product of many.
trait Orthonormal {
    fn orthonormal(self) -> Self;
}

impl Orthonormal for DAffine3 {
    fn orthonormal(self) -> Self {
        let turn = glam::DQuat::from_mat3(&self.matrix3).normalize();
        Self::from_rotation_translation(turn, self.translation)
    }
}
