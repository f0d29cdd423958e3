//! Certificates, checked with the set-points and the machine file alone.

use crate::common::checker::{Motion, check, motion};
use crate::common::{example, free_example, root, write};
use std::fs;

const EXAMPLES: [(&str, &str); 6] = [
    ("saddle", "saddle-4axis"),
    ("head-nozzle", "torch-5axis"),
    ("ellipse", "ellipse-xy"),
    ("trunnion-saddle", "table-tilting-xyzac"),
    ("oblique-girth", "ebw-7axis"),
    ("t-joint", "dual-laser-10axis"),
];

fn machine_text(name: &str) -> String {
    fs::read_to_string(root().join("machines").join(format!("{name}.toml"))).unwrap()
}

/// The example, as it is or at another speed and slowed down where an axis needs it.
fn of_example(name: &str, machine: &str, speed: Option<(&str, &str)>, period_ms: &str) -> Motion {
    let Some((from, to)) = speed else { return motion(&example(name), machine, &machine_text(machine), period_ms) };
    let text = free_example(name);
    assert!(text.contains(from));
    let folder = tempfile::tempdir().unwrap();
    let job = write(folder.path(), "job.toml", text.replacen(from, &format!("{to}\non_limit = \"slow\""), 1));
    motion(&job, machine, &machine_text(machine), period_ms)
}

#[test]
fn every_example_is_as_its_certificate_says() {
    for (name, machine) in EXAMPLES {
        // Short seams are looked at more closely.
        let periods = if matches!(name, "ellipse" | "t-joint") { &["1", "4"][..] } else { &["4"] };
        for period in periods {
            let m = of_example(name, machine, None, period);
            let found = check(&m);
            println!("{name} {period} ms: band {:?}, at asked {}, uses {:?}", found.band, found.at_asked, found.uses);
            assert!(found.wrong.is_empty(), "{name} {period} ms: {:#?}", found.wrong);
        }
    }
}

#[test]
fn slowed_welds_are_as_their_certificates_say() {
    for (name, machine, from, to) in [
        ("head-nozzle", "torch-5axis", "speed_mm_s = 6", "speed_mm_s = 60"),
        ("trunnion-saddle", "table-tilting-xyzac", "speed_mm_s = 8", "speed_mm_s = 80"),
        ("ellipse", "ellipse-xy", "speed_mm_s = 5", "speed_mm_s = 200"),
        ("saddle", "saddle-4axis", "speed_mm_s = 10", "speed_mm_s = 1e5"),
    ] {
        for period in ["1", "4"] {
            let m = of_example(name, machine, Some((from, to)), period);
            let found = check(&m);
            println!("{name} {period} ms: band {:?}, at asked {}, uses {:?}", found.band, found.at_asked, found.uses);
            assert!(found.wrong.is_empty(), "{name} {period} ms: {:#?}", found.wrong);
            // An axis is at one of its limits: otherwise the weld could go faster.
            let most = found.uses.values().flatten().fold(0.0f64, |m, u| m.max(*u));
            assert!(most > 0.98, "{name}: {most}");
        }
    }
}

#[test]
fn the_checker_sees_what_is_wrong() {
    let m = of_example("ellipse", "ellipse-xy", None, "1");
    assert!(check(&m).wrong.is_empty());
    let complains = |word: &str, change: &dyn Fn(&mut Motion)| {
        let mut changed = m.clone();
        change(&mut changed);
        let found = check(&changed);
        assert!(found.wrong.iter().any(|w| w.contains(word)), "{word}: {:?}", found.wrong);
    };
    // A micrometre's bump at one set-point is a jerk that no axis may have.
    complains("jerk", &|m| m.axes.get_mut("x").unwrap()[3000] += 1e-3);
    complains("speed", &|m| m.limits.values_mut().for_each(|l| l[0] = 4.99));
    complains("acceleration", &|m| m.limits.values_mut().for_each(|l| l[1] = 1.0));
    complains("jerk", &|m| m.limits.values_mut().for_each(|l| l[2] = 1.0));
    complains("claimed", &|m| m.claim["uses"][0]["acceleration_percent"] = 0.1.into());
    complains("claimed", &|m| m.claim["uses"][1]["speed_percent"] = 99.0.into());
    complains("jerk claimed", &|m| m.claim["uses"][1]["jerk_percent"] = 23.0.into());
    complains("tip", &|m| m.claim["least_speed_mm_s"] = 5.01.into());
    complains("tip: only", &|m| m.claim["least_speed_mm_s"] = 4.9.into());
    complains("tip", &|m| m.tip[3000][0] += 1e-3);
    complains("at asked", &|m| m.claim["at_asked_percent"] = 90.0.into());
    complains("stretch", &|m| m.claim["intervals"][1]["from_mm"] = 1.0.into());
}
