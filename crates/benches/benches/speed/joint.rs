//! Benchmark of following a joint through a frame. Targets for 512 x 512: median 0.3 ms, 99th percentile 1 ms; time
//! linear in the passed pixels.

use crate::measure::rate;
use seamwright_vision::joint::{CONFIDENT, End, Follower, Options, Start};
use seamwright_vision::{Frame, Pixels};
use std::hint::black_box;

/// A wavy joint of this width with a contrast-to-noise ratio of about 4; deterministic noise.
fn image(size: usize, width: f64) -> Vec<u8> {
    let mut state = 1u32;
    let mut pixels = Vec::with_capacity(size * size);
    for y in 0..size {
        for x in 0..size {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let noise = f64::from(state >> 24) / 8.0 - 16.0;
            let d = (y as f64 - 0.45 * size as f64 - 14.0 * (x as f64 / 90.0).sin()) / width;
            pixels.push((140.0 - 40.0 * (-2.77 * d * d).exp() + noise) as u8);
        }
    }
    pixels
}

pub(crate) fn joint() {
    let mut follower = Follower::new(Options::default());
    for (size, width) in [(512, 2.5), (512, 6.0), (512, 12.0), (512, 30.0), (256, 6.0), (1024, 6.0)] {
        let pixels = image(size, width);
        let frame = Frame::new(size, size, Pixels::U8(&pixels)).expect("it has that many pixels");
        let start = Start { x: 10.0, y: 0.45 * size as f32 + 1.5, direction: 0.15, width: None };
        let found = follower.follow(&frame, &start);
        let sure = found.rows.iter().filter(|r| r.confidence >= CONFIDENT).count();
        assert!(found.end == End::LeftImage && 2 * sure > found.rows.len(), "{size} {width}: {sure} sure");
        rate(&format!("joint/width {width}/{size}"), (size * size) as u64, || {
            black_box(follower.follow(&frame, &start).rows.len())
        });
    }
}
