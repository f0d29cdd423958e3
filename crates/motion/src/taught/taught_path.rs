use super::spline::{Piece, slopes};
use super::thinning::{Kept, SAME, Taught, Thinned, Tolerance};
use crate::speed_profile::{Channels, Feed};
use crate::stretch::Stretch;
use crate::tip_channels::{ChannelLimits, channel_derivatives, channel_limits};
use seamwright_machine::{AxisKind, AxisLimits, Joints, MAX_AXES, Machine};
use std::collections::VecDeque;

/// Motion at a corner of the taught points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Corner {
    /// Exact stop at the corner.
    Stop,
    /// Blend, twice continuously differentiable, that passes the corner within this distance of the tip (mm).
    Blend(f64),
}

/// The axes' path through taught points, loaded on demand.
///
/// The parameter is the length of the tip's chords (mm) while the tip moves at the requested speed. If an axis would
/// exceed its speed, or the tip rests, it counts the time of that axis times the requested speed. Guarantee: passes
/// through every kept point, and within the tolerance of omitted ones, except in blends at corners. Between points it
/// is the cubic spline through them: a bend too small for a corner is rounded over the distance of the points there. If
/// the spline would swing by more than a tenth of that distance, points are added.
pub struct TaughtPath<'a, I: Iterator<Item = Joints>> {
    machine: &'a Machine,
    /// Limits of the axes, then of the tip if it has any.
    limits: ChannelLimits,
    speed: f64,
    corner: Corner,
    points: std::iter::Peekable<Thinned<Tips<'a, I>>>,
    pieces: VecDeque<Piece>,
    /// Points of the current run with their parameters, and the slope of the first one if pieces already end there.
    run: Vec<(f64, Kept)>,
    /// Maximum distance from an omitted point.
    tolerance: Tolerance,
    slope: Option<Joints>,
    /// The last piece before a corner, until the next piece is known.
    held: Option<Piece>,
    stops: Vec<f64>,
    complete: bool,
}

/// Number of pieces built together, and of points that must be known after the last of them: the influence of later
/// slopes is negligible (each point passes on at most about 0.4 of it).
const AT_ONCE: usize = 64;
const AHEAD: usize = 32;
/// Turn of the path (in axis space, axes by their speeds) that makes a point a corner.
const CORNER_COS: f64 = 0.866;
/// Maximum deviation of a piece from the chord between its ends, as a fraction of it: an even turn by 30 degrees takes
/// 0.065.
const SWING: f64 = 0.1;
/// Maximum fraction of the neighbouring pieces that a blend takes.
const PART_OF_PIECE: f64 = 0.45;

impl<'a, I: Iterator<Item = Joints>> TaughtPath<'a, I> {
    /// Creates the path of `machine` through the axis positions `points` at `speed` (mm/s) of the tip. Points within
    /// `tolerance` (mm; rotary axes: the same at 100 mm) of the path may be omitted.
    pub fn new(machine: &'a Machine, points: I, speed: f64, corner: Corner, tolerance: f64) -> Self {
        let near = |i: usize| match machine.axes.get(i).map(|a| a.kind) {
            Some(AxisKind::Rotary) => tolerance / 100.0,
            _ => tolerance,
        };
        let tips = Tips { machine, points };
        let tolerance = Tolerance { tip: tolerance, axes: std::array::from_fn(near) };
        Self {
            machine,
            limits: channel_limits(machine),
            speed,
            corner,
            points: Thinned::new(tips, tolerance).peekable(),
            tolerance,
            pieces: VecDeque::new(),
            run: Vec::new(),
            slope: None,
            held: None,
            stops: Vec::new(),
            complete: false,
        }
    }
}

struct Tips<'a, I> {
    machine: &'a Machine,
    points: I,
}

impl<I: Iterator<Item = Joints>> Iterator for Tips<'_, I> {
    type Item = Taught;

    fn next(&mut self) -> Option<Taught> {
        let q = self.points.next()?;
        Some(Taught { q, tip: self.machine.forward(&q).point })
    }
}

impl<I: Iterator<Item = Joints>> TaughtPath<'_, I> {
    /// Positions of the axes at `u`, mm or rad.
    pub fn position(&self, u: f64) -> Joints {
        self.piece(u, false).derivatives(u)[0]
    }

    /// Speed of the tip by the parameter at `u`.
    pub fn tip_rate(&self, u: f64) -> f64 {
        self.machine.tip_derivatives(&self.piece(u, false).derivatives(u), 0.0)[0].length()
    }

    /// True if the path has no motion: no two points differ.
    pub fn is_empty(&mut self) -> bool {
        while self.pieces.is_empty() && !self.complete {
            self.extend();
        }
        self.pieces.is_empty()
    }

    fn piece(&self, u: f64, before: bool) -> &Piece {
        let i = self.pieces.partition_point(|p| if before { p.from < u } else { p.from <= u });
        &self.pieces[i.saturating_sub(1)]
    }

    /// The parameter's step from one point to another.
    fn step(&self, a: &Taught, b: &Taught) -> f64 {
        let axes = self.machine.axes.iter().enumerate().map(|(i, axis)| (a.q[i] - b.q[i]).abs() / axis.max_speed);
        axes.fold(a.tip.distance(b.tip) / self.speed, f64::max) * self.speed
    }

    /// True if the path has a corner at `at`.
    fn is_corner(&self, before: &Taught, at: &Taught, after: &Taught) -> bool {
        let way = |a: &Taught, b: &Taught| -> Joints {
            std::array::from_fn(|i| self.machine.axes.get(i).map_or(0.0, |axis| (b.q[i] - a.q[i]) / axis.max_speed))
        };
        let (a, b) = (way(before, at), way(at, after));
        let dot = |a: &Joints, b: &Joints| (0..MAX_AXES).map(|i| a[i] * b[i]).sum::<f64>();
        dot(&a, &b) < CORNER_COS * (dot(&a, &a) * dot(&b, &b)).sqrt()
    }

    fn extend(&mut self) {
        let mut ended = false;
        while self.run.len() < AT_ONCE + AHEAD {
            let Some(kept) = self.points.next() else {
                (ended, self.complete) = (true, true);
                break;
            };
            let point = kept.point;
            let u = match self.run.last() {
                Some((u, last)) => u + self.step(&last.point, &point).max(SAME),
                None => 0.0,
            };
            let next = self.points.peek().map(|next| next.point);
            let corner = match (self.run.last(), next) {
                (Some((_, last)), Some(next)) => self.is_corner(&last.point, &point, &next),
                _ => false,
            };
            self.run.push((u, kept));
            if corner {
                ended = true;
                break;
            }
        }
        if self.run.len() > 1 {
            self.make_pieces(ended);
        }
        if self.complete {
            self.pieces.extend(self.held.take());
        }
    }

    /// Turns the run into pieces: all of it if it has ended, else without the part that later points still change.
    fn make_pieces(&mut self, ended: bool) {
        let pieces = loop {
            let pieces = self.spline();
            let mut good = true;
            for (i, piece) in pieces.iter().enumerate().rev() {
                if let Some(k) = self.farthest(i, piece) {
                    self.take_back(i, k);
                    good = false;
                } else if self.swings(piece) {
                    self.halve(i, piece);
                    good = false;
                }
            }
            if good {
                break pieces;
            }
        };
        let begins = self.slope.is_none();
        let count = if ended { pieces.len() } else { AT_ONCE.min(pieces.len()) };
        for (i, piece) in pieces.into_iter().take(count).enumerate() {
            self.slope = Some(piece.derivatives(piece.to)[1]);
            if begins && i == 0 {
                self.begin_run(piece);
            } else {
                self.pieces.extend(self.held.replace(piece));
            }
        }
        self.run.drain(..count);
        if ended {
            self.slope = None;
        }
        // Points omitted before the first point belong to finished pieces.
        self.run.first_mut().into_iter().for_each(|(_, first)| first.left_out.clear());
    }

    fn spline(&self) -> Vec<Piece> {
        let u: Vec<f64> = self.run.iter().map(|r| r.0).collect();
        let q: Vec<Joints> = self.run.iter().map(|r| r.1.point.q).collect();
        let d = slopes(&u, &q, self.slope.as_ref());
        let piece = |i: usize| {
            let over = Stretch { from: u[i], to: u[i + 1] };
            Piece::cubic(over, [&q[i], &q[i + 1]], [&d[i], &d[i + 1]])
        };
        (0..u.len() - 1).map(piece).collect()
    }

    /// The omitted point of piece `i` that is farthest from it, if that is beyond the tolerance.
    fn farthest(&self, i: usize, piece: &Piece) -> Option<usize> {
        let left_out = &self.run[i + 1].1.left_out;
        let away = left_out.iter().enumerate().map(|(k, point)| (k, self.away(piece, point, k, left_out.len())));
        let (k, most) = away.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (most > 1.0).then_some(k)
    }

    /// Distance of `point` (number `k` of `count` omitted ones) from a piece, as a fraction of the tolerance.
    fn away(&self, piece: &Piece, point: &Taught, k: usize, count: usize) -> f64 {
        let Tolerance { tip, axes } = &self.tolerance;
        let off = |q: &Joints, i: usize| (point.q[i] - q[i]) / axes[i];
        // Nearest parameter on it, by Newton's method without the curvature.
        let mut u = piece.from + (piece.to - piece.from) * (k + 1) as f64 / (count + 1) as f64;
        for _ in 0..3 {
            let [q, d1, ..] = piece.derivatives(u);
            let along: f64 = (0..MAX_AXES).map(|i| off(&q, i) * d1[i] / axes[i]).sum();
            let square: f64 = (0..MAX_AXES).map(|i| (d1[i] / axes[i]).powi(2)).sum();
            if square > 0.0 {
                u = (u + along / square).clamp(piece.from, piece.to);
            }
        }
        let q = piece.derivatives(u)[0];
        let by_axes = (0..MAX_AXES).map(|i| off(&q, i).abs()).fold(0.0, f64::max);
        by_axes.max(self.machine.forward(&q).point.distance(point.tip) / tip)
    }

    /// True if a piece deviates from the chord between its ends by more than an even turn and by more than the
    /// tolerance.
    fn swings(&self, piece: &Piece) -> bool {
        let axes = &self.tolerance.axes;
        let between = |a: &Joints, b: &Joints| -> Joints { std::array::from_fn(|i| (b[i] - a[i]) / axes[i]) };
        let dot = |a: &Joints, b: &Joints| (0..MAX_AXES).map(|i| a[i] * b[i]).sum::<f64>();
        let at = |part: f64| piece.derivatives(piece.from + part * (piece.to - piece.from))[0];
        let start = at(0.0);
        let chord = between(&start, &at(1.0));
        let square = dot(&chord, &chord);
        let off = |part: f64| {
            let way = between(&start, &at(part));
            let along = if square > 0.0 { (dot(&way, &chord) / square).clamp(0.0, 1.0) } else { 0.0 };
            let aside: Joints = std::array::from_fn(|i| way[i] - along * chord[i]);
            dot(&aside, &aside).sqrt()
        };
        piece.to - piece.from > 4.0 * SAME
            && [0.25, 0.5, 0.75].into_iter().any(|p| off(p) > 1.0 + SWING * square.sqrt())
    }

    /// Splits a piece into two: at the middle one of the omitted points, or halfway between its ends.
    fn halve(&mut self, i: usize, piece: &Piece) {
        let [a, b] = [piece.from, piece.to].map(|u| piece.derivatives(u)[0]);
        let left_out = &mut self.run[i + 1].1.left_out;
        if left_out.is_empty() {
            let q: Joints = std::array::from_fn(|k| 0.5 * (a[k] + b[k]));
            left_out.push(Taught { q, tip: self.machine.forward(&q).point });
        }
        let middle = left_out.len() / 2;
        self.take_back(i, middle);
    }

    /// Puts the omitted point `k` of piece `i` back into the run.
    fn take_back(&mut self, i: usize, k: usize) {
        let mut before = std::mem::take(&mut self.run[i + 1].1.left_out);
        let after = before.split_off(k + 1);
        let Some(point) = before.pop() else { return };
        let (u, to) = (self.run[i].0, self.run[i + 1].0);
        let begin = u + self.step(&self.run[i].1.point, &point).max(SAME);
        let longer = begin + self.step(&point, &self.run[i + 1].1.point).max(SAME) - to;
        self.run[i + 1..].iter_mut().for_each(|r| r.0 += longer);
        self.run[i + 1].1.left_out = after;
        self.run.insert(i + 1, (begin, Kept { point, left_out: before }));
    }

    /// Adds the first piece after a corner, or of the path.
    fn begin_run(&mut self, mut after: Piece) {
        let Some(mut before) = self.held.replace(after) else { return };
        let Corner::Blend(distance) = self.corner else {
            self.stops.push(before.to);
            self.pieces.push_back(before);
            return;
        };
        let u = before.to;
        let room = PART_OF_PIECE * (before.to - before.from).min(after.to - after.from);
        let corner = self.machine.forward(&before.derivatives(u)[0]).point;
        // The tip passes a corner of straight lines at 3/16 of the difference of their slopes: reduces the width until
        // it fits.
        let mut half = room;
        for _ in 0..60 {
            (before.to, after.from) = (u - half, u + half);
            let blend = Piece::blend(&before, &after);
            let off = self.machine.forward(&blend.derivatives(u)[0]).point.distance(corner);
            if off <= distance {
                self.pieces.push_back(before);
                self.pieces.push_back(blend);
                self.held = Some(after);
                return;
            }
            half *= (distance / off).clamp(0.3, 0.95);
        }
        self.stops.push(u);
        before.to = u;
        self.pieces.push_back(before);
    }
}

impl<I: Iterator<Item = Joints>> Channels for TaughtPath<'_, I> {
    fn range(&self) -> (f64, f64) {
        (self.pieces.front().map_or(0.0, |p| p.from), self.pieces.back().map_or(0.0, |p| p.to))
    }

    fn limits(&self) -> &[AxisLimits] {
        &self.limits
    }

    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        let d = self.piece(u, before).derivatives(u);
        channel_derivatives(self.machine, 0.0, &d, out)[0].length()
    }

    fn asked(&self, _u: f64) -> f64 {
        self.speed
    }

    fn breaks(&self) -> Vec<f64> {
        self.pieces.iter().skip(1).map(|p| p.from).collect()
    }

    fn stops(&self) -> Vec<f64> {
        let (from, to) = self.range();
        self.stops.iter().copied().filter(|u| *u > from && *u < to).collect()
    }
}

impl<I: Iterator<Item = Joints>> Feed for TaughtPath<'_, I> {
    fn load(&mut self, from: f64, beyond: f64, seconds: f64) {
        while !self.complete && self.range().1 < beyond + seconds * self.speed {
            self.extend();
        }
        while self.pieces.front().is_some_and(|p| p.to < from) {
            self.pieces.pop_front();
        }
        self.stops.retain(|u| *u >= from);
    }

    fn is_complete(&self) -> bool {
        self.complete
    }
}
