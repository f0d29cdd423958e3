use schemars::JsonSchema;
use seamwright_document::{Direction as Vector, NonNegative, Point, Positive};
use serde::{Deserialize, Serialize};

/// A head with a spherical crown and a knuckle. The radii are those of its inside, as the standards give them; the
/// nozzle stands on the outside, a thickness farther out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TorisphericalHead {
    /// Outer diameter of the flange, mm.
    pub outer_diameter_mm: Positive,
    /// Thickness of the wall, mm.
    pub thickness_mm: Positive,
    /// Standard that gives crown and knuckle; without one both radii are needed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub standard: Option<HeadStandard>,
    /// Inside radius of the crown, mm, instead of the standard's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub crown_radius_mm: Option<Positive>,
    /// Inside radius of the knuckle, mm, instead of the standard's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub knuckle_radius_mm: Option<Positive>,
    /// Length of the cylindrical flange, mm.
    #[serde(default)]
    pub flange_mm: NonNegative,
    /// The point of the axis where the flange begins, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Direction of the axis, out of the vessel; z if missing.
    #[serde(default = "Vector::z")]
    pub axis: Vector,
}

/// A standard for torispherical heads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum HeadStandard {
    /// DIN 28011 (Klöpper): the crown's radius is the outer diameter, the knuckle's a tenth of it.
    #[serde(rename = "din_28011")]
    Din28011,
    /// DIN 28013 (Korbbogen): 0.8 and 0.154 of the outer diameter.
    #[serde(rename = "din_28013")]
    Din28013,
    /// Flanged and dished, at the limits of ASME VIII-1, UG-32: the crown's radius is the outer diameter, the knuckle's
    /// 6 % of it, and at least three times the thickness.
    #[serde(rename = "asme_fd")]
    AsmeFd,
}

impl HeadStandard {
    /// Inside radii (mm) of crown and knuckle for an outer diameter and a thickness.
    pub fn radii(self, outer_diameter: f64, thickness: f64) -> (f64, f64) {
        match self {
            Self::Din28011 => (outer_diameter, 0.1 * outer_diameter),
            Self::Din28013 => (0.8 * outer_diameter, 0.154 * outer_diameter),
            Self::AsmeFd => (outer_diameter, (0.06 * outer_diameter).max(3.0 * thickness)),
        }
    }
}

impl TorisphericalHead {
    /// Inside radii (mm) of crown and knuckle: those given, or the standard's; `None` without either.
    pub fn radii(&self) -> (Option<f64>, Option<f64>) {
        let standard = self.standard.map(|s| s.radii(self.outer_diameter_mm.get(), self.thickness_mm.get()));
        let of = |given: Option<Positive>, standard: Option<f64>| given.map(Positive::get).or(standard);
        (of(self.crown_radius_mm, standard.map(|s| s.0)), of(self.knuckle_radius_mm, standard.map(|s| s.1)))
    }
}

/// A head whose outside is half an ellipsoid of revolution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EllipsoidalHead {
    /// Outer diameter of the flange, mm.
    pub outer_diameter_mm: Positive,
    /// Outer height of the ellipsoid, mm; if missing a quarter of the diameter: a 2:1 head.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_mm: Option<Positive>,
    /// Thickness of the wall, mm; needed for set-in nozzles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_mm: Option<Positive>,
    /// Length of the cylindrical flange, mm.
    #[serde(default)]
    pub flange_mm: NonNegative,
    /// The point of the axis where the flange begins, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Direction of the axis, out of the vessel; z if missing.
    #[serde(default = "Vector::z")]
    pub axis: Vector,
}

/// Half a ball on a cylindrical flange.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HemisphericalHead {
    /// Outer diameter, mm.
    pub outer_diameter_mm: Positive,
    /// Thickness of the wall, mm; needed for set-in nozzles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_mm: Option<Positive>,
    /// Length of the cylindrical flange, mm.
    #[serde(default)]
    pub flange_mm: NonNegative,
    /// The point of the axis where the flange begins, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Direction of the axis, out of the vessel; z if missing.
    #[serde(default = "Vector::z")]
    pub axis: Vector,
}

/// A flat head with a knuckle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FlatHead {
    /// Outer diameter of the flange, mm.
    pub outer_diameter_mm: Positive,
    /// Thickness of the wall, mm.
    pub thickness_mm: Positive,
    /// Inside radius of the knuckle, mm.
    pub knuckle_radius_mm: Positive,
    /// Length of the cylindrical flange, mm.
    #[serde(default)]
    pub flange_mm: NonNegative,
    /// The point of the axis where the flange begins, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Direction of the axis, out of the vessel; z if missing.
    #[serde(default = "Vector::z")]
    pub axis: Vector,
}

/// A cone, closed at its apex, with a knuckle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConicalHead {
    /// Outer diameter of the flange, mm.
    pub outer_diameter_mm: Positive,
    /// Thickness of the wall, mm.
    pub thickness_mm: Positive,
    /// Angle between axis and wall, degrees, between 0 and 90.
    pub half_angle_deg: Positive,
    /// Inside radius of the knuckle, mm.
    pub knuckle_radius_mm: Positive,
    /// Length of the cylindrical flange, mm.
    #[serde(default)]
    pub flange_mm: NonNegative,
    /// The point of the axis where the flange begins, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub centre_mm: Point,
    /// Direction of the axis, out of the vessel; z if missing.
    #[serde(default = "Vector::z")]
    pub axis: Vector,
}
