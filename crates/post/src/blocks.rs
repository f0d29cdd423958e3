use crate::feed::LEAST_FEED;
use crate::{Error, Level};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine};
use seamwright_motion::{PassMotion, TipPath};
use seamwright_program::TorchPath;

/// End of a block: where the axes are, where the tip is, and how long the block took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Path length at its end, mm.
    pub s: f64,
    /// Axis positions at its end, mm or rad.
    pub q: Joints,
    /// Torch tip at its end in the work frame, mm.
    pub tip: DVec3,
    /// Duration by the plan, s.
    pub duration: f64,
    /// True if the block only turns: its linear motion is too small for the control's least feed and is left to a later
    /// block.
    pub turns_only: bool,
    /// True if the torch stops at its end, at a corner.
    pub stops: bool,
}

/// A pass cut into blocks.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearisation {
    /// Where the first block begins (with no duration).
    pub start: Block,
    /// The blocks.
    pub blocks: Vec<Block>,
    /// Greatest distance found between the path of the blocks and the planned one of the tip, mm.
    pub chord_error_mm: f64,
}

/// Parts of a block at whose ends it is compared with the exact path.
const CHECKS: usize = 16;
/// What may be used of the tolerance at these places: between them the path of the blocks strays up to
/// `(1/16)^2` of the tolerance more where the deviation has one hump, and four times that where it has two.
const USED: f64 = 0.98;
/// How far along the seam, or the way of a weaving tip, a block may run ahead of the plan or behind it, as a multiple of
/// the chord tolerance.
const LAG: f64 = 20.0;
/// Largest deviation of the torch's attitude within a block, rad.
const ATTITUDE: f64 = 0.1 * std::f64::consts::PI / 180.0;
/// Shortest block, mm.
const SHORTEST_MM: f64 = 1e-4;
/// Linear motion that may be left to a later block, as a part of the tolerance. The cutter's own tolerance is smaller
/// by as much.
pub(crate) const HELD_BACK: f64 = 0.05;
/// Turns smaller than this (rad) are lost in the words' decimals.
const TURN: f64 = 1e-7;

/// Cuts `motion` into few blocks whose path stays within `tolerance_mm` of the planned one of the tip (the seam, but
/// for blends at corners): greedily, each block as long as tolerance, timing, attitude and the control's least feed let
/// it be.
///
/// Places where spans end (`breaks`, mm) and corners at which the torch stops always end a block.
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
    let path = motion.tip_path(machine);
    let cutter = Cutter { machine, path, motion, level, tolerance: USED * tolerance_mm };
    if level == Level::Tip && !["x", "y", "z"].iter().all(|n| machine.axis(n).is_some()) {
        return Err(Error::NoTip);
    }
    let mut here = cutter.end_at(0.0, 0.0);
    // The last place whose linear words were written.
    let mut written = here;
    let mut cut = Linearisation { start: here, blocks: Vec::new(), chord_error_mm: 0.0 };
    let stops: Vec<f64> = motion.law.legs().iter().skip(1).map(|leg| leg.from).collect();
    let mut ends: Vec<f64> = breaks.iter().chain(&stops).copied().filter(|s| *s > 0.0 && *s < path.length()).collect();
    ends.sort_by(f64::total_cmp);
    ends.push(path.length());
    let mut length = 1.0;
    for end in ends {
        while here.s < end {
            let next = cutter.farthest(&here, &written, end, length);
            if next - here.s < SHORTEST_MM && next < end {
                return Err(Error::TooFine { s: here.s });
            }
            let next = cutter.turned_back(&here, &written, next);
            let mut block = cutter.end_at(next, here.s);
            block.turns_only = cutter.below_least_feed(&written, &block) && cutter.turns(&here, &block);
            if !block.turns_only {
                written = block;
            }
            block.stops = stops.contains(&next);
            cut.chord_error_mm = cut.chord_error_mm.max(cutter.chord_error(&here, &block).0);
            length = next - here.s;
            cut.blocks.push(block);
            here = block;
        }
    }
    Ok(cut)
}

struct Cutter<'a> {
    machine: &'a Machine,
    path: TipPath<'a>,
    motion: &'a PassMotion,
    level: Level,
    tolerance: f64,
}

impl Cutter<'_> {
    fn end_at(&self, s: f64, before: f64) -> Block {
        let q = self.motion.path.at(s);
        let duration = self.motion.law.time(s) - self.motion.law.time(before);
        Block { s, q, tip: self.machine.forward(&q).point, duration, turns_only: false, stops: false }
    }

    /// The farthest end of a good block from `here`, not beyond `end`; `guess` is the length of the last one.
    fn farthest(&self, here: &Block, written: &Block, end: f64, guess: f64) -> f64 {
        let good = |s: f64| {
            let block = self.end_at(s, here.s);
            self.good(here, &block) && self.feed_is_kept(written, &block)
        };
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

    /// The middle of a block to `end`, if linear motion goes out and back in it and would be left out as too small
    /// though either half has enough; otherwise `end`.
    fn turned_back(&self, here: &Block, written: &Block, end: f64) -> f64 {
        let middle = self.end_at(0.5 * (here.s + end), here.s);
        let lost = self.below_least_feed(written, &self.end_at(end, here.s));
        let halved = lost && middle.s - here.s > SHORTEST_MM && !self.below_least_feed(written, &middle);
        if halved && self.good(here, &middle) { middle.s } else { end }
    }

    fn good(&self, a: &Block, b: &Block) -> bool {
        let (chord, lag, attitude) = self.chord_error(a, b);
        chord <= self.tolerance && lag <= LAG * self.tolerance && attitude <= ATTITUDE
    }

    /// The pose the control passes through at the part `f` of a block.
    fn interpolated(&self, a: &Block, b: &Block, f: f64) -> Pose {
        let q: Joints = std::array::from_fn(|i| a.q[i] + f * (b.q[i] - a.q[i]));
        let pose = self.machine.forward(&q);
        match self.level {
            Level::Joint => pose,
            Level::Tip => Pose { point: a.tip.lerp(b.tip, f), ..pose },
        }
    }

    /// Worst distance from the planned path (mm), lead or lag along it (mm) and attitude deviation (rad) inside a
    /// block.
    fn chord_error(&self, a: &Block, b: &Block) -> (f64, f64, f64) {
        let begin = self.motion.law.time(a.s);
        let mut worst = (0.0f64, 0.0f64, 0.0f64);
        let mut cursor = 0;
        for k in 1..CHECKS {
            let f = k as f64 / CHECKS as f64;
            let passed = self.interpolated(a, b, f);
            let planned = self.motion.law.at(begin + f * b.duration, &mut cursor).s;
            let s = self.path.foot(passed.point, planned, (a.s, b.s));
            let there = self.path.pose(s);
            // Compared with what the axes really reach, so that a missing freedom is not a chord error.
            let reached = self.machine.forward(&self.motion.path.at(s)).direction;
            worst.0 = worst.0.max((passed.point - there.point).length());
            worst.1 = worst.1.max((s - planned).abs() * self.path.pace(planned));
            worst.2 = worst.2.max(2.0 * (0.5 * (passed.direction - reached).length()).min(1.0).asin());
        }
        worst
    }

    /// True if the control would raise the block's feed, counted from the last linear words `written`.
    fn below_least_feed(&self, written: &Block, b: &Block) -> bool {
        self.linear(written, b) / b.duration * 60.0 < 1.2 * LEAST_FEED
    }

    /// True if the control will not run the block faster than planned: its feed is above the least one, or its linear
    /// motion is small enough to be left to a later block.
    fn feed_is_kept(&self, written: &Block, b: &Block) -> bool {
        !self.below_least_feed(written, b) || self.linear(written, b) <= HELD_BACK * self.tolerance
    }

    /// True if a rotary axis moves in the block by more than its words can say.
    fn turns(&self, a: &Block, b: &Block) -> bool {
        let axes = self.machine.axes.iter().zip(a.q.iter().zip(&b.q));
        axes.filter(|(x, _)| x.kind == AxisKind::Rotary).any(|(_, (a, b))| (a - b).abs() > TURN)
    }

    /// Length of linear motion as the control will see it, mm.
    fn linear(&self, a: &Block, b: &Block) -> f64 {
        match self.level {
            Level::Tip => (b.tip - a.tip).length(),
            Level::Joint => {
                let axes = self.machine.axes.iter().zip(a.q.iter().zip(&b.q));
                let linear = axes.filter(|(x, _)| x.kind == AxisKind::Linear);
                linear.map(|(_, (a, b))| (b - a).powi(2)).sum::<f64>().sqrt()
            }
        }
    }
}
