//! Profiles against a slow optimiser of another kind: in time instead of path length, without interior points.

use super::check::check_ends;
use super::curves::Spline;
use super::random::Path;
use seamwright_geometry::numeric::bisect;
use seamwright_machine::AxisLimits;
use seamwright_motion::speed_profile::{Channels, SpeedProfile};
use seamwright_testkit::Random;

/// Number of steps of constant jerk along the path in the reference profile.
const STEPS: usize = 100;
/// Maximum relative excess over a limit of a profile that counts as found.
const FOUND: f64 = 1.5e-3;

/// Searches a profile from rest to rest in the time `duration` within all limits of `path`, a single piece. The jerks
/// along the path in equal steps of time minimise the sum of squares of the excess over limits (Levenberg-Marquardt).
/// Returns the maximum remaining excess.
fn excess(path: &Path, duration: f64, start: impl Fn(f64) -> f64) -> f64 {
    let h = duration / STEPS as f64;
    // Jerks from third differences of the start.
    let mut jerk: Vec<f64> = (0..STEPS)
        .map(|k| {
            let at = |i: f64| start(((k as f64 + i) * h).clamp(0.0, duration));
            (at(2.0) - 3.0 * at(1.0) + 3.0 * at(0.0) - at(-1.0)) / h.powi(3)
        })
        .collect();
    let (mut now, mut damping) = (Excess::new(path, duration, &jerk), 1e-3);
    for _ in 0..150 {
        if now.worst < FOUND || damping > 1e9 {
            break;
        }
        let step = now.step(damping);
        let next: Vec<f64> = jerk.iter().zip(&step).map(|(j, s)| j + s).collect();
        let then = Excess::new(path, duration, &next);
        if then.sum < now.sum {
            (jerk, now, damping) = (next, then, damping * 0.3);
        } else {
            damping *= 4.0;
        }
    }
    now.worst
}

/// Excess over the limits, with slopes by the jerks.
struct Excess {
    sum: f64,
    worst: f64,
    /// The normal equations `matrix x = -right`, by jerks times `scale`.
    matrix: Vec<f64>,
    right: Vec<f64>,
    scale: f64,
}

impl Excess {
    fn new(path: &Path, duration: f64, jerk: &[f64]) -> Self {
        let (h, (from, to)) = (duration / STEPS as f64, path.range());
        let length = to - from;
        let scale = length / duration.powi(3);
        let mut built = Self { sum: 0.0, worst: 0.0, matrix: vec![0.0; STEPS * STEPS], right: vec![0.0; STEPS], scale };
        let mut q = vec![[0.0; 3]; path.limits().len()];
        let (mut s, mut v, mut a) = (from, 0.0, 0.0);
        for (k, &j) in jerk.iter().enumerate() {
            // At its start with this step's jerk, at its end too.
            for (end, t) in [(false, 0.0), (true, h)] {
                let (s, v, a) = (s + t * (v + t * (a / 2.0 + t * j / 6.0)), v + t * (a + t * j / 2.0), a + t * j);
                path.derivatives(s.clamp(from, to), end, &mut q);
                let count = if end { k + 1 } else { k };
                let mut beyond = |value: f64, by: [f64; 4]| {
                    if value.abs() > 1.0 {
                        built.add(value.abs() - 1.0, by.map(|x| x * value.signum()), k, count, h);
                    }
                };
                for ([q1, q2, q3], l) in q.iter().zip(path.limits()) {
                    beyond(q1 * v / l.speed, [q2 * v, *q1, 0.0, 0.0].map(|x| x / l.speed));
                    let by = [q3 * v * v + q2 * a, 2.0 * q2 * v, *q1, 0.0];
                    beyond((q2 * v * v + q1 * a) / l.acceleration, by.map(|x| x / l.acceleration));
                    let value = q3 * v.powi(3) + 3.0 * q2 * v * a + q1 * j;
                    let by = [3.0 * q3 * v * a + q2 * j, 3.0 * q3 * v * v + 3.0 * q2 * a, 3.0 * q2 * v, *q1];
                    beyond(value / l.jerk, by.map(|x| x / l.jerk));
                }
                if v < 0.0 {
                    built.add(-v * duration / length, [0.0, -duration / length, 0.0, 0.0], k, count, h);
                }
            }
            (s, v, a) = (s + h * (v + h * (a / 2.0 + h * j / 6.0)), v + h * (a + h * j / 2.0), a + h * j);
        }
        let (one, two) = (duration / length, duration * duration / length);
        // The end counts for more: it is to be met.
        for (value, by) in [
            ((s - to) / length, [1.0 / length, 0.0, 0.0, 0.0]),
            (v * one, [0.0, one, 0.0, 0.0]),
            (a * two, [0.0, 0.0, two, 0.0]),
        ] {
            built.add(10.0 * value, by.map(|x| 10.0 * x), STEPS - 1, STEPS, h);
        }
        built
    }

    /// Adds an excess with its slopes by parameter, speed, acceleration and jerk after `count` steps, in step `own`.
    fn add(&mut self, value: f64, by: [f64; 4], own: usize, count: usize, h: f64) {
        self.sum += value * value;
        self.worst = self.worst.max(value.abs());
        let mut row = [0.0; STEPS];
        for (m, row) in row.iter_mut().enumerate().take(count) {
            // The jerk of step m lasts h and ends `rest` before.
            let rest = (count - 1 - m) as f64 * h;
            let (da, dv) = (h, h * (rest + h / 2.0));
            let ds = h * (rest * rest / 2.0 + rest * h / 2.0 + h * h / 6.0);
            *row = by[0] * ds + by[1] * dv + by[2] * da;
        }
        row[own] += by[3];
        row.iter_mut().for_each(|x| *x *= self.scale);
        for i in 0..STEPS {
            self.right[i] += row[i] * value;
            for k in 0..=i {
                self.matrix[i * STEPS + k] += row[i] * row[k];
            }
        }
    }

    fn step(&self, damping: f64) -> Vec<f64> {
        let n = STEPS;
        let mut l = self.matrix.clone();
        let most = (0..n).map(|i| l[i * n + i]).fold(1e-30, f64::max);
        (0..n).for_each(|i| l[i * n + i] += damping * (l[i * n + i] + 1e-6 * most) + 1e-12 * most);
        for i in 0..n {
            for k in 0..=i {
                let dot: f64 = (0..k).map(|m| l[i * n + m] * l[k * n + m]).sum();
                let rest = l[i * n + k] - dot;
                l[i * n + k] = if i == k { rest.max(1e-300).sqrt() } else { rest / l[k * n + k] };
            }
        }
        let mut x: Vec<f64> = self.right.iter().map(|r| -r).collect();
        for i in 0..n {
            let dot: f64 = (0..i).map(|k| l[i * n + k] * x[k]).sum();
            x[i] = (x[i] - dot) / l[i * n + i];
        }
        for i in (0..n).rev() {
            let dot: f64 = (i + 1..n).map(|k| l[k * n + i] * x[k]).sum();
            x[i] = (x[i] - dot) / l[i * n + i];
        }
        x.iter().map(|x| x * self.scale).collect()
    }
}

/// A single cubic piece of one to three axes, along which all kinds of limits matter.
fn curve(random: &mut Random) -> Path {
    let axes = 1 + random.below(3);
    let mut column = |size: f64| -> Vec<f64> { (0..axes).map(|_| size * random.within(-1.0, 1.0)).collect() };
    let piece = [column(30.0), column(30.0), column(20.0), column(0.0)];
    let limit = || {
        let acceleration = random.decades(20.0, 200.0);
        AxisLimits { speed: random.decades(5.0, 40.0), acceleration, jerk: acceleration * random.decades(3.0, 30.0) }
    };
    Path::free(Spline {
        knots: vec![0.0, 1.0],
        pieces: vec![piece],
        limits: std::iter::repeat_with(limit).take(axes).collect(),
    })
}

#[test]
fn at_most_two_percent_slower_than_a_slow_optimiser_in_time() {
    let mut refound = 0;
    for seed in 0..20 {
        let path = curve(&mut Random::of_case(seed));
        let profile = SpeedProfile::new(&path).unwrap();
        check_ends(&path, &profile);
        let t = profile.duration();
        let smooth = |t: f64, all: f64| {
            let x = t / all;
            x * x * x * (10.0 - x * (15.0 - 6.0 * x))
        };
        let own = |t: f64, all: f64| profile.at(t / all * profile.duration(), &mut 0).s;
        let shorter = [excess(&path, 0.98 * t, |x| smooth(x, 0.98 * t)), excess(&path, 0.98 * t, |x| own(x, 0.98 * t))];
        let longer = excess(&path, 1.01 * t, |x| smooth(x, 1.01 * t));
        assert!(shorter.iter().all(|e| *e > FOUND), "seed {seed}: a profile of {} s is possible", 0.98 * t);
        refound += u32::from(longer < FOUND);
    }
    // The reference is able to find faster profiles: it finds nearly as fast ones without ours.
    assert!(refound >= 18, "{refound} of 20");
}

/// Time of the fastest rest-to-rest motion over `length` in closed form, see Biagiotti and Melchiorri, 2008, 3.4.
fn seven_segments(length: f64, l: AxisLimits) -> f64 {
    let AxisLimits { speed: v, acceleration: a, jerk: j } = l;
    let ramp = |v: f64| if v * j < a * a { 2.0 * (v / j).sqrt() } else { v / a + a / j };
    // Acceleration and deceleration phase cover v times the time of one of them.
    if v * ramp(v) <= length {
        return ramp(v) + length / v;
    }
    2.0 * ramp(bisect(0.0, v, 200, |v| v * ramp(v) < length).0)
}

#[test]
fn straight_lines_take_as_long_as_in_closed_form() {
    let mut random = Random::of_case(1);
    for _ in 0..300 {
        let acceleration = random.decades(1.0, 1e4);
        let l = AxisLimits {
            speed: random.decades(1.0, 1e3),
            acceleration,
            jerk: acceleration * random.decades(0.5, 100.0),
        };
        let length = random.decades(1e-3, 1e4);
        // Another axis that moves along, always slower by its limits.
        let wide = l.scaled(2.0);
        let zero = || vec![0.0; 2];
        let piece = [zero(), zero(), vec![length, -length], zero()];
        let path = Path::free(Spline { knots: vec![0.0, 1.0], pieces: vec![piece], limits: vec![l, wide] });
        let profile = SpeedProfile::new(&path).unwrap();
        check_ends(&path, &profile);
        let slower = profile.duration() / seven_segments(length, l) - 1.0;
        assert!(slower > 0.0 && slower < 0.01, "{slower} for {length} mm with {l:?}");
    }
}
