//! Approximation of a profile by a few straight segments.
//!
//! The first pass is coarse: medians of up to 128 bins are cut into at most [`MAX_SEGMENTS`] straight runs. Dynamic
//! programming minimises the squared distances plus a cost per run. The second pass uses all points: it fits robust
//! lines in the runs without their ends, moves the cuts to where neighbours meet, and fits the lines again.

use super::fit::{Moments, StripeLine, line};
use super::profile::{Columns, Profile, Sample, median, within};
use glam::DVec2;

/// Maximum number of segments.
pub(super) const MAX_SEGMENTS: usize = 5;

/// Maximum number of bins, and minimum columns per bin.
const BINS: usize = 128;
const BIN_COLUMNS: usize = 4;

/// Cost of an additional piece, in squared standard deviations of a bin.
const A_PIECE: f64 = 30.0;

/// Deviation attributed to the surface's grain instead of a corner.
const PLAY: f64 = 0.35;

/// Columns left out beside a corner, which the stripe's own width rounds.
const ROUNDED: i32 = 6;

/// Maximum columns that span the last points of a segment.
const TOGETHER: i32 = 8;

/// A straight part of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The line of the segment.
    pub line: StripeLine,
    pub(super) columns: Columns,
    /// Deviation of the points from the line, mm.
    pub deviation: f64,
    /// End points on the line, mm.
    pub ends: [DVec2; 2],
}

impl Segment {
    /// Returns the length, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    /// Returns the maximum distance of a point on the segment from its line, mm.
    pub(super) fn within(&self, grain: f64) -> f64 {
        (4.0 * self.deviation).max(1.5 * grain)
    }
}

#[derive(Debug, Clone, Copy)]
struct Bin {
    at: DVec2,
    columns: Columns,
}

/// Cuts profiles; reuses its buffers.
#[derive(Debug, Clone, Default)]
pub(super) struct Cutter {
    bins: Vec<Bin>,
    moments: Vec<Moments>,
    /// Cost of the best cut of the bins before `j` into `k` pieces, and the start of its last piece.
    costs: Vec<[(f64, u16); MAX_SEGMENTS + 1]>,
    scratch: Vec<f64>,
    other: Vec<f64>,
}

impl Cutter {
    /// Reserves capacity for a profile of this many columns.
    pub(super) fn reserve(&mut self, columns: usize) {
        self.bins.clear();
        self.bins.reserve(BINS + 2);
        self.moments.clear();
        self.moments.reserve(BINS + 3);
        self.costs.clear();
        self.costs.reserve(BINS + 3);
        for scratch in [&mut self.scratch, &mut self.other] {
            scratch.clear();
            scratch.reserve(columns);
        }
    }

    /// Finds the segments of `profile`, from left to right.
    pub(super) fn cut(&mut self, profile: &Profile, segments: &mut Vec<Segment>) {
        segments.clear();
        self.fill_bins(profile);
        if self.bins.len() < 3 {
            return;
        }
        let mut cuts = [0usize; MAX_SEGMENTS + 1];
        let pieces = self.best_cut(profile.grain, &mut cuts);
        for k in 0..pieces {
            let bins = &self.bins[cuts[k]..cuts[k + 1]];
            let columns = Columns { from: bins[0].columns.from, to: bins[bins.len() - 1].columns.to };
            if let Some(segment) = self.fit(profile, columns, 0, None) {
                segments.push(segment);
            }
        }
        for _ in 0..2 {
            self.move_cuts(profile, segments);
        }
    }

    fn fill_bins(&mut self, profile: &Profile) {
        self.bins.clear();
        let size = profile.columns().div_ceil(BINS).max(BIN_COLUMNS) as i32;
        let mut rest = &profile.samples[..];
        while let Some(first) = rest.first() {
            let end = (first.column / size + 1) * size;
            let (inside, after) = rest.split_at(rest.partition_point(|s| s.column < end));
            rest = after;
            if (inside.len() as i32) < (size / 4).max(2) {
                continue;
            }
            let mut middle = |of: fn(&Sample) -> f64| {
                self.scratch.clear();
                self.scratch.extend(inside.iter().map(of));
                median(&mut self.scratch).unwrap_or(0.0)
            };
            let at = DVec2::new(middle(|s| s.at.x), middle(|s| s.at.y));
            let columns = Columns { from: first.column, to: inside[inside.len() - 1].column };
            self.bins.push(Bin { at, columns });
        }
    }

    /// Returns the standard deviation of a bin from its neighbours' middle.
    fn bin_deviation(&mut self) -> f64 {
        self.scratch.clear();
        let bent = |w: &[Bin]| (w[0].at.y - 2.0 * w[1].at.y + w[2].at.y).abs();
        self.scratch.extend(self.bins.windows(3).map(bent));
        median(&mut self.scratch).unwrap_or(0.0) / (0.6745 * 6f64.sqrt())
    }

    /// Finds the best cut into straight runs: the first bin of each; returns their number.
    fn best_cut(&mut self, grain: f64, cuts: &mut [usize; MAX_SEGMENTS + 1]) -> usize {
        let deviation = self.bin_deviation().clamp(PLAY * grain, 6.0 * PLAY * grain).max(1e-12);
        let origin = self.bins[0].at;
        self.moments.clear();
        self.moments.push(Moments::default());
        for bin in &self.bins {
            self.moments.push(self.moments[self.moments.len() - 1].with(bin.at - origin, 1.0));
        }
        let n = self.bins.len();
        let weight = 1.0 / (deviation * deviation);
        self.costs.clear();
        self.costs.resize(n + 1, [(f64::INFINITY, 0); MAX_SEGMENTS + 1]);
        self.costs[0][0].0 = 0.0;
        for to in 2..=n {
            for from in 0..=to - 2 {
                let off = self.moments[to].less(&self.moments[from]).cost() * weight;
                for k in 0..MAX_SEGMENTS {
                    let cost = self.costs[from][k].0 + off;
                    if cost < self.costs[to][k + 1].0 {
                        self.costs[to][k + 1] = (cost, from as u16);
                    }
                }
            }
        }
        let total = |k: &usize| self.costs[n][*k].0 + A_PIECE * *k as f64;
        let pieces = (1..=MAX_SEGMENTS).min_by(|a, b| total(a).total_cmp(&total(b))).unwrap_or(1);
        cuts[pieces] = n;
        for k in (0..pieces).rev() {
            cuts[k] = usize::from(self.costs[cuts[k + 1]][k + 1].1);
        }
        pieces
    }

    /// Fits a robust line through the columns, without up to `trim` of them at either end.
    fn fit(&mut self, profile: &Profile, columns: Columns, trim: i32, start: Option<StripeLine>) -> Option<Segment> {
        let Columns { from, to } = columns;
        let trim = trim.min((to - from) / 4);
        let samples = profile.between(Columns { from: from + trim, to: to - trim });
        let (line, deviation) = line(samples, start, 0.3 * profile.grain, &mut self.other)?;
        let all = profile.between(columns);
        let ends = [all.first()?, all.last()?].map(|s| line.foot(s.at));
        Some(Segment { line, columns, deviation, ends })
    }

    /// Moves every cut to the best separation of two segments' points, and fits the lines again.
    fn move_cuts(&mut self, profile: &Profile, segments: &mut Vec<Segment>) {
        for i in 1..segments.len() {
            let (a, b) = (segments[i - 1], segments[i]);
            // At most into a third of either.
            let from = a.columns.to - (a.columns.to - a.columns.from) / 3;
            let to = b.columns.from + (b.columns.to - b.columns.from) / 3;
            let limit = 3.0 * a.deviation.max(b.deviation);
            let off = |line: &StripeLine, s: &Sample| line.off(s.at).abs().min(limit);
            let zone = profile.between(Columns { from, to });
            let mut cost: f64 = zone.iter().map(|s| off(&b.line, s)).sum();
            let (mut least, mut cut) = (cost, from);
            for s in zone {
                cost += off(&a.line, s) - off(&b.line, s);
                if cost < least {
                    (least, cut) = (cost, s.column + 1);
                }
            }
            let last = profile.between(Columns { from, to: cut - 1 }).last().map_or(from, |s| s.column);
            let first = profile.between(Columns { from: cut, to }).first().map_or(to, |s| s.column);
            segments[i - 1].columns.to = last;
            segments[i].columns.from = first;
        }
        for segment in segments.iter_mut() {
            *segment = self.fit(profile, segment.columns, ROUNDED, Some(segment.line)).unwrap_or(*segment);
        }
        segments.iter_mut().for_each(|s| shrink(profile, s));
        segments.retain(|s| s.columns.to > s.columns.from);
    }
}

impl Profile {
    /// Replaces points by another blob of their column that lies on a longer line than their own. Returns true if any
    /// point changed.
    pub(super) fn repick(&mut self, segments: &[Segment]) -> bool {
        let (mut changed, grain) = (false, self.grain);
        for segment in segments {
            let longer = || segments.iter().filter(|g| g.length() > 1.5 * segment.length());
            if longer().next().is_none() {
                continue;
            }
            let on_longer = |at: DVec2| longer().any(|g| g.line.off(at).abs() < g.within(grain));
            let Columns { from, to } = segment.columns;
            let first = self.samples.partition_point(|s| s.column < from);
            let end = self.samples.partition_point(|s| s.column <= to).max(first);
            let mut rest = within(&self.all, segment.columns);
            for sample in &mut self.samples[first..end] {
                rest = &rest[rest.iter().take_while(|s| s.column < sample.column).count()..];
                let mut own = rest.iter().take_while(|s| s.column == sample.column);
                if let Some(other) = own.find(|s| s.at != sample.at && on_longer(s.at)) {
                    *sample = *other;
                    changed = true;
                }
            }
        }
        changed
    }
}

/// Shrinks the columns to the first and last point on the line. Two of the next three points inwards must be on it too.
fn shrink(profile: &Profile, segment: &mut Segment) {
    let samples = profile.between(segment.columns);
    let within = segment.within(profile.grain);
    let on = |s: &Sample| segment.line.off(s.at).abs() <= within;
    let sure = |w: &[Sample]| w[3].column - w[0].column < TOGETHER && w.iter().filter(|s| on(s)).count() >= 3;
    let first = samples.windows(4).find(|w| on(&w[0]) && sure(w)).map(|w| w[0]);
    let last = samples.windows(4).rev().find(|w| on(&w[3]) && sure(w)).map(|w| w[3]);
    if let (Some(first), Some(last)) = (first, last)
        && last.column > first.column
    {
        segment.columns = Columns { from: first.column, to: last.column };
        segment.ends = [first, last].map(|s| segment.line.foot(s.at));
    }
}
