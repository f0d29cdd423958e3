//! Tests of the whole axis: following error and coming to rest.

use std::f64::consts::TAU;

use seamwright_servo::{AxisState, DriveParameters, DriveTuning, Gains, LinearLoad, Notch, ServoAxis, SetPoint};

const PERIOD: f64 = 1e-3;
const BANDWIDTH: f64 = 80.0;
const COUNT: f64 = 1e-3;
const FREE: LinearLoad = LinearLoad { mass_kg: 60.0, peak_force_n: 600.0, coulomb_n: 0.0, viscous_n_s_per_m: 0.0 };
const REAL: LinearLoad = LinearLoad { coulomb_n: 40.0, viscous_n_s_per_m: 150.0, ..FREE };

fn axis(gains: Gains, load: LinearLoad, count: f64) -> ServoAxis {
    let tuning = DriveTuning {
        velocity_bandwidth_hz: BANDWIDTH,
        current_time_constant_s: 3e-4,
        current_delay_s: 0.0,
        encoder_counts_per_unit: 1.0 / count,
    };
    ServoAxis::new(gains, 300.0, DriveParameters::linear(load, tuning).unwrap(), PERIOD).unwrap()
}

fn suggested() -> Gains {
    Gains::suggested(BANDWIDTH, PERIOD)
}

fn at(position: f64) -> SetPoint {
    SetPoint { position, ..SetPoint::default() }
}

/// Rest, a smooth (cosine) acceleration to `speed` over `ramp` seconds, then constant speed.
fn ramp_up(t: f64, speed: f64, ramp: f64) -> SetPoint {
    if t < ramp {
        let w = TAU / (2.0 * ramp);
        let velocity = 0.5 * speed * (1.0 - (w * t).cos());
        let acceleration = 0.5 * speed * w * (w * t).sin();
        SetPoint { position: 0.5 * speed * (t - (w * t).sin() / w), velocity, acceleration }
    } else {
        SetPoint { position: speed * (t - 0.5 * ramp), velocity: speed, acceleration: 0.0 }
    }
}

fn run(mut axis: ServoAxis, periods: u32, set: impl Fn(f64) -> SetPoint) -> Vec<AxisState> {
    (0..periods).map(|k| axis.step(set(f64::from(k) * PERIOD), 0.0)).collect()
}

fn worst(states: &[AxisState]) -> f64 {
    states.iter().map(|state| state.following_error.abs()).fold(0.0, f64::max)
}

#[test]
fn proportional_only_follows_v_over_kp_behind() {
    for (kp, speed) in [(20.0, 50.0), (40.0, 120.0), (40.0, -7.0)] {
        let gains = Gains { kp, ..Gains::default() };
        for load in [FREE, REAL] {
            let states = run(axis(gains, load, 1e-6), 3000, |t| ramp_up(t, speed, 0.2));
            let error = states.last().unwrap().following_error;
            assert!((error - speed / kp).abs() < 2e-6, "{error}");
        }
    }
}

#[test]
fn full_velocity_feed_forward_leaves_no_error_at_constant_speed() {
    for load in [FREE, REAL] {
        for speed in [5.0, 150.0] {
            let fine = run(axis(suggested(), load, 1e-7), 2000, |t| ramp_up(t, speed, 0.2));
            assert!(worst(&fine[1500..]) < 1e-6, "{}", worst(&fine[1500..]));
            let coarse = run(axis(suggested(), load, COUNT), 2000, |t| ramp_up(t, speed, 0.2));
            assert!(worst(&coarse[1500..]) < COUNT, "{}", worst(&coarse[1500..]));
        }
    }
}

#[test]
fn acceleration_feed_forward_is_worth_a_factor_of_ten() {
    let motion = |t| ramp_up(t, 100.0, 0.1);
    let without = worst(&run(axis(Gains { kaff: 0.0, ..suggested() }, FREE, 1e-7), 200, motion));
    let with = worst(&run(axis(suggested(), FREE, 1e-7), 200, motion));
    let detuned = worst(&run(axis(Gains { kaff: 0.8 * suggested().kaff, ..suggested() }, FREE, 1e-7), 200, motion));
    assert!(with < 0.1 * without && with < 0.5 * detuned);
}

#[test]
fn the_integral_removes_a_constant_speed_error() {
    // With 3 % of the speed not fed forward, the error is v * 0.03 / kp; ki removes it.
    let gains = Gains { kvff: 0.97, ..suggested() };
    let left = run(axis(gains, REAL, 1e-7), 4000, |t| ramp_up(t, 80.0, 0.2)).last().unwrap().following_error;
    assert!((left - 0.03 * 80.0 / gains.kp).abs() < 1e-6);
    let gains = Gains { ki: 0.1 * gains.kp * gains.kp, ..gains };
    let left = run(axis(gains, REAL, 1e-7), 4000, |t| ramp_up(t, 80.0, 0.2)).last().unwrap().following_error;
    assert!(left.abs() < 1e-6);
}

#[test]
fn friction_at_the_turn_is_worked_off() {
    // A sine motion: the error jumps at the reversal, then decays.
    let turn = |t: f64| {
        let w = TAU * 0.5;
        SetPoint {
            position: 10.0 * (w * t).sin(),
            velocity: 10.0 * w * (w * t).cos(),
            acceleration: -10.0 * w * w * (w * t).sin(),
        }
    };
    let with_ki = Gains { ki: 0.25 * suggested().kp * suggested().kp, ..suggested() };
    for gains in [suggested(), with_ki] {
        let states = run(axis(gains, REAL, 1e-6), 2000, turn);
        assert!(worst(&states[450..700]) > 1e-3 && worst(&states[450..700]) < 5e-3);
        assert!(worst(&states[700..1400]) < 2e-4);
    }
}

fn rest_after_step(gains: Gains, load: LinearLoad, target: f64) -> (f64, f64) {
    let states = run(axis(gains, load, COUNT), 8000, |_| at(target));
    let tail = &states[4000..];
    let low = tail.iter().map(|s| s.position).fold(f64::MAX, f64::min);
    let high = tail.iter().map(|s| s.position).fold(f64::MIN, f64::max);
    ((high - low) / COUNT, worst(tail) / COUNT)
}

/// On the encoder's grid, between its counts, and exactly half way, where the reading toggles.
const TARGETS: [f64; 5] = [1.0, 20.0 * COUNT, 7.4 * COUNT, -3.1234, 80.5 * COUNT];

#[test]
fn a_step_settles_without_hunting() {
    for load in [FREE, REAL, LinearLoad { coulomb_n: 200.0, ..FREE }] {
        for target in TARGETS {
            let (swing, error) = rest_after_step(suggested(), load, target);
            assert!(swing < 0.2 && error < 0.5, "{} N, {target}: {swing} {error}", load.coulomb_n);
        }
    }
}

#[test]
fn integral_action_hunts_by_less_than_two_counts_where_friction_is_moderate() {
    // With stiction at a third of the peak force it is about 6 counts; therefore the suggested ki is zero.
    let kp = suggested().kp;
    let pi = Gains { ki: 0.25 * kp * kp, ..suggested() };
    let pid = Gains { ki: 0.1 * kp * kp, kd: 0.2, ..suggested() };
    for gains in [pi, pid] {
        for load in [FREE, REAL] {
            for target in TARGETS {
                let (swing, error) = rest_after_step(gains, load, target);
                assert!(swing < 2.0 && error < 1.0, "{} N, {target}: {swing} {error}", load.coulomb_n);
            }
        }
    }
}

#[test]
fn suggested_gains_do_not_overshoot_a_step_off_the_limits() {
    for load in [FREE, REAL] {
        let states = run(axis(suggested(), load, 1e-7), 1500, |_| at(0.05));
        assert!(states.iter().all(|s| !s.saturated && s.position < 0.05 * (1.0 + 1e-6)));
    }
}

#[test]
fn a_push_moves_it_and_it_comes_back() {
    let mut pushed = axis(suggested(), REAL, 1e-6);
    pushed.settle_at(2.0, 0.0);
    let states: Vec<_> = (0..600).map(|k| pushed.step(at(2.0), if k >= 100 { 120.0 } else { 0.0 })).collect();
    assert!(worst(&states[..100]) < 1e-9);
    assert!(worst(&states[100..]) > 1e-3);
    assert!(worst(&states[500..]) < 1e-5);
}

#[test]
fn a_vertical_axis_starts_without_a_sag() {
    let mut vertical = axis(suggested(), FREE, COUNT);
    vertical.settle_at(40.0, -588.0);
    for _ in 0..100 {
        assert!(vertical.step(at(40.0), -588.0).following_error.abs() < 1e-9);
    }
}

#[test]
fn times_of_the_state_belong_together() {
    let mut moving = axis(suggested(), FREE, COUNT);
    moving.settle_at(1.0, 0.0);
    let before = *moving.drive();
    let state = moving.step(SetPoint { position: 1.5, velocity: 2.0, acceleration: 0.0 }, 0.0);
    assert!(state.position.to_bits() == before.position().to_bits());
    assert!(state.velocity.to_bits() == before.velocity().to_bits());
    assert!((state.following_error - 0.5).abs() < 1e-12);
    assert!((state.measured - 1.0).abs() < 1e-12);
    assert!((state.command - (2.0 + 0.5 * suggested().kp)).abs() < 1e-9);
    assert!(state.current.to_bits() == moving.drive().current().to_bits());
}

#[test]
fn a_notch_keeps_the_axis_following_once_its_delay_is_fed_forward() {
    let notch = Notch::new(150.0, 0.1, 40.0, PERIOD).unwrap();
    let gains = Gains { kaff: suggested().kaff + notch.delay_s(), kp: 0.8 * suggested().kp, ..suggested() };
    let plain = axis(gains, REAL, 1e-7);
    let notched = plain.position_loop().with_notch(notch).unwrap();
    let notched = ServoAxis::with_loop(notched, *plain.drive().parameters()).unwrap();
    let states = run(notched, 2000, |t| ramp_up(t, 100.0, 0.2));
    assert!(worst(&states[..200]) < 0.02, "{}", worst(&states[..200]));
    assert!(worst(&states[1500..]) < 1e-6);
}
