use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::numeric::bisect;
use crate::quadric::{LineAlong, Quadric, Surface};
use crate::tube::Tube;
use glam::DVec3;
use std::f64::consts::TAU;

/// The curve where a tube's wall leaves a quadric body, parametrised by the angle about the tube's axis (rad).
///
/// At each angle the wall is a straight line; of the points where it crosses the body this is the outermost along
/// the tube's direction: the one where the line leaves the body. The height is the closed-form root of a quadratic
/// (INTERSECT-2006, generalised to any axis and any quadric); derivatives follow from differentiating
/// `F(p(phi)) = 0` once and twice, so they are exact.
#[derive(Debug, Clone, PartialEq)]
pub struct TubeIntersection {
    tube: Tube,
    body: Quadric,
    /// The wall's lines in the body's function.
    line: LineAlong,
}

/// Samples used to search the discriminant, a trigonometric polynomial of degree two with at most four extrema.
pub(crate) const SAMPLES: usize = 256;

impl TubeIntersection {
    /// The closed curve where `tube` leaves `body`.
    ///
    /// # Errors
    /// [`Error::TubeLargerThanBody`], [`Error::TubeBesideBody`], [`Error::NotClosed`], [`Error::Tangent`] or
    /// [`Error::NeverLeaves`] if the curve does not exist or is not closed and smooth.
    pub fn new(tube: Tube, body: Quadric) -> Result<Self, Error> {
        let curve = Self::unchecked(tube, body);
        curve.check()?;
        Ok(curve)
    }

    /// The unchecked curve, of which only a part is used.
    pub(crate) fn unchecked(tube: Tube, body: Quadric) -> Self {
        let line = body.line_along(tube.e3);
        Self { tube, body, line }
    }

    /// The tube.
    pub fn tube(&self) -> &Tube {
        &self.tube
    }

    /// The body.
    pub fn body(&self) -> &Quadric {
        &self.body
    }

    /// The outermost point of the wall's line through `foot`: its height (mm; NaN where the line misses the body), and
    /// half the body's gradient there with its part along the line.
    fn outermost(&self, foot: DVec3) -> Outermost {
        let (k1, k0, half) = self.body.on_line(&self.line, foot);
        let root = (k1 * k1 - self.line.k2 * k0).sqrt();
        // The root where F grows, in the form without cancellation; it also covers k2 = 0. One division for both
        // forms, since on a nozzle through the body's centre the sign of k1 is rounding and cannot be predicted.
        let size = k1.abs() + root;
        let (above, below) = if k1 > 0.0 { (-k0, size) } else { (size, self.line.k2) };
        let height = above / below;
        Outermost { height, half_gradient: half + height * self.line.ad, half_along: root }
    }

    /// The discriminant of the wall's quadratic at `phi`: positive where the wall meets the body. A trigonometric
    /// polynomial of degree two.
    pub(crate) fn discriminant(&self, phi: f64) -> f64 {
        let (k1, k0, _) = self.body.on_line(&self.line, self.tube.wall(phi).0);
        k1 * k1 - self.line.k2 * k0
    }

    /// Height of the curve at `phi` along the tube's direction from its origin, mm; NaN where the wall misses the body.
    pub(crate) fn height(&self, phi: f64) -> f64 {
        self.outermost(self.tube.wall(phi).0).height
    }

    /// Distance of the wall's point beyond a cone's apex on its own nappe, mm (infinite for other bodies).
    fn nappe_margin(&self, phi: f64) -> f64 {
        let foot = self.tube.wall(phi).0;
        self.body.beyond_apex(foot + self.outermost(foot).height * self.tube.e3)
    }

    fn check(&self) -> Result<(), Error> {
        let (k1, k0, _) = self.body.on_line(&self.line, self.tube.origin);
        let k2 = self.line.k2;
        // A line along a plane, or parallel to a cylinder's axis, crosses at most once: F must grow along it.
        let flat = k2.abs() * self.tube.radius < 1e-12;
        let grows = |phi: f64| self.body.on_line(&self.line, self.tube.wall(phi).0).0;
        if flat && samples().any(|phi| grows(phi) <= 1e-9) {
            return Err(Error::NeverLeaves);
        }
        // Relative to its largest size, so that thresholds have no unit.
        let scale = samples().map(|phi| self.discriminant(phi).abs()).fold(f64::MIN_POSITIVE, f64::max);
        let margin = |phi: f64| if flat { 1.0 } else { self.discriminant(phi) / scale };
        let axis_meets = k1 * k1 - k2 * k0 > 0.0;
        check_margin(&margin, axis_meets)?;
        check_margin(&|phi| self.nappe_margin(phi).min(1.0), axis_meets)
    }
}

/// Checks that `margin` stays positive all around.
pub(crate) fn check_margin(margin: &dyn Fn(f64) -> f64, axis_meets: bool) -> Result<(), Error> {
    let step = TAU / SAMPLES as f64;
    let edge = |bad: f64, good: f64| {
        let (good, bad) = bisect(good, bad, 60, |phi| margin(phi) > 0.0);
        0.5 * (bad + good)
    };
    let good: Vec<bool> = samples().map(|phi| margin(phi) > 0.0).collect();
    if good.iter().all(|g| !g) {
        return Err(if axis_meets { Error::TubeLargerThanBody } else { Error::TubeBesideBody });
    }
    if let Some(first_bad) = (0..SAMPLES).find(|&i| !good[i] && good[(i + SAMPLES - 1) % SAMPLES]) {
        let run = (0..SAMPLES).take_while(|k| !good[(first_bad + k) % SAMPLES]).count();
        let start = first_bad as f64 * step;
        let end = start + (run - 1) as f64 * step;
        let (from, to) = (edge(start, start - step), edge(end, end + step));
        return Err(if to - from < 1e-6 {
            Error::Tangent { at: 0.5 * (from + to) }
        } else {
            Error::NotClosed { from, to }
        });
    }
    // No sample is bad: check each local minimum between samples.
    let values: Vec<f64> = samples().map(margin).collect();
    for i in 0..SAMPLES {
        let (l, m, r) = (values[(i + SAMPLES - 1) % SAMPLES], values[i], values[(i + 1) % SAMPLES]);
        if m <= l && m <= r && m < 0.05 {
            let at = minimum(margin, (i as f64 - 1.0) * step, (i as f64 + 1.0) * step);
            if margin(at).is_nan() || margin(at) < -1e-12 {
                return Err(Error::NotClosed { from: edge(at, at - step), to: edge(at, at + step) });
            }
            if margin(at) < 1e-10 {
                return Err(Error::Tangent { at: at.rem_euclid(TAU) });
            }
        }
    }
    Ok(())
}

pub(crate) fn samples() -> impl Iterator<Item = f64> {
    (0..SAMPLES).map(|i| i as f64 * TAU / SAMPLES as f64)
}

/// Golden-section search for the minimum of `f` in [a, b].
pub(crate) fn minimum(f: &dyn Fn(f64) -> f64, mut a: f64, mut b: f64) -> f64 {
    let g = 0.5 * (5f64.sqrt() - 1.0);
    for _ in 0..60 {
        let (l, r) = (b - g * (b - a), a + g * (b - a));
        if f(l) < f(r) { b = r } else { a = l }
    }
    0.5 * (a + b)
}

/// The outermost point of a line of the wall.
struct Outermost {
    height: f64,
    half_gradient: DVec3,
    half_along: f64,
}

/// Point and first-order terms at one angle.
struct Tangency {
    point: DVec3,
    d1: DVec3,
    n1: DVec3,
    outermost: Outermost,
}

impl TubeIntersection {
    fn tangency(&self, phi: f64) -> Tangency {
        let (foot, n1, around) = self.tube.wall(phi);
        let outermost = self.outermost(foot);
        let w1 = self.tube.radius * around;
        let rise = -outermost.half_gradient.dot(w1) / outermost.half_along;
        let e3 = self.tube.e3;
        Tangency { point: foot + outermost.height * e3, d1: w1 + rise * e3, n1, outermost }
    }
}

impl Curve for TubeIntersection {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    fn jet(&self, phi: f64) -> Jet {
        let Tangency { point, d1, n1, outermost } = self.tangency(phi);
        let w2 = -self.tube.radius * n1;
        let bend = 0.5 * d1.dot(self.body.hessian(point) * d1) + outermost.half_gradient.dot(w2);
        Jet { point, d1, d2: w2 - bend / outermost.half_along * self.tube.e3 }
    }
    fn point(&self, phi: f64) -> DVec3 {
        let foot = self.tube.wall(phi).0;
        foot + self.outermost(foot).height * self.tube.e3
    }
    fn speed(&self, phi: f64) -> f64 {
        self.tangency(phi).d1.length()
    }
}

impl Edge for TubeIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        let Tangency { point, d1, n1, outermost } = self.tangency(phi);
        EdgePoint { point, d1, n1, n2: outermost.half_gradient.normalize() }
    }
}
