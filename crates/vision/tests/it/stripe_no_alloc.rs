//! Reading stripes does not allocate after the first image of a size, for any joint type.

use seamwright_geometry::Homography;
use seamwright_testkit::no_alloc;
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use seamwright_vision::{Frame, Pixels};
use std::hint::black_box;

const SIZE: (usize, usize) = (800, 300);

/// A V groove with two reflections, moved to the right by `shift` columns.
fn image(shift: f64) -> Vec<u8> {
    let row = |c: f64| match c - shift {
        c if c < 300.0 => 80.0,
        c if c < 400.0 => 80.0 + 1.5 * (c - 300.0),
        c if c < 500.0 => 230.0 - 1.5 * (c - 400.0),
        _ => 80.0,
    };
    let light = |d: f64| 150.0 * (-d * d / 10.0).exp();
    let grey = |i: usize| {
        let (c, r) = ((i % SIZE.0) as f64, (i / SIZE.0) as f64);
        let reflection = if c < 250.0 { light(r - 250.0 + 0.1 * c) } else { 0.0 };
        (10.0 + light(r - row(c)) + 0.5 * light(r - 50.0 - 0.01 * c) + reflection).min(255.0) as u8
    };
    (0..SIZE.0 * SIZE.1).map(grey).collect()
}

#[test]
fn reading_does_not_allocate() {
    let images: Vec<Vec<u8>> = (0..4).map(|i| image(f64::from(i) * 7.0)).collect();
    let to_mm = Homography::from_eight([0.05, 0.0, -20.0, 0.0, -0.05, 7.5, 1e-5, 1e-4]).unwrap();
    let mut reader = StripeReader::new();
    let mut read = |pixels: &[u8], joint: JointKind| {
        let frame = Frame::new(SIZE.0, SIZE.1, Pixels::U8(pixels)).unwrap();
        black_box(reader.read_image(&frame, Some(&to_mm), &StripeTask::in_mm(joint)).is_ok())
    };
    for joint in JointKind::ALL {
        read(&images[0], joint);
    }
    let mut found = 0;
    no_alloc(|| {
        for pixels in &images {
            for joint in JointKind::ALL {
                found += u32::from(read(pixels, joint));
            }
        }
    });
    assert!(found >= 4, "the groove was read");
}
