//! Benchmark from an image to the features of a V groove, at 2048 columns. Target: 1 ms with windows of up to 512 rows.

use crate::measure::rate;
use seamwright_geometry::Homography;
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use seamwright_vision::{Frame, Pixels};
use std::hint::black_box;

const WIDTH: usize = 2048;

/// A V groove over a third of the height, with deterministic noise.
fn image(height: usize) -> Vec<u8> {
    let (top, deep) = (0.3 * height as f64, 0.35 * height as f64);
    let half = deep / 1.7;
    let row = |c: f64| top + deep * (1.0 - (c - 1000.0).abs() / half).max(0.0);
    let mut state = 1u32;
    let mut pixels = Vec::with_capacity(WIDTH * height);
    for r in 0..height {
        for c in 0..WIDTH {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let d = r as f64 - row(c as f64);
            let noise = f64::from(state >> 24) / 16.0;
            pixels.push((15.0 + noise + 160.0 * (-d * d / 10.0).exp()) as u8);
        }
    }
    pixels
}

pub(crate) fn stripe() {
    for height in [256, 512, 1024] {
        let pixels = image(height);
        let to_mm = Homography::from_eight([0.05, 0.0, -51.2, 0.0, -0.05, 10.0, 0.0, 0.0]).expect("it is a scale");
        let mut reader = StripeReader::new();
        let task = StripeTask::in_mm(JointKind::V);
        let frame = Frame::new(WIDTH, height, Pixels::U8(&pixels)).expect("it has that many pixels");
        assert!(reader.read_image(&frame, Some(&to_mm), &task).is_ok_and(|f| f.is_confident()));
        rate(&format!("stripe/image to features/{height}"), (WIDTH * height) as u64, || {
            black_box(reader.read_image(&frame, Some(&to_mm), &task).is_ok())
        });
        rate(&format!("stripe/image to chain/{height}"), (WIDTH * height) as u64, || {
            black_box(reader.trace(&frame).is_ok())
        });
    }
}
