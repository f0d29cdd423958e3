//! Process values that the control interpolates, along a pass.

use crate::control::Control;
use crate::part_program::ChannelKind;
use seamwright_program::{ArcTime, Pass};
use std::ops::Range;

/// Way over which a value goes from that of one span to that of the next, mm.
const JUMP_MM: f64 = 0.5;
/// Maximum deviation of a value from an even change within a block, as a part of its range there.
const USED: f64 = 0.005;
/// Stations at which a value's range is searched.
const PLACES: u32 = 400;

/// The interpolated process values of a pass.
#[derive(Debug)]
pub(crate) struct Course<'a> {
    pass: &'a Pass,
    /// Name, channel and tolerance of each.
    values: Vec<(&'a str, usize, f64)>,
}

impl<'a> Course<'a> {
    pub(crate) fn new(control: &Control, pass: &'a Pass) -> Self {
        let mut course = Self { pass, values: Vec::new() };
        for name in pass.spans[0].process.keys() {
            let Some(i) = control.channel(name).filter(|i| control.channels[*i].kind == ChannelKind::Interpolated)
            else {
                continue;
            };
            let places = (0..=PLACES).map(|k| course.at(name, pass.length() * f64::from(k) / f64::from(PLACES)));
            let (least, most) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (v.min(l), v.max(m)));
            let tolerance = (USED * (most - least)).max(1e-6);
            course.values.push((name, i, tolerance));
        }
        course
    }

    /// Channel and value of each at path length `s`.
    pub(crate) fn row(&self, s: f64) -> impl Iterator<Item = (usize, f64)> {
        self.values.iter().map(move |(name, i, _)| (*i, self.at(name, s)))
    }

    /// Channel and value of each while the torch rests at `s`.
    pub(crate) fn at_rest(&self, s: f64, time: ArcTime) -> impl Iterator<Item = (usize, f64)> {
        self.values.iter().map(move |(name, i, _)| (*i, self.pass.process_at(name, s, time).unwrap_or(0.0)))
    }

    /// Starts and ends of jumps, mm.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        if self.values.is_empty() {
            return Vec::new();
        }
        self.pass.spans.iter().skip(1).map(|span| span.from_mm.get() + jump(span)).collect()
    }

    /// True if all values are nearly even in time over a range of path lengths. `at` gives the path length at a part of
    /// the time.
    pub(crate) fn is_even(&self, Range { start, end }: Range<f64>, at: impl Fn(f64) -> f64) -> bool {
        const CHECKS: u32 = 8;
        self.values.iter().all(|(name, _, tolerance)| {
            let (a, b) = (self.at(name, start), self.at(name, end));
            (1..CHECKS).all(|k| {
                let f = f64::from(k) / f64::from(CHECKS);
                (self.at(name, at(f)) - (a + f * (b - a))).abs() <= *tolerance
            })
        })
    }

    /// The value at path length `s`: where it jumps between spans, it goes over evenly behind the border.
    fn at(&self, name: &str, s: f64) -> f64 {
        let value = |s: f64| self.pass.process_at(name, s, ArcTime::TRAVEL).unwrap_or(0.0);
        let k = self.pass.spans.partition_point(|span| span.to_mm.get() <= s).min(self.pass.spans.len() - 1);
        let span = &self.pass.spans[k];
        let (begin, way) = (span.from_mm.get(), jump(span));
        if k == 0 || s >= begin + way {
            return value(s);
        }
        let before = value(begin.next_down());
        before + (value(begin + way) - before) * (s - begin) / way
    }
}

fn jump(span: &seamwright_program::Span) -> f64 {
    JUMP_MM.min(0.5 * (span.to_mm.get() - span.from_mm.get()))
}
