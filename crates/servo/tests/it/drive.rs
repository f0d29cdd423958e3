//! Tests of the simulated drive against closed forms and against other sub-steps.

use std::f64::consts::TAU;

use seamwright_servo::{Drive, DriveParameters, DriveTuning, LinearLoad, RotaryLoad};

const PERIOD: f64 = 1e-3;
const BANDWIDTH: f64 = 100.0;
const FREE: LinearLoad = LinearLoad { mass_kg: 50.0, peak_force_n: 500.0, coulomb_n: 0.0, viscous_n_s_per_m: 0.0 };

fn linear(load: LinearLoad, current_time_constant_s: f64) -> DriveParameters {
    let tuning = DriveTuning {
        velocity_bandwidth_hz: BANDWIDTH,
        current_time_constant_s,
        current_delay_s: 0.0,
        encoder_counts_per_unit: 1000.0,
    };
    DriveParameters::linear(load, tuning).unwrap()
}

/// Speed after 10 ms under a small step of the command that never reaches the peak.
fn speed_after_step(current_time_constant_s: f64, sub_steps: u32) -> f64 {
    let mut drive = Drive::with_sub_steps(linear(FREE, current_time_constant_s), PERIOD, sub_steps).unwrap();
    for _ in 0..4 {
        drive.step(1.0, 0.0, 0.0);
        assert!(!drive.limited());
    }
    drive.velocity()
}

#[test]
fn the_speed_follows_a_small_step_as_a_first_order_lag() {
    let w = TAU * BANDWIDTH;
    let exact = 1.0 - (-w * 4.0 * PERIOD).exp();
    let error = |sub_steps| (speed_after_step(0.0, sub_steps) - exact).abs();
    assert!(error(4000) < 1e-4);
    // First order in the sub-step, as the velocity loop is sampled.
    for sub_steps in [32, 64, 128] {
        let ratio = error(sub_steps) / error(2 * sub_steps);
        assert!((1.9..2.1).contains(&ratio), "{ratio}");
    }
    // The number of sub-steps chosen by Drive::new.
    assert!(error(13) < 0.02);
}

#[test]
fn halving_the_sub_step_halves_the_change_with_a_current_lag_and_friction() {
    let load = LinearLoad { coulomb_n: 20.0, viscous_n_s_per_m: 200.0, ..FREE };
    let way = |sub_steps| {
        let mut drive = Drive::with_sub_steps(linear(load, 3e-4), PERIOD, sub_steps).unwrap();
        for k in 0..50 {
            drive.step(5.0 * (TAU * 20.0 * PERIOD * f64::from(k)).sin(), 0.0, 30.0);
        }
        drive.position()
    };
    let (a, b, c, d) = (way(64), way(128), way(256), way(512));
    let (first, second) = ((a - b) / (b - c), (b - c) / (c - d));
    assert!((1.7..2.3).contains(&first) && (1.7..2.3).contains(&second), "{first} {second}");
}

#[test]
fn saturated_start_follows_the_lagged_peak_exactly() {
    // With the demand at the peak all the way, v = a (t - tau (1 - exp(-t / tau))) for any sub-step.
    let (tau, peak) = (3e-4_f64, 10_000.0);
    for sub_steps in [1, 3, 20] {
        let mut drive = Drive::with_sub_steps(linear(FREE, tau), PERIOD, sub_steps).unwrap();
        for k in 1..=10 {
            drive.step(1000.0, 0.0, 0.0);
            let t = f64::from(k) * PERIOD;
            let velocity = peak * (t + tau * (-t / tau).exp_m1());
            assert!((drive.velocity() - velocity).abs() < 1e-9);
            assert!(drive.limited() && (drive.current() + (-t / tau).exp_m1()).abs() < 1e-12);
        }
    }
}

#[test]
fn position_is_second_order_between_current_updates() {
    // Same motion: x = a (t^2/2 - tau t + tau^2 (1 - exp(-t/tau))).
    let (tau, peak, t) = (3e-4_f64, 10_000.0, 1e-3);
    let exact = peak * (0.5 * t * t - tau * t - tau * tau * (-t / tau).exp_m1());
    let error = |sub_steps| {
        let mut drive = Drive::with_sub_steps(linear(FREE, tau), PERIOD, sub_steps).unwrap();
        drive.step(1000.0, 0.0, 0.0);
        (drive.position() - exact).abs()
    };
    for sub_steps in [8, 16, 32] {
        let ratio = error(sub_steps) / error(2 * sub_steps);
        assert!((3.8..4.2).contains(&ratio), "{ratio}");
    }
}

#[test]
fn a_constant_force_is_worked_off() {
    for (load, force) in [(FREE, 300.0), (LinearLoad { coulomb_n: 40.0, ..FREE }, -250.0)] {
        let mut drive = Drive::new(linear(load, 2e-4), PERIOD).unwrap();
        for _ in 0..200 {
            drive.step(20.0, 0.0, force);
        }
        assert!((drive.velocity() - 20.0).abs() < 1e-6);
        assert!((drive.current() - (load.coulomb_n - force) / 500.0).abs() < 1e-6);
    }
}

#[test]
fn acceleration_never_beyond_the_peak_and_no_overshoot_out_of_the_limit() {
    let mut drive = Drive::new(linear(FREE, 2e-4), PERIOD).unwrap();
    let (peak, mut before, mut fastest, mut limited) = (10_000.0, 0.0, 0.0_f64, false);
    for k in 0..400 {
        let command = if k < 200 { 300.0 } else { -300.0 };
        drive.step(command, 0.0, 0.0);
        assert!((drive.velocity() - before).abs() <= peak * PERIOD * (1.0 + 1e-12));
        assert!(drive.current().abs() <= 1.0);
        before = drive.velocity();
        fastest = fastest.max(drive.velocity().abs());
        limited |= drive.limited();
    }
    assert!(limited);
    assert!(fastest < 300.0 * 1.005, "{fastest}");
    assert!((drive.velocity() + 300.0).abs() < 1e-3);
}

#[test]
fn held_by_friction_it_does_not_move_at_all() {
    let load = RotaryLoad { inertia_kg_m2: 2.0, peak_torque_nm: 80.0, coulomb_nm: 5.0, viscous_nm_s_per_rad: 3.0 };
    let tuning = DriveTuning {
        velocity_bandwidth_hz: 60.0,
        current_time_constant_s: 3e-4,
        current_delay_s: 0.0,
        encoder_counts_per_unit: 1e5,
    };
    let parameters = DriveParameters::rotary(load, tuning).unwrap();
    let mut drive = Drive::new(parameters, PERIOD).unwrap();
    drive.settle_at(0.7, 0.0);
    for k in 0..1000 {
        drive.step(0.0, 0.0, 5.0 * f64::from(k).sin());
        assert!(drive.position().to_bits() == 0.7_f64.to_bits() && drive.velocity() == 0.0);
    }
    // A force just above friction moves it, as no current holds it.
    drive.step(0.0, 0.0, 5.01);
    assert!(drive.position() > 0.7);
}

#[test]
fn a_weight_is_held_from_the_start() {
    let mut drive = Drive::new(linear(FREE, 2e-4), PERIOD).unwrap();
    drive.settle_at(3.0, -490.0);
    for _ in 0..100 {
        drive.step(0.0, 0.0, -490.0);
    }
    assert!((drive.position() - 3.0).abs() < 1e-12 && (drive.current() - 0.98).abs() < 1e-12);
}

#[test]
fn inputs_that_are_no_numbers_count_as_zero() {
    let mut bad = Drive::new(linear(FREE, 2e-4), PERIOD).unwrap();
    bad.step(50.0, 0.0, 10.0);
    let mut good = bad;
    bad.step(f64::NAN, 0.0, f64::INFINITY);
    good.step(0.0, 0.0, 0.0);
    assert!(bad == good);
}

#[test]
fn periods_out_of_reach_are_refused() {
    assert!(Drive::new(linear(FREE, 2e-4), 0.0).is_err());
    assert!(Drive::new(linear(FREE, 2e-4), f64::NAN).is_err());
    assert!(Drive::with_sub_steps(linear(FREE, 2e-4), PERIOD, 0).is_err());
    let tuning = DriveTuning {
        velocity_bandwidth_hz: 1e4,
        current_time_constant_s: 0.0,
        current_delay_s: 0.0,
        encoder_counts_per_unit: 1.0,
    };
    assert!(Drive::new(DriveParameters::linear(FREE, tuning).unwrap(), 1.0).is_err());
}
