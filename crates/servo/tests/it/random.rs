//! Seeded random axes under random motions: states are finite and within their limits.

use std::f64::consts::TAU;

use proptest::prelude::*;
use proptest::test_runner::RngSeed;
use seamwright_servo::{
    DriveParameters, DriveTuning, Encoder, Gains, LinearLoad, Notch, PositionLoop, ServoAxis, SetPoint,
};

fn config() -> ProptestConfig {
    ProptestConfig { cases: 400, rng_seed: RngSeed::Fixed(20_130_705), failure_persistence: None, ..Default::default() }
}

/// Drives with their loads.
fn drives() -> impl Strategy<Value = (LinearLoad, DriveParameters)> {
    let load = (0.1..500.0, 1.0..50.0, 0.0..0.6, 0.0..5.0);
    (load, 5.0..200.0, 0.0..0.25, 1.0..6.0).prop_map(
        |((mass_kg, peak, coulomb, viscous), hz, lag, counts): (_, f64, f64, f64)| {
            let load = LinearLoad {
                mass_kg,
                peak_force_n: mass_kg * peak,
                coulomb_n: mass_kg * peak * coulomb,
                viscous_n_s_per_m: mass_kg * viscous,
            };
            let tuning = DriveTuning {
                velocity_bandwidth_hz: hz,
                current_time_constant_s: 0.999 * lag / (TAU * hz),
                current_delay_s: 0.0,
                encoder_counts_per_unit: 10.0_f64.powf(counts),
            };
            (load, DriveParameters::linear(load, tuning).unwrap())
        },
    )
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn any_axis_on_any_set_points_stays_within_its_limits(
        (load, drive) in drives(),
        (kp, ki, kd, kvff, kaff) in (0.0..2000.0, 0.0..1e5, 0.0..3.0, 0.0..2.0, 0.0..0.1),
        max_speed in 1.0..1000.0,
        period in 1e-4..1e-2,
        notch in prop::option::of((0.01..0.95, 0.0..1.0, 0.01..0.9)),
        sets in prop::collection::vec((-1e3..1e3, -1e3..1e3, -1e5..1e5, -1.0..1.0), 60),
    ) {
        let mut looped = PositionLoop::new(Gains { kp, ki, kd, kvff, kaff }, period, max_speed).unwrap();
        if let Some((frequency, depth, width)) = notch {
            let notch = Notch::new(frequency * 0.5 / period, depth, width * 0.5 / period, period).unwrap();
            looped = looped.with_notch(notch).unwrap();
        }
        let mut axis = ServoAxis::with_loop(looped, drive).unwrap();
        let by_mass = 1000.0 / load.mass_kg; // mm/s^2 per N
        let (peak, friction) = (load.peak_force_n * by_mass, load.coulomb_n * by_mass);
        for (position, velocity, acceleration, push) in sets {
            let push = push * load.peak_force_n;
            let before = axis.drive().velocity();
            let state = axis.step(SetPoint { position, velocity, acceleration }, push);
            let after = axis.drive().velocity();
            prop_assert!(state.command.abs() <= max_speed);
            prop_assert!(state.current.abs() <= 1.0);
            prop_assert!((state.measured - state.position).abs() <= drive.encoder().count());
            prop_assert!(axis.drive().position().is_finite() && after.is_finite());
            let fastest = before.abs().max(after.abs()) + 2.0 * peak * period;
            let most = 2.0 * peak + friction + load.viscous_n_s_per_m / load.mass_kg * fastest;
            prop_assert!((after - before).abs() <= most * period * (1.0 + 1e-9));
        }
    }

    #[test]
    fn suggested_gains_come_to_rest_on_the_target((load, drive) in drives(), period in 1e-4..4e-3, part in 0.01..0.3) {
        let by_mass = 1000.0 / load.mass_kg; // mm/s^2 per N
        let hz = drive.velocity_bandwidth_hz();
        let gains = Gains::suggested(hz, period);
        // The step initially demands this part of the peak: within the limits, and less with friction.
        let target = part * load.peak_force_n * by_mass / (TAU * hz * gains.kp);
        let mut axis = ServoAxis::new(gains, 1e4, drive, period).unwrap();
        let set = SetPoint { position: target, ..SetPoint::default() };
        let (mut highest, mut end) = (0.0_f64, 0.0_f64);
        let periods = ((2.0 + 200.0 * gains.kaff) / period) as u32;
        for k in 0..periods {
            let state = axis.step(set, 0.0);
            highest = highest.max(state.position);
            if k + 100 > periods {
                end = end.max(state.following_error.abs());
            }
        }
        let count = drive.encoder().count();
        // If friction F holds the axis short of the target, the drive's integrator must grow by up to 2 F. It grows at
        // w^2 kp e, so after a time t e is at most 2 F / (w^2 kp t).
        let growth = (TAU * hz).powi(2) * gains.kp * 0.5 * f64::from(periods) * period;
        let held = 2.0 * load.coulomb_n * by_mass / growth;
        prop_assert!(end < count + held + 1e-6 * target, "error {end}, count {count}, held {held}");
        prop_assert!(highest < 1.02 * target + count, "overshoot {highest} of {target}, count {count}");
    }

    #[test]
    fn the_loop_alone_takes_any_bits(
        gains in (0.0..1e9, 0.0..1e9, 0.0..1e9, 0.0..1e9, 0.0..1e9),
        inputs in prop::collection::vec((any::<f64>(), any::<f64>(), any::<f64>(), any::<f64>()), 40),
    ) {
        let (kp, ki, kd, kvff, kaff) = gains;
        let notch = Notch::new(100.0, 0.1, 30.0, 1e-3).unwrap();
        let mut looped = PositionLoop::new(Gains { kp, ki, kd, kvff, kaff }, 1e-3, 50.0).unwrap();
        looped = looped.with_notch(notch).unwrap();
        for (position, velocity, acceleration, measured) in inputs {
            let command = looped.update(SetPoint { position, velocity, acceleration }, measured);
            prop_assert!(command.abs() <= 50.0);
        }
        // It still works after a reset.
        looped.reset();
        prop_assert!(looped.update(SetPoint::default(), 0.0).abs() < 1e-12);
    }

    #[test]
    fn encoders_are_within_a_count(counts in 1.0..1e6, position in -1e4..1e4) {
        let encoder = Encoder::new(counts).unwrap();
        prop_assert!((encoder.read(position) - position).abs() <= encoder.count());
    }
}
