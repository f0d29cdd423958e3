//! The example saddle on drives with resonance, backlash, friction and dead time, all axes tuned: deviation of the
//! torch.

// Helpers of tests are tests too, but clippy.toml lets only the #[test] functions unwrap.
#![allow(clippy::unwrap_used)]

use crate::common::simulated;
use seamwright_machine::{Machine, shipped};
use seamwright_simulation::{Conditions, Summary, tune_axis};
use seamwright_weld::Welding;

/// Returns the shipped saddle welder with elastic drives. The first mode of the whole box is the lowest.
fn elastic() -> String {
    let mut text = shipped("saddle-4axis").unwrap().text.to_owned();
    for (axis, keys) in [
        (
            "theta",
            "resonance_hz = 32\nload_ratio = 3\nresonance_damping = 0.03\nbacklash_deg = 0.002\nencoder_on = \"load\"",
        ),
        ("s", "resonance_hz = 55\nload_ratio = 2\nbacklash_mm = 0.01\nmotor_friction = 0.5"),
        ("h", "resonance_hz = 70\nload_ratio = 1.5\nbacklash_mm = 0.008\nmotor_friction = 0.5"),
        (
            "beta",
            "resonance_hz = 45\nload_ratio = 0.8\nresonance_damping = 0.04\nbacklash_deg = 0.01\nmotor_friction = 0.6",
        ),
    ] {
        let table = format!("[drives.{axis}]\n");
        assert!(text.contains(&table));
        text = text.replacen(&table, &format!("{table}{keys}\ncurrent_delay_ms = 0.125\n"), 1);
    }
    text
}

fn tuned(mut machine: Machine) -> Machine {
    for axis in &mut machine.axes {
        let found = tune_axis(axis, machine.servo_period_s).unwrap();
        assert!(found.margins.reach(6.0, 35.0) && found.following_counts <= 1.0, "{}", axis.name);
        let drive = axis.drive.as_mut().unwrap();
        drive.velocity_bandwidth_hz = found.velocity_bandwidth_hz;
        drive.gains = Some(found.gains);
        drive.notches = found.notches;
        drive.friction_compensation = found.friction;
        drive.backlash_compensation = found.backlash;
    }
    machine
}

fn weld(machine: &Machine) -> Summary {
    let welding = Welding::read("saddle", include_str!("../../../../examples/saddle.toml")).unwrap();
    assert!((welding.program.value.passes[0].speed_at(0.0) - 10.0).abs() < 1e-9);
    let (path, pass) = (welding.path(0), &welding.program.value.passes[0]);
    simulated(machine, &[(&path, pass)], Conditions::default()).unwrap().1.remove(0)
}

#[test]
fn a_tuned_elastic_machine_stays_near_the_seam() {
    let machine = Machine::read("m.toml", &elastic()).unwrap();
    let untuned = weld(&machine);
    let summary = weld(&tuned(machine));
    println!("{:?} {:?}", untuned.path_error_mm, summary.path_error_mm);
    for axis in &summary.axes {
        println!("{} {:?} current {}", axis.axis, axis.following_error, axis.current);
    }
    // A hundredth of a millimetre all along. A thousandth more in the first hundredths of a millimetre, where axes
    // that came from the other side break away.
    assert!(summary.path_error_mm.max <= 0.012, "{:?} at {}", summary.path_error_mm, summary.path_error_at_mm);
    // Without tuning, lost motion alone is more than that.
    assert!(untuned.path_error_mm.max > 2.0 * summary.path_error_mm.max, "{:?}", untuned.path_error_mm);
}
