//! `seamwright vision stripe`: simulated images and profiles whose joint is known, and the errors of others.

use crate::common::{bad, column, good, json, picture, root, run, run_with, scratch_file, table};
use seamwright_machine::{Machine, Sight, shipped};
use seamwright_simulation::camera_simulator::stripe::{Placement, Section, StripeDisturbances, StripeScene};
use seamwright_vision::Image;
use serde_json::Value;

const V: Section = Section::V { bevels: [0.5, 0.45], depth: 6.0, gap: 1.0, mismatch: 0.3 };

fn placement() -> Placement {
    Placement { at: glam::DVec2::new(1.5, -1.0), turn: 0.05, mirrored: false }
}

fn pgm(name: &str, image: &Image) -> String {
    let Image::U8 { width, height, pixels } = image else { panic!("8 bits") };
    let mut bytes = format!("P5\n{width} {height}\n255\n").into_bytes();
    bytes.extend(pixels);
    scratch_file(name, &bytes)
}

fn scene() -> StripeScene {
    StripeScene::new(V, placement(), [1024, 512], 0.05)
}

#[test]
fn a_v_groove_in_pixels_and_in_mm() {
    let scene = scene();
    let image = scene.image(&StripeDisturbances::USUAL, 1);
    let truth = image.truth.joint().unwrap();
    let path = pgm("v.pgm", &image.image);
    let text = good(&["vision", "stripe", &path, "--joint", "v", "--mm-per-px", "0.05"]);
    let t = table(&text);
    assert!(text.starts_with("feature,x_px,y_px,confidence,value,unit,y_mm,z_mm\njoint,"), "{text}");
    let (y, z) = (column(&t, "y_mm")[0], column(&t, "z_mm")[0]);
    assert!((y - truth.x).hypot(z - truth.y) < 0.1, "{y} {z} {truth}");
    let px = scene.to_mm.inverse().map(truth).unwrap();
    assert!((column(&t, "x_px")[0] - px.x).hypot(column(&t, "y_px")[0] - px.y) < 2.0);
    let gap = text.lines().find(|l| l.starts_with("gap,")).unwrap();
    let cells: Vec<&str> = gap.split(',').collect();
    assert!((cells[4].parse::<f64>().unwrap() - 1.0).abs() < 0.1 && cells[5] == "mm", "{gap}");
    // In pixels it is the same point, and lengths are in pixels.
    let in_px = good(&["vision", "stripe", &path, "--joint", "v", "--json"]);
    let v: Value = serde_json::from_str(&in_px).unwrap();
    assert!((v["points"]["joint"]["x_px"].as_f64().unwrap() - px.x).abs() < 2.0, "{in_px}");
    assert!((v["values"]["gap_px"].as_f64().unwrap() - 20.0).abs() < 2.0, "{in_px}");
    assert!((v["values"]["mismatch_px"].as_f64().unwrap() - 6.0).abs() < 0.5, "{in_px}");
    assert!(v["points"]["joint"].get("y_mm").is_none() && v["confident"] == true);
}

/// Through the camera of a sensor in a machine file, with its perspective.
#[test]
fn a_fillet_through_the_sensor_of_a_machine() {
    let machine = Machine::read("m", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let sensor = machine.sensor("left").unwrap();
    let Sight::Stripe(stripe) = &sensor.sight else { panic!("no stripe sensor") };
    let section = Section::Fillet { angle: 1.5, gap: 0.8 };
    let flat = Placement { at: glam::DVec2::new(1.0, -6.0), ..placement() };
    let scene = StripeScene { to_mm: stripe.to_mm, ..StripeScene::new(section, flat, sensor.size_px, 0.03) };
    let path = pgm("fillet.pgm", &scene.image(&StripeDisturbances::USUAL, 2).image);
    let arguments =
        ["stripe", &path, "--joint", "fillet", "--machine", "dual-laser-10axis", "--sensor", "left", "--json"];
    let v = json(&arguments);
    let joint = &v["points"]["joint"];
    assert!(
        (joint["y_mm"].as_f64().unwrap() - 1.0).abs() < 0.05 && (joint["z_mm"].as_f64().unwrap() + 6.0).abs() < 0.05
    );
    assert!((v["values"]["angle_deg"].as_f64().unwrap() - 1.5f64.to_degrees()).abs() < 0.3, "{v}");
    assert!((v["values"]["gap_mm"].as_f64().unwrap() - 0.8).abs() < 0.1, "{v}");
    let small = pgm("small.pgm", &self::scene().image(&StripeDisturbances::CLEAN, 1).image);
    let told =
        bad(2, &["vision", "stripe", &small, "--joint", "v", "--machine", "dual-laser-10axis", "--sensor", "left"]);
    assert!(told.contains("1024 x 512") && told.contains("1280 x 1024"), "{told}");
    let told =
        bad(2, &["vision", "stripe", &path, "--joint", "v", "--machine", "dual-laser-10axis", "--sensor", "lift"]);
    assert!(told.contains("left, right"), "{told}");
    let told = bad(2, &["vision", "stripe", &path, "--joint", "v", "--machine", "torch-5axis", "--sensor", "left"]);
    assert!(told.contains("none"), "{told}");
}

#[test]
fn a_profile_with_holes() {
    let mut csv = "z_mm,y_mm,note\n".to_owned();
    for (i, p) in scene().profile(0.02, 0.02, 0.1, 3).iter().enumerate() {
        match i % 2 {
            0 => csv += &format!("{},{},x\n", p.y, p.x),
            _ if p.x.is_nan() => csv += ",,\n",
            _ => csv += &format!("{},{},\n", p.y, p.x),
        }
    }
    let output = run_with(&["vision", "stripe", "-", "--joint", "v"], &csv);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let t = table(&text);
    assert!(text.starts_with("feature,y_mm,z_mm,confidence,value,unit\njoint,"), "{text}");
    let truth = V.truth(&placement()).joint().unwrap();
    assert!((column(&t, "y_mm")[0] - truth.x).hypot(column(&t, "z_mm")[0] - truth.y) < 0.3, "{text}");
}

#[test]
fn the_overlay_is_a_picture_of_the_same_size() {
    let path = pgm("overlay.pgm", &scene().image(&StripeDisturbances::USUAL, 4).image);
    let png = scratch_file("overlay.png", b"");
    good(&["vision", "stripe", &path, "--joint", "v", "--overlay", &png]);
    let (size, pixels) = picture(&png);
    assert_eq!(size, (1024, 512));
    let coloured = pixels.iter().filter(|p| p[0].abs_diff(p[2]) > 100).count();
    assert!(coloured > 1000, "{coloured}");
}

#[test]
fn no_such_joint_ends_with_1_and_says_why() {
    let path = pgm(
        "plate.pgm",
        &StripeScene { section: Section::Plate, ..scene() }.image(&StripeDisturbances::USUAL, 5).image,
    );
    for (joint, why) in
        [("fillet", "no corner"), ("v", "no groove"), ("lap", "no step"), ("butt", "no gap"), ("u", "no groove")]
    {
        let told = bad(1, &["vision", "stripe", &path, "--joint", joint]);
        assert!(told.contains(why), "{joint}: {told}");
    }
    let dark = pgm("dark.pgm", &Image::U8 { width: 300, height: 200, pixels: vec![7; 60000] });
    assert!(bad(1, &["vision", "stripe", &dark, "--joint", "v"]).contains("no stripe"));
    let white = pgm("white.pgm", &Image::U8 { width: 300, height: 200, pixels: vec![255; 60000] });
    assert!(bad(1, &["vision", "stripe", &white, "--joint", "v"]).contains("saturated"));
    let output = run(&["vision", "stripe", &white, "--joint", "v", "--json"]);
    let v: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(v["found"] == false && v["reason"].as_str().unwrap().contains("saturated"));
    let one = scratch_file("one.csv", b"y_mm,z_mm\n1,2\n");
    assert!(bad(1, &["vision", "stripe", &one, "--joint", "v"]).contains("1 usable points"));
    let same = format!("y_mm,z_mm\n{}", "1,2\n".repeat(100));
    assert!(
        bad(1, &["vision", "stripe", &scratch_file("same.csv", same.as_bytes()), "--joint", "v"]).contains("points")
    );
}

fn upside_down(image: &Image) -> Image {
    let Image::U8 { width, height, pixels } = image else { panic!("8 bits") };
    let pixels = pixels.chunks(*width).rev().flatten().copied().collect();
    Image::U8 { width: *width, height: *height, pixels }
}

#[test]
fn an_image_upside_down_gets_a_hint() {
    let upright = scene().image(&StripeDisturbances::USUAL, 1).image;
    let path = pgm("upside-down.pgm", &upside_down(&upright));
    for scale in [&["--mm-per-px", "0.05"][..], &[]] {
        let told = bad(1, &[&["vision", "stripe", &path, "--joint", "v"], scale].concat());
        assert!(told.contains("hint: upside down the joint is there"), "{told}");
    }
    let mut csv = "y_mm,z_mm\n".to_owned();
    scene().profile(0.02, 0.0, 0.0, 3).iter().for_each(|p| csv += &format!("{},{}\n", p.x, -p.y));
    assert!(
        bad(1, &["vision", "stripe", &scratch_file("turned.csv", csv.as_bytes()), "--joint", "v"])
            .contains("hint: upside down")
    );
    // An image without a joint in either orientation gets no hint.
    let dark = pgm("dark.pgm", &Image::U8 { width: 300, height: 200, pixels: vec![7; 60000] });
    assert!(!bad(1, &["vision", "stripe", &dark, "--joint", "v"]).contains("hint"));
}

#[test]
fn a_joint_that_may_not_be_followed_ends_with_1_and_says_why() {
    // The right wall goes out of sight for more columns than noise makes: the groove is found, but not all of it.
    let mut image = scene().image(&StripeDisturbances::CLEAN, 1).image;
    let truth = scene().image(&StripeDisturbances::CLEAN, 1).truth.joint().unwrap();
    let px = scene().to_mm.inverse().map(truth).unwrap();
    let Image::U8 { width, pixels, .. } = &mut image else { panic!("8 bits") };
    let (from, to) = (px.x as usize + 60, px.x as usize + 80);
    for row in pixels.chunks_mut(*width) {
        row[from..to].fill(0);
    }
    let path = pgm("hole.pgm", &image);
    let output = run(&["vision", "stripe", &path, "--joint", "v"]);
    let (out, err) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
    assert_eq!(output.status.code(), Some(1), "{out}{err}");
    assert!(out.contains("\njoint,"), "{out}");
    assert!(err.contains("is below 0.5") && err.contains("dark places"), "{err}");
    let json: Value =
        serde_json::from_slice(&run(&["vision", "stripe", &path, "--joint", "v", "--json"]).stdout).unwrap();
    assert!(json["confident"] == false && json["doubt"].as_str().unwrap().contains("dark places"), "{json}");
}

#[test]
fn bad_input_is_named() {
    let path = pgm("good.pgm", &scene().image(&StripeDisturbances::USUAL, 6).image);
    let told = bad(2, &["vision", "stripe", &path, "--joint", "w"]);
    assert!(told.contains("fillet, v, lap, butt, u, j"), "{told}");
    let bytes = std::fs::read(&path).unwrap();
    let cut = scratch_file("cut.pgm", &bytes[..bytes.len() / 2]);
    assert!(bad(2, &["vision", "stripe", &cut, "--joint", "v"]).contains("cut.pgm: unreadable image"));
    let absurd = scratch_file("absurd.pgm", b"P5\n99999999 99999999\n255\n0");
    assert!(bad(2, &["vision", "stripe", &absurd, "--joint", "v"]).contains("absurd.pgm"));
    assert!(
        bad(2, &["vision", "stripe", &scratch_file("bytes.bin", &[0xff, 0xfe, 0, 1]), "--joint", "v"])
            .contains("neither an image")
    );
    assert!(
        bad(2, &["vision", "stripe", &scratch_file("wrong.csv", b"x_mm,z_mm\n1,2\n"), "--joint", "v"]).contains("y_mm")
    );
    let told = bad(2, &["vision", "stripe", &scratch_file("text.csv", b"y_mm,z_mm\n1,2\n1,two\n"), "--joint", "v"]);
    assert!(told.contains("text.csv:3: z_mm = `two`"), "{told}");
    assert!(
        bad(2, &["vision", "stripe", &scratch_file("far.csv", b"y_mm,z_mm\n1,1e300\n"), "--joint", "v"])
            .contains("far.csv:2")
    );
    assert!(bad(2, &["vision", "stripe", "nowhere.png", "--joint", "v"]).contains("nowhere.png: cannot be read"));
    assert!(bad(2, &["vision", "stripe", &root().display().to_string(), "--joint", "v"]).contains("cannot be read"));
    for scale in ["0", "-1", "nan", "inf"] {
        assert!(bad(2, &["vision", "stripe", &path, "--joint", "v", "--mm-per-px", scale]).contains("--mm-per-px"));
    }
    let told = bad(2, &["vision", "stripe", &path, "--joint", "lap", "--thickness-mm", "0"]);
    assert!(told.contains("--thickness-mm"), "{told}");
    let csv = scratch_file("profile.csv", b"y_mm,z_mm\n1,2\n");
    assert!(bad(2, &["vision", "stripe", &csv, "--joint", "v", "--mm-per-px", "0.05"]).contains("a profile is in mm"));
    let told = bad(2, &["vision", "stripe", &path, "--joint", "v", "--overlay", "/nowhere/at/all.png"]);
    assert!(told.contains("cannot be written"), "{told}");
}
