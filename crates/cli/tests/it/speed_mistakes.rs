//! Invalid speeds, periods and limits: each has a clear error or finding.

use crate::common::{self, example, free_example, json_file, root, run};
use serde_json::Value;
use std::fs;
use tempfile::TempDir;

/// An example in a folder of its own, with its machine file, both changed.
fn changed(name: &str, machine: &str, job: &[(&str, &str)], limits: &[(&str, &str)]) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let swap = |mut text: String, changes: &[(&str, &str)]| {
        for (from, to) in changes {
            assert!(text.contains(from), "{from}");
            text = text.replacen(from, to, 1);
        }
        text
    };
    let text = free_example(name).replace(&format!("\"{machine}\""), "\"mine.toml\"");
    let path = folder.path().join("job.toml");
    fs::write(&path, swap(text, job)).unwrap();
    let text = fs::read_to_string(root().join(format!("machines/{machine}.toml"))).unwrap();
    fs::write(folder.path().join("mine.toml"), swap(text, limits)).unwrap();
    let path = path.display().to_string();
    (folder, path)
}

fn findings_of(kind: &str, job: &str) -> (i32, Vec<Value>) {
    let output = run(&["check", job, "--json"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let of_kind = found.as_array().unwrap().iter().filter(|f| f["kind"] == kind).cloned().collect();
    (output.status.code().unwrap(), of_kind)
}

fn findings(job: &str) -> (i32, Vec<Value>) {
    findings_of("speed", job)
}

#[test]
fn periods() {
    let job = example("ellipse");
    for (period, word) in [
        ("0", "greater than 0"),
        ("-1", "greater than 0"),
        ("nan", "greater than 0"),
        ("inf", "greater than 0"),
        ("1e6", "pass 1"),
        ("1e300", "pass 1"),
    ] {
        let output = run(&["tools", "motion", &job, "--period-ms", period]);
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{period}: {text}");
        assert!(output.stdout.is_empty());
        assert!(text.contains("period") && text.contains("allowed: ") && text.contains(word), "{text}");
    }
}

#[test]
fn speeds_beyond_any_possibility() {
    for (name, machine, asked) in [
        ("saddle", "saddle-4axis", "speed_mm_s = 10"),
        ("ellipse", "ellipse-xy", "speed_mm_s = 5"),
        ("trunnion-saddle", "table-tilting-xyzac", "speed_mm_s = 8"),
    ] {
        let (_folder, job) = changed(name, machine, &[(asked, "speed_mm_s = 1e5")], &[]);
        let (code, found) = findings(&job);
        assert_eq!(code, 1);
        assert!(!found.is_empty() && found.iter().all(|f| f["allowed"] == false), "{found:?}");
        let slow = "speed_mm_s = 1e5\non_limit = \"slow\"";
        let (folder, job) = changed(name, machine, &[(asked, slow)], &[]);
        let (code, found) = findings(&job);
        assert_eq!(code, 0, "{found:?}");
        let file = folder.path().join("c.json").display().to_string();
        let output = run(&["tools", "motion", &job, "--period-ms", "20", "--certificate", &file]);
        assert_eq!(output.status.code(), Some(0));
        let certificate = json_file(file);
        let number = |key: &str| certificate["passes"][0][key].as_f64().unwrap();
        // However much is asked for, the weld does not stop in between.
        let (least, held) = (number("least_speed_mm_s"), number("everywhere_mm_s"));
        println!("{name}: {least} to {}, everywhere {held}", number("greatest_speed_mm_s"));
        assert!(least > 0.5 * held && held > 10.0, "{name}: {least} {held}");
        assert!(number("at_asked_percent") == 0.0);
    }
}

#[test]
fn limits_of_machine_files() {
    for (key, value) in [
        ("max_speed_deg_s = 30", "0"),
        ("max_acceleration_deg_s2 = 60", "nan"),
        ("max_jerk_deg_s3 = 600", "-1"),
        ("max_jerk_deg_s3 = 600", "0"),
        ("max_speed_deg_s = 30", "inf"),
    ] {
        let name = key.split(' ').next().unwrap();
        let (_folder, job) = changed("saddle", "saddle-4axis", &[], &[(key, &format!("{name} = {value}"))]);
        for verb in [&["check"][..], &["tools", "motion"]] {
            let output = run(&[verb, &[job.as_str()]].concat());
            let text = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(2), "{text}");
            assert!(output.stdout.is_empty());
            let address = format!("{name} = {value}");
            assert!(
                text.contains("mine.toml:") && text.contains(&address) && text.contains("greater than 0"),
                "{text}"
            );
        }
    }
    // Limits that are too low for a sensible weld are findings or refused, and never a panic.
    for (limit, code) in [("0.0002", 1), ("1e-12", 2), ("1e-300", 2)] {
        let limit = format!("max_speed_deg_s = {limit}");
        let (_folder, job) = changed("saddle", "saddle-4axis", &[], &[("max_speed_deg_s = 30", limit.as_str())]);
        let output = run(&["check", &job]);
        assert_eq!(output.status.code(), Some(code), "{}", String::from_utf8_lossy(&output.stderr));
    }
}

#[test]
fn the_procedure_s_least_speed() {
    let job = |speeds: &str| changed("head-nozzle", "torch-5axis", &[("speed_mm_s = 6", speeds)], &[]);
    // Slowed down to 44.45 mm/s by axis x, and to 45.8 by axis y.
    let (_folder, path) = job("speed_mm_s = 60\non_limit = \"slow\"\nleast_speed_mm_s = 44");
    assert_eq!(findings(&path).0, 0);
    let (_folder, path) = job("speed_mm_s = 60\non_limit = \"slow\"\nleast_speed_mm_s = 50");
    let (code, found) = findings_of("least_speed", &path);
    assert_eq!(code, 1);
    let forbidding: Vec<&Value> = found.iter().filter(|f| f["allowed"] == false).collect();
    assert_eq!(forbidding.len(), 5);
    for (f, axis) in forbidding.iter().zip(["x", "y", "x", "y", "x"]) {
        let text = f["message"].as_str().unwrap();
        assert!(text.contains("50.000 mm/s") && text.contains(&format!("the speed limit of axis {axis}")), "{text}");
        assert!(f["cure"].as_str().unwrap().contains("least_speed_mm_s"));
    }
    // At the start and at the end of the second stretch the tip has that speed.
    let output = run(&["tools", "motion", &path, "--period-ms", "20"]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(1), 0));
    let ends = ["from_mm", "to_mm"].map(|key| forbidding[1][key].as_f64().unwrap());
    let (_folder, path) = job("speed_mm_s = 60\non_limit = \"slow\"");
    let rows = common::table(&common::good(&["tools", "motion", &path, "--period-ms", "1"]));
    let (s, v) = (common::column(&rows, "s_mm"), common::column(&rows, "speed_mm_s"));
    for end in ends {
        let i = s.partition_point(|s| *s < end);
        // Within the millisecond that lies before the row.
        assert!((v[i] - 50.0).abs() < 0.05, "{end}: {}", v[i]);
    }
    // The acceleration and deceleration phases are notes, not errors: they go over into forbidden stretches.
    let notes: Vec<&Value> = found.iter().filter(|f| f["allowed"] == true).collect();
    assert_eq!(notes.len(), 2);
    assert_eq!((&notes[0]["to_mm"], &notes[1]["from_mm"]), (&forbidding[0]["from_mm"], &forbidding[4]["to_mm"]));
    assert_eq!(notes[0]["from_mm"], 0.0);
    assert!((notes[1]["to_mm"].as_f64().unwrap() - s[s.len() - 1]).abs() < 1e-9);
    // A weld of constant speed has no finding, even close to the minimum speed.
    let (_folder, path) = job("speed_mm_s = 6\nleast_speed_mm_s = 5.999");
    assert_eq!(findings(&path), (0, vec![]));
    let (_, notes) = findings_of("least_speed", &path);
    assert!(notes.len() == 2 && notes.iter().all(|f| f["allowed"] == true), "{notes:?}");
    for least in ["6", "7", "0", "-1", "nan"] {
        let (_folder, path) = job(&format!("speed_mm_s = 6\nleast_speed_mm_s = {least}"));
        let output = run(&["check", &path]);
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(text.contains(&format!("weld.least_speed_mm_s = {least}")) && text.contains("allowed: "), "{text}");
    }
}

#[test]
fn welds_too_short_for_the_least_speed() {
    let fast = [("speed_mm_s = 5", "speed_mm_s = 50\non_limit = \"slow\"\nleast_speed_mm_s = 45")];
    let weak = [("max_acceleration_mm_s2 = 500", "max_acceleration_mm_s2 = 5")];
    let (_folder, path) = changed("ellipse", "ellipse-xy", &fast, &weak);
    let (code, found) = findings_of("least_speed", &path);
    assert_eq!(code, 1);
    let told = |f: &Value| f["allowed"] == false && f["message"].as_str().unwrap().contains("minimum speed is 45.000");
    assert!(found.iter().any(told), "{found:#?}");
}
