//! The trait of all curves: a point and exact derivatives at any parameter.

use glam::DVec3;

/// Point and derivatives of a curve at one parameter, in the frame of the curve.
///
/// This is returned by [`Curve::jet`]. With `d1` and `d2` the curvature is `|d1 x d2| / |d1|^3`, 1/mm, whatever the
/// parameter is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Position, mm.
    pub point: DVec3,
    /// First derivative by the parameter, mm per unit of it.
    pub d1: DVec3,
    /// Second derivative by the parameter, mm per unit of it squared.
    pub d2: DVec3,
}

/// A parametrised curve in space.
///
/// The parameter `u` has any unit that suits the curve: mm for a [`Line`](crate::Line), rad for an
/// [`Arc`](crate::Arc) or a [`TubeIntersection`](crate::TubeIntersection). To work with path lengths instead, wrap the
/// curve in [`ByLength`](crate::ByLength).
///
/// # Contract
///
/// - Between its [`breaks`](Curve::breaks) a curve is twice continuously differentiable.
/// - The first derivative is nowhere zero.
/// - Derivatives are exact (closed form), not differences.
/// - The domain is finite and not empty, and evaluation inside it does not panic.
///
/// Outside its domain a closed curve repeats. An open one continues by its own formula; the caller keeps to the domain.
///
/// # Examples
///
/// A parabola as a curve. Its length is known in closed form:
///
/// ```
/// use glam::DVec3;
/// use seamwright_geometry::{ByLength, Curve, DEFAULT_ACCURACY_MM, Jet};
///
/// /// `y = x^2 / 40` from x = 0 to 20 mm, by x.
/// struct Parabola;
///
/// impl Curve for Parabola {
///     fn domain(&self) -> (f64, f64) {
///         (0.0, 20.0)
///     }
///     fn jet(&self, u: f64) -> Jet {
///         Jet {
///             point: DVec3::new(u, u * u / 40.0, 0.0),
///             d1: DVec3::new(1.0, u / 20.0, 0.0),
///             d2: DVec3::new(0.0, 1.0 / 20.0, 0.0),
///         }
///     }
/// }
///
/// let by_length = ByLength::new(Parabola, DEFAULT_ACCURACY_MM)?;
/// let length = 10.0 * (2.0f64.sqrt() + 1.0f64.asinh());
/// assert!((by_length.length() - length).abs() < 1e-10);
/// // Half way along the curve is more than half way in x: the curve gets steeper.
/// assert!(by_length.parameter(0.5 * length) > 10.0);
/// # Ok::<(), seamwright_geometry::Error>(())
/// ```
pub trait Curve {
    /// Returns the first and the last parameter, increasing.
    fn domain(&self) -> (f64, f64);

    /// Returns true if the end joins the start, with equal derivatives unless there is a break.
    fn closed(&self) -> bool {
        false
    }

    /// Evaluates the point and the exact first and second derivative at parameter `u`.
    ///
    /// At a break these are the derivatives behind it.
    fn jet(&self, u: f64) -> Jet;

    /// Returns the parameters at which a derivative of any order may jump, increasing, within the domain. A closed
    /// curve may have one at its start.
    ///
    /// If a break is missing, [`ByLength`](crate::ByLength) halves its panels towards it, and fails at a corner.
    fn breaks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Evaluates the point at parameter `u`, mm.
    fn point(&self, u: f64) -> DVec3 {
        self.jet(u).point
    }

    /// Evaluates the length of the first derivative at parameter `u`: mm per unit of the parameter.
    fn speed(&self, u: f64) -> f64 {
        self.jet(u).d1.length()
    }
}

/// A curve behind a pointer is a curve.
macro_rules! behind {
    ($($pointer:tt)+) => {
        impl<C: Curve + ?Sized> Curve for $($pointer)+ {
            fn domain(&self) -> (f64, f64) {
                (**self).domain()
            }
            fn closed(&self) -> bool {
                (**self).closed()
            }
            fn jet(&self, u: f64) -> Jet {
                (**self).jet(u)
            }
            fn breaks(&self) -> Vec<f64> {
                (**self).breaks()
            }
            fn point(&self, u: f64) -> DVec3 {
                (**self).point(u)
            }
            fn speed(&self, u: f64) -> f64 {
                (**self).speed(u)
            }
        }
    };
}
behind!(Box<C>);
behind!(&C);

#[cfg(test)]
pub(crate) mod testing {
    use super::*;

    /// Checks both derivatives against central differences and closure of closed curves.
    pub(crate) fn check_derivatives(curve: &dyn Curve, scale: f64) {
        let (a, b) = curve.domain();
        let h = (b - a) * 1e-5;
        for i in 1..200 {
            let u = a + (b - a) * f64::from(i) / 200.0;
            let (l, m, r) = (curve.jet(u - h), curve.jet(u), curve.jet(u + h));
            let d1 = (r.point - l.point) / (2.0 * h);
            let d2 = (r.d1 - l.d1) / (2.0 * h);
            assert!((d1 - m.d1).length() < 1e-6 * scale, "d1 at {u}: {d1} {}", m.d1);
            assert!((d2 - m.d2).length() < 1e-6 * scale, "d2 at {u}: {d2} {}", m.d2);
            assert!((m.point - curve.point(u)).length() < 1e-13 * scale);
            assert!((m.d1.length() - curve.speed(u)).abs() < 1e-13 * scale);
        }
        if curve.closed() {
            let (s, e) = (curve.jet(a), curve.jet(b));
            assert!((s.point - e.point).length() < 1e-12 * scale);
            assert!((s.d1 - e.d1).length() < 1e-12 * scale);
            assert!((s.d2 - e.d2).length() < 1e-11 * scale);
        }
    }
}
