//! The profile: places of the stripe in mm, from left to right.

use super::chain::StripePoint;
use glam::DVec2;
use seamwright_geometry::Homography;

/// A place of the profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Column of the sensor, counted from the first place.
    pub(super) column: i32,
    /// y and z, mm (pixels, z upwards, where there is no map).
    pub(super) at: DVec2,
    /// Strength of the stripe; none in a profile that came without.
    pub(super) strength: Option<f64>,
}

/// Places by column, and their usual distance along y.
#[derive(Debug, Clone, Default)]
pub(super) struct Profile {
    pub(super) samples: Vec<Sample>,
    /// Length of a column along y, mm.
    pub(super) pitch: f64,
    scratch: Vec<f64>,
}

/// Most columns from the first place to the last: profiles with wild distances are thinned to it.
const MOST_COLUMNS: f64 = 65536.0;

impl Profile {
    /// The stripe through a map from pixels to mm.
    pub(super) fn set_chain(&mut self, chain: &[StripePoint], to_mm: Option<&Homography>) {
        let map = |at: DVec2| match to_mm {
            Some(map) => map.map(at),
            None => Some(DVec2::new(at.x, -at.y)),
        };
        self.samples.clear();
        self.samples.extend(
            chain
                .iter()
                .filter_map(|p| Some(Sample { column: p.at.x as i32, at: map(p.at)?, strength: Some(p.strength) })),
        );
        // y may run against the columns.
        if let [first, .., last] = self.samples[..]
            && last.at.x < first.at.x
        {
            self.samples.reverse();
            self.samples.iter_mut().for_each(|s| s.column = -s.column);
        }
        let first = self.samples.first().map_or(0, |s| s.column);
        self.samples.iter_mut().for_each(|s| s.column -= first);
        self.scratch.clear();
        self.scratch.extend(
            self.samples
                .windows(2)
                .map(|w| (w[1].at.x - w[0].at.x).abs() / f64::from((w[1].column - w[0].column).max(1))),
        );
        self.pitch = median(&mut self.scratch).unwrap_or(0.0);
    }

    /// Places that are given, in any order; those that are not finite are missing.
    pub(super) fn set_points(&mut self, points: &[DVec2]) {
        self.samples.clear();
        let there = points.iter().filter(|p| p.is_finite());
        self.samples.extend(there.map(|&at| Sample { column: 0, at, strength: None }));
        self.samples.sort_by(|a, b| a.at.x.total_cmp(&b.at.x));
        self.scratch.clear();
        self.scratch.extend(self.samples.windows(2).map(|w| w[1].at.x - w[0].at.x).filter(|d| *d > 0.0));
        self.pitch = median(&mut self.scratch).unwrap_or(0.0);
        let [first, .., last] = self.samples[..] else { return };
        self.pitch = self.pitch.max((last.at.x - first.at.x) / MOST_COLUMNS);
        if self.pitch > 0.0 {
            let (from, pitch) = (first.at.x, self.pitch);
            self.samples.iter_mut().for_each(|s| s.column = ((s.at.x - from) / pitch).round() as i32);
        }
    }

    /// Number of columns from the first place to the last.
    pub(super) fn columns(&self) -> usize {
        self.samples.last().map_or(0, |s| s.column as usize + 1)
    }

    /// Samples of the columns `from` to `to`, both included.
    pub(super) fn between(&self, from: i32, to: i32) -> &[Sample] {
        let first = self.samples.partition_point(|s| s.column < from);
        let end = self.samples.partition_point(|s| s.column <= to);
        &self.samples[first..end.max(first)]
    }
}

/// The middle one of `values`, which are put in another order.
pub(super) fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}
