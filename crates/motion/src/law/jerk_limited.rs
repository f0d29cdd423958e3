//! The coefficients of a piece's law, with what lies between the places where rows were imposed checked.

use super::cells::Cells;
use super::channels::{Channels, Limits};
use super::error::LawError;
use super::interior::Iterate;
use super::peak::{peak, used};
use super::problem::Problem;
use super::rest::RestToRest;
use super::rows::Room;

/// The law is planned with limits smaller by this part: for what lies between the places checked, and so that a hold
/// has room to begin (see `pace`).
pub(crate) const RESERVE: f64 = 1e-3;
/// Times the law is solved again with less room where a limit was passed.
const ROUNDS: usize = 4;
/// How near the law comes to the best that the method can find, as a part of the time lost against the asked speed.
const GAP: f64 = 1e-5;
/// Coefficients nearer to the asked speed than this part are put on it.
const SNAP: f64 = 1e-5;

/// Cells that could change the time lost by more than this part are halved.
const SHARE: f64 = 5e-5;
/// All of them together are worth halving from this part on.
const ENOUGH: f64 = 3e-4;
/// Cells in which the law is too stiff to follow an asked speed that changes are halved if that costs more than this
/// part of the time,
const STIFF: f64 = 4e-6;
/// and no limit is used by more than this part.
const SPARED: f64 = 0.9;
/// Use of a limit between the places of rows from which on cells are halved rather than given less room.
const ROUGH: f64 = 1.001;
/// Narrower cells than this part of the path get less room rather than being halved: they would cost digits.
const NARROWEST: f64 = 1e-6;
/// What may be used of a limit in the end.
const ALLOWED: f64 = 1.0 - 0.5 * RESERVE;
/// A law that uses this much of a limit is no place to begin at.
const WILD: f64 = 1.1;
/// Room is not lessened by more than this factor at once.
const LEAST_AT_ONCE: f64 = 0.9;
/// Cells beyond those to begin with, from which on nothing is halved any more.
const MOST_CELLS: usize = 4000;
/// Gap to which laws on grids that will be refined are solved,
const COARSE_GAP: f64 = 1e-3;
/// and laws that only tell where to begin.
const GUESS_GAP: f64 = 1e-2;
/// Fewer cells than these are begun at a slow law, more at a law in coarser ones.
const FEW: usize = 80;

/// The cells of a piece of `path` and the coefficients of the fastest law in them, see [`Problem`].
///
/// Solved on the cells between `tau` first, then with every cell halved in which the law does not just cruise at the
/// asked speed: what was found before is a spline on the finer cells too and a good start there. Guarantee: no limit
/// is exceeded anywhere (speeds, accelerations and jerks are bounded between the places where rows were imposed, and
/// half a thousandth is kept in reserve); nowhere faster than asked.
///
/// # Errors
/// As [`Cells::new`].
pub(crate) fn plan(
    path: &dyn Channels,
    map: RestToRest,
    tau: Vec<f64>,
    limits: &[Limits],
) -> Result<(Cells, Vec<f64>), LawError> {
    let mut cells = Cells::new(path, map, tau, limits.to_vec())?;
    let mut near = guess(path, &cells);
    let most = cells.count() + MOST_CELLS;
    loop {
        let room = Room::new(&cells);
        let problem = Problem::new(&cells, &room, near.as_deref());
        let mut law = begin(&problem, near.as_deref());
        law.solve(&problem, COARSE_GAP);
        let found = law.coefficients();
        let Some(tau) = refined(&cells, most, (found, problem.lost(problem.time(found)))) else {
            let c = certified(&cells, problem, room, law);
            return Ok((cells, c));
        };
        let finer = Cells::new(path, map, tau, limits.to_vec())?;
        near = Some(cells.carried(found, &finer, 0.0));
        cells = finer;
    }
}

/// Stations of finer cells for the law with coefficients `c`, which loses the time `lost`, where it bends or uses too
/// much of a limit, or is too stiff; none if they would hardly make it faster, or there are the `most` already.
fn refined(cells: &Cells, most: usize, (c, lost): (&[f64], f64)) -> Option<Vec<f64>> {
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

/// A law near to the one wanted in `cells`, from coarser ones: none if they are few.
fn guess(path: &dyn Channels, cells: &Cells) -> Option<Vec<f64>> {
    if cells.count() < FEW {
        return None;
    }
    let coarser = Cells::new(path, cells.map, cells.merged(), cells.limits.clone()).ok()?;
    let near = guess(path, &coarser);
    let problem = Problem::new(&coarser, &Room::new(&coarser), near.as_deref());
    let mut law = begin(&problem, near.as_deref());
    law.solve(&problem, GUESS_GAP);
    Some(coarser.carried(law.coefficients(), cells, 0.0))
}

/// About the time (s) that cell `i` could gain or lose by being finer: from the jump of the squared speed's second
/// derivative at its ends, where a quadratic spline is too stiff.
fn bend(cells: &Cells, c: &[f64], i: usize) -> f64 {
    let second = |i: usize| {
        let w = cells.weights(i).second;
        w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2]
    };
    let (own, width) = (second(i), cells.width(i));
    let before = if i > 0 { (own - second(i - 1)).abs() } else { 0.0 };
    let after = if i + 1 < cells.count() { (own - second(i + 1)).abs() } else { 0.0 };
    let b = c[i + 1];
    // Not more than the time it takes as it is.
    (before.max(after) * width.powi(3) / (8.0 * b * b.sqrt())).min(width / b.sqrt())
}

/// Where to begin: at a law known before, or at a slow one.
fn begin(problem: &Problem, near: Option<&[f64]>) -> Iterate {
    near.map_or_else(|| Iterate::slow(problem), |c| Iterate::near(problem, c))
}

/// The law in its final cells, beginning at one found before, solved until no limit is exceeded between the places of
/// its rows.
fn certified(cells: &Cells, mut problem: Problem, mut room: Room, mut law: Iterate) -> Vec<f64> {
    let mut worst = room.lessen(cells, law.coefficients());
    let mut c = Vec::new();
    for _ in 0..ROUNDS {
        problem.tighten(cells, &room);
        if worst < WILD {
            law.resume(&problem);
        } else {
            law = Iterate::slow(&problem);
        }
        law.solve(&problem, GAP);
        c = law.coefficients().to_vec();
        snap(&mut c, &problem.upper);
        worst = room.lessen(cells, &c);
        if worst <= ALLOWED {
            return c;
        }
    }
    // Slowing the whole law by a part lessens its accelerations by as much, and its jerks by more.
    c.iter_mut().for_each(|c| *c *= ALLOWED / worst);
    c
}

impl Room {
    /// All but the reserve; more rows in run-up and run-down.
    fn new(cells: &Cells) -> Self {
        let dense = (0..cells.count()).map(|i| cells.is_near_rest(i)).collect();
        Self { part: vec![1.0 - RESERVE; cells.count()], dense }
    }

    /// Lessens it where the law with coefficients `c` uses more than is allowed, and beside; the greatest use.
    fn lessen(&mut self, cells: &Cells, c: &[f64]) -> f64 {
        let mut worst: f64 = 0.0;
        for i in 0..cells.count() {
            let most = peak(cells, c, i);
            worst = worst.max(most);
            if most > ALLOWED {
                let less = ((1.0 - RESERVE) / most).max(LEAST_AT_ONCE);
                let around = i.saturating_sub(1)..(i + 2).min(cells.count());
                self.part[around.clone()].iter_mut().for_each(|r| *r = r.min((1.0 - RESERVE) * less * less));
                self.dense[around].iter_mut().for_each(|d| *d = true);
            }
        }
        worst
    }
}

/// Coefficients all but at the asked speed are put on it: a constant speed is to be exactly that.
fn snap(c: &mut [f64], upper: &[f64]) {
    for (c, u) in c.iter_mut().zip(upper).filter(|(c, u)| **c > (1.0 - SNAP) * **u) {
        *c = *u;
    }
}
