//! `machine tune`: margins on the shipped machines, settings that can be pasted, plots, bad names.

use crate::common::{bad, good, has_all, json, run, write};
use std::fs;
use toml_edit::DocumentMut;

/// The file of a machine that ships with the keys of `snippet` in its drives.
fn pasted(machine: &str, snippet: &str) -> String {
    let mut document: DocumentMut = good(&["machine", "show", machine]).parse().unwrap();
    let keys: DocumentMut = snippet.parse().unwrap();
    for (axis, table) in keys["drives"].as_table().unwrap() {
        for (key, value) in table.as_table().unwrap() {
            document["drives"][axis][key] = value.clone();
        }
    }
    document.to_string()
}

#[test]
fn a_shipped_machine_is_tuned_and_the_settings_can_be_pasted() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let text = good(&["machine", "tune", "saddle-4axis", "-o", &out]);
    has_all(&text, &["phase m.", "following", "theta", "beta", "tuning.toml", "bode-theta.svg"]);
    for axis in ["theta", "s", "h", "beta"] {
        let svg = fs::read_to_string(folder.path().join(format!("out/bode-{axis}.svg"))).unwrap();
        assert!(svg.contains("gain margin") && svg.contains("phase margin") && svg.contains("frequency, Hz"), "{axis}");
    }
    let snippet = fs::read_to_string(folder.path().join("out/tuning.toml")).unwrap();
    let mine = write(folder.path(), "mine.toml", pasted("saddle-4axis", &snippet));
    let check = good(&["machine", "check", &mine, "--poses", "100"]);
    assert!(check.contains("passed"), "{check}");
    // Tuning again does not depend on the settings that were there.
    let again = folder.path().join("again").display().to_string();
    good(&["machine", "tune", &mine, "-o", &again]);
    let second = fs::read_to_string(folder.path().join("again/tuning.toml")).unwrap();
    let keys = |text: &str| text.lines().filter(|l| !l.starts_with('#')).collect::<Vec<_>>().join("\n");
    assert_eq!(keys(&snippet), keys(&second));
}

#[test]
fn one_axis_as_json_has_its_margins() {
    let json: serde_json::Value = json(&["machine", "tune", "ebw-7axis", "--axis", "w", "--json"]);
    let [axis] = json.as_array().unwrap().as_slice() else { panic!("{json}") };
    let tuned = &axis["tuned"];
    assert!(axis["axis"] == "w" && axis["unit"] == "deg" && axis["refused"].is_null());
    assert!(tuned["phase_margin_deg"].as_f64().unwrap() >= 35.0);
    assert!(tuned["gain_margin_db"].as_f64().is_none_or(|db| db >= 6.0));
    assert!(tuned["following_error_counts"].as_f64().unwrap() <= 1.0);
}

#[test]
fn what_cannot_be_tuned_and_what_is_not_there_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let mine = folder.path().join("mine.toml");
    // A drive that hardly overcomes its friction.
    let weak = "[drives.s]\npeak_force_n = 30.05\n";
    fs::write(&mine, pasted("saddle-4axis", weak)).unwrap();
    let out = run(&["machine", "tune", &mine.display().to_string(), "--axis", "s"]);
    let said = String::from_utf8_lossy(&out.stdout).into_owned();
    assert_eq!(out.status.code(), Some(1), "{said}");
    assert!(said.contains("not tuned    s: "), "{said}");

    let said = bad(2, &["machine", "tune", "saddle-4axis", "--axis", "q"]);
    assert!(said.contains("allowed: theta, s, h, beta"), "{said}");

    let elastic = "[drives.s]\nresonance_hz = 50000\nload_ratio = 1\n";
    fs::write(&mine, pasted("saddle-4axis", elastic)).unwrap();
    let said = bad(2, &["machine", "tune", &mine.display().to_string()]);
    assert!(said.contains("drives.s") && said.contains("resonance_hz"), "{said}");
}
