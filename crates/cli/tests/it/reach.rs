//! `machine reach`: the best placement is planned by the ordinary planner and written into the job.

use crate::common::{bad, example, good, has_all, json, json_file, run, write};
use serde_json::Value;
use std::fs;

/// A nozzle on a shell, near enough for the arms.
const NOZZLE: &str = include_str!("../../../../tests/data/nozzle-on-arm.toml");

fn ellipse(folder: &tempfile::TempDir, placement: &str) -> String {
    let text = fs::read_to_string(example("ellipse")).unwrap();
    write(folder.path(), "job.toml", text.replace("[start]", &format!("{placement}\n[start]")))
}

const SMALL: [&str; 4] = ["--x=-300,300,3", "--y=-100,100,3", "--z=0,0", "--turn=0,0"];

#[test]
fn the_best_placement_is_planned_and_written() {
    let folder = tempfile::tempdir().unwrap();
    let job = ellipse(&folder, "# beside the table\n[placement]\nmove_mm = [700, 50, 0] # too far");
    assert_eq!(run(&["check", &job]).status.code(), Some(1));
    let out = folder.path().join("out").display().to_string();
    let text = good(&[&["machine", "reach", &job, "--apply", "-o", &out], &SMALL[..]].concat());
    has_all(&text, &["axis x", "placement: move_mm", "reach.html", "job.toml"]);
    good(&["check", &job]);
    let written = fs::read_to_string(&job).unwrap();
    has_all(&written, &["# beside the table\n[placement]\n", "# too far", "# eccentric angle: the point (0, 16)"]);
    let found = json_file(format!("{out}/reach.json"));
    assert_eq!(found["placements"][0]["weldable"], Value::Bool(false));
    assert_eq!(found["placements"][0]["fault"], "range");
    assert_eq!(found["cut_off"], Value::Bool(false));
    let page = fs::read_to_string(format!("{out}/reach.html")).unwrap();
    has_all(&page, &["class=\"heat h", "Reasons of failures", "best placement"]);
    assert!(fs::read_to_string(format!("{out}/reach.svg")).unwrap().starts_with("<svg"));
}

#[test]
fn the_result_is_the_same_each_time() {
    let arguments = [&["machine", "reach", "ellipse", "--json"], &SMALL[..]].concat();
    assert_eq!(good(&arguments), good(&arguments));
}

fn on_arm(machine: &str, ranges: [&str; 4]) {
    let folder = tempfile::tempdir().unwrap();
    let job = write(folder.path(), "job.toml", NOZZLE.replace("MACHINE", machine));
    let found = json(&[&["machine", "reach", &job, "--json", "--apply", "--budget", "400"], &ranges[..]].concat());
    let best = &found["best"];
    println!("{machine}: {best}");
    assert_eq!(best["weldable"], Value::Bool(true), "{found}");
    let score = |row: &Value| row["score"].as_f64().unwrap();
    assert!(score(best) >= score(&found["placements"][0]) - 5e-3);
    assert_eq!(best["key"], "placement");
    assert!(fs::read_to_string(&job).unwrap().contains("# on the plate"));
    good(&["check", &job]);
}

#[test]
fn the_best_placement_on_an_arm_is_planned() {
    on_arm("irb-2600", ["--x=-200,300,3", "--y=-300,300,3", "--z=0,0", "--turn=0,0"]);
}

#[test]
fn the_best_placement_on_an_arm_with_a_positioner_is_planned() {
    on_arm("ur10e-positioner", ["--x=-60,60,3", "--y=0,0", "--z=0,60,2", "--turn=0,0"]);
}

/// The base of a machine file is moved, and the job is planned on it; a supplied machine has no file to write to.
#[test]
fn the_best_base_is_written_into_the_machine_file() {
    let folder = tempfile::tempdir().unwrap();
    let job = write(folder.path(), "job.toml", NOZZLE.replace("MACHINE", "irb-2600"));
    let ranges = ["--base", "--x=-100,200,2", "--y=0,0", "--z=0,0", "--turn=0,0", "--budget", "400"];
    let refused = bad(2, &[&["machine", "reach", &job, "--apply"], &ranges[..]].concat());
    has_all(&refused, &["--apply irb-2600", "seamwright machine show irb-2600 > machines/irb-2600.toml"]);
    fs::create_dir(folder.path().join("machines")).unwrap();
    let supplied = good(&["machine", "show", "irb-2600"]);
    let machine = write(&folder.path().join("machines"), "irb-2600.toml", supplied.clone());
    let before = fs::read_to_string(&job).unwrap();
    let out = folder.path().join("out").display().to_string();
    let text = good(&[&["machine", "reach", &job, "--apply", "-o", &out], &ranges[..]].concat());
    has_all(&text, &["the machine's base", "irb-2600.toml: work[0].fixed = { move_mm = ["]);
    let found = json_file(format!("{out}/reach.json"));
    assert_eq!((&found["moved"], &found["best"]["key"]), (&"base".into(), &"work[0].fixed".into()));
    let x = found["best"]["x_mm"].as_f64().unwrap();
    assert!(x.abs() > 1.0, "{found}");
    let written = fs::read_to_string(&machine).unwrap();
    assert!(written.contains(&format!("fixed = {{ move_mm = [{:?}, 0.0, 0.0] }}", 900.0 - x)), "{x} {written}");
    let same = written.lines().zip(supplied.lines()).filter(|(a, b)| a == b).count();
    assert_eq!(same + 1, supplied.lines().count());
    assert_eq!(fs::read_to_string(&job).unwrap(), before);
    assert!(fs::read_to_string(format!("{out}/reach.html")).unwrap().contains("Placements of the machine's base"));
    good(&["check", &job]);
}

/// Ctrl-C ends the search with a result, a second one ends the program.
#[cfg(target_os = "linux")]
#[test]
fn ctrl_c_ends_the_search_and_then_the_program() {
    let arguments = ["machine", "reach", "ellipse", "--x=-300,300,300", "--y=-100,100,300", "--budget", "3000"];
    let mut search = start_search(&arguments);
    interrupt(&search);
    let ended = search.wait_with_output().unwrap();
    let text = String::from_utf8(ended.stdout).unwrap();
    has_all(&text, &["Ctrl-C ended the search", "placement: move_mm"]);
    assert_eq!(ended.status.code(), Some(0));
    // The plan of the best placement takes longer than the pause.
    let folder = tempfile::tempdir().unwrap();
    let job = write(folder.path(), "job.toml", NOZZLE.replace("MACHINE", "irb-2600"));
    search = start_search(&["machine", "reach", &job, "--x=-100,100,100", "--budget", "3000"]);
    interrupt(&search);
    std::thread::sleep(std::time::Duration::from_millis(100));
    interrupt(&search);
    let ended = search.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(130), "{}", String::from_utf8_lossy(&ended.stderr));
}

/// Starts the program, and waits until it takes Ctrl-C and has searched for a while.
#[cfg(target_os = "linux")]
fn start_search(arguments: &[&str]) -> std::process::Child {
    use std::time::Duration;
    let child = crate::common::start(arguments);
    let takes_interrupts = || {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:")).unwrap().trim().to_owned();
        u64::from_str_radix(&caught, 16).unwrap() & 2 != 0
    };
    while !takes_interrupts() {
        std::thread::sleep(Duration::from_millis(20));
    }
    std::thread::sleep(Duration::from_secs(2));
    child
}

#[cfg(target_os = "linux")]
fn interrupt(child: &std::process::Child) {
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

#[test]
fn nothing_is_written_without_a_placement() {
    let folder = tempfile::tempdir().unwrap();
    let job = ellipse(&folder, "[placement]\nmove_mm = [0, 0, 50]");
    let before = fs::read_to_string(&job).unwrap();
    let output = run(&[&["machine", "reach", &job, "--apply"], &SMALL[..]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stdout).unwrap().contains("no placement is weldable"));
    assert_eq!(fs::read_to_string(&job).unwrap(), before);
}

#[test]
fn a_small_budget_ends_with_what_was_found() {
    let output = run(&["machine", "reach", "ellipse", "--json", "--budget", "0.000001"]);
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(found["cut_off"], Value::Bool(true));
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn bad_ranges_are_refused_with_what_is_allowed() {
    let bad = |extra: &[&str]| bad(2, &[&["machine", "reach", "ellipse"], extra].concat());
    has_all(&bad(&["--x=300,-300,9"]), &["--x 300,-300,9", "starts above its end", "FROM,TO,CELLS"]);
    has_all(&bad(&["--turn", "1"]), &["--turn 1", "FROM,TO or FROM,TO,CELLS"]);
    has_all(&bad(&["--y", "0,1,0"]), &["--y 0,1,0", "1 or more cells"]);
    has_all(&bad(&["--z", "0,1e9"]), &["--z 0,1e9", "100000"]);
    has_all(&bad(&["--x", "0,1,1000", "--y", "0,1,1000"]), &["1000000 places", "100000"]);
    has_all(&bad(&["--budget", "0"]), &["--budget 0"]);
    has_all(&bad(&["--apply"]), &["--apply ellipse", "seamwright examples NAME > job.toml"]);
}
