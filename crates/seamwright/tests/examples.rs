//! The examples run, and their results agree with closed forms and quadrature.
//!
//! Run all tests of the package (`cargo test -p seamwright`): this builds the examples too.

use std::env::{self, consts::EXE_EXTENSION};
use std::f64::consts::TAU;
use std::path::Path;
use std::process::Command;

/// Returns the output of an example.
fn run(name: &str) -> String {
    // Cargo gives tests no path of examples: their folder is beside `deps`, which holds this program.
    let this = env::current_exe().unwrap();
    let folder = this.parent().and_then(Path::parent).unwrap().join("examples");
    let program = folder.join(name).with_extension(EXE_EXTENSION);
    let output = Command::new(&program).output();
    let output = output.unwrap_or_else(|e| panic!("{}: {e}; build it: cargo test -p seamwright", program.display()));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{name}: {}\n{errors}", output.status);
    String::from_utf8(output.stdout).unwrap()
}

/// Returns the first number after `label`.
fn number_after(label: &str, output: &str) -> f64 {
    let (_, rest) = output.split_once(label).unwrap_or_else(|| panic!("no “{label}” in:\n{output}"));
    let word = rest.split_whitespace().next().unwrap_or_default();
    word.parse().unwrap_or_else(|e| panic!("“{label}” {word}: {e}"))
}

/// Returns the length of a curve over a range of degrees. The chords are shorter than their arcs by less than 1e-9.
fn length(point: impl Fn(f64) -> [f64; 3], from_deg: f64, to_deg: f64) -> f64 {
    const CHORDS: u32 = 200_000;
    let at = |i: u32| point((from_deg + (to_deg - from_deg) * f64::from(i) / f64::from(CHORDS)).to_radians());
    let chord = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
    (0..CHORDS).map(|i| chord(at(i), at(i + 1))).sum()
}

/// A nozzle of radius 250 mm on a shell of radius 800 mm.
fn saddle(phi: f64) -> [f64; 3] {
    let (sin, cos) = phi.sin_cos();
    [250.0 * cos, 250.0 * sin, (800.0_f64.powi(2) - (250.0 * sin).powi(2)).sqrt()]
}

/// The weld of the example job `ellipse`: once around, and 5 mm of overlap.
fn ellipse_weld() -> f64 {
    length(|phi| [20.0 * phi.cos(), 16.0 * phi.sin(), 0.0], 0.0, TAU.to_degrees()) + 5.0
}

/// Asserts that `time` is that of `length` at `speed`, with less than `extra` s for acceleration and deceleration.
fn assert_travel(time: f64, length: f64, speed: f64, extra: f64) {
    let steady = length / speed;
    assert!(time > steady && time < steady + extra, "{time} s, {steady} s at a steady speed");
}

#[test]
fn seam_has_the_length_of_the_intersection() {
    let printed = number_after("length:", &run("seam"));
    let expected = length(saddle, 0.0, 360.0);
    assert!((printed - expected).abs() < 1e-3, "{printed} {expected}");
}

#[test]
fn plan_keeps_the_speed_of_the_job() {
    let output = run("plan");
    let (length_mm, expected) = (number_after("pass 1:", &output), length(saddle, 0.0, 360.0) + 20.0);
    assert!((length_mm - expected).abs() < 0.01, "{length_mm} {expected}");
    assert_travel(number_after("mm in", &output), expected, 10.0, 0.5);
}

#[test]
fn post_has_the_arc_on_for_travel_start_and_crater() {
    // Start and crater fill take 0.5 s each.
    assert_travel(number_after("arc on:", &run("post")) - 1.0, ellipse_weld(), 5.0, 0.2);
}

#[test]
fn own_machine_accelerates_by_its_own_jerk() {
    let output = run("own_machine");
    // From rest to speed v with jerk j takes 2 sqrt(v / j), over half the distance of a steady speed. The start is along
    // an axis, whose jerk is that of the path there.
    let expected = ellipse_weld() / 5.0 + 2.0 * (5.0_f64 / 2000.0).sqrt();
    let time = number_after("time:", &output);
    assert!((time - expected).abs() < 5e-3, "{time} {expected}");
    assert!((number_after("axis x: -20.000 to", &output) - 20.0).abs() < 1e-3, "{output}");
    assert!((number_after("axis y: -16.000 to", &output) - 16.0).abs() < 1e-3, "{output}");
}

#[test]
fn simulate_follows_the_seam_in_the_planned_time() {
    let output = run("simulate");
    assert_travel(number_after("travel time:", &output), length(saddle, 280.0, 340.0), 10.0, 0.5);
    assert!(number_after("path error:", &output) < 0.5, "{output}");
}
