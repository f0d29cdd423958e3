//! Lap joints: the end of an upper sheet on a lower one.

use super::completeness::Part;
use super::groove::SHOULDERS;
use super::{Support, View, ramp, turn};
use crate::stripe::features::{Feature, Features, NoFeatures, Quantity};
use crate::stripe::light::Course;
use crate::stripe::profile::Columns;

/// Maximum apparent overlap of the sheets of a lap joint, columns.
const OVERLAP: f64 = 8.0;

/// Distance beyond the end of the upper sheet from which its line must be dark, columns.
const AFTER_EDGE: i32 = 2;

impl View<'_> {
    /// Detects two parallel sheets, one higher than the other by a step.
    pub(super) fn lap(&mut self) -> Result<Features, NoFeatures> {
        let (Some(&first), Some(&last)) = (self.segments.first(), self.segments.last()) else {
            return Err(NoFeatures::NoStep);
        };
        if self.segments.len() < 2 || turn(&first.line, &last.line).abs() > SHOULDERS {
            return Err(NoFeatures::NoStep);
        }
        let left = self.edge(&first, last.columns.from).ok_or(NoFeatures::NoStep)?;
        let right = self.edge(&last, first.columns.to).ok_or(NoFeatures::NoStep)?;
        // The end of the upper sheet is above the other sheet's line.
        let (upper, lower) = if last.line.off(left.at) > 0.0 { (left, last) } else { (right, first) };
        let height = lower.line.off(upper.at);
        let share = self.share(self.samples(), &[first, last]);
        let apart = (right.column - left.column) * self.pitch();
        if height < self.task.least_step
            || share < 0.55
            || apart > 1.2 * height + 10.0 * self.pitch()
            || apart < -OVERLAP * self.pitch()
        {
            return Err(NoFeatures::NoStep);
        }
        let (line, step) = if lower == last { (first.line, 1) } else { (last.line, -1) };
        let seen = if upper.hidden || self.hidden(&upper, &line, step, &[first, last]) { 0.0 } else { 1.0 };
        let (a, b) = (left.column.round() as i32, right.column.round() as i32);
        let (of_left, of_right) = if step > 0 { (Some(AFTER_EDGE), None) } else { (None, Some(AFTER_EDGE)) };
        let end = self.profile.columns() as i32 - 1;
        let (on_left, on_right) = (Columns { from: 0, to: a - 1 }, Columns { from: b + 1, to: end });
        let parts = [
            Part { course: Course::Line(first.line), columns: on_left, dark_after: [None, of_left] },
            Part { course: Course::Line(last.line), columns: on_right, dark_after: [of_right, None] },
        ];
        let cover = seen * self.cover(&parts);
        let margin = ramp(height / self.task.least_step, 1.0, 1.2) * ramp(share, 0.7, 0.85);
        let mut values =
            [(Quantity::Height, height), (Quantity::Bend, turn(&first.line, &last.line)), (Quantity::Gap, 0.0)];
        let known = match self.task.thickness {
            Some(thickness) => {
                values[2].1 = (height - thickness).max(0.0);
                3
            }
            None => 2,
        };
        let points = [(Feature::Joint, lower.line.foot(upper.at)), (Feature::UpperEdge, upper.at)];
        let segments = [first, last];
        let support = Support { share, segments: &segments, margin, cover, covered: false };
        Ok(self.features(&points, &values[..known], &support))
    }
}
