use super::*;

const PERIOD: f64 = 1e-3;

fn position_loop(gains: Gains) -> PositionLoop {
    PositionLoop::new(gains, PERIOD, 100.0).unwrap()
}

fn at(position: f64) -> SetPoint {
    SetPoint { position, ..SetPoint::default() }
}

#[test]
fn each_term_by_itself() {
    let set = SetPoint { position: 2.0, velocity: 30.0, acceleration: 400.0 };
    let alone = |gains: Gains| position_loop(gains).update(set, 1.5);
    let zero = Gains::default();
    assert!((alone(Gains { kp: 20.0, ..zero }) - 10.0).abs() < 1e-12);
    assert!((alone(Gains { ki: 400.0, ..zero }) - 0.2).abs() < 1e-12);
    assert!((alone(Gains { kvff: 0.9, ..zero }) - 27.0).abs() < 1e-12);
    assert!((alone(Gains { kaff: 0.01, ..zero }) - 4.0).abs() < 1e-12);
    // The rate is unknown at the first update.
    assert!(alone(Gains { kd: 1.0, ..zero }).abs() < 1e-12);
}

#[test]
fn the_derivative_is_the_filtered_rate_of_the_error() {
    let mut derivative = position_loop(Gains { kd: 0.5, ..Gains::default() });
    for k in 0..200 {
        // A ramp of 8 u/s; the filter's answer to it is 8 (1 - (4/5)^k).
        let command = derivative.update(at(8.0 * PERIOD * f64::from(k)), 0.0);
        assert!((command - 0.5 * 8.0 * (1.0 - 0.8_f64.powi(k))).abs() < 1e-9);
    }
}

#[test]
fn the_integral_removes_what_friction_leaves() {
    // A plant that loses 5 u/s of its command to friction, as a drive without integral action.
    let settle = |ki: f64| {
        let mut looped = position_loop(Gains { kp: 20.0, ki, kvff: 1.0, ..Gains::default() });
        let mut position = 0.0;
        let mut error = 0.0;
        for k in 0..5000 {
            let set = SetPoint { position: 40.0 * PERIOD * f64::from(k), velocity: 40.0, acceleration: 0.0 };
            error = set.position - position;
            position += (looped.update(set, position) - 5.0) * PERIOD;
        }
        error
    };
    assert!((settle(0.0) - 5.0 / 20.0).abs() < 1e-9);
    assert!(settle(80.0).abs() < 1e-9);
}

#[test]
fn no_wind_up_while_the_command_is_limited() {
    let mut looped = position_loop(Gains { kp: 10.0, ki: 1000.0, ..Gains::default() });
    for _ in 0..10_000 {
        assert!((looped.update(at(500.0), 0.0) - 100.0).abs() < 1e-12);
        assert!(looped.limited());
    }
    // The sum still has its value from before the limit: zero.
    assert!(looped.update(at(0.0), 0.0).abs() < 1e-12);
    assert!(!looped.limited());
    // Inside the limit the sum grows up to it, and shrinks as soon as the error changes its sign.
    for _ in 0..10_000 {
        looped.update(at(1.0), 0.0);
    }
    assert!(looped.update(at(0.0), 0.0) <= 100.0);
    assert!(looped.update(at(-1.0), 0.0) < 90.0);
}

#[test]
fn inputs_that_are_no_numbers_stop_the_axis_and_leave_the_memory_alone() {
    let gains = Gains { kp: 10.0, ki: 50.0, kd: 0.1, kvff: 1.0, kaff: 0.01 };
    let mut looped = position_loop(gains).with_notch(Notch::new(90.0, 0.1, 20.0, PERIOD).unwrap()).unwrap();
    looped.update(at(1.0), 0.5);
    let mut bad = looped;
    for (set, measured) in [
        (at(f64::NAN), 0.0),
        (at(0.0), f64::INFINITY),
        (SetPoint { velocity: f64::NAN, ..at(0.0) }, 0.0),
        (SetPoint { acceleration: f64::NEG_INFINITY, ..at(0.0) }, 0.0),
    ] {
        assert!(bad.update(set, measured) == 0.0);
        assert!(bad.limited());
    }
    assert!(bad.update(at(1.0), 0.6).to_bits() == looped.update(at(1.0), 0.6).to_bits());
    for huge in [f64::MAX, -f64::MAX] {
        let command = bad.update(SetPoint { position: huge, velocity: -huge, acceleration: 0.0 }, 0.0);
        assert!(command.abs() <= 100.0);
    }
}

#[test]
fn reset_makes_it_new() {
    let gains = Gains { kp: 10.0, ki: 50.0, kd: 0.1, kvff: 1.0, kaff: 0.01 };
    let new = position_loop(gains).with_notch(Notch::new(90.0, 0.1, 20.0, PERIOD).unwrap()).unwrap();
    let mut used = new;
    for _ in 0..10 {
        used.update(at(3.0), 1.0);
    }
    assert!(used != new);
    used.reset();
    assert!(used == new);
}

#[test]
fn the_notch_acts_on_the_command_within_the_limit() {
    let notch = Notch::new(50.0, 0.0, 10.0, PERIOD).unwrap();
    let mut looped = position_loop(Gains { kp: 10.0, ..Gains::default() }).with_notch(notch).unwrap();
    let mut largest = 0.0_f64;
    for k in 0..4000 {
        let command = looped.update(at((TAU * 50.0 * PERIOD * f64::from(k)).sin()), 0.0);
        if k > 3000 {
            largest = largest.max(command.abs());
        }
    }
    assert!(largest < 1e-6);
    for k in 0..200 {
        let command = looped.update(at(if k % 20 < 10 { 50.0 } else { -50.0 }), 0.0);
        assert!(command.abs() <= 100.0);
    }
}

#[test]
fn nonsense_is_refused() {
    for gains in [Gains { kp: -1.0, ..Gains::default() }, Gains { kaff: f64::NAN, ..Gains::default() }] {
        assert!(PositionLoop::new(gains, PERIOD, 1.0).is_err());
    }
    assert!(PositionLoop::new(Gains::default(), 0.0, 1.0).is_err());
    let other = Notch::new(50.0, 0.0, 10.0, 0.5 * PERIOD).unwrap();
    assert!(position_loop(Gains::default()).with_notch(other).is_err());
    assert!(PositionLoop::new(Gains::default(), PERIOD, 0.0).is_err());
    assert!(PositionLoop::new(Gains::suggested(0.0, PERIOD), PERIOD, 1.0).is_err());
    assert!(PositionLoop::new(Gains::suggested(f64::NAN, PERIOD), PERIOD, 1.0).is_err());
}
