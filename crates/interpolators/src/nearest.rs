use crate::path::{Base, Path};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The point of the true curve nearest to a given point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Its angle, rad, in (-pi, pi]; see [`Path`].
    pub u_rad: f64,
    /// Distance to it, mm.
    pub distance_mm: f64,
}

/// Samples of the search window on a saddle if Newton's method alone is unreliable.
const SAMPLES: usize = 256;

impl Path {
    /// The nearest point to `p` on the whole closed curve, without regard to its ends: the normal distance.
    ///
    /// For an ellipse it is the global minimum: in the point's own quadrant the distance has one stationary point,
    /// found by Newton's method within a shrinking bracket. For a saddle it is the global minimum if `p` is nearer than
    /// a hundredth of the nozzle's radius and of the curve's radius of curvature. Farther off it is the best of 256
    /// samples over the window that must contain it, improved by the same method. The distance is exact to the rounding
    /// of coordinates.
    pub fn nearest(&self, p: DVec3) -> Nearest {
        let u = match &self.base {
            Base::Ellipse { a, b, .. } => nearest_on_ellipse(*a, *b, p.truncate()),
            Base::Saddle { nozzle, .. } => self.nearest_on_saddle(*nozzle, p),
        };
        Nearest { u_rad: u, distance_mm: self.point(u).distance(p) }
    }

    /// Half the derivative by the angle of the squared distance to `p`, and the derivative of that.
    fn slope(&self, u: f64, p: DVec3) -> (f64, f64) {
        let jet = self.jet_at(u);
        let off = jet.point - p;
        (off.dot(jet.d1), jet.d1.length_squared() + off.dot(jet.d2))
    }

    fn nearest_on_saddle(&self, nozzle: f64, p: DVec3) -> f64 {
        let guess = p.y.atan2(p.x);
        let jet = self.jet_at(guess);
        let off = (jet.point - p).length();
        // The nearest point is at most `off` from p, so at most 2 off from the guess; seen along z that is a chord.
        let window = 2.0 * (off / nozzle).min(1.0).asin();
        let bend = off * jet.d2.length() / jet.d1.length_squared();
        let middle = if off < 0.01 * nozzle && bend < 0.01 {
            guess
        } else {
            let at = |i: usize| guess + window * (2.0 * i as f64 / SAMPLES as f64 - 1.0);
            let distance = |u: f64| self.point(u).distance_squared(p);
            (0..=SAMPLES).map(at).min_by(|l, r| distance(*l).total_cmp(&distance(*r))).unwrap_or(guess)
        };
        let reach = if middle.total_cmp(&guess).is_eq() { window } else { 2.0 * window / SAMPLES as f64 };
        let u = bracketed_root(|u| self.slope(u, p), middle - reach, middle + reach, middle);
        if u > PI {
            u - TAU
        } else if u <= -PI {
            u + TAU
        } else {
            u
        }
    }
}

/// Eccentric angle, in (-pi, pi], of the point of the ellipse nearest to `p`.
fn nearest_on_ellipse(a: f64, b: f64, p: DVec2) -> f64 {
    // In the first quadrant the squared distance has a single minimum.
    let (x, y) = (p.x.abs(), p.y.abs());
    let slope = |t: f64| {
        let (sin, cos) = t.sin_cos();
        let off = DVec2::new(a * cos - x, b * sin - y);
        let d1 = DVec2::new(-a * sin, b * cos);
        (off.dot(d1), d1.length_squared() - off.dot(DVec2::new(a * cos, b * sin)))
    };
    let t = bracketed_root(slope, 0.0, FRAC_PI_2, (y / b).atan2(x / a));
    match (p.x < 0.0, p.y < 0.0) {
        (false, false) => t,
        (true, false) => PI - t,
        (true, true) => t - PI,
        (false, true) => -t,
    }
}

/// The root in [low, high] of a function that is at most zero at `low`, at least zero at `high`, and increasing at the
/// root. `f` gives value and derivative. Uses Newton's method from `guess`, and bisection if a step leaves the bracket
/// or the function does not increase.
fn bracketed_root(f: impl Fn(f64) -> (f64, f64), mut low: f64, mut high: f64, guess: f64) -> f64 {
    let mut u = guess;
    for _ in 0..200 {
        let (value, growth) = f(u);
        if growth > 0.0 {
            let step = value / growth;
            if step.abs() <= f64::EPSILON * u.abs() || step == 0.0 {
                return u;
            }
        }
        // At an end of the bracket the sign is known, also with rounding.
        if u >= high || (u > low && value > 0.0) {
            high = u;
        } else {
            low = u;
        }
        let newton = u - value / growth;
        let next = if growth > 0.0 && newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if next <= low || next >= high {
            return next;
        }
        u = next;
    }
    u
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Shape;
    use crate::testing::Random;

    fn brute(path: &Path, p: DVec3) -> f64 {
        let n = 4000;
        let at = |i: i32| TAU * f64::from(i) / f64::from(n);
        let d = |u: f64| path.point(u).distance(p);
        let best = (0..n).min_by(|l, r| d(at(*l)).total_cmp(&d(at(*r)))).unwrap();
        let (mut l, mut r) = (at(best - 1), at(best + 1));
        for _ in 0..80 {
            let (m, n) = (l + (r - l) / 3.0, r - (r - l) / 3.0);
            if d(m) < d(n) { r = n } else { l = m }
        }
        d(0.5 * (l + r))
    }

    #[test]
    fn ellipse_against_brute_force() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let (a, b) = (random.log(0.1, 100.0), random.log(0.1, 100.0));
            let path =
                Shape::Ellipse { a_mm: a, b_mm: b, start_mm: DVec2::new(a, 0.0), end_mm: None, clockwise: false }
                    .path()
                    .unwrap();
            let wide = random.log(1e-6, 3.0) * a.max(b);
            let on = path.point(random.between(0.0, TAU));
            for p in [
                on + wide * DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0),
                DVec3::new(random.between(-a, a), 0.0, 0.0),
                DVec3::new(0.0, random.between(-b, b), 0.0),
                DVec3::ZERO,
            ] {
                let (got, want) = (path.nearest(p).distance_mm, brute(&path, p));
                assert!((got - want).abs() < 1e-7 * a.max(b), "a {a} b {b} {p}: {got} {want}");
                assert!(got <= want + 1e-13 * a.max(b), "a {a} b {b} {p}: {got} {want}");
            }
        }
    }

    #[test]
    fn saddle_against_brute_force() {
        let mut random = Random::new(2);
        for _ in 0..1000 {
            let shell = random.between(10.0, 100.0);
            let nozzle = shell * random.between(0.05, 0.999);
            let path =
                Shape::Saddle { nozzle_radius_mm: nozzle, shell_radius_mm: shell, start_rad: 0.0, sweep_rad: 1.0 };
            let path = path.path().unwrap();
            let wide = random.log(1e-6, 1.0) * nozzle;
            let p = path.point(random.between(0.0, TAU))
                + wide * DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            let (got, want) = (path.nearest(p).distance_mm, brute(&path, p));
            assert!((got - want).abs() < 1e-6 * shell, "r {nozzle} R {shell} {p}: {got} {want}");
        }
    }

    #[test]
    fn points_of_the_curve_find_themselves() {
        for shape in [Shape::ELLIPSE_2015, Shape::SADDLE_2020] {
            let path = shape.path().unwrap();
            for i in -400..400 {
                let u = PI * f64::from(i) / 400.0;
                let near = path.nearest(path.point(u));
                let turn = (near.u_rad - u).rem_euclid(TAU);
                assert!(near.distance_mm < 1e-12 && turn.min(TAU - turn) < 1e-13, "{u} {near:?}");
            }
        }
    }
}
