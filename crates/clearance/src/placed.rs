use crate::convex::Convex;
use crate::shape::Shape;
use glam::{DAffine3, DVec2, DVec3};

/// A direction with a smaller part across a round body's axis counts as along it: dividing the radius by it could
/// overflow.
const ALONG: f64 = 1e-150;

/// Bound of the rounding error of a distance, as a share of the coordinates.
const ROUNDING: f64 = 1e-14;

/// Core of a convex shape, in the shape's frame.
#[derive(Debug, Clone, Copy)]
enum Core {
    /// On z, between two heights.
    Segment(f64, f64),
    Box(DVec3),
    /// Radii at z = 0 and at the length.
    Frustum(f64, f64, f64),
    Ellipsoid(DVec3),
}

impl Core {
    /// Height of its inner point over its origin, mm.
    fn middle(&self) -> f64 {
        match *self {
            Self::Segment(low, high) => (low + high) / 2.0,
            Self::Frustum(_, _, length) => length / 2.0,
            Self::Box(_) | Self::Ellipsoid(_) => 0.0,
        }
    }

    /// Maximum distance of its points from its inner point, mm.
    fn reach(&self) -> f64 {
        match *self {
            Self::Segment(low, high) => (high - low) / 2.0,
            Self::Frustum(bottom, top, length) => bottom.max(top).hypot(length / 2.0),
            Self::Box(half) => half.length(),
            Self::Ellipsoid(semi) => semi.max_element(),
        }
    }
}

/// A convex body in a frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placed {
    core: Core,
    radius: f64,
    pose: DAffine3,
}

impl Placed {
    /// None for half-spaces and meshes.
    pub(crate) fn new(shape: &Shape, pose: DAffine3) -> Option<Self> {
        let (core, radius) = match *shape {
            Shape::Box { size } => (Core::Box(size / 2.0), 0.0),
            Shape::Sphere { radius } => (Core::Segment(0.0, 0.0), radius),
            Shape::Capsule { radius, length } => (Core::Segment(radius, length - radius), radius),
            Shape::Cylinder { radius, length } => (Core::Frustum(radius, radius, length), 0.0),
            Shape::Cone { radius, top_radius, length } => (Core::Frustum(radius, top_radius, length), 0.0),
            Shape::Ellipsoid { semi_axes } => (Core::Ellipsoid(semi_axes), 0.0),
            Shape::HalfSpace | Shape::Mesh(_) => return None,
        };
        Some(Self { core, radius, pose })
    }

    /// The same body in another pose.
    pub(crate) fn at(&self, pose: DAffine3) -> Self {
        Self { pose, ..*self }
    }

    /// An upper bound of the distance of any point of the core from where it is in the pose of `other`, mm.
    pub(crate) fn displacement(&self, other: &Self) -> f64 {
        let turn = self.pose.matrix3 - other.pose.matrix3;
        let turn = (turn.x_axis.length_squared() + turn.y_axis.length_squared() + turn.z_axis.length_squared()).sqrt();
        self.inner_point().distance(other.inner_point()) + turn * self.core.reach()
    }
}

impl Convex for Placed {
    fn support(&self, direction: DVec3) -> DVec3 {
        let d = self.pose.matrix3.transpose() * direction;
        let local = match self.core {
            Core::Segment(low, high) => DVec3::Z * if d.z > 0.0 { high } else { low },
            Core::Box(half) => half.copysign(d),
            Core::Ellipsoid(semi) => {
                let scaled = semi * d;
                semi * scaled.try_normalize().unwrap_or(DVec3::Z)
            }
            Core::Frustum(bottom, top, length) => {
                let across = d.truncate().length();
                let (radius, height) =
                    if across * top + d.z * length > across * bottom { (top, length) } else { (bottom, 0.0) };
                let scale = if across > ALONG { radius / across } else { 0.0 };
                DVec3::new(d.x * scale, d.y * scale, height)
            }
        };
        self.pose.transform_point3(local)
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    fn inner_point(&self) -> DVec3 {
        self.pose.transform_point3(DVec3::Z * self.core.middle())
    }

    fn at_least(&self, point: DVec3) -> f64 {
        let p = self.pose.matrix3.transpose() * (point - self.pose.translation);
        // Of a cylinder around round bodies, and of a sphere around ellipsoids.
        let beside = |radius: f64, low: f64, high: f64| {
            let across = (p.truncate().length() - radius).max(0.0);
            DVec2::new(across, (low - p.z).max(p.z - high).max(0.0)).length()
        };
        let distance = match self.core {
            Core::Segment(low, high) => beside(0.0, low, high),
            Core::Box(half) => (p.abs() - half).max(DVec3::ZERO).length(),
            Core::Ellipsoid(semi) => (p.length() - semi.max_element()).max(0.0),
            Core::Frustum(bottom, top, length) => beside(bottom.max(top), 0.0, length),
        };
        distance - ROUNDING * (point.abs().max_element() + self.pose.translation.abs().max_element() + distance)
    }
}
