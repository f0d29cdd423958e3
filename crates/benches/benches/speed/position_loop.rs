//! Benchmark of the position loops in a cycle: updates of ten loops and, for comparison, steps of ten simulated axes.

use crate::measure::time;
use seamwright_servo::{
    BacklashCompensation, DriveParameters, DriveTuning, EncoderSide, FrictionCompensation, Gains, LinearLoad, Notch,
    PositionLoop, ServoAxis, SetPoint, Transmission,
};
use std::hint::black_box;

const PERIOD: f64 = 1e-3;

/// A loop with all options.
fn full_loop() -> Result<PositionLoop, seamwright_servo::Error> {
    PositionLoop::new(Gains::suggested(60.0, PERIOD), PERIOD, 60.0)?
        .with_notch(Notch::new(45.0, 0.2, 30.0, PERIOD)?)?
        .with_notch(Notch::new(160.0, 0.1, 80.0, PERIOD)?)?
        .with_friction(FrictionCompensation { force: 30.0, smoothing: 0.1 })?
        .with_backlash(BacklashCompensation { width: 0.02, time_s: 0.02 })
}

fn drive() -> Result<DriveParameters, seamwright_servo::Error> {
    let load = LinearLoad { mass_kg: 40.0, peak_force_n: 800.0, coulomb_n: 30.0, viscous_n_s_per_m: 100.0 };
    let tuning = DriveTuning {
        velocity_bandwidth_hz: 60.0,
        current_time_constant_s: 2e-4,
        current_delay_s: 1e-4,
        encoder_counts_per_unit: 2000.0,
    };
    DriveParameters::linear(load, tuning)?.with_transmission(Transmission {
        resonance_hz: 60.0,
        damping: 0.03,
        load_ratio: 2.0,
        backlash: 0.005,
        motor_friction: 0.5,
        encoder_on: EncoderSide::Motor,
    })
}

pub(crate) fn ten_loops() {
    let mut loops: Vec<PositionLoop> = (0..10).map(|_| full_loop().expect("a good loop")).collect();
    let mut k = 0u32;
    time("10 position loops", || {
        k = k.wrapping_add(1);
        let t = f64::from(k % 4096) * PERIOD;
        let set = SetPoint { position: t.sin(), velocity: t.cos(), acceleration: -t.sin() };
        for position_loop in &mut loops {
            black_box((position_loop.update(black_box(set), black_box(set.position - 1e-3)), position_loop.force()));
        }
    });
    let mut axes: Vec<ServoAxis> = loops
        .iter()
        .map(|position_loop| ServoAxis::with_loop(*position_loop, drive().expect("a good drive")))
        .collect::<Result<_, _>>()
        .expect("good axes");
    time("10 simulated axes", || {
        k = k.wrapping_add(1);
        let t = f64::from(k) * PERIOD;
        let set = SetPoint { position: t.sin(), velocity: t.cos(), acceleration: -t.sin() };
        for axis in &mut axes {
            black_box(axis.step(black_box(set), 0.0));
        }
    });
}
