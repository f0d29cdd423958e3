//! Speed and process values at several stations of a weld.

use crate::jobs::{read, refusal};
use seamwright_program::ArcTime;

const SADDLE: &str = include_str!("../../../../examples/t-joint.toml");

fn job(at: &str) -> String {
    format!("{SADDLE}\n{at}")
}

fn rows(text: &str) -> Vec<(f64, f64)> {
    text.split(' ')
        .map(|pair| pair.split_once(':').unwrap())
        .map(|(s, v)| (s.parse().unwrap(), v.parse().unwrap()))
        .collect()
}

/// Value between rows, found by walking along them.
fn walked(rows: &[(f64, f64)], s: f64) -> f64 {
    let mut value = rows[0].1;
    for pair in rows.windows(2) {
        let part = ((s - pair[0].0) / (pair[1].0 - pair[0].0)).clamp(0.0, 1.0);
        value += part * (pair[1].1 - pair[0].1);
    }
    value
}

#[test]
fn values_are_linear_between_stations() {
    let plain = read(SADDLE);
    let name = plain.program.value.passes[0].spans[0].process.keys().next().unwrap().clone();
    let (speeds, values) = (rows("10:8 25.5:12 60:9"), rows("10:100 40:140"));
    let at = format!(
        "[[weld.at]]\ns_mm = 10\nspeed_mm_s = 8\nprocess = {{ {name} = 100 }}\n[[weld.at]]\ns_mm = 25.5\nspeed_mm_s = 12\n\
         [[weld.at]]\ns_mm = 40\nprocess = {{ {name} = 140 }}\n[[weld.at]]\ns_mm = 60\nspeed_mm_s = 9\n"
    );
    let welding = read(&job(&at));
    let pass = &welding.program.value.passes[0];
    assert!((pass.length() - plain.program.value.passes[0].length()).abs() < 1e-9);
    for i in 0..500 {
        let s = pass.length() * f64::from(i) / 499.0;
        assert!((pass.speed_at(s) - walked(&speeds, s)).abs() < 1e-9, "{s}");
        assert!((pass.process_at(&name, s, ArcTime::TRAVEL).unwrap() - walked(&values, s)).abs() < 1e-9, "{s}");
    }
}

#[test]
fn wrong_stations_have_an_address() {
    let key = |at: &str| refusal(&job(at)).key;
    assert_eq!(key("[[weld.at]]\ns_mm = 1e5\n"), "weld.at[0].s_mm");
    assert_eq!(key("[[weld.at]]\ns_mm = 5\n[[weld.at]]\ns_mm = 5\n"), "weld.at[1].s_mm");
    assert_eq!(key("[[weld.at]]\ns_mm = 5\nspeed_mm_s = 0\n"), "weld.at[0].speed_mm_s");
    assert_eq!(key("[[weld.at]]\ns_mm = 5\nprocess = { nothing_a = 5 }\n"), "weld.at[0].process.nothing_a");
    assert_eq!(key("[[weld.at]]\ns_mm = 5\nspeed = 5\n"), "weld.at[0].speed");
}
