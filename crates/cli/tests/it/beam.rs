//! Beam mode and replay in `simulate`, on the half-ring that ships.

use crate::common::{bad, example, good, part_of, root, run};
use serde_json::Value;
use std::fs;
use std::path::Path;

fn report(folder: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(folder.join("report.json")).unwrap()).unwrap()
}

#[test]
fn a_half_ring_with_a_cosmetic_pass() {
    let folder = tempfile::tempdir().unwrap();
    let [out, again, moved] = ["out", "again", "moved"].map(|name| folder.path().join(name));
    let shown = |path: &Path| path.display().to_string();
    let job = part_of(folder.path(), "half-ring", "end_phi_deg = 210", "end_phi_deg = 75");
    let misplaced = shown(&root().join("examples/distortions/half-ring.toml"));
    let text = good(&["simulate", &job, "-o", &shown(&out), "--distortion", &misplaced]);
    assert!(
        text.contains("untracked") && text.contains("replayed: deflected by") && text.contains("deviations-pass-1.csv")
    );
    let found = report(&out);
    for (pass, replayed) in [(0, false), (1, true)] {
        let head = &found["passes"][pass]["simulation"]["heads"][0];
        assert!(head["untracked_p99_mm"].as_f64().unwrap() > 1.5, "{head}");
        assert!(head["miss_p99_mm"].as_f64().unwrap() <= 0.05 && head["beam"]["replayed"] == replayed, "{head}");
    }
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    for words in ["measurement by the beam", "stored deviations", "a beam has no height", "gun carried by the axes"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!out.join("deviations-pass-2.csv").exists());
    // A later run of the same part, without tracking anew.
    let stored = shown(&out.join("deviations-pass-1.csv"));
    let replay = |distortion: &str, to: &Path| {
        run(&["simulate", &job, "-o", &shown(to), "--distortion", distortion, "--seed", "2", "--replay", &stored])
    };
    assert_eq!(replay(&misplaced, &again).status.code(), Some(0));
    let head = &report(&again)["passes"][0]["simulation"]["heads"][0];
    assert!(head["beam"]["replayed"] == true && head["miss_p99_mm"].as_f64().unwrap() <= 0.05, "{head}");
    // A part that lies where it was planned is not that part.
    let right = shown(&folder.path().join("right.toml"));
    fs::write(&right, "schema = 1\n").unwrap();
    let refused = replay(&right, &moved);
    let told = String::from_utf8(refused.stderr).unwrap();
    assert_eq!(refused.status.code(), Some(1), "{told}");
    assert!(told.contains("the stored deviation does not fit") && told.contains("stopped at 0.0 mm"), "{told}");
    let text = String::from_utf8(refused.stdout).unwrap();
    assert!(text.matches("nothing of it").count() == 2 && !text.contains("inf"), "{text}");
}

#[test]
fn what_cannot_be_replayed() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    let file = folder.path().join("d.csv").display().to_string();
    let head = "s_mm,lateral_mm,height_mm,confidence\n";
    let simulate = |job: &str, rows: &str, more: &[&str]| {
        fs::write(&file, format!("{head}{rows}")).unwrap();
        let told = bad(2, &[&["simulate", &example(job), "-o", &out, "--replay", &file], more].concat());
        assert!(!Path::new(&out).exists());
        told
    };
    assert!(simulate("half-ring", "0,0,0,1\n50,0,0,1\n", &[]).contains("deviations are stored from 0 mm to 50 mm"));
    assert!(simulate("half-ring", "0,0,0,1\n50,zero,0,1\n", &[]).contains("d.csv:3: lateral_mm = `zero`"));
    assert!(simulate("saddle", "0,0,0,1\n5000,0,0,1\n", &[]).contains("torch.deflection"));
    assert!(simulate("half-ring", "0,0,0,1\n5000,0,0,1\n", &["--no-tracking"]).contains("--no-tracking"));
    let job = folder.path().join("job.toml");
    let text = fs::read_to_string(example("half-ring")).unwrap();
    for (from, to, says) in [
        ("from_mm = 20", "from_mm = 2000", "starts beyond the end of the weld"),
        ("beam_ma = 12", "beam_mA = 12", "cosmetic.process"),
        ("beam_ma = 12", "beam_ma = { from = 1, to = 2 }", "steady values"),
    ] {
        fs::write(&job, text.replace(from, to)).unwrap();
        let told = bad(2, &["check", &job.display().to_string()]);
        assert!(told.contains(says), "{told}");
    }
}
