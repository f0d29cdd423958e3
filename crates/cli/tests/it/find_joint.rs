//! `seamwright vision joint`: a painted joint whose midline is known, photographs with hand-read points, and the errors
//! of other images.

use crate::common::{bad, good, json, json_file, picture, root, run, scratch_file};

/// Rows with at least this confidence are confident (docs/reference/cli.md).
const CONFIDENT: f64 = 0.5;

#[derive(Debug)]
struct Row {
    x: f64,
    y: f64,
    confidence: f64,
    width: f64,
}

fn rows(csv: &str) -> Vec<Row> {
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("x_px,y_px,confidence,width_px,state"));
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        assert!(["seen", "coasted"].contains(&cells[4]), "{line}");
        let n = |i: usize| cells[i].parse().unwrap();
        Row { x: n(0), y: n(1), confidence: n(2), width: n(3) }
    };
    lines.map(row).collect()
}

fn pgm(name: &str, width: usize, height: usize, grey: impl Fn(usize, usize) -> f64) -> String {
    let mut bytes = format!("P5\n{width} {height}\n255\n").into_bytes();
    bytes.extend((0..width * height).map(|i| grey(i % width, i / width).round().clamp(0.0, 255.0) as u8));
    scratch_file(name, &bytes)
}

/// A number from -1 to 1 that goes with the pixel.
fn even(x: usize, y: usize) -> f64 {
    let mut v = (x as u64 * 0x9e37_79b9 + y as u64 * 0x85eb_ca6b).wrapping_mul(0xff51_afd7_ed55_8ccd);
    v ^= v >> 33;
    v = v.wrapping_mul(0xc4ce_b9fe_1a85_ec53);
    (v >> 40) as f64 / f64::from(1 << 23) - 1.0
}

fn midline(x: f64) -> f64 {
    120.0 + 0.1 * x
}

/// A joint 6 pixels wide at half its depth of 60, on metal of 150 with noise.
fn painted() -> String {
    pgm("painted.pgm", 320, 256, |x, y| {
        let off = (y as f64 - midline(x as f64)) / 1.01f64.sqrt();
        150.0 - 60.0 * (-4.0 * 2f64.ln() * (off / 6.0).powi(2)).exp() + 8.0 * even(x, y)
    })
}

#[test]
fn a_painted_joint_as_rows_json_and_picture() {
    let image = painted();
    let png = scratch_file("seen.png", b"");
    let arguments = ["vision", "joint", &image, "--start", "12,121", "--direction-deg", "3", "--overlay", &png];
    let output = run(&arguments);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(String::from_utf8(output.stderr).unwrap().lines().last(), Some("left-image"));
    let found = rows(&String::from_utf8(output.stdout).unwrap());
    let confident: Vec<&Row> = found.iter().filter(|r| r.confidence >= CONFIDENT).collect();
    assert!(confident.len() > 200, "{} of {}", confident.len(), found.len());
    for row in confident {
        let off = (row.y - midline(row.x)) / 1.01f64.sqrt();
        assert!(off.abs() < 0.6 && (row.width - 6.0).abs() < 2.0, "{off} {}", row.width);
    }
    let (size, pixels) = picture(&png);
    assert_eq!(size, (320, 256));
    let colours = pixels.iter().filter(|p| p[0] != p[1]).count();
    assert!(colours > 1000, "{colours}");
    let json = json(&[&arguments[..7], &["--json"]].concat());
    assert_eq!(json["end"], "left-image");
    let all = json["rows"].as_array().unwrap();
    assert_eq!(all.len(), found.len());
    assert!((all[9]["y_px"].as_f64().unwrap() - found[9].y).abs() < 1e-9);
    // The zone ends the line.
    let zoned = rows(&good(&[&arguments[..7], &["--zone-px", "0,0,150,255"]].concat()));
    assert!(!zoned.is_empty() && zoned.iter().all(|r| r.x <= 150.0));
}

#[test]
fn no_joint_is_lost_at_once() {
    let blank = pgm("blank.pgm", 200, 200, |x, y| 130.0 + 8.0 * even(x, y));
    let told = bad(1, &["vision", "joint", &blank, "--start", "20,100", "--direction-deg", "0"]);
    assert_eq!(told.lines().last(), Some("lost"), "{told}");
    assert!(told.contains("no joint at the start"), "{told}");
}

/// Hand-read points of three photographs (tests/data/images), from the first of them on and with no width given: all of
/// x7; all of x1 with its burn hole, which is crossed from most directions of the start and not from others; x3 to the rim of the
/// picture, on the top-hat (its plates are five times as dark there) and between its rims. The labels have no widths.
#[test]
fn photographs() {
    let folder = root().join("tests/data/images");
    let labels = json_file(folder.join("labels.json"));
    for (name, least, widths) in [("x1.jpg", 7, 7.0..14.0), ("x3.jpg", 9, 25.0..60.0), ("x7.jpg", 6, 6.0..18.0)] {
        let points: Vec<[f64; 3]> = serde_json::from_value(labels["images"][name]["points"].clone()).unwrap();
        let ([y, x, _], [to_y, to_x, _]) = (points[0], points[1]);
        let image = folder.join(name).display().to_string();
        let (start, direction) = (format!("{x},{y}"), (to_y - y).atan2(to_x - x).to_degrees().to_string());
        let found = rows(&good(&["vision", "joint", &image, "--start", &start, "--direction-deg", &direction]));
        assert!(widths.contains(&found[20].width), "{name}: {}", found[20].width);
        assert!(
            found.last().is_some_and(|row| row.y > points[points.len() - 1][0]),
            "{name} is not followed to its rim"
        );
        let mut right = 0;
        for [y, x, u] in &points {
            // Rows are up to a third of the width apart.
            let nearest = found.iter().min_by(|a, b| (a.y - y).abs().total_cmp(&(b.y - y).abs()));
            let Some(row) = nearest.filter(|r| (r.y - y).abs() < 8.0) else { continue };
            let is_right = (row.x - x).abs() <= (2.0 * u).max(1.0);
            assert!(is_right || row.confidence < CONFIDENT, "{name} at {y}: {} for {x}", row.x);
            right += usize::from(is_right);
        }
        assert!(right >= least, "{name}: {right} points are found");
        // Between points the joint is known to some pixels only: it is curved.
        for pair in points.windows(2) {
            let ([y0, x0, u0], [y1, x1, u1]) = (pair[0], pair[1]);
            for row in found.iter().filter(|r| r.confidence >= CONFIDENT && (y0..=y1).contains(&r.y)) {
                let off = row.x - x0 - (x1 - x0) * (row.y - y0) / (y1 - y0);
                assert!(off.abs() <= 4.0 + u0.max(u1), "{name} at {}: {off} from the chord", row.y);
            }
        }
    }
}

/// Wherever the start points within 3 degrees, no hand-read point is on a confident row that is wrong.
#[test]
fn photographs_from_other_directions() {
    let folder = root().join("tests/data/images");
    let labels = json_file(folder.join("labels.json"));
    for name in ["x1.jpg", "x3.jpg", "x7.jpg"] {
        let points: Vec<[f64; 3]> = serde_json::from_value(labels["images"][name]["points"].clone()).unwrap();
        let ([y, x, _], [to_y, to_x, _]) = (points[0], points[1]);
        let image = folder.join(name).display().to_string();
        for off in [-3.0, -1.5, -0.5, 0.5, 1.5, 3.0] {
            let direction = ((to_y - y).atan2(to_x - x).to_degrees() + off).to_string();
            let found = rows(&good(&[
                "vision",
                "joint",
                &image,
                "--start",
                &format!("{x},{y}"),
                "--direction-deg",
                &direction,
            ]));
            for [y, x, u] in &points {
                let near = found.iter().filter(|r| (r.y - y).abs() < 8.0 && r.confidence >= CONFIDENT);
                let nearest = near.min_by(|a, b| (a.y - y).abs().total_cmp(&(b.y - y).abs()));
                let right = nearest.is_none_or(|r| (r.x - x).abs() <= (2.0 * u).max(1.0));
                assert!(right, "{name}, {off} degrees off, at {y}: {nearest:?} for {x}");
            }
        }
    }
}

#[test]
fn bad_input_is_named() {
    let image = painted();
    let place = ["--start", "12,121", "--direction-deg", "0"];
    let of = |image: &str| bad(2, &[&["vision", "joint", image], &place[..]].concat());
    let photograph = std::fs::read(root().join("tests/data/images/x3.jpg")).unwrap();
    for (name, bytes, says) in [
        ("head.jpg", &photograph[..300], "unreadable image"),
        ("half.jpg", &photograph[..photograph.len() / 2], "ends before its picture"),
        ("half.pgm", &std::fs::read(&image).unwrap()[..999], "unreadable image"),
        ("text.png", &b"not an image"[..], "unknown image format"),
        ("empty.png", &b""[..], "unknown image format"),
    ] {
        let told = of(&scratch_file(name, bytes));
        assert!(told.contains(name) && told.contains(says) && told.contains("allowed:"), "{told}");
    }
    let told = of("nowhere.png");
    assert!(told.contains("nowhere.png"), "{told}");
    let told = of(&pgm("one.pgm", 1, 1, |_, _| 90.0));
    assert!(told.contains("1 x 1 pixels") && told.contains("at least 16"), "{told}");
    let told = of(&pgm("white.pgm", 200, 200, |_, _| 255.0));
    assert!(told.contains("saturated"), "{told}");
    for (more, says) in [
        (["--start", "320,10", "--direction-deg", "0"], "x from 0 to 319"),
        (["--start", "-1,10", "--direction-deg", "0"], "outside the image"),
        (["--start", "10", "--direction-deg", "0"], "2 finite numbers"),
        (["--start", "1,2,3", "--direction-deg", "0"], "2 finite numbers"),
        (["--start", "nan,2", "--direction-deg", "0"], "2 finite numbers"),
        (["--start", "a,2", "--direction-deg", "0"], "--start"),
        (["--start", "9,9", "--direction-deg", "inf"], "--direction-deg"),
    ] {
        let told = bad(2, &[&["vision", "joint", &image], &more[..]].concat());
        assert!(told.contains(says), "{more:?}: {told}");
    }
    for more in [["--width-px", "0"], ["--width-px", "-3"], ["--width-px", "nan"], ["--width-px", "401"]] {
        let told = bad(2, &[&["vision", "joint", &image], &place[..], &more[..]].concat());
        assert!(told.contains("--width-px") && told.contains("1 to 400"), "{told}");
    }
    for zone in ["0,0,400,255", "50,0,10,255", "0,0,9", "100,0,300,255"] {
        let told = bad(2, &[&["vision", "joint", &image], &place[..], &["--zone-px", zone]].concat());
        assert!(told.contains("allowed:"), "{told}");
    }
}
