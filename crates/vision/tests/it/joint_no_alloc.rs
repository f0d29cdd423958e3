//! Following a joint does not allocate after the first frame of a size.

use seamwright_testkit::no_alloc;
use seamwright_vision::joint::{Follower, Options, Start};
use seamwright_vision::{Frame, Pixels};
use std::hint::black_box;

const SIZE: usize = 400;

/// A wavy joint of this width, with a tack.
fn image(width: f64) -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        let d = (y - 200.0 - 12.0 * (x / 60.0).sin()) / width;
        if (x - 230.0).abs() < 20.0 { 180 } else { (150.0 - 60.0 * (-2.8 * d * d).exp()) as u8 }
    };
    (0..SIZE * SIZE).map(grey).collect()
}

/// A black gap that ends in a shadow, so that it is searched on the top-hat too.
fn shaded() -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        let d = (y - 200.0) / 14.0;
        let depth = if x < 300.0 { 0.85 * (-2.8 * d * d).exp() } else { 0.0 };
        (210.0 * (-x / 160.0).exp() * (1.0 - depth) + 4.0) as u8
    };
    (0..SIZE * SIZE).map(grey).collect()
}

/// A gap beside the edge of a shadow, with a tack on both: it continues on the top-hat, or seems to.
fn tacked(width: f64, edge: f64, radius: f64, end: f64) -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % SIZE) as f64, (i / SIZE) as f64);
        let middle = 200.0 + 12.0 * (x / 60.0).sin();
        let metal = if y + 0.05 * x > edge { 110.0 } else { 160.0 };
        let d = (y - middle) / width;
        let gap = if x < end { (-2.8 * d * d).exp() } else { 0.0 };
        let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
        let noise = 12.0 * (hash as f64 / f64::from(1 << 24) - 0.5);
        let plate = if (x - 190.0).hypot(y - 200.0) < radius { 175.0 } else { metal + (85.0 - metal) * gap };
        (plate + noise) as u8
    };
    (0..SIZE * SIZE).map(grey).collect()
}

#[test]
fn following_does_not_allocate() {
    let many = (0..120).map(|i| {
        let (a, b) = (f64::from(i % 12), f64::from(i / 12));
        tacked(2.0 + 1.7 * a, 190.0 + 4.0 * b, 8.0 + 3.0 * (a + b) / 2.0, if i % 3 == 0 { 280.0 } else { 500.0 })
    });
    let images: Vec<Vec<u8>> =
        [2.0, 5.0, 9.0, 17.0, 33.0].map(image).into_iter().chain([shaded()]).chain(many).collect();
    let follow = |follower: &mut Follower, pixels: &[u8], width: Option<f32>| {
        let frame = Frame::new(SIZE, SIZE, Pixels::U8(pixels)).unwrap();
        black_box(follower.follow(&frame, &Start { x: 8.0, y: 202.0, direction: 0.1, width }).rows.len())
    };
    // The first frame has no joint, or one joint or another, and is searched with any width or with one.
    let blank = vec![128; SIZE * SIZE];
    for (first, width) in [(&blank, None), (&blank, Some(5.0)), (&images[0], None), (&images[2], Some(9.0))] {
        let mut follower = Follower::new(Options::default());
        assert_eq!(follow(&mut follower, first, width) > 100, first != &blank);
        for width in [width, None, Some(12.0), Some(24.0)] {
            no_alloc(|| images.iter().for_each(|image| _ = follow(&mut follower, image, width)));
        }
    }
}
