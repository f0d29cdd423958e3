use crate::part_program::Xyz;
use crate::play::Segment;
use seamwright_document::Finite;
use std::ops::Range;

/// Maximum error of a cubic that replaces a segment, mm, degrees or parts of 1.
const SAME: f64 = 1e-7;
/// Part of a segment for differences.
const STEP: f64 = 1e-4;
/// Shortest part of a segment that has a cubic of its own.
const SHORTEST: f64 = 1.0 / 4096.0;

/// The columns of a row's position.
pub(super) type Place<'a> = Box<dyn Fn(&[f64]) -> Vec<f64> + 'a>;

/// A segment of a part program, a cubic or a curve, as cubics in time of the columns of a point's position.
pub(super) struct Cubics<'a> {
    pub(super) segment: &'a Segment,
    /// Channels of X, Y and Z where the columns are those of a pose.
    pub(super) xyz: Option<Xyz>,
    /// The columns of a row.
    pub(super) place: Place<'a>,
}

impl Cubics<'_> {
    /// Ends of the cubics, as parts of the segment: one cubic, unless its directions or its even feed bend it.
    pub(super) fn ends(&self) -> Vec<f64> {
        let mut ends = Vec::new();
        self.halve(0.0..1.0, &mut ends);
        ends
    }

    /// Adds the ends of the cubics in this part of the segment.
    fn halve(&self, Range { start, end }: Range<f64>, ends: &mut Vec<f64>) {
        if end - start <= SHORTEST || self.is_near(start..end) {
            return ends.push(end);
        }
        let middle = 0.5 * (start + end);
        self.halve(start..middle, ends);
        self.halve(middle..end, ends);
    }

    /// Whether one cubic equals this part of the segment.
    fn is_near(&self, Range { start, end }: Range<f64>) -> bool {
        let ([p0, p1], [v0, v1]) = ([start, end].map(|f| self.at(f)), [start, end].map(|f| self.speeds(f)));
        let time = self.segment.seconds * (end - start);
        [0.25, 0.5, 0.75].into_iter().all(|f: f64| {
            let g = 1.0 - f;
            self.at(start + f * (end - start)).iter().enumerate().all(|(i, place)| {
                let bend = time * f * g * (g * v0[i].get() - f * v1[i].get());
                let cubic = p0[i] + f * f * (3.0 - 2.0 * f) * (p1[i] - p0[i]) + bend;
                (cubic - place).abs() <= SAME
            })
        })
    }

    fn at(&self, f: f64) -> Vec<f64> {
        let mut row = Vec::new();
        self.segment.at(f, &mut row);
        (self.place)(&row)
    }

    /// Speeds at the part `f` of the segment in the position's columns, per s.
    pub(super) fn speeds(&self, f: f64) -> Vec<Finite> {
        let mut speeds = self.segment.speeds(f).unwrap_or_default();
        if let Some(xyz) = self.xyz {
            // Directions turn with the rotary axes: by differences.
            let ends = [(f - STEP).max(0.0), (f + STEP).min(1.0)];
            let [a, b] = ends.map(|f| self.at(f));
            let time = (ends[1] - ends[0]) * self.segment.seconds;
            speeds = xyz.of(&speeds).to_array().into_iter().chain((3..6).map(|k| (b[k] - a[k]) / time)).collect();
        }
        speeds.into_iter().map(|v| Finite::new(v).unwrap_or_default()).collect()
    }
}
