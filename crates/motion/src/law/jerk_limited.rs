//! The coefficients of a piece's law, with what lies between the places where rows were imposed checked.

use super::cells::{Cells, PARTS};
use super::interior::fastest;
use super::problem::Problem;

/// The law is planned with limits smaller by this part: for what lies between the places checked, and so that a hold has
/// room to begin (see `pace`).
pub(crate) const RESERVE: f64 = 1e-3;
/// Times the law is solved again with less room where a limit was passed.
const ROUNDS: usize = 4;
/// The law is this part of its time within the best that the method can find.
const GAP: f64 = 1e-6;
/// Coefficients nearer to the asked speed than this part are put on it.
const SNAP: f64 = 1e-5;

/// Coefficients of the squared speed by `tau`, see [`Problem`].
pub(crate) fn coefficients(cells: &Cells) -> Vec<f64> {
    let count = cells.count();
    let [up, down] = cells.map.borders();
    let mut room = vec![1.0 - RESERVE; count];
    let mut dense: Vec<bool> = (0..count).map(|i| cells.tau[i] < up || cells.tau[i + 1] > down).collect();
    let mut before: Option<Vec<f64>> = None;
    for round in 0..=ROUNDS {
        let problem = Problem::new(cells, &room, &dense);
        let start = match before.take() {
            Some(c) => slowed(&problem, c),
            None => vec![0.5 * problem.greatest_constant(); problem.unknowns],
        };
        let mut c = fastest(&problem, start, GAP);
        snap(&mut c, &problem.upper);
        let mut worst: f64 = 0.0;
        for i in 0..count {
            let most = peak(cells, &c, i);
            worst = worst.max(most);
            if most > 1.0 - 0.5 * RESERVE {
                let around = i.saturating_sub(1)..(i + 2).min(count);
                let less = (1.0 - RESERVE) / most;
                room[around.clone()].iter_mut().for_each(|r| *r = r.min((1.0 - RESERVE) * less * less));
                dense[around].iter_mut().for_each(|d| *d = true);
            }
        }
        if worst <= 1.0 - 0.5 * RESERVE {
            return c;
        }
        if round == ROUNDS {
            // Slowing the whole law never violates a symmetric limit.
            c.iter_mut().for_each(|c| *c *= (1.0 - RESERVE) / (worst * worst));
            return c;
        }
        before = Some(c);
    }
    Vec::new()
}

/// The law slowed as a whole until it satisfies every row with some room.
fn slowed(problem: &Problem, mut c: Vec<f64>) -> Vec<f64> {
    let mut g = vec![0.0; problem.slacks];
    loop {
        c.iter_mut().zip(&problem.upper).for_each(|(c, u)| *c = (0.95 * *c).min(0.95 * u));
        if problem.slacks(&c, &mut g) && g.iter().all(|g| *g > 0.0) {
            return c;
        }
    }
}

/// Coefficients all but at the asked speed are put on it: a constant speed is to be exactly that.
fn snap(c: &mut [f64], upper: &[f64]) {
    for (c, u) in c.iter_mut().zip(upper).filter(|(c, u)| **c > (1.0 - SNAP) * **u) {
        *c = *u;
    }
}

/// The greatest use of a limit in cell `i`: of a speed (squared), an acceleration or a jerk. Between the [`PARTS`] a
/// parabola through three neighbours each, and what their third differences leave open.
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
    most
}

/// Greatest size of a smooth function known at five evenly spaced places, between them too.
fn greatest(f: &[f64; PARTS.len()]) -> f64 {
    let mut most = f.iter().map(|v| v.abs()).fold(0.0, f64::max);
    let mut bend: f64 = 0.0;
    for i in 1..PARTS.len() - 1 {
        let (slope, second) = (0.5 * (f[i + 1] - f[i - 1]), f[i + 1] - 2.0 * f[i] + f[i - 1]);
        let vertex = -slope / second;
        if vertex.abs() <= 1.0 {
            most = most.max((f[i] + 0.5 * slope * vertex).abs());
        }
        if i > 1 {
            bend = bend.max((f[i + 1] - 3.0 * f[i] + 3.0 * f[i - 1] - f[i - 2]).abs());
        }
    }
    most + 0.07 * bend
}
