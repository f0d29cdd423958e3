//! Jobs checked against a procedure: output of `check` and `plan`, written files, and errors of bad procedure files.

use crate::common::{example, good, has_all, json_file, root, run, write};
use std::fs;
use std::path::Path;
use std::process::Output;

/// The example saddle and its procedure in `folder`, both changed.
fn job(folder: &Path, procedure: &[(&str, &str)], job: &[(&str, &str)]) -> String {
    let changed = |path: String, changes: &[(&str, &str)]| {
        let mut text = fs::read_to_string(path).unwrap();
        for (from, to) in changes {
            assert!(text.contains(from), "{from}");
            text = text.replacen(from, to, 1);
        }
        text
    };
    let wps = root().join("examples/procedures/135-saddle.toml").display().to_string();
    fs::create_dir_all(folder.join("wps")).unwrap();
    fs::write(folder.join("wps/my.toml"), changed(wps, procedure)).unwrap();
    let text = changed(example("saddle"), job).replacen("\"135-saddle\"", "\"wps/my.toml\"", 1);
    write(folder, "job.toml", text)
}

fn check(procedure: &[(&str, &str)], changes: &[(&str, &str)]) -> Output {
    let folder = tempfile::tempdir().unwrap();
    run(&["check", &job(folder.path(), procedure, changes)])
}

#[test]
fn a_plan_that_leaves_its_procedure_is_written_and_has_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = job(folder.path(), &[], &[("current_a = 240", "current_a = { from = 200, to = 290 }")]);
    let out = folder.path().join("out");
    let output = run(&["plan", &path, "-o", &out.display().to_string(), "--plots"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("current_a is 290 at s = 1600.834 mm"));
    let report = json_file(out.join("report.json"));
    let held = &report["passes"][0]["procedure"];
    let current = held["quantities"].as_array().unwrap().iter().find(|q| q["key"] == "current_a").unwrap();
    let length = report["seam"]["weld_length_mm"].as_f64().unwrap();
    let outside = current["outside"].as_array().unwrap();
    assert!((outside[0]["to_mm"].as_f64().unwrap() - length * 20.0 / 90.0).abs() < 1e-6, "{outside:?}");
    assert!((outside[1]["from_mm"].as_f64().unwrap() - length * 60.0 / 90.0).abs() < 1e-6, "{outside:?}");
    assert_eq!((&held["positions"][0]["position"], &held["joint"]), (&"PB".into(), &"fillet".into()));
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    has_all(
        &page,
        &["Outside WPS 135-01", "Heat input along the seam", "Welding position", "to be measured", "outside: s ="],
    );
    assert!(out.join("plots/heat-input.svg").exists() && out.join("plots/position.svg").exists());
    // The program holds its procedure and is judged alike; verbs that would weld refuse it.
    let program = out.join("program.toml").display().to_string();
    let again = run(&["check", &program]);
    assert_eq!((again.status.code(), again.stdout), (Some(1), run(&["check", &path]).stdout));
    assert_eq!(run(&["post", &program, "--dialect", "linuxcnc"]).status.code(), Some(1));
}

#[test]
fn each_kind_of_window_is_watched() {
    let says = |procedure: &[(&str, &str)], changes: &[(&str, &str)], words: &[&str]| {
        let output = check(procedure, changes);
        let text = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(1), "{text}");
        has_all(&text, words);
    };
    says(
        &[("[8, 12]", "[4, 6]")],
        &[],
        &["finding (procedure): the speed of the tip is 10 mm/s", "allows (pass 1) 4 mm/s to 6 mm/s"],
    );
    says(&[("[0.4, 0.65]", "[0.6, 0.9]")], &[], &["the heat input is 0.5184 kJ/mm", "weld slower or with more power"]);
    says(&[("\"PB\", ", "")], &[], &["in position PB", "rotation 45.0° to 54.1°", "allows (pass 1) PA, PC"]);
    says(&[("[-20, 20]", "[-3, 3]")], &[], &["travel angle", "allows", "-3° to 3°"]);
    says(&[("process = 135 ", "process = 52 ")], &[], &["does not give laser_w"]);
    says(&[("passes = \"1\"", "name = \"root\"")], &[], &["no run of WPS 135-01 is for pass 1"]);
    says(&[], &[("wire_feed_m_min = 8", "wire_feed_m_min = 9.5")], &["wire_feed_m_min is 9.5", "7 to 9"]);
}

#[test]
fn bad_procedures_have_an_address() {
    let refused = |from: &str, to: &str, words: &[&str]| {
        let output = check(&[(from, to)], &[]);
        let text = String::from_utf8(output.stderr).unwrap();
        println!("{text}");
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(output.stdout.is_empty() && text.contains("my.toml:"));
        has_all(&text, words);
    };
    refused("[8, 12]", "[12, 8]", &["runs[0].speed_mm_s", "above the maximum", "[minimum, maximum]"]);
    refused("[8, 12]", "[-8, 12]", &["runs[0].speed_mm_s", "begins below 0", "0 or greater"]);
    refused("[8, 12]", "[8, 12, 14]", &["runs[0].speed_mm_s", "length 2"]);
    refused("process = 135 ", "process = 163 ", &["process = 163", "allowed: 111 (manual"]);
    refused("\"PC\"", "\"PX\"", &["runs[0].positions", "`PX`"]);
    refused("passes = \"1\"", "passes = \"1, 1\"", &["pass 1 is named twice"]);
    refused("passes = \"1\"\n", "", &["names no passes"]);
    refused("speed_mm_s", "speed_cm_min", &["did you mean `speed_mm_s`?"]);
    let output = check(&[], &[("\"135-saddle\"", "\"135-sadle\"")]);
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(
        output.status.code() == Some(2) && text.contains("procedure = \"135-sadle\"") && text.contains("135-saddle,"),
        "{text}"
    );
}

#[test]
fn procedures_are_listed_and_printed() {
    assert!(good(&["examples", "--procedures"]).contains("135 MAG welding with solid wire"));
    let text = fs::read_to_string(root().join("examples/procedures/135-saddle.toml")).unwrap();
    assert_eq!(good(&["examples", "--procedures", "135-saddle"]), text);
}

/// Windows of beads that no plan can keep are findings with the plan beside them, not a refusal of the job's keys.
#[test]
fn windows_of_beads_that_the_plan_leaves_are_findings() {
    let folder = tempfile::tempdir().unwrap();
    let window = "[[runs]]\nname = \"fill\"\nbead_width_mm = [4, 5]\nbead_height_mm = [1, 1.5]\n";
    let wps = "schema = 1\nnumber = \"W\"\ntitle = \"t\"\nprocess = 135\nwire_diameter_mm = 1.2\n".to_owned() + window;
    write(folder.path(), "narrow.toml", wps);
    let text = fs::read_to_string(example("hillside")).unwrap();
    let machine = text.find("machine = ").unwrap();
    let job = format!("{}procedure = \"narrow.toml\"\n{}", &text[..machine], &text[machine..]);
    let output = run(&["check", &write(folder.path(), "job.toml", job)]);
    let printed = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{printed}");
    has_all(&printed, &["the bead would be", "another window in the procedure"]);
}
