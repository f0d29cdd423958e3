//! Measured responses compared with analytic ones, in linear cases.

use std::f64::consts::TAU;

use num_complex::Complex64;
use seamwright_servo::{
    DriveParameters, DriveTuning, EncoderSide, Gains, LinearLoad, Margins, Notch, PositionLoop, ServoAxis, SetPoint,
    Transmission, decibels, loop_response,
};

const PERIOD: f64 = 1e-3;
const FREE: LinearLoad = LinearLoad { mass_kg: 50.0, peak_force_n: 2000.0, coulomb_n: 0.0, viscous_n_s_per_m: 0.0 };
const KP: f64 = 60.0;

fn tuning(hz: f64, lag: f64, delay: f64) -> DriveTuning {
    DriveTuning {
        velocity_bandwidth_hz: hz,
        current_time_constant_s: lag,
        current_delay_s: delay,
        encoder_counts_per_unit: 1e7,
    }
}

/// Times of a drive's loops, s.
#[derive(Clone, Copy)]
struct LoopTimes {
    /// Time constant of the current loop.
    lag: f64,
    /// Dead time of the current loop.
    delay: f64,
    /// Step of the velocity loop.
    step: f64,
}

/// From speed command to position: the continuous drive with the lag and the delay of its current loop, and the
/// velocity loop's step. To first order in that, the speed fed back is late by half a step, as the demand is held
/// over one, while the integral, whose step ends where it is used, is early by half a step.
fn drive(s: Complex64, hz: f64, times: LoopTimes, t: Option<Transmission>) -> Complex64 {
    let LoopTimes { lag, delay, step } = times;
    let w = TAU * hz;
    let current = (-s * delay).exp() / (1.0 + s * lag);
    let half = (s * 0.5 * step).exp();
    let (motor, load) = match t {
        None => (1.0 / s, 1.0 / (s * s)),
        Some(t) => {
            let (m, l) = (1.0 / (1.0 + t.load_ratio), t.load_ratio / (1.0 + t.load_ratio));
            let wr = TAU * t.resonance_hz;
            let spring = wr * wr * m * l + 2.0 * t.damping * wr * m * l * s;
            let both = m * l * s * s + spring;
            // Motor: (l s^2 + c s + k) / (s^2 (m l s^2 + c s + k)), and the load follows through the spring.
            let motor = (l * s * s + spring) / (s * both);
            let load = spring / (s * s * both);
            (motor, if t.encoder_on == EncoderSide::Load { load } else { motor / s })
        }
    };
    // PI with a set-point weight of one half: Kv (r/2 - v) + Kv w/2 (r - v) / s.
    let kv = 2.0 * w;
    // The command changes at the start of a step, so the hold does not delay it.
    let forward = kv * (0.5 + 0.5 * w / s * half) * current;
    let back = kv * (1.0 / half + 0.5 * w / s) * current;
    forward * load / (1.0 + back * motor)
}

/// The open loop as sampled: hold, drive and its images at multiples of the sampling rate.
fn sampled(hz: f64, drive: impl Fn(Complex64) -> Complex64) -> Complex64 {
    let term = |n: i32| {
        let s = Complex64::new(0.0, TAU * (hz + f64::from(n) / PERIOD));
        drive(s) * (1.0 - (-s * PERIOD).exp()) / (s * PERIOD)
    };
    (-40..=40).map(term).sum()
}

fn axis(parameters: DriveParameters, notch: Option<Notch>) -> ServoAxis {
    let gains = Gains { kp: KP, kvff: 1.0, ..Gains::default() };
    let mut position_loop = PositionLoop::new(gains, PERIOD, 300.0).unwrap();
    if let Some(notch) = notch {
        position_loop = position_loop.with_notch(notch).unwrap();
    }
    ServoAxis::with_loop(position_loop, parameters).unwrap()
}

/// Maximum difference of the measured from the analytic response (dB, degrees) below `top_hz`, above -40 dB.
fn distance(axis: &ServoAxis, top_hz: f64, analytic: impl Fn(f64) -> Complex64) -> (f64, f64) {
    let lines = loop_response(axis, 20.0).unwrap();
    let seen: Vec<_> = lines.iter().filter(|l| l.frequency_hz < top_hz && l.ratio.norm() > 0.01).collect();
    assert!(seen.len() > 30);
    seen.iter().fold((0.0, 0.0), |(db, deg): (f64, f64), line| {
        let off = line.ratio / analytic(line.frequency_hz);
        (db.max(decibels(off.norm()).abs()), deg.max(off.arg().to_degrees().abs()))
    })
}

#[test]
fn a_rigid_axis_is_measured_as_its_transfer_function() {
    // Sub-steps as in Drive::new: 0.1 over twice the bandwidth, at least eight per period.
    for (hz, lag, delay) in [(60.0, 2e-4, 0.0), (60.0, 3e-4, 2.5e-4), (25.0, 1e-3, 4e-4)] {
        let step = PERIOD / (PERIOD * 2.0 * TAU * hz / 0.1).ceil().max(8.0);
        let parameters = DriveParameters::linear(FREE, tuning(hz, lag, delay)).unwrap();
        let analytic = |f: f64| KP * sampled(f, |s| drive(s, hz, LoopTimes { lag, delay, step }, None));
        let (db, deg) = distance(&axis(parameters, None), 250.0, analytic);
        assert!(db < 0.1 && deg < 1.0, "{hz}: {db} dB, {deg} deg");
    }
}

#[test]
fn an_elastic_axis_with_a_notch_is_measured_as_its_transfer_function() {
    for encoder_on in [EncoderSide::Motor, EncoderSide::Load] {
        let t = Transmission {
            resonance_hz: 70.0,
            damping: 0.03,
            load_ratio: 1.5,
            backlash: 0.0,
            motor_friction: 0.0,
            encoder_on,
        };
        let (hz, lag, delay) = (30.0, 2e-4, 1e-4);
        let step = PERIOD / (PERIOD * (2.0 * TAU * hz).max(TAU * t.resonance_hz) / 0.1).ceil().max(8.0);
        let parameters = DriveParameters::linear(FREE, tuning(hz, lag, delay)).unwrap().with_transmission(t).unwrap();
        let notch = Notch::new(52.0, 0.2, 30.0, PERIOD).unwrap();
        let analytic = |f: f64| {
            let z = Complex64::from_polar(1.0, TAU * f * PERIOD);
            KP * notch.response(z) * sampled(f, |s| drive(s, hz, LoopTimes { lag, delay, step }, Some(t)))
        };
        let looped = axis(parameters, Some(notch));
        let (db, deg) = distance(&looped, 250.0, analytic);
        assert!(db < 0.1 && deg < 1.0, "{encoder_on:?}: {db} dB, {deg} deg");
    }
}

#[test]
fn the_measured_gain_margin_is_where_the_loop_becomes_unstable() {
    // Independent check: kp is raised by the margin, 5 % less and 5 % more; the axis is excited and must settle or not.
    let parameters = DriveParameters::linear(FREE, tuning(40.0, 3e-4, 2e-4)).unwrap();
    let gains = |kp: f64| Gains { kp, kvff: 1.0, ..Gains::default() };
    let base = ServoAxis::new(gains(KP), 300.0, parameters, PERIOD).unwrap();
    let margins = Margins::of(&loop_response(&base, 20.0).unwrap());
    let limit = KP * 10.0_f64.powf(margins.gain_margin_db / 20.0);
    let swing = |kp: f64| {
        let mut axis = ServoAxis::new(gains(kp), 300.0, parameters, PERIOD).unwrap();
        let set = SetPoint { position: 1e-3, ..SetPoint::default() };
        let errors: Vec<f64> = (0..4000).map(|_| axis.step(set, 0.0).following_error.abs()).collect();
        errors[3000..].iter().fold(0.0, |worst: f64, e| worst.max(*e))
    };
    let (below, above) = (swing(0.95 * limit), swing(1.05 * limit));
    assert!(below < 1e-6 && above > 1e-3, "{below} {above} {margins:?}");
}

#[test]
fn speeds_without_sense_are_refused() {
    let looped = axis(DriveParameters::linear(FREE, tuning(40.0, 2e-4, 0.0)).unwrap(), None);
    for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(loop_response(&looped, speed).is_err());
    }
}
