//! A plate with a grid of dots, seen by a camera whose map deviates from the assumed one.

use super::Random;
use glam::DVec2;
use seamwright_geometry::{MapError, MapParameters, PlaneMap};
use seamwright_vision::Image;

/// Radius of a dot as a share of the pitch.
const RADIUS: f64 = 0.22;
/// Brightness of the plate, and the share by which a dot reduces it.
const PLATE: f64 = 180.0;
const DARK: f64 = 0.65;
/// Standard deviation of a pixel's noise.
const NOISE: f64 = 3.0;

/// Simulates a camera near to `believed` before a skew plate with dots every `pitch_mm`. Returns the picture and the
/// camera's true map. The seed changes scales by up to 2 %, turns the picture by up to 3 degrees, and changes its
/// distortion.
///
/// # Errors
/// Invalid parameters of the camera near to it.
pub fn plate(believed: &MapParameters, pitch_mm: f64, seed: u64) -> Result<(Image, PlaneMap), MapError> {
    let mut random = Random::new(seed);
    let truth = PlaneMap::new(MapParameters {
        mm_per_px: believed.mm_per_px * DVec2::new(random.within(0.98, 1.02), random.within(0.98, 1.02)),
        rotation: believed.rotation + random.within(-3.0, 3.0).to_radians(),
        shear: believed.shear + random.within(-0.004, 0.004),
        barrel: believed.barrel + random.within(-0.01, 0.01),
        ..*believed
    })?;
    let (askew, origin) = (
        DVec2::from_angle(random.within(-5.0, 5.0).to_radians()),
        pitch_mm * DVec2::new(random.within(0.0, 1.0), random.within(0.0, 1.0)),
    );
    let (width, height) = believed.size_px;
    let edge = believed.mm_per_px.min_element();
    let mut pixels = Vec::with_capacity(width * height);
    for i in 0..width * height {
        let place = truth.to_mm(DVec2::new((i % width) as f64, (i / width) as f64));
        // Offset in the plate's own frame from the nearest dot; a pixel on its rim is partly dark.
        let off = place.map(|mm| askew.rotate(mm) - origin).map(|mm| mm - pitch_mm * (mm / pitch_mm).round());
        let covered = off.map_or(0.0, |off| (0.5 + (RADIUS * pitch_mm - off.length()) / edge).clamp(0.0, 1.0));
        pixels.push((PLATE * (1.0 - DARK * covered) + NOISE * random.normal()).clamp(0.0, 255.0) as u8);
    }
    Ok((Image::U8 { width, height, pixels }, truth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_vision::camera::{Grid, identify};

    /// The camera identified from the picture is the one that painted it, except for the pose of the plate.
    #[test]
    fn its_picture_tells_the_camera() {
        for seed in 0..6 {
            let believed = MapParameters {
                size_px: (400, 320),
                centre_px: DVec2::new(205.0, 150.0),
                mm_per_px: DVec2::new(0.1, 0.09),
                rotation: 0.0,
                shear: 0.0,
                barrel: -0.02,
            };
            let (image, truth) = plate(&believed, 3.0, seed).unwrap();
            let grid = Grid { pitch_mm: 3.0, centre_px: Some(believed.centre_px), limit_px: 0.3 };
            let found = identify(&image.frame().unwrap(), &grid).unwrap();
            let (is, of) = (found.map.parameters(), truth.parameters());
            assert!(((is.mm_per_px - of.mm_per_px) / of.mm_per_px).abs().max_element() < 1e-3, "{is:?} {of:?}");
            assert!((is.shear - of.shear).abs() < 1e-3 && (is.barrel - of.barrel).abs() < 2e-3, "{is:?} {of:?}");
            assert!((is.mm_per_px - believed.mm_per_px).length() > 1e-5, "it is the believed one");
        }
    }
}
