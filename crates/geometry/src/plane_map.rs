use glam::{DMat2, DVec2};
use seamwright_message::{Message, Unit, display_by_message};

/// Minimum and maximum mm per pixel.
const SCALES: std::ops::RangeInclusive<f64> = 1e-6..=1e3;
const MAX_SHEAR: f64 = 0.9;
/// Maximum relative change of a radius at the rim: beyond it the image folds or does not show a work plane.
const MAX_BARREL: f64 = 0.25;
/// Maximum radius of a frame as a share of the fold's radius: the slope there is still above a third.
const BEFORE_FOLD: f64 = 0.95;

/// Parameters of a map, as a user states them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapParameters {
    /// Size of the frame, pixels.
    pub size_px: (usize, usize),
    /// The pixel where the optical axis meets the plane; centre of the distortion.
    pub centre_px: DVec2,
    /// mm a pixel along the picture's x and y.
    pub mm_per_px: DVec2,
    /// Turn of the picture's x on the plane, from the camera's x to its y, rad.
    pub rotation: f64,
    /// Shift along the picture's x per mm down the picture, mm.
    pub shear: f64,
    /// Relative radial distortion at half a width from the centre: negative for a barrel, positive for a pincushion.
    pub barrel: f64,
}

/// Error for invalid map parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum MapError {
    /// A scale outside the allowed range of mm per pixel.
    Scale(f64),
    /// A shear beyond the limit: the picture's rows and columns are nearly parallel.
    Shear(f64),
    /// A rotation that is not finite or exceeds half a turn.
    Rotation(f64),
    /// The centre, in pixels to the right and down, is far outside of the frame.
    Centre { x: f64, y: f64 },
    /// Distortion without an inverse over the whole frame.
    Barrel(f64),
}

display_by_message!(MapError);

impl MapError {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        let new = Message::new;
        match *self {
            Self::Scale(scale) => new("geometry-map-scale")
                .value("scale", scale, Unit::Mm)
                .value("min", *SCALES.start(), Unit::Mm)
                .value("max", *SCALES.end(), Unit::Mm),
            Self::Shear(shear) => new("geometry-map-shear")
                .value("shear", shear, Unit::One)
                .value("min", -MAX_SHEAR, Unit::One)
                .value("max", MAX_SHEAR, Unit::One),
            Self::Rotation(rotation) => new("geometry-map-rotation").value("rotation", rotation, Unit::Rad),
            Self::Centre { x, y } => new("geometry-map-centre").value("x", x, Unit::One).value("y", y, Unit::One),
            Self::Barrel(barrel) => {
                new("geometry-map-barrel").value("barrel", barrel, Unit::One).value("max", MAX_BARREL, Unit::One)
            }
        }
    }
}

/// Pixels to mm on one plane square to the optical axis, and back.
///
/// A position m (mm) maps to the undistorted pixel offset n = M m. The pixel is n (1 + b |n|^2 / R^2) from the centre,
/// with R half the frame's width. The inverse solves that cubic by Newton's method, which approaches the root from one
/// side; both ways together are good to 1e-9 px. Beyond the fold of the distortion (a barrel far outside of the frame)
/// both maps return `None`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneMap {
    parameters: MapParameters,
    to_mm: DMat2,
    to_px: DMat2,
}

impl PlaneMap {
    /// The map of these parameters.
    ///
    /// # Errors
    /// The first parameter that is out of its range; a barrel that folds within the frame.
    pub fn new(parameters: MapParameters) -> Result<Self, MapError> {
        let MapParameters { size_px, centre_px, mm_per_px, rotation, shear, barrel } = parameters;
        if let Some(scale) = mm_per_px.to_array().into_iter().find(|s| !SCALES.contains(s)) {
            return Err(MapError::Scale(scale));
        }
        if !(..=std::f64::consts::PI).contains(&rotation.abs()) {
            return Err(MapError::Rotation(rotation));
        }
        if !(..=MAX_SHEAR).contains(&shear.abs()) {
            return Err(MapError::Shear(shear));
        }
        let size = DVec2::new(size_px.0 as f64, size_px.1 as f64);
        let far = (centre_px - 0.5 * size).abs() / (1.5 * size);
        if !far.is_finite() || far.max_element() > 1.0 {
            return Err(MapError::Centre { x: centre_px.x, y: centre_px.y });
        }
        let turn = DMat2::from_angle(rotation);
        let square = DMat2::from_cols(DVec2::new(mm_per_px.x, 0.0), DVec2::new(shear * mm_per_px.y, mm_per_px.y));
        let to_mm = turn * square;
        let map = Self { parameters, to_mm, to_px: to_mm.inverse() };
        let corners = [DVec2::ZERO, size, DVec2::new(size.x, 0.0), DVec2::new(0.0, size.y)];
        let folds = |corner: &DVec2| (*corner - centre_px).length() / map.radius() > BEFORE_FOLD * map.greatest();
        if !(..=MAX_BARREL).contains(&barrel.abs()) || corners.iter().any(folds) {
            return Err(MapError::Barrel(barrel));
        }
        Ok(map)
    }

    /// The parameters of the map.
    pub fn parameters(&self) -> &MapParameters {
        &self.parameters
    }

    /// Half the frame's width, pixels: the unit of the distortion.
    fn radius(&self) -> f64 {
        0.5 * self.parameters.size_px.0 as f64
    }

    /// Maximum distorted radius, in units of [`PlaneMap::radius`].
    fn greatest(&self) -> f64 {
        let b = self.parameters.barrel;
        if b < 0.0 { 2.0 / 3.0 / (-3.0 * b).sqrt() } else { f64::INFINITY }
    }

    /// The pixel of a position on the plane (mm in the camera's x and y); none beyond the fold.
    pub fn to_px(&self, mm: DVec2) -> Option<DVec2> {
        let n = self.to_px * mm;
        let bend = self.parameters.barrel * n.length_squared() / self.radius().powi(2);
        (1.0 + 3.0 * bend > 0.0).then(|| self.parameters.centre_px + (1.0 + bend) * n)
    }

    /// The position of a pixel on the plane, mm; none beyond the fold.
    pub fn to_mm(&self, px: DVec2) -> Option<DVec2> {
        let n = px - self.parameters.centre_px;
        let (b, rho) = (self.parameters.barrel, n.length() / self.radius());
        if !(..self.greatest()).contains(&rho) {
            return None;
        }
        // Towards the root of b r^3 + r - rho from the side where Newton's steps never pass it.
        let mut r = rho;
        for _ in 0..60 {
            let step = (b * r.powi(3) + r - rho) / (1.0 + 3.0 * b * r * r);
            r -= step;
            if step.abs() <= 1e-15 * rho {
                break;
            }
        }
        Some(self.to_mm * (n / (1.0 + b * r * r)))
    }

    /// mm a pixel about a pixel, the mean over all directions.
    pub fn scale_at(&self, px: DVec2) -> Option<f64> {
        let (x, y) = (self.to_mm(px + DVec2::X)?, self.to_mm(px + DVec2::Y)?);
        let here = self.to_mm(px)?;
        Some((x - here).perp_dot(y - here).abs().sqrt())
    }

    /// Linear interpolation from this map to `other` by the fraction `part`.
    pub(crate) fn mixed(&self, other: &Self, part: f64) -> Result<Self, MapError> {
        let (a, b) = (&self.parameters, &other.parameters);
        let mix = |from: f64, to: f64| from + part * (to - from);
        Self::new(MapParameters {
            size_px: a.size_px,
            centre_px: a.centre_px.lerp(b.centre_px, part),
            mm_per_px: a.mm_per_px.lerp(b.mm_per_px, part),
            rotation: mix(a.rotation, b.rotation),
            shear: mix(a.shear, b.shear),
            barrel: mix(a.barrel, b.barrel),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn parameters() -> impl Strategy<Value = MapParameters> {
        let size = (64usize..2000, 64usize..2000);
        let place = (0.2f64..0.8, 0.2f64..0.8);
        let scale = ((-4.0f64..1.0), (0.7f64..1.4));
        (size, place, scale, -3.1f64..3.1, -0.3f64..0.3, -0.02f64..0.06).prop_map(
            |(size, place, scale, turn, shear, b)| MapParameters {
                size_px: size,
                centre_px: DVec2::new(place.0 * size.0 as f64, place.1 * size.1 as f64),
                mm_per_px: DVec2::new(1.0, scale.1) * 10f64.powf(scale.0),
                rotation: turn,
                shear,
                barrel: b,
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 4 * ProptestConfig::default().cases, ..ProptestConfig::default() })]

        #[test]
        fn there_and_back(p in parameters(), at in (0.0f64..1.0, 0.0f64..1.0)) {
            // A frame much higher than wide reaches far beyond the radius at which the distortion is given.
            let Ok(map) = PlaneMap::new(p) else {
                prop_assert!(p.barrel < 0.0 && p.size_px.1 > p.size_px.0);
                return Ok(());
            };
            let px = DVec2::new(at.0 * p.size_px.0 as f64, at.1 * p.size_px.1 as f64);
            let mm = map.to_mm(px).unwrap();
            prop_assert!((map.to_px(mm).unwrap() - px).length() < 1e-9, "{px}");
            let again = map.to_mm(map.to_px(mm).unwrap()).unwrap();
            prop_assert!((again - mm).length() < 1e-9 * p.mm_per_px.max_element().max(1.0));
        }
    }

    fn plain() -> MapParameters {
        MapParameters {
            size_px: (512, 512),
            centre_px: DVec2::splat(256.0),
            mm_per_px: DVec2::new(0.1, 0.2),
            rotation: 0.0,
            shear: 0.0,
            barrel: 0.0,
        }
    }

    #[test]
    fn parameters_mean_what_they_say() {
        let map = PlaneMap::new(plain()).unwrap();
        assert!((map.to_mm(DVec2::new(266.0, 251.0)).unwrap() - DVec2::new(1.0, -1.0)).length() < 1e-12);
        assert!((map.scale_at(DVec2::ZERO).unwrap() - 0.02f64.sqrt()).abs() < 1e-12);
        let turned = PlaneMap::new(MapParameters { rotation: 0.5f64.to_radians() * 180.0, ..plain() }).unwrap();
        assert!((turned.to_mm(DVec2::new(266.0, 256.0)).unwrap() - DVec2::new(0.0, 1.0)).length() < 1e-12);
        let sheared = PlaneMap::new(MapParameters { shear: 0.5, ..plain() }).unwrap();
        assert!((sheared.to_mm(DVec2::new(256.0, 261.0)).unwrap() - DVec2::new(0.5, 1.0)).length() < 1e-12);
        // Half a width off the centre a barrel of -0.05 draws in by a twentieth.
        let barrelled = PlaneMap::new(MapParameters { barrel: -0.05, ..plain() }).unwrap();
        let px = barrelled.to_px(DVec2::new(25.6, 0.0)).unwrap();
        assert!((px - DVec2::new(256.0 + 0.95 * 256.0, 256.0)).length() < 1e-12, "{px}");
        assert!(barrelled.to_mm(DVec2::new(1000.0, 256.0)).is_none());
    }

    #[test]
    fn what_is_no_map_is_refused() {
        let bad = |p: MapParameters| PlaneMap::new(p).unwrap_err();
        assert_eq!(bad(MapParameters { mm_per_px: DVec2::new(0.1, 0.0), ..plain() }), MapError::Scale(0.0));
        let scale = bad(MapParameters { mm_per_px: DVec2::new(f64::NAN, 0.1), ..plain() });
        assert!(matches!(scale, MapError::Scale(scale) if scale.is_nan()));
        assert_eq!(bad(MapParameters { shear: 1.0, ..plain() }), MapError::Shear(1.0));
        assert_eq!(bad(MapParameters { rotation: f64::INFINITY, ..plain() }), MapError::Rotation(f64::INFINITY));
        assert_eq!(bad(MapParameters { barrel: -0.24, ..plain() }), MapError::Barrel(-0.24));
        let centre = bad(MapParameters { centre_px: DVec2::new(-600.0, 0.0), ..plain() });
        assert_eq!(centre, MapError::Centre { x: -600.0, y: 0.0 });
    }
}
