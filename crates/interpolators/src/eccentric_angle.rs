use crate::method::AngleRule;
use crate::path::Path;
use crate::point::Point;

/// Minimum remainder that gets its own step, as a fraction of a step.
const NO_REMAINDER: f64 = 1e-9;

/// Steps of the angle; see [`AngleRule`].
///
/// Rounding accumulates in the angle alone, some 1e-16 rad a step. Each point is computed from the angle and lies on
/// the curve.
pub(crate) struct EccentricAngle {
    path: Path,
    rule: AngleRule,
    step: f64,
    period: f64,
    next: Option<Point>,
    /// Periods since the start.
    number: u64,
    /// Polar angle of the last point, rad; only [`AngleRule::Polar`] uses it.
    polar: f64,
}

impl EccentricAngle {
    pub(crate) fn new(path: Path, rule: AngleRule, step: f64, period: f64) -> Self {
        let u_rad = path.start_rad();
        let (a, b) = path.plan_axes();
        let next = Some(Point { t_s: 0.0, u_rad, position: path.point(u_rad) });
        Self { polar: polar(a, b, u_rad), path, rule, step, period, next, number: 0 }
    }

    /// The angle one step after the point; also advances the polar angle.
    fn advance(&mut self, from: &Point) -> f64 {
        let direction = self.path.direction();
        // On a saddle the centre is the nozzle's axis.
        let by_radius = direction * self.step / from.position.truncate().length();
        match self.rule {
            AngleRule::Printed => from.u_rad + by_radius,
            AngleRule::Polar => {
                let (a, b) = self.path.plan_axes();
                self.polar += by_radius;
                // The inverse is the polar angle of the ellipse with exchanged axes.
                polar(b, a, self.polar)
            }
            AngleRule::Tangent => from.u_rad + direction * self.step / self.path.jet_at(from.u_rad).d1.length(),
        }
    }

    fn after(&mut self, from: &Point) -> Option<Point> {
        let (direction, end) = (self.path.direction(), self.path.end_rad());
        let rest = direction * (end - from.u_rad);
        if rest <= 0.0 {
            return None;
        }
        let u = self.advance(from);
        let part = rest / (direction * (u - from.u_rad));
        self.number += 1;
        Some(if part <= 1.0 + NO_REMAINDER {
            let t_s = self.period * ((self.number - 1) as f64 + part.min(1.0));
            Point { t_s, u_rad: end, position: self.path.point(end) }
        } else {
            Point { t_s: self.period * self.number as f64, u_rad: u, position: self.path.point(u) }
        })
    }
}

/// The angle psi with `tan(psi) = (b/a) tan(t)` in the same quadrant and turn as `t`.
fn polar(a: f64, b: f64, t: f64) -> f64 {
    let (sin, cos) = t.sin_cos();
    t + ((b - a) * sin * cos / (a * cos * cos + b * sin * sin)).atan()
}

impl Iterator for EccentricAngle {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        let point = self.next.take()?;
        self.next = self.after(&point);
        Some(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Method;
    use crate::request::Request;
    use crate::shape::Shape;
    use crate::testing::Random;
    use std::f64::consts::TAU;

    const RULES: [AngleRule; 3] = [AngleRule::Printed, AngleRule::Polar, AngleRule::Tangent];

    fn spread(shape: Shape, rule: AngleRule, step: f64) -> (f64, f64) {
        let method = Method::EccentricAngle(rule);
        let request = Request { shape, method, speed_mm_s: step / 0.01, period_s: 0.01, ..Request::default() };
        let s = request.statistics().unwrap().step;
        (s.min_percent, s.max_percent)
    }

    #[test]
    fn the_papers_example() {
        let of = |rule| spread(Shape::ELLIPSE_2015, rule, 0.05);
        let (low, high) = of(AngleRule::Printed);
        assert!((-20.0..-19.9).contains(&low) && (24.9..25.0).contains(&high), "{low} {high}");
        let (low, high) = of(AngleRule::Polar);
        assert!(low > -0.01 && (2.4..2.6).contains(&high), "{low} {high}");
        let (low, high) = of(AngleRule::Tangent);
        assert!(low.abs().max(high.abs()) < 0.0325 && low.abs().max(high.abs()) > 0.0315, "{low} {high}");
    }

    #[test]
    fn tangent_error_is_of_first_order_in_the_step() {
        for shape in [Shape::ELLIPSE_2015, Shape::SADDLE_2020] {
            let worst = |step| {
                let (low, high) = spread(shape, AngleRule::Tangent, step);
                high.max(-low)
            };
            let ratio = worst(0.4) / worst(0.1);
            assert!((3.9..4.1).contains(&ratio), "{ratio}");
        }
    }

    #[test]
    fn equal_angles_on_the_saddle_are_uneven() {
        // |dP/du| / r is 1 on the axes and sqrt(1 + (r sin cos / z)^2) between them.
        let (low, high) = spread(Shape::SADDLE_2020, AngleRule::Printed, 0.2);
        assert!(low.abs() < 0.01, "{low}");
        let steepest = (0..10_000)
            .map(|i| f64::from(i) * 1e-4 * TAU / 4.0)
            .map(|u| (250.0 * u.sin() * u.cos() / (800f64.powi(2) - (250.0 * u.sin()).powi(2)).sqrt()).hypot(1.0))
            .fold(0.0, f64::max);
        assert!((high - 100.0 * (steepest - 1.0)).abs() < 1e-3, "{high} {steepest}");
        assert_eq!(spread(Shape::SADDLE_2020, AngleRule::Polar, 0.2), (low, high));
    }

    #[test]
    fn every_point_is_on_the_curve_and_the_end_is_reached() {
        let mut random = Random::new(5);
        for i in 0..300 {
            let shape = if i % 3 == 0 { random.saddle(5.0, 100.0, 0.98) } else { random.ellipse(0.5, 50.0) };
            let path = shape.path().unwrap();
            let step = random.log(0.002, 0.1) * path.length_mm().unwrap() / path.span_rad();
            for rule in RULES {
                let method = Method::EccentricAngle(rule);
                let request = Request { shape, method, speed_mm_s: step, period_s: 1.0, ..Request::default() };
                let Ok(run) = request.interpolate() else { continue };
                let (mut last, mut travelled, mut t) = (f64::NAN, f64::NEG_INFINITY, f64::NEG_INFINITY);
                for p in run {
                    let off = match shape {
                        Shape::Ellipse { a_mm, b_mm, .. } => (p.position.x / a_mm).hypot(p.position.y / b_mm) - 1.0,
                        Shape::Saddle { nozzle_radius_mm: r, shell_radius_mm: big, .. } => {
                            let nozzle = p.position.x.hypot(p.position.y) / r - 1.0;
                            nozzle.abs().max((p.position.y.hypot(p.position.z) / big - 1.0).abs())
                        }
                    };
                    assert!(off.abs() < 1e-14, "{shape:?} {off}");
                    let angle = path.direction() * (p.u_rad - path.start_rad());
                    assert!(angle > travelled && p.t_s > t && p.t_s < t + 1.0 + 1e-9 || t < 0.0, "{shape:?} {p:?}");
                    (last, travelled, t) = (p.u_rad, angle, p.t_s);
                }
                assert!((last - path.end_rad()).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn polar_angle_there_and_back() {
        for i in -300..300 {
            let t = f64::from(i) * 0.05;
            let psi = polar(20.0, 16.0, t);
            assert!((psi.tan() - 0.8 * t.tan()).abs() < 1e-12 * (1.0 + psi.tan().powi(2)) && (psi - t).abs() < 0.2);
            assert!((polar(16.0, 20.0, psi) - t).abs() < 1e-14 * (1.0 + t.abs()));
        }
    }
}
