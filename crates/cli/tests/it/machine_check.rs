//! `machine check`: shipped machines pass, all files are written, bad files and numbers are refused.

use crate::common::{good, json_file, root, run, write};
use seamwright_machine::SHIPPED;
use std::fs;

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

#[test]
fn shipped_machines_pass_and_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    for name in SHIPPED.iter().map(|shipped| shipped.name) {
        let out = folder.path().join(name);
        let shown = out.display().to_string();
        let summary = good(&["machine", "check", name, "--poses", "500", "-o", &shown]);
        assert!(summary.contains("result       passed") && summary.contains("check.html"), "{summary}");
        let json = json_file(out.join("check.json"));
        assert!(json["passed"] == true && json["name"] == name);
        let svg = fs::read_to_string(out.join("machine.svg")).unwrap();
        let page = fs::read_to_string(out.join("check.html")).unwrap();
        for axis in json["axes"].as_array().unwrap() {
            let axis = axis["name"].as_str().unwrap();
            // Once in each view, three of them to scale and a pictorial one.
            let labels = [format!(">{axis}</text>"), format!(">{axis} (")];
            let count: usize = labels.iter().map(|l| svg.matches(l.as_str()).count()).sum();
            assert!(count >= 4, "{name} {axis}: {count}");
            assert!(page.contains(&format!("<td>{axis}</td>")), "{name} {axis}");
        }
        assert!(page.contains("In order") && page.contains("Singular configurations"));
    }
}

#[test]
fn json_goes_to_standard_output_and_the_seed_decides() {
    let run = |seed: &str| good(&["machine", "check", "saddle-4axis", "--poses", "300", "--seed", seed, "--json"]);
    let (a, b) = (run("1"), run("1"));
    assert_eq!(a, b);
    assert_ne!(a, run("2"));
    let json: serde_json::Value = serde_json::from_str(&a).unwrap();
    assert_eq!(json["heads"][0]["round_trip"]["poses"], 300);
    assert!(json["heads"][0]["reach"]["volume"]["measure"].as_f64().unwrap() > 5e8);
}

#[test]
fn remarks_name_their_line_and_do_not_fail() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.toml");
    let file = fs::read_to_string(root().join("machines/torch-5axis.toml")).unwrap();
    let slipped = file.replacen("max_speed_mm_s = 100", "max_speed_mm_s = 6000", 1);
    let line = slipped.lines().position(|l| l == "max_speed_mm_s = 6000").unwrap() + 1;
    fs::write(&path, slipped).unwrap();
    let summary = good(&["machine", "check", &path.display().to_string(), "--poses", "100"]);
    assert!(summary.contains(&format!("remark       line {line}: tool[0].max_speed_mm_s = 6000")), "{summary}");
    assert!(summary.contains("cure: give the speed in mm/s; mm/min may have been meant"), "{summary}");
}

#[test]
fn bad_input_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let file = fs::read_to_string(root().join("machines/torch-5axis.toml")).unwrap();
    let write = |name: &str, text: &str| write(folder.path(), name, text);
    let outside = file.replacen("range_mm = [-800, 800]", "range_mm = [-800, 800]\nhome_mm = 900", 1);
    for (machine, words) in [
        ("no-such-machine".to_owned(), "there is no such machine"),
        (write("outside.toml", &outside), "outside the range"),
        (write("unit.toml", &file.replacen("range_mm", "range_deg", 1)), "a linear axis is in mm"),
        (write("empty.toml", ""), "schema"),
        (write("broken.toml", &file[..file.len() / 2].replacen('=', "", 1)), "broken.toml:"),
    ] {
        let output = run(&["machine", "check", &machine, "-o", &out.display().to_string()]);
        let errors = text(output.stderr);
        assert!(output.status.code() == Some(2) && errors.contains(words), "{machine}: {errors}");
        assert!(output.stdout.is_empty() && !out.exists());
    }
    for poses in ["0", "-5", "1e3", "20000000"] {
        let output = run(&["machine", "check", "ellipse-xy", &format!("--poses={poses}")]);
        assert_eq!(output.status.code(), Some(2), "{poses}");
    }
    let file = write("file", "");
    assert_eq!(run(&["machine", "check", "ellipse-xy", "-o", &file]).status.code(), Some(2));
}
