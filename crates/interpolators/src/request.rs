use crate::course::{Course, walk};
use crate::dda::Dda;
use crate::eccentric_angle::EccentricAngle;
use crate::error::{Error, positive};
use crate::exact::Exact;
use crate::grid::Grid;
use crate::interpolation::Interpolation;
use crate::method::{EqualStep, Method};
use crate::path::Path;
use crate::point::Point;
use crate::shape::Shape;
use crate::statistics::{Statistics, Tally};
use crate::{comparison_integral, point_by_point};
use seamwright_message::{Message, Unit};
use std::f64::consts::TAU;

/// Maximum number of steps or pulses of a request.
pub const STEP_LIMIT: f64 = 1e9;

/// Request of an interpolation: curve, method, speed, period and pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// The curve.
    pub shape: Shape,
    /// The method.
    pub method: Method,
    /// Nominal speed v along the seam, mm/s.
    pub speed_mm_s: f64,
    /// Interpolation period T, s. The wanted step is `v T`. The pulse methods do not step by it; their speed is
    /// measured by it.
    pub period_s: f64,
    /// Pulse equivalent, mm a pulse, the same for all axes. Only the pulse methods read it.
    ///
    /// Clock of [`Method::PointByPoint`] and [`Method::ComparisonIntegral`]: `v / pulse`, so that an axis that pulses
    /// every clock moves at v. Clock of [`Method::Dda`]: such that the whole path takes `length / v`.
    pub pulse_mm: f64,
}

impl Default for Request {
    /// The example of ELLIPSE-2015 (v = 5 mm/s, T = 10 ms) by equal lengths along the curve; pulses of 1 um.
    fn default() -> Self {
        Self {
            shape: Shape::ELLIPSE_2015,
            method: Method::Exact(EqualStep::Arc),
            speed_mm_s: 5.0,
            period_s: 0.01,
            pulse_mm: 0.001,
        }
    }
}

impl Request {
    /// The wanted step: speed times period, mm.
    pub fn step_mm(&self) -> f64 {
        self.speed_mm_s * self.period_s
    }

    /// Starts the interpolation. Points are computed one by one on demand, in constant memory.
    ///
    /// # Errors
    /// Any [`Error`]: the request is checked in full before the first point.
    pub fn interpolate(&self) -> Result<Interpolation, Error> {
        let (path, length) = self.checked()?;
        let (step, period) = (self.step_mm(), self.period_s);
        Ok(match self.method {
            Method::Exact(equal) => Interpolation::new(path.clone(), Exact::new(&path, equal, step, period)?),
            Method::EccentricAngle(rule) => {
                Interpolation::new(path.clone(), EccentricAngle::new(path, rule, step, period))
            }
            Method::PointByPoint => self.pulses(path, point_by_point::pulse),
            Method::ComparisonIntegral => self.pulses(path, comparison_integral::pulse),
            Method::Dda => {
                let dda = Dda::new(&path, self.pulse_mm);
                let clock_s = length / self.speed_mm_s / dda.clocks as f64;
                pulse_points(path, dda.grid.clone(), clock_s, dda)
            }
        })
    }

    fn pulses(&self, path: Path, rule: fn(&Course) -> Option<[i64; 3]>) -> Interpolation {
        let grid = Grid::new(&path, self.pulse_mm);
        pulse_points(path, grid.clone(), self.pulse_mm / self.speed_mm_s, walk(grid, rule))
    }

    /// An empty tally for this request; add every point of [`Request::interpolate`] to it in turn.
    ///
    /// # Errors
    /// As [`Request::interpolate`].
    pub fn tally(&self) -> Result<Tally, Error> {
        let (path, length) = self.checked()?;
        Ok(Tally::new(path, length, self.period_s, (!self.method.is_pulse()).then(|| self.step_mm())))
    }

    /// Runs the whole interpolation for its statistics alone.
    ///
    /// # Errors
    /// As [`Request::interpolate`].
    pub fn statistics(&self) -> Result<Statistics, Error> {
        let mut tally = self.tally()?;
        self.interpolate()?.for_each(|point| tally.add(&point));
        Ok(tally.finish())
    }

    /// The path and its length.
    fn checked(&self) -> Result<(Path, f64), Error> {
        let path = self.shape.path()?;
        let length = path.length_mm()?;
        positive("motion-value-speed", self.speed_mm_s)?;
        positive("motion-value-period", self.period_s)?;
        let step = positive("motion-value-step", self.step_mm())?;
        let turn = length * (TAU / path.span_rad());
        let limit = length.min(turn / 8.0);
        if step > limit {
            let message = Message::new("motion-step-too-long").value("step", step, Unit::Mm);
            return Err(Error(message.value("max", limit, Unit::Mm)));
        }
        let mut steps = length / step;
        if self.method.is_pulse() {
            let pulse = positive("motion-value-pulse", self.pulse_mm)?;
            let (a, b) = path.plan_axes();
            let limit = (a.min(b) / 4.0).min(length);
            if pulse > limit {
                let message = Message::new("motion-pulse-too-large").value("pulse", pulse, Unit::Mm);
                return Err(Error(message.value("max", limit, Unit::Mm)));
            }
            // The moves of three axes sum to at most sqrt(3) times the length. The sizes must fit in integers, also for
            // a short piece of the curve.
            steps = steps.max(3f64.sqrt() * length / pulse).max(4.0 * path.size() / pulse);
        }
        if steps > STEP_LIMIT {
            let message = Message::new("motion-too-many-steps").text("steps", format!("{steps:.3e}"));
            return Err(Error(message.text("max", format!("{STEP_LIMIT:.0e}"))));
        }
        Ok((path, length))
    }
}

/// Turns clocks and lattice points into timed points in mm, their angles unwrapped.
fn pulse_points(
    path: Path,
    grid: Grid,
    clock_s: f64,
    lattice: impl Iterator<Item = (u64, [i64; 3])> + Send + 'static,
) -> Interpolation {
    let (curve, mut u_rad) = (path.clone(), path.start_rad());
    let point = move |(clock, at)| {
        let position = grid.position(at);
        let u = curve.nearest(position).u_rad;
        u_rad = u + TAU * ((u_rad - u) / TAU).round();
        Point { t_s: clock as f64 * clock_s, u_rad, position }
    };
    Interpolation::new(path, lattice.map(point))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::AngleRule;
    use crate::testing::Random;
    use glam::DVec2;

    const METHODS: [Method; 8] = [
        Method::Exact(EqualStep::Arc),
        Method::Exact(EqualStep::Chord),
        Method::EccentricAngle(AngleRule::Printed),
        Method::EccentricAngle(AngleRule::Polar),
        Method::EccentricAngle(AngleRule::Tangent),
        Method::PointByPoint,
        Method::ComparisonIntegral,
        Method::Dda,
    ];

    fn error(change: impl Fn(&mut Request)) -> Message {
        let mut request = Request { method: Method::PointByPoint, ..Request::default() };
        change(&mut request);
        let error = request.interpolate().err().unwrap();
        // As text, since NaN is not equal to itself.
        assert_eq!(request.statistics().unwrap_err().0.to_string(), error.0.to_string());
        error.0
    }

    #[test]
    fn refuses_what_cannot_be() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(error(|r| r.speed_mm_s = bad).to_string().starts_with("the speed must be a finite number greater"));
            assert!(error(|r| r.period_s = bad).to_string().starts_with("the period must be a finite number greater"));
            assert!(error(|r| r.pulse_mm = bad).to_string().starts_with("the pulse must be a finite number greater"));
        }
        assert_eq!(error(|r| r.speed_mm_s = 1e5).code, "motion-step-too-long");
        assert_eq!(error(|r| r.speed_mm_s = 1e-7).code, "motion-too-many-steps");
        assert_eq!(error(|r| r.pulse_mm = 5.0).code, "motion-pulse-too-large");
        assert_eq!(error(|r| r.pulse_mm = 1e-8).code, "motion-too-many-steps");
        assert_eq!(error(|r| (r.speed_mm_s, r.period_s) = (1e-200, 1e-200)).code, "motion-value-not-positive");
    }

    #[test]
    fn only_pulse_methods_read_the_pulse() {
        for method in METHODS {
            let request = Request { method, pulse_mm: f64::NAN, ..Request::default() };
            assert_eq!(request.interpolate().is_err(), method.is_pulse());
        }
    }

    /// A request inside, at and beyond the limits of valid requests.
    fn any(random: &mut Random) -> Request {
        let shape = if random.unit() < 0.6 {
            let (a, b) = (random.log(1e-3, 1e3), random.log(1e-3, 1e3));
            let corner = |random: &mut Random| match (random.unit() * 8.0) as u32 {
                0 => DVec2::new(a, 0.0),
                1 => DVec2::new(-a, 0.0),
                2 => DVec2::new(0.0, b),
                3 => DVec2::new(0.0, -b),
                _ => {
                    let u = random.between(0.0, TAU);
                    DVec2::new(a * u.cos(), b * u.sin())
                }
            };
            let start_mm = corner(random);
            let end_mm = match (random.unit() * 4.0) as u32 {
                0 => None,
                1 => Some(start_mm + random.log(1e-9, 1e-3) * DVec2::new(random.unit(), random.unit())),
                _ => Some(corner(random)),
            };
            Shape::Ellipse { a_mm: a, b_mm: b, start_mm, end_mm, clockwise: random.unit() < 0.5 }
        } else {
            let shell = random.log(1e-2, 1e3);
            let nozzle = if random.unit() < 0.3 { 1.0 - random.log(1e-9, 0.1) } else { random.log(1e-3, 1.0) };
            let quarter = |random: &mut Random| (random.between(-9.0, 9.0)).floor() * TAU / 4.0;
            let start_rad = if random.unit() < 0.5 { quarter(random) } else { random.between(-9.0, 9.0) };
            let sweep_rad = if random.unit() < 0.5 { quarter(random) } else { random.between(-9.0, 9.0) };
            Shape::Saddle { nozzle_radius_mm: shell * nozzle, shell_radius_mm: shell, start_rad, sweep_rad }
        };
        let method = METHODS[(random.unit() * 8.0) as usize];
        Request { shape, method, speed_mm_s: random.log(1e-3, 1e3), period_s: 1.0, pulse_mm: random.log(1e-4, 1e2) }
    }

    /// Every request is refused or runs to its end, with finite points in order of time.
    #[test]
    fn no_request_hangs_or_breaks() {
        let mut random = Random::new(11);
        let mut whole = 0;
        for _ in 0..4000 {
            let request = any(&mut random);
            let Ok(run) = request.interpolate() else { continue };
            let path = run.path().clone();
            let length = path.length_mm().unwrap();
            let (step, extra) =
                if request.method.is_pulse() { (request.pulse_mm, 0.0) } else { (request.step_mm(), 1.0) };
            if length / step > 2e4 {
                continue;
            }
            whole += 1;
            // All rules but the printed one step by at least the wanted step; at most 3 pulses per pulse of path
            // length.
            let (a, b) = path.plan_axes();
            let most = 3.0 * length / step * if extra > 0.0 { (a / b).max(b / a) } else { 1.0 } + 20.0;
            let mut tally = request.tally().unwrap();
            let (mut count, mut t) = (0.0, f64::NEG_INFINITY);
            for p in run {
                count += 1.0;
                assert!(count < most, "{request:?}: more than {most} steps");
                assert!(p.position.is_finite() && p.u_rad.is_finite() && p.t_s > t, "{request:?} {p:?}");
                t = p.t_s;
                if length / request.step_mm() < 1e4 {
                    tally.add(&p);
                }
            }
            let s = tally.finish();
            assert!(s.deviation_max_mm.is_finite() && s.chord_error_max_mm.is_finite(), "{request:?} {s:?}");
            if !matches!(request.method, Method::Dda) && s.steps > 0 {
                let slack = if request.method.is_pulse() { 0.9 * request.pulse_mm } else { 1e-12 * path.size() };
                assert!(s.end_error_mm <= slack, "{request:?} {s:?}");
            }
        }
        assert!(whole > 500);
    }
}
