//! `study`: results, exit codes, and the same rows after it was killed.

use crate::common::{bad, good, has_all, json, run, start, write};
use std::fs;
use std::thread::sleep;
use std::time::Duration;

const STUDY: &str = "schema = 1\njob = \"saddle\"\ndraws = 8\n\
    [[quantities]]\nname = \"height, mm\"\nvary.work = \"z_mm\"\ndraw.normal = { deviation = 30 }\n";

#[test]
fn a_study_prints_its_summary_and_writes_its_files() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(folder.path(), "study.toml", STUDY);
    let out = folder.path().join("out").display().to_string();
    let text = good(&["study", &file, "-o", &out, "--jobs", "2"]);
    has_all(&text, &["8 draws of saddle", "margin_h_mm", "motion-attitude", "report.html"]);
    let page = fs::read_to_string(format!("{out}/report.html")).unwrap();
    has_all(&page, &["Margin of axis h", "class=\"gantt", "Effect of each quantity"]);
    let summary = json(&["study", &file, "-o", &out, "--json"]);
    assert_eq!(summary["draws"], 8);
    assert_eq!(summary["quantities"][0]["varies"], "work.z_mm");
    assert_eq!(summary["quantities"][0]["name"], "height, mm");
    // No draw can be welded.
    let far = write(folder.path(), "far.toml", STUDY.replace("normal = { deviation = 30 }", "values = [500, 600]"));
    let failed = run(&["study", &far, "-o", &out]);
    assert_eq!(failed.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&failed.stdout).contains("motion-beyond-range"));
}

#[test]
fn a_killed_study_ends_with_the_same_rows() {
    let folder = tempfile::tempdir().unwrap();
    let file = write(folder.path(), "study.toml", STUDY);
    let [whole, killed] = ["whole", "killed"].map(|name| folder.path().join(name).display().to_string());
    good(&["study", &file, "-o", &whole]);
    let mut child = start(&["study", &file, "-o", &killed, "--jobs", "1"]);
    let lines = || fs::read_to_string(format!("{killed}/draws.jsonl")).unwrap_or_default().matches('\n').count();
    while lines() < 2 && child.try_wait().unwrap().is_none() {
        sleep(Duration::from_millis(2));
    }
    // An error means that it has ended: then everything is kept.
    let _ = child.kill();
    child.wait().unwrap();
    assert!(lines() >= 2);
    good(&["study", &file, "-o", &killed]);
    for name in ["draws.csv", "draws.parquet", "summary.json"] {
        assert_eq!(
            fs::read(format!("{whole}/{name}")).unwrap(),
            fs::read(format!("{killed}/{name}")).unwrap(),
            "{name}"
        );
    }
}

#[test]
fn wrong_studies_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let study = |text: String| write(folder.path(), "study.toml", text);
    for (text, parts) in [
        (STUDY.replace("z_mm", "z_cm"), ["study.toml:6", "turn_x_deg"]),
        (STUDY.replace("deviation = 30", "deviation = -30"), ["deviation", "-30"]),
        (STUDY.replace("draws", "drawn"), ["drawn", "draws"]),
    ] {
        has_all(&bad(2, &["study", &study(text), "-o", &out]), &parts);
    }
    let file = study(STUDY.to_owned());
    has_all(&bad(2, &["study", &file, "-o", &out, "--draws", "0"]), &["--draws", "10000000"]);
    has_all(&bad(2, &["study", &file, "-o", &out, "--jobs", "0"]), &["--jobs"]);
    assert!(!folder.path().join("out").exists());
}
