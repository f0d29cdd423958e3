use super::arcs::{Arcs, Normal, through};
use super::block::{Block, Linearisation, Shape, Speeds};
use super::course::Course;
use crate::error::Error;
use crate::even_speed::EvenSpeed;
use crate::feed::MIN_FEED;
use crate::part_program::Level;
use crate::polynomial::{Evenly, Polynomial};
use glam::DVec3;
use seamwright_machine::{AxisKind, Joints, Machine};
use seamwright_motion::{PassMotion, TipPath};

/// Parts of a block at whose ends it is compared with the exact path.
pub(super) const CHECKS: usize = 16;
/// Usable part of the tolerance at these stations. Between them the deviation grows by up to `(1/16)^2` of the
/// tolerance if it has one hump, and by four times that with two.
const USED: f64 = 0.98;
/// Shortest block, mm.
const SHORTEST_MM: f64 = 1e-4;
/// Maximum number of blocks in a pass: controls refuse larger part programs.
pub(super) const MAX_BLOCKS: usize = 2_000_000;
/// An arc is looked for if one this much longer than the line is good.
const LONGER: f64 = 1.2;
/// Linear motion that may be left to a later block, as a part of the tolerance. The cutter's own tolerance is smaller
/// by as much.
pub(crate) const HELD_BACK: f64 = 0.05;
/// Safety factor of feeds over the minimum feed.
const MARGIN: f64 = 1.2;
/// Turns smaller than this (rad) are lost in the words' decimals.
const TURN: f64 = 1e-7;

/// Settings that cut a pass into blocks.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Cutting<'a> {
    /// Level at which the control interpolates.
    pub(crate) level: Level,
    /// Maximum distance from the planned path, mm.
    pub(crate) tolerance_mm: f64,
    /// Maximum deviation of the tip's speed from the planned one inside a block, as a part of that.
    pub(crate) speed: f64,
    /// Whether the control raises feeds below [`MIN_FEED`].
    pub(crate) least_feed: bool,
    /// Kind of blocks other than arcs.
    pub(crate) base: Kind,
    pub(crate) arcs: Arcs,
    /// Axes X, Y and Z, for arcs at joint level.
    pub(crate) xyz: [Option<usize>; 3],
    /// Longest time of a block, s.
    pub(crate) longest_s: f64,
    /// Process values that go evenly within blocks.
    pub(crate) course: Option<&'a Course<'a>>,
    /// Whether a second torch welds too.
    pub(crate) second: bool,
}

impl Cutting<'_> {
    fn lines(level: Level, tolerance_mm: f64) -> Self {
        Self {
            level,
            tolerance_mm,
            speed: f64::INFINITY,
            least_feed: true,
            base: Kind::Line,
            arcs: Arcs::None,
            xyz: [None; 3],
            longest_s: f64::INFINITY,
            course: None,
            second: false,
        }
    }
}

/// Cuts `motion` into few straight blocks for LinuxCNC. Their path stays within `tolerance_mm` of the planned one of
/// the tip: the seam, except for blends at corners. Each block is as long as tolerance, timing, torch attitude and the
/// control's minimum feed permit.
///
/// Ends of spans (`breaks`, mm) and corners at which the torch stops always end a block.
///
/// # Errors
/// [`Error::TooFine`], [`Error::NoTip`].
pub fn linearise(
    machine: &Machine,
    motion: &PassMotion,
    breaks: &[f64],
    level: Level,
    tolerance_mm: f64,
) -> Result<Linearisation, Error> {
    cut(machine, motion, breaks, &Cutting::lines(level, tolerance_mm))
}

/// The same in the blocks that `cutting` allows: from each station on the longer of the farthest good line and arc.
pub(crate) fn cut(
    machine: &Machine,
    motion: &PassMotion,
    breaks: &[f64],
    cutting: &Cutting,
) -> Result<Linearisation, Error> {
    let path = motion.tip_path(machine);
    let even = EvenSpeed::new(machine, motion, 0.0);
    let mut cutter =
        Cutter { machine, path, motion, cutting, tolerance: USED * cutting.tolerance_mm, ends: (0.0, 0.0), even };
    let mut here = cutter.end_at(0.0, 0.0);
    // The last position whose linear words were written.
    let mut written = here;
    let mut cut = Linearisation { start: here, blocks: Vec::new(), chord_error_mm: 0.0 };
    let stops: Vec<f64> = motion.profile.legs().iter().skip(1).map(|leg| leg.from).collect();
    let mut ends: Vec<f64> = breaks.iter().chain(&stops).copied().filter(|s| *s > 0.0 && *s < path.length()).collect();
    ends.sort_by(f64::total_cmp);
    ends.push(path.length());
    let mut length = 1.0;
    for end in ends {
        let leg = stops.partition_point(|s| *s <= here.s);
        let leg_end = stops.get(leg).copied().unwrap_or(path.length());
        cutter.ends = (if leg == 0 { 0.0 } else { stops[leg - 1] }, leg_end);
        while here.s < end {
            let mut block = cutter.next(Start { here: &here, written: &written }, end, length);
            if (block.s - here.s < SHORTEST_MM && block.s < end) || cut.blocks.len() >= MAX_BLOCKS {
                return Err(Error::TooFine { s: here.s });
            }
            block.turns_only = cutting.least_feed
                && block.shape == Shape::Line
                && cutter.below_least_feed(&written, &block)
                && cutter.turns(&here, &block);
            if !block.turns_only {
                written = block;
            }
            block.stops = stops.contains(&block.s);
            cut.chord_error_mm = cut.chord_error_mm.max(cutter.chord_error(&here, &block));
            if !matches!(block.shape, Shape::Arc(_)) {
                length = block.s - here.s;
            }
            cut.blocks.push(block);
            here = block;
        }
    }
    Ok(cut)
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    /// Straight.
    Line,
    /// Cubics in time.
    Cubic,
    /// Cubics that are gone along evenly.
    Curve,
    Arc(Normal),
}

#[derive(Clone, Copy)]
struct Start<'a> {
    /// The last block, which ends here.
    here: &'a Block,
    /// The last block whose linear words were written.
    written: &'a Block,
}

/// Search for the end of a block.
#[derive(Clone, Copy)]
struct Search {
    /// Maximum path length of the end, mm.
    end: f64,
    /// First length tried, mm.
    guess: f64,
    /// Number of checks within a block.
    checks: usize,
}

pub(super) struct Cutter<'a> {
    pub(super) machine: &'a Machine,
    pub(super) path: TipPath<'a>,
    pub(super) motion: &'a PassMotion,
    pub(super) cutting: &'a Cutting<'a>,
    pub(super) tolerance: f64,
    /// Path lengths between which the torch does not stop.
    ends: (f64, f64),
    /// Comparison of the tip's speed with the plan.
    pub(super) even: EvenSpeed<'a>,
}

impl Cutter<'_> {
    fn end_at(&self, s: f64, before: f64) -> Block {
        let q = self.motion.path.at(s);
        let duration = self.motion.profile.time(s) - self.motion.profile.time(before);
        let tip = self.machine.forward(&q).point;
        Block { s, q, tip, duration, turns_only: false, stops: false, shape: Shape::Line }
    }

    fn block(&self, kind: Kind, here: &Block, s: f64) -> Option<Block> {
        let mut block = self.end_at(s, here.s);
        block.shape = match kind {
            Kind::Line => Shape::Line,
            Kind::Cubic => Shape::Hermite { from: self.speeds(here.s, false), to: self.speeds(s, true) },
            Kind::Curve => self.curve(here, &block),
            Kind::Arc(normal) => {
                let time = self.motion.profile.time(here.s) + 0.5 * block.duration;
                let middle = self.end_at(self.motion.profile.at(time, &mut 0).s, here.s);
                Shape::Arc(through(self.place(here), self.place(&middle), self.place(&block), normal)?)
            }
        };
        Some(block)
    }

    /// The cubic with the path's directions at both ends; only the control's own channels are bent.
    fn curve(&self, here: &Block, block: &Block) -> Shape {
        let slopes = |s: f64, before: bool| self.slopes(s, before, block.s - here.s);
        let (from, to) = (slopes(here.s, false), slopes(block.s, true));
        let tip = self.cutting.level == Level::Tip;
        let cubic = |a: f64, va: f64, b: f64, vb: f64| {
            let higher = [3.0 * (b - a) - 2.0 * va - vb, va + vb - 2.0 * (b - a), 0.0, 0.0];
            Polynomial { from: a, to: b, higher }
        };
        let axes = self.machine.axes.iter().enumerate().filter(|(_, axis)| !tip || axis.kind == AxisKind::Rotary);
        let axes = axes.map(|(i, axis)| {
            let [a, va, b, vb] = [here.q[i], from.q[i], block.q[i], to.q[i]].map(|value| axis.to_file(value));
            cubic(a, va, b, vb)
        });
        let place = (0..3).filter(|_| tip).map(|k| cubic(here.tip[k], from.tip[k], block.tip[k], to.tip[k]));
        Shape::Curve { from, to, evenly: Evenly::new(axes.chain(place)) }
    }

    /// Derivatives by path length at `s`, as they are before or behind it, times `rate`.
    fn slopes(&self, s: f64, before: bool, rate: f64) -> Speeds {
        let point = self.motion.path.point(s, before);
        let rest = Joints::default();
        let tip = self.machine.tip_derivatives(&[point.q, point.d1, rest, rest], 0.0)[0];
        Speeds { q: point.d1.map(|d| d * rate), tip: tip * rate }
    }

    /// Speeds by the plan at `s`, as they are before or behind it.
    fn speeds(&self, s: f64, before: bool) -> Speeds {
        if s <= self.ends.0 || s >= self.ends.1 {
            return Speeds::default();
        }
        self.slopes(s, before, self.motion.profile.speed(s))
    }

    /// X, Y and Z that the control moves, mm.
    pub(super) fn place(&self, at: &Block) -> DVec3 {
        match self.cutting.level {
            Level::Tip => at.tip,
            Level::Joint => DVec3::from_array(self.cutting.xyz.map(|i| i.map_or(0.0, |i| at.q[i]))),
        }
    }

    /// The longest good block from `start`, not beyond `end`; `guess` is the length of the last one.
    fn next(&self, start: Start, end: f64, guess: f64) -> Block {
        let (here, base) = (start.here, self.cutting.base);
        let s = self.farthest(base, start, Search { end, guess, checks: CHECKS });
        let line = self.turned_back(start, s);
        // A line from rest has no history, so halves of a line so short are no good for an arc.
        let length = (line - here.s).max(SHORTEST_MM);
        let tried = (here.s + LONGER * length).min(end);
        let mut best = (line, base);
        for normal in self.cutting.arcs.normals().iter().filter(|_| tried > line) {
            let kind = Kind::Arc(*normal);
            if !self.tried(kind, start, tried, CHECKS) {
                continue;
            }
            // The checks are as dense as within a line, so that no wave slips through between them.
            let fine = |to: f64| (CHECKS as f64 / 4.0 * (to - here.s) / length).max(CHECKS as f64) as usize;
            let mut far = tried;
            while far < end {
                let next = (here.s + 2.0 * (far - here.s)).min(end);
                let search = Search { end: next, guess: next - here.s, checks: fine(next) };
                let reached = self.farthest(kind, start, search);
                let stuck = reached < next;
                far = far.max(reached);
                if stuck {
                    break;
                }
            }
            if far > best.0 {
                best = (far, kind);
            }
        }
        self.block(best.1, here, best.0).unwrap_or_else(|| self.end_at(best.0, here.s))
    }

    /// True if the block of a kind to `s` exists and is good.
    fn tried(&self, kind: Kind, start: Start, s: f64, checks: usize) -> bool {
        self.block(kind, start.here, s)
            .is_some_and(|block| self.good(start.here, &block, checks) && self.feed_is_kept(start, &block))
    }

    /// The farthest end of a good block.
    fn farthest(&self, kind: Kind, start: Start, search: Search) -> f64 {
        let Search { end, guess, checks } = search;
        let here = start.here;
        let good = |s: f64| self.tried(kind, start, s, checks);
        let mut length = guess.max(SHORTEST_MM);
        // Grow until bad, or shrink until good, then halve the bracket.
        while here.s + length < end && good(here.s + length) {
            length *= 2.0;
        }
        let mut bad = (here.s + length).min(end);
        if bad >= end && good(end) {
            return end;
        }
        let mut ok = here.s;
        while bad - ok > 1e-3 * (ok - here.s).max(SHORTEST_MM) {
            let middle = 0.5 * (ok + bad);
            if good(middle) { ok = middle } else { bad = middle }
        }
        ok
    }

    /// The middle of a block to `end`, if linear motion goes out and back in it: the whole would be left out as too
    /// small, though either half has enough. Otherwise `end`.
    fn turned_back(&self, start: Start, end: f64) -> f64 {
        let Start { here, written } = start;
        if !self.cutting.least_feed {
            return end;
        }
        let middle = self.end_at(0.5 * (here.s + end), here.s);
        let lost = self.below_least_feed(written, &self.end_at(end, here.s));
        let halved = lost && middle.s - here.s > SHORTEST_MM && !self.below_least_feed(written, &middle);
        if halved && self.good(here, &middle, CHECKS) { middle.s } else { end }
    }

    /// True if the control will not run the block faster than planned: its feed is above the minimum, or its linear
    /// motion is small enough to be left to a later block.
    fn feed_is_kept(&self, start: Start, b: &Block) -> bool {
        let Start { here, written } = start;
        if !self.cutting.least_feed {
            return true;
        }
        match b.shape {
            // An arc must start at the position of the last words.
            Shape::Arc(arc) => {
                let way = arc.length(self.place(here), self.place(b));
                written.s >= here.s && way / b.duration * 60.0 >= MARGIN * MIN_FEED
            }
            _ => !self.below_least_feed(written, b) || self.linear(written, b) <= HELD_BACK * self.tolerance,
        }
    }

    /// True if the control would raise the block's feed, counted from the last linear words `written`.
    fn below_least_feed(&self, written: &Block, b: &Block) -> bool {
        self.linear(written, b) / b.duration * 60.0 < MARGIN * MIN_FEED
    }

    /// True if a rotary axis moves in the block by more than the resolution of its words.
    fn turns(&self, a: &Block, b: &Block) -> bool {
        let axes = self.machine.axes.iter().zip(a.q.iter().zip(&b.q));
        axes.filter(|(x, _)| x.kind == AxisKind::Rotary).any(|(_, (a, b))| (a - b).abs() > TURN)
    }

    /// Length of linear motion as the control will see it, mm.
    fn linear(&self, a: &Block, b: &Block) -> f64 {
        match self.cutting.level {
            Level::Tip => (b.tip - a.tip).length(),
            Level::Joint => {
                let axes = self.machine.axes.iter().zip(a.q.iter().zip(&b.q));
                axes.filter(|(x, _)| x.kind == AxisKind::Linear).map(|(_, (a, b))| (b - a).powi(2)).sum::<f64>().sqrt()
            }
        }
    }
}
