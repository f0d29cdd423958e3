//! The profile: points of the stripe in mm, from left to right.

use super::blob_chain::StripePoint;
use super::blobs::{Blob, Blobs, MAX_BLOBS};
use glam::DVec2;
use seamwright_geometry::Homography;

/// A point of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Column of the sensor, counted from the first point.
    pub(super) column: i32,
    /// y and z, mm; pixels, with z upwards, without a map.
    pub(super) at: DVec2,
    /// Strength of the stripe; `None` in a profile without it.
    pub(super) strength: Option<f64>,
    /// Half of its extent along its column, mm.
    pub(super) covers: f64,
}

/// Columns from one to another, both included. Where the order matters, they may run to the left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) from: i32,
    pub(super) to: i32,
}

/// Points by column, and their usual distance along y.
#[derive(Debug, Clone, Default)]
pub(super) struct Profile {
    pub(super) samples: Vec<Sample>,
    /// The samples and all blobs outside the chain, by column.
    pub(super) all: Vec<Sample>,
    /// Length of a column along y, mm.
    pub(super) pitch: f64,
    /// Length of a column or a row, whichever is longer, mm: the unit for distances from a line. Rows are much longer
    /// than columns if the camera looks at the laser's plane at a small angle.
    pub(super) grain: f64,
    /// Length of a row, mm.
    pub(super) row: f64,
    /// Column of the image at column 0, and 1 if columns run as in the image, else -1.
    pub(super) first: f64,
    pub(super) direction: f64,
    scratch: Vec<f64>,
}

/// Maximum number of columns; profiles with extreme distances are thinned to it.
const MAX_COLUMNS: f64 = 65536.0;

impl Profile {
    /// Reserves capacity for an image of this many columns.
    pub(super) fn reserve(&mut self, columns: usize) {
        self.samples.clear();
        self.samples.reserve(columns);
        self.all.clear();
        self.all.reserve(columns * MAX_BLOBS);
        self.scratch.clear();
        self.scratch.reserve(columns);
    }

    /// Takes the stripe, and all blobs, through a map from pixels to mm.
    pub(super) fn set_chain(&mut self, chain: &[StripePoint], blobs: &Blobs, to_mm: Option<&Homography>) {
        let map = |at: DVec2| match to_mm {
            Some(map) => map.map(at),
            None => Some(DVec2::new(at.x, -at.y)),
        };
        let sample = |column: usize, row: f64, strength: f64, width: f64| {
            let at = map(DVec2::new(column as f64, row))?;
            Some(Sample { column: column as i32, at, strength: Some(strength), covers: width / 2.0 })
        };
        self.samples.clear();
        self.samples.extend(chain.iter().filter_map(|p| sample(p.at.x as usize, p.at.y, p.strength, p.width)));
        self.all.clear();
        for column in 0..blobs.width() {
            let of = |b: &Blob| sample(column, f64::from(b.row), f64::from(b.strength), f64::from(b.width));
            self.all.extend(blobs.of(column).iter().filter_map(of));
        }
        // y may run against the columns.
        self.direction = 1.0;
        if let [first, .., last] = self.samples[..]
            && last.at.x < first.at.x
        {
            self.direction = -1.0;
            for samples in [&mut self.samples, &mut self.all] {
                samples.reverse();
                samples.iter_mut().for_each(|s| s.column = -s.column);
            }
        }
        let first = self.samples.first().map_or(0, |s| s.column);
        self.samples.iter_mut().chain(&mut self.all).for_each(|s| s.column -= first);
        self.first = self.direction * f64::from(first);
        self.scratch.clear();
        self.scratch.extend(
            self.samples
                .windows(2)
                .map(|w| (w[1].at.x - w[0].at.x).abs() / f64::from((w[1].column - w[0].column).max(1))),
        );
        self.pitch = median(&mut self.scratch).unwrap_or(0.0);
        let row_at = |p: &StripePoint| {
            let step = DVec2::new(0.0, 0.5);
            Some(map(p.at + step)?.distance(map(p.at - step)?))
        };
        self.scratch.clear();
        self.scratch.extend(chain.iter().step_by(16).filter_map(row_at));
        let row = median(&mut self.scratch).unwrap_or(self.pitch);
        self.grain = self.pitch.max(row);
        self.row = row;
        self.samples.iter_mut().chain(&mut self.all).for_each(|s| s.covers *= row);
    }

    /// Takes points in any order; points that are not finite count as missing.
    pub(super) fn set_points(&mut self, points: &[DVec2]) {
        self.samples.clear();
        let there = points.iter().filter(|p| p.is_finite());
        self.samples.extend(there.map(|&at| Sample { column: 0, at, strength: None, covers: 0.0 }));
        self.samples.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
        self.scratch.clear();
        self.scratch.extend(self.samples.windows(2).map(|w| w[1].at.x - w[0].at.x).filter(|d| *d > 0.0));
        self.pitch = median(&mut self.scratch).unwrap_or(0.0);
        let [first, .., last] = self.samples[..] else { return };
        self.pitch = self.pitch.max((last.at.x - first.at.x) / MAX_COLUMNS);
        if self.pitch > 0.0 {
            let (from, pitch) = (first.at.x, self.pitch);
            self.samples.iter_mut().for_each(|s| s.column = ((s.at.x - from) / pitch).round() as i32);
        }
        self.grain = self.pitch;
        self.row = self.pitch;
        self.all.clear();
        self.all.extend_from_slice(&self.samples);
    }

    pub(super) fn image_column(&self, column: f64) -> f64 {
        self.first + self.direction * column
    }

    /// Returns the approximate y of a column, mm, from the nearest point before it.
    pub(super) fn y_at(&self, column: f64) -> f64 {
        let near = self.samples.get(self.samples.partition_point(|s| f64::from(s.column) <= column).saturating_sub(1));
        near.map_or(0.0, |s| s.at.x + (column - f64::from(s.column)) * self.pitch)
    }

    /// Returns the approximate column at `y`.
    pub(super) fn column_at(&self, y: f64) -> f64 {
        let near = self.samples.get(self.samples.partition_point(|s| s.at.x <= y).saturating_sub(1));
        near.map_or(0.0, |s| f64::from(s.column) + (y - s.at.x) / self.pitch)
    }

    /// Returns the number of columns from the first point to the last.
    pub(super) fn columns(&self) -> usize {
        self.samples.last().map_or(0, |s| s.column as usize + 1)
    }

    /// Returns the samples of the columns, from left to right.
    pub(super) fn between(&self, columns: Columns) -> &[Sample] {
        within(&self.samples, columns)
    }

    /// Returns all blobs of the columns, from left to right.
    pub(super) fn all_between(&self, columns: Columns) -> &[Sample] {
        within(&self.all, columns)
    }
}

pub(super) fn within(samples: &[Sample], columns: Columns) -> &[Sample] {
    let first = samples.partition_point(|s| s.column < columns.from);
    let end = samples.partition_point(|s| s.column <= columns.to);
    &samples[first..end.max(first)]
}

/// Returns the median of `values`, and reorders them.
pub(super) fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stripe::fit::StripeLine;
    use crate::stripe::segments::Segment;
    use seamwright_testkit::Random;

    /// A level segment at this height, 1 mm per column.
    fn level(z: f64, columns: Columns) -> Segment {
        let at = |column: i32| DVec2::new(f64::from(column), z);
        let ends = [at(columns.from), at(columns.to)];
        Segment { line: StripeLine { at: ends[0], along: DVec2::X }, columns, deviation: 0.2, ends }
    }

    #[test]
    fn blobs_on_a_longer_line_are_taken_and_no_others() {
        let mut random = Random::new(7);
        let (mut taken, mut stayed) = (0, 0);
        for _ in 0..300 {
            let mut profile = Profile { grain: 1.0, ..Profile::default() };
            for column in 0..120 {
                if random.chance(0.2) {
                    continue;
                }
                // One to three blobs, one of them in the chain; some near a line, all at different heights.
                let count = 1 + random.below(3);
                let blob = |z: f64| {
                    let at = DVec2::new(f64::from(column), z);
                    Sample { column, at, strength: None, covers: 0.0 }
                };
                let blobs: Vec<Sample> =
                    (0..count).map(|_| blob(10.0 * random.below(4) as f64 + random.within(0.0, 2.0))).collect();
                profile.samples.push(blobs[random.below(count)]);
                profile.all.extend(blobs);
            }
            let cut = 20 + random.below(80) as i32;
            let segments = [level(10.0, Columns { from: 0, to: cut - 1 }), level(20.0, Columns { from: cut, to: 119 })];
            let before = profile.clone();
            let changed = profile.repick(&segments);
            let wanted = before.samples.iter().map(|sample| {
                let own = &segments[usize::from(sample.column >= cut)];
                let longer: Vec<&Segment> = segments.iter().filter(|s| s.length() > 1.5 * own.length()).collect();
                let is_better = |s: &&Sample| {
                    s.column == sample.column
                        && s.at != sample.at
                        && longer.iter().any(|g| g.line.off(s.at).abs() < g.within(1.0))
                };
                *before.all.iter().find(is_better).unwrap_or(sample)
            });
            assert!(profile.samples.iter().copied().eq(wanted));
            assert_eq!(changed, profile.samples != before.samples);
            *if changed { &mut taken } else { &mut stayed } += 1;
        }
        assert!(taken > 50 && stayed > 50, "{taken} {stayed}");
    }
}
