//! `seamwright edit`: operations, dry runs, scripts, the way back, files changed by hand.

use crate::common::{self, bad, good, run};
use serde_json::Value;
use std::fs;
use std::path::PathBuf;

const TEXT: &str = "# by hand
schema = 1
title = \"t\"
machine = \"torch-5axis\"

[variables]
far = 30

[[passes]]
name = \"root\" # the first
repeat = 2

[passes.points]
columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"current_a\", \"time_s\"]
start = [0, 0, 0, 180, 0]

[[passes.points.spans]]
along = \"line\"
points = [
    [10, 0, 0, 180, 2], # the clamp
    [20, 0, 0, 180, 2],
    [\"= far\", 0, 0, 180, 2],
]
";

fn file() -> (tempfile::TempDir, PathBuf, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p.toml");
    fs::write(&path, TEXT).unwrap();
    let name = path.display().to_string();
    (folder, path, name)
}

#[test]
fn edits_and_the_way_back() {
    let (_folder, path, name) = file();
    let text = || fs::read_to_string(&path).unwrap();
    let edit = |rest: &[&str]| good(&[&["edit", &name], rest].concat());
    let dry = edit(&["set-point", "--pass", "1", "--point", "1", "--set", "x_mm=-12.5,y_mm=1", "--dry-run"]);
    assert_eq!(
        dry,
        "pass 1, point 1: set x_mm, y_mm\n-   20 |     [10, 0, 0, 180, 2], # the clamp\n+   20 |     [-12.5, 1, 0, 180, 2], # the clamp\n"
    );
    assert!(text() == TEXT && !path.with_extension("toml.edits").exists());
    edit(&["set-point", "--pass", "1", "--point", "1", "--set", "x_mm=-12.5,y_mm=1"]);
    assert_eq!(text(), TEXT.replace("[10, 0, 0,", "[-12.5, 1, 0,"));
    let report: Value =
        serde_json::from_str(&edit(&["set-variable", "--name", "far", "--value", "40", "--json"])).unwrap();
    assert!(report["written"] == true && report["reports"][0]["words"] == "variable far = 40", "{report}");
    edit(&["set-process", "--pass", "1", "--points", "2,3", "--name", "current_a", "--value", "100,120"]);
    let last = text();
    assert!(last.contains("[20, 0, 0, 100, 2]") && last.contains("[\"= far\", 0, 0, 120, 2]"), "{last}");
    let history = edit(&["history"]);
    assert_eq!(
        history,
        "   1  pass 1, point 1: set x_mm, y_mm\n   2  variable far = 40\n   3  pass 1: current_a set\n"
    );
    for _ in 0..3 {
        assert!(edit(&["undo"]).starts_with("undone: "));
    }
    assert_eq!(text(), TEXT);
    assert!(edit(&["history"]).lines().all(|line| line.ends_with("(undone)")));
    assert!(bad(2, &["edit", &name, "undo"]).contains("nothing to be undone"));
    (0..3).for_each(|_| drop(edit(&["redo"])));
    assert_eq!(text(), last);
    // A file changed by hand: no step without force, and with it as far as it goes.
    fs::write(&path, last.replace("title = \"t\"", "title = \"mine\"")).unwrap();
    assert!(bad(2, &["edit", &name, "undo"]).contains("changed by hand"));
    edit(&["undo", "--force"]);
    assert!(text().contains("title = \"mine\"") && text().contains("[20, 0, 0, 180, 2]"));
    let to = path.with_file_name("out.toml");
    let before = text();
    edit(&["format", "-o", &to.display().to_string()]);
    assert!(text() == before && fs::read_to_string(to).unwrap().contains("# the clamp"));
}

#[test]
fn scripts_are_made_whole_or_not_at_all() {
    let (folder, path, name) = file();
    let script = folder.path().join("ops.json");
    let ops = script.display().to_string();
    fs::write(&script, r#"[{"op":"delete_points","pass":1,"from":2},{"op":"duplicate_pass","pass":7}]"#).unwrap();
    let told = bad(2, &["edit", &name, "--script", &ops]);
    assert!(told.contains("operation 2: ") && told.contains("no pass 7"), "{told}");
    assert_eq!(fs::read_to_string(&path).unwrap(), TEXT);
    fs::write(&script, r#"[{"op":"delete_points","pass":1,"from":2},{"op":"duplicate_pass","pass":1}]"#).unwrap();
    good(&["edit", &name, "--script", &ops]);
    assert_eq!(good(&["edit", &name, "history"]).lines().count(), 2);
    fs::write(&script, r#"[{"op":"delete_point"}]"#).unwrap();
    let told = bad(2, &["edit", &name, "--script", &ops]);
    assert!(told.contains("delete_point") && told.contains("ops.json"), "{told}");
}

#[test]
fn every_operation_has_help_with_an_example() {
    let help = good(&["edit", "--help"]);
    let verbs: Vec<&str> = help
        .lines()
        .skip_while(|line| !line.starts_with("Commands:"))
        .skip(1)
        .take_while(|line| line.starts_with("  "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|verb| *verb != "help")
        .collect();
    assert!(verbs.len() >= 27, "{verbs:?}");
    for verb in verbs {
        assert!(good(&["edit", "p.toml", verb, "--help"]).contains("Example"), "{verb}");
    }
}

#[test]
fn wrong_use_is_told_and_writes_nothing() {
    let (_folder, path, name) = file();
    let cases: [(&[&str], &str); 8] = [
        (&[], "no operation is given"),
        (&["set-point", "--pass", "1", "--point", "1", "--set", "x_mm"], "NAME=NUMBER"),
        (&["set-point", "--pass", "1", "--point", "1", "--set", "x_mm=nan"], "a finite number"),
        (&["mirror", "--normal", "0,0,0"], "not all 0"),
        (&["scale-speed", "--factor", "0"], "greater than 0"),
        (&["set-pass", "--pass", "1", "--repeat", "1001"], "1 to 1000"),
        (&["set-variable", "--name", "far"], "`far` is not known"),
        (&["undo"], "nothing to be undone"),
    ];
    for (arguments, message) in cases {
        let told = bad(2, &[&["edit", name.as_str()], arguments].concat());
        assert!(told.contains(message), "{arguments:?}: {told}");
        assert_eq!(fs::read_to_string(&path).unwrap(), TEXT);
    }
}

#[test]
fn repeated_passes_and_variables_are_planned() {
    let (_folder, _path, name) = file();
    let rows = common::table(&good(&["tools", "motion", &name, "--period-ms", "100"]));
    let pass = common::column(&rows, "pass");
    assert!(pass.contains(&1.0) && pass.contains(&2.0) && !pass.contains(&3.0));
}

#[test]
fn a_line_becomes_a_cubic_whose_speeds_are_set() {
    let (_folder, path, name) = file();
    let text = || fs::read_to_string(&path).unwrap();
    let edit = |rest: &[&str]| good(&[&["edit", &name], rest].concat());
    edit(&["interpolate", "--pass", "1", "--span", "1", "--along", "cubic"]);
    assert!(
        text().contains("speeds = [\n    [5, 0, 0],\n    [5, 0, 0],\n    [5, 0, 0],\n    [5, 0, 0],\n]"),
        "{}",
        text()
    );
    edit(&["set-point", "--pass", "1", "--point", "2", "--speeds", "x_mm=4,z_mm=0.5"]);
    assert!(text().contains("    [4, 0, 0.5],\n"), "{}", text());
    let told = run(&["edit", &name, "set-point", "--pass", "1", "--point", "2", "--speeds", "current_a=4"]);
    let told = String::from_utf8_lossy(&told.stderr).into_owned();
    assert!(told.contains("is not a column of the position") && told.contains("x_mm, y_mm, z_mm"), "{told}");
    edit(&["undo"]);
    edit(&["undo"]);
    assert_eq!(text(), TEXT);
}
