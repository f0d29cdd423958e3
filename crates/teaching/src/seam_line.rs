//! A seam in space by closely spaced stations: nominal, or in its true position.

use crate::work_shape::{Patch, Shape};
use glam::DVec3;
use std::collections::HashMap;

/// Distance of stations, mm: interpolation between them is linear.
pub const STATION_MM: f64 = 0.5;
/// Side of the cubes that index the stations, mm.
const CUBE_MM: f64 = 4.0;
/// Number of rings of cubes searched: a foot is found up to about 16 mm away.
const RINGS: i64 = 4;

/// A position on a seam, in the work frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Position, mm.
    pub point: DVec3,
    /// Unit normal of the surface, out of the work: the bisector of the faces.
    pub normal: DVec3,
}

/// The point of a seam nearest to a given point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Foot {
    /// Path length of the foot, mm.
    pub way: f64,
    /// The foot itself.
    pub at: Station,
    /// Unit direction of the seam there.
    pub along: DVec3,
}

/// A seam given by stations.
#[derive(Debug, Clone)]
pub struct SeamLine {
    stations: Vec<Station>,
    ways: Vec<f64>,
    closed: bool,
    cubes: HashMap<[i64; 3], Vec<u32>>,
}

impl SeamLine {
    /// Samples the seam of `length` (mm) given by path length; if it is closed, the length is that of one turn.
    pub fn sampled(length: f64, closed: bool, at: impl Fn(f64) -> Station) -> Self {
        let count = (length / STATION_MM).ceil().clamp(2.0, 1e7);
        Self::through((0..=count as u32).map(|i| at(length * f64::from(i) / count)).collect(), closed)
    }

    /// Creates the seam through stations.
    pub fn through(stations: Vec<Station>, closed: bool) -> Self {
        let mut ways = Vec::with_capacity(stations.len());
        let mut cubes: HashMap<[i64; 3], Vec<u32>> = HashMap::new();
        let mut way = 0.0;
        for (i, station) in stations.iter().enumerate() {
            way += i.checked_sub(1).map_or(0.0, |before| stations[before].point.distance(station.point));
            ways.push(way);
            cubes.entry(cube(station.point)).or_default().push(i as u32);
        }
        Self { stations, ways, closed, cubes }
    }

    /// Returns the stations; of a closed seam the last one is the first.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Returns the path length of each station, mm.
    pub fn ways(&self) -> &[f64] {
        &self.ways
    }

    /// Returns the length, mm.
    pub fn length(&self) -> f64 {
        self.ways.last().copied().unwrap_or(0.0)
    }

    /// Returns true if the seam returns to its start.
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Returns the stations within `reach` of `point`, in order.
    pub fn around(&self, point: DVec3, reach: f64) -> Vec<usize> {
        (0..self.stations.len()).filter(|&i| self.stations[i].point.distance_squared(point) < reach * reach).collect()
    }

    /// Returns the station at path length `way`, and the direction there; clamped to the ends of an open seam.
    pub fn at(&self, way: f64) -> (Station, DVec3) {
        let way = if self.closed { way.rem_euclid(self.length()) } else { way.clamp(0.0, self.length()) };
        let i = self.ways.partition_point(|w| *w <= way).clamp(1, self.ways.len() - 1);
        let part = (way - self.ways[i - 1]) / (self.ways[i] - self.ways[i - 1]).max(f64::MIN_POSITIVE);
        (self.between(i - 1, part), self.along(i - 1))
    }

    /// Returns the foot of `point`, or `None` if it is further than some 15 mm away.
    pub fn foot(&self, point: DVec3) -> Option<Foot> {
        let nearest = self.nearest(point)?;
        let first = nearest.saturating_sub(1);
        let last = (nearest + 1).min(self.stations.len() - 1);
        let feet = (first..last).map(|i| {
            let (a, b) = (self.stations[i].point, self.stations[i + 1].point);
            let part = ((point - a).dot(b - a) / a.distance_squared(b).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            let at = self.between(i, part);
            let way = self.ways[i] + part * (self.ways[i + 1] - self.ways[i]);
            Foot { way, at, along: self.along(i) }
        });
        feet.min_by(|a, b| a.at.point.distance_squared(point).total_cmp(&b.at.point.distance_squared(point)))
    }

    fn between(&self, i: usize, part: f64) -> Station {
        let (a, b) = (&self.stations[i], &self.stations[i + 1]);
        let normal = a.normal.lerp(b.normal, part).try_normalize().unwrap_or(a.normal);
        Station { point: a.point.lerp(b.point, part), normal }
    }

    fn along(&self, i: usize) -> DVec3 {
        (self.stations[i + 1].point - self.stations[i].point).normalize_or_zero()
    }

    fn nearest(&self, point: DVec3) -> Option<usize> {
        let [x, y, z] = cube(point);
        let mut best: Option<(usize, f64)> = None;
        for ring in 0..=RINGS {
            // Minimum distance of stations in this ring.
            let least = (ring - 1).max(0) as f64 * CUBE_MM;
            if best.is_some_and(|(_, d)| d <= least) {
                break;
            }
            for i in -ring..=ring {
                for j in -ring..=ring {
                    let rim = i.abs() == ring || j.abs() == ring;
                    let step = if rim || ring == 0 { 1 } else { 2 * ring };
                    let mut k = -ring;
                    while k <= ring {
                        for &at in self.cubes.get(&[x + i, y + j, z + k]).into_iter().flatten() {
                            let d = self.stations[at as usize].point.distance(point);
                            if best.is_none_or(|(_, least)| d < least) {
                                best = Some((at as usize, d));
                            }
                        }
                        k += step;
                    }
                }
            }
        }
        best.map(|(i, _)| i)
    }
}

fn cube(p: DVec3) -> [i64; 3] {
    (p / CUBE_MM).floor().as_i64vec3().to_array()
}

/// Beside the seam the surface continues straight, square to the bisector.
impl Shape for SeamLine {
    fn near(&self, point: DVec3) -> Option<Patch> {
        self.foot(point).map(|foot| Patch { point: foot.at.point, normal: foot.at.normal })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feet_are_those_of_brute_force() {
        let at = |s: f64| Station {
            point: DVec3::new(50.0 * (s / 50.0).cos(), 50.0 * (s / 50.0).sin(), 5.0 * (s / 25.0).sin()),
            normal: DVec3::Z,
        };
        let line = SeamLine::sampled(50.0 * std::f64::consts::TAU, true, at);
        for i in 0..500 {
            let t = f64::from(i);
            let p = at(0.7 * t).point + DVec3::new((3.1 * t).sin(), (1.7 * t).cos(), (0.3 * t).sin()) * (t % 7.0);
            let foot = line.foot(p).unwrap();
            let brute = (0..62_832).map(|k| at(0.005 * f64::from(k)).point.distance(p)).fold(f64::INFINITY, f64::min);
            assert!((foot.at.point.distance(p) - brute).abs() < 2e-3, "{p}: {} {brute}", foot.at.point.distance(p));
            assert!(line.at(foot.way).0.point.distance(foot.at.point) < 1e-9);
        }
        assert!(line.foot(DVec3::Z * 400.0).is_none());
    }
}
