//! Robust lines and circles through points with outliers: least squares of distances with Tukey's weights.

use super::profile::{Sample, median};
use glam::DVec2;

/// Tukey's limit in standard deviations, and the maximum number of iterations.
const LIMIT: f64 = 4.685;
const ROUNDS: usize = 6;

/// A line has converged if its ends move by less than this part of the scale.
const SETTLED: f64 = 0.02;

/// A straight line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripeLine {
    /// A point on the line, mm.
    pub at: DVec2,
    /// Unit direction, to the right.
    pub along: DVec2,
}

impl StripeLine {
    /// Returns the signed distance of `p`, mm: positive above the line.
    #[must_use]
    pub fn off(&self, p: DVec2) -> f64 {
        self.along.perp_dot(p - self.at)
    }

    /// Returns the intersection with `other`; `None` if they are parallel to 0.1 degree.
    #[must_use]
    pub fn meets(&self, other: &Self) -> Option<DVec2> {
        let sine = self.along.perp_dot(other.along);
        let t = (other.at - self.at).perp_dot(other.along) / sine;
        (sine.abs() > 1.7e-3).then_some(self.at + t * self.along)
    }

    /// Returns the foot of `p` on the line.
    #[must_use]
    pub fn foot(&self, p: DVec2) -> DVec2 {
        self.at + self.along * self.along.dot(p - self.at)
    }
}

/// Weighted sums over points, to fit a line.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Moments {
    pub(super) n: f64,
    pub(super) sum: DVec2,
    pub(super) yy: f64,
    pub(super) yz: f64,
    pub(super) zz: f64,
}

impl Moments {
    pub(super) fn with(self, p: DVec2, weight: f64) -> Self {
        Self {
            n: self.n + weight,
            sum: self.sum + weight * p,
            yy: self.yy + weight * p.x * p.x,
            yz: self.yz + weight * p.x * p.y,
            zz: self.zz + weight * p.y * p.y,
        }
    }

    pub(super) fn less(self, o: &Self) -> Self {
        Self { n: self.n - o.n, sum: self.sum - o.sum, yy: self.yy - o.yy, yz: self.yz - o.yz, zz: self.zz - o.zz }
    }

    /// Returns the second moments about the mean: yy, yz, zz.
    fn scatter(&self) -> (f64, f64, f64) {
        let mean = self.sum * (1.0 / self.n);
        (self.yy - self.sum.x * mean.x, self.yz - self.sum.x * mean.y, self.zz - self.sum.y * mean.y)
    }

    /// Returns the minimum sum of squared distances from a line.
    pub(super) fn cost(&self) -> f64 {
        let (yy, yz, zz) = self.scatter();
        let half = (yy - zz) / 2.0;
        ((yy + zz) / 2.0 - (half * half + yz * yz).sqrt()).max(0.0)
    }

    /// Returns the line of that minimum.
    pub(super) fn line(&self) -> Option<StripeLine> {
        let (yy, yz, zz) = self.scatter();
        let angle = 0.5 * (2.0 * yz).atan2(yy - zz);
        let along = DVec2::from_angle(angle);
        let along = if along.x < 0.0 { -along } else { along };
        let line = StripeLine { at: self.sum / self.n, along };
        (self.n > 0.0 && line.at.is_finite() && along.is_finite()).then_some(line)
    }
}

/// Returns a robust scale of distances from their median, at least `floor`.
fn deviation(scratch: &mut [f64], floor: f64) -> f64 {
    (median(scratch).unwrap_or(0.0) / 0.6745).max(floor)
}

fn tukey(distance: f64, scale: f64) -> f64 {
    let u = distance / (LIMIT * scale);
    if u.abs() < 1.0 { (1.0 - u * u).powi(2) } else { 0.0 }
}

/// Fits a line to `samples`, from `start` if given; returns it with the deviation of the samples on it.
pub(super) fn line(
    samples: &[Sample],
    start: Option<StripeLine>,
    floor: f64,
    scratch: &mut Vec<f64>,
) -> Option<(StripeLine, f64)> {
    let all = || samples.iter().fold(Moments::default(), |m, s| m.with(s.at, 1.0)).line();
    let mut line = start.or_else(all)?;
    let mut scale = floor;
    let ends = [samples.first()?.at, samples.last()?.at];
    for _ in 0..ROUNDS {
        scratch.clear();
        scratch.extend(samples.iter().map(|s| line.off(s.at).abs()));
        scale = deviation(scratch, floor);
        let weighted =
            samples.iter().fold(Moments::default(), |m, s| m.with(s.at - line.at, tukey(line.off(s.at), scale)));
        if weighted.n < 3.0 {
            return None;
        }
        let next = weighted.line()?;
        let next = StripeLine { at: next.at + line.at, ..next };
        let moved = ends.map(|e| (line.off(e) - next.off(e)).abs());
        line = next;
        if moved[0].max(moved[1]) < SETTLED * scale {
            break;
        }
    }
    Some((line, scale))
}

/// A circle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct StripeArc {
    /// Centre, mm.
    pub(super) centre: DVec2,
    /// Radius, mm.
    pub(super) radius: f64,
}

impl StripeArc {
    /// Returns the signed distance of `p`, mm: positive outside.
    pub(super) fn off(&self, p: DVec2) -> f64 {
        p.distance(self.centre) - self.radius
    }

    /// Returns the circle through three points.
    pub(super) fn through(a: DVec2, b: DVec2, c: DVec2) -> Option<Self> {
        let (u, v) = (b - a, c - a);
        let twice = 2.0 * u.perp_dot(v);
        let to = DVec2::new(
            v.y * u.length_squared() - u.y * v.length_squared(),
            u.x * v.length_squared() - v.x * u.length_squared(),
        );
        let centre = a + to / twice;
        centre.is_finite().then(|| Self { centre, radius: centre.distance(a) })
    }

    /// Refines the circle by Gauss-Newton steps with Tukey's weights; returns it with the samples' deviation.
    pub(super) fn refined(mut self, samples: &[Sample], floor: f64, scratch: &mut Vec<f64>) -> Option<(Self, f64)> {
        let mut scale = floor;
        for _ in 0..2 * ROUNDS {
            scratch.clear();
            let off = |s: &Sample| self.off(s.at).abs();
            scratch.extend(samples.iter().map(off).filter(|d| *d < 8.0 * scale.max(floor)));
            scale = deviation(scratch, floor);
            let mut normal = nalgebra::Matrix3::<f64>::zeros();
            let mut right = nalgebra::Vector3::<f64>::zeros();
            for s in samples {
                let weight = tukey(self.off(s.at), scale);
                let to = (s.at - self.centre).normalize_or_zero();
                let row = nalgebra::Vector3::new(to.x, to.y, 1.0);
                normal += weight * row * row.transpose();
                right += weight * self.off(s.at) * row;
            }
            let step = normal.cholesky()?.solve(&right);
            self.centre += DVec2::new(step.x, step.y);
            self.radius += step.z;
        }
        (self.centre.is_finite() && self.radius > 0.0).then_some((self, scale))
    }
}
