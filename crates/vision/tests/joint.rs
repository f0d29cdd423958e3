//! The follower on pictures that are known exactly.

use seamwright_vision::joint::{End, Follower, Options, Start, State};
use seamwright_vision::{Frame, Pixels};

/// A bell `depth` deep of full width `width` along the line y = a + b x on grey 150.
fn straight(size: usize, a: f64, b: f64, width: f64, depth: f64) -> Vec<u8> {
    let bell = |d: f64| (-4.0 * std::f64::consts::LN_2 * (d / width).powi(2)).exp();
    (0..size * size)
        .map(|i| {
            let (x, y) = ((i % size) as f64, (i / size) as f64);
            let d = (y - a - b * x) / b.hypot(1.0);
            (150.0 - depth * bell(d)).round() as u8
        })
        .collect()
}

#[test]
fn straight_joints_of_all_widths_are_found_between_pixels() {
    let mut follower = Follower::new(Options::default());
    for width in [2.0, 3.0, 4.5, 6.0, 8.0, 11.0, 16.0, 23.0, 32.0, 44.0] {
        for (a, b) in [(200.3, 0.0), (160.0, 0.31), (300.7, -0.17)] {
            let pixels = straight(512, a, b, width, 60.0);
            let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
            let start =
                Start { x: 8.0, y: (a + 8.0 * b + 1.0) as f32, direction: (b as f32).atan() + 0.05, width: None };
            let joint = follower.follow(&frame, &start);
            assert_eq!(joint.end, End::LeftImage, "width {width}");
            let last = joint.rows.last().unwrap();
            assert!(last.x > 500.0, "width {width}: {}", last.x);
            if width == 2.0 { for r in joint.rows.iter().take(60).step_by(3) { println!("{r:?}"); } }
            let inside = joint.rows.iter().filter(|r| (20.0..490.0).contains(&r.x));
            for row in inside {
                let off = (f64::from(row.y) - a - b * f64::from(row.x)) / b.hypot(1.0);
                assert!(off.abs() < 0.1, "width {width}, slope {b}: {off} at {}", row.x);
                assert!(row.state == State::Seen && row.confidence > 0.9, "width {width}: {row:?}");
                assert!((f64::from(row.width) / width - 1.0).abs() < 0.2, "width {width}: {row:?}");
            }
        }
    }
}
