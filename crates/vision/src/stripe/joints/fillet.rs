use super::completeness::Part;
use super::{Support, View, ramp, turn};
use crate::stripe::edges::Usual;
use crate::stripe::features::{Feature, Features, NoFeatures, Quantity};
use crate::stripe::light::Course;
use crate::stripe::profile::Columns;
use crate::stripe::segments::Segment;
use glam::DVec2;
use std::f64::consts::PI;

/// Limits of the angle between the faces, degrees; the confidence falls to 0 [`MARGIN_DEG`] beyond.
const ANGLES_DEG: [f64; 2] = [60.0, 120.0];
const MARGIN_DEG: f64 = 6.0;

/// Maximum distance of an end from the corner without a gap, columns or rows: the stripe's width rounds the corner.
const ROUNDED: f64 = 3.0;

/// Minimum part of the columns on each face for no and for full confidence.
const FACE: [f64; 2] = [0.04, 0.1];

impl View<'_> {
    /// Detects two faces that meet in a valley and make up the whole profile.
    pub(super) fn fillet(&mut self) -> Result<Features, NoFeatures> {
        let (a, b) = self.faces().ok_or(NoFeatures::NoCorner)?;
        let angle = PI - turn(&a.line, &b.line);
        let degrees = angle.to_degrees();
        let inside = (degrees - ANGLES_DEG[0]).min(ANGLES_DEG[1] - degrees);
        let at = a.line.meets(&b.line).ok_or(NoFeatures::NoCorner)?;
        if inside < -MARGIN_DEG {
            return Err(NoFeatures::NoCorner);
        }
        let change = self.change(&a, &b, self.profile.column_at(at.x)).ok_or(NoFeatures::NoCorner)?;
        // All points must lie on the two faces: shoulders would make it a groove.
        let (clear, last) = (Some(self.clear_of(&a.line, &b.line)), self.profile.columns() as i32 - 1);
        let (on_a, on_b) = (Columns { from: 0, to: change - 1 }, Columns { from: change, to: last });
        let parts = [
            Part { course: Course::Line(a.line), columns: on_a, dark_after: [None, clear] },
            Part { course: Course::Line(b.line), columns: on_b, dark_after: [clear, None] },
        ];
        let cover = self.cover(&parts);
        if cover <= 0.0 {
            return Err(NoFeatures::NoCorner);
        }
        let gap = self.fillet_gap(&a, &b, at, change);
        let shorter = f64::from(change.min(last - change)) / f64::from(last);
        let margin = ramp(inside, -MARGIN_DEG, MARGIN_DEG / 2.0) * ramp(shorter, FACE[0], FACE[1]);
        let support = Support { share: 1.0, segments: &[a, b], margin, cover, covered: true };
        Ok(self.features(&[(Feature::Joint, at)], &[(Quantity::Gap, gap), (Quantity::Angle, angle)], &support))
    }

    /// Returns the longest lines that meet in a valley.
    fn faces(&self) -> Option<(Segment, Segment)> {
        let (s, lengths) = (self.segments, self.lengths());
        let pairs = (0..s.len()).flat_map(|i| (i + 1..s.len()).map(move |j| (i, j)));
        let valleys = pairs.filter(|(i, j)| turn(&s[*i].line, &s[*j].line) > 0.6);
        let length = |(i, j): &(usize, usize)| lengths[*i] + lengths[*j];
        valleys.max_by(|a, b| length(a).total_cmp(&length(b))).map(|(i, j)| (s[i], s[j]))
    }

    /// Returns the distance of one face's end from the other face: 0 if both reach the corner. The face that does not
    /// end continues past the corner to the other one's shadow.
    fn fillet_gap(&mut self, a: &Segment, b: &Segment, at: DVec2, change: i32) -> f64 {
        let corner = self.profile.column_at(at.x);
        let (ends, sign) = if f64::from(change) < corner { (a, 1.0) } else { (b, -1.0) };
        if sign * (corner - f64::from(change)) < ROUNDED {
            return 0.0;
        }
        // Near the corner the other face adds light.
        let clear = (corner - sign * f64::from(self.clear_of(&a.line, &b.line))).round() as i32;
        let inner = if sign > 0.0 { change - 1 } else { change };
        let end = self.end_at(ends, inner, clear + if sign > 0.0 { -1 } else { 1 });
        let sine = turn(&a.line, &b.line).sin();
        end.map_or(0.0, |e| (sign * (at - e.at).dot(ends.line.along)).max(0.0) * sine)
    }

    /// Returns the first column with the stripe on the right face instead of the left one; among equals the nearest to
    /// the corner.
    fn change(&mut self, a: &Segment, b: &Segment, corner: f64) -> Option<i32> {
        let (from, to) = ((a.columns.from + a.columns.to) / 2, (b.columns.from + b.columns.to) / 2);
        let [left, right] = [(a, from), (b, to)].map(|(s, middle)| {
            let end = if middle == from { s.columns.to } else { s.columns.from };
            self.look_along(&Course::Line(s.line), Columns { from: middle, to: end });
            Usual::of(self.strip, self.scratch)
        });
        let (left, right) = (left?, right?);
        self.look_along(&Course::Line(a.line), Columns { from, to });
        self.scratch.clear();
        self.scratch.extend(self.strip.iter().map(|v| left.evidence(*v)));
        self.look_along(&Course::Line(b.line), Columns { from, to });
        let (mut sum, mut most, mut change) = (0.0, 0.0, from);
        for (i, (on_left, light)) in self.scratch.iter().zip(self.strip.iter()).enumerate() {
            sum += on_left - right.evidence(*light);
            let column = from + i as i32 + 1;
            let nearer = (f64::from(column) - 0.5 - corner).abs() < (f64::from(change) - 0.5 - corner).abs();
            if sum > most + 1e-9 || (sum > most - 1e-9 && nearer) {
                (most, change) = (sum, column);
            }
        }
        Some(change)
    }
}
