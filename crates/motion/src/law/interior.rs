//! The fastest law under limits of speed, acceleration and jerk: a primal-dual interior-point method.

use super::lanes::larger;
use super::pentadiagonal::Pentadiagonal;
use super::problem::{Lists, Newton, Problem};

/// Iterations after which the law reached is taken as it is: it satisfies every row at any time.
const MOST: usize = 120;
/// Part of the way to the next row that a step may go.
const SHORT_OF: f64 = 0.99;
/// Complementarity to begin with, as a part of the time, at a law known before that was slowed by a part of its squared
/// speed: this many times that part; and if its multipliers are known too.
const BEGIN_NEAR: f64 = 2.0;
const BEGIN_AGAIN: f64 = 0.1;
/// Complementarity to begin with at a slow law.
const BEGIN: f64 = 0.1;
/// Complementarity falls to this part of what the slopes leave at most: faster, and rows would stop the law far from
/// the fastest one.
const BALANCE: f64 = 0.3;
/// A law known before is slowed by this part at least.
const LEAST_SLOWED: f64 = 0.01;

/// A law on its way to the fastest one: coefficients with the slacks and multipliers of all rows.
///
/// Mehrotra's predictor and corrector on the time with the rows of [`Problem`] as logarithmic barriers. The rows of
/// jerk are not convex (`1 / sqrt(b)` curves the wrong way): their curvature is kept as long as the matrix stays
/// positive, and halved until it is. Every step is shortened until the true slacks are positive, so that each iterate
/// satisfies the rows. A local method: no bad local optimum is known, none is excluded.
pub(crate) struct Iterate {
    c: Vec<f64>,
    /// Slacks, and one by each.
    g: Lists,
    by_g: Lists,
    /// Multipliers, and multipliers by slacks.
    z: Lists,
    ratio: Lists,
    /// Changes of slacks, and what the right side gets of each, later changes of multipliers.
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
    /// Half the greatest constant speed that satisfies every row.
    pub(crate) fn slow(problem: &Problem) -> Self {
        Self::new(problem, vec![0.5 * problem.greatest_constant(); problem.unknowns], BEGIN)
    }

    /// A law known before, slowed as a whole until it satisfies every row.
    pub(crate) fn near(problem: &Problem, c: &[f64]) -> Self {
        match slowed(problem, c) {
            Some((c, less)) => Self::new(problem, c, BEGIN_NEAR * less),
            None => Self::slow(problem),
        }
    }

    /// Goes on after the problem was tightened: at the law reached, slowed as far as is needed.
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

    /// At `c`, inside all rows, with the part `begin` of the time as complementarity.
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

    /// The coefficients reached.
    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.c
    }

    /// Goes on to the fastest law, to within the part `gap` of the time it loses against the asked speed.
    pub(crate) fn solve(&mut self, problem: &Problem, gap: f64) {
        for _ in 0..MOST {
            self.look(problem);
            let enough = gap * problem.lost(self.newton.time);
            // What changing every coefficient by itself would gain, as a time.
            let residual: f64 = self.newton.left.iter().zip(&self.c).map(|(left, c)| left.abs() * c).sum();
            if (self.complementarity < enough && residual < enough) || !self.improve(problem, residual) {
                break;
            }
        }
    }

    /// Slopes and curvatures where it is.
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

    /// One step; false if it could not be made.
    fn improve(&mut self, problem: &Problem, residual: f64) -> bool {
        let (matrix, concave) = (&self.newton.matrix, &self.newton.concave);
        // Beside breaks next to each other rounding may cost the matrix its sign.
        let tries = [(1.0, 0.0), (0.5, 0.0), (0.25, 0.0), (0.0, 0.0), (0.0, 1e-12), (0.0, 1e-9)];
        if !tries.iter().any(|(part, more)| self.factors.factor(matrix, 1.0 + more, concave, *part)) {
            return false;
        }
        // The predictor: as if every product of slack and multiplier were to vanish.
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

    /// The Newton step for the weights of the slacks' slopes in `dz`, if `weighted`, and the changes of slacks with it.
    fn head(&mut self, problem: &Problem, weighted: bool) {
        self.step.iter_mut().zip(&self.newton.slope).for_each(|(step, slope)| *step = -slope);
        if weighted {
            problem.weighted_slopes(&self.newton.steep, &self.dz, &mut self.step);
        }
        self.factors.solve(&mut self.step);
        problem.change(&self.newton, &self.step, &mut self.dg);
    }

    /// How far the predictor's step can go, and what complementarity it leaves. Its multipliers change by
    /// `-z - ratio dg`.
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

    /// What the right side gets of each slack, so that products become `target`: `(target - part dg dz) / g`.
    fn correct(&mut self, target: f64, part: f64) {
        for k in 0..self.g.len() {
            let lists = self.dg[k].iter().zip(&self.by_g[k]).zip(&self.z[k]).zip(&self.ratio[k]);
            for (out, (((dg, by_g), z), ratio)) in self.dz[k].iter_mut().zip(lists) {
                *out = (target + part * dg * (z + ratio * dg)) * by_g;
            }
        }
    }

    /// Sets the changes of the multipliers, and says how much of the changes of slacks and of multipliers can be gone.
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

    /// Goes the step, shortened until the true slacks are positive.
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

    /// Whether the slacks to be are all positive, and none next to nothing of what it was.
    fn stays_inside(&self) -> bool {
        let kept =
            |(new, old): (&Vec<f64>, &Vec<f64>)| new.iter().zip(old).fold(true, |all, (n, o)| all & (*n > 0.005 * o));
        self.dg.iter().zip(&self.g).all(kept)
    }
}

/// How far the predictor's step goes, and the complementarity after it.
struct Predicted {
    slack: f64,
    multiplier: f64,
    left: f64,
}

/// The law slowed as a whole until it satisfies every row with some room, and by which part.
fn slowed(problem: &Problem, c: &[f64]) -> Option<(Vec<f64>, f64)> {
    let mut g = problem.lists(0.0);
    let mut less = LEAST_SLOWED;
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

/// The part of a change (at most 1) that leaves everything positive, a little short of it, where `most` is the
/// greatest loss by what there is.
fn part(most: f64) -> f64 {
    if most > 0.0 { (SHORT_OF / most).min(1.0) } else { 1.0 }
}

/// Lists are gone through this many at once, with results for each: always in the same order.
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
