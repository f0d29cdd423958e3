use crate::bounds::FARTHEST_MM;
use crate::document::fault_in_serde;
use crate::number::{Finite, inline_schema};
use glam::{DAffine3, DQuat, DVec3};
use schemars::JsonSchema;
use seamwright_message::{Message, Unit};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

/// Three numbers, mm: a point or a displacement, each within 1e7 mm (10 km) of zero.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, JsonSchema)]
#[serde(transparent)]
pub struct Point([Finite; 3]);

impl<'de> Deserialize<'de> for Point {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let v = <[Finite; 3]>::deserialize(deserializer)?;
        if v.iter().any(|c| c.get().abs() > FARTHEST_MM) {
            return Err(D::Error::custom(fault_in_serde(
                &Message::new("document-coordinate-too-large"),
                &Message::new("document-coordinates").quantity("limit", FARTHEST_MM, Unit::Mm, 0),
            )));
        }
        Ok(Self(v))
    }
}

impl Point {
    /// The point, if its coordinates are finite and within 1e7 mm of zero.
    pub fn new(p: DVec3) -> Option<Self> {
        finite(p).filter(|_| p.abs().max_element() <= FARTHEST_MM).map(Self)
    }

    /// As a vector, mm.
    pub fn get(self) -> DVec3 {
        DVec3::from_array(self.0.map(Finite::get))
    }

    /// True for the origin.
    pub fn is_zero(&self) -> bool {
        self.get() == DVec3::ZERO
    }
}

fn finite(v: DVec3) -> Option<[Finite; 3]> {
    Some([Finite::new(v.x)?, Finite::new(v.y)?, Finite::new(v.z)?])
}

/// A direction: three finite numbers, not all zero; the length does not matter.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Direction([Finite; 3]);

impl Direction {
    /// The x axis.
    pub fn x() -> Self {
        Self([1.0, 0.0, 0.0].map(|v| Finite::new(v).unwrap_or_default()))
    }

    /// The z axis.
    pub fn z() -> Self {
        Self([0.0, 0.0, 1.0].map(|v| Finite::new(v).unwrap_or_default()))
    }

    /// The direction of `v`, if it is finite and has a length.
    pub fn new(v: DVec3) -> Option<Self> {
        let parts = finite(v)?;
        (v != DVec3::ZERO).then_some(Self(parts))
    }

    /// As a unit vector.
    pub fn unit(self) -> DVec3 {
        // Scaled first, so that no finite direction over- or underflows.
        let v = DVec3::from_array(self.0.map(Finite::get));
        (v / v.abs().max_element()).normalize()
    }
}

impl<'de> Deserialize<'de> for Direction {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let v = <[Finite; 3]>::deserialize(deserializer)?;
        if v.iter().all(|c| c.get() == 0.0) {
            return Err(D::Error::custom(fault_in_serde(
                &Message::new("document-direction-without-length"),
                &Message::new("document-direction"),
            )));
        }
        Ok(Self(v))
    }
}

inline_schema!(Direction, { "type": "array", "items": { "type": "number" }, "minItems": 3, "maxItems": 3 });

/// A fixed displacement: first turned by `angle_deg` about `turn` (right-hand rule), then moved by `move_mm`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Transform {
    /// Displacement of the origin, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub move_mm: Point,
    /// Direction to turn about; the z axis if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turn: Option<Direction>,
    /// Angle to turn by, degrees.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub angle_deg: Finite,
}

fn is_zero(v: &Finite) -> bool {
    v.get() == 0.0
}

impl Transform {
    /// As a rigid motion in mm that maps coordinates in the displaced frame to the frame it is given in.
    pub fn affine(&self) -> DAffine3 {
        let axis = self.turn.unwrap_or_else(Direction::z).unit();
        let rotation = DQuat::from_axis_angle(axis, self.angle_deg.get().to_radians());
        DAffine3::from_rotation_translation(rotation, self.move_mm.get())
    }

    /// The rigid motion `motion` (mm) as written in a file; the inverse of [`Transform::affine`] to rounding. `None` if
    /// a number is not finite, or the displacement more than 1e7 mm.
    pub fn from_affine(motion: &DAffine3) -> Option<Self> {
        let turn = DQuat::from_mat3(&motion.matrix3).normalize();
        // The shorter way round, and from the sine, so that small angles keep their digits.
        let sine = if turn.w < 0.0 { -turn.xyz() } else { turn.xyz() };
        let angle = 2.0 * sine.length().atan2(turn.w.abs());
        let move_mm = Point::new(motion.translation)?;
        Some(match sine.try_normalize() {
            Some(axis) if angle > 0.0 => {
                Self { move_mm, turn: Direction::new(axis), angle_deg: Finite::new(angle.to_degrees())? }
            }
            _ => Self { move_mm, ..Self::default() },
        })
    }

    /// True if it neither moves nor turns.
    pub fn is_identity(&self) -> bool {
        self.move_mm.is_zero() && is_zero(&self.angle_deg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_then_moves() {
        let t: Transform = toml::from_str("move_mm = [1, 2, 3]\nangle_deg = 90").unwrap();
        let p = t.affine().transform_point3(DVec3::X);
        assert!((p - DVec3::new(1.0, 3.0, 3.0)).length() < 1e-15);
        assert!(!t.is_identity() && Transform::default().is_identity());
    }

    #[test]
    fn motions_come_back() {
        for (i, angle) in [0.0f64, 1e-7, 0.4, 3.0, 180.0, -170.0, 359.0].into_iter().enumerate() {
            let axis = DVec3::new(1.0, i as f64 - 3.0, 0.5).normalize();
            let there = DAffine3::from_rotation_translation(
                DQuat::from_axis_angle(axis, angle.to_radians()),
                DVec3::new(100.0, -2.0, i as f64),
            );
            let back = Transform::from_affine(&there).unwrap().affine();
            assert!(back.abs_diff_eq(there, 1e-14), "{angle}: {back} {there}");
        }
        assert!(Transform::from_affine(&DAffine3::IDENTITY).unwrap().is_identity());
        assert!(Transform::from_affine(&DAffine3::from_translation(DVec3::NAN)).is_none());
    }

    #[test]
    fn directions_have_a_length() {
        #[derive(Debug, Deserialize)]
        struct Doc {
            d: Direction,
        }
        let unit = |text: &str| toml::from_str::<Doc>(text).map(|d| d.d.unit());
        assert!((unit("d = [0, 1e-300, 0]").unwrap() - DVec3::Y).length() < 1e-15);
        assert!((unit("d = [3e300, 0, 4e300]").unwrap() - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-15);
        assert!(unit("d = [0, 0, 0]").unwrap_err().to_string().contains("document-direction-without-length"));
        assert!(unit("d = [0, nan, 1]").is_err());
    }
}
