use glam::DVec3;

/// Point and derivatives of a curve at one parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet {
    /// Position, mm.
    pub point: DVec3,
    /// First derivative by the parameter.
    pub d1: DVec3,
    /// Second derivative by the parameter.
    pub d2: DVec3,
}

/// A parametrised curve in space, twice continuously differentiable except at its [`breaks`](Curve::breaks), with a
/// non-zero first derivative.
pub trait Curve {
    /// First and last parameter, increasing.
    fn domain(&self) -> (f64, f64);

    /// True if the end joins the start, with equal derivatives unless there is a break; the curve may then be evaluated
    /// outside its domain, where it repeats.
    fn closed(&self) -> bool;

    /// Point and exact first and second derivative at parameter `u`.
    fn jet(&self, u: f64) -> Jet;

    /// Parameters at which a derivative of any order may jump, increasing, within the domain; a closed curve may have
    /// one at its start. There [`Curve::jet`] gives the derivatives behind the break.
    fn breaks(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Point at parameter `u`, mm.
    fn point(&self, u: f64) -> DVec3 {
        self.jet(u).point
    }

    /// Length of the first derivative: mm per unit of parameter.
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
