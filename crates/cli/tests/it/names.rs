//! Names of examples and machines stand for their files; for an unknown name the closest one is suggested. Outputs go
//! to the named path.

use crate::common::{bad, example, good, json, root, run};
use serde_json::Value;
use std::fs;
use std::process::{Command, Output};

fn run_in(folder: &std::path::Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_seamwright")).args(arguments).current_dir(folder).output().unwrap()
}

#[test]
fn an_example_is_taken_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let seam = |job: &str| run_in(folder.path(), &["tools", "seam", job, "--points", "5"]);
    assert_eq!(seam("saddle").stdout, seam(&fs::canonicalize(example("saddle")).unwrap().display().to_string()).stdout);
    assert!(run_in(folder.path(), &["check", "ellipse"]).status.success());
    // A file of that name comes first.
    fs::write(folder.path().join("saddle"), "schema = 1\ntitle = 5\n").unwrap();
    let output = seam("saddle");
    assert!(output.status.code() == Some(2) && String::from_utf8_lossy(&output.stderr).contains("title"));
    // A shipped example is welded on the shipped machine, even with another machine file in the folder.
    fs::create_dir(folder.path().join("machines")).unwrap();
    fs::write(folder.path().join("machines/ellipse-xy.toml"), "broken").unwrap();
    assert!(run_in(folder.path(), &["check", "ellipse"]).status.success());
}

/// As after `seamwright plan ellipse -o ellipse`: a folder is no job.
#[test]
fn a_folder_of_its_name_does_not_hide_an_example() {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("ellipse")).unwrap();
    let output = run_in(folder.path(), &["check", "ellipse"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn what_is_no_job_says_what_is_meant() {
    for (job, meant) in [("sadle", "saddle"), ("hill_side", "hillside"), ("jobs/ellipse.toml", "ellipse")] {
        let told = bad(2, &["plan", job]);
        let copy = format!("there is an example `{meant}`; to copy it: seamwright examples {meant} > {meant}.toml");
        assert!(told.contains(job) && told.contains("there is no such file") && told.contains(&copy), "{told}");
        assert!(told.contains("allowed: ") && told.contains("thick-saddle"), "{told}");
    }
    let told = bad(2, &["check", "nothing-like-it"]);
    assert!(!told.contains("there is an example") && told.contains("thick-saddle"), "{told}");
    let told = bad(2, &["machine", "kinematics", "torch-5-axis", "--forward"]);
    assert!(told.contains("did you mean `torch-5axis`?"), "{told}");
}

#[test]
fn a_plan_goes_to_a_folder_of_its_name() {
    let folder = tempfile::tempdir().unwrap();
    fs::copy(example("ellipse"), folder.path().join("plate.toml")).unwrap();
    for (job, name) in [("plate.toml", "plate"), ("ellipse", "ellipse")] {
        let output = run_in(folder.path(), &["plan", job]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(folder.path().join("out").join(name).join("report.html").is_file());
        let wrote: Vec<&str> = text.lines().filter(|line| line.contains("wrote")).collect();
        assert!(
            wrote.len() == 1 && wrote[0].contains(&format!("files to out/{name}: report.html, program.toml")),
            "{text}"
        );
    }
}

#[test]
fn a_job_is_planned_before_it_is_edited() {
    for operation in [&["history"][..], &["undo"]] {
        let told = bad(2, &[&["edit", &example("saddle")], operation].concat());
        assert!(told.contains("this is a job") && told.contains("plan it first: seamwright plan"), "{told}");
        assert!(told.contains("out/saddle/program.toml"), "{told}");
    }
}

#[test]
fn several_jobs_are_checked_and_the_worst_exit_code_counts() {
    let folder = tempfile::tempdir().unwrap();
    let fast = folder.path().join("fast.toml");
    let text = fs::read_to_string(example("ellipse")).unwrap();
    fs::write(&fast, text.replace("speed_mm_s = 5", "speed_mm_s = 2000")).unwrap();
    let fast = fast.display().to_string();
    let check = |jobs: &[&str]| {
        let output = run(&[&["check"], jobs].concat());
        (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap())
    };
    let (code, text) = check(&["ellipse", "points"]);
    assert!(code == 0 && text.contains("ellipse: the weld can be made"), "{code} {text}");
    assert!(text.contains("points: the weld can be made"), "{text}");
    let (code, text) = check(&[&fast, "ellipse"]);
    assert!(code == 1 && text.contains("fast.toml: the weld cannot be made") && text.contains("ellipse: "), "{text}");
    let (code, text) = check(&["nowhere.toml", &fast, "ellipse"]);
    assert!(code == 2 && text.contains("nowhere.toml: error: ") && text.contains("ellipse: "), "{code} {text}");
    let (code, text) = check(&["ellipse", &fast, "nowhere.toml", "--json"]);
    let all: Value = serde_json::from_str(&text).unwrap();
    assert_eq!((code, all.as_array().unwrap().len()), (2, 3));
    assert!(all[0]["findings"].is_array() && all[1]["findings"][0]["allowed"] == false && all[2]["error"].is_string());
    // One job is answered as before: a list of findings.
    let alone = json(&["check", "ellipse", "--json"]);
    assert!(alone.is_array());
}

#[test]
fn what_is_named_and_missing_is_bad_input_everywhere() {
    let job = example("oblique-girth");
    for arguments in [
        &["teach", &job, "--frames", "nowhere", "-o", "taught.toml"][..],
        &["teach", &job, "--semi-manual", "nowhere.csv", "-o", "taught.toml"],
        &["check", "nowhere.toml"],
        &["tools", "reduce", "nowhere.csv", "--tolerance-mm", "1"],
        &["vision", "stripe", "nowhere.png", "--joint", "v"],
        &["vision", "joint", "nowhere.png", "--start", "1,1", "--direction-deg", "0"],
        &["import", "nowhere.ngc", "--machine", "torch-5axis"],
        &["edit", "nowhere.toml", "history"],
        &["tools", "follow", "nowhere.csv", "--machine", "torch-5axis", "--speed-mm-s", "5"],
        &["machine", "check", "nowhere.toml"],
        &["records", "restore", "nowhere.tar", "--data", "nowhere"],
        &["simulate", "ellipse", "-o", "nowhere", "--distortion", "nowhere.toml"],
    ] {
        let told = bad(2, arguments);
        assert!(told.contains("nowhere"), "{arguments:?}: {told}");
    }
    assert!(!root().join("nowhere").exists());
}

#[cfg(unix)]
#[test]
fn outputs_follow_links_and_are_written_to_pipes() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let section = |svg: &str| {
        let svg = at(svg).display().to_string();
        good(&["tools", "section", "thick-saddle", "--points", "2", "--svg", &svg])
    };
    std::os::unix::fs::symlink("there.svg", at("link.svg")).unwrap();
    section("link.svg");
    assert!(fs::symlink_metadata(at("link.svg")).unwrap().is_symlink());
    let drawn = fs::read_to_string(at("there.svg")).unwrap();
    assert!(drawn.contains("<svg"));
    assert!(Command::new("mkfifo").arg(at("pipe")).status().unwrap().success());
    let reader = std::thread::spawn({
        let pipe = at("pipe");
        move || fs::read_to_string(pipe).unwrap()
    });
    section("pipe");
    assert_eq!(reader.join().unwrap(), drawn);
    assert!(!fs::symlink_metadata(at("pipe")).unwrap().is_file());
}
