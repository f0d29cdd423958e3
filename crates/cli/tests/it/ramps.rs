//! Process values that ramp with path length and slope with time, at every set-point, in posted programs and in
//! reports.

use crate::common::{column, free_example, good, json, table, write};
use std::fs;
use tempfile::TempDir;

/// The saddle with a current that ramps from 120 to 240 A over the weld. It rises from 60 A in 0.2 s of its travel
/// delay of 0.3 s. It falls to 40 A in the last 0.5 s of its crater fill of 0.8 s.
fn ramped() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let text = free_example("saddle");
    let slopes = "upslope = { time_s = 0.2, process = { current_a = 60 } }\n\
        downslope = { time_s = 0.5, process = { current_a = 40 } }\n[weld]\n";
    let text = text.replacen("[weld]\n", slopes, 1);
    let text = text.replacen("current_a = 240", "current_a = { from = 120, to = 240 }", 1);
    let job = write(folder.path(), "job.toml", text);
    (folder, job)
}

#[test]
fn values_ramp_in_step_with_the_motion() {
    let (_folder, job) = ramped();
    let t = table(&good(&["tools", "motion", &job, "--period-ms", "10"]));
    let [time, s, arc, current, voltage] =
        ["t_s", "s_mm", "arc", "current_a", "voltage_v"].map(|name| column(&t, name));
    let length = s[s.len() - 1];
    let off = time[arc.iter().rposition(|a| *a > 0.5).unwrap() + 1];
    let (on, travel) = (0.5, 0.8);
    let mut seen = [0; 5];
    for i in 0..time.len() {
        let since = time[i] - on;
        let (part, wanted) = if arc[i] < 0.5 {
            (0, 0.0)
        } else if since < 0.2 {
            (1, 60.0 + 300.0 * since)
        } else if time[i] < travel {
            (2, 120.0)
        } else {
            (3, 120.0 + 120.0 * s[i] / length)
        };
        assert!((voltage[i] - 27.0 * arc[i]).abs() < 1e-12);
        if s[i] < length || arc[i] < 0.5 {
            assert!((current[i] - wanted).abs() < 1e-9, "{} {} {wanted}", time[i], current[i]);
        } else {
            // The arc goes off within the period before the first set-point without it.
            let low = 240.0 - 400.0 * (0.5 - (off - time[i])).clamp(0.0, 0.5);
            assert!(current[i] <= low + 1e-9 && current[i] > low - 4.0 - 1e-9, "{} {}", time[i], current[i]);
        }
        seen[part] += 1;
    }
    assert!(seen[..4].iter().all(|n| *n > 8), "{seen:?}");
    // No jump while the arc is on: 4 A is the downslope's change in a period.
    for i in 1..time.len() {
        assert!(arc[i] < 0.5 || arc[i - 1] < 0.5 || (current[i] - current[i - 1]).abs() < 4.0 + 1e-9);
    }
}

#[test]
fn energy_and_trace_have_the_ramp() {
    let (folder, job) = ramped();
    let out = folder.path().join("out").display().to_string();
    let report = json(&["plan", &job, "-o", &out, "--appendix", "--json"]);
    let energy = |i: usize| report["plan"]["arc_energy_kj_mm"][i].as_f64().unwrap();
    // U I / v at both ends of the weld, without the acceleration and deceleration phases.
    assert!((energy(0) / (27.0 * 0.120 / 10.0) - 1.0).abs() < 1e-2, "{}", energy(0));
    assert!((energy(1) / (27.0 * 0.240 / 10.0) - 1.0).abs() < 1e-2, "{}", energy(1));
    // The program is the job.
    let program = format!("{out}/program.toml");
    let motion = |file: &str| good(&["tools", "motion", file, "--period-ms", "50"]);
    assert_eq!(motion(&program), motion(&job));
    // With the end of the downslope.
    assert!(fs::read_to_string(format!("{out}/report.html")).unwrap().contains(">40 to 240<"));
}

#[test]
fn posted_programs_step_along_the_ramp() {
    let (_folder, job) = ramped();
    let text = good(&["post", &job, "--dialect", "linuxcnc"]);
    let values = |word: &str| -> Vec<f64> {
        let of = |l: &str| l.strip_prefix(word)?.split_once(" Q")?.1.split_once(" (current_a)")?.0.parse().ok();
        text.lines().filter_map(of).collect()
    };
    let ramp = values("M67 E0");
    assert!(ramp.len() >= 50 && ramp[0] > 120.0 && ramp[ramp.len() - 1] < 240.0, "{ramp:?}");
    assert!(ramp.windows(2).all(|w| w[1] > w[0] && w[1] - w[0] < 2.4 + 1e-3), "{ramp:?}");
    let slopes = values("M68 E0");
    let turn = slopes.windows(2).position(|w| w[1] < w[0]).unwrap();
    assert!(slopes[..=turn].windows(2).all(|w| w[1] > w[0]) && slopes[0] > 60.0 && slopes[0] < 70.0, "{slopes:?}");
    assert!(slopes[turn + 1..].windows(2).all(|w| w[1] < w[0]) && slopes[slopes.len() - 1] < 50.0, "{slopes:?}");
    assert!(text.contains("M68 E0 Q0 (current_a off)"));
    // The dwells still add up.
    let dwells = |why: &str| -> f64 {
        let lines = text.lines().filter(|l| l.ends_with(&format!("({why})")));
        lines.map(|l| l["G4 P".len()..].split(' ').next().unwrap().parse::<f64>().unwrap()).sum()
    };
    assert!((dwells("upslope") + dwells("travel delay") - 0.3).abs() < 1e-9);
    assert!((dwells("downslope") + dwells("crater fill") - 0.8).abs() < 1e-9);
}
