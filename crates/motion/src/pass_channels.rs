use crate::JointPath;
use crate::law::{Bend, Channels, Limits};
use crate::tip_channels::TipChannels;
use glam::DVec3;
use seamwright_machine::{Joints, Machine};
use seamwright_program::{Pass, Span};

/// Part of an axis' acceleration by which it may jump between two panels of a path: more is a corner.
const JUMP: f64 = 1e-3;
/// Part of the asked speed by which a spline with even stations may stay below one of its bends: with stations that grow
/// away from it and limits looked at in five places of a cell it is up to four times as much, over a thousand valleys on the
/// saddle (`tests/it/asked_speed.rs`),
const ROUNDED: f64 = 4e-4;
/// and the shortest time, s, in which a bend is passed.
const BRIEF: f64 = 4e-3;
/// Places nearer to each other than this part of the path are one.
const SAME: f64 = 1e-9;

/// The axes along a pass, by path length, as a speed law sees them; after them the tip if it has limits of its own.
pub(crate) struct PassChannels<'a> {
    machine: &'a Machine,
    path: &'a JointPath,
    pass: &'a Pass,
    /// How many times the pass' speeds are asked for.
    times: f64,
    limits: Vec<Limits>,
    /// Where spans but the last end, exactly at one of the breaks.
    borders: Vec<f64>,
    breaks: Vec<f64>,
    /// Places at which the torch has to stop, and an axis that would jump there otherwise.
    corners: Vec<(f64, usize)>,
}

impl<'a> PassChannels<'a> {
    pub(crate) fn new(machine: &'a Machine, path: &'a JointPath, pass: &'a Pass, times: f64) -> Self {
        let limits: Vec<Limits> = machine.axes.iter().map(limits).chain(TipChannels::limits(machine)).collect();
        let length = path.length();
        let mut breaks = path.edges();
        let last = pass.spans.len().saturating_sub(1);
        let ends = pass.spans[..last].iter().map(|span| span.to_mm.get());
        // A border next to a panel's end is there: which span a place is in and which panel must go together.
        let there = |s: f64| breaks.iter().copied().find(|e| (e - s).abs() < SAME * length).unwrap_or(s);
        let borders: Vec<f64> = ends.map(there).collect();
        breaks.extend(&borders);
        breaks.retain(|s| *s > 0.0 && *s < length);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| *a - *b < SAME * length);
        let mut built = Self { machine, path, pass, times, limits, borders, breaks, corners: Vec::new() };
        // A bend next to a break is there.
        let bend = |s: &f64| {
            let i = path.bends().partition_point(|bend| *bend < s - SAME * length);
            path.bends().get(i).is_some_and(|bend| *bend <= s + SAME * length)
        };
        let bends = built.breaks.iter().filter(|s| bend(s));
        let corners = bends.filter_map(|s| Some((*s, built.corner(*s)?)));
        built.corners = corners.filter(|(s, _)| !built.is_asked_stop(*s)).collect();
        built
    }

    /// Places at which the torch has to stop, and an axis that would jump there otherwise.
    pub(crate) fn corners(&self) -> &[(f64, usize)] {
        &self.corners
    }

    /// True if the path asks for a stop at `s`.
    fn is_asked_stop(&self, s: f64) -> bool {
        self.path.stops().iter().any(|stop| (stop - s).abs() <= SAME * self.path.length())
    }

    /// Derivatives of all channels where the axes have the positions and derivatives `d`, into `out`; and those of the
    /// tip.
    pub(crate) fn along(&self, d: &[Joints; 4], out: &mut [[f64; 3]]) -> [DVec3; 3] {
        let (axes, tip) = out.split_at_mut(self.machine.axes.len());
        axes.iter_mut().enumerate().for_each(|(i, out)| *out = [d[1][i], d[2][i], d[3][i]]);
        let motion = self.machine.tip_derivatives(d);
        if !tip.is_empty() {
            TipChannels::derivatives(motion, tip);
        }
        motion
    }

    /// An axis whose speed or acceleration would jump at `s` at the asked speed.
    fn corner(&self, s: f64) -> Option<usize> {
        let (before, after) = (self.path.point(s, true), self.path.point(s, false));
        // No faster than the axes' speeds allow: however much is asked for, rounding is no corner.
        let axes = &self.limits[..self.machine.axes.len()];
        let held = axes.iter().zip(before.d1).map(|(limits, d1)| limits.speed / d1.abs());
        let speed = held.fold(self.asked(s) / self.path.speed_rate(self.machine, s), f64::min);
        let jumps = |(i, limits): (usize, &Limits)| {
            let jump = ((after.d1[i] - before.d1[i]).abs(), (after.d2[i] - before.d2[i]).abs());
            // A jump of the speed within one ms is one of the acceleration.
            (jump.0 * speed * 1e3).max(jump.1 * speed * speed) > JUMP * limits.acceleration
        };
        axes.iter().enumerate().position(jumps)
    }
}

/// An axis' limits.
pub(crate) fn limits(axis: &seamwright_machine::Axis) -> Limits {
    Limits { speed: axis.max_speed, acceleration: axis.max_acceleration, jerk: axis.jerk() }
}

impl Channels for PassChannels<'_> {
    fn range(&self) -> (f64, f64) {
        (0.0, self.path.length())
    }

    fn limits(&self) -> &[Limits] {
        &self.limits
    }

    fn derivatives(&self, s: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        let p = self.path.point(s, before);
        let has_rate = self.path.has_rate(s);
        if has_rate || out.len() > self.machine.axes.len() {
            let [d1, ..] = self.along(&[p.q, p.d1, p.d2, p.d3], out);
            let line = self.path.line_rate(self.path.panel(s, before), s);
            return if has_rate { line.unwrap_or(d1.length()) } else { 1.0 };
        }
        out.iter_mut().enumerate().for_each(|(i, out)| *out = [p.d1[i], p.d2[i], p.d3[i]]);
        1.0
    }

    fn asked(&self, s: f64) -> f64 {
        let span = &self.pass.spans[self.borders.partition_point(|border| *border <= s)];
        self.times * span.speed_mm_s.at(span.part(s))
    }

    fn breaks(&self) -> Vec<f64> {
        self.breaks.clone()
    }

    /// A quadratic spline with stations `w` apart that stays below a bend of `slope` is up to `slope w / 8` below it.
    fn bends(&self) -> Vec<Bend> {
        let bend = |(at, pair): (&f64, &[Span])| {
            let slope = |span: &Span| {
                let speed = span.speed_mm_s;
                (speed.at(1.0) - speed.at(0.0)) / (span.to_mm.get() - span.from_mm.get())
            };
            let bend = self.times * (slope(&pair[1]) - slope(&pair[0])).abs();
            let speed = self.asked(*at);
            let rounded_over = (8.0 * ROUNDED * speed / bend).max(BRIEF * speed);
            (rounded_over < self.path.length()).then_some(Bend { at: *at, rounded_over })
        };
        self.borders.iter().zip(self.pass.spans.windows(2)).filter_map(bend).collect()
    }

    fn stops(&self) -> Vec<f64> {
        let asked = self.breaks.iter().copied().filter(|s| self.is_asked_stop(*s));
        let mut stops: Vec<f64> = self.corners.iter().map(|corner| corner.0).chain(asked).collect();
        stops.sort_by(f64::total_cmp);
        stops
    }
}
