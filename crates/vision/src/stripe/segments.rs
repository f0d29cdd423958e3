//! A profile as a few straight segments.
//!
//! First the whole at once, coarsely: medians of up to 128 bins, and of all ways to cut them into at most
//! [`MOST`] straight runs the one of least squares and pieces, by dynamic programming. Then, with all places, robust lines
//! in the runs without their ends, the cuts where neighbours meet, and the lines once more.

use super::fit::{Moments, StripeLine, line};
use super::profile::{Profile, Sample, median};
use glam::DVec2;

/// Most segments.
pub(super) const MOST: usize = 5;

/// Most bins, and fewest columns of one.
const BINS: usize = 128;
const BIN_COLUMNS: usize = 4;

/// What a piece more must save, in squared standard deviations of a bin.
const A_PIECE: f64 = 30.0;

/// Deviation that is put down to the steel, not to a corner: grains.
const PLAY: f64 = 0.35;

/// Columns left out beside a corner: the stripe's own width rounds it.
const ROUNDED: i32 = 6;

/// Columns that the last places of a segment are in.
const TOGETHER: i32 = 8;

/// A straight part of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The line that it is on.
    pub line: StripeLine,
    /// Its first and last column.
    pub(super) columns: (i32, i32),
    /// Deviation of its places from the line, mm.
    pub deviation: f64,
    /// Its ends on the line, mm.
    pub ends: [DVec2; 2],
}

impl Segment {
    /// Its length, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    /// How far a place on it may be from its line, mm.
    pub(super) fn within(&self, grain: f64) -> f64 {
        (4.0 * self.deviation).max(1.5 * grain)
    }
}

#[derive(Debug, Clone, Copy)]
struct Bin {
    at: DVec2,
    columns: (i32, i32),
}

/// Cuts profiles; its buffers are kept.
#[derive(Debug, Clone, Default)]
pub(super) struct Cutter {
    bins: Vec<Bin>,
    moments: Vec<Moments>,
    /// Cost of the best cut of the bins before `j` into `k` pieces, and where its last piece begins.
    costs: Vec<[(f64, u16); MOST + 1]>,
    scratch: Vec<f64>,
    other: Vec<f64>,
}

impl Cutter {
    /// Room for what a profile of so many columns can hold.
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

    /// The segments of `profile`, from left to right.
    pub(super) fn cut(&mut self, profile: &Profile, segments: &mut Vec<Segment>) {
        segments.clear();
        self.fill_bins(profile);
        if self.bins.len() < 3 {
            return;
        }
        let mut cuts = [0usize; MOST + 1];
        let pieces = self.best_cut(profile.grain, &mut cuts);
        for k in 0..pieces {
            let bins = &self.bins[cuts[k]..cuts[k + 1]];
            let columns = (bins[0].columns.0, bins[bins.len() - 1].columns.1);
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
            self.bins.push(Bin { at, columns: (first.column, inside[inside.len() - 1].column) });
        }
    }

    /// Standard deviation of a bin from its neighbours' middle.
    fn bin_deviation(&mut self) -> f64 {
        self.scratch.clear();
        let bent = |w: &[Bin]| (w[0].at.y - 2.0 * w[1].at.y + w[2].at.y).abs();
        self.scratch.extend(self.bins.windows(3).map(bent));
        median(&mut self.scratch).unwrap_or(0.0) / (0.6745 * 6f64.sqrt())
    }

    /// The best cut into straight runs: the first bin of each, and their number.
    fn best_cut(&mut self, grain: f64, cuts: &mut [usize; MOST + 1]) -> usize {
        let deviation = self.bin_deviation().clamp(PLAY * grain, 6.0 * PLAY * grain).max(1e-12);
        let origin = self.bins[0].at;
        self.moments.clear();
        self.moments.push(Moments::default());
        for bin in &self.bins {
            let last = self.moments[self.moments.len() - 1];
            self.moments.push(last.with(bin.at - origin, 1.0));
        }
        let n = self.bins.len();
        let weight = 1.0 / (deviation * deviation);
        self.costs.clear();
        self.costs.resize(n + 1, [(f64::INFINITY, 0); MOST + 1]);
        self.costs[0][0].0 = 0.0;
        for to in 2..=n {
            for from in 0..=to - 2 {
                let off = self.moments[to].less(&self.moments[from]).cost() * weight;
                for k in 0..MOST {
                    let cost = self.costs[from][k].0 + off;
                    if cost < self.costs[to][k + 1].0 {
                        self.costs[to][k + 1] = (cost, from as u16);
                    }
                }
            }
        }
        let total = |k: &usize| self.costs[n][*k].0 + A_PIECE * *k as f64;
        let pieces = (1..=MOST).min_by(|a, b| total(a).total_cmp(&total(b))).unwrap_or(1);
        cuts[pieces] = n;
        for k in (0..pieces).rev() {
            cuts[k] = usize::from(self.costs[cuts[k + 1]][k + 1].1);
        }
        pieces
    }

    /// A robust line through the columns, `trim` of them left out at both ends where enough are left.
    fn fit(
        &mut self,
        profile: &Profile,
        (from, to): (i32, i32),
        trim: i32,
        start: Option<StripeLine>,
    ) -> Option<Segment> {
        let trim = trim.min((to - from) / 4);
        let samples = profile.between(from + trim, to - trim);
        let (line, deviation) = line(samples, start, 0.3 * profile.grain, &mut self.other)?;
        let all = profile.between(from, to);
        let ends = [all.first()?, all.last()?].map(|s| line.foot(s.at));
        Some(Segment { line, columns: (from, to), deviation, ends })
    }

    /// Puts every cut where it parts the places of two segments best, and fits the lines again.
    fn move_cuts(&mut self, profile: &Profile, segments: &mut Vec<Segment>) {
        for i in 1..segments.len() {
            let (a, b) = (segments[i - 1], segments[i]);
            // No farther than into a third of either.
            let from = a.columns.1 - (a.columns.1 - a.columns.0) / 3;
            let to = b.columns.0 + (b.columns.1 - b.columns.0) / 3;
            let limit = 3.0 * a.deviation.max(b.deviation);
            let off = |line: &StripeLine, s: &Sample| line.off(s.at).abs().min(limit);
            let zone = profile.between(from, to);
            let mut cost: f64 = zone.iter().map(|s| off(&b.line, s)).sum();
            let (mut least, mut cut) = (cost, from);
            for s in zone {
                cost += off(&a.line, s) - off(&b.line, s);
                if cost < least {
                    (least, cut) = (cost, s.column + 1);
                }
            }
            let last = profile.between(from, cut - 1).last().map_or(from, |s| s.column);
            let first = profile.between(cut, to).first().map_or(to, |s| s.column);
            segments[i - 1].columns.1 = last;
            segments[i].columns.0 = first;
        }
        for segment in segments.iter_mut() {
            let refit = self.fit(profile, segment.columns, ROUNDED, Some(segment.line));
            *segment = refit.unwrap_or(*segment);
        }
        segments.iter_mut().for_each(|s| shrink(profile, s));
        segments.retain(|s| s.columns.1 > s.columns.0);
    }
}

/// Leaves the columns between the first and the last places that are on the line with two of the three after them.
fn shrink(profile: &Profile, segment: &mut Segment) {
    let samples = profile.between(segment.columns.0, segment.columns.1);
    let within = segment.within(profile.grain);
    let on = |s: &Sample| segment.line.off(s.at).abs() <= within;
    let sure = |w: &[Sample]| w[3].column - w[0].column < TOGETHER && w.iter().filter(|s| on(s)).count() >= 3;
    let first = samples.windows(4).find(|w| on(&w[0]) && sure(w)).map(|w| w[0]);
    let last = samples.windows(4).rev().find(|w| on(&w[3]) && sure(w)).map(|w| w[3]);
    if let (Some(first), Some(last)) = (first, last)
        && last.column > first.column
    {
        segment.columns = (first.column, last.column);
        segment.ends = [first, last].map(|s| segment.line.foot(s.at));
    }
}
