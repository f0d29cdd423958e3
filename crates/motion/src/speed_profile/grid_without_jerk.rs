//! Division of a path into the cells of a profile without limits of jerk: narrow cells at low tip speed.

use super::channels::Channels;
use crate::stretch::Stretch;
use seamwright_machine::AxisLimits;

/// Number of cells per probe of the speed.
const CELLS_A_PROBE: usize = 4;
/// Minimum number of probes.
const MIN_PROBES: usize = 8;
/// Factor by which the bins at rest are repeatedly divided.
const GRADE: f64 = 0.25;
/// Number of these divisions.
const GRADES: i32 = 6;
/// Fraction of the cells spread evenly by path, not by time.
const EVEN: f64 = 0.1;
/// Minimum number of cells between two breaks.
const MIN_CELLS_BETWEEN_BREAKS: f64 = 2.0;

/// Stations (in `u`) of the `piece` of `path` between two stops: `count` cells or more, a station at each break. Most
/// are even by an estimated time from the limits of speed, of centripetal acceleration, and of acceleration and
/// deceleration phase alone.
///
/// A profile with few cells loses its time at low speed.
pub(super) fn spread(path: &dyn Channels, piece: Stretch, count: usize) -> Vec<f64> {
    let Stretch { from, to } = piece;
    let length = to - from;
    let inside = |u: &f64| *u > from + 1e-9 * length && *u < to - 1e-9 * length;
    let mut fixed: Vec<f64> = path.breaks().into_iter().filter(inside).collect();
    fixed.dedup_by(|a, b| *a - *b < 1e-9 * length);
    fixed.push(to);
    let bins = Bins::new(path, piece, count.div_ceil(CELLS_A_PROBE).max(MIN_PROBES));
    let mut stations = Vec::with_capacity(count + 2 * fixed.len() + 1);
    stations.push(from);
    let (mut begin, mut bin) = (0.0, 0);
    for end in fixed {
        let until = bins.measure(end);
        let parts = (count as f64 * (until - begin) - 1e-9).ceil().max(MIN_CELLS_BETWEEN_BREAKS);
        let step = (until - begin) / parts;
        for i in 1..parts as usize {
            stations.push(bins.place(begin + i as f64 * step, &mut bin));
        }
        stations.push(end);
        begin = until;
    }
    stations
}

struct Bins {
    edges: Vec<f64>,
    measure: Vec<f64>,
}

impl Bins {
    /// Measures the `piece` of `path` by estimated times, with `probes` of the speed.
    fn new(path: &dyn Channels, piece: Stretch, probes: usize) -> Self {
        let Stretch { from, to } = piece;
        let limits = path.limits();
        let mut row = vec![[0.0; 3]; limits.len()];
        let mut highest = |u: f64, before: bool| {
            let tip = path.derivatives(u, before, &mut row).abs();
            squared_speed_and_acceleration(&row, limits, path.asked(u) / tip)
        };
        let width = (to - from) / probes as f64;
        let ramps = [highest(from, false).1, highest(to, true).1];
        let mut edges = vec![from];
        edges.extend((1..=GRADES).rev().map(|k| from + width * GRADE.powi(k)));
        edges.extend((1..probes).map(|i| from + width * i as f64));
        edges.extend((1..=GRADES).map(|k| to - width * GRADE.powi(k)));
        edges.push(to);
        let mut times = Vec::with_capacity(edges.len());
        let (mut probe, mut by_probe) = (usize::MAX, f64::NAN);
        for w in edges.windows(2) {
            let middle = 0.5 * (w[0] + w[1]);
            let nearest = ((middle - from) / width) as usize;
            if nearest != probe {
                (probe, by_probe) = (nearest, highest(from + width * (nearest as f64 + 0.5), false).0);
            }
            let squared = by_probe.min(2.0 * ramps[0] * (middle - from)).min(2.0 * ramps[1] * (to - middle));
            times.push((w[1] - w[0]) / squared.sqrt());
        }
        let time: f64 = times.iter().sum();
        let even = if time > 0.0 && time.is_finite() { EVEN } else { 1.0 };
        let mut sum = 0.0;
        let mut measure = vec![0.0];
        for (w, t) in edges.windows(2).zip(times) {
            sum += even * (w[1] - w[0]) / (to - from) + if even < 1.0 { (1.0 - even) * t / time } else { 0.0 };
            measure.push(sum);
        }
        measure.iter_mut().for_each(|m| *m /= sum);
        Self { edges, measure }
    }

    fn measure(&self, u: f64) -> f64 {
        let i = self.edges.partition_point(|e| *e <= u).clamp(1, self.edges.len() - 1) - 1;
        let part = (u - self.edges[i]) / (self.edges[i + 1] - self.edges[i]);
        self.measure[i] + part * (self.measure[i + 1] - self.measure[i])
    }

    /// Parameter up to which the path measures `m`, which rises from call to call with `bin`.
    fn place(&self, m: f64, bin: &mut usize) -> f64 {
        while *bin + 2 < self.edges.len() && self.measure[*bin + 1] <= m {
            *bin += 1;
        }
        let part = (m - self.measure[*bin]) / (self.measure[*bin + 1] - self.measure[*bin]);
        self.edges[*bin] + part * (self.edges[*bin + 1] - self.edges[*bin])
    }
}

/// Maximum squared speed for channels with the derivatives `row`, with `asked` the maximum by the tip, and the maximum
/// acceleration from rest.
fn squared_speed_and_acceleration(row: &[[f64; 3]], limits: &[AxisLimits], asked: f64) -> (f64, f64) {
    let (mut speed, mut first, mut second) = (0.0f64, 0.0f64, 0.0f64);
    for ([q1, q2, _], l) in row.iter().zip(limits) {
        speed = speed.max(q1.abs() / l.speed);
        first = first.max(q1.abs() / l.acceleration);
        second = second.max(q2.abs() / l.acceleration);
    }
    let asked = if asked.is_nan() { f64::INFINITY } else { asked * asked };
    (asked.min(1.0 / (speed * speed)).min(1.0 / second), 1.0 / first)
}
