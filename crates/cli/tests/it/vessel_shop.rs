//! Joints of a vessel shop, planned with the clearance check on: passes, clearance, heat input and stick-out of each.

use crate::common::{good, json_file, root};
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
