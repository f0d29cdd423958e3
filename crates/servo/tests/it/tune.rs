//! Tuning of thousands of random drives: the margins hold, or the error gives the reason.

use std::f64::consts::TAU;

use seamwright_servo::{
    DriveParameters, DriveTuning, EncoderSide, Error, LinearLoad, REQUIRED, ServoAxis, SetPoint, Transmission, Tuned,
    tune,
};
use seamwright_testkit::{Random, cases};

const PERIOD: f64 = 1e-3;
const MAX_SPEED: f64 = 50.0;

fn random_drive(random: &mut Random) -> (DriveParameters, String) {
    let mass_kg = random.decades(5.0, 500.0);
    let peak_force_n = mass_kg * random.decades(2.0, 20.0);
    let hz = random.decades(15.0, 120.0);
    let (lag, delay) = (random.decades(0.1, 1.0), random.decades(0.1, 1.0));
    let part = 0.24 / (TAU * hz * (lag + delay) * 1e-3);
    let part = part.min(random.decades(0.2, 1.0));
    let tuning = DriveTuning {
        velocity_bandwidth_hz: hz,
        current_time_constant_s: part * lag * 1e-3,
        current_delay_s: part * delay * 1e-3,
        encoder_counts_per_unit: random.decades(500.0, 10_000.0),
    };
    let (ratio, resonance, damping) =
        (random.decades(0.2, 10.0), random.decades(15.0, 300.0), random.decades(0.005, 0.1));
    let load = LinearLoad {
        mass_kg,
        peak_force_n,
        coulomb_n: peak_force_n * 0.1 * random.unit(),
        viscous_n_s_per_m: mass_kg * 5.0 * random.unit(),
    };
    let drive = DriveParameters::linear(load, tuning).unwrap();
    if random.chance(0.2) {
        return (drive, format!("{load:?} {tuning:?}"));
    }
    let transmission = Transmission {
        resonance_hz: resonance,
        damping,
        load_ratio: ratio,
        backlash: if random.chance(0.3) { 0.01 * random.unit() } else { 0.0 },
        motor_friction: random.unit(),
        encoder_on: if random.chance(0.5) { EncoderSide::Motor } else { EncoderSide::Load },
    };
    (drive.with_transmission(transmission).unwrap(), format!("{load:?} {tuning:?} {transmission:?}"))
}

#[test]
fn random_drives_have_their_margins_or_say_why_not() {
    let mut random = Random::new(21);
    let mut refused = 0;
    for case in 0..cases(24) {
        let (drive, text) = random_drive(&mut random);
        match tune(&drive, PERIOD, MAX_SPEED) {
            Ok(tuned) => {
                assert!(tuned.margins.reach(REQUIRED.0, REQUIRED.1), "{case} {text}: {:?}", tuned.margins);
                assert!(tuned.following_counts <= 1.0, "{case} {text}: {}", tuned.following_counts);
                assert!(tuned.velocity_bandwidth_hz <= drive.velocity_bandwidth_hz() && tuned.notches.len() <= 2);
                // It comes to rest within half a count, a count of backlash in the loop, and stiction.
                comes_to_rest(&tuned, &drive, &format!("{case} {text}"));
            }
            Err(error) => {
                assert!(
                    !matches!(error, Error::OutOfRange { .. } | Error::TooManyNotches { .. }),
                    "{case} {error}: {text}"
                );
                // A rigid axis can always be tuned.
                assert!(drive.transmission().is_some(), "{case} {error}: {text}");
                refused += 1;
            }
        }
    }
    assert!(refused <= 1 + cases(24) / 50);
}

fn comes_to_rest(tuned: &Tuned, drive: &DriveParameters, text: &str) {
    let drive = drive.with_velocity_bandwidth(tuned.velocity_bandwidth_hz).unwrap();
    let mut axis = ServoAxis::with_loop(tuned.position_loop(PERIOD, MAX_SPEED).unwrap(), drive).unwrap();
    let count = drive.encoder().count();
    let target = (20.0 * count).max(0.01);
    let set = SetPoint { position: target, ..SetPoint::default() };
    for k in 0..12_000 {
        axis.step(set, 0.0);
        let error = axis.position_loop().error().abs();
        assert!(error <= 2.0 * target, "{text}: {error}");
        // Friction holds the axis until the drive's integrator has grown; the load may rattle within the gap.
        let gap = drive.transmission().map_or(0.0, |t| t.backlash);
        assert!(k < 11_000 || error <= 0.25 * target + 2.0 * count + gap, "{text}: {error} of {target}");
    }
}

#[test]
fn tuning_is_repeatable() {
    let (drive, _) = random_drive(&mut Random::new(7));
    assert!(tune(&drive, PERIOD, MAX_SPEED) == tune(&drive, PERIOD, MAX_SPEED));
}

const LOAD: LinearLoad = LinearLoad { mass_kg: 40.0, peak_force_n: 800.0, coulomb_n: 30.0, viscous_n_s_per_m: 100.0 };
const TUNING: DriveTuning = DriveTuning {
    velocity_bandwidth_hz: 50.0,
    current_time_constant_s: 2e-4,
    current_delay_s: 1.25e-4,
    encoder_counts_per_unit: 2000.0,
};
const ELASTIC: Transmission = Transmission {
    resonance_hz: 60.0,
    damping: 0.02,
    load_ratio: 2.0,
    backlash: 0.01,
    motor_friction: 0.5,
    encoder_on: EncoderSide::Motor,
};

#[test]
fn what_it_measures_is_what_is_there() {
    let drive = DriveParameters::linear(LOAD, TUNING).unwrap();
    let rigid = tune(&drive, PERIOD, MAX_SPEED).unwrap();
    assert!(rigid.resonance_hz.is_none() && rigid.backlash.is_none() && rigid.notches.is_empty(), "{rigid:?}");
    assert!((rigid.friction.unwrap().force - 30.0).abs() < 0.1);
    // Lag of the velocity loop, and half a period of hold.
    let lag = 1.0 / (TAU * 50.0) + 0.5 * PERIOD;
    assert!((rigid.gains.kaff / lag - 1.0).abs() < 0.05, "{} {lag}", rigid.gains.kaff);

    let elastic = tune(&drive.with_transmission(ELASTIC).unwrap(), PERIOD, MAX_SPEED).unwrap();
    assert!((elastic.resonance_hz.unwrap() / 60.0 - 1.0).abs() < 0.03, "{:?}", elastic.resonance_hz);
    // The gap, and the wind-up under the load's half of the friction, once either way. Viscous friction (50 N s/m at
    // the creeping 1 mm/s) is negligible.
    let w = TAU * 60.0;
    let stiffness_n_per_mm = 40.0 * w * w * 2.0 / 9.0 / 1000.0;
    let lost = 0.01 + 2.0 * 15.0 / stiffness_n_per_mm;
    assert!((elastic.backlash.unwrap().width - lost).abs() < 1e-3, "{:?} {lost}", elastic.backlash);
    let seen = Transmission { encoder_on: EncoderSide::Load, backlash: 0.0, ..ELASTIC };
    let seen = tune(&drive.with_transmission(seen).unwrap(), PERIOD, MAX_SPEED).unwrap();
    assert!(seen.backlash.is_none() && !seen.notches.is_empty());
}

#[test]
fn compensation_takes_the_lost_motion_and_the_friction_out_of_a_reversal() {
    let drive = DriveParameters::linear(LOAD, TUNING).unwrap().with_transmission(ELASTIC).unwrap();
    let with = tune(&drive, PERIOD, MAX_SPEED).unwrap();
    let without = Tuned { friction: None, backlash: None, ..with.clone() };
    let worst = |tuned: &Tuned| {
        let mut axis = ServoAxis::with_loop(tuned.position_loop(PERIOD, MAX_SPEED).unwrap(), drive).unwrap();
        let w = TAU * 0.25;
        let state = |k: u32| {
            let t = f64::from(k) * PERIOD;
            let (sine, cosine) = (w * t).sin_cos();
            axis.step(
                SetPoint { position: 5.0 * sine, velocity: 5.0 * w * cosine, acceleration: -5.0 * w * w * sine },
                0.0,
            )
        };
        let errors: Vec<f64> = (0..12_000).map(state).map(|s| s.following_error.abs()).collect();
        errors[4000..].iter().fold(0.0, |worst: f64, e| worst.max(*e))
    };
    let (bad, good) = (worst(&without), worst(&with));
    assert!(bad > 0.015 && good < 0.7 * bad, "{bad} {good}");
}

#[test]
fn what_cannot_be_tuned_is_refused_with_its_reason() {
    let drive = DriveParameters::linear(LOAD, TUNING).unwrap();
    for (period, speed) in [(0.0, 50.0), (f64::NAN, 50.0), (PERIOD, 0.0), (PERIOD, f64::NAN), (PERIOD, -3.0)] {
        assert!(matches!(tune(&drive, period, speed), Err(Error::OutOfRange { .. })));
    }
    // A velocity loop with almost no force beyond friction always meets its limit.
    let weak = LinearLoad { peak_force_n: 30.5, ..LOAD };
    let error = tune(&DriveParameters::linear(weak, TUNING).unwrap(), PERIOD, 5000.0).unwrap_err();
    assert!(!error.to_string().is_empty());
    for t in [
        Transmission { resonance_hz: 0.0, ..ELASTIC },
        Transmission { resonance_hz: f64::NAN, ..ELASTIC },
        Transmission { damping: -0.1, ..ELASTIC },
        Transmission { damping: f64::NAN, ..ELASTIC },
        Transmission { load_ratio: 0.0, ..ELASTIC },
        Transmission { backlash: -1.0, ..ELASTIC },
        Transmission { backlash: f64::INFINITY, ..ELASTIC },
        Transmission { motor_friction: 1.1, ..ELASTIC },
    ] {
        assert!(drive.with_transmission(t).is_err(), "{t:?}");
    }
    for limit in [0.0, -5.0, 30.0, 801.0, f64::NAN] {
        assert!(drive.with_force_limit(limit).is_err(), "{limit}");
    }
}
