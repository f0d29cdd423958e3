//! Coefficients of a piece's speed profile, verified also between the points at which rows were imposed.

use super::cells::Cells;
use super::channels::Channels;
use super::error::SpeedProfileError;
use super::interior_point::Iterate;
use super::limit_use::{peak, used};
use super::problem::Problem;
use super::rest_to_rest::RestToRest;
use super::row_selection::Room;
use seamwright_machine::AxisLimits;

/// Fraction of the limits kept in reserve: for values between the checked points, and for the start of a hold (see
/// `feed_override`).
pub(crate) const RESERVE: f64 = 1e-3;
/// Maximum number of repeated solutions with less room in cells that exceed a limit.
const ROUNDS: usize = 4;
/// Relative gap of the final solution to the optimum of the method, of the time lost against the requested speed.
const GAP: f64 = 1e-5;
/// Coefficients closer to the requested speed than this fraction are set to it.
const SNAP: f64 = 1e-5;

/// Minimum change of the lost time, as a fraction, for which a cell is halved.
const SHARE: f64 = 5e-5;
/// Minimum total change of the lost time, as a fraction, for a refinement.
const ENOUGH: f64 = 3e-4;
/// Cells too stiff to follow a changing requested speed are halved if that costs more than this fraction of the time,
const STIFF: f64 = 4e-6;
/// and no limit is used by more than this fraction.
const SPARED: f64 = 0.9;
/// Use of a limit between the points of rows above which cells are halved rather than given less room.
const ROUGH: f64 = 1.001;
/// Minimum width of a halved cell, as a fraction of the path; narrower cells get less room, since halving costs digits.
const NARROWEST: f64 = 1e-6;
/// Maximum use of a limit by the final profile.
const ALLOWED: f64 = 1.0 - 0.5 * RESERVE;
/// Use of a limit above which a profile is not a valid start.
const WILD: f64 = 1.1;
/// Minimum factor by which room is reduced in one round.
const MIN_ROOM_FACTOR: f64 = 0.9;
/// Number of added cells above which halving stops.
const MAX_ADDED_CELLS: usize = 4000;
/// Gap of profiles on grids that will be refined,
const COARSE_GAP: f64 = 1e-3;
/// and of profiles used only as a start.
const GUESS_GAP: f64 = 1e-2;
/// Fewer cells than this start at a slow profile, more at a profile in coarser cells.
const FEW: usize = 80;

/// Plans the cells of a piece of `path` and the coefficients of the fastest profile in them, see [`Problem`].
///
/// Solved on the cells between `tau` first, then after halving cells in which the profile bends, exceeds a limit or is
/// too stiff. The previous solution is a spline on the finer cells too and a good start there. Guarantee: no limit is
/// exceeded anywhere (speeds, accelerations and jerks are bounded between the points of rows, and half a thousandth is
/// kept in reserve); the tip is never faster than requested.
pub(crate) fn plan(
    path: &dyn Channels,
    map: RestToRest,
    tau: Vec<f64>,
    limits: &[AxisLimits],
) -> Result<(Cells, Vec<f64>), SpeedProfileError> {
    let mut cells = Cells::new(path, map, tau, limits.to_vec())?;
    let mut near = guess(path, &cells);
    let most = cells.count() + MAX_ADDED_CELLS;
    loop {
        let room = Room::new(&cells);
        let problem = Problem::new(&cells, &room, near.as_deref());
        let mut profile = begin(&problem, near.as_deref());
        profile.solve(&problem, COARSE_GAP);
        let found = &profile.c;
        let lost = problem.lost(problem.time(found));
        let Some(tau) = refined(&cells, found, lost, most) else {
            let c = certified(&cells, problem, room, profile);
            return Ok((cells, c));
        };
        let finer = Cells::new(path, map, tau, limits.to_vec())?;
        near = Some(cells.carried(found, &finer, 0.0));
        cells = finer;
    }
}

/// Stations after halving cells in which the profile with coefficients `c` bends, uses too much of a limit, or is too
/// stiff; it loses the time `lost`. None if the gain is negligible, or if there are more than `most` cells.
fn refined(cells: &Cells, c: &[f64], lost: f64, most: usize) -> Option<Vec<f64>> {
    let bends: Vec<f64> = (0..cells.count()).map(|i| bend(cells, c, i)).collect();
    let narrow = NARROWEST * cells.map.length();
    let rough: Vec<bool> = (0..cells.count()).map(|i| cells.width(i) > narrow && peak(cells, c, i) > ROUGH).collect();
    let time: f64 = (0..cells.count()).map(|i| cells.width(i) / c[i + 1].sqrt()).sum();
    let stiff: Vec<bool> = (0..cells.count())
        .map(|i| cells.width(i) > narrow && cells.late(c, i) > STIFF * time && used(cells, c, i) < SPARED)
        .collect();
    let gain: f64 = bends.iter().filter(|bend| **bend > SHARE * lost).sum();
    if cells.count() > most || (gain < ENOUGH * lost && !rough.contains(&true) && !stiff.contains(&true)) {
        return None;
    }
    let tau = cells.halved(|i| bends[i] > SHARE * lost || rough[i] || stiff[i]);
    (tau.len() > cells.tau.len()).then_some(tau)
}

/// A start profile for `cells`, solved in coarser ones; none for few cells.
fn guess(path: &dyn Channels, cells: &Cells) -> Option<Vec<f64>> {
    if cells.count() < FEW {
        return None;
    }
    let coarser = Cells::new(path, cells.map, cells.merged(), cells.limits.clone()).ok()?;
    let near = guess(path, &coarser);
    let problem = Problem::new(&coarser, &Room::new(&coarser), near.as_deref());
    let mut profile = begin(&problem, near.as_deref());
    profile.solve(&problem, GUESS_GAP);
    Some(coarser.carried(&profile.c, cells, 0.0))
}

/// Estimated change of time (s) from refining cell `i`: from the jump of the squared speed's second derivative at its
/// ends, where a quadratic spline is too stiff.
fn bend(cells: &Cells, c: &[f64], i: usize) -> f64 {
    let second = |i: usize| {
        let w = cells.weights(i).second;
        w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2]
    };
    let (own, width) = (second(i), cells.width(i));
    let before = if i > 0 { (own - second(i - 1)).abs() } else { 0.0 };
    let after = if i + 1 < cells.count() { (own - second(i + 1)).abs() } else { 0.0 };
    let b = c[i + 1];
    // Bounded by the time of the cell.
    (before.max(after) * width.powi(3) / (8.0 * b * b.sqrt())).min(width / b.sqrt())
}

/// Start of the iteration: a previous profile, or a slow one.
fn begin(problem: &Problem, near: Option<&[f64]>) -> Iterate {
    near.map_or_else(|| Iterate::slow(problem), |c| Iterate::near(problem, c))
}

/// Solves the profile in its final cells from a previous one, until no limit is exceeded between the points of its
/// rows.
fn certified(cells: &Cells, mut problem: Problem, mut room: Room, mut profile: Iterate) -> Vec<f64> {
    let mut worst = room.lessen(cells, &profile.c);
    let mut c = Vec::new();
    for _ in 0..ROUNDS {
        problem.tighten(cells, &room);
        if worst < WILD {
            profile.resume(&problem);
        } else {
            profile = Iterate::slow(&problem);
        }
        profile.solve(&problem, GAP);
        c = profile.c.clone();
        snap(&mut c, &problem.upper);
        worst = room.lessen(cells, &c);
        if worst <= ALLOWED {
            return c;
        }
    }
    // Slowing the whole profile by a factor reduces accelerations by the same factor, and jerks by more.
    c.iter_mut().for_each(|c| *c *= ALLOWED / worst);
    c
}

impl Room {
    /// Full limits less the reserve; more rows in acceleration and deceleration phase.
    fn new(cells: &Cells) -> Self {
        let dense = (0..cells.count()).map(|i| cells.is_near_rest(i)).collect();
        Self { part: vec![1.0 - RESERVE; cells.count()], dense }
    }

    /// Reduces the room of cells, and of their neighbours, in which the profile with coefficients `c` exceeds the
    /// allowed use. Returns the maximum use.
    fn lessen(&mut self, cells: &Cells, c: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        for i in 0..cells.count() {
            let most = peak(cells, c, i);
            worst = worst.max(most);
            if most > ALLOWED {
                let less = ((1.0 - RESERVE) / most).max(MIN_ROOM_FACTOR);
                let around = i.saturating_sub(1)..(i + 2).min(cells.count());
                self.part[around.clone()].iter_mut().for_each(|r| *r = r.min((1.0 - RESERVE) * less * less));
                self.dense[around].iter_mut().for_each(|d| *d = true);
            }
        }
        worst
    }
}

/// Sets coefficients very near the requested speed to it, so that a constant speed is exact.
fn snap(c: &mut [f64], upper: &[f64]) {
    for (c, u) in c.iter_mut().zip(upper).filter(|(c, u)| **c > (1.0 - SNAP) * **u) {
        *c = *u;
    }
}
