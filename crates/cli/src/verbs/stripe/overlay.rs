//! Drawing of the result over the image.

use glam::DVec2;
use seamwright_frames::{Colour, Overlay};
use seamwright_geometry::Homography;
use seamwright_project::failure::Failure;
use seamwright_vision::Image;
use seamwright_vision::stripe::{Features, StripeReader};

/// Colours: the chain, segments in turn, features, the joint point.
const CHAIN: Colour = [0, 210, 255];
const SEGMENTS: [Colour; 2] = [[80, 255, 80], [255, 210, 0]];
const FEATURE: Colour = [255, 120, 255];
const JOINT: Colour = [255, 40, 40];
/// Segments are three pixels thick, without the middle one, which is the chain's.
const BESIDE: [f64; 4] = [-3.0, -2.0, 2.0, 3.0];

/// The image with chain, segments and features as PNG.
pub(super) fn draw(
    image: &Image,
    reader: &StripeReader,
    to_mm: Option<&Homography>,
    found: Option<&Features>,
) -> Result<Vec<u8>, Failure> {
    let frame = image.frame().map_err(|e| Failure::input(&e))?;
    let to_px = to_mm.map(Homography::inverse);
    let px = |p: DVec2| match &to_px {
        Some(map) => map.map(p),
        None => Some(DVec2::new(p.x, -p.y)),
    };
    let mut picture = Overlay::of(&frame);
    for (i, segment) in reader.segments().iter().enumerate() {
        if let (Some(a), Some(b)) = (px(segment.ends[0]), px(segment.ends[1])) {
            picture.line(a, b, &BESIDE, SEGMENTS[i % 2]);
        }
    }
    for point in reader.chain() {
        picture.dot(point.at, CHAIN);
    }
    for (i, (_, at)) in found.iter().flat_map(|f| &f.points).enumerate().collect::<Vec<_>>().into_iter().rev() {
        if let Some(at) = px(*at) {
            picture.cross(at, if i == 0 { JOINT } else { FEATURE }, if i == 0 { 14 } else { 8 });
        }
    }
    picture.png().map_err(Failure::Environment)
}
