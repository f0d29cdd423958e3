//! Distances along a whole motion, with bounds between samples.

use crate::error::ClearanceError;
use crate::scene::{Evaluation, Memory, Place, Scene, Watch};
use glam::DAffine3;

/// Motion of the groups of a scene, over any parameter `s` (path length, for example).
pub trait Motion {
    /// First and last parameter, the first not above the last.
    fn range(&self) -> (f64, f64);
    /// Frames of all groups at `s`, in a common frame.
    fn frames(&self, s: f64, frames: &mut [DAffine3]);
    /// An upper bound, valid everywhere in `from..=to`, of the speed (mm per unit of s) of any point of group `a`'s
    /// solids seen from group `b`. It exists since the first group of every watch is bounded.
    fn greatest_speed(&self, a: usize, b: usize, from: f64, to: f64) -> f64;
}

/// Range and resolution of the sampling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Cut-off: larger distances are only reported as at least this, mm.
    pub cutoff_mm: f64,
    /// Lower bounds may lie below the distance by this, mm, plus a tenth of the distance.
    pub precision_mm: f64,
    /// Minimum cell length, in s: shorter cells are not halved, and their bound is reported as it is.
    pub smallest: f64,
}

/// Share of a distance by which its lower bound may be smaller.
const SHARE: f64 = 0.1;

/// Clearance along a motion.
#[derive(Debug, Clone)]
pub struct Profile {
    /// The ends of the cells, one more than there are cells.
    pub edges: Vec<f64>,
    /// One trace for each watch of the scene.
    pub traces: Vec<Trace>,
    /// Stretches where a watch is violated or unproven, by watch and in the order of s.
    pub stretches: Vec<Stretch>,
}

/// One watch along the motion.
#[derive(Debug, Clone)]
pub struct Trace {
    /// One bound for each cell.
    pub cells: Vec<Cell>,
    /// The minimum distance of all samples, with its s.
    pub nearest: (f64, Evaluation),
    /// Distance at each edge, mm; NaN where no sample was taken, since the bound is sufficient.
    pub at_edges: Vec<f64>,
}

/// One watch over one cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Lower bound of the distance (or margin) in the whole cell, mm; at most the cut-off.
    pub at_least_mm: f64,
    /// Parameter of the nearer of the two samples of this bound.
    pub s: f64,
    /// Nearest points of the solids there; none beyond the cut-off.
    pub place: Option<Place>,
}

/// A part of the motion where a watch is violated or unproven.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Index of the watch.
    pub watch: usize,
    /// Start, in s. Next to a stretch the watch is proven; within it, it may hold in parts, by less than the precision.
    pub from: f64,
    /// End, in s.
    pub to: f64,
    /// Lower bound of the distance (or margin) in the whole stretch, mm.
    pub at_least_mm: f64,
    /// The sample with the minimum distance, in s. If that distance is sufficient, the watch may hold, but cells of the
    /// minimum length could not prove it.
    pub s: f64,
    /// Evaluation there.
    pub nearest: Evaluation,
}

impl Profile {
    /// The watch with the smallest bound in a cell, and its bound: the data of a plot. None without watches.
    pub fn nearest(&self, cell: usize) -> Option<(usize, &Cell)> {
        let cells = self.traces.iter().map(|t| &t.cells[cell]).enumerate();
        cells.min_by(|a, b| a.1.at_least_mm.total_cmp(&b.1.at_least_mm))
    }

    /// Lower bound of the distance of a watch at an edge, mm.
    fn bound_at(&self, watch: usize, edge: usize) -> f64 {
        let cells = &self.traces[watch].cells;
        let beside = [edge.checked_sub(1), Some(edge)].into_iter().flatten().filter_map(|cell| cells.get(cell));
        beside.map(|cell| cell.at_least_mm).fold(f64::INFINITY, f64::min)
    }
}

impl Scene {
    /// Follows a motion in `stations` cells of equal length (at least one).
    ///
    /// Guarantee: all distances in a cell are at least the cell's bound, if the motion's speed bound is right. Let two
    /// samples ds apart have the distances d0 and d1, and v bound the closing speed. All distances between them are at
    /// least `(d0 + d1 - v ds) / 2`. Cells are halved until that bound is close to the samples and on one side of the
    /// required distance. One bound covers many cells where it already is. The work is bounded by the motion's length
    /// over `limits.smallest`, for each watch.
    ///
    /// # Errors
    /// Limits that are not greater than 0.
    pub fn along(&self, motion: &impl Motion, stations: usize, limits: &Limits) -> Result<Profile, ClearanceError> {
        let numbers = [
            ("clearance-cutoff", limits.cutoff_mm),
            ("clearance-precision", limits.precision_mm),
            ("clearance-smallest-cell", limits.smallest),
        ];
        if let Some((what, _)) = numbers.into_iter().find(|n| n.1.is_nan() || n.1 <= 0.0) {
            return Err(ClearanceError::Limit { what });
        }
        let (from, to) = motion.range();
        let stations = stations.max(1);
        let mut edges: Vec<f64> = (0..stations).map(|i| from + (to - from) * (i as f64 / stations as f64)).collect();
        edges.push(to);
        let mut profile = Profile { edges, traces: Vec::new(), stretches: Vec::new() };
        for watch in 0..self.watches().len() {
            let walk = Walk::new(self, motion, watch, limits, &profile.edges);
            let (trace, stretches) = walk.run();
            profile.traces.push(trace);
            profile.stretches.extend(stretches);
        }
        Ok(profile)
    }

    /// Minimum distance or margin of all watches at each edge of a `profile` of `motion`, mm, at most `cutoff_mm`.
    ///
    /// Samples of the profile are used again, and watches whose bound is not below the minimum are left out.
    pub fn at_edges(&self, motion: &impl Motion, profile: &Profile, cutoff_mm: f64) -> Vec<f64> {
        let mut frames = vec![DAffine3::IDENTITY; self.groups().len()];
        let mut memories: Vec<Memory> = self.watches().iter().map(|_| Memory::default()).collect();
        let mut one = |(edge, s): (usize, &f64)| {
            let known = |watch: usize| profile.traces[watch].at_edges[edge];
            // NaN, the unknown, is never the smaller one.
            let mut least = (0..memories.len()).map(known).fold(cutoff_mm, f64::min);
            let mut open: Vec<(f64, usize)> = (0..memories.len())
                .filter(|watch| known(*watch).is_nan())
                .map(|watch| (profile.bound_at(watch, edge), watch))
                .filter(|(bound, _)| *bound < least)
                .collect();
            if open.is_empty() {
                return least;
            }
            motion.frames(*s, &mut frames);
            open.sort_by(|a, b| a.0.total_cmp(&b.0));
            for (bound, watch) in open {
                if bound >= least {
                    break;
                }
                let found = self.evaluate_near(watch, &frames, least.max(0.0), &mut memories[watch]);
                least = least.min(found.distance);
            }
            least
        };
        profile.edges.iter().enumerate().map(&mut one).collect()
    }
}

#[derive(Debug, Clone, Copy)]
struct Sample {
    s: f64,
    found: Evaluation,
}

struct Walk<'a, M> {
    scene: &'a Scene,
    motion: &'a M,
    watch: usize,
    limits: &'a Limits,
    edges: &'a [f64],
    /// Cut-off of evaluated distances, mm.
    limit: f64,
    frames: Vec<DAffine3>,
    memory: Memory,
    cells: Vec<Cell>,
    stretches: Vec<Stretch>,
    nearest: Option<Sample>,
    at_edges: Vec<f64>,
}

impl<'a, M: Motion> Walk<'a, M> {
    fn new(scene: &'a Scene, motion: &'a M, watch: usize, limits: &'a Limits, edges: &'a [f64]) -> Self {
        let nothing = Cell { at_least_mm: limits.cutoff_mm, s: f64::NAN, place: None };
        Self {
            scene,
            motion,
            watch,
            limits,
            edges,
            // Above the required distance with a margin for the proof; otherwise every sample would be at the limit.
            limit: limits.cutoff_mm.max(2.0 * scene.watches()[watch].least_mm() + limits.precision_mm),
            frames: vec![DAffine3::IDENTITY; scene.groups().len()],
            memory: Memory::default(),
            cells: vec![nothing; edges.len() - 1],
            stretches: Vec::new(),
            nearest: None,
            at_edges: vec![f64::NAN; edges.len()],
        }
    }

    fn run(mut self) -> (Trace, Vec<Stretch>) {
        let count = self.cells.len();
        let first = self.look_at_edge(0);
        let last = self.look_at_edge(count);
        self.between(0..count, &first, &last);
        let nearest = self.nearest.unwrap_or(first);
        let trace = Trace { cells: self.cells, nearest: (nearest.s, nearest.found), at_edges: self.at_edges };
        (trace, self.stretches)
    }

    fn look_at_edge(&mut self, edge: usize) -> Sample {
        let sample = self.look(self.edges[edge]);
        self.at_edges[edge] = sample.found.distance;
        sample
    }

    fn look(&mut self, s: f64) -> Sample {
        self.motion.frames(s, &mut self.frames);
        let found = self.scene.evaluate_near(self.watch, &self.frames, self.limit, &mut self.memory);
        let sample = Sample { s, found };
        if self.nearest.is_none_or(|n| found.distance < n.found.distance) {
            self.nearest = Some(sample);
        }
        sample
    }

    /// Lower bound of the distance between two samples, from the samples and the speed alone; it may be below 0.
    fn bound(&self, u: &Sample, v: &Sample) -> f64 {
        let (a, b) = self.scene.watches()[self.watch].groups();
        let speed = self.motion.greatest_speed(a, b, u.s, v.s);
        let bound = (u.found.distance + v.found.distance - speed * (v.s - u.s).abs()) / 2.0;
        // A NaN speed gives no bound.
        if bound.is_nan() { f64::NEG_INFINITY } else { bound.min(u.found.distance).min(v.found.distance) }
    }

    /// Settles the range between two samples: the ends of `cells`, or both in the one cell.
    fn between(&mut self, cells: std::ops::Range<usize>, u: &Sample, v: &Sample) {
        let bound = self.bound(u, v);
        let required = self.scene.watches()[self.watch].least_mm();
        let (d0, d1) = (u.found.distance, v.found.distance);
        // Over many cells the bound must be close to all distances, which reach as far above the mean as the bound lies
        // below.
        let known = if cells.len() == 1 { d0.min(d1) } else { d0 + d1 - bound }.min(self.limits.cutoff_mm);
        let near_enough = bound >= known - self.limits.precision_mm - SHARE * known.abs();
        let decided = bound >= required || (cells.len() == 1 && d0.max(d1) < required);
        // Never so short that the middle would equal an end; a NaN range also ends here.
        let smallest = self.limits.smallest.max(4.0 * f64::EPSILON * u.s.abs().max(v.s.abs()));
        let width = (v.s - u.s).abs();
        if (near_enough && decided) || (cells.len() == 1 && (width.is_nan() || width <= smallest)) {
            self.settle(cells, bound, u, v);
            return;
        }
        if cells.len() == 1 {
            let middle = self.look(u.s + (v.s - u.s) / 2.0);
            self.between(cells.clone(), u, &middle);
            self.between(cells, &middle, v);
        } else {
            let half = cells.start + cells.len() / 2;
            let middle = self.look_at_edge(half);
            self.between(cells.start..half, u, &middle);
            self.between(half..cells.end, &middle, v);
        }
    }

    fn settle(&mut self, cells: std::ops::Range<usize>, bound: f64, u: &Sample, v: &Sample) {
        // The distance of two bodies is never below 0.
        let apart = matches!(self.scene.watches()[self.watch], Watch::Apart { .. });
        let bound = if apart { bound.max(0.0) } else { bound };
        let nearer = if u.found.distance <= v.found.distance { u } else { v };
        for cell in &mut self.cells[cells] {
            let at_least_mm = bound.min(self.limits.cutoff_mm);
            if cell.s.is_nan() || at_least_mm < cell.at_least_mm {
                *cell = Cell { at_least_mm, s: nearer.s, place: nearer.found.place };
            }
        }
        if bound >= self.scene.watches()[self.watch].least_mm() {
            return;
        }
        match self.stretches.last_mut().filter(|last| last.to >= u.s) {
            Some(last) => {
                last.to = v.s;
                last.at_least_mm = last.at_least_mm.min(bound);
                if nearer.found.distance < last.nearest.distance {
                    (last.s, last.nearest) = (nearer.s, nearer.found);
                }
            }
            None => self.stretches.push(Stretch {
                watch: self.watch,
                from: u.s,
                to: v.s,
                at_least_mm: bound,
                s: nearer.s,
                nearest: nearer.found,
            }),
        }
    }
}
