//! A cycle of position loops and simulated drives does not allocate.

use seamwright_servo::{
    BacklashCompensation, DriveParameters, DriveTuning, EncoderSide, FrictionCompensation, Gains, LinearLoad, Notch,
    PositionLoop, ServoAxis, SetPoint, Transmission,
};
use seamwright_testkit::no_alloc;
use std::hint::black_box;

#[test]
fn a_step_does_not_allocate() {
    let period = 1e-3;
    let position_loop = PositionLoop::new(Gains::suggested(60.0, period), period, 60.0)
        .and_then(|l| l.with_notch(Notch::new(45.0, 0.2, 30.0, period)?))
        .and_then(|l| l.with_notch(Notch::new(160.0, 0.1, 80.0, period)?))
        .and_then(|l| l.with_friction(FrictionCompensation { force: 30.0, smoothing: 0.1 }))
        .and_then(|l| l.with_backlash(BacklashCompensation { width: 0.02, time_s: 0.02 }))
        .unwrap();
    let load = LinearLoad { mass_kg: 40.0, peak_force_n: 800.0, coulomb_n: 30.0, viscous_n_s_per_m: 100.0 };
    let tuning = DriveTuning {
        velocity_bandwidth_hz: 60.0,
        current_time_constant_s: 2e-4,
        current_delay_s: 1e-4,
        encoder_counts_per_unit: 2000.0,
    };
    let transmission = Transmission {
        resonance_hz: 60.0,
        damping: 0.03,
        load_ratio: 2.0,
        backlash: 0.005,
        motor_friction: 0.5,
        encoder_on: EncoderSide::Motor,
    };
    let drive = DriveParameters::linear(load, tuning).and_then(|d| d.with_transmission(transmission)).unwrap();
    let mut axis = ServoAxis::with_loop(position_loop, drive).unwrap();
    no_alloc(|| {
        for k in 0..2000 {
            let t = f64::from(k) * period;
            let set = SetPoint { position: t.sin(), velocity: t.cos(), acceleration: -t.sin() };
            black_box(axis.step(set, 5.0));
        }
        axis.settle_at(1.0, 20.0);
    });
}
