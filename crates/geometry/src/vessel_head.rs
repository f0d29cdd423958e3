use crate::error::{Error, positive, unit};
use crate::parallel_surface::ParallelSurface;
use crate::quadric::Quadric;
use crate::signed_distance::{Ball, Foot, QuadricDistance, SignedDistance, way_out};
use crate::torus::Torus;
use glam::DVec3;
use std::f64::consts::FRAC_PI_2;

/// The head of a vessel: a convex body of revolution. Its meridian is a chain of arcs and lines joined without corners,
/// from the crown through a knuckle into a cylindrical flange.
///
/// Heights count along the axis, out of the vessel, from the end of the knuckle, where the [`Flange`] begins; for
/// distances the flange is infinite.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    centre: DVec3,
    axis: DVec3,
    radius: f64,
    /// Length of the flange, mm.
    flange: f64,
    top: f64,
    /// From the crown to the flange.
    zones: Vec<Zone>,
}

/// The cylindrical flange of a head; outside measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flange {
    /// The point of the axis where the flange begins, mm.
    pub centre: DVec3,
    /// Direction of the axis, out of the vessel.
    pub axis: DVec3,
    /// Radius, mm.
    pub radius: f64,
    /// Length, mm.
    pub length: f64,
}

/// A part of the head, up to its border with the next one.
#[derive(Debug, Clone, PartialEq)]
struct Zone {
    meridian: Meridian,
    face: Face,
    end: Border,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Face {
    Quadric(Box<(Quadric, QuadricDistance)>),
    Torus(Torus),
    Parallel(Box<ParallelSurface>),
}

/// The line that a zone turns about the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Meridian {
    /// Across the axis at this height.
    Plate { height: f64 },
    /// From the axis at this height down, at this angle to the axis.
    Cone { apex: f64, half_angle: f64 },
    /// An arc about a point of the axis.
    Ball { height: f64, radius: f64 },
    /// An arc about a point beside the axis at height 0.
    Knuckle { ring: f64, radius: f64 },
    /// A quarter of an ellipse about the centre, or the line `below` mm inside it.
    Oval { radius: f64, depth: f64, below: f64 },
    /// Along the axis.
    Flange,
}

/// A circle around the head, and the cone (or plane, or cylinder) through it along the normals.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Border {
    radius: f64,
    height: f64,
    /// Angle of the normal there to the axis, rad.
    normal: f64,
}

impl Head {
    /// A spherical crown of radius `crown` and a knuckle of radius `knuckle` on a flange; outside measures.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`]; [`Error::Range`] if the knuckle is not smaller than the flange, or the
    /// crown not larger.
    pub fn torispherical(flange: Flange, crown: f64, knuckle: f64) -> Result<Self, Error> {
        let radius = flange.radius;
        let ring = ring(radius, knuckle)?;
        if !(crown > radius && crown.is_finite()) {
            return Err(Error::Range { what: "geometry-crown-radius", value: crown, min: radius, max: f64::INFINITY });
        }
        // The arcs touch on the line through their centres.
        let apart = crown - knuckle;
        let below = ((apart - ring) * (apart + ring)).sqrt();
        let touch = Border::on(ring, 0.0, knuckle, ring.atan2(below));
        let zones = vec![
            (Meridian::Ball { height: -below, radius: crown }, touch),
            (Meridian::Knuckle { ring, radius: knuckle }, Border::flange(radius, 0.0)),
        ];
        Self::new(flange, crown - below, zones)
    }

    /// Half an ellipsoid of revolution, `depth` high, on a flange; outside measures. Of its wall the surface `below` mm
    /// inside it, 0 for the outside.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`]; [`Error::Range`] if `below` is not less than the minimum radius of curvature.
    pub fn ellipsoidal(flange: Flange, depth: f64, below: f64) -> Result<Self, Error> {
        let radius = flange.radius;
        let depth = positive("geometry-head-depth", depth)?;
        let zones = vec![(Meridian::Oval { radius, depth, below }, Border::flange(radius - below, 0.0))];
        Self::new(Flange { radius: radius - below, ..flange }, depth - below, zones)
    }

    /// Half a ball on a flange.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`].
    pub fn hemispherical(flange: Flange) -> Result<Self, Error> {
        let radius = flange.radius;
        let zones = vec![(Meridian::Ball { height: 0.0, radius }, Border::flange(radius, 0.0))];
        Self::new(flange, radius, zones)
    }

    /// A flat plate and a knuckle on a flange; outside measures.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`]; [`Error::Range`] if the knuckle is not smaller than the flange.
    pub fn flat(flange: Flange, knuckle: f64) -> Result<Self, Error> {
        let radius = flange.radius;
        let ring = ring(radius, knuckle)?;
        let zones = vec![
            (Meridian::Plate { height: knuckle }, Border::on(ring, 0.0, knuckle, 0.0)),
            (Meridian::Knuckle { ring, radius: knuckle }, Border::flange(radius, 0.0)),
        ];
        Self::new(flange, knuckle, zones)
    }

    /// A cone whose wall is `half_angle` (rad) off the axis, closed at its apex, and a knuckle on a flange; outside
    /// measures.
    ///
    /// # Errors
    /// [`Error::Size`], [`Error::Direction`]; [`Error::Range`] if the knuckle is not smaller than the flange.
    pub fn conical(flange: Flange, half_angle: f64, knuckle: f64) -> Result<Self, Error> {
        let radius = flange.radius;
        let ring = ring(radius, knuckle)?;
        if !(half_angle > 0.0 && half_angle < FRAC_PI_2) {
            return Err(Error::Size { what: "geometry-cone-half-angle", value: half_angle });
        }
        let touch = Border::on(ring, 0.0, knuckle, FRAC_PI_2 - half_angle);
        let apex = touch.height + touch.radius / half_angle.tan();
        let zones = vec![
            (Meridian::Cone { apex, half_angle }, touch),
            (Meridian::Knuckle { ring, radius: knuckle }, Border::flange(radius, 0.0)),
        ];
        Self::new(flange, apex, zones)
    }

    /// The head `top` mm high with these zones above its flange.
    fn new(flange: Flange, top: f64, mut zones: Vec<(Meridian, Border)>) -> Result<Self, Error> {
        let Flange { centre, axis, radius, length } = flange;
        positive("geometry-head-radius", radius)?;
        if !(length >= 0.0 && length.is_finite()) {
            return Err(Error::Size { what: "geometry-head-flange", value: length });
        }
        let axis = unit("geometry-head-axis", axis)?;
        zones.push((Meridian::Flange, Border::flange(radius, -length)));
        let zone = |(meridian, end): (Meridian, Border)| {
            let face = meridian.face(centre, axis, radius)?;
            Ok(Zone { meridian, face, end })
        };
        let zones = zones.into_iter().map(zone).collect::<Result<_, Error>>()?;
        Ok(Self { centre, axis, radius, flange: length, top, zones })
    }

    /// The point of the axis where the flange begins, mm.
    pub fn centre(&self) -> DVec3 {
        self.centre
    }

    /// Unit direction of the axis, out of the vessel.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Radius of the flange, mm.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The surfaces of the zones, from the crown to the flange.
    pub(crate) fn faces(&self) -> impl Iterator<Item = &Face> {
        self.zones.iter().map(|z| &z.face)
    }

    /// Distance from the axis, height.
    fn meridional(&self, p: DVec3) -> (f64, f64) {
        let d = p - self.centre;
        let height = d.dot(self.axis);
        ((d - height * self.axis).length(), height)
    }

    /// Distance (mm) of `p` beyond the end of each zone, towards the flange; the last is the flange's own end.
    pub(crate) fn beyond(&self, p: DVec3) -> impl Iterator<Item = f64> {
        let (rho, height) = self.meridional(p);
        self.zones.iter().map(move |zone| {
            let (sin, cos) = zone.end.normal.sin_cos();
            (rho - zone.end.radius) * cos - (height - zone.end.height) * sin
        })
    }

    /// Distance (mm) of `p` from the axis of a cone, where its tip is; infinity for other heads.
    pub(crate) fn off_tip(&self, p: DVec3) -> f64 {
        let pointed = matches!(self.zones[0].meridian, Meridian::Cone { .. });
        if pointed { self.meridional(p).0 } else { f64::INFINITY }
    }

    /// Height over `foot` at which the line along the unit vector `d` leaves the head, if it meets it. If the exit lies
    /// on the flange's continuation beyond the head, returns its height there.
    pub(crate) fn way_out(&self, foot: DVec3, d: DVec3) -> Option<f64> {
        let half = 0.5 * (self.top + self.flange);
        let ball = Ball { centre: self.centre + (self.top - half) * self.axis, radius: self.radius.hypot(half) };
        way_out(self, ball, foot, d)
    }

    /// A meridian around the head's own as a chain of lines, at most `within` mm outside it: distances from the axis
    /// and heights, from the top to the end of the flange.
    pub fn outline(&self, within: f64) -> Vec<(f64, f64)> {
        let mut points = vec![(0.0, self.top)];
        let mut from = 0.0;
        for zone in &self.zones {
            let to = zone.end.normal;
            if let Some(Oval { across: a, along: b, below, ring, height }) = zone.meridian.arc() {
                // Two tangents at an angle of `step` meet outside the arc by its radius times the square over 8.
                let widest = (a * a / b).max(b * b / a);
                let count = ((to - from) / (8.0 * within / widest).sqrt()).ceil().max(1.0);
                let step = (to - from) / count;
                let tangent = |i: f64| {
                    let (sin, cos) = (from + i * step).sin_cos();
                    (sin, cos, (a * sin).hypot(b * cos) - below)
                };
                for i in 0..count as usize {
                    let ((s1, c1, h1), (s2, c2, h2)) = (tangent(i as f64), tangent(i as f64 + 1.0));
                    let sine = s2 * c1 - s1 * c2;
                    points.push((ring + (h2 * c1 - h1 * c2) / sine, height + (s2 * h1 - s1 * h2) / sine));
                }
            }
            points.push((zone.end.radius, zone.end.height));
            from = to;
        }
        points.dedup_by(|p, q| (p.0 - q.0).hypot(p.1 - q.1) < 1e-9);
        points
    }
}

impl SignedDistance for Head {
    /// Exact outside; inside down to the head's minimum radius of curvature.
    fn foot(&self, p: DVec3) -> Foot {
        let last = self.zones.len() - 1;
        let zone = self.beyond(p).take(last).take_while(|b| *b > 0.0).count();
        match &self.zones[zone].face {
            Face::Quadric(quadric) => quadric.1.foot(p),
            Face::Torus(torus) => torus.foot(p),
            Face::Parallel(parallel) => parallel.foot(p),
        }
    }
}

impl Meridian {
    /// The surface of this meridian on a head with a flange of `radius`.
    fn face(self, centre: DVec3, axis: DVec3, radius: f64) -> Result<Face, Error> {
        let at = |height: f64| centre + height * axis;
        let quadric = match self {
            Self::Plate { height } => Quadric::plane(at(height), axis)?,
            Self::Cone { apex, half_angle } => Quadric::cone(at(apex), -axis, half_angle)?,
            Self::Ball { height, radius } => Quadric::sphere(at(height), radius)?,
            Self::Oval { radius, depth, below } => {
                let (x, semi) = (axis.any_orthonormal_vector(), DVec3::new(radius, radius, depth));
                if below > 0.0 {
                    let parallel = ParallelSurface::below_ellipsoid(centre, axis, x, semi, below)?;
                    return Ok(Face::Parallel(Box::new(parallel)));
                }
                Quadric::ellipsoid(centre, axis, x, semi)?
            }
            Self::Flange => Quadric::cylinder(centre, axis, radius)?,
            Self::Knuckle { ring, radius } => return Ok(Face::Torus(Torus::new(centre, axis, ring, radius)?)),
        };
        let distance = QuadricDistance::new(&quadric);
        Ok(Face::Quadric(Box::new((quadric, distance))))
    }

    /// A curved meridian as an ellipse, or the line inside it.
    fn arc(self) -> Option<Oval> {
        let of = |across, along, ring, height| Oval { across, along, below: 0.0, ring, height };
        match self {
            Self::Ball { height, radius } => Some(of(radius, radius, 0.0, height)),
            Self::Knuckle { ring, radius } => Some(of(radius, radius, ring, 0.0)),
            Self::Oval { radius, depth, below } => Some(Oval { below, ..of(radius, depth, 0.0, 0.0) }),
            Self::Plate { .. } | Self::Cone { .. } | Self::Flange => None,
        }
    }
}

/// An ellipse, or the line `below` mm inside it: semi-axes across and along the head's axis, and the middle's distance
/// from the axis and height, mm.
#[derive(Debug, Clone, Copy)]
struct Oval {
    across: f64,
    along: f64,
    below: f64,
    ring: f64,
    height: f64,
}

impl Border {
    /// The border at which the normal of an arc about (`ring`, `height`) has this angle.
    fn on(ring: f64, height: f64, radius: f64, normal: f64) -> Self {
        let (sin, cos) = normal.sin_cos();
        Self { radius: ring + radius * sin, height: height + radius * cos, normal }
    }

    /// Across a flange.
    fn flange(radius: f64, height: f64) -> Self {
        Self { radius, height, normal: FRAC_PI_2 }
    }
}

/// Radius of the circle of the knuckle's centres.
fn ring(radius: f64, knuckle: f64) -> Result<f64, Error> {
    positive("geometry-head-radius", radius)?;
    if knuckle > 0.0 && knuckle < radius {
        Ok(radius - knuckle)
    } else {
        Err(Error::Range { what: "geometry-knuckle-radius", value: knuckle, min: 0.0, max: radius })
    }
}
