use crate::vessel_head::{ConicalHead, EllipsoidalHead, FlatHead, HemisphericalHead, TorisphericalHead};
use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, Point, Positive};
use serde::{Deserialize, Serialize};

/// A nozzle: a circular tube that stands on a body.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nozzle {
    /// Outer radius, mm.
    pub radius_mm: Positive,
    /// Thickness of its wall, mm; needed for the root of a set-on nozzle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wall_mm: Option<Positive>,
    /// Connection of nozzle and body.
    #[serde(default)]
    pub mount: Mount,
    /// Which curve is welded.
    #[serde(default)]
    pub curve: NozzleCurve,
    /// A point on the nozzle's axis, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub origin_mm: Point,
    /// Direction of the axis, away from the body; z if missing.
    #[serde(default = "Vector::z")]
    pub direction: Vector,
    /// Direction in which the angle phi about the nozzle's axis is 0, made perpendicular to `direction`. If missing: x,
    /// or y for a nozzle along x.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub zero_direction: Option<Vector>,
    /// Body under the nozzle.
    pub body: Body,
}

/// Connection of a nozzle and its body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Mount {
    /// Its end is cut to stand on the body's outer surface.
    #[default]
    SetOn,
    /// It goes through a hole in the body's wall, whose thickness must be given.
    SetIn,
}

/// Which curve of a nozzle with a wall is welded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NozzleCurve {
    /// The nozzle's outside on the body's outside, welded from outside.
    #[default]
    OuterToe,
    /// The root, welded from inside: of a set-on nozzle its bore on the body's outside, the torch in the bore; of a
    /// set-in nozzle its outside on the body's inside, the torch in the body.
    InnerRoot,
}

/// A body with a quadric surface, a pipe bend, or the head of a vessel: surfaces that go over into each other without
/// an edge.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Body {
    /// A cylindrical shell.
    Cylinder {
        /// Outer radius, mm.
        radius_mm: Positive,
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
        /// A point on the axis, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        point_mm: Point,
        /// Direction of the axis; x if missing.
        #[serde(default = "Vector::x")]
        axis: Vector,
    },
    /// A conical shell, opening along its axis from the apex.
    Cone {
        /// Angle between axis and wall, degrees, between 0 and 90.
        half_angle_deg: Positive,
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
        /// Apex, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        apex_mm: Point,
        /// Direction in which the cone opens.
        axis: Vector,
    },
    /// A spherical shell.
    Sphere {
        /// Outer radius, mm.
        radius_mm: Positive,
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
        /// Centre, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        centre_mm: Point,
    },
    /// An ellipsoid.
    Ellipsoid {
        /// Semi-axes along the body's x, y and z directions, mm.
        semi_axes_mm: [Positive; 3],
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
        /// Centre, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        centre_mm: Point,
        /// Direction of the third semi-axis; z if missing.
        #[serde(default = "Vector::z")]
        axis: Vector,
        /// Direction of the first semi-axis; x if missing. Made perpendicular to `axis`.
        #[serde(default = "Vector::x")]
        x_direction: Vector,
    },
    /// A flat plate.
    Plane {
        /// A point of its surface, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        point_mm: Point,
        /// Outward normal.
        normal: Vector,
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
    },
    /// A torus: a pipe bend.
    Torus {
        /// Radius of the pipe's middle line, mm; more than `radius_mm`.
        bend_radius_mm: Positive,
        /// Outer radius of the pipe, mm.
        radius_mm: Positive,
        /// Thickness of the wall, mm; needed for set-in nozzles.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        thickness_mm: Option<Positive>,
        /// Centre of the middle line, mm.
        #[serde(default, skip_serializing_if = "Point::is_zero")]
        centre_mm: Point,
        /// Normal of the middle line's plane; z if missing.
        #[serde(default = "Vector::z")]
        axis: Vector,
    },
    /// A head with a spherical crown, a knuckle and a flange.
    TorisphericalHead(TorisphericalHead),
    /// A head of half an ellipsoid and a flange.
    EllipsoidalHead(EllipsoidalHead),
    /// A head of half a ball and a flange.
    HemisphericalHead(HemisphericalHead),
    /// A flat head with a knuckle and a flange.
    FlatHead(FlatHead),
    /// A conical head with a knuckle and a flange.
    ConicalHead(ConicalHead),
}
