//! Distances along a whole motion, with bounds between samples.

use crate::error::ClearanceError;
use crate::scene::{Evaluation, Memory, Place, Scene, Watch};
use glam::DAffine3;
use std::collections::VecDeque;
use std::ops::Range;

/// Motion of the groups of a scene, over any parameter `s` (path length, for example).
pub trait Motion {
    /// First and last parameter, the first not above the last.
    fn range(&self) -> (f64, f64);
    /// Frames of all groups at `s`, in a common frame.
    fn frames(&self, s: f64, frames: &mut [DAffine3]);
    /// An upper bound, valid everywhere in `from..=to`, of the speed (mm per unit of s) of any point of group `a`'s
    /// solids seen from group `b`. It exists since the first group of every watch is bounded.
    fn greatest_speed(&self, a: usize, b: usize, from: f64, to: f64) -> f64;

    /// An upper bound, valid everywhere in `from..=to`, of the distance (mm) of any point of group `a`'s solids, seen
    /// from group `b`, from where it would be if it moved straight and evenly from its place at `from` to that at `to`.
    ///
    /// By default that of a motion of which only the maximum speed is known.
    fn greatest_bend(&self, a: usize, b: usize, from: f64, to: f64) -> f64 {
        self.greatest_speed(a, b, from, to) * (to - from) / 2.0
    }
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

impl Limits {
    fn check(&self) -> Result<(), ClearanceError> {
        let numbers = [
            ("clearance-cutoff", self.cutoff_mm),
            ("clearance-precision", self.precision_mm),
            ("clearance-smallest-cell", self.smallest),
        ];
        let bad = numbers.into_iter().find(|n| n.1.is_nan() || n.1 <= 0.0);
        bad.map_or(Ok(()), |(what, _)| Err(ClearanceError::Limit { what }))
    }
}

/// Share of a distance by which its lower bound may be smaller.
const SHARE: f64 = 0.1;
/// Share of the precision by which the minimum distance may be smaller than the smallest sample.
const NEAREST: f64 = 0.1;
/// Number of times a part of the motion is halved for the smallest sample: a bound on the work, not tuned.
const HALVINGS: u32 = 3;
/// Length of the longest sweep, as a multiple of the distance: longer ones are halved first. It changes the time only, and
/// is not tuned.
const LONGEST_SWEEP: f64 = 4.0;

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
    /// One bound for each cell. Where another watch is nearer, the bound may be as low as the distance of that one.
    pub cells: Vec<Cell>,
    /// The minimum distance of all samples, with its s. Where another watch is nearer, there may be no samples.
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
    /// least `(d0 + d1 - v ds) / 2`. They are also at least the distance of the bodies swept on straight lines between
    /// the two samples, less the motion's bend there. Cells are halved until the greater bound is close to the samples
    /// and on one side of the required distance. One bound covers many cells where it already is. The work is bounded by
    /// the motion's length over `limits.smallest`, for each watch. Parts that may have a distance below the smallest sample
    /// of all watches, by more than a tenth of the precision, are halved up to three times more.
    ///
    /// # Errors
    /// Limits that are not greater than 0.
    pub fn along(&self, motion: &impl Motion, stations: usize, limits: &Limits) -> Result<Profile, ClearanceError> {
        limits.check()?;
        let (from, to) = motion.range();
        let stations = stations.max(1);
        let mut edges: Vec<f64> = (0..stations).map(|i| from + (to - from) * (i as f64 / stations as f64)).collect();
        edges.push(to);
        let mut walks: Vec<_> = (0..self.watches().len()).map(|w| Walk::new(self, motion, w, limits, &edges)).collect();
        let ends: Vec<[Sample; 2]> = walks.iter_mut().map(Walk::ends).collect();
        // The nearest first: the others need only be shown to be farther.
        let at_ends =
            |watch: &usize| ends[*watch].map(|end| end.found.distance).into_iter().fold(f64::INFINITY, f64::min);
        let mut order: Vec<usize> = (0..walks.len()).collect();
        order.sort_by(|a, b| at_ends(a).total_cmp(&at_ends(b)));
        let mut nearer = vec![f64::INFINITY; stations];
        for watch in order {
            let [first, last] = &ends[watch];
            walks[watch].between(0..stations, first, last, &mut nearer);
        }
        let least = walks.iter().map(Walk::least).fold(f64::INFINITY, f64::min);
        walks.iter_mut().for_each(|walk| walk.sharpen(least));
        let mut profile = Profile { edges: edges.clone(), traces: Vec::new(), stretches: Vec::new() };
        for (walk, [first, _]) in walks.into_iter().zip(&ends) {
            let nearest = walk.nearest.unwrap_or(*first);
            let nearest = (nearest.s, nearest.found);
            profile.traces.push(Trace { cells: walk.cells, nearest, at_edges: walk.at_edges });
            profile.stretches.extend(walk.stretches);
        }
        Ok(profile)
    }

    /// Returns true if every watch is proven along the whole motion, as by [`Scene::along`], which also shows where and by
    /// how much. It is faster, and ends at the first sample below a minimum.
    ///
    /// # Errors
    /// Limits that are not greater than 0.
    pub fn is_clear_along(&self, motion: &impl Motion, limits: &Limits) -> Result<bool, ClearanceError> {
        limits.check()?;
        let (from, to) = motion.range();
        let edges = [from, to];
        let mut walks: Vec<_> = (0..self.watches().len()).map(|w| Walk::new(self, motion, w, limits, &edges)).collect();
        let ends: Vec<[Sample; 2]> = walks.iter_mut().map(Walk::ends).collect();
        let is_near = |(walk, [u, v]): (&Walk<_>, &[Sample; 2])| !(walk.is_kept(u) && walk.is_kept(v));
        if walks.iter().zip(&ends).any(is_near) {
            return Ok(false);
        }
        Ok(walks.iter_mut().zip(ends).all(|(walk, ends)| walk.is_clear(ends)))
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
    /// Pose of the first group in the frame of the second.
    seen: DAffine3,
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
    /// Parts of the motion whose bound is below the smallest sample then.
    open: Vec<[Sample; 2]>,
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
            open: Vec::new(),
        }
    }

    fn ends(&mut self) -> [Sample; 2] {
        [0, self.cells.len()].map(|edge| self.look_at_edge(edge))
    }

    /// True if a sample has the required distance.
    fn is_kept(&self, sample: &Sample) -> bool {
        sample.found.distance >= self.scene.watches()[self.watch].least_mm()
    }

    /// True if the watch is proven between two samples that have the required distance. The longest parts come first,
    /// since an obstacle is found soonest by samples far from one another.
    fn is_clear(&mut self, ends: [Sample; 2]) -> bool {
        let required = self.scene.watches()[self.watch].least_mm();
        let mut open = VecDeque::from([ends]);
        while let Some([u, v]) = open.pop_front() {
            if self.is_at_least(required, &u, &v) {
                continue;
            }
            if self.is_smallest(&u, &v) {
                return false;
            }
            let middle = self.look(u.s + (v.s - u.s) / 2.0);
            if !self.is_kept(&middle) {
                return false;
            }
            open.extend([[u, middle], [middle, v]]);
        }
        true
    }

    /// The minimum distance of all samples, mm.
    fn least(&self) -> f64 {
        self.nearest.map_or(f64::INFINITY, |nearest| nearest.found.distance)
    }

    /// Bound above which a part of the motion has no distance that matters for the smallest sample, mm: any, while all
    /// samples are beyond the cut-off.
    fn beyond(&self, least: f64) -> f64 {
        if least < self.limits.cutoff_mm { least - NEAREST * self.limits.precision_mm } else { f64::NEG_INFINITY }
    }

    /// Looks for distances below `least`, the minimum of all watches' samples.
    fn sharpen(&mut self, least: f64) {
        let mut open: Vec<([Sample; 2], u32)> = self.open.drain(..).map(|part| (part, HALVINGS)).collect();
        while let Some(([u, v], left)) = open.pop() {
            let needed = self.beyond(least.min(self.least()));
            if self.is_at_least(needed, &u, &v) || left == 0 || self.is_smallest(&u, &v) {
                continue;
            }
            let middle = self.look(u.s + (v.s - u.s) / 2.0);
            open.extend([([u, middle], left - 1), ([middle, v], left - 1)]);
        }
    }

    fn look_at_edge(&mut self, edge: usize) -> Sample {
        let sample = self.look(self.edges[edge]);
        self.at_edges[edge] = sample.found.distance;
        sample
    }

    fn look(&mut self, s: f64) -> Sample {
        self.motion.frames(s, &mut self.frames);
        let found = self.scene.evaluate_near(self.watch, &self.frames, self.limit, &mut self.memory);
        let (a, b) = self.scene.watches()[self.watch].groups();
        let sample = Sample { s, found, seen: self.frames[b].inverse() * self.frames[a] };
        if self.nearest.is_none_or(|n| found.distance < n.found.distance) {
            self.nearest = Some(sample);
        }
        sample
    }

    /// Upper bound of the displacement of any point of the first group between two samples, mm.
    fn travel(&self, u: &Sample, v: &Sample) -> f64 {
        let (a, b) = self.scene.watches()[self.watch].groups();
        self.motion.greatest_speed(a, b, u.s, v.s) * (v.s - u.s).abs()
    }

    /// True if all distances between two samples are proven to be at least `needed`.
    fn is_at_least(&mut self, needed: f64, u: &Sample, v: &Sample) -> bool {
        let travel = self.travel(u, v);
        Self::bound(u, v, travel) >= needed || self.swept(u, v, travel, needed).is_some_and(|bound| bound >= needed)
    }

    /// Lower bound of the distance between two samples, from the samples and the travel alone; it may be below 0.
    fn bound(u: &Sample, v: &Sample, travel: f64) -> f64 {
        let bound = (u.found.distance + v.found.distance - travel) / 2.0;
        // A NaN speed gives no bound.
        if bound.is_nan() { f64::NEG_INFINITY } else { bound.min(u.found.distance).min(v.found.distance) }
    }

    /// Lower bound of the distance between two samples from the bodies swept between them; it may be below 0. None if
    /// that could not reach `needed`, and for ways much longer than the distance: swept bodies so long are near to a large
    /// part of the others.
    fn swept(&mut self, u: &Sample, v: &Sample, travel: f64, needed: f64) -> Option<f64> {
        let nearer = u.found.distance.min(v.found.distance);
        let is_short = travel <= LONGEST_SWEEP * nearer;
        if !is_short {
            return None;
        }
        let (a, b) = self.scene.watches()[self.watch].groups();
        let bend = self.motion.greatest_bend(a, b, u.s, v.s);
        let is_of_use = nearer - bend >= needed;
        if !is_of_use {
            return None;
        }
        Some(self.scene.swept(self.watch, &u.seen, &v.seen, nearer, &mut self.memory)? - bend)
    }

    /// True if the range between two samples is not halved: never so short that the middle would equal an end. A NaN range
    /// is one, too.
    fn is_smallest(&self, u: &Sample, v: &Sample) -> bool {
        let smallest = self.limits.smallest.max(4.0 * f64::EPSILON * u.s.abs().max(v.s.abs()));
        let width = (v.s - u.s).abs();
        width.is_nan() || width <= smallest
    }

    /// Settles the range between two samples: the ends of `cells`, or both in the one cell. `nearer` holds, for each cell,
    /// a distance that a watch before this one does not exceed somewhere in it.
    fn between(&mut self, cells: Range<usize>, u: &Sample, v: &Sample, nearer: &mut [f64]) {
        let travel = self.travel(u, v);
        let mut bound = Self::bound(u, v, travel);
        let required = self.scene.watches()[self.watch].least_mm();
        let (d0, d1) = (u.found.distance, v.found.distance);
        // Over many cells the bound must be close to all distances, which reach as far above the mean as the bound lies
        // below.
        let known = if cells.len() == 1 { d0.min(d1) } else { d0 + d1 - bound }.min(self.limits.cutoff_mm);
        let close = known - self.limits.precision_mm - SHARE * known.abs();
        let violated = cells.len() == 1 && d0.max(d1) < required;
        let others = nearer[cells.clone()].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let needed = if violated { close } else { close.min(others).max(required) };
        if bound < needed && cells.len() == 1 {
            bound = self.swept(u, v, travel, needed).map_or(bound, |swept| swept.max(bound));
        }
        if bound >= needed || (cells.len() == 1 && self.is_smallest(u, v)) {
            let most = if cells.len() == 1 { d0.max(d1) } else { d0 + d1 - bound };
            nearer[cells.clone()].iter_mut().for_each(|distance| *distance = distance.min(most));
            self.settle(cells, bound, u, v);
            return;
        }
        if cells.len() == 1 {
            let middle = self.look(u.s + (v.s - u.s) / 2.0);
            self.between(cells.clone(), u, &middle, nearer);
            self.between(cells, &middle, v, nearer);
        } else {
            let half = cells.start + cells.len() / 2;
            let middle = self.look_at_edge(half);
            self.between(cells.start..half, u, &middle, nearer);
            self.between(half..cells.end, &middle, v, nearer);
        }
    }

    fn settle(&mut self, cells: Range<usize>, bound: f64, u: &Sample, v: &Sample) {
        // The distance of two bodies is never below 0.
        let apart = matches!(self.scene.watches()[self.watch], Watch::Apart { .. });
        if apart && bound < self.beyond(self.least()) {
            self.open.push([*u, *v]);
        }
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
