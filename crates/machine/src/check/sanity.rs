use super::usual::*;
use crate::{Axis, AxisKind, Clamped, Machine, MachineFile, StepFile, Surroundings};
use seamwright_document::Document;
use serde::Serialize;

/// A valid but unusual value.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Remark {
    /// Path of the key.
    pub key: String,
    /// Its line in the file; 0 if it is missing.
    pub line: usize,
    /// The value as written; empty if it is missing.
    pub value: String,
    /// The reason of the remark.
    pub why: String,
    /// The proposed action.
    pub cure: String,
}

struct Remarks<'a> {
    file: &'a Document<MachineFile>,
    all: Vec<Remark>,
}

impl Remarks<'_> {
    fn add(&mut self, key: &str, why: impl Into<String>, cure: impl Into<String>) {
        let place = self.file.error_at(key, "", "");
        // A missing key has the line of its table, and no value.
        let value = if place.value.len() < 60 { place.value } else { String::new() };
        let (why, cure) = (why.into(), cure.into());
        self.all.push(Remark { key: key.to_owned(), line: place.line, value, why, cure });
    }

    /// Adds a remark on a missing table.
    fn missing(&mut self, key: &str, why: String, cure: String) {
        self.all.push(Remark { key: key.to_owned(), line: 0, value: String::new(), why, cure });
    }
}

/// Lists unusual values of a machine file: likely other units or mistakes. `check/usual.rs` has the thresholds with
/// their reasons.
pub fn remarks(file: &Document<MachineFile>, machine: &Machine) -> Vec<Remark> {
    let mut remarks = Remarks { file, all: Vec::new() };
    let period = machine.servo_period_s;
    if !(SHORT_PERIOD_S..=LONG_PERIOD_S).contains(&period) {
        let why = format!("the position loops would run every {} ms", number(1e3 * period));
        remarks.add("servo_period_ms", why, "the period in ms; 1 is usual");
    }
    let m = &file.value;
    let mut branches: Vec<(String, &[StepFile])> = vec![("tool".to_owned(), &m.tool), ("work".to_owned(), &m.work)];
    branches.extend(m.heads.iter().enumerate().map(|(i, h)| (format!("heads[{i}].steps"), h.steps.as_slice())));
    for (branch, steps) in branches {
        for (i, step) in steps.iter().enumerate() {
            let path = format!("{branch}[{i}]");
            let axis = machine.axes.iter().find(|a| Some(&a.name) == step.axis.as_ref());
            match (axis, &step.fixed) {
                (Some(axis), _) => about_axis(&mut remarks, &path, axis, period),
                (None, Some(fixed)) if fixed.affine().translation.length() > FAR_MM => {
                    let why = "the displacement is longer than 100 m";
                    remarks.add(&format!("{path}.fixed"), why, "lengths in mm");
                }
                _ => {}
            }
        }
    }
    about_clearance(&mut remarks, machine);
    remarks.all
}

/// Remarks on a machine without shapes for collision checks, or with a collision at its home position.
fn about_clearance(remarks: &mut Remarks, machine: &Machine) {
    if machine.solids.solids.is_empty() {
        let why = "the machine has no shapes: nothing can be checked for collisions";
        return remarks.missing(
            "shapes",
            why.to_owned(),
            "[[shapes.torch]], and so on for what may collide".to_owned(),
        );
    }
    // An invalid scene is reported as an error elsewhere.
    let Ok(around) = Surroundings::new(machine, &Clamped::default()) else { return };
    let home = machine.home();
    if around.is_clear(&home) {
        return;
    }
    let Some((watch, found)) = around.nearest(&home, around.greatest_least_mm() + 1.0) else { return };
    let (a, b) = around.names(watch);
    let least = around.scene().watches()[watch].least_mm();
    let why = format!(
        "at the home position {a} and {b} are {} mm apart, and {} mm are asked for",
        number(found.distance),
        number(least)
    );
    remarks.missing("home", why, "home_mm or home_deg of an axis, or the shapes".to_owned());
}

fn about_axis(remarks: &mut Remarks, path: &str, axis: &Axis, period: f64) {
    let unit = axis.unit();
    let key = |what: &str, power: &str| format!("{path}.{what}_{unit}{power}");
    about_range(remarks, &key("range", ""), axis);
    about_speed(remarks, &key("max_speed", "_s"), axis);
    about_acceleration(remarks, &key("max_acceleration", "_s2"), axis);
    about_jerk(remarks, path, &key("max_jerk", "_s3"), axis);
    about_drive(remarks, axis, period);
    about_pitch(remarks, axis);
}

fn about_range(remarks: &mut Remarks, key: &str, axis: &Axis) {
    let Some((low, high)) = axis.range.map(|(low, high)| (axis.to_file(low), axis.to_file(high))) else { return };
    let span = high - low;
    match axis.kind {
        AxisKind::Linear if span > LONG_MM => {
            let why = format!("axis {} would run over {} m", axis.name, number(1e-3 * span));
            remarks.add(key, why, "the range in mm");
        }
        AxisKind::Linear if span < SHORT_MM => {
            let why = format!("axis {} would move by {} mm in all", axis.name, number(span));
            remarks.add(key, why, "the range in mm; m may have been meant");
        }
        AxisKind::Rotary if span > MANY_DEG => {
            let why = format!("axis {} would make {} turns", axis.name, number(span / 360.0));
            remarks.add(key, why, "the range in degrees, or continuous = true");
        }
        AxisKind::Rotary if span < FEW_DEG => {
            remarks.add(key, format!("axis {} would turn by {} deg in all", axis.name, number(span)), "degrees");
        }
        AxisKind::Rotary if span <= RADIANS_SPAN_DEG => {
            let quarter = |v: f64| {
                let quarters = (v / std::f64::consts::FRAC_PI_2).round();
                (v - quarters * std::f64::consts::FRAC_PI_2).abs() <= RADIANS_ROUNDED
            };
            let sure = quarter(low) && quarter(high);
            let why = format!(
                "axis {} would turn by {} deg in all; {} in rad this would be {} to {} deg",
                axis.name,
                number(span),
                if sure { "the ends are quarter turns in rad:" } else { "read" },
                number(low.to_degrees()),
                number(high.to_degrees())
            );
            remarks.add(key, why, "the range in degrees; leave it if so little is meant");
        }
        _ => {}
    }
}

fn about_speed(remarks: &mut Remarks, key: &str, axis: &Axis) {
    let speed = axis.to_file(axis.max_speed);
    let (slow, fast, others) = match axis.kind {
        AxisKind::Linear => (SLOW_MM_S, FAST_MM_S, ("m/s", "mm/min")),
        AxisKind::Rotary => (SLOW_DEG_S, FAST_DEG_S, ("rad/s or turns a minute", "deg/min")),
    };
    let unit = axis.unit();
    if speed > fast {
        let why = format!("{} {unit}/s is faster than such an axis goes", number(speed));
        return remarks.add(key, why, format!("the speed in {unit}/s; {} may have been meant", others.1));
    }
    if speed < slow {
        let why = format!("{} {unit}/s is slower than such an axis goes", number(speed));
        return remarks.add(key, why, format!("the speed in {unit}/s; {} may have been meant", others.0));
    }
    // Acceleration and deceleration phases at full acceleration need v^2 / a.
    let (room, needed) = (axis.range.map(|(l, h)| h - l), axis.max_speed.powi(2) / axis.max_acceleration);
    if let Some(room) = room.filter(|room| needed > *room) {
        let why = format!(
            "axis {} never reaches it: run-up and run-down take {} {unit}, and its range is {} {unit}",
            axis.name,
            number(axis.to_file(needed)),
            number(axis.to_file(room))
        );
        remarks.add(key, why, format!("speed in {unit}/s and acceleration in {unit}/s^2"));
    }
}

fn about_acceleration(remarks: &mut Remarks, key: &str, axis: &Axis) {
    let time = axis.max_speed / axis.max_acceleration;
    let unit = axis.unit();
    let cure = format!("the acceleration in {unit}/s^2");
    if time > LONG_RUN_UP_S {
        let why = format!("axis {} takes {} s to reach its speed", axis.name, number(time));
        remarks.add(key, why, format!("{cure}; m/s^2 or rad/s^2 may have been meant"));
    } else if time < SHORT_RUN_UP_S {
        let why = format!("axis {} reaches its speed in {} ms", axis.name, number(1e3 * time));
        remarks.add(key, why, cure);
    } else if axis.kind == AxisKind::Linear && axis.max_acceleration > HARD_MM_S2 {
        let why =
            format!("{} times gravity is more than such an axis can stand", number(axis.max_acceleration / 9807.0));
        remarks.add(key, why, cure);
    }
}

fn about_jerk(remarks: &mut Remarks, path: &str, key: &str, axis: &Axis) {
    let (unit, time) = (axis.unit(), axis.max_acceleration / axis.max_jerk);
    if axis.max_jerk.is_infinite() {
        let why = format!("axis {} has no jerk limit", axis.name);
        remarks.add(path, why, format!("max_jerk_{unit}_s3; ten times the acceleration is usual"));
    } else if time > LONG_JERK_S {
        let why = format!("the acceleration takes {} s to build up", number(time));
        remarks.add(key, why, format!("a jerk in {unit}/s^3"));
    }
}

fn about_drive(remarks: &mut Remarks, axis: &Axis, period: f64) {
    let table = format!("drives.{}", axis.name);
    let Some(drive) = &axis.drive else {
        let why = format!("axis {} has no drive: it is simulated with an assumed one", axis.name);
        return remarks.missing(&table, why, format!("[drives.{}]", axis.name));
    };
    // Forces are in N and kg m/s^2, limits in mm.
    let (scale, peak_key, inertia_key, force) = match axis.kind {
        AxisKind::Linear => (1e-3, "peak_force_n", "mass_kg", "N"),
        AxisKind::Rotary => (1.0, "peak_torque_n_m", "inertia_kg_m2", "N m"),
    };
    let load = &drive.load;
    let moving = load.inertia * scale * axis.max_acceleration;
    let needed = moving + load.coulomb + load.viscous * scale * axis.max_speed;
    if needed > load.peak {
        let why = format!(
            "axis {} needs {} {force} for its acceleration at its highest speed, friction included",
            axis.name,
            number(needed)
        );
        remarks.add(&format!("{table}.{peak_key}"), why, "a stronger drive, or a lower max_acceleration");
    } else if load.peak > STRONG * needed {
        let why = format!("the drive is {} times as strong as its load asks", number(load.peak / needed));
        remarks.add(&format!("{table}.{inertia_key}"), why, format!("kg or kg m^2, and {force}"));
    }
    let count = axis.to_file(1.0 / drive.encoder_counts_per_unit);
    let unit = axis.unit();
    if count > COARSE {
        let key = format!("{table}.encoder_counts_per_{unit}");
        remarks.add(&key, format!("one count is {} {unit}", number(count)), format!("counts per {unit} at the axis"));
    }
    // A velocity loop's period must span several periods of the position loop.
    if drive.velocity_bandwidth_hz * period > 0.25 {
        let why = format!(
            "{} Hz is too fast for a position loop every {} ms",
            number(drive.velocity_bandwidth_hz),
            number(1e3 * period)
        );
        remarks.add(&format!("{table}.velocity_bandwidth_hz"), why, "Hz; or a shorter servo_period_ms");
    }
}

fn about_pitch(remarks: &mut Remarks, axis: &Axis) {
    let Some(table) = &axis.pitch_error else { return };
    let (low, high) = axis.range.unwrap_or((-std::f64::consts::PI, std::f64::consts::PI));
    let at = |i: u32| low + (high - low) * f64::from(i) / 1000.0;
    let worst = axis.to_file((0..=1000).map(|i| (table.true_at(at(i)).0 - at(i)).abs()).fold(0.0, f64::max));
    let most = if axis.kind == AxisKind::Linear { PITCH_ERROR_MM } else { PITCH_ERROR_DEG };
    if worst > most {
        let unit = axis.unit();
        let why = format!("axis {} would be off by up to {} {unit}", axis.name, number(worst));
        remarks.add(&format!("pitch_error.{}.error_{unit}", axis.name), why, format!("errors in {unit}"));
    }
}

/// Formats a number for reading: at most four decimals, none from 1000 on.
fn number(value: f64) -> String {
    let text = if value.abs() >= 1000.0 { format!("{value:.0}") } else { format!("{value:.4}") };
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
