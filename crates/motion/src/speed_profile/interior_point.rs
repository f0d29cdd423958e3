//! Primal-dual interior-point method for the fastest profile under limits of speed, acceleration and jerk.

use super::lanes::larger;
use super::problem::{Lists, Newton, Problem};
use seamwright_geometry::numeric::Pentadiagonal;

/// Maximum number of iterations; the last iterate is then used, as every iterate satisfies all rows.
const MAX_ITERATIONS: usize = 120;
/// Maximum step, as a fraction of the distance to the nearest row.
const SHORT_OF: f64 = 0.99;
/// Initial complementarity, as a fraction of the time, at a previous profile slowed by a fraction of its squared speed:
/// this factor times that fraction; and the factor if its multipliers are known too.
const BEGIN_NEAR: f64 = 2.0;
const BEGIN_AGAIN: f64 = 0.1;
/// Initial complementarity at a slow profile.
const BEGIN: f64 = 0.1;
/// Minimum complementarity as a fraction of the residual: a faster reduction would stop at rows far from the optimum.
const BALANCE: f64 = 0.3;
/// Minimum fraction by which a previous profile is slowed.
const MIN_SLOWDOWN: f64 = 0.01;

/// Iterate of the method: coefficients with the slacks and multipliers of all rows.
///
/// Mehrotra's predictor and corrector on the time with the rows of [`Problem`] as logarithmic barriers. The rows of
/// jerk are not convex (`1 / sqrt(b)` curves the wrong way): their curvature is kept as long as the matrix stays
/// positive, and halved until it is. Every step is shortened until the true slacks are positive, so that each iterate
/// satisfies the rows. The method is local; bad local optima are unknown but not excluded.
pub(crate) struct Iterate {
    pub(crate) c: Vec<f64>,
    /// Slacks, and their reciprocals.
    g: Lists,
    by_g: Lists,
    /// Multipliers, and multipliers by slacks.
    z: Lists,
    ratio: Lists,
    /// Changes of slacks, and their contributions to the right side, later changes of multipliers.
    dg: Lists,
    dz: Lists,
    /// Sum of slacks times multipliers, and their number.
    complementarity: f64,
    count: f64,
    newton: Newton,
    factors: Pentadiagonal,
    step: Vec<f64>,
}

impl Iterate {
    /// Starts at half the maximum constant squared speed that satisfies every row.
    pub(crate) fn slow(problem: &Problem) -> Self {
        Self::new(problem, vec![0.5 * problem.greatest_constant(); problem.unknowns], BEGIN)
    }

    /// Starts at a previous profile, slowed as a whole until it satisfies every row.
    pub(crate) fn near(problem: &Problem, c: &[f64]) -> Self {
        match slowed(problem, c) {
            Some((c, less)) => Self::new(problem, c, BEGIN_NEAR * less),
            None => Self::slow(problem),
        }
    }

    /// Continues after the problem was tightened, from the last iterate, slowed as far as needed.
    pub(crate) fn resume(&mut self, problem: &Problem) {
        let Some((c, less)) = slowed(problem, &self.c) else {
            *self = Self::slow(problem);
            return;
        };
        let mut next = Self::new(problem, c, BEGIN_AGAIN * less);
        for (new, old) in next.z.iter_mut().zip(&self.z) {
            new.iter_mut().zip(old).for_each(|(new, old)| *new = larger(*new, *old));
        }
        *self = next;
    }

    /// Starts at `c`, inside all rows, with the fraction `begin` of the time as complementarity.
    fn new(problem: &Problem, c: Vec<f64>, begin: f64) -> Self {
        let mut g = problem.lists(0.0);
        problem.slacks(&c, &mut g);
        let count = g.iter().map(Vec::len).sum::<usize>() as f64;
        let product = begin * problem.time(&c) / count;
        let z = g.each_ref().map(|g| g.iter().map(|g| product / g).collect());
        let zero = || problem.lists(0.0);
        Self {
            g,
            z,
            by_g: zero(),
            ratio: zero(),
            dg: zero(),
            dz: zero(),
            complementarity: 0.0,
            count,
            newton: problem.flat(),
            factors: Pentadiagonal::zero(c.len()),
            step: vec![0.0; c.len()],
            c,
        }
    }

    /// Iterates to the fastest profile, to within the fraction `gap` of the time lost against the requested speed.
    pub(crate) fn solve(&mut self, problem: &Problem, gap: f64) {
        for _ in 0..MAX_ITERATIONS {
            self.look(problem);
            let enough = gap * problem.lost(self.newton.time);
            // Estimated gain of time from changing every coefficient alone.
            let residual: f64 = self.newton.left.iter().zip(&self.c).map(|(left, c)| left.abs() * c).sum();
            if (self.complementarity < enough && residual < enough) || !self.improve(problem, residual) {
                break;
            }
        }
    }

    /// Computes slopes and curvatures at the current iterate.
    fn look(&mut self, problem: &Problem) {
        self.complementarity = 0.0;
        for k in 0..self.g.len() {
            let (by_g, ratio) = (&mut self.by_g[k], &mut self.ratio[k]);
            for (((by, ratio), g), z) in by_g.iter_mut().zip(ratio).zip(&self.g[k]).zip(&self.z[k]) {
                *by = 1.0 / g;
                *ratio = z * *by;
            }
            let [products] = over([&self.g[k], &self.z[k]], |[g, z], [sum]| [sum + g * z]);
            self.complementarity += products.iter().sum::<f64>();
        }
        problem.newton(&self.c, &self.ratio, &self.z, &mut self.newton);
    }

    fn improve(&mut self, problem: &Problem, residual: f64) -> bool {
        let (matrix, concave) = (&self.newton.matrix, &self.newton.concave);
        // Close breaks: rounding may make the matrix indefinite.
        let tries = [(1.0, 0.0), (0.5, 0.0), (0.25, 0.0), (0.0, 0.0), (0.0, 1e-12), (0.0, 1e-9)];
        if !tries.iter().any(|(part, more)| self.factors.factor(matrix, 1.0 + more, concave, *part)) {
            return false;
        }
        // Predictor step with the target 0 for every product of slack and multiplier.
        self.head(problem, false);
        let Predicted { slack, multiplier, left } = self.predicted();
        let mean = self.complementarity / self.count;
        let centring = (left / self.complementarity).powi(2).clamp(1e-3, 0.9);
        let target = (centring * mean).max(mean.min(BALANCE * residual / self.count));
        self.correct(target, slack * multiplier);
        self.head(problem, true);
        let (slack, multiplier) = self.parts();
        self.go(problem, slack, multiplier)
    }

    /// Computes the Newton step, with the weights of the slacks' slopes in `dz` if `weighted`, and the resulting
    /// changes of slacks.
    fn head(&mut self, problem: &Problem, weighted: bool) {
        self.step.iter_mut().zip(&self.newton.slope).for_each(|(step, slope)| *step = -slope);
        if weighted {
            problem.weighted_slopes(&self.newton.steep, &self.dz, &mut self.step);
        }
        self.factors.solve(&mut self.step);
        problem.change(&self.newton, &self.step, &mut self.dg);
    }

    /// Step lengths of the predictor and the complementarity after it. Its multipliers change by `-z - ratio dg`.
    fn predicted(&self) -> Predicted {
        let (mut nearest, mut most) = (0.0, 0.0);
        let (mut first, mut second) = (0.0, 0.0);
        for k in 0..self.g.len() {
            let lists = [&self.dg[k], &self.by_g[k], &self.z[k], &self.ratio[k]];
            let [n, m, a, b] = over(lists, |[dg, by_g, z, ratio], [n, m, a, b]| {
                let by = dg * by_g;
                [larger(n, -by), larger(m, 1.0 + by), a + z * dg, b + ratio * dg * dg]
            });
            (nearest, most) = (larger(nearest, larger_of(n)), larger(most, larger_of(m)));
            first += a.iter().sum::<f64>();
            second += b.iter().sum::<f64>();
        }
        let (slack, multiplier) = (part(nearest), part(most));
        let own = self.complementarity;
        let left = own + slack * first - multiplier * (own + first) - slack * multiplier * (first + second);
        Predicted { slack, multiplier, left }
    }

    /// Sets each slack's contribution to the right side for products of `target`: `(target - part dg dz) / g`.
    fn correct(&mut self, target: f64, part: f64) {
        for k in 0..self.g.len() {
            let lists = self.dg[k].iter().zip(&self.by_g[k]).zip(&self.z[k]).zip(&self.ratio[k]);
            for (out, (((dg, by_g), z), ratio)) in self.dz[k].iter_mut().zip(lists) {
                *out = (target + part * dg * (z + ratio * dg)) * by_g;
            }
        }
    }

    fn parts(&mut self) -> (f64, f64) {
        let (mut nearest, mut most) = (0.0, 0.0);
        for k in 0..self.g.len() {
            let lists = self.dg[k].iter().zip(&self.z[k]).zip(&self.ratio[k]);
            for (dz, ((dg, z), ratio)) in self.dz[k].iter_mut().zip(lists) {
                *dz -= z + ratio * dg;
            }
            let lists = [&self.dg[k], &self.by_g[k], &self.dz[k], &self.z[k]];
            let [n, m] = over(lists, |[dg, by_g, dz, z], [n, m]| [larger(n, -dg * by_g), larger(m, -dz / z)]);
            (nearest, most) = (larger(nearest, larger_of(n)), larger(most, larger_of(m)));
        }
        (part(nearest), part(most))
    }

    fn go(&mut self, problem: &Problem, mut slack: f64, multiplier: f64) -> bool {
        let mut next = vec![0.0; self.c.len()];
        loop {
            (0..next.len()).for_each(|i| next[i] = self.c[i] + slack * self.step[i]);
            if problem.slacks(&next, &mut self.dg) && self.stays_inside() {
                break;
            }
            slack *= 0.7;
            if slack < 1e-9 {
                return false;
            }
        }
        self.c = next;
        std::mem::swap(&mut self.g, &mut self.dg);
        for (z, dz) in self.z.iter_mut().flatten().zip(self.dz.iter().flatten()) {
            *z += multiplier * dz;
        }
        true
    }

    /// True if every new slack exceeds 0.5 % of its old value.
    fn stays_inside(&self) -> bool {
        let kept =
            |(new, old): (&Vec<f64>, &Vec<f64>)| new.iter().zip(old).fold(true, |all, (n, o)| all & (*n > 0.005 * o));
        self.dg.iter().zip(&self.g).all(kept)
    }
}

/// Step lengths of the predictor, and the complementarity after it.
struct Predicted {
    slack: f64,
    multiplier: f64,
    left: f64,
}

/// The profile slowed as a whole until it satisfies every row with a margin, and the fraction by which it was slowed.
fn slowed(problem: &Problem, c: &[f64]) -> Option<(Vec<f64>, f64)> {
    let mut g = problem.lists(0.0);
    let mut less = MIN_SLOWDOWN;
    while less < 0.9 {
        let by =
            |less: f64| -> Vec<f64> { c.iter().zip(&problem.upper).map(|(c, u)| (1.0 - less) * c.min(*u)).collect() };
        let half = by(0.5 * less);
        if problem.slacks(&half, &mut g) && g.iter().flatten().all(|g| *g > 0.0) {
            return Some((by(less), less));
        }
        less *= 1.5;
    }
    None
}

/// Step length (at most 1) that keeps all values positive with a margin; `most` is the maximum relative decrease.
fn part(most: f64) -> f64 {
    if most > 0.0 { (SHORT_OF / most).min(1.0) } else { 1.0 }
}

/// Number of list elements processed together, each with its own result: always in the same order.
const LANES: usize = 4;

/// Gathers `K` results over lists of one length, one in each lane.
fn over<const N: usize, const K: usize>(
    lists: [&Vec<f64>; N],
    take: impl Fn([f64; N], [f64; K]) -> [f64; K],
) -> [[f64; LANES]; K] {
    let mut results = [[0.0; LANES]; K];
    let whole = lists[0].len() / LANES * LANES;
    let mut add = |lane: usize, values: [f64; N]| {
        let next = take(values, std::array::from_fn(|k| results[k][lane]));
        (0..K).for_each(|k| results[k][lane] = next[k]);
    };
    for i in (0..whole).step_by(LANES) {
        let block = lists.map(|list| &list[i..i + LANES]);
        (0..LANES).for_each(|lane| add(lane, block.map(|block| block[lane])));
    }
    for i in whole..lists[0].len() {
        add(i - whole, lists.map(|list| list[i]));
    }
    results
}

fn larger_of(lanes: [f64; LANES]) -> f64 {
    lanes.into_iter().fold(0.0, larger)
}
