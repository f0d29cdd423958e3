//! Blocks as points.

use super::{Builder, finite};
use crate::part_program::{Level, Move, Path, What};
use crate::play::Segment;
use crate::points::cubics::Cubics;
use seamwright_document::{Direction, Finite, Point};
use seamwright_machine::Joints;
use seamwright_program::{Along, PointSpan};
use std::f64::consts::PI;

impl Builder<'_> {
    /// Adds the points of a segment to the open pass.
    pub(super) fn add(&mut self, m: &Move, segment: &Segment, number: Option<u32>) {
        let level = m.level;
        let arc = match m.path {
            Path::Arc(arc) => Some(self.read.arcs[arc as usize]),
            _ => None,
        };
        let along = match m.path {
            Path::Rapid => Along::Rapid,
            Path::Line => Along::Line,
            Path::Arc(_) => Along::Arc,
            Path::Hermite(_) | Path::Spline | Path::Curve(_) => Along::Cubic,
        };
        // Arcs of more than half a turn are split.
        let ends = match arc {
            Some(arc) => {
                let parts = (arc.sweep / (PI * (1.0 + 1e-9))).ceil().max(1.0) as u32;
                (1..=parts).map(|k| f64::from(k) / f64::from(parts)).collect()
            }
            None if along == Along::Cubic => self.cubics(segment, level).ends(),
            None => vec![1.0],
        };
        let mut row = Vec::new();
        let mut begin = 0.0;
        for (part, end) in ends.iter().enumerate() {
            segment.at(0.5 * (begin + end), &mut row);
            let via = self.read.xyz().of(&row);
            let last = part + 1 == ends.len();
            if last {
                row.clear();
                row.extend_from_slice(segment.end());
            } else {
                segment.at(*end, &mut row);
            }
            let seconds = segment.seconds * (end - begin);
            let point = self.point(&row, level, number.filter(|_| last), seconds);
            let span = PointSpan {
                along,
                stops: m.exact_stop && last && along != Along::Rapid,
                via_mm: arc.and_then(|_| Point::new(via)),
                normal: arc.filter(|_| self.climbs(segment)).and_then(|arc| Direction::new(arc.normal)),
                speeds: match along {
                    Along::Cubic => [begin, *end].map(|f| self.cubics(segment, level).speeds(f)).into(),
                    _ => Vec::new(),
                },
                points: vec![point],
            };
            if let Some(open) = &mut self.open {
                push(&mut open.points.spans, span);
            }
            begin = *end;
        }
    }

    /// Whether an arc also goes along its axis: then its points do not define its plane.
    fn climbs(&self, segment: &Segment) -> bool {
        let Some(arc) = self.arc_of(segment) else { return false };
        let [start, end] = [segment.start(), segment.end()].map(|row| self.read.xyz().of(row));
        (end - start).dot(arc.normal).abs() > 1e-9
    }

    fn arc_of(&self, segment: &Segment) -> Option<crate::part_program::Arc> {
        match self.read.steps[segment.step].what {
            What::Move(Move { path: Path::Arc(arc), .. }) => Some(self.read.arcs[arc as usize]),
            _ => None,
        }
    }

    /// A cubic or a curve as cubics of the position's columns.
    fn cubics<'s>(&'s self, segment: &'s Segment, level: Level) -> Cubics<'s> {
        let xyz = (level == Level::Tip).then(|| self.read.xyz());
        Cubics { segment, xyz, place: Box::new(move |row| self.place(row, level)) }
    }

    /// The position's columns of a row.
    fn place(&self, row: &[f64], level: Level) -> Vec<f64> {
        match level {
            Level::Joint => row[..self.read.axes()].to_vec(),
            Level::Tip => self.pose(row),
        }
    }

    /// The numbers of a point where the channels are at `row`.
    pub(super) fn point(&self, row: &[f64], level: Level, number: Option<u32>, seconds: f64) -> Vec<Finite> {
        let mut numbers = self.place(row, level);
        numbers.extend(self.used.iter().map(|i| row[*i]));
        if self.numbered {
            numbers.push(number.map_or(0.0, f64::from));
        }
        numbers.push(seconds);
        numbers.into_iter().map(finite).collect()
    }

    /// Tip and direction if X, Y and Z of a row are the tip's position.
    fn pose(&self, row: &[f64]) -> Vec<f64> {
        let mut q = Joints::default();
        for ((q, axis), value) in q.iter_mut().zip(&self.machine.axes).zip(row) {
            *q = axis.from_file(*value);
        }
        self.read.xyz().of(row).to_array().into_iter().chain(self.machine.forward(&q).direction.to_array()).collect()
    }
}

/// Adds a span of one point, to the last span if both are alike.
pub(super) fn push(spans: &mut Vec<PointSpan>, span: PointSpan) {
    match spans.last_mut() {
        // A cubic whose first speeds differ from the last ones before starts another span.
        Some(last)
            if last.along == span.along
                && last.stops == span.stops
                && span.via_mm.is_none()
                && last.speeds.last() == span.speeds.first() =>
        {
            last.speeds.extend(span.speeds.into_iter().skip(1));
            last.points.extend(span.points);
        }
        _ => spans.push(span),
    }
}
