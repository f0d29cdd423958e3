//! Tests of the follower on synthetic pictures.

use seamwright_testkit::Random;
use seamwright_vision::joint::{CONFIDENT, End, Follower, Options, Start, State};
use seamwright_vision::{Frame, Pixels};

#[test]
fn straight_joints_of_all_widths_are_found_between_pixels() {
    let mut follower = Follower::new(Options::default());
    for width in [2.0, 3.0, 4.5, 6.0, 8.0, 11.0, 16.0, 23.0, 32.0, 44.0] {
        for (a, b) in [(200.3, 0.0), (160.0, 0.31), (300.7, -0.17)] {
            let pixels = picture(512, |x, y| 60.0 * bell((y - a - b * x) / b.hypot(1.0), width));
            let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
            let start =
                Start { x: 8.0, y: (a + 8.0 * b + 1.0) as f32, direction: (b as f32).atan() + 0.05, width: None };
            let joint = follower.follow(&frame, &start);
            assert_eq!(joint.end, End::LeftImage, "width {width}");
            let last = joint.rows.last().unwrap();
            assert!(last.x > 500.0, "width {width}: {}", last.x);
            // The first rows, and those next to the frame's border, are unconfident.
            let inside = joint.rows.iter().skip(8).filter(|r| r.x < 450.0);
            for row in inside {
                let off = (f64::from(row.y) - a - b * f64::from(row.x)) / b.hypot(1.0);
                assert!(off.abs() < 0.1 + 0.005 * width, "width {width}, slope {b}: {off} at {}", row.x);
                assert!(row.state == State::Seen && row.confidence >= CONFIDENT, "width {width}: {row:?}");
                assert!((f64::from(row.width) - width).abs() < (0.2 * width).max(0.7), "width {width}: {row:?}");
            }
        }
    }
}

/// A picture of the given depth at each point, on a grey value of 150.
fn picture(size: usize, depth: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    (0..size * size).map(|i| (150.0 - depth((i % size) as f64, (i / size) as f64)).round() as u8).collect()
}

fn bell(d: f64, width: f64) -> f64 {
    (-4.0 * std::f64::consts::LN_2 * (d / width).powi(2)).exp()
}

#[test]
fn circles_are_found_between_pixels_and_close() {
    let mut follower = Follower::new(Options::default());
    for (radius, width) in [(60.0, 3.0), (90.0, 6.0), (140.0, 12.0), (170.0, 10.0)] {
        let centre = (256.4, 255.7);
        let pixels = picture(512, |x, y| 70.0 * bell((x - centre.0).hypot(y - centre.1) - radius, width));
        let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
        for (side, direction) in [(1.0, 1.6), (-1.0, -1.55)] {
            let start = Start {
                x: (centre.0 + side * radius) as f32,
                y: centre.1 as f32,
                direction: direction + if side < 0.0 { 0.02 } else { 0.0 },
                width: None,
            };
            let joint = follower.follow(&frame, &start);
            assert_eq!(joint.end, End::Closed, "radius {radius}, width {width}");
            let confident: Vec<_> = joint.rows.iter().filter(|r| r.confidence >= CONFIDENT).collect();
            assert!(5 * confident.len() > 4 * joint.rows.len(), "{} of {}", confident.len(), joint.rows.len());
            for row in confident {
                let off = (f64::from(row.x) - centre.0).hypot(f64::from(row.y) - centre.1) - radius;
                assert!(off.abs() < 0.2, "radius {radius}, width {width}: {off}");
            }
        }
    }
}

#[test]
fn a_square_end_is_found_where_it_is() {
    let mut follower = Follower::new(Options::default());
    for (width, end) in [(2.5, 300.0), (5.0, 333.5), (9.0, 371.0), (18.0, 380.0), (30.0, 350.0)] {
        let pixels = picture(512, |x, y| 60.0 * bell(y - 240.2, width) * f64::from(u8::from(x <= end)));
        let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
        let joint = follower.follow(&frame, &Start { x: 12.0, y: 240.0, direction: 0.03, width: None });
        assert_eq!(joint.end, End::JointEnd, "width {width}");
        let last = joint.rows.last().unwrap();
        assert!((f64::from(last.x) - end).abs() < 1.5, "width {width}: ends at {} instead of {end}", last.x);
    }
}

fn noise(i: usize) -> f64 {
    let hash = (i as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let hash = (hash ^ (hash >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    ((hash >> 40) as f64 / f64::from(1 << 24) - 0.5) * 40.0
}

fn noisy(size: usize) -> Vec<u8> {
    let grey = |i: usize| {
        let (x, y) = ((i % size) as f64, (i / size) as f64);
        150.0 - 50.0 * bell(y - 0.4 * size as f64 - 20.0 * (x / 90.0).sin(), 4.0) + noise(i)
    };
    (0..size * size).map(|i| grey(i).round() as u8).collect()
}

fn begin(size: usize) -> Start {
    Start { x: 6.0, y: 0.4 * size as f32 + 1.3, direction: 0.2, width: None }
}

#[test]
fn sixteen_bits_show_what_eight_do_and_the_same_frame_gives_the_same_joint() {
    let eight = noisy(300);
    let sixteen: Vec<u16> = eight.iter().map(|p| u16::from(*p) * 257).collect();
    let mut follower = Follower::new(Options::default());
    let first = follower.follow(&Frame::new(300, 300, Pixels::U8(&eight)).unwrap(), &begin(300)).clone();
    assert_eq!(first.end, End::LeftImage);
    assert!(first.rows.len() > 280 && first.rows.iter().filter(|r| r.confidence >= CONFIDENT).count() > 200);
    // Independent of the frame followed before.
    let other = picture(200, |_, y| 80.0 * bell(y - 77.0, 11.0));
    follower.follow(
        &Frame::new(200, 200, Pixels::U8(&other)).unwrap(),
        &Start { x: 9.0, y: 77.0, direction: 0.0, width: None },
    );
    assert_eq!(first, follower.follow(&Frame::new(300, 300, Pixels::U8(&eight)).unwrap(), &begin(300)).clone());
    let wide = Follower::new(Options::default())
        .follow(&Frame::new(300, 300, Pixels::U16(&sixteen)).unwrap(), &begin(300))
        .clone();
    assert_eq!(wide.rows.len(), first.rows.len());
    for (a, b) in wide.rows.iter().zip(&first.rows) {
        assert!((a.x - b.x).abs() < 1e-3 && (a.y - b.y).abs() < 1e-3, "{a:?} {b:?}");
    }
}

#[test]
fn of_two_joints_that_cross_the_one_pointed_along_is_taken() {
    let mut follower = Follower::new(Options::default());
    for angle in [0.7f64, 0.9, 1.2, 1.57, -0.8, -1.3] {
        let (sin, cos) = angle.sin_cos();
        let pixels = picture(512, |x, y| {
            let along = bell(y - 250.0, 5.0);
            let across = bell((y - 250.0) * cos - (x - 256.0) * sin, 5.0);
            60.0 * along + 60.0 * across
        });
        let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
        let joint = follower.follow(&frame, &Start { x: 10.0, y: 251.0, direction: -0.05, width: None });
        assert_eq!(joint.end, End::LeftImage, "angle {angle}");
        assert!(joint.rows.last().unwrap().x > 505.0, "angle {angle}");
        for row in &joint.rows {
            assert!(
                (row.y - 250.0).abs() < if row.confidence >= CONFIDENT { 2.0 } else { 6.0 },
                "angle {angle}: {row:?}"
            );
        }
    }
}

#[test]
fn starts_outside_and_frames_without_a_joint_give_no_rows() {
    let mut follower = Follower::new(Options::default());
    let pixels = noisy(200);
    let frame = Frame::new(200, 200, Pixels::U8(&pixels)).unwrap();
    let good = begin(200);
    for start in [
        Start { x: -1.0, ..good },
        Start { y: 200.0, ..good },
        Start { x: f32::NAN, ..good },
        Start { direction: f32::INFINITY, ..good },
    ] {
        let joint = follower.follow(&frame, &start);
        assert!(joint.rows.is_empty() && joint.end == End::LeftImage, "{start:?}");
    }
    let grey = [vec![255u8; 10_000], vec![0; 10_000], (0..10_000).map(|i| (128.0 + noise(i)) as u8).collect()];
    for pixels in &grey {
        let frame = Frame::new(100, 100, Pixels::U8(pixels)).unwrap();
        let joint = follower.follow(&frame, &Start { x: 20.0, y: 50.0, direction: 0.0, width: None });
        assert!(joint.rows.is_empty() && joint.end == End::Lost);
    }
    // Frames smaller than a strip.
    for (width, height) in [(1, 1), (3, 40), (40, 2), (17, 16)] {
        let pixels = vec![90u8; width * height];
        let frame = Frame::new(width, height, Pixels::U8(&pixels)).unwrap();
        let joint = follower.follow(&frame, &Start { x: 0.0, y: 0.0, direction: 0.3, width: Some(30.0) });
        assert!(joint.rows.iter().all(|r| r.confidence < CONFIDENT));
    }
}

/// Gaps between plates of different light, with a lit rib in the gap up to half as light as the darker plate. The whole
/// gap is followed; 999 of 1000 rows are within 0.04 of the width of the middle between the rims. No confident row is
/// off by more than 2 px.
#[test]
fn a_rib_in_a_wide_gap_does_not_draw_the_middle_to_one_side() {
    let mut follower = Follower::new(Options::default());
    let mut numbers = Random::new(11);
    let mut random = |low: f64, high: f64| numbers.within(low, high);
    let (mut rows, mut near) = (0, 0);
    for _ in 0..200 {
        let (width, a, b) = (random(20.0, 50.0), random(220.0, 290.0), random(-0.1, 0.1));
        let plates = [random(110.0, 220.0), random(110.0, 220.0)];
        let rib = random(0.2, 0.5) * plates[0].min(plates[1]);
        let (at, thick) = (random(-0.2, 0.2) * width, random(0.08, 0.2) * width);
        let pixels = picture(512, |x, y| {
            let d = (y - a - b * x) / b.hypot(1.0);
            // Rims are as sharp as a lens makes them.
            let beyond = |side: f64| 1.0 / (1.0 + (1.5 * (0.5 * width - side * d)).exp());
            let metal = plates[0] * beyond(-1.0) + plates[1] * beyond(1.0);
            150.0 - (20.0 + metal + rib * bell(d - at, thick)).min(255.0)
        });
        let frame = Frame::new(512, 512, Pixels::U8(&pixels)).unwrap();
        let start = Start { x: 8.0, y: (a + 8.0 * b) as f32, direction: b.atan() as f32, width: None };
        let joint = follower.follow(&frame, &start);
        assert!(joint.rows.last().is_some_and(|r| r.x > 490.0), "width {width}, rib {rib} at {at}: {:?}", joint.end);
        for row in joint.rows.iter().filter(|r| (20.0..490.0).contains(&r.x)) {
            let off = (f64::from(row.y) - a - b * f64::from(row.x)) / b.hypot(1.0);
            assert!(off.abs() < 2.0 || row.confidence < CONFIDENT, "width {width}, rib {rib} at {at}: {off}, {row:?}");
            rows += 1;
            near += usize::from(off.abs() < 0.04 * width);
        }
    }
    assert!(rows > 10_000 && 1000 * near >= 999 * rows, "{near} of {rows}");
}

/// Frames of any size with pieces of lines, edges and noise, from any start: rows are finite, and a frame gives the
/// same joint after any other.
#[test]
fn any_frame_gives_rows_of_numbers_and_the_same_ones_again() {
    let mut numbers = Random::new(11);
    let mut random = |most: f64| numbers.within(0.0, most);
    let mut follower = Follower::new(Options::default());
    let mut found = 0;
    for case in 0..1500 {
        let (width, height) = (1 + random(260.0) as usize, 1 + random(260.0) as usize);
        let (x0, y0) = (random(width as f64), random(height as f64));
        let (slant, wide, deep) = (random(2.0) - 1.0, 1.0 + random(30.0), random(120.0));
        let (edge, step, ends, loud) = (random(width as f64), random(90.0), random(300.0), random(1.5));
        let grey = |i: usize| {
            let (x, y) = ((i % width) as f64, (i / width) as f64);
            let line = if (x - x0).abs() < ends {
                deep * bell((y - y0 - slant * (x - x0)) / slant.hypot(1.0), wide)
            } else {
                0.0
            };
            let lit = if x + 0.4 * y > edge { step } else { 0.0 };
            (120.0 + lit - line + loud * noise(i + case)).clamp(0.0, 255.0)
        };
        let eight: Vec<u8> = (0..width * height).map(|i| grey(i) as u8).collect();
        let sixteen: Vec<u16> = (0..width * height).map(|i| (257.0 * grey(i)) as u16).collect();
        let pixels = if case % 2 == 0 { Pixels::U8(&eight) } else { Pixels::U16(&sixteen) };
        let frame = Frame::new(width, height, pixels).unwrap();
        let told = (random(1.0) < 0.3).then(|| random(40.0) as f32);
        let start = Start { x: x0 as f32, y: y0 as f32, direction: slant.atan() as f32, width: told };
        let joint = follower.follow(&frame, &start).clone();
        assert!(joint.rows.iter().all(|r| r.x.is_finite() && r.y.is_finite() && (0.0..=1.0).contains(&r.confidence)));
        assert_eq!(joint, *Follower::new(Options::default()).follow(&frame, &start), "case {case}");
        found += usize::from(!joint.rows.is_empty());
    }
    assert!(found > 500, "{found}");
}
