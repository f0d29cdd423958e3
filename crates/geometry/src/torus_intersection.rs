use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::quadric::Surface;
use crate::torus::Torus;
use crate::tube::Tube;
use crate::tube_intersection::{SAMPLES, check_margin};
use glam::DVec3;
use std::f64::consts::TAU;

/// The curve where a tube's wall leaves a [`Torus`], such as a pipe bend, parametrised by the angle about the tube's
/// axis (rad).
///
/// At each angle it is the outermost point of the wall's line on the torus, along the tube's direction: the last real
/// root of a quartic. Derivatives follow from differentiating `F(p(phi)) = 0`, so they are exact.
#[derive(Debug, Clone, PartialEq)]
pub struct TorusIntersection {
    tube: Tube,
    torus: Torus,
    /// Only the half of the torus outside its ring, as the knuckle of a head.
    outer_half: bool,
}

impl TorusIntersection {
    /// The closed curve where `tube` leaves `torus`.
    ///
    /// # Errors
    /// [`Error::TubeLargerThanBody`], [`Error::TubeBesideBody`], [`Error::NotClosed`] or [`Error::Tangent`] if the
    /// curve does not exist or is not closed and smooth: also where it would jump across the hole of the torus.
    pub fn new(tube: Tube, torus: Torus) -> Result<Self, Error> {
        let curve = Self { tube, torus, outer_half: false };
        curve.check()?;
        Ok(curve)
    }

    /// The unchecked curve on the outer half, of which only a part is used.
    pub(crate) fn on_outer_half(tube: Tube, torus: Torus) -> Self {
        Self { tube, torus, outer_half: true }
    }

    fn check(&self) -> Result<(), Error> {
        let e3 = self.tube.e3;
        let steepness = |phi: f64| {
            let EdgePoint { point, n2, .. } = self.edge(phi);
            if point.is_nan() { -1.0 } else { n2.dot(e3).powi(2) }
        };
        let axis_meets = !self.torus.leaves(self.tube.origin, e3).is_nan();
        check_margin(&steepness, axis_meets)?;
        // If another part of the torus obstructs the line, the height jumps by more than the slope explains.
        let step = TAU / SAMPLES as f64;
        let seen = |i: usize| {
            let e = self.edge(i as f64 * step);
            (e.point.dot(e3), e.d1.dot(e3))
        };
        for i in 0..SAMPLES {
            let (from, to) = (seen(i), seen(i + 1));
            let climbed = 0.5 * step * (from.1 + to.1);
            if (to.0 - from.0 - climbed).abs() > 0.1 * self.torus.tube + climbed.abs() {
                return Err(Error::Tangent { at: (i as f64 + 0.5) * step });
            }
        }
        Ok(())
    }
}

impl Curve for TorusIntersection {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    /// Differentiating `F(p(phi)) = 0` twice.
    fn jet(&self, phi: f64) -> Jet {
        let EdgePoint { point, d1, n1, n2 } = self.edge(phi);
        let w2 = -self.tube.radius * n1;
        let bend = d1.dot(self.torus.hessian(point) * d1) + n2.dot(w2);
        Jet { point, d1, d2: w2 - bend / n2.dot(self.tube.e3) * self.tube.e3 }
    }
    fn point(&self, phi: f64) -> DVec3 {
        self.edge(phi).point
    }
    fn speed(&self, phi: f64) -> f64 {
        self.edge(phi).d1.length()
    }
}

impl Edge for TorusIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        let (foot, n1, around) = self.tube.wall(phi);
        let e3 = self.tube.e3;
        let height = match self.outer_half {
            true => self.torus.leaves_outer_half(foot, e3),
            false => self.torus.leaves(foot, e3),
        };
        let point = foot + height * e3;
        let n2 = self.torus.gradient(point);
        let w1 = self.tube.radius * around;
        EdgePoint { point, d1: w1 - n2.dot(w1) / n2.dot(e3) * e3, n1, n2 }
    }
}
