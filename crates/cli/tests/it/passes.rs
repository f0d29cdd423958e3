//! A program of four passes, some of which lie beside the seam, start elsewhere, run back or cover a part: every verb,
//! and the tip by `kinematics` of the rows of `motion`.

use crate::common::{column, good, json, root, run_with, table};
use std::fs;

/// Asked speed by pass (from 1) and path length.
fn asked(pass: usize, s: f64) -> f64 {
    match pass {
        1 => 8.0,
        2 if s < 100.0 => 8.0 - 0.02 * s,
        2 if s < 200.0 => 6.0,
        2 => 6.0 + 2.0 * (s - 200.0) / 190.0,
        _ => 7.0,
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn four_passes_go_through_every_verb() {
    let program = root().join("tests/data/passes.toml").display().to_string();
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("weld");
    let shown = out.display().to_string();
    let summary = good(&["plan", &program, "-o", &shown]);
    assert!(!summary.contains("unchecked"), "{summary}");
    let report = json(&["simulate", &program, "-o", &shown, "--json"]);
    let passes = report["passes"].as_array().unwrap();
    assert_eq!(passes.len(), 4);
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    for (pass, name) in passes.iter().zip(["root", "fill, body side", "fill, nozzle side", "cap"]) {
        assert!(pass["name"] == name && page.contains(name));
        let simulated = &pass["simulation"];
        assert!(simulated["path_error_mm"]["max"].as_f64().unwrap() < 0.08, "{simulated}");
        assert!(simulated["speed_ripple"].as_f64().unwrap() < 0.08, "{simulated}");
        assert!(pass["clearance"]["nearest_mm"].as_f64().unwrap() > 0.0);
        assert!(pass["certificate"]["at_asked_percent"].as_f64().unwrap() > 98.0, "{}", pass["certificate"]);
    }
    assert_eq!(passes[1]["plan"]["asked_speed_mm_s"], serde_json::json!([6.0, 8.0]));
    assert!((passes[1]["plan"]["least_speed_mm_s"].as_f64().unwrap() / 6.0 - 1.0).abs() < 5e-3);
    let findings = report["findings"].as_array().unwrap();
    assert!(findings.iter().all(|f| f["allowed"] == true), "{findings:#?}");
    let part = good(&["post", &program, "--dialect", "linuxcnc"]);
    assert!(
        part.contains("(fill, nozzle side: travel") && part.matches("the planned way to the next pass").count() == 3
    );
}

#[test]
fn the_tip_runs_along_each_bead_as_asked() {
    let program = root().join("tests/data/passes.toml").display().to_string();
    let csv = good(&["tools", "motion", &program, "--period-ms", "2"]);
    let rows = table(&csv);
    let (pass, s, v, t) =
        (column(&rows, "pass"), column(&rows, "s_mm"), column(&rows, "speed_mm_s"), column(&rows, "t_s"));
    let poses = table(
        &String::from_utf8(run_with(&["machine", "kinematics", "table-tilting-xyzac", "--forward"], &csv).stdout)
            .unwrap(),
    );
    let tip: Vec<[f64; 3]> = poses.1.iter().map(|p| [p[0], p[1], p[2]]).collect();
    // One turn of the root: the seam itself.
    let root: Vec<usize> = (0..tip.len()).filter(|&i| (pass[i] - 1.0).abs() < 0.5).collect();
    let mut ran = [0.0f64; 5];
    let mut steady = [0; 5];
    for i in 0..tip.len() - 1 {
        let p = pass[i] as usize;
        if p == 0 || pass[i + 1] as usize != p {
            continue;
        }
        let way = distance(&tip[i], &tip[i + 1]);
        ran[p] += way;
        let (speed, wanted) = (way / (t[i + 1] - t[i]), asked(p, s[i]).max(asked(p, s[i + 1])));
        assert!(speed <= wanted * (1.0 + 1e-7), "pass {p} at {}: {speed} of {wanted}", s[i]);
        if v[i] > 0.5 * wanted {
            assert!((speed - 0.5 * (v[i] + v[i + 1])).abs() < 1e-3 * speed, "pass {p}: {speed} told {}", v[i]);
        }
        steady[p] += usize::from(speed > 0.997 * asked(p, s[i]).min(asked(p, s[i + 1])));
        // The distance from the seam is that of the rows, to within the seam's bend.
        if i % 50 == 0 {
            let nearest = root.iter().map(|&k| distance(&tip[i], &tip[k])).fold(f64::INFINITY, f64::min);
            let (low, high) = [(0.0, 0.02), (3.1, 4.0), (3.1, 3.3), (3.4, 5.1)][p - 1];
            assert!(nearest >= low && nearest <= high, "pass {p} at {}: {nearest}", s[i]);
        }
    }
    println!("{ran:?} {steady:?}");
    for p in 1..=4 {
        let moving = (0..tip.len()).filter(|&i| pass[i] as usize == p && v[i] > 0.0).count();
        assert!(steady[p] as f64 > 0.97 * moving as f64, "pass {p}: {} of {moving}", steady[p]);
        // The way of the tip is another than the seam's length but for the root.
        let length = (0..tip.len()).filter(|&i| pass[i] as usize == p).map(|i| s[i]).fold(0.0, f64::max);
        assert_eq!((ran[p] / length - 1.0).abs() < 1e-4, p == 1, "pass {p}: {} over {length}", ran[p]);
    }
    // Two fills run opposite ways: where pass 3 is after 20 mm, pass 2 comes by at 300 mm of its own.
    let at = |p: usize, place: f64| {
        let near = |i: &usize| (s[*i] - place).abs();
        (0..tip.len()).filter(|&i| pass[i] as usize == p).min_by(|a, b| near(a).total_cmp(&near(b))).unwrap()
    };
    let seam = good(&["tools", "seam", &program, "--every-mm", "1"]);
    let length = {
        let rows = table(&seam);
        column(&rows, "s_mm").into_iter().fold(0.0, f64::max) - 15.0
    };
    let (two, three) = (at(2, length - 120.0 + 30.0), at(3, 20.0));
    let between = distance(&tip[two], &tip[three]);
    assert!(between > 4.0 && between < 6.5, "{between}");
}
