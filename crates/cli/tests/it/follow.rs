//! `seamwright tools follow`: points of any spacing become the same motion, within limits; errors have their line.

use crate::common::{self, column, run, run_with, table};
use std::f64::consts::TAU;
use std::fmt::Write;

/// A saddle on the trunnion table as points of the tip with directions, in `count` steps a turn.
fn saddle(count: u32) -> String {
    let mut out = String::from("x_mm,y_mm,z_mm,ax,ay,az\n");
    for i in 0..=count {
        let phi = TAU * f64::from(i) / f64::from(count);
        let (x, y) = (25.0 * phi.cos(), 25.0 * phi.sin());
        writeln!(out, "{x},{y},{},{},{},-1", (3600.0 - y * y).sqrt(), 0.2 * phi.cos(), 0.2 * phi.sin()).unwrap();
    }
    out
}

fn follow(points: &str, more: &[&str]) -> std::process::Output {
    let arguments = ["tools", "follow", "-", "--machine", "table-tilting-xyzac"];
    run_with(&[&arguments[..], more].concat(), points)
}

#[test]
fn the_same_seam_in_steps_of_any_length_takes_as_long() {
    let mut ends = Vec::new();
    for count in [120, 900, 20_000] {
        let output = follow(&saddle(count), &["--speed-mm-s", "10", "--period-ms", "2"]);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{told}");
        let t = table(&String::from_utf8(output.stdout).unwrap());
        let (time, way, speed) = (column(&t, "t_s"), column(&t, "s_mm"), column(&t, "speed_mm_s"));
        // Constant speed but at the ends, and positions of the axes without jumps.
        let cruises = speed.iter().filter(|v| (**v - 10.0).abs() < 0.02).count();
        assert!(cruises as f64 > 0.93 * speed.len() as f64, "{cruises} of {}", speed.len());
        for (axis, acceleration) in [("x", 1000.0), ("y", 1000.0), ("z", 1000.0), ("a", 300.0), ("c", 600.0)] {
            let q = column(&t, axis);
            let worst = q.windows(3).map(|w| ((w[0] - 2.0 * w[1] + w[2]) / 4e-6).abs()).fold(0.0, f64::max);
            assert!(worst <= acceleration * (1.0 + 1e-3), "{axis}: {worst}");
        }
        ends.push((time[time.len() - 1], way[way.len() - 1]));
    }
    // The seam's length by summing a million chords.
    let chord = |i: u32| {
        let point = |i: u32| {
            let phi = TAU * f64::from(i) / 1e6;
            let y = 25.0 * phi.sin();
            (25.0 * phi.cos(), y, (3600.0 - y * y).sqrt())
        };
        let (a, b) = (point(i), point(i + 1));
        ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2) + (a.2 - b.2).powi(2)).sqrt()
    };
    let length: f64 = (0..1_000_000).map(chord).sum();
    for (time, way) in &ends {
        assert!((way - length).abs() < 2e-3, "{way} {length}");
        assert!((time / ends[2].0 - 1.0).abs() < 1e-3, "{ends:?}");
    }
}

#[test]
fn corners_stop_or_are_blended() {
    let square = "x,y,z,a,c\n0,0,50,0,0\n40,0,50,0,0\n40,40,50,0,0\n0,40,50,0,0\n";
    let run = |more: &[&str]| {
        let output = follow(square, &[&["--speed-mm-s", "20"], more].concat());
        assert_eq!(output.status.code(), Some(0));
        table(&String::from_utf8(output.stdout).unwrap())
    };
    let away = |t: &(Vec<String>, Vec<Vec<f64>>)| {
        let (x, y) = (column(t, "x"), column(t, "y"));
        x.iter().zip(&y).map(|(x, y)| (x - 40.0).hypot(*y)).fold(f64::MAX, f64::min)
    };
    let (stopped, blended) = (run(&[]), run(&["--corner", "blend", "--corner-mm", "0.5"]));
    assert!(away(&stopped) < 1e-3 && away(&blended) > 0.3 && away(&blended) <= 0.5 + 1e-3);
    let slowest = |t: &(Vec<String>, Vec<Vec<f64>>)| {
        let v = column(t, "speed_mm_s");
        v[400..v.len() - 400].iter().copied().fold(f64::MAX, f64::min)
    };
    assert!(slowest(&stopped) < 0.1 && slowest(&blended) > 2.0, "{} {}", slowest(&stopped), slowest(&blended));
}

#[test]
fn what_is_wrong_is_named() {
    let head = "x,y,z,a,c\n0,0,50,0,0\n";
    for (points, more, code, words) in [
        ("1,2\n", vec![], 2, vec!["-:1:", "no column", "x,y,z,a,c or x_mm"]),
        ("x_mm;y_mm;z_mm\n0;0;50\n", vec![], 2, vec!["-:1:", "no column", "separated by commas"]),
        ("x_mm,y_mm,z_mm,ax,ay\n0,0,50,0,0\n", vec![], 2, vec!["-:1:", "no column `az`"]),
        ("x_mm,y_mm,z_mm,ax,ay,az\n0,0,50,0,0,0\n", vec![], 2, vec!["-:2:", "ax,ay,az", "no length"]),
        ("x,y,z,a,c\n0,0,50,0,0\n", vec![], 2, vec!["fewer than two different points"]),
        ("x,y,z,a,c\n0,0,50,0,0\n10,bad,50,0,0\n", vec![], 2, vec!["-:3:", "y = `bad`"]),
        ("x,y,z,a,c\n0,0,50,0,0\n10,0,50,0\n", vec![], 2, vec!["-:3:", "c = ``"]),
        ("x,y,z,a,c\n0,0,50,0,0\n9000,0,50,0,0\n", vec![], 1, vec!["line 3", "axis x", "beyond its limit"]),
        (&format!("{head}10,0,50,0,0\n"), vec!["--speed-mm-s", "0"], 2, vec!["--speed-mm-s 0", "1e-4 to 1e6"]),
        (&format!("{head}10,0,50,0,0\n"), vec!["--window-s", "nan"], 2, vec!["--window-s NaN"]),
        (&format!("{head}10,0,50,0,0\n"), vec!["--period-ms", "0"], 2, vec!["--period-ms 0"]),
    ] {
        let speed: &[&str] = if more.contains(&"--speed-mm-s") { &[] } else { &["--speed-mm-s", "5"] };
        let output = follow(points, &[speed, &more[..]].concat());
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{points}: {told}");
        assert!(words.iter().all(|w| told.contains(w)), "{points}: {told}");
    }
    // The torch into the table: the motion ends before.
    let output = follow("x_mm,y_mm,z_mm\n0,0,200\n0,0,-150\n", &["--speed-mm-s", "20"]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && told.contains("comes too near to"), "{told}");
    let output = run(&["tools", "follow", "nowhere.csv", "--machine", "ellipse-xy", "--speed-mm-s", "5"]);
    assert!(output.status.code() == Some(2) && output.stdout.is_empty());
    // Impossible speed: reported, and within the limits (250 mm/s).
    let output = follow(&format!("{head}300,0,50,0,0\n"), &["--speed-mm-s", "1e6"]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("1000000 mm/s asked for are never reached"));
    let speed = column(&table(&String::from_utf8(output.stdout).unwrap()), "speed_mm_s");
    let fastest = speed.iter().copied().fold(0.0, f64::max);
    assert!(fastest <= 250.0 && fastest > 249.0, "{fastest}");
    // Set-points farther apart than the whole motion lasts: its two ends.
    let output = follow(&format!("{head}10,0,50,0,0\n"), &["--speed-mm-s", "5", "--period-ms", "1e6"]);
    let x = column(&table(&String::from_utf8(output.stdout).unwrap()), "x");
    assert_eq!(x, [0.0, 10.0]);
}

#[test]
fn points_as_seam_writes_them_keep_the_torch_on_the_bisector() {
    let seam = common::good(&["tools", "seam", &common::example("trunnion-saddle"), "--every-mm", "1"]);
    let output = follow(&seam, &["--speed-mm-s", "8", "--period-ms", "20"]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let t = table(&String::from_utf8(output.stdout).unwrap());
    let tilt = column(&t, "a").into_iter().fold(0.0f64, |m, a| m.max(a.abs()));
    assert!(tilt > 20.0, "{tilt}");
}
