//! Many copies of a seam in one job: planned, drawn, simulated, and the same again from the program.

use crate::common::{column, example, good, json, table};
use serde_json::Value;
use std::fs;

#[test]
fn a_radiator_is_welded_back_and_forth() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("weld").display().to_string();
    let summary = good(&["plan", &example("radiator"), "-o", &out, "--plots"]);
    assert!(summary.contains("row 2, 6"), "{summary}");
    let file = |name: &str| fs::read_to_string(folder.path().join("weld").join(name)).unwrap();
    let svg = file("plots/order.svg");
    assert!((1..=12).all(|number| svg.contains(&format!(">{number}</text>"))), "{svg}");
    assert!(file("report.html").contains("passes in the order of welding"));
    let planned: Value = serde_json::from_str(&file("report.json")).unwrap();
    let passes = planned["passes"].as_array().unwrap();
    let rows: Vec<&str> = passes.iter().map(|pass| &pass["copy"].as_str().unwrap()[..5]).collect();
    assert!(rows.len() == 12 && rows.windows(2).all(|w| w[0] != w[1]), "{rows:?}");
    let number = |value: &Value| value.as_f64().unwrap();
    let total: f64 =
        passes.iter().map(|pass| number(&pass["plan"]["total_s"])).sum::<f64>() + number(&planned["air_s"]);
    assert!((total - number(&planned["total_s"])).abs() < 1e-9);
    assert!(passes.iter().map(|pass| number(&pass["air_before_s"])).sum::<f64>() < number(&planned["air_s"]));

    let program = folder.path().join("weld/program.toml").display().to_string();
    let again = folder.path().join("again").display().to_string();
    let simulated = json(&["simulate", &program, "-o", &again, "--json"]);
    assert_eq!(simulated["total_s"], planned["total_s"]);
    for pass in simulated["passes"].as_array().unwrap() {
        assert!(number(&pass["simulation"]["path_error_mm"]["max"]) < 0.05);
    }
}

#[test]
fn the_torch_goes_around_each_tube_at_its_place() {
    let rows = table(&good(&["tools", "motion", &example("radiator"), "--period-ms", "50"]));
    let [pass, x, y] = ["pass", "x", "y"].map(|name| column(&rows, name));
    let mut centres = Vec::new();
    for number in 1..=12 {
        let on: Vec<usize> = (0..pass.len()).filter(|i| (pass[*i] - f64::from(number)).abs() < 0.5).collect();
        let middle = |v: &[f64]| {
            let ends = on.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), i| (l.min(v[*i]), h.max(v[*i])));
            (0.5 * (ends.0 + ends.1)).round()
        };
        let centre = (middle(&x), middle(&y));
        for i in on {
            let (u, v) = ((x[i] - centre.0) / 20.0, (y[i] - centre.1) / 16.0);
            assert!((u.hypot(v) - 1.0).abs() < 1e-6, "pass {number}: {} {}", x[i], y[i]);
        }
        centres.push(centre);
    }
    centres.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.total_cmp(&b.0)));
    let wanted = [-30.0, 30.0].into_iter().flat_map(|y| (0..6).map(move |k| (-125.0 + 50.0 * f64::from(k), y)));
    assert!(centres.iter().copied().eq(wanted), "{centres:?}");
}
