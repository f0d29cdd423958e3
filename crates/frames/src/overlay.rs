//! A frame as a picture that is drawn on, to PNG.

use glam::DVec2;
use seamwright_message::Message;
use seamwright_vision::{Frame, Pixels};

/// A colour: red, green, blue.
pub type Colour = [u8; 3];

/// Colour of rows that were only coasted over.
pub const COASTED: Colour = [90, 150, 255];
/// Of a cross.
pub const CROSS: Colour = [255, 255, 255];
/// Of where a joint is looked for.
pub const ZONE: Colour = [0, 210, 255];
/// Of the next move.
pub const MOTION: Colour = [255, 120, 255];

/// Red without confidence, yellow at `usual`, green when sure.
pub fn sureness(confidence: f64, usual: f64) -> Colour {
    let part = |v: f64| (255.0 * v.clamp(0.0, 1.0)) as u8;
    [part(2.0 - confidence / usual), part(confidence / usual), 0]
}

/// A picture to draw on; positions are in the frame's pixels.
pub struct Overlay {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Overlay {
    /// The frame, darkened so that colours stand out.
    pub fn of(frame: &Frame) -> Self {
        let dark = |grey: u8| [(u16::from(grey) * 3 / 5) as u8; 3];
        let pixels = match frame.pixels() {
            Pixels::U8(pixels) => pixels.iter().flat_map(|p| dark(*p)).collect(),
            Pixels::U16(pixels) => pixels.iter().flat_map(|p| dark((p >> 8) as u8)).collect(),
        };
        Self { width: frame.width(), height: frame.height(), pixels }
    }

    /// One pixel, if it is on the picture.
    pub fn dot(&mut self, at: DVec2, colour: Colour) {
        let (x, y) = (at.x.round(), at.y.round());
        if x >= 0.0 && y >= 0.0 && x < self.width as f64 && y < self.height as f64 {
            let i = 3 * (y as usize * self.width + x as usize);
            self.pixels[i..i + 3].copy_from_slice(&colour);
        }
    }

    /// A line drawn once for each of the distances `beside` it, pixels.
    pub fn line(&mut self, a: DVec2, b: DVec2, beside: &[f64], colour: Colour) {
        let steps = (b - a).abs().max_element().ceil().min(4.0 * (self.width + self.height) as f64);
        let across = (b - a).perp().normalize_or(DVec2::Y);
        for i in 0..=steps as usize {
            let p = a + (b - a) * (i as f64 / steps.max(1.0));
            beside.iter().for_each(|k| self.dot(p + *k * across, colour));
        }
    }

    /// A rectangle, two pixels thick, a pixel inside of `low` and `high`: where a joint was looked for.
    pub fn zone(&mut self, low: DVec2, high: DVec2) {
        let (low, high) = (low + 1.0, high - 1.0);
        let corners = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y), low];
        corners.windows(2).for_each(|side| self.line(side[0], side[1], &[0.0, 1.0], ZONE));
    }

    /// A cross, two pixels thick.
    pub fn cross(&mut self, at: DVec2, colour: Colour, size: i32) {
        for k in -size..=size {
            for w in [0.0, 1.0] {
                self.dot(at + DVec2::new(f64::from(k), w), colour);
                self.dot(at + DVec2::new(w, f64::from(k)), colour);
            }
        }
    }

    /// Draws an arrow, two pixels thick, unless it is shorter than a pixel.
    pub fn arrow(&mut self, from: DVec2, to: DVec2, colour: Colour) {
        let Some(along) = (to - from).try_normalize().filter(|_| from.distance(to) >= 1.0) else { return };
        let barb = (0.2 * from.distance(to)).min(18.0);
        self.line(from, to, &[0.0, 1.0], colour);
        for side in [-0.4, 0.4] {
            self.line(to, to - barb * (along + side * along.perp()), &[0.0, 1.0], colour);
        }
    }

    /// The picture as PNG.
    ///
    /// # Errors
    /// Errors of the PNG encoder.
    pub fn png(&self) -> Result<Vec<u8>, Message> {
        let mut bytes = Vec::new();
        let mut png = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        png.set_color(png::ColorType::Rgb);
        png.set_compression(png::Compression::Fast);
        let written = png.write_header().and_then(|mut png| {
            png.write_image_data(&self.pixels)?;
            png.finish()
        });
        written.map_err(|e| Message::outside(&e))?;
        Ok(bytes)
    }
}
