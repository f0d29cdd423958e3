//! What was seen, drawn over the image.

use crate::failure::Failure;
use glam::DVec2;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder as _};
use seamwright_geometry::Homography;
use seamwright_vision::stripe::{Features, StripeReader};
use seamwright_vision::{Frame, Image, Pixels};

/// Colours: the chain, segments in turn, features, the joint point.
const CHAIN: [u8; 3] = [0, 210, 255];
const SEGMENTS: [[u8; 3]; 2] = [[80, 255, 80], [255, 210, 0]];
const FEATURE: [u8; 3] = [255, 120, 255];
const JOINT: [u8; 3] = [255, 40, 40];

/// A picture being drawn on.
struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

/// The image with chain, segments and features as PNG.
pub(super) fn draw(
    image: &Image,
    reader: &StripeReader,
    to_mm: Option<&Homography>,
    found: Option<&Features>,
) -> Result<Vec<u8>, Failure> {
    let frame = image.frame().map_err(|e| Failure::Input(e.to_string()))?;
    let to_px = to_mm.map(Homography::inverse);
    let px = |p: DVec2| match &to_px {
        Some(map) => map.map(p),
        None => Some(DVec2::new(p.x, -p.y)),
    };
    let mut canvas = Canvas::of(&frame);
    for (i, segment) in reader.segments().iter().enumerate() {
        if let (Some(a), Some(b)) = (px(segment.ends[0]), px(segment.ends[1])) {
            canvas.line(a, b, SEGMENTS[i % 2]);
        }
    }
    for point in reader.chain() {
        canvas.dot(point.at, CHAIN);
    }
    for (i, (_, at)) in found.iter().flat_map(|f| &f.points).enumerate().collect::<Vec<_>>().into_iter().rev() {
        if let Some(at) = px(*at) {
            canvas.cross(at, if i == 0 { JOINT } else { FEATURE }, if i == 0 { 14 } else { 8 });
        }
    }
    canvas.png()
}

impl Canvas {
    /// The frame, darkened so that colours stand out.
    fn of(frame: &Frame) -> Self {
        let dark = |grey: u8| [(u16::from(grey) * 3 / 5) as u8; 3];
        let pixels = match frame.pixels() {
            Pixels::U8(pixels) => pixels.iter().flat_map(|p| dark(*p)).collect(),
            Pixels::U16(pixels) => pixels.iter().flat_map(|p| dark((p >> 8) as u8)).collect(),
        };
        Self { width: frame.width(), height: frame.height(), pixels }
    }

    /// One pixel, if it is on the picture.
    fn dot(&mut self, at: DVec2, colour: [u8; 3]) {
        let (x, y) = (at.x.round(), at.y.round());
        if x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64 {
            let i = 3 * (y as usize * self.width + x as usize);
            self.pixels[i..i + 3].copy_from_slice(&colour);
        }
    }

    /// A line three pixels thick, without the middle one, which is the chain's.
    fn line(&mut self, a: DVec2, b: DVec2, colour: [u8; 3]) {
        let steps = (b - a).abs().max_element().ceil().min(4.0 * (self.width + self.height) as f64);
        let across = (b - a).perp().normalize_or(DVec2::Y);
        for i in 0..=steps as usize {
            let p = a + (b - a) * (i as f64 / steps.max(1.0));
            [-3.0, -2.0, 2.0, 3.0].into_iter().for_each(|k| self.dot(p + k * across, colour));
        }
    }

    /// A cross, two pixels thick.
    fn cross(&mut self, at: DVec2, colour: [u8; 3], size: i32) {
        for k in -size..=size {
            for w in [0.0, 1.0] {
                self.dot(at + DVec2::new(f64::from(k), w), colour);
                self.dot(at + DVec2::new(w, f64::from(k)), colour);
            }
        }
    }

    fn png(&self) -> Result<Vec<u8>, Failure> {
        let mut png = Vec::new();
        let (width, height) = (self.width as u32, self.height as u32);
        let encoded = PngEncoder::new(&mut png).write_image(&self.pixels, width, height, ExtendedColorType::Rgb8);
        encoded.map_err(|e| Failure::Environment(e.to_string()))?;
        Ok(png)
    }
}
