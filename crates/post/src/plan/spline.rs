//! Uniform cubic B-splines in time whose ends are at rest: PMAC's SPLINE1.

use super::block::{Block, Linearisation, Shape};
use super::block_cutter::{Cutting, MAX_BLOCKS};
use super::options::BRIEFEST_S;
use crate::error::Error;
use crate::even_speed::EvenSpeed;
use crate::part_program::Level;
use glam::DVec3;
use nalgebra::SVector;
use seamwright_geometry::Pose;
use seamwright_geometry::numeric::{self, tridiagonal};
use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_motion::PassMotion;
use seamwright_program::PathRange;

/// Times are multiples of this, s.
pub(crate) const TICK: f64 = 2.5e-7;
/// Shortest time of a block that the control keeps up with, s.
const SHORTEST_S: f64 = 5e-4;
/// Values that change sooner than this are late by half a block at most, s.
const STEADY_S: f64 = 0.02;
/// Minimum number of blocks of a leg at first.
const FEWEST: f64 = 6.0;
/// Stations checked within a block.
const CHECKS: u32 = 4;
/// Usable part of the tolerance at these stations.
const USED: f64 = 0.95;
/// Maximum lead or lag of a block against the plan, as a multiple of the tolerance.
const LAG: f64 = 20.0;

/// Axes and tip together: the points of the splines.
type Row = SVector<f64, { MAX_AXES + 3 }>;

/// The pass as splines, one for every leg from rest to rest: through the planned positions at all knots except the
/// first and last. Times are halved until all between is within the tolerance, and shortened until the tip keeps its
/// speed.
///
/// The control points of the spline are the start of the leg and the ends of its blocks, the first and the last three
/// times. So it takes two block times more than it has blocks. Errors: [`Error::TooFine`].
pub(crate) fn splines(
    machine: &Machine,
    motion: &PassMotion,
    breaks: &[f64],
    cutting: &Cutting,
) -> Result<Linearisation, Error> {
    let plan = Plan { machine, motion, cutting };
    let start = plan.block(&plan.row(0.0), 0.0, 0.0);
    let mut all = Linearisation { start, blocks: Vec::new(), chord_error_mm: 0.0 };
    let legs = motion.profile.legs();
    let finest = least_step(motion, breaks).max(STEADY_S).min(cutting.longest_s);
    for (i, leg) in legs.iter().enumerate() {
        let (begin, end) = (motion.profile.time(leg.from), motion.profile.time(leg.to));
        let mut count = ((end - begin) / finest).max(FEWEST).ceil();
        let (points, worst) = loop {
            let step = (end - begin) / count;
            if step < SHORTEST_S || count > MAX_BLOCKS as f64 {
                return Err(Error::TooFine { s: leg.from });
            }
            let points = plan.control_points(begin, step, count as usize - 2);
            let worst = plan.deviation(&points, begin, step);
            let fits = worst <= USED * cutting.tolerance_mm;
            if fits && plan.keeps_speed(&points, begin, step) {
                break (points, worst);
            }
            count = finer(count, end - begin, fits);
        };
        let step = (end - begin) / count;
        all.chord_error_mm = all.chord_error_mm.max(worst);
        let last = points.len() - 1;
        for (k, point) in points.iter().enumerate().skip(1) {
            let s = if k == last { leg.to } else { plan.s(begin + (k as f64 + 1.0) * step) };
            let mut block = plan.block(point, s, (step / TICK).round() * TICK);
            block.stops = k == last && i + 1 < legs.len();
            all.blocks.push(block);
        }
    }
    Ok(all)
}

/// Number of blocks, more than `count`, that a leg of `duration` s is tried with next: twice as many; where they fit the
/// path already, for the sake of the speed no more than it takes to be as brief as [`BRIEFEST_S`].
fn finer(count: f64, duration: f64, fits: bool) -> f64 {
    let limit = if fits { (duration / BRIEFEST_S).ceil() } else { f64::INFINITY };
    (2.0 * count).min(limit).max(count + 1.0)
}

/// Minimum time between positions where values change, s.
fn least_step(motion: &PassMotion, breaks: &[f64]) -> f64 {
    breaks.windows(2).map(|w| motion.profile.time(w[1]) - motion.profile.time(w[0])).fold(f64::INFINITY, f64::min)
}

struct Plan<'a> {
    machine: &'a Machine,
    motion: &'a PassMotion,
    cutting: &'a Cutting<'a>,
}

impl Plan<'_> {
    fn s(&self, t: f64) -> f64 {
        self.motion.profile.at(t, &mut 0).s
    }

    fn row(&self, s: f64) -> Row {
        let q = self.motion.path.at(s);
        let tip = self.machine.forward(&q).point.to_array();
        Row::from_fn(|i, _| if i < MAX_AXES { q[i] } else { tip[i - MAX_AXES] })
    }

    fn block(&self, row: &Row, s: f64, duration: f64) -> Block {
        let (q, tip) = split(row);
        Block { s, q, tip, duration, turns_only: false, stops: false, shape: Shape::Spline }
    }

    /// Control points, the first of them at the start of the leg. At all knots except the first and last the planned
    /// position is `(p[i - 1] + 4 p[i] + p[i + 1]) / 6`.
    fn control_points(&self, begin: f64, step: f64, moves: usize) -> Vec<Row> {
        let place = |i: usize| self.row(self.s(begin + (i as f64 + 1.0) * step));
        let first = self.row(self.s(begin));
        let last = self.row(self.s(begin + (moves as f64 + 2.0) * step));
        let known = |i: usize| {
            if i == 0 {
                first
            } else if i == moves {
                last
            } else {
                Row::zeros()
            }
        };
        let equation = |i: usize| numeric::Row::new([1.0, 4.0, 1.0], place(i) * 6.0 - known(i - 1) - known(i + 1));
        let mut points = vec![first];
        points.extend(tridiagonal((1..moves).map(equation)));
        points.push(last);
        points
    }

    /// True if the tip keeps to its planned speed inside all segments, or these are too brief to be halved.
    fn keeps_speed(&self, points: &[Row], begin: f64, step: f64) -> bool {
        let allowed = USED * self.cutting.speed;
        if step <= BRIEFEST_S || allowed.is_infinite() {
            return true;
        }
        let even = EvenSpeed::new(self.machine, self.motion, 0.0);
        let parts = EvenSpeed::parts(step);
        let last = points.len() - 1;
        let point = |i: usize| &points[i.saturating_sub(2).min(last)];
        let tip = |k: usize, f: f64| {
            let w = weights(f);
            let row: Row = (0..4).map(|j| point(k + j) * w[j]).sum();
            let (q, tip) = split(&row);
            if self.cutting.level == Level::Tip { tip } else { self.machine.forward(&q).point }
        };
        let part = 1.0 / parts as f64;
        (0..=last + 1).all(|k| {
            (0..parts).all(|c| {
                let ends = [c, c + 1].map(|c| c as f64 * part);
                let way = tip(k, ends[0]).distance(tip(k, ends[1]));
                even.deviation(ends.map(|f| begin + (k as f64 + f) * step), way).is_none_or(|off| off <= allowed)
            })
        })
    }

    /// Maximum distance of the spline from the plan, mm; lead and lag count as parts of their larger limit.
    fn deviation(&self, points: &[Row], begin: f64, step: f64) -> f64 {
        let last = points.len() - 1;
        let point = |i: usize| &points[i.saturating_sub(2).min(last)];
        let path = self.motion.tip_path(self.machine);
        let mut worst = 0.0f64;
        for k in 0..=last + 1 {
            let near = [point(k), point(k + 1), point(k + 2), point(k + 3)];
            for c in 0..CHECKS {
                let f = (f64::from(c) + 0.5) / f64::from(CHECKS);
                let w = weights(f);
                let row: Row = (0..4).map(|j| near[j] * w[j]).sum();
                let (q, tip) = split(&row);
                let mut passed = self.machine.forward(&q);
                if self.cutting.level == Level::Tip {
                    passed = Pose { point: tip, ..passed };
                }
                let planned = self.s(begin + (k as f64 + f) * step);
                let s = path.foot(passed.point, planned, PathRange::up_to(path.length()));
                let there = self.motion.path.at(s);
                worst = worst.max((passed.point - self.machine.forward(&there).point).length());
                worst = worst.max((s - planned).abs() * path.tip_rate(planned) / LAG);
                if self.cutting.second {
                    let second = self.machine.forward_of(1, &q).point - self.machine.forward_of(1, &there).point;
                    worst = worst.max(second.length());
                }
            }
            if worst > self.cutting.tolerance_mm {
                break;
            }
        }
        worst
    }
}

fn split(row: &Row) -> (Joints, DVec3) {
    (std::array::from_fn(|i| row[i]), DVec3::new(row[MAX_AXES], row[MAX_AXES + 1], row[MAX_AXES + 2]))
}

/// Weights of four control points at the part `f` of a segment of the uniform cubic B-spline.
fn weights(f: f64) -> [f64; 4] {
    let g = 1.0 - f;
    [g * g * g, 3.0 * f * f * (f - 2.0) + 4.0, 3.0 * g * g * (g - 2.0) + 4.0, f * f * f].map(|w| w / 6.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_not_halved_below_the_briefest_for_the_sake_of_speed() {
        // Of 15 ms to 10 ms, not to 7.5 ms; for the path they are.
        for (count, fits, expected) in [(66.0, true, 99.0), (66.0, false, 132.0), (10.0, true, 20.0)] {
            assert!((finer(count, 0.99, fits) - expected).abs() < 1e-9, "{count}");
        }
        for (duration, count) in
            (1..2000).flat_map(|k| [(0.0103 * f64::from(k), f64::from(k)), (0.01 * f64::from(k), 6.0)])
        {
            let next = finer(count, duration, true);
            assert!(next > count);
            let longest = BRIEFEST_S * (1.0 - 1.0 / next) - 1e-12;
            assert!(duration / next >= longest || duration / count <= BRIEFEST_S, "{duration} {count} {next}");
        }
    }
}
