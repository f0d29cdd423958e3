use super::Source;
use super::line::{RawPoint, TaughtLine};
use glam::DVec3;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// A point of the smoothed line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Way along the raw points, mm.
    pub way: f64,
    /// In the work frame, mm.
    pub point: DVec3,
    /// The surface's unit normal, out of the work.
    pub normal: DVec3,
    /// Mean confidence of the points it comes from; 0 where it bridges a stretch without any.
    pub confidence: f64,
}

/// Fewest points that a parabola goes through the middle of.
const FEWEST: usize = 7;

/// The line through `line`'s points, every `every` mm and at both ends: at each place the parabola by way that is nearest to
/// the points within `window` mm to both sides, weighted by confidence and nearness. Where there are too few (a tack that was
/// coasted over) the window widens to both sides until there are some beyond the gap.
///
/// A line that closes is smoothed over its start: then give `closed`.
pub fn smoothed(line: &TaughtLine, every: f64, window: f64, closed: bool) -> Vec<LinePoint> {
    let count = (line.length() / every).ceil().max(1.0);
    if line.points().len() < FEWEST || !count.is_finite() || !(window > 0.0) {
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

/// The points by way; of a closed line a turn before and after too.
struct Track {
    ways: Vec<f64>,
    points: Vec<RawPoint>,
}

impl Track {
    fn new(line: &TaughtLine, closed: bool) -> Self {
        let turns: &[f64] = if closed { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        let (mut ways, mut points) = (Vec::new(), Vec::new());
        for turn in turns {
            // The last point is the first one again, seen anew.
            ways.extend(line.ways().iter().map(|w| w + turn * line.length()));
            points.extend_from_slice(line.points());
        }
        Self { ways, points }
    }

    fn at(&self, way: f64, window: f64) -> LinePoint {
        let range = |reach: f64| {
            (self.ways.partition_point(|w| *w < way - reach), self.ways.partition_point(|w| *w <= way + reach))
        };
        let (mut reach, mut bridged) = (window, false);
        let (ends, most) =
            ((self.ways[0], self.ways[self.ways.len() - 1]), self.ways[self.ways.len() - 1] - self.ways[0]);
        let (mut first, mut last) = range(reach);
        // Points to both sides, or to one at an end of the line.
        let enough = |first: usize, last: usize| {
            let here = self.ways.partition_point(|w| *w < way);
            let (before, after) = (here.saturating_sub(first), last.saturating_sub(here));
            let near_end = (way - ends.0 < 0.5 * window, ends.1 - way < 0.5 * window);
            last - first >= FEWEST && (before > 1 || near_end.0) && (after > 1 || near_end.1)
        };
        while !enough(first, last) && reach < most {
            reach *= 1.25;
            bridged = true;
            (first, last) = range(reach);
        }
        self.parabola(way, reach, (first, last), bridged)
    }

    fn parabola(&self, way: f64, reach: f64, (first, last): (usize, usize), bridged: bool) -> LinePoint {
        let mut normal = Matrix3::zeros();
        let mut right = SMatrix::<f64, 3, 3>::zeros();
        let (mut across, mut weights, mut confidence) = (DVec3::ZERO, 0.0, 0.0);
        let origin = self.points[first].point;
        for (w, p) in self.ways[first..last].iter().zip(&self.points[first..last]) {
            let u = (w - way) / reach;
            // An operator's point stands alone among thousands of the eye's.
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
        let mean = || self.points[first..last].iter().map(|p| p.point - origin).sum::<DVec3>() / (last - first) as f64;
        LinePoint {
            way,
            point: origin + found.filter(|p| p.is_finite()).unwrap_or_else(mean),
            normal: across.try_normalize().unwrap_or(self.points[first].normal),
            confidence: if bridged { 0.0 } else { confidence / weights },
        }
    }
}
