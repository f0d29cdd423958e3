//! Taught spans and free seams through the command line: points, recorded axis positions and tables; the program file
//! stands alone; bad input with its address.

use crate::common::{column, example, good, run, table, write};
use std::fs;
use std::path::Path;

/// Runs a verb in a folder with these files; exit code and errors.
fn with(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let output = run(arguments);
    let text = String::from_utf8(output.stderr).unwrap();
    println!("{}: {text}", folder.display());
    (output.status.code().unwrap(), text)
}

#[test]
fn the_taught_saddle_plans_without_a_stop() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let (code, text) = with(folder.path(), &["plan", &example("taught-saddle"), "-o", &out, "--plots"]);
    assert_eq!(code, 0, "{text}");
    let report = fs::read_to_string(folder.path().join("out/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let kinds: Vec<&str> = report["findings"].as_array().unwrap().iter().filter_map(|f| f["kind"].as_str()).collect();
    assert!(!kinds.contains(&"stop") && !kinds.contains(&"blend") && !kinds.contains(&"speed"), "{kinds:?}");
    assert!((report["plan"]["least_speed_mm_s"].as_f64().unwrap() - 10.0).abs() < 1e-6);
    let svg = fs::read_to_string(folder.path().join("out/plots/taught-1.svg")).unwrap();
    assert!(svg.contains("Distance from the nominal seam") && svg.contains("taught points"));
    assert!(fs::read_to_string(folder.path().join("out/report.html")).unwrap().contains("Taught spans"));
}

/// The torch over the taught points, recorded as axis positions and given back, welds the same seam.
#[test]
fn recorded_positions_are_the_points() {
    let text = fs::read_to_string(example("taught-saddle")).unwrap();
    let job_seam = table(&good(&["tools", "seam", &example("taught-saddle"), "--every-mm", "1"]));
    let motion = table(&good(&["tools", "motion", &example("taught-saddle"), "--period-ms", "20"]));
    let (s, axes) = (column(&motion, "s_mm"), ["theta", "s", "h", "beta"].map(|a| column(&motion, a)));
    let rows: Vec<String> = [350.0, 390.0, 430.0, 470.0]
        .map(|place: f64| {
            let i = s.iter().position(|s| *s >= place).unwrap();
            format!("[{:?}, {:?}, {:?}, {:?}]", axes[0][i], axes[1][i], axes[2][i], axes[3][i])
        })
        .into();
    let (head, tail) = (text.split("points_mm").next().unwrap(), text.split("[sequence]").nth(1).unwrap());
    let recorded = format!("{head}axes = [{}]\n[sequence]{tail}", rows.join(", "));
    let folder = tempfile::tempdir().unwrap();
    let job = write(folder.path(), "job.toml", &recorded);
    let seam = table(&good(&["tools", "seam", &job, "--every-mm", "1"]));
    // Other points of the same curve: nearly the same spline.
    let near = ["x_mm", "y_mm", "z_mm"].map(|name| {
        let pairs = column(&seam, name);
        pairs.iter().zip(column(&job_seam, name)).take(1500).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    });
    assert!(near.iter().all(|n| *n < 0.3), "{near:?}");
    let out = folder.path().join("out").display().to_string();
    assert_eq!(with(folder.path(), &["plan", &job, "-o", &out]).0, 0);
    let program = fs::read_to_string(folder.path().join("out/program.toml")).unwrap();
    assert!(program.contains("points_mm") && !program.contains("axes = ["));
    let (code, text) = with(folder.path(), &["plan", &write(folder.path(), "p.toml", &program), "-o", &out, "--plots"]);
    assert_eq!(code, 0, "{text}");

    let refused = |from: &str, to: &str, words: &[&str]| {
        let bad = recorded.replacen(from, to, 1);
        assert_ne!(bad, recorded);
        let (code, text) = with(folder.path(), &["check", &write(folder.path(), "bad.toml", &bad)]);
        assert!(code == 2 && text.contains("allowed: ") && words.iter().all(|w| text.contains(w)), "{text}");
    };
    refused("axes = [[", "axes = [[7, ", &["taught[0].axes[0]", "5 positions", "theta, s, h, beta"]);
    refused("axes = [[", "axes = [[900, 0, 0, 0], [", &["taught[0].axes[0]", "theta"]);
    refused("to_mm = 520", "to_mm = 400", &["taught[0].axes[2]", "between the joins"]);
    refused("\"saddle-4axis\"", "\"no-machine\"", &["no-machine"]);
}

const TABLE: &str = "x_mm,y_mm,z_mm,n1x,n1y,n1z\n-40,0,0,0,0,1\n-15,12,0,0,0,1\n10,8,0,0,0,2\n40,-6,0,0,0,1\n";

#[test]
fn tables_weld_and_programs_hold_their_points() {
    let folder = tempfile::tempdir().unwrap();
    let job = "schema = 1\ntitle = \"t\"\nmachine = \"ellipse-xy\"\n[seam.spline]\nfile = \"joint.csv\"\njoint = \"butt\"\n\
               [weld]\nspeed_mm_s = 5\n";
    let path = write(folder.path(), "job.toml", job);
    write(folder.path(), "joint.csv", TABLE);
    let out = folder.path().join("out").display().to_string();
    let (code, text) = with(folder.path(), &["plan", &path, "-o", &out, "--plots"]);
    assert_eq!(code, 0, "{text}");
    let alone = tempfile::tempdir().unwrap();
    let program = fs::read_to_string(folder.path().join("out/program.toml")).unwrap();
    let moved = write(alone.path(), "program.toml", &program);
    assert_eq!(good(&["tools", "seam", &moved]), good(&["tools", "seam", &path]));

    let refused = |csv: &str, words: &[&str]| {
        write(folder.path(), "joint.csv", csv);
        let (code, text) = with(folder.path(), &["plan", &path, "-o", &out]);
        assert!(code == 2 && text.contains("job.toml:5") && text.contains("seam.spline.file"), "{text}");
        assert!(text.contains("allowed: ") && words.iter().all(|w| text.contains(w)), "{text}");
    };
    refused(&TABLE.replace("12", "ten"), &["joint.csv:3", "y_mm = `ten`", "finite number"]);
    refused(&TABLE.replace("z_mm", "height"), &["joint.csv:1", "no column"]);
    refused(&TABLE.replace(",n1z", ",other"), &["joint.csv:1", "n1z"]);
    refused("x_mm,y_mm,z_mm\n1,2,3\n", &["the seam has 1 point"]);
    refused(&TABLE.replace("0,0,2", "0,0,0"), &["point 3", "without length"]);
    refused(&TABLE.replace("10,8,0", "-15,12,0"), &["point 3", "coincides with the one before"]);
    fs::remove_file(folder.path().join("joint.csv")).unwrap();
    let (code, text) = with(folder.path(), &["plan", &path, "-o", &out]);
    assert!(code == 2 && text.contains("cannot be read"), "{text}");
}
