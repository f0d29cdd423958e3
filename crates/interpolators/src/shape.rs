use crate::error::{Error, finite, positive};
use crate::path::{Base, Path};
use glam::{DVec2, DVec3};
use seamwright_geometry::{Ellipse, Quadric, Tube, TubeIntersection};
use seamwright_message::{Message, Unit};
use std::f64::consts::TAU;

/// Maximum distance of a start or end point from the ellipse, mm; within it the nearest point is used.
pub const ON_ELLIPSE_TOLERANCE_MM: f64 = 1e-3;

/// Maximum absolute sweep of a saddle, rad: ten turns.
pub const SWEEP_LIMIT_RAD: f64 = 10.0 * TAU;

/// Angle between start and end, rad, below which an ellipse is one full turn.
const SAME_POINT_RAD: f64 = 1e-9;

/// A curve with start, end and direction of travel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// The ellipse `x = a cos(u), y = b sin(u), z = 0` (ELLIPSE-2015); `u` is the eccentric angle.
    Ellipse {
        /// Semi-axis along x, mm.
        a_mm: f64,
        /// Semi-axis along y, mm; it may be the longer one.
        b_mm: f64,
        /// Start point, mm; within [`ON_ELLIPSE_TOLERANCE_MM`] of the ellipse.
        start_mm: DVec2,
        /// End point, mm, with the same tolerance; none, or the start itself, for one full turn.
        end_mm: Option<DVec2>,
        /// True for clockwise travel seen from the tip of z, that is with decreasing eccentric angle.
        clockwise: bool,
    },
    /// The saddle `x = r cos(u), y = r sin(u), z = sqrt(R^2 - r^2 sin(u)^2)`: a nozzle of radius r about the z axis on
    /// a shell of radius R about the x axis (SADDLE-2020).
    Saddle {
        /// Nozzle radius r, mm.
        nozzle_radius_mm: f64,
        /// Shell radius R, mm; greater than r.
        shell_radius_mm: f64,
        /// Start angle about the nozzle's axis, rad.
        start_rad: f64,
        /// Angle of travel, rad; negative for clockwise seen from the tip of z; absolute value up to
        /// [`SWEEP_LIMIT_RAD`].
        sweep_rad: f64,
    },
}

impl Shape {
    /// The example of ELLIPSE-2015: a = 20 mm, b = 16 mm, from (0, 16) clockwise to (20, 0).
    pub const ELLIPSE_2015: Self = Self::Ellipse {
        a_mm: 20.0,
        b_mm: 16.0,
        start_mm: DVec2::new(0.0, 16.0),
        end_mm: Some(DVec2::new(20.0, 0.0)),
        clockwise: true,
    };

    /// The sizes of SADDLE-2020: r = 250 mm, R = 800 mm, one full turn from the x axis.
    pub const SADDLE_2020: Self =
        Self::Saddle { nozzle_radius_mm: 250.0, shell_radius_mm: 800.0, start_rad: 0.0, sweep_rad: TAU };

    /// The true curve from start to end.
    ///
    /// # Errors
    /// Every [`Error`] that concerns the shape alone.
    pub fn path(&self) -> Result<Path, Error> {
        match *self {
            Self::Ellipse { a_mm, b_mm, start_mm, end_mm, clockwise } => {
                ellipse(a_mm, b_mm, start_mm, end_mm, clockwise)
            }
            Self::Saddle { nozzle_radius_mm, shell_radius_mm, start_rad, sweep_rad } => {
                saddle(nozzle_radius_mm, shell_radius_mm, start_rad, sweep_rad)
            }
        }
    }
}

fn ellipse(a: f64, b: f64, start: DVec2, end: Option<DVec2>, clockwise: bool) -> Result<Path, Error> {
    positive("motion-value-semi-axis-a", a)?;
    positive("motion-value-semi-axis-b", b)?;
    let curve = Ellipse::new(DVec3::ZERO, DVec3::Z, DVec3::X, a, b)?;
    let direction = if clockwise { -1.0 } else { 1.0 };
    let whole = Path::new(Base::Ellipse { curve, a, b }, 0.0, direction, TAU);
    let from = angle_of(&whole, "motion-start-off-ellipse", start)?;
    let span = match end {
        None => TAU,
        Some(end) => {
            let span = (direction * (angle_of(&whole, "motion-end-off-ellipse", end)? - from)).rem_euclid(TAU);
            if !(SAME_POINT_RAD..=TAU - SAME_POINT_RAD).contains(&span) { TAU } else { span }
        }
    };
    Ok(Path::new(whole.base, from, direction, span))
}

/// Eccentric angle of a point that should lie on the ellipse, in (-pi, pi]; else the error `off`.
fn angle_of(path: &Path, off: &'static str, p: DVec2) -> Result<f64, Error> {
    finite("motion-value-x", p.x)?;
    finite("motion-value-y", p.y)?;
    let near = path.nearest(p.extend(0.0));
    // This form of the comparison rejects NaN from an overflow.
    if near.distance_mm <= ON_ELLIPSE_TOLERANCE_MM {
        return Ok(near.u_rad);
    }
    let on = path.point(near.u_rad);
    let message = Message::new(off)
        .value("x", p.x, Unit::One)
        .value("y", p.y, Unit::One)
        .value("distance", near.distance_mm, Unit::Mm)
        .value("tolerance", ON_ELLIPSE_TOLERANCE_MM, Unit::Mm)
        .value("near_x", on.x, Unit::One)
        .value("near_y", on.y, Unit::One);
    Err(Error(message))
}

fn saddle(nozzle: f64, shell: f64, start: f64, sweep: f64) -> Result<Path, Error> {
    positive("motion-value-nozzle-radius", nozzle)?;
    positive("motion-value-shell-radius", shell)?;
    finite("motion-value-start-angle", start)?;
    finite("motion-value-sweep", sweep)?;
    if nozzle >= shell {
        let message = Message::new("motion-nozzle-too-large").value("nozzle", nozzle, Unit::Mm);
        return Err(Error(message.value("shell", shell, Unit::Mm)));
    }
    if sweep == 0.0 || sweep.abs() > SWEEP_LIMIT_RAD {
        let message = Message::new("motion-sweep").value("sweep", sweep, Unit::Rad);
        return Err(Error(message.value("limit", SWEEP_LIMIT_RAD, Unit::Rad)));
    }
    let tube = Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, nozzle)?;
    let body = Quadric::cylinder(DVec3::ZERO, DVec3::X, shell)?;
    let curve = TubeIntersection::new(tube, body)?;
    // Resolution of the angle is best near zero.
    let start = start.rem_euclid(TAU);
    Ok(Path::new(Base::Saddle { curve, nozzle, shell }, start, sweep.signum(), sweep.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn arc(start: DVec2, end: Option<DVec2>, clockwise: bool) -> Result<Path, Error> {
        Shape::Ellipse { a_mm: 20.0, b_mm: 16.0, start_mm: start, end_mm: end, clockwise }.path()
    }

    fn code(path: Result<Path, Error>) -> String {
        path.unwrap_err().0.code.to_string()
    }

    #[test]
    fn the_papers_quarter() {
        let p = Shape::ELLIPSE_2015.path().unwrap();
        assert!((p.start_rad() - FRAC_PI_2).abs() < 1e-15 && p.end_rad().abs() < 1e-15);
        assert!((p.span_rad() - FRAC_PI_2).abs() < 1e-15);
        assert!((p.length_mm().unwrap() - 28.361_667_888_974_5).abs() < 2e-13);
    }

    #[test]
    fn spans_and_directions() {
        let (right, top, left) = (DVec2::new(20.0, 0.0), DVec2::new(0.0, 16.0), DVec2::new(-20.0, 0.0));
        let span = |s, e, c| arc(s, e, c).unwrap().span_rad();
        assert!((span(right, Some(top), false) - FRAC_PI_2).abs() < 1e-12);
        assert!((span(right, Some(top), true) - 1.5 * PI).abs() < 1e-12);
        assert!((span(top, Some(left), false) - FRAC_PI_2).abs() < 1e-12);
        assert!((span(left, Some(top), false) - 1.5 * PI).abs() < 1e-12);
        assert!((span(left, None, false) - TAU).abs() < 1e-12);
        assert!((span(left, Some(left), true) - TAU).abs() < 1e-12);
    }

    #[test]
    fn a_rounded_start_is_taken_and_a_wrong_one_told_how_far() {
        let on = DVec2::new(20.0 * 0.7f64.cos(), 16.0 * 0.7f64.sin());
        let rounded = (on * 1e3).round() / 1e3;
        assert!((arc(rounded, None, true).unwrap().start_rad() - 0.7).abs() < 1e-4);
        let start = arc(DVec2::new(0.0, 16.5), None, true).unwrap_err().0;
        assert!(start.code == "motion-start-off-ellipse" && start.to_string().contains("0.5 mm"), "{start}");
        assert_eq!(code(arc(on, Some(DVec2::new(1.0, 1.0)), true)), "motion-end-off-ellipse");
    }

    #[test]
    fn bad_sizes() {
        let ellipse = |a, b| {
            Shape::Ellipse { a_mm: a, b_mm: b, start_mm: DVec2::new(1.0, 0.0), end_mm: None, clockwise: false }.path()
        };
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(code(ellipse(bad, 1.0)), "motion-value-not-positive");
            assert_eq!(code(ellipse(1.0, bad)), "motion-value-not-positive");
        }
        assert_eq!(code(arc(DVec2::new(f64::NAN, 0.0), None, true)), "motion-value-not-finite");
        assert!(arc(DVec2::splat(1e300), None, true).is_err());
        let saddle = |r, big, start, sweep| {
            Shape::Saddle { nozzle_radius_mm: r, shell_radius_mm: big, start_rad: start, sweep_rad: sweep }.path()
        };
        assert_eq!(code(saddle(0.0, 1.0, 0.0, 1.0)), "motion-value-not-positive");
        assert_eq!(code(saddle(2.0, 1.0, 0.0, 1.0)), "motion-nozzle-too-large");
        assert_eq!(code(saddle(1.0, 1.0, 0.0, 1.0)), "motion-nozzle-too-large");
        assert_eq!(code(saddle(1.0, 2.0, f64::NAN, 1.0)), "motion-value-not-finite");
        assert_eq!(code(saddle(1.0, 2.0, 0.0, 0.0)), "motion-sweep");
        assert_eq!(code(saddle(1.0, 2.0, 0.0, 100.0)), "motion-sweep");
        assert!((saddle(1.0, 2.0, 7.0, -1.0).unwrap().end_rad() - (6.0 - TAU)).abs() < 1e-12);
    }
}
