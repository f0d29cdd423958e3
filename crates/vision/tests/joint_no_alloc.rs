//! After the first frame of a size, following a joint allocates nothing.

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use seamwright_vision::joint::{Follower, Options, Start};
use seamwright_vision::{Frame, Pixels};
use std::hint::black_box;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

const SIZE: usize = 400;

/// Joints of a width, wavy, with a tack.
fn image(width: f64) -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        let d = (y - 200.0 - 12.0 * (x / 60.0).sin()) / width;
        if (x - 230.0).abs() < 20.0 { 180 } else { (150.0 - 60.0 * (-2.8 * d * d).exp()) as u8 }
    };
    (0..SIZE * SIZE).map(grey).collect()
}

/// A black gap that ends in the shade: it is looked for on the top-hat too.
fn shaded() -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        let d = (y - 200.0) / 14.0;
        let depth = if x < 300.0 { 0.85 * (-2.8 * d * d).exp() } else { 0.0 };
        (210.0 * (-x / 160.0).exp() * (1.0 - depth) + 4.0) as u8
    };
    (0..SIZE * SIZE).map(grey).collect()
}

#[test]
fn following_does_not_allocate() {
    let images: Vec<Vec<u8>> = [2.0, 5.0, 9.0, 17.0, 33.0].map(image).into_iter().chain([shaded()]).collect();
    let mut follower = Follower::new(Options::default());
    let mut follow = |pixels: &[u8]| {
        let frame = Frame::new(SIZE, SIZE, Pixels::U8(pixels)).unwrap();
        black_box(follower.follow(&frame, &Start { x: 8.0, y: 202.0, direction: 0.1, width: None }).rows.len())
    };
    assert!(follow(&images[0]) > 100);
    assert_no_alloc(|| images.iter().for_each(|image| _ = follow(image)));
    assert_eq!(violation_count(), 0);
}
