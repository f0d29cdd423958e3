//! Drives by pulses: every cycle's count and every edge's position over random motion, and motors that lose steps.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng, SeedableRng};
use seamwright_executive::devices::{Drives, StepDrives};
use seamwright_executive::{DriveReport, Orders};
use seamwright_machine::{Machine, shipped};
use seamwright_motion::pulses::{Edge, Event};
use seamwright_servo::SetPoint;

fn machine(change: &[(&str, &str)]) -> Result<Machine, String> {
    let mut text = shipped("torch-5axis").unwrap().text.to_owned();
    for (from, to) in change {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    Machine::read("m.toml", &format!("{text}\n[devices.drives.steps]")).map_err(|e| e.to_string())
}

fn ready(machine: &Machine) -> (StepDrives, Orders, DriveReport) {
    let mut drives = StepDrives::new(machine, machine.devices.steps.as_ref().unwrap()).unwrap();
    let mut orders = Orders { power: true, home: true, ..Orders::default() };
    let mut report = DriveReport::default();
    while report.referenced == 0 {
        drives.exchange(&orders, &mut report);
    }
    orders.home = false;
    for (set, position) in orders.set.iter_mut().zip(report.position) {
        *set = SetPoint { position, ..SetPoint::default() };
    }
    (drives, orders, report)
}

/// Listens to the lines: counts, and checks the driver's times, all in ticks.
#[derive(Clone, Copy, Default)]
struct Driver {
    count: i64,
    positive: Option<bool>,
    rise: Option<u64>,
    fall: Option<u64>,
    turn: Option<u64>,
}

impl Driver {
    fn hear(&mut self, event: Event, stepper: &seamwright_machine::Stepper) {
        let s = |from: Option<u64>| from.map_or(f64::INFINITY, |from| (event.tick - from) as f64 * 1e-7) + 1e-12;
        match event.edge {
            Edge::Rise => {
                assert!(s(self.rise) >= 1.0 / stepper.max_pulse_hz && s(self.fall) >= stepper.min_pulse_s);
                assert!(s(self.turn) >= stepper.direction_setup_s);
                self.count += if self.positive.unwrap() { 1 } else { -1 };
                self.rise = Some(event.tick);
            }
            Edge::Fall => {
                assert!(s(self.rise) >= stepper.min_pulse_s);
                self.fall = Some(event.tick);
            }
            Edge::Direction(positive) => {
                assert!(self.positive != Some(positive) && s(self.fall) >= stepper.direction_hold_s);
                // The step line is low.
                assert!(self.fall >= self.rise);
                (self.positive, self.turn) = (Some(positive), Some(event.tick));
            }
        }
    }
}

/// Random speeds, accelerations, resolutions and driver's times, unless the machine file is refused. After each cycle
/// the pulses are the set-point rounded to steps.
#[test]
fn the_count_is_the_rounded_set_point() {
    let mut accepted = 0;
    for seed in 0..60 {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let mut uniform = move || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let mut between = |low: f64, high: f64| low * (high / low).powf(uniform());
        let change = [
            ("max_speed_mm_s = 100", format!("max_speed_mm_s = {}", between(10.0, 1000.0))),
            ("max_acceleration_mm_s2 = 500", format!("max_acceleration_mm_s2 = {}", between(100.0, 1e4))),
            ("max_jerk_mm_s3 = 5000", String::new()),
            ("resolution_mm = 0.005", format!("resolution_mm = {}", between(0.0005, 0.05))),
            ("max_pulse_hz = 200000", format!("max_pulse_hz = {}", between(2e4, 2e5))),
            ("direction_setup_us = 5", format!("direction_setup_us = {}", between(0.1, 400.0))),
            ("direction_hold_us = 5", format!("direction_hold_us = {}", between(0.1, 400.0))),
            // A motor that only counts.
            ("\nrotor_inertia_kg_m2", "\n#".to_owned()),
            ("\nrotor_friction_n_m", "\n#".to_owned()),
            ("\ntorque_rpm", "\n#".to_owned()),
            ("\ntorque_n_m", "\n#".to_owned()),
        ];
        let change: Vec<(&str, &str)> = change.iter().map(|(from, to)| (*from, to.as_str())).collect();
        let Ok(machine) = machine(&change) else { continue };
        accepted += 1;
        let (mut drives, mut orders, mut report) = ready(&machine);
        let mut lines = drives.tap(1 << 14);
        let per_unit: Vec<f64> = drives.steps_per_unit().collect();
        let mut drivers = vec![Driver::default(); machine.axes.len()];
        for (driver, (position, per_unit)) in drivers.iter_mut().zip(report.position.iter().zip(&per_unit)) {
            driver.count = (position * per_unit).round() as i64;
        }
        let period = machine.servo_period_s;
        let mut speeds = [0.0f64; 5];
        let mut pushes = [0.0f64; 5];
        for cycle in 0..4000 {
            for (i, axis) in machine.axes.iter().enumerate() {
                // Now and then another acceleration, up to the maximum.
                if uniform() < 0.01 {
                    pushes[i] = axis.max_acceleration * (3.0 * uniform() - 1.5).clamp(-1.0, 1.0);
                }
                let before = speeds[i];
                speeds[i] = (before + pushes[i] * period).clamp(-axis.max_speed, axis.max_speed);
                orders.set[i].position += 0.5 * (before + speeds[i]) * period;
            }
            drives.exchange(&orders, &mut report);
            while let Ok(event) = lines.pop() {
                assert_eq!((event.tick / 10_000).min(1), 1, "the references took longer");
                drivers[event.axis].hear(event, machine.axes[event.axis].stepper.as_ref().unwrap());
            }
            for (i, driver) in drivers.iter().enumerate() {
                let wanted = orders.set[i].position * per_unit[i];
                let off = (driver.count as f64 - wanted).abs();
                assert!(off <= 0.5 + 1e-6, "{seed} {cycle} axis {i}: {} {wanted}", driver.count);
                assert!((report.position[i] * per_unit[i] - driver.count as f64).abs() < 1e-6);
            }
        }
        assert!(drivers.iter().any(|d| d.count.abs() > 1000));
    }
    assert!(accepted > 15, "{accepted}");
}

/// A jump of the set-point is followed as fast as the driver accepts pulses, back and forth.
#[test]
fn a_jump_is_caught_up_with() {
    let machine = machine(&[
        ("\nrotor_inertia_kg_m2", "\n#"),
        ("\nrotor_friction_n_m", "\n#"),
        ("\ntorque_rpm", "\n#"),
        ("\ntorque_n_m", "\n#"),
    ])
    .unwrap();
    let (mut drives, mut orders, mut report) = ready(&machine);
    let mut lines = drives.tap(1 << 14);
    let count = (report.position[0] * drives.steps_per_unit().next().unwrap()).round() as i64;
    let mut driver = Driver { count, ..Driver::default() };
    let from = report.position[0];
    for jump in [50.0, -70.0, 0.01, -0.02, 3.0] {
        orders.set[0].position = from + jump;
        let mut cycles = 0;
        while report.following_error[0].abs() > 0.002 || cycles == 0 {
            drives.exchange(&orders, &mut report);
            while let Ok(event) = lines.pop() {
                driver.hear(event, machine.axes[0].stepper.as_ref().unwrap());
            }
            cycles += 1;
            // 320 steps a mm, 200 in a cycle.
            assert!(cycles <= 200 + 3, "{jump}: {report:?}");
        }
    }
}

/// Ramps within the torque curve are followed. With a hundredth of the torque the motor stands, and the following
/// error shows it. After a power cycle the axis keeps its position, and moves from there.
#[test]
fn steps_are_lost_beyond_the_torque() {
    for (torque, holds) in [("[8.5, 7.6, 6.8, 4.6, 3.1, 2.2]", true), ("[0.4, 0.35, 0.3, 0.2, 0.1, 0.05]", false)] {
        let machine = machine(&[("[8.5, 7.6, 6.8, 4.6, 3.1, 2.2]", torque)]).unwrap();
        let (mut drives, mut orders, mut report) = ready(&machine);
        let from = report.position[0];
        let mut worst = 0.0f64;
        let mut go = |drives: &mut StepDrives, orders: &mut Orders, report: &mut DriveReport, way: f64| {
            let from = orders.set[0].position;
            for k in 1..=500 {
                let angle = std::f64::consts::PI * f64::from(k) / 500.0;
                orders.set[0].position = from + way * 0.5 * (1.0 - angle.cos());
                drives.exchange(orders, report);
                worst = worst.max(report.following_error[0].abs());
            }
        };
        go(&mut drives, &mut orders, &mut report, 20.0);
        if holds {
            assert!((report.position[0] - from - 20.0).abs() < 0.005, "{report:?}");
            assert!(worst < 0.05, "{worst}");
            continue;
        }
        assert!(worst > 2.0 && report.following_error[0] > 2.0, "{worst} {report:?}");
        // As the executive does without power: set-points at the axes.
        orders.power = false;
        for _ in 0..200 {
            drives.exchange(&orders, &mut report);
            orders.set[0].position = report.position[0];
            orders.power |= !report.powered;
        }
        assert!(report.powered && report.following_error[0].abs() < 0.05, "{report:?}");
        let stood = report.position[0];
        // A slow motion succeeds.
        for _ in 0..2000 {
            orders.set[0].position += 1e-3;
            drives.exchange(&orders, &mut report);
        }
        assert!((report.position[0] - stood - 2.0).abs() < 0.1, "{stood} {report:?}");
    }
}

/// A receiver that does not take the pulses in time stops the drives, which report a fault.
#[test]
fn a_stream_that_tears_is_a_fault() {
    let machine = machine(&[]).unwrap();
    let (mut drives, mut orders, mut report) = ready(&machine);
    let lines = drives.tap(100);
    for _ in 0..500 {
        orders.set[1].position += 0.05;
        drives.exchange(&orders, &mut report);
    }
    assert_eq!(report.fault, 0b11111);
    assert!(report.following_error[1] > 20.0 && lines.slots() == 100);
}
