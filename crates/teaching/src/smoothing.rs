use crate::taught_line::{GAP_MM, RawPoint, Source, TaughtLine};
use glam::DVec3;
use nalgebra::{Matrix3, SMatrix, Vector3};
use std::ops::Range;

/// A point of the smoothed line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Distance along the raw points, mm.
    pub way: f64,
    /// In the work frame, mm.
    pub point: DVec3,
    /// The surface's unit normal, out of the work.
    pub normal: DVec3,
    /// Mean confidence of its source points; 0 where it bridges a gap.
    pub confidence: f64,
}

/// Minimum number of points of a parabola.
const FEWEST: usize = 7;
/// Minimum fraction of a window covered by points; beside a gap or at an end the window is widened to reach it.
const COVERED: f64 = 0.7;

/// Smooths `line` to points every `every` mm and at both ends. Each lies on the least-squares parabola through the
/// points within `window` mm to both sides, weighted by confidence and nearness. The window is wider over a gap (such
/// as an extrapolated tack), beside one and at the ends, to cover enough of the line.
///
/// With `closed` the line is smoothed over its start.
pub fn smoothed(line: &TaughtLine, every: f64, window: f64, closed: bool) -> Vec<LinePoint> {
    let count = (line.length() / every).ceil().max(1.0);
    if line.points().len() < FEWEST || !count.is_finite() || !(f64::MIN_POSITIVE..).contains(&window) {
        let plain = |(p, way): (&RawPoint, &f64)| LinePoint {
            way: *way,
            point: p.point,
            normal: p.normal,
            confidence: p.confidence,
        };
        return line.points().iter().zip(line.ways()).map(plain).collect();
    }
    let track = Track::new(line, closed);
    (0..=count as usize).map(|k| track.at(line.length() * k as f64 / count, window)).collect()
}

/// Points by distance; of a closed line also one turn before and after.
struct Track {
    ways: Vec<f64>,
    points: Vec<RawPoint>,
    /// Distance up to each without gaps, mm.
    covered: Vec<f64>,
}

impl Track {
    fn new(line: &TaughtLine, closed: bool) -> Self {
        let turns: &[f64] = if closed { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        let (mut ways, mut points) = (Vec::new(), Vec::new());
        for turn in turns {
            // The last point is the first one again, from another frame.
            ways.extend(line.ways().iter().map(|w| w + turn * line.length()));
            points.extend_from_slice(line.points());
        }
        let mut sum = 0.0;
        let steps = ways.iter().enumerate().map(|(i, way)| {
            let step = i.checked_sub(1).map_or(0.0, |before| way - ways[before]);
            sum += if step > GAP_MM { 0.0 } else { step };
            sum
        });
        let covered = steps.collect();
        Self { ways, points, covered }
    }

    fn at(&self, way: f64, window: f64) -> LinePoint {
        let here = self.ways.partition_point(|w| *w < way).min(self.ways.len() - 1);
        let (before, after) = (self.ways[here.saturating_sub(1)], self.ways[here]);
        let bridged = after - before > GAP_MM;
        // Reaches the points on both sides of a gap, and covers as much of the line as elsewhere.
        let mut reach = if bridged { (way - before).max(after - way) + COVERED * window } else { window };
        let whole = self.ways[self.ways.len() - 1] - self.ways[0];
        loop {
            let first = self.ways.partition_point(|w| *w < way - reach);
            let last = self.ways.partition_point(|w| *w <= way + reach);
            let covered = if last > first { self.covered[last - 1] - self.covered[first] } else { 0.0 };
            if reach > whole || (covered >= 2.0 * COVERED * window && last - first >= FEWEST) {
                return self.parabola(way, reach, first..last, bridged);
            }
            reach *= 1.2;
        }
    }

    /// Returns the point at `way` on the parabola through the `near` points, which are within `reach`.
    fn parabola(&self, way: f64, reach: f64, near: Range<usize>, bridged: bool) -> LinePoint {
        let mut normal = Matrix3::zeros();
        let mut right = SMatrix::<f64, 3, 3>::zeros();
        let (mut across, mut weights, mut confidence) = (DVec3::ZERO, 0.0, 0.0);
        let (ways, points) = (&self.ways[near.clone()], &self.points[near]);
        let origin = points[0].point;
        for (w, p) in ways.iter().zip(points) {
            let u = (w - way) / reach;
            // An operator's point is alone among thousands of detected ones.
            let trust = if p.source == Source::Operator { 10.0 } else { p.confidence.max(1e-3) };
            let weight = trust * (1.0 - 0.9 * u * u).max(0.0).powi(2);
            let basis = Vector3::new(1.0, u, u * u);
            normal += weight * basis * basis.transpose();
            right += weight * basis * Vector3::from((p.point - origin).to_array()).transpose();
            across += weight * p.normal;
            weights += weight;
            confidence += weight * p.confidence;
        }
        let found = normal.cholesky().map(|c| c.solve(&right)).map(|m| DVec3::new(m[(0, 0)], m[(0, 1)], m[(0, 2)]));
        let mean = || points.iter().map(|p| p.point - origin).sum::<DVec3>() / points.len() as f64;
        LinePoint {
            way,
            point: origin + found.filter(|p| p.is_finite()).unwrap_or_else(mean),
            normal: across.try_normalize().unwrap_or(points[0].normal),
            confidence: if bridged { 0.0 } else { confidence / weights },
        }
    }
}
