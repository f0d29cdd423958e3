use super::random::{Random, ranges};
use crate::chain::Joints;
use crate::machine::Machine;
use glam::{DMat3, DVec3};
use serde::Serialize;
use std::collections::VecDeque;

/// Voxels along each side of the box.
pub(super) const SIDE: usize = 20;
/// Tolerance of a reached point, as a fraction of the box' diagonal.
const REACHED: f64 = 1e-7;
/// Maximum number of steps towards a point.
const STEPS: usize = 60;

/// Part of space that the tip can reach, by one random point in each of 20 x 20 x 20 voxels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Volume {
    /// 3 for a volume (mm^3), 2 for an area (mm^2), 1 for a length (mm), 0 for a point: the box is flat in the others.
    pub dimensions: u32,
    /// The reached measure.
    pub measure: f64,
    /// One standard deviation of it, from the voxels at the edge.
    pub deviation: f64,
    /// The reached fraction of the box.
    pub part_of_box: f64,
}

struct Grid {
    low: DVec3,
    size: DVec3,
    counts: [usize; 3],
}

impl Grid {
    fn new([low, high]: [DVec3; 2]) -> Self {
        let size = high - low;
        let flat = 1e-9 * size.length().max(1.0);
        Self { low, size, counts: std::array::from_fn(|i| if size[i] > flat { SIDE } else { 1 }) }
    }

    fn count(&self) -> usize {
        self.counts.iter().product()
    }

    fn place(&self, index: usize) -> [usize; 3] {
        [index % self.counts[0], index / self.counts[0] % self.counts[1], index / self.counts[0] / self.counts[1]]
    }

    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        i + self.counts[0] * (j + self.counts[1] * k)
    }

    fn of(&self, p: DVec3) -> usize {
        self.index(std::array::from_fn(|i| {
            let part = (p[i] - self.low[i]) / self.size[i].max(1e-300) * self.counts[i] as f64;
            (part.max(0.0) as usize).min(self.counts[i] - 1)
        }))
    }

    fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> {
        let place = self.place(index);
        (0..6).filter_map(move |side| {
            let (axis, up) = (side / 2, side % 2 == 1);
            let mut next = place;
            next[axis] = if up { place[axis] + 1 } else { place[axis].checked_sub(1)? };
            (next[axis] < self.counts[axis]).then(|| self.index(next))
        })
    }

    fn point(&self, index: usize, random: &mut Random) -> DVec3 {
        let place = self.place(index);
        let part = |i: usize, r: f64| self.low[i] + self.size[i] * (place[i] as f64 + r) / self.counts[i] as f64;
        let flat = |i: usize, r: f64| if self.counts[i] == 1 { 0.5 } else { r };
        let r = [random.unit(), random.unit(), random.unit()];
        DVec3::new(part(0, flat(0, r[0])), part(1, flat(1, r[1])), part(2, flat(2, r[2])))
    }
}

/// Solves for one random point in each voxel, from the nearest voxel with known positions, then again from neighbours.
pub(super) fn volume(
    machine: &Machine,
    samples: &[(Joints, DVec3)],
    around: [DVec3; 2],
    random: &mut Random,
    step: &mut dyn FnMut(),
) -> Volume {
    let grid = Grid::new(around);
    let near = REACHED * grid.size.length().max(1e-6);
    let mut starts: Vec<Option<Joints>> = vec![None; grid.count()];
    samples.iter().for_each(|(q, p)| starts[grid.of(*p)] = Some(*q));
    let mut queue: VecDeque<usize> = (0..grid.count()).filter(|&i| starts[i].is_some()).collect();
    let points: Vec<DVec3> = (0..grid.count()).map(|i| grid.point(i, random)).collect();
    let mut reached = vec![false; grid.count()];
    while let Some(i) = queue.pop_front() {
        step();
        let Some(start) = starts[i] else { continue };
        let (q, off) = towards(machine, &start, points[i], near);
        (reached[i], starts[i]) = (off <= near, Some(q));
        for n in grid.neighbours(i) {
            if starts[n].is_none() {
                starts[n] = Some(q);
                queue.push_back(n);
            }
        }
    }
    for i in 0..grid.count() {
        for n in grid.neighbours(i).filter(|n| reached[*n]).collect::<Vec<_>>() {
            let (false, Some(start)) = (reached[i], starts[n]) else { break };
            reached[i] = towards(machine, &start, points[i], near).1 <= near;
        }
    }
    measured(&grid, &reached)
}

fn measured(grid: &Grid, reached: &[bool]) -> Volume {
    let sides: Vec<f64> = (0..3).filter(|&i| grid.counts[i] > 1).map(|i| grid.size[i]).collect();
    let whole: f64 = sides.iter().product();
    let hit = reached.iter().filter(|r| **r).count();
    let edge = (0..grid.count()).filter(|&i| grid.neighbours(i).any(|n| reached[n] != reached[i])).count();
    let cells = grid.count() as f64;
    Volume {
        dimensions: sides.len() as u32,
        measure: whole * hit as f64 / cells,
        // A voxel at the edge is inside or outside by chance.
        deviation: whole * (0.25 * edge as f64).sqrt() / cells,
        part_of_box: hit as f64 / cells,
    }
}

/// Moves from `start` towards `point` within the ranges by damped Gauss-Newton steps, without axes that push against
/// the end of their range. Returns the final positions and the remaining distance.
fn towards(machine: &Machine, start: &Joints, point: DVec3, enough: f64) -> (Joints, f64) {
    let ranges = ranges(machine);
    let mut q = *start;
    let mut off = point - machine.forward(&q).point;
    let mut damping = 1e-6;
    for _ in 0..STEPS {
        if off.length() <= enough || damping > 1e6 {
            break;
        }
        let columns = machine.jacobian(&q);
        let next = stepped(&ranges, &q, |axis| columns[axis].0, off, damping);
        let there = point - machine.forward(&next).point;
        if there.length() < off.length() * (1.0 - 1e-6) {
            (q, off) = (next, there);
            damping = (damping * 0.1).max(1e-9);
        } else {
            damping = damping.max(1e-6) * 30.0;
        }
    }
    (q, off.length())
}

/// The damped step of minimum length, relative to the ranges and within their ends.
fn stepped(ranges: &[(f64, f64)], q: &Joints, column: impl Fn(usize) -> DVec3, off: DVec3, damping: f64) -> Joints {
    let mut stopped = vec![false; ranges.len()];
    let mut next = *q;
    for _ in 0..ranges.len() {
        let mut gram = DMat3::ZERO;
        let mut trace = 0.0;
        for (axis, (low, high)) in ranges.iter().enumerate().filter(|(axis, _)| !stopped[*axis]) {
            let c = (high - low) * column(axis);
            gram += DMat3::from_cols(c.x * c, c.y * c, c.z * c);
            trace += c.length_squared();
        }
        let weights = (gram + DMat3::from_diagonal(DVec3::splat((damping + 1e-12) * trace.max(1e-12)))).inverse() * off;
        let mut any = false;
        for (axis, (low, high)) in ranges.iter().enumerate() {
            if stopped[axis] {
                continue;
            }
            let step = (high - low).powi(2) * column(axis).dot(weights);
            stopped[axis] = (q[axis] <= *low && step < 0.0) || (q[axis] >= *high && step > 0.0);
            next[axis] = if stopped[axis] { q[axis] } else { (q[axis] + step).clamp(*low, *high) };
            any |= stopped[axis];
        }
        if !any {
            break;
        }
    }
    next
}
