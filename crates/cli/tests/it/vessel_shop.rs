//! Joints of a vessel shop, planned with the clearance check on: passes, clearance, heat input and stick-out of each.

use crate::common::{good, json_file, root, run};
use serde_json::Value;
use std::ops::RangeInclusive;

/// Ranges that a plan must lie in: wide enough for other layers of the same groove, and for no other process.
struct Expected {
    job: &'static str,
    passes: RangeInclusive<usize>,
    /// Arc energy of the root, kJ/mm, if the job has one.
    root_kj_mm: Option<RangeInclusive<f64>>,
    /// Longest stick-out, mm, if one is not the machine's.
    stick_out_mm: Option<RangeInclusive<f64>>,
}

fn numbers(report: &Value, key: &str) -> Vec<f64> {
    report["passes"].as_array().unwrap().iter().filter_map(|pass| pass[key].as_f64()).collect()
}

fn holds(expected: &Expected) {
    let Expected { job, passes, root_kj_mm, stick_out_mm } = expected;
    let file = root().join("examples/vessel-shop").join(format!("{job}.toml"));
    let folder = tempfile::tempdir().unwrap();
    good(&["plan", file.to_str().unwrap(), "-o", folder.path().to_str().unwrap()]);
    let report = json_file(folder.path().join("report.json"));
    let all = report["passes"].as_array().unwrap();
    assert!(passes.contains(&all.len()), "{job}: {} passes", all.len());
    for pass in all {
        let clearance = &pass["clearance"];
        assert!(clearance["nearest_mm"].as_f64().unwrap() >= 0.5, "{job}: {}: {clearance}", pass["name"]);
        if let Some(range) = root_kj_mm.as_ref().filter(|_| pass["role"] == "root") {
            for end in pass["plan"]["arc_energy_kj_mm"].as_array().unwrap() {
                assert!(range.contains(&end.as_f64().unwrap()), "{job}: {end} kJ/mm");
            }
        }
    }
    let longest = numbers(&report, "stick_out_mm").into_iter().reduce(f64::max);
    match (stick_out_mm, longest) {
        (None, None) => {}
        (Some(range), Some(longest)) => assert!(range.contains(&longest), "{job}: {longest} mm"),
        other => panic!("{job}: {other:?}"),
    }
}

#[test]
fn a_set_on_nozzle_and_one_across_the_knuckle_are_clear() {
    let root_kj_mm = Some(0.4..=1.0);
    holds(&Expected { job: "set-on", passes: 8..=14, root_kj_mm: root_kj_mm.clone(), stick_out_mm: None });
    holds(&Expected { job: "knuckle-set-on", passes: 8..=16, root_kj_mm, stick_out_mm: Some(15.0..=28.0) });
}

#[test]
#[ignore = "tens of seconds a joint: make soak"]
fn the_other_joints_are_clear() {
    let root = || Some(0.4..=1.0);
    for (job, passes, root_kj_mm, stick_out_mm) in [
        ("hillside", 8..=14, root(), Some(15.0..=28.0)),
        ("knuckle-set-in", 12..=24, root(), Some(15.0..=28.0)),
        ("k-joint", 5..=12, root(), Some(15.0..=35.0)),
        ("narrow-gap-set-in", 20..=36, root(), Some(15.0..=28.0)),
        ("tube-sheet", 50..=50, None, None),
        ("titanium-girth", 8..=8, None, None),
    ] {
        holds(&Expected { job, passes, root_kj_mm, stick_out_mm });
    }
}

/// The cap's toes are 78.7 degrees as drawn. In position PB the lower one is steeper, and a procedure between both is left.
#[test]
fn toes_are_compared_as_they_sag() {
    let folder = tempfile::tempdir().unwrap();
    let shop = root().join("examples/vessel-shop");
    let job = std::fs::read_to_string(shop.join("set-on.toml")).unwrap();
    std::fs::copy(shop.join("gantry.toml"), folder.path().join("gantry.toml")).unwrap();
    let job = job.replacen("machine =", "procedure = \"w.toml\"\nmachine =", 1);
    std::fs::write(folder.path().join("job.toml"), job).unwrap();
    let procedure = |min: f64| {
        format!(
            "schema = 1\nnumber = \"W\"\ntitle = \"t\"\nprocess = 135\nwire_diameter_mm = 1.2\n[[runs]]\nname = \"tack\"\n\
             [[runs]]\nname = \"root\"\n[[runs]]\nname = \"fill\"\n[[runs]]\nname = \"cap\"\nmin_toe_angle_deg = {min}\n"
        )
    };
    for (min, is_steep) in [(74.0, false), (77.5, true), (82.0, true)] {
        std::fs::write(folder.path().join("w.toml"), procedure(min)).unwrap();
        let path = folder.path().join("job.toml");
        let output = run(&["check", path.to_str().unwrap(), "--json"]);
        let findings: Value = serde_json::from_slice(&output.stdout).unwrap();
        let codes: Vec<&str> = findings.as_array().unwrap().iter().filter_map(|f| f["code"].as_str()).collect();
        assert_eq!(
            codes.iter().filter(|code| **code == "weld-bead-toe-steep").count(),
            usize::from(is_steep),
            "{min}: {findings}"
        );
        assert_eq!(output.status.code(), Some(i32::from(is_steep)), "{min}: {findings}");
    }
}

/// Nothing is fed at the root: its metal is the ring of 2.4 x 3.2 mm once round the mean line of the pass.
#[test]
fn an_insert_is_part_of_the_weld_metal() {
    let folder = tempfile::tempdir().unwrap();
    let job = folder.path().join("job.toml");
    std::fs::write(
        &job,
        "schema = 1\ntitle = \"ring\"\nmachine = \"irb-2600\"\n[seam.girth]\nradius_mm = 84.15\n[joint]\ncap_mm = 1.0\n\
         [joint.preparation.single_v]\nthickness_mm = 7.1\nangle_deg = 60\nroot_gap_mm = 2.4\nroot_face_mm = 1.5\n\
         [joint.insert]\nkind = \"ring\"\nwidth_mm = 2.4\nheight_mm = 3.2\n[beads]\nwire_mm = 1.2\ndeposition = 1\nmost_percent = 40\n\
         root = { speed_mm_s = 1.5, process = { current_a = 110, voltage_v = 11, wire_feed_m_min = 0 } }\n\
         fill = { layer_mm = 2.5 }\n[start]\noverlap_mm = 10\n[weld]\nspeed_mm_s = 2\n\
         process = { current_a = 150, voltage_v = 12, wire_feed_m_min = 1.5 }\n",
    )
    .unwrap();
    let out = folder.path().join("out");
    good(&["plan", job.to_str().unwrap(), "-o", out.to_str().unwrap()]);
    let report = json_file(out.join("report.json"));
    let of = |i: usize| report["passes"][i]["weld_metal_kg"].as_f64().unwrap();
    let ring = 2.4 * 3.2 * std::f64::consts::TAU * 84.15 * 7.85e-6;
    assert!((of(0) / ring - 1.0).abs() < 1e-3, "{} {ring}", of(0));
    let total = report["totals"]["weld_metal_kg"].as_f64().unwrap();
    let all: f64 = (0..report["passes"].as_array().unwrap().len()).map(of).sum();
    assert!((total / all - 1.0).abs() < 1e-9 && total > ring);
}
