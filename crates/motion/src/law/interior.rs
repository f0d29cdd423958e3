//! The fastest law under limits of speed, acceleration and jerk: a primal-dual interior-point method.

use super::pentadiagonal::Pentadiagonal;
use super::problem::{Newton, Problem};

/// Iterations after which the law reached is taken as it is: it satisfies every row at any time.
const MOST: usize = 120;
/// Complementarity to begin with, as a part of the time.
const BEGIN: f64 = 0.1;
/// Part of the way to the next row that a step may go.
const SHORT_OF: f64 = 0.99;

/// Coefficients of the fastest law, to within the part `gap` of the time it loses against the asked speed, beginning
/// at `start` (every row satisfied).
///
/// Mehrotra's predictor and corrector on the time with the rows of [`Problem`] as logarithmic barriers. The rows of
/// jerk are not convex (`1 / sqrt(b)` curves the wrong way): their curvature is kept as long as the matrix stays
/// positive, and halved until it is. Every step is shortened until the true slacks are positive, so that each iterate
/// satisfies the rows. A local method: no bad local optimum is known, none is excluded.
pub(crate) fn fastest(problem: &Problem, start: Vec<f64>, gap: f64) -> Vec<f64> {
    let mut at = Iterate::new(problem, start);
    for _ in 0..MOST {
        let enough = gap * problem.lost(&at.c);
        if (at.complementarity() < enough && at.residual(problem) < enough) || !at.improve(problem) {
            break;
        }
    }
    at.c
}

/// Unknowns with the slacks and multipliers of rows, of zero below them and of the upper bound above.
struct Iterate {
    c: Vec<f64>,
    rows: Pair,
    zero: Pair,
    upper: Pair,
    newton: Newton,
    factors: Pentadiagonal,
    /// Multipliers by slacks, of the rows.
    ratio: Vec<f64>,
}

/// Slacks, their multipliers, and changes of both.
struct Pair {
    g: Vec<f64>,
    z: Vec<f64>,
    dg: Vec<f64>,
    dz: Vec<f64>,
}

impl Pair {
    fn new(g: Vec<f64>, product: f64) -> Self {
        let z = g.iter().map(|g| product / g).collect();
        let (dg, dz) = (vec![0.0; g.len()], vec![0.0; g.len()]);
        Self { g, z, dg, dz }
    }

    fn complementarity(&self) -> f64 {
        self.g.iter().zip(&self.z).map(|(g, z)| if g.is_finite() { g * z } else { 0.0 }).sum()
    }

    /// The same after a step of these parts of the changes.
    fn after(&self, slack: f64, multiplier: f64) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.g.len() {
            if self.g[i].is_finite() {
                sum += (self.g[i] + slack * self.dg[i]) * (self.z[i] + multiplier * self.dz[i]);
            }
        }
        sum
    }

    /// Sets the multipliers' changes for the slacks' changes, `weights` being those of [`Pair::wanted`].
    fn follow(&mut self, weights: &[f64]) {
        for (i, w) in weights.iter().enumerate() {
            self.dz[i] = w - self.z[i] - self.z[i] / self.g[i] * self.dg[i];
        }
    }

    /// What the right side gets of each slack: `(target - part dg dz) / g`.
    fn wanted(&self, target: f64, part: f64, out: &mut [f64]) {
        for (i, out) in out.iter_mut().enumerate() {
            *out = (target - part * self.dg[i] * self.dz[i]) / self.g[i];
        }
    }
}

/// The greatest part of `change` (at most 1) that leaves every `x` positive, a little short of it.
fn part(x: &[f64], change: &[f64]) -> f64 {
    let most = x.iter().zip(change).map(|(x, d)| -d / x).fold(0.0, f64::max);
    if most > 0.0 { (SHORT_OF / most).min(1.0) } else { 1.0 }
}

impl Iterate {
    fn new(problem: &Problem, c: Vec<f64>) -> Self {
        let n = problem.unknowns;
        let mut g = vec![0.0; problem.slacks];
        problem.slacks(&c, &mut g);
        let product = BEGIN * problem.time(&c) / g.len() as f64;
        let above = c.iter().zip(&problem.upper).map(|(c, u)| u - c).collect();
        Self {
            rows: Pair::new(g, product),
            zero: Pair::new(c.clone(), product),
            upper: Pair::new(above, product),
            newton: Newton { slope: vec![0.0; n], matrix: Pentadiagonal::zero(n), concave: Pentadiagonal::zero(n) },
            factors: Pentadiagonal::zero(n),
            ratio: vec![0.0; problem.slacks],
            c,
        }
    }

    fn pairs(&self) -> [&Pair; 3] {
        [&self.rows, &self.zero, &self.upper]
    }

    fn complementarity(&self) -> f64 {
        self.pairs().iter().map(|p| p.complementarity()).sum()
    }

    /// How far the law is from one that no change betters, as a time: what changing every coefficient by itself gains.
    fn residual(&mut self, problem: &Problem) -> f64 {
        let slope = &mut self.newton.slope;
        problem.slopes(&self.c, slope);
        slope.iter_mut().for_each(|s| *s = -*s);
        problem.weighted_slopes(&self.c, &self.rows.z, slope);
        (0..self.c.len()).map(|i| (slope[i] + self.zero.z[i] - self.upper.z[i]).abs() * self.c[i]).sum()
    }

    /// One step; false if it could not be made.
    fn improve(&mut self, problem: &Problem) -> bool {
        let count = self.pairs().iter().flat_map(|p| &p.g).filter(|g| g.is_finite()).count() as f64;
        let mean = self.complementarity() / count;
        if !self.factorise(problem) {
            return false;
        }
        let mut weights = [vec![0.0; problem.slacks], vec![0.0; problem.unknowns], vec![0.0; problem.unknowns]];
        self.direction(problem, &weights);
        let (slack, multiplier) = self.parts();
        let predicted = self.pairs().iter().map(|p| p.after(slack, multiplier)).sum::<f64>() / count;
        let centring = (predicted / mean).powi(2).clamp(1e-3, 0.9);
        for (pair, w) in [&self.rows, &self.zero, &self.upper].into_iter().zip(&mut weights) {
            pair.wanted(centring * mean, slack * multiplier, w);
        }
        let step = self.direction(problem, &weights);
        let (slack, multiplier) = self.parts();
        self.go(problem, &step, slack, multiplier)
    }

    /// Factors of the Newton matrix, with as much of the concave part as leaves it positive.
    fn factorise(&mut self, problem: &Problem) -> bool {
        for (r, (g, z)) in self.ratio.iter_mut().zip(self.rows.g.iter().zip(&self.rows.z)) {
            *r = z / g;
        }
        problem.newton(&self.c, &self.ratio, &self.rows.z, &mut self.newton);
        for i in 0..self.c.len() {
            self.newton.matrix.diagonals[0][i] += self.zero.z[i] / self.zero.g[i] + self.upper.z[i] / self.upper.g[i];
        }
        [1.0, 0.5, 0.25, 0.0].iter().any(|part| self.factors.factor(&self.newton.matrix, &self.newton.concave, *part))
    }

    /// The Newton step for these weights of the slacks' slopes, and the changes of slacks and multipliers with it.
    fn direction(&mut self, problem: &Problem, weights: &[Vec<f64>; 3]) -> Vec<f64> {
        let mut step: Vec<f64> =
            (0..self.c.len()).map(|i| weights[1][i] - weights[2][i] - self.newton.slope[i]).collect();
        problem.weighted_slopes(&self.c, &weights[0], &mut step);
        self.factors.solve(&mut step);
        problem.change(&self.c, &step, &mut self.rows.dg);
        self.zero.dg.copy_from_slice(&step);
        self.upper.dg.iter_mut().zip(&step).for_each(|(d, s)| *d = -s);
        self.rows.follow(&weights[0]);
        self.zero.follow(&weights[1]);
        self.upper.follow(&weights[2]);
        step
    }

    /// How much of the changes of slacks and of multipliers can be gone.
    fn parts(&self) -> (f64, f64) {
        let least = |part_of: fn(&Pair) -> f64| self.pairs().iter().map(|p| part_of(p)).fold(1.0, f64::min);
        (least(|p| part(&p.g, &p.dg)), least(|p| part(&p.z, &p.dz)))
    }

    /// Goes the step, shortened until the true slacks are positive.
    fn go(&mut self, problem: &Problem, step: &[f64], mut slack: f64, multiplier: f64) -> bool {
        let mut next = vec![0.0; self.c.len()];
        let mut g = vec![0.0; problem.slacks];
        loop {
            (0..next.len()).for_each(|i| next[i] = self.c[i] + slack * step[i]);
            let inside = next.iter().zip(&problem.upper).all(|(c, u)| *c > 0.0 && c < u);
            if inside
                && problem.slacks(&next, &mut g)
                && g.iter().zip(&self.rows.g).all(|(new, old)| *new > 0.005 * old)
            {
                break;
            }
            slack *= 0.7;
            if slack < 1e-9 {
                return false;
            }
        }
        self.c.copy_from_slice(&next);
        self.rows.g.copy_from_slice(&g);
        self.zero.g.copy_from_slice(&next);
        (0..next.len()).for_each(|i| self.upper.g[i] = problem.upper[i] - next[i]);
        for pair in [&mut self.rows, &mut self.zero, &mut self.upper] {
            pair.z.iter_mut().zip(&pair.dz).for_each(|(z, d)| *z += multiplier * d);
        }
        true
    }
}
