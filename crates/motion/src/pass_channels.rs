use crate::joint_path::JointPath;
use crate::speed_profile::{Bend, Channels};
use crate::tip_channels::{ChannelLimits, channel_derivatives, channel_limits};
use seamwright_machine::{AxisLimits, Machine};
use seamwright_program::{Pass, Span};

/// Maximum jump of an axis' acceleration between two panels of a path, as a fraction of its limit; a larger one is a
/// corner.
const JUMP: f64 = 1e-3;
/// Fraction of the requested speed by which a spline with even stations may stay below one of its bends. Chosen on eight
/// valleys of the requested speed on the saddle; on 964 (`tests/it/asked_speed.rs` with `SEAMWRIGHT_SOAK=40`) the tip is
/// at most 0.31 % below it, with the solver's own margin,
const ROUNDED: f64 = 4e-4;
/// and the minimum time, s, in which a bend is passed.
const BRIEF: f64 = 4e-3;
/// Path lengths closer than this fraction of the path are equal.
const SAME: f64 = 1e-9;

/// Channels of a pass for its speed profile, by path length: the axes, then the tip if it has its own limits.
pub(crate) struct PassChannels<'a> {
    machine: &'a Machine,
    path: &'a JointPath,
    pass: &'a Pass,
    /// Factor of the pass' requested speeds.
    times: f64,
    limits: ChannelLimits,
    /// Ends of all spans but the last, each exactly at one of the breaks.
    borders: Vec<f64>,
    breaks: Vec<f64>,
    /// Path lengths at which the torch must stop, and an axis that would jump there otherwise.
    pub(crate) corners: Vec<(f64, usize)>,
}

impl<'a> PassChannels<'a> {
    pub(crate) fn new(machine: &'a Machine, path: &'a JointPath, pass: &'a Pass, times: f64) -> Self {
        let limits = channel_limits(machine);
        let length = path.length();
        let mut breaks = path.edges();
        let last = pass.spans.len().saturating_sub(1);
        let ends = pass.spans[..last].iter().map(|span| span.to_mm.get());
        // A border next to a panel's end is moved to it, so that span and panel of a path length agree.
        let there = |s: f64| breaks.iter().copied().find(|e| (e - s).abs() < SAME * length).unwrap_or(s);
        let borders: Vec<f64> = ends.map(there).collect();
        breaks.extend(&borders);
        breaks.retain(|s| *s > 0.0 && *s < length);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| *a - *b < SAME * length);
        let mut built = Self { machine, path, pass, times, limits, borders, breaks, corners: Vec::new() };
        // A bend next to a break counts as at the break.
        let bend = |s: &f64| {
            let i = path.bends.partition_point(|bend| *bend < s - SAME * length);
            path.bends.get(i).is_some_and(|bend| *bend <= s + SAME * length)
        };
        let bends = built.breaks.iter().filter(|s| bend(s));
        let corners = bends.filter_map(|s| Some((*s, built.corner(*s)?)));
        built.corners = corners.filter(|(s, _)| !built.is_asked_stop(*s)).collect();
        built
    }

    fn is_asked_stop(&self, s: f64) -> bool {
        self.path.stops.iter().any(|stop| (stop - s).abs() <= SAME * self.path.length())
    }

    /// An axis whose speed or acceleration would jump at `s` at the requested speed.
    fn corner(&self, s: f64) -> Option<usize> {
        // At the ends there is nothing to jump from.
        let (before, after) = (self.path.point_in_wide(s, true)?, self.path.point_in_wide(s, false)?);
        // Limited to the axes' speeds, so that rounding at a high requested speed is not a corner.
        let axes = &self.limits[..self.machine.axes.len()];
        let held = axes.iter().zip(before.d1).map(|(limits, d1)| limits.speed / d1.abs());
        let speed = held.fold(self.asked(s) / self.path.speed_rate(self.machine, s), f64::min);
        let jumps = |(i, limits): (usize, &AxisLimits)| {
            let jump = ((after.d1[i] - before.d1[i]).abs(), (after.d2[i] - before.d2[i]).abs());
            // A jump of the speed counts as an acceleration over one ms.
            (jump.0 * speed * 1e3).max(jump.1 * speed * speed) > JUMP * limits.acceleration
        };
        axes.iter().enumerate().position(jumps)
    }
}

impl Channels for PassChannels<'_> {
    fn range(&self) -> (f64, f64) {
        (0.0, self.path.length())
    }

    fn limits(&self) -> &[AxisLimits] {
        &self.limits
    }

    fn derivatives(&self, s: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        let p = self.path.point(s, before);
        let has_rate = self.path.has_rate(s);
        if has_rate || out.len() > self.machine.axes.len() {
            let [d1, ..] = channel_derivatives(self.machine, self.path.drawn_back, &[p.q, p.d1, p.d2, p.d3], out);
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
