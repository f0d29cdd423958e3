//! Seeded random paths of every kind.

use super::curves::Spline;
use seamwright_machine::AxisLimits;
use seamwright_motion::speed_profile::Channels;
use seamwright_testkit::Random;

/// A spline with a requested speed of its tip, the first `tip` axes, and its parameter scaled.
pub struct Path {
    pub spline: Spline,
    pub tip: usize,
    /// Requested speeds, each from its parameter on.
    pub asked: Vec<(f64, f64)>,
    pub breaks: Vec<f64>,
}

impl Path {
    /// A spline without a requested speed.
    pub fn free(spline: Spline) -> Self {
        let breaks = spline.breaks();
        Self { spline, tip: 0, asked: vec![(f64::NEG_INFINITY, f64::INFINITY)], breaks }
    }
}

impl Channels for Path {
    fn range(&self) -> (f64, f64) {
        self.spline.range()
    }

    fn limits(&self) -> &[AxisLimits] {
        &self.spline.limits
    }

    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        self.spline.derivatives(u, before, out);
        out[..self.tip].iter().map(|d| d[0] * d[0]).sum::<f64>().sqrt()
    }

    fn asked(&self, u: f64) -> f64 {
        self.asked[self.asked.partition_point(|(from, _)| *from <= u).max(1) - 1].1
    }

    fn breaks(&self) -> Vec<f64> {
        self.breaks.clone()
    }
}

/// The natural cubic spline through `points` (one list of values a channel) at `knots`.
pub fn natural(knots: Vec<f64>, points: &[Vec<f64>], limits: Vec<AxisLimits>) -> Spline {
    let count = knots.len() - 1;
    let h: Vec<f64> = knots.windows(2).map(|w| w[1] - w[0]).collect();
    let mut pieces = vec![std::array::from_fn(|_| vec![0.0; points.len()]); count];
    for (axis, y) in points.iter().enumerate() {
        let slope: Vec<f64> = (0..count).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
        // Second derivatives by Thomas' algorithm.
        let (mut second, mut over) = (vec![0.0; count + 1], vec![0.0; count + 1]);
        for i in 1..count {
            let pivot = 2.0 * (h[i - 1] + h[i]) - h[i - 1] * over[i - 1];
            over[i] = h[i] / pivot;
            second[i] = (6.0 * (slope[i] - slope[i - 1]) - h[i - 1] * second[i - 1]) / pivot;
        }
        for i in (1..count).rev() {
            second[i] -= over[i] * second[i + 1];
        }
        for i in 0..count {
            let piece: &mut [Vec<f64>; 4] = &mut pieces[i];
            piece[0][axis] = (second[i + 1] - second[i]) / (6.0 * h[i]);
            piece[1][axis] = 0.5 * second[i];
            piece[2][axis] = slope[i] - h[i] * (2.0 * second[i] + second[i + 1]) / 6.0;
            piece[3][axis] = y[i];
        }
    }
    Spline { knots, pieces, limits }
}

fn values(random: &mut Random, parts: &[f64]) -> Vec<f64> {
    let size = random.decades(1e-2, 1e3);
    let rise = size * random.within(-1.0, 1.0);
    let wiggle = match random.below(10) {
        0 => return vec![0.3 * size; parts.len()],
        1 | 2 => 0.0,
        3 => 1e-6,
        4 => 1e-3,
        _ => random.decades(1e-2, 1.0),
    };
    parts.iter().map(|x| rise * x + size * wiggle * random.within(-1.0, 1.0)).collect()
}

/// Random limits: acceleration reached in 1 ms to 10 s, its jerk in 10 ms to 2 s.
fn limits(random: &mut Random) -> AxisLimits {
    let speed = random.decades(1e-1, 1e3);
    let acceleration = speed * random.decades(0.1, 1e3);
    AxisLimits { speed, acceleration, jerk: acceleration * random.decades(0.5, 100.0) }
}

pub fn path(random: &mut Random, most_axes: usize, most_pieces: usize) -> Path {
    let axes = 1 + random.below(most_axes);
    let pieces = 1 + random.below(most_pieces);
    let scale = random.decades(1e-6, 1e6);
    let start = if random.below(3) == 0 { scale * random.within(-3.0, 3.0) } else { 0.0 };
    // Even, uneven, or very uneven.
    let uneven = [0.0, 1.0, 4.0][random.below(3)];
    let mut parts = vec![0.0];
    for _ in 0..pieces {
        let width = random.within(0.0, uneven).exp();
        parts.push(parts[parts.len() - 1] + width);
    }
    let length = parts[parts.len() - 1];
    parts.iter_mut().for_each(|p| *p /= length);
    let mut points: Vec<Vec<f64>> = (0..axes).map(|_| values(random, &parts)).collect();
    if points.iter().all(|p| p.iter().all(|v| (v - p[0]).abs() < 1e-12)) {
        points[0] = parts.clone();
    }
    let limits = (0..axes).map(|_| limits(random)).collect();
    let spline = natural(parts.iter().map(|p| start + scale * p).collect(), &points, limits);
    let mut path = Path::free(spline);
    if random.below(2) == 0 {
        ask(random, &mut path);
    }
    path
}

fn ask(random: &mut Random, path: &mut Path) {
    path.tip = path.limits().len().min(3);
    let (from, to) = path.range();
    let fastest = path.limits()[..path.tip].iter().map(|l| l.speed).fold(f64::INFINITY, f64::min);
    for _ in 0..random.below(3) {
        path.breaks.push(random.within(from, to));
    }
    path.breaks.sort_by(f64::total_cmp);
    for i in 0..=path.breaks.len() {
        let begin = if i == 0 { f64::NEG_INFINITY } else { path.breaks[i - 1] };
        let speed = fastest * random.decades(1e-2, 10.0);
        if i == 0 {
            path.asked[0].1 = speed;
        } else if random.below(2) == 0 {
            path.asked.push((begin, speed));
        }
    }
}
