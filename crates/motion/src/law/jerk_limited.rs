//! The coefficients of a piece's law, with what lies between the places where rows were imposed checked.

use super::cells::{Cells, PARTS};
use super::channels::{Channels, Limits};
use super::error::LawError;
use super::interior::fastest;
use super::problem::Problem;
use super::rest::RestToRest;

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
/// Use of a limit between the places of rows from which on cells are halved rather than given less room.
const ROUGH: f64 = 1.003;
/// What may be used of a limit in the end.
const ALLOWED: f64 = 1.0 - 0.5 * RESERVE;
/// A law that uses this much of a limit is no place to begin at.
const WILD: f64 = 1.1;
/// Room is not lessened by more than this factor at once.
const LEAST_AT_ONCE: f64 = 0.9;
/// Cells beyond which nothing is halved any more.
const MOST_CELLS: usize = 4000;
/// Gap to which laws on grids that will be refined are solved.
const COARSE_GAP: f64 = 1e-3;

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
    let mut c: Option<Vec<f64>> = None;
    loop {
        let room = Room::new(&cells);
        let problem = Problem::new(&cells, &room, c.as_deref());
        let found = fastest(&problem, start(&problem, c.take()), COARSE_GAP);
        let coarse = SHARE * problem.lost(&found);
        let tau = cells.halved(|i| bend(&cells, &found, i) > coarse || peak(&cells, &found, i) > ROUGH);
        let gain: f64 = (0..cells.count()).map(|i| bend(&cells, &found, i)).filter(|b| *b > coarse).sum();
        let rough = (0..cells.count()).any(|i| peak(&cells, &found, i) > ROUGH);
        if (!rough && gain < ENOUGH * problem.lost(&found))
            || cells.count() > MOST_CELLS
            || tau.len() == cells.tau.len()
        {
            let c = certified(&cells, found);
            return Ok((cells, c));
        }
        let finer = Cells::new(path, map, tau, limits.to_vec())?;
        c = Some(cells.carried(&found, &finer, 0.0));
        cells = finer;
    }
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

/// The law in its final cells, beginning at one found before, solved until no limit is exceeded between the places of
/// its rows.
fn certified(cells: &Cells, mut c: Vec<f64>) -> Vec<f64> {
    let mut room = Room::new(cells);
    let mut worst = room.lessen(cells, &c);
    for _ in 0..ROUNDS {
        let problem = Problem::new(cells, &room, Some(&c));
        let begin = if worst < WILD { slowed(&problem, c) } else { slow(&problem) };
        c = fastest(&problem, begin, GAP);
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

/// What each cell may use of the limits.
pub(crate) struct Room {
    /// The part of them.
    pub(crate) part: Vec<f64>,
    /// Whether the cell needs rows at more places.
    pub(crate) dense: Vec<bool>,
}

impl Room {
    /// All but the reserve; more rows in run-up and run-down.
    fn new(cells: &Cells) -> Self {
        let [up, down] = cells.map.borders();
        let dense = (0..cells.count()).map(|i| cells.tau[i] < up || cells.tau[i + 1] > down).collect();
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

/// Where to begin: at a law known before, slowed, or at a slow constant one.
fn start(problem: &Problem, before: Option<Vec<f64>>) -> Vec<f64> {
    match before {
        Some(c) => slowed(problem, c),
        None => slow(problem),
    }
}

/// Half the greatest constant.
fn slow(problem: &Problem) -> Vec<f64> {
    vec![0.5 * problem.greatest_constant(); problem.unknowns]
}

/// The law slowed as a whole until it satisfies every row with some room.
fn slowed(problem: &Problem, mut c: Vec<f64>) -> Vec<f64> {
    let mut g = vec![0.0; problem.slacks];
    for _ in 0..40 {
        c.iter_mut().zip(&problem.upper).for_each(|(c, u)| *c = (0.95 * *c).min(0.95 * u));
        if c.iter().all(|c| *c > 0.0) && problem.slacks(&c, &mut g) && g.iter().all(|g| *g > 0.0) {
            return c;
        }
    }
    slow(problem)
}

/// Coefficients all but at the asked speed are put on it: a constant speed is to be exactly that.
fn snap(c: &mut [f64], upper: &[f64]) {
    for (c, u) in c.iter_mut().zip(upper).filter(|(c, u)| **c > (1.0 - SNAP) * **u) {
        *c = *u;
    }
}

/// The greatest use of a limit in cell `i`: of a speed (squared, the asked one too), an acceleration or a jerk.
/// Between the [`PARTS`] a parabola through three neighbours each, and what their third differences leave open.
pub(crate) fn peak(cells: &Cells, c: &[f64], i: usize) -> f64 {
    let law: [[f64; 3]; PARTS.len()] = std::array::from_fn(|part| {
        let w = cells.weights_at(i, part);
        let dot = |w: &[f64; 3]| w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2];
        [dot(&w.value), dot(&w.first), dot(&w.second)]
    });
    let mut most: f64 = 0.0;
    for (channel, limits) in cells.limits.iter().enumerate() {
        let mut used = [[0.0; PARTS.len()]; 3];
        for (part, [b, d, e]) in law.iter().enumerate() {
            let [q1, q2, q3] = cells.derivatives(i, part)[channel];
            used[0][part] = q1 * q1 * b / (limits.speed * limits.speed);
            used[1][part] = (q2 * b + 0.5 * q1 * d) / limits.acceleration;
            used[2][part] = b.max(0.0).sqrt() * (q3 * b + 1.5 * q2 * d + 0.5 * q1 * e) / limits.jerk;
        }
        most = used.iter().map(greatest).fold(most, f64::max);
    }
    if !cells.is_steady(i) {
        let asked = cells.asked(i);
        most = most.max(greatest(&std::array::from_fn(|part| law[part][0] / asked[part])));
    }
    most
}

/// Greatest size of a smooth function known at five evenly spaced places, between them too.
fn greatest(f: &[f64; PARTS.len()]) -> f64 {
    let mut most = f.iter().map(|v| v.abs()).fold(0.0, f64::max);
    for i in 1..PARTS.len() - 1 {
        let (slope, second) = (0.5 * (f[i + 1] - f[i - 1]), f[i + 1] - 2.0 * f[i] + f[i - 1]);
        let vertex = -slope / second;
        if vertex.abs() <= 1.0 {
            most = most.max((f[i] + 0.5 * slope * vertex).abs());
        }
    }
    let thirds = [0, 1].map(|i| f[i + 3] - 3.0 * f[i + 2] + 3.0 * f[i + 1] - f[i]);
    // A cubic is off its parabola by 0.065 of the third difference, which changes by the fourth one.
    most + 0.07 * (thirds[0].abs().max(thirds[1].abs()) + (thirds[1] - thirds[0]).abs())
}
