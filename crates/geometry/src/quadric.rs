use crate::error::{Error, positive, unit};
use glam::{DMat3, DVec3};

/// A surface given as the zero set of a function that is negative inside the body and positive outside.
pub trait Surface {
    /// The function's value at `p`; zero on the surface.
    fn value(&self, p: DVec3) -> f64;
    /// The function's gradient at `p`: on the surface it points out of the body.
    fn gradient(&self, p: DVec3) -> DVec3;
    /// The function's Hessian at `p`.
    fn hessian(&self, p: DVec3) -> DMat3;
}

fn outer(u: DVec3, v: DVec3) -> DMat3 {
    DMat3::from_cols(u * v.x, u * v.y, u * v.z)
}

/// A quadric body: plane, sphere, cylinder, cone or ellipsoid.
///
/// `F(p) = d^T A d + 2 b^T d + c` with `d = p - centre`, scaled so that the gradient's length is about 1 on the
/// surface (so that `F` is about the distance in mm near it); for a cone it is the distance from the apex.
#[derive(Debug, Clone, PartialEq)]
pub struct Quadric {
    pub(crate) centre: DVec3,
    pub(crate) a: DMat3,
    pub(crate) b: DVec3,
    pub(crate) c: f64,
    /// A cone's own nappe: only points with `(p - centre) . axis > 0` belong to it.
    pub(crate) nappe: Option<DVec3>,
}

/// Lines of one direction through a quadric: half the second derivative along them, and the change of the gradient.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LineAlong {
    /// Half the change of the gradient per mm along the line.
    pub(crate) ad: DVec3,
    /// Coefficient of h^2.
    pub(crate) k2: f64,
    bd: f64,
}

impl Quadric {
    /// The half-space below the plane through `point` with outward `normal`.
    ///
    /// # Errors
    /// [`Error::Direction`].
    pub fn plane(point: DVec3, normal: DVec3) -> Result<Self, Error> {
        let n = unit("geometry-plane-normal", normal)?;
        Self::checked(Self { centre: point, a: DMat3::ZERO, b: 0.5 * n, c: 0.0, nappe: None })
    }

    /// A sphere.
    ///
    /// # Errors
    /// [`Error::Size`].
    pub fn sphere(centre: DVec3, radius: f64) -> Result<Self, Error> {
        let r = positive("geometry-sphere-radius", radius)?;
        let a = DMat3::from_diagonal(DVec3::splat(0.5 / r));
        Self::checked(Self { centre, a, b: DVec3::ZERO, c: -0.5 * r, nappe: None })
    }

    /// A circular cylinder without end about the axis through `point` along `axis`.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`].
    pub fn cylinder(point: DVec3, axis: DVec3, radius: f64) -> Result<Self, Error> {
        let r = positive("geometry-cylinder-radius", radius)?;
        let e = unit("geometry-cylinder-axis", axis)?;
        let a = (DMat3::IDENTITY - outer(e, e)) * (0.5 / r);
        Self::checked(Self { centre: point, a, b: DVec3::ZERO, c: -0.5 * r, nappe: None })
    }

    /// A cylinder without end over an ellipse: semi-axis `a` (mm) along `x_direction`, made perpendicular to `axis`,
    /// and `b` across it.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`], [`Error::Parallel`].
    pub fn elliptic_cylinder(centre: DVec3, axis: DVec3, x_direction: DVec3, a: f64, b: f64) -> Result<Self, Error> {
        for value in [a, b] {
            positive("geometry-elliptic-cylinder-semi-axis", value)?;
        }
        let z = unit("geometry-elliptic-cylinder-axis", axis)?;
        let x = unit("geometry-elliptic-cylinder-x-direction", x_direction)?;
        let across = x - x.dot(z) * z;
        if across.length() < 1e-9 {
            return Err(Error::Parallel { first: "geometry-elliptic-cylinder-axis", second: "geometry-x-direction" });
        }
        let x = across.normalize();
        let y = z.cross(x);
        let scale = 0.5 * a.min(b);
        let a = outer(x, x) * (scale / (a * a)) + outer(y, y) * (scale / (b * b));
        Self::checked(Self { centre, a, b: DVec3::ZERO, c: -scale, nappe: None })
    }

    /// A circular cone from its `apex`, opening along `axis` with the half angle `half_angle` (rad, between 0 and
    /// 90 degrees); only this nappe, without end.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`].
    pub fn cone(apex: DVec3, axis: DVec3, half_angle: f64) -> Result<Self, Error> {
        let e = unit("geometry-cone-axis", axis)?;
        if !(half_angle > 0.0 && half_angle < std::f64::consts::FRAC_PI_2) {
            return Err(Error::Size { what: "geometry-cone-half-angle", value: half_angle });
        }
        // |d|^2 cos^2 - (d.e)^2 is zero on the cone; its gradient there has length 2 |d| cos sin.
        let (sin, cos) = half_angle.sin_cos();
        let a = (DMat3::from_diagonal(DVec3::splat(cos * cos)) - outer(e, e)) * (0.5 / (sin * cos));
        Self::checked(Self { centre: apex, a, b: DVec3::ZERO, c: 0.0, nappe: Some(e) })
    }

    /// An ellipsoid with the semi-axes `semi` (mm) along `x_direction`, `z_direction` x `x_direction` and
    /// `z_direction`.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`], [`Error::Parallel`].
    pub fn ellipsoid(centre: DVec3, z_direction: DVec3, x_direction: DVec3, semi: DVec3) -> Result<Self, Error> {
        for value in semi.to_array() {
            positive("geometry-ellipsoid-semi-axis", value)?;
        }
        let z = unit("geometry-ellipsoid-axis", z_direction)?;
        let x = unit("geometry-ellipsoid-x-direction", x_direction)?;
        let across = x - x.dot(z) * z;
        if across.length() < 1e-9 {
            return Err(Error::Parallel { first: "geometry-ellipsoid-axis", second: "geometry-x-direction" });
        }
        let x = across.normalize();
        let y = z.cross(x);
        let scale = 0.5 * semi.min_element();
        let term = |e: DVec3, s: f64| outer(e, e) * (scale / (s * s));
        let a = term(x, semi.x) + term(y, semi.y) + term(z, semi.z);
        Self::checked(Self { centre, a, b: DVec3::ZERO, c: -scale, nappe: None })
    }

    fn checked(self) -> Result<Self, Error> {
        if self.centre.is_finite() { Ok(self) } else { Err(Error::Direction { what: "geometry-body-position" }) }
    }

    pub(crate) fn line_along(&self, d: DVec3) -> LineAlong {
        let ad = self.a * d;
        LineAlong { ad, k2: d.dot(ad), bd: self.b.dot(d) }
    }

    /// `F(p + h d) = k2 h^2 + 2 k1 h + k0` along a line through `p`: k1, k0 and half the gradient at `p`.
    pub(crate) fn on_line(&self, line: &LineAlong, p: DVec3) -> (f64, f64, DVec3) {
        let q = p - self.centre;
        let half = self.a * q + self.b;
        (q.dot(line.ad) + line.bd, q.dot(half + self.b) + self.c, half)
    }

    /// Distance (mm) of `p` beyond a cone's apex on its own nappe; infinity for other bodies.
    pub fn beyond_apex(&self, p: DVec3) -> f64 {
        self.nappe.map_or(f64::INFINITY, |e| (p - self.centre).dot(e))
    }
}

impl Surface for Quadric {
    fn value(&self, p: DVec3) -> f64 {
        let d = p - self.centre;
        d.dot(self.a * d) + 2.0 * self.b.dot(d) + self.c
    }
    fn gradient(&self, p: DVec3) -> DVec3 {
        2.0 * (self.a * (p - self.centre) + self.b)
    }
    fn hessian(&self, _: DVec3) -> DMat3 {
        self.a * 2.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bodies() -> Vec<(&'static str, Quadric, Vec<DVec3>)> {
        let o = DVec3::new(10.0, -20.0, 5.0);
        vec![
            ("plane", Quadric::plane(o, DVec3::Z).unwrap(), vec![o + DVec3::new(3.0, 4.0, 0.0)]),
            ("sphere", Quadric::sphere(o, 30.0).unwrap(), vec![o + DVec3::new(10.0, 20.0, 20.0)]),
            ("cylinder", Quadric::cylinder(o, DVec3::X, 5.0).unwrap(), vec![o + DVec3::new(77.0, 3.0, -4.0)]),
            (
                "cone",
                Quadric::cone(o, DVec3::Z, std::f64::consts::FRAC_PI_4).unwrap(),
                vec![o + DVec3::new(3.0, 4.0, 5.0)],
            ),
            (
                "ellipsoid",
                Quadric::ellipsoid(o, DVec3::X, DVec3::Y, DVec3::new(2.0, 3.0, 4.0)).unwrap(),
                vec![o + DVec3::new(4.0, 0.0, 0.0), o + DVec3::new(0.0, 2.0, 0.0), o + DVec3::new(0.0, 0.0, 3.0)],
            ),
        ]
    }

    #[test]
    fn known_points_lie_on_the_surface_and_outside_is_positive() {
        for (name, body, points) in bodies() {
            for p in points {
                assert!(body.value(p).abs() < 1e-13, "{name}");
                let n = body.gradient(p).normalize();
                assert!(body.value(p + 0.1 * n) > 0.0 && body.value(p - 0.1 * n) < 0.0, "{name}");
            }
        }
    }

    #[test]
    fn gradient_and_hessian_match_differences() {
        for (name, body, points) in bodies() {
            let p = points[0] + DVec3::new(0.3, -0.2, 0.1);
            for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
                let h = 1e-4;
                let g = (body.value(p + h * axis) - body.value(p - h * axis)) / (2.0 * h);
                assert!((g - body.gradient(p).dot(axis)).abs() < 1e-8, "{name}");
                let hess = (body.gradient(p + h * axis) - body.gradient(p - h * axis)) / (2.0 * h);
                assert!((hess - body.hessian(p) * axis).length() < 1e-8, "{name}");
            }
        }
    }

    #[test]
    fn bad_sizes_are_refused() {
        for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(Quadric::sphere(DVec3::ZERO, bad).is_err());
            assert!(Quadric::cylinder(DVec3::ZERO, DVec3::X, bad).is_err());
            assert!(Quadric::cone(DVec3::ZERO, DVec3::X, bad).is_err());
            assert!(Quadric::ellipsoid(DVec3::ZERO, DVec3::Z, DVec3::X, DVec3::new(1.0, bad, 1.0)).is_err());
        }
        assert!(Quadric::cone(DVec3::ZERO, DVec3::X, 1.6).is_err());
        assert!(Quadric::plane(DVec3::ZERO, DVec3::ZERO).is_err());
        assert!(Quadric::plane(DVec3::NAN, DVec3::Z).is_err());
    }
}
