use super::block_comparison::Block;
use super::{PassVerification, Planned, is_tip};
use crate::even_speed::EvenSpeed;
use crate::plan::BRIEFEST_S;
use crate::play::Segment;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine};
use seamwright_motion::{PassMotion, TipPath};
use seamwright_program::{ArcTime, Pass, PathRange};
use std::ops::Range;

/// Stations checked in a block, its end among them.
const PLACES: u32 = 16;
/// Blocks shorter than this, or slower than this part of the fastest, are not compared: speed changes within them in
/// the acceleration and deceleration phases.
const SHORTEST_S: f64 = 1e-3;
const SLOWEST: f64 = 0.2;

/// A pass whose blocks are the program's points: their times.
pub(super) fn as_it_stands(pass: &Pass, number: usize, blocks: &[Block]) -> PassVerification {
    let own = blocks.iter().filter(|b| b.pass == number);
    PassVerification { as_it_stands: true, arc_s: own.map(|b| b.told.seconds).sum(), ..nothing(pass) }
}

fn nothing(pass: &Pass) -> PassVerification {
    PassVerification { name: pass.name.clone(), ..PassVerification::default() }
}

/// Compares the blocks of a pass with the arc on with its planned motion.
pub(super) fn check(planned: Planned, pass: &Pass, number: usize, blocks: &[Block]) -> PassVerification {
    let motion = &planned.motion.passes[number];
    let own: Vec<&Block> =
        blocks.iter().filter(|b| b.pass == number && (b.arc || !pass.has_arc()) && !b.rapid).collect();
    let mut proof = nothing(pass);
    let Some(first) = own.first() else {
        proof.time_percent = f64::NAN;
        return proof;
    };
    let expected = if pass.has_arc() { motion.arc_on_s() } else { motion.total_s() };
    proof.arc_s = own.iter().map(|b| b.told.seconds).sum();
    proof.time_percent = 100.0 * (proof.arc_s / expected - 1.0);
    let delay = if pass.has_arc() { motion.sequence.travel_delay_s.get() } else { motion.before_s() };
    let mut checker = Checker {
        planned,
        pass,
        motion,
        path: motion.tip_path(planned.machine),
        even: EvenSpeed::new(planned.machine, motion, BRIEFEST_S),
        travel: first.told.begin + delay,
        cursor: 0,
        greatest: greatest_values(planned, pass),
        proof,
    };
    own.iter().for_each(|block| checker.block(block));
    checker.proof
}

/// Each process channel of the control with the value's name and its maximum in the pass.
fn greatest_values(planned: Planned, pass: &Pass) -> Vec<(usize, String, f64)> {
    let names = pass.spans.first().into_iter().flat_map(|span| span.process.keys());
    let greatest = |name: &String| {
        let ends = pass.spans.iter().filter_map(|span| Some(span.process.get(name)?.ends()));
        ends.map(|(from, to)| from.max(to)).fold(0.0, f64::max)
    };
    names.filter_map(|name| Some((planned.control.channel(name)?, name.clone(), greatest(name)))).collect()
}

/// A position that the text reaches, and its counterparts on the planned path.
struct Reached {
    q: Joints,
    tip: Pose,
    /// Planned path length at that time, mm.
    s: f64,
    /// Path length of the point nearest to the tip, mm.
    foot: f64,
}

struct Checker<'a> {
    planned: Planned<'a>,
    pass: &'a Pass,
    motion: &'a PassMotion,
    path: TipPath<'a>,
    /// Comparison of the tip's speed with the plan.
    even: EvenSpeed<'a>,
    /// Start of the torch's travel on the text's clock, s.
    travel: f64,
    cursor: usize,
    greatest: Vec<(usize, String, f64)>,
    proof: PassVerification,
}

impl Checker<'_> {
    fn block(&mut self, block: &Block) {
        let segment = &block.told;
        if !segment.is_move() {
            return;
        }
        let length = self.motion.path.length();
        let mut row = Vec::new();
        let mut way = 0.0;
        let mut last: Option<DVec3> = None;
        for k in 0..=PLACES {
            let f = f64::from(k) / f64::from(PLACES);
            segment.at(f, &mut row);
            let t = segment.begin + f * segment.seconds - self.travel;
            let (q, tip) = self.place(&row, is_tip(segment.level));
            let s = self.motion.profile.at(t.clamp(0.0, self.motion.profile.duration()), &mut self.cursor).s;
            let foot = self.path.foot(tip.point, s, PathRange::up_to(length));
            self.deviation(&Reached { q, tip, s, foot }, is_tip(segment.level));
            way += last.map_or(0.0, |last| last.distance(tip.point));
            last = Some(tip.point);
        }
        self.speed(segment.begin, segment.seconds, way);
        self.speed_inside(segment);
        segment.at(0.5, &mut row);
        self.process(&row, segment.begin + 0.5 * segment.seconds);
    }

    fn place(&self, row: &[f64], tip_level: bool) -> (Joints, Pose) {
        let machine = self.planned.machine;
        let mut q = Joints::default();
        for (i, axis) in machine.axes.iter().enumerate() {
            q[i] = axis.from_file(row[i]);
        }
        let pose = machine.forward(&q);
        if !tip_level {
            return (q, pose);
        }
        let part = |name: &str| machine.axis(name).map_or(0.0, |i| row[i]);
        (q, Pose { point: DVec3::new(part("x"), part("y"), part("z")), ..pose })
    }

    /// Updates the maximum deviations from the planned path.
    fn deviation(&mut self, reached: &Reached, tip_level: bool) {
        let &Reached { q, tip, s, foot } = reached;
        let machine = self.planned.machine;
        let asked = self.motion.path.at(foot);
        let there = machine.forward(&asked);
        self.proof.tip_mm = self.proof.tip_mm.max(tip.point.distance(there.point));
        let angle = 2.0 * (0.5 * (tip.direction - there.direction).length()).min(1.0).asin();
        self.proof.direction_deg = self.proof.direction_deg.max(angle.to_degrees());
        self.proof.lag_mm = self.proof.lag_mm.max((foot - s).abs() * self.path.tip_rate(s));
        for (i, axis) in machine.axes.iter().enumerate() {
            let worst = match axis.kind {
                AxisKind::Linear if tip_level => continue,
                AxisKind::Linear => &mut self.proof.linear,
                AxisKind::Rotary => &mut self.proof.rotary,
            };
            let off = (axis.to_file(q[i]) - axis.to_file(asked[i])).abs();
            if worst.as_ref().is_none_or(|(most, _)| off > *most) {
                *worst = Some((off, axis.name.clone()));
            }
        }
    }

    /// The mean speed of the tip in a block against the planned one in the same time.
    fn speed(&mut self, begin: f64, seconds: f64, way: f64) {
        let from = begin - self.travel;
        let (from, to) = (from.max(0.0), (from + seconds).min(self.motion.profile.duration()));
        if to - from < SHORTEST_S {
            return;
        }
        let planned = planned_way(self.planned.machine, self.motion, from..to);
        let fastest = self.motion.certificate.everywhere.max(self.pass.speeds().1);
        if planned > SLOWEST * fastest * (to - from) {
            self.proof.speed_percent = self.proof.speed_percent.max(100.0 * (way / planned - 1.0).abs());
        }
    }

    /// The speed of the tip in parts of a block against the planned one in the same times.
    fn speed_inside(&mut self, segment: &Segment) {
        let parts = EvenSpeed::parts(segment.seconds);
        let (mut row, mut before) = (Vec::new(), None);
        for k in 0..=parts {
            segment.at(k as f64 / parts as f64, &mut row);
            let here = self.place(&row, is_tip(segment.level)).1.point;
            let Some(last) = before.replace(here) else { continue };
            let step = segment.seconds / parts as f64;
            let begin = segment.begin - self.travel + (k - 1) as f64 * step;
            let Some(off) = self.even.deviation([begin, begin + step], here.distance(last)) else { continue };
            self.proof.speed_inside_percent = self.proof.speed_inside_percent.max(100.0 * off);
            if segment.seconds > BRIEFEST_S && !self.motion.path.is_woven() {
                self.proof.speed_bounded_percent = self.proof.speed_bounded_percent.max(100.0 * off);
            }
        }
    }

    fn process(&mut self, row: &[f64], t: f64) {
        let (mut cursor, since_on) = (self.cursor, t - self.travel + self.motion.sequence.travel_delay_s.get());
        let s = self.motion.profile.at((t - self.travel).clamp(0.0, self.motion.profile.duration()), &mut cursor).s;
        for (channel, name, greatest) in &self.greatest {
            let time = ArcTime { since_on_s: since_on, until_off_s: self.motion.arc_on_s() - since_on };
            let Some(asked) = self.pass.process_at(name, s, time) else { continue };
            let percent = if *greatest > 0.0 { 100.0 * (row[*channel] - asked).abs() / greatest } else { 0.0 };
            if self.proof.process.as_ref().is_none_or(|(most, _)| percent > *most) {
                self.proof.process = Some((percent, name.clone()));
            }
        }
    }
}

/// Way of the tip by the plan in a range of times of the travel, mm: by chords as the blocks' is.
fn planned_way(machine: &Machine, motion: &PassMotion, Range { start, end }: Range<f64>) -> f64 {
    let mut cursor = 0;
    let tips = (0..=PLACES).map(|k| {
        let t = start + (end - start) * f64::from(k) / f64::from(PLACES);
        machine.forward(&motion.path.at(motion.profile.at(t, &mut cursor).s)).point
    });
    let tips: Vec<DVec3> = tips.collect();
    tips.windows(2).map(|w| w[0].distance(w[1])).sum()
}
