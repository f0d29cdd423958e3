//! The simulated cell on the example saddle: repeatable, with realistic drives.

use crate::common::simulated;
use seamwright_executive::Mode;
use seamwright_machine::{Machine, shipped};
use seamwright_program::TorchPath;
use seamwright_simulation::{Conditions, Error, Sample, Summary};
use seamwright_weld::Welding;

fn run(machine_text: &str, seed: u64) -> Result<(Summary, Vec<Sample>), Error> {
    run_job(include_str!("../../../../examples/ellipse.toml"), machine_text, seed)
}

fn run_job(job: &str, machine_text: &str, seed: u64) -> Result<(Summary, Vec<Sample>), Error> {
    let welding = Welding::read("job.toml", job).unwrap();
    let (program, path) = (&welding.program.value, welding.path(0));
    let machine = Machine::read("m.toml", machine_text).unwrap();
    let conditions = Conditions { seed, ..Conditions::default() };
    let (_, mut summaries, samples) = simulated(&machine, &[(&path, &program.passes[0])], conditions)?;
    Ok((summaries.remove(0), samples))
}

fn shipped_text() -> &'static str {
    shipped("ellipse-xy").unwrap().text
}

#[test]
fn good_drives_weld_well_and_repeatably() {
    let (summary, samples) = run(shipped_text(), 1).unwrap();
    println!("{summary:#?}");
    assert!(summary.path_error_mm.max < 0.05 && summary.path_error_mm.max > 0.0);
    assert!(summary.speed_ripple.unwrap() < 0.06, "{:?}", summary.speed_ripple);
    let (again, same) = run(shipped_text(), 1).unwrap();
    // During transfer moves some values are NaN, which equals nothing.
    let welded = |samples: &[Sample]| format!("{:?}", samples.iter().filter(|s| s.pass > 0).collect::<Vec<_>>());
    assert!(summary == again && welded(&samples) == welded(&same));
    let (other, _) = run(shipped_text(), 2).unwrap();
    assert!(other != summary);
}

#[test]
fn the_summary_is_that_of_the_samples() {
    let (summary, samples) = run(shipped_text(), 1).unwrap();
    let worst = samples.iter().filter(|s| s.travels()).map(|s| s.path_error).fold(0.0, f64::max);
    assert!((summary.path_error_mm.max - worst).abs() < 1e-15);
    let x: Vec<f64> = samples.iter().filter(|s| s.arc()).map(|s| s.following_error[0]).collect();
    let rms = (x.iter().map(|e| e * e).sum::<f64>() / x.len() as f64).sqrt();
    assert!((summary.axes[0].following_error.rms - rms).abs() < 1e-15);
    let arc = samples.iter().filter(|s| s.arc()).count() as f64 * 1e-3;
    assert!((summary.arc_on_s - arc).abs() < 2e-3);
    // True positions differ from the set-points by the following error.
    assert!(samples.iter().all(|s| (s.set.q[0] - s.q[0] - s.following_error[0]).abs() < 1e-12));
}

#[test]
fn worse_drives_weld_worse() {
    // Slow enough that the following error stays below the trip limit of the cell: 1 mm at rest.
    let slow = |text: &str| text.replace("max_speed_mm_s = 100", "max_speed_mm_s = 6");
    let soft = slow(shipped_text()).replace("velocity_bandwidth_hz = 40", "velocity_bandwidth_hz = 8\nkp_per_s = 10");
    let (good, _) = run(&slow(shipped_text()), 1).unwrap();
    let (bad, _) = run(&soft, 1).unwrap();
    assert!(bad.path_error_mm.max > 5.0 * good.path_error_mm.max);
    // A pure proportional loop lags by speed / Kp, here 0.5 mm, and oscillates with a slow velocity loop.
    assert!((bad.axes[0].following_error.max - 0.5).abs() < 0.2, "{:?}", bad.axes[0].following_error);
}

/// Drives that lag by more than a millimetre trip the cell before anything is welded.
#[test]
fn drives_that_do_not_follow_are_no_drives() {
    let soft = shipped_text().replace("velocity_bandwidth_hz = 40", "velocity_bandwidth_hz = 5\nkp_per_s = 5");
    let (summary, samples) = run(&soft, 1).unwrap();
    assert!(!summary.welded && samples.last().unwrap().mode == Mode::Fault, "{summary:?}");
    assert!(samples.iter().all(|s| !s.arc()));
}

#[test]
fn impossible_drives_are_refused() {
    let text = shipped_text().replace("velocity_bandwidth_hz = 40", "velocity_bandwidth_hz = 4000");
    assert!(run(&text, 1).unwrap_err().to_string().starts_with("drive of axis x"));
}

/// A woven weld is evaluated by its distance from the woven path, found by brute force here, and by its speed along
/// the seam.
#[test]
fn a_woven_weld_is_judged_by_its_woven_path() {
    let (job, machine) = (include_str!("../../../../examples/weave.toml"), shipped("torch-5axis").unwrap().text);
    let (summary, samples) = run_job(job, machine, 1).unwrap();
    let (welding, machine) = (Welding::read("job.toml", job).unwrap(), Machine::read("m", machine).unwrap());
    let path = welding.path(0);
    for sample in samples.iter().filter(|s| s.travels()).step_by(499) {
        let tip = machine.forward(&sample.q).point;
        let near = (-4000..=4000).map(|i| (sample.set.profile.s + 5e-5 * f64::from(i)).clamp(0.0, path.length()));
        let least = near.map(|s| path.pose(s).point.distance(tip)).fold(f64::INFINITY, f64::min);
        assert!((sample.path_error - least).abs() < 1e-3, "{}: {} {least}", sample.set.profile.s, sample.path_error);
        assert!((sample.tip_s - sample.set.profile.s).abs() < 0.05, "{sample:?}");
    }
    let speed = summary.tip_speed_mm_s.unwrap();
    assert!(speed.min > 2.2 && speed.max < 2.8 && summary.path_error_mm.max < 0.05, "{summary:#?}");
}
