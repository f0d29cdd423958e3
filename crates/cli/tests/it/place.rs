//! `machine place`: the offset found is that of the points; bad tables are refused with their address.

use crate::common::{self, bad, example, good, has_all, root, run, run_with};
use std::f64::consts::TAU;
use std::fs;

const SHIFT: [f64; 3] = [12.0, -7.0, 3.0];

/// Points on the example saddle's nozzle and body, in the work frame, with the part moved by `SHIFT`.
fn saddle_points(outside: f64) -> String {
    let mut csv = "x_mm,y_mm,z_mm,feature\n".to_owned();
    for i in 0..10 {
        let (sin, cos) = (f64::from(i) * TAU / 10.0 + 0.1).sin_cos();
        let height = 40.0 + 3.0 * f64::from(i % 3);
        let r = 250.0 + outside;
        let mut row = |p: [f64; 3], feature: &str| {
            csv += &format!("{},{},{},{feature}\n", p[0] + SHIFT[0], p[1] + SHIFT[1], p[2] + SHIFT[2]);
        };
        row([r * cos, r * sin, height], "nozzle");
        // Around the shell's axis by an angle, 800 mm below.
        let turn = 330.0 * sin / 800.0;
        let r = 800.0 + outside;
        row([330.0 * cos, r * turn.sin(), r * turn.cos() - 800.0], "body");
    }
    csv
}

fn place(extra: &[&str], csv: &str) -> (i32, String, String) {
    let saddle = example("saddle");
    let output = run_with(&[&["machine", "place", &saddle, "--points", "-"], extra].concat(), csv);
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn json(extra: &[&str], csv: &str) -> serde_json::Value {
    let (code, out, errors) = place(&[extra, &["--json"]].concat(), csv);
    assert_eq!(code, 0, "{errors}{out}");
    serde_json::from_str(&out).unwrap()
}

fn moved(found: &serde_json::Value) -> [f64; 3] {
    std::array::from_fn(|i| found["offset"]["move_mm"][i].as_f64().unwrap())
}

fn near(found: [f64; 3], expected: [f64; 3]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-6), "{found:?} {expected:?}");
}

#[test]
fn best_fit_finds_the_shift_with_and_without_a_ball() {
    for (outside, radius) in [(0.0, "0"), (2.5, "2.5")] {
        let found = json(&["--probe-radius-mm", radius], &saddle_points(outside));
        near(moved(&found), SHIFT);
        assert!(found["offset"]["turn"].is_null() || found["offset"]["angle_deg"].as_f64().unwrap() < 1e-6);
        assert!(found["free"].as_array().unwrap().is_empty() && found["accepted"] == true);
        assert!(found["largest_mm"].as_f64().unwrap() < 1e-6);
    }
}

#[test]
fn the_example_s_points_tell_the_displacement_they_were_made_with() {
    let points = root().join("examples/saddle-touched.csv").display().to_string();
    let text = good(&["machine", "place", &example("saddle"), "--points", &points, "--json"]);
    let found: serde_json::Value = serde_json::from_str(&text).unwrap();
    for (found, expected) in moved(&found).into_iter().zip([1.5, -0.8, 0.6]) {
        assert!((found - expected).abs() < 0.05, "{found} {expected}");
    }
    let angle = found["offset"]["angle_deg"].as_f64().unwrap();
    assert!((angle - 0.4).abs() < 0.02, "{angle}");
    let rms = found["rms_mm"].as_f64().unwrap();
    assert!((0.01..0.03).contains(&rms), "{rms}");
}

#[test]
fn a_nozzle_alone_leaves_two_motions_to_the_job() {
    let csv: String = saddle_points(0.0).lines().filter(|l| !l.ends_with("body")).map(|l| format!("{l}\n")).collect();
    let found = json(&[], &csv);
    near(moved(&found), [SHIFT[0], SHIFT[1], 0.0]);
    let free = found["free"].as_array().unwrap();
    assert!(free.len() == 2 && free[0] == "moving along (0, 0, 1)", "{free:?}");
    assert!(free[1].as_str().unwrap().starts_with("turning about the axis along (0, 0, 1)"));
}

#[test]
fn three_points_three_faces_and_a_chuck() {
    let three = "nx_mm,ny_mm,nz_mm,x_mm,y_mm,z_mm\n0,0,0,5,6,7\n100,0,0,5,106,7\n0,100,0,-95,6,7\n";
    let found = json(&["--method", "three-point"], three);
    near(moved(&found), [5.0, 6.0, 7.0]);
    assert!((found["offset"]["angle_deg"].as_f64().unwrap() - 90.0).abs() < 1e-6);
    assert!(found["side_errors_mm"].as_array().unwrap().iter().all(|s| s.as_f64().unwrap().abs() < 1e-9));
    let faces =
        "feature,x_mm,y_mm,z_mm\npoint,3,50,6\nplane,10,10,8\nplane,90,10,8\nline,10,9,6\nplane,50,80,8\nline,90,9,6\n";
    let found = json(&["--method", "plane-line-point", "--probe-radius-mm", "1"], faces);
    near(moved(&found), [4.0, 10.0, 7.0]);
    // This method needs no surface: a polyline has none.
    let polyline = example("weave");
    let output = run_with(&["machine", "place", &polyline, "--points", "-", "--method", "three-point"], three);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    // A tube 0.3 mm off, leaning by a thousandth, 0.1 mm too large; the saddle's middle is at z = -19.8 mm or so.
    let mut chuck = "x_mm,y_mm,z_mm\n".to_owned();
    for i in 0..8 {
        let (sin, cos) = (f64::from(i) * TAU / 8.0).sin_cos();
        let z = if i % 2 == 0 { 20.0 } else { 90.0 };
        // Across the nominal axis the leaning tube is an ellipse, wider along x.
        let r = 250.1;
        let lean = 1e-3f64;
        let x = 0.3 + lean * z + r * cos * (1.0 + lean * lean).sqrt();
        chuck += &format!("{x},{},{z}\n", r * sin);
    }
    let found = json(&["--method", "chuck"], &chuck);
    let out = &found["run_out"];
    let at = out["at_mm"][2].as_f64().unwrap();
    assert!((out["eccentricity_mm"].as_f64().unwrap() - (0.3 + 1e-3 * at)).abs() < 1e-6, "{out}");
    assert!((out["tilt_deg"].as_f64().unwrap() - 1e-3f64.atan().to_degrees()).abs() < 1e-7);
    assert!((out["radius_error_mm"].as_f64().unwrap() - 0.1).abs() < 1e-6);
    assert!(found["warnings"].as_array().unwrap().is_empty(), "{found}");
}

#[test]
fn axis_positions_are_as_good_as_points() {
    let kinematics = ["machine", "kinematics", "saddle-4axis", "--forward"];
    let axes =
        "theta,s,h,beta\n0,-100,50,0\n60,-90,60,5\n120,-100,40,0\n180,-110,50,-5\n250,-100,70,0\n300,-100,50,3\n";
    let points = String::from_utf8(run_with(&kinematics, axes).stdout).unwrap();
    let by_axes = json(&["--method", "chuck", "--largest-mm", "500"], axes);
    let by_points = json(&["--method", "chuck", "--largest-mm", "500"], &points);
    assert_eq!(by_axes["residuals"], by_points["residuals"]);
    assert_eq!(by_axes["offset"], by_points["offset"]);
}

#[test]
fn the_job_written_again_keeps_its_words_and_stands_where_it_was_touched() {
    let folder = tempfile::tempdir().unwrap();
    let new = folder.path().join("placed.toml").display().to_string();
    let (code, out, errors) = place(&["--name", "table-1", "-o", &new], &saddle_points(0.0));
    assert!(code == 0 && out.contains("wrote"), "{errors}");
    let (before, after) = (fs::read_to_string(example("saddle")).unwrap(), fs::read_to_string(&new).unwrap());
    let kept: Vec<&str> = after.lines().filter(|l| before.lines().any(|b| b == *l)).collect();
    assert!(before.lines().all(|l| kept.contains(&l)), "{after}");
    assert!(after.contains("offset = \"table-1\"") && after.contains("[offsets.table-1]"), "{after}");
    // The seam stands shifted in the machine: its set-points through forward kinematics, away from those of the old
    // job.
    let tip = |job: &str| -> Vec<f64> {
        let motion = good(&["tools", "motion", job, "--period-ms", "1000"]);
        let table = common::table(&motion);
        let columns = ["theta", "s", "h", "beta"].map(|n| common::column(&table, n)[0]);
        let row = format!("theta,s,h,beta\n{},{},{},{}\n", columns[0], columns[1], columns[2], columns[3]);
        let out = run_with(&["machine", "kinematics", "saddle-4axis", "--forward"], &row).stdout;
        common::table(&String::from_utf8(out).unwrap()).1[0][..3].to_vec()
    };
    let (old, shifted) = (tip(&example("saddle")), tip(&new));
    for i in 0..3 {
        assert!((shifted[i] - old[i] - SHIFT[i]).abs() < 1e-4, "{old:?} {shifted:?}");
    }
    // Placed again: the offset in force is where the search starts, and it is replaced, not added.
    let output =
        run_with(&["machine", "place", &new, "--points", "-", "--name", "table-1", "-o", &new], &saddle_points(0.0));
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(fs::read_to_string(&new).unwrap().matches("[offsets.").count(), 1);
    // A job whose offset is misspelt gives an error.
    fs::write(&new, after.replace("offset = \"table-1\"", "offset = \"tabel-1\"")).unwrap();
    let text = bad(2, &["check", &new]);
    assert!(text.contains("did you mean `table-1`?"), "{text}");
}

#[test]
fn bad_points_are_told_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let new = folder.path().join("placed.toml");
    let mut csv = saddle_points(0.0);
    csv += &format!("{},0,50,nozzle\n", 250.0 + SHIFT[0] + 30.0);
    let (code, out, _) = place(&["-o", &new.display().to_string()], &csv);
    assert!(code == 1 && !new.exists(), "{out}");
    assert!(out.contains("not accepted") && out.contains("--largest-mm") && out.contains("outlier"), "{out}");
    assert!(!out.contains("[offsets."));
    // Two points of three too far apart: the sides count, though two of the residuals are 0.
    let three = "nx_mm,ny_mm,nz_mm,x_mm,y_mm,z_mm\n0,0,0,0,0,0\n100,0,0,103,0,0\n0,100,0,0,100,0\n";
    let (code, out, _) = place(&["--method", "three-point"], three);
    assert!(code == 1 && out.contains("1-2 +3.0000 mm"), "{out}");
}

#[test]
fn bad_input_is_refused_with_its_place() {
    let three = "nx_mm,ny_mm,nz_mm,x_mm,y_mm,z_mm\n";
    for (extra, csv, words) in [
        (vec![], String::new(), vec!["standard input:1", "no column `x_mm`", "theta,s,h,beta"]),
        (vec![], "x_mm;y_mm;z_mm\n1;2;3\n".to_owned(), vec!["standard input:1", "no column `x_mm`"]),
        (vec![], "x_mm,y_mm,z_mm\n1,2,3\n".to_owned(), vec!["no column `feature`", "nozzle, body"]),
        (vec![], "x_mm,y_mm,z_mm,feature\n1,2,nan,body\n".to_owned(), vec!["standard input:2: z_mm = `nan`", "finite"]),
        (vec![], "x_mm,y_mm,z_mm,feature\n1,2,3,body\n\n1,1e9,3,body\n".to_owned(), vec!["input:4: y_mm = `1e9`"]),
        (vec![], "x_mm,y_mm,z_mm,feature\n1,2\n".to_owned(), vec!["standard input:2: z_mm = ``"]),
        (
            vec![],
            "x_mm,y_mm,z_mm,feature\n1,2,3,shell\n".to_owned(),
            vec!["input:2: feature = `shell`", "nozzle, body"],
        ),
        (vec![], "x_mm,y_mm,z_mm,feature\n".to_owned(), vec!["too few", "0 given, at least 1"]),
        (
            vec!["--method", "three-point"],
            three.to_owned() + "0,0,0,1,1,1\n",
            vec!["too few points of the frame: 1 given, at least 3"],
        ),
        (
            vec!["--method", "three-point"],
            three.to_owned() + "0,0,0,0,0,0\n1,0,0,1,0,0\n2,0,0,2,0,0\n",
            vec!["nominal frame", "on one line"],
        ),
        (vec!["--method", "three-point"], "x_mm,y_mm,z_mm\n".to_owned(), vec!["no column `nx_mm`"]),
        (
            vec!["--method", "plane-line-point"],
            "x_mm,y_mm,z_mm,feature\n0,0,0,plane\n".to_owned(),
            vec!["points of the plane: 1 given, at least 3"],
        ),
        (vec!["--method", "chuck"], "x_mm,y_mm,z_mm\n0,1,2\n".to_owned(), vec!["points of the tube: 1 given,"]),
        (vec!["--method", "three-point", "--probe-radius-mm", "1"], String::new(), vec!["--probe-radius-mm 1"]),
        (vec!["--probe-radius-mm", "-1"], String::new(), vec!["--probe-radius-mm -1", "0 to 1000"]),
        (vec!["--largest-mm", "0"], String::new(), vec!["--largest-mm 0", "greater than 0"]),
        (vec!["--name", "my table"], String::new(), vec!["--name my table", "letters, digits"]),
    ] {
        let (code, out, text) = place(&extra, &csv);
        assert!(code == 2 && out.is_empty(), "{extra:?} {csv}: {out}{text}");
        assert!(text.contains("allowed: "), "{text}");
        has_all(&text, &words);
    }
    let output = run_with(
        &["machine", "place", &example("ellipse"), "--points", "-", "--method", "chuck"],
        "x_mm,y_mm,z_mm\n0,1,2\n",
    );
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && text.contains("no nozzle") && text.contains("allowed: "), "{text}");
    assert_eq!(run(&["machine", "place", &example("saddle"), "--points", "none.csv"]).status.code(), Some(2));
    let nowhere = ["-o", "/nonexistent/placed.toml"];
    assert_eq!(place(&nowhere, &saddle_points(0.0)).0, 2);
}
