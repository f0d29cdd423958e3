use super::thresholds::*;
use crate::axis::{Axis, AxisKind};
use crate::file::{MachineFile, StepFile};
use crate::machine::Machine;
use crate::surroundings::Surroundings;
use seamwright_clearance::Clamped;
use seamwright_document::Document;
use seamwright_message::{Argument, Language, Message, Quantity, Unit};
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

/// A valid but unusual value.
///
/// As JSON, `why` and `cure` are English text, and `why_code`, `why_arguments`, `cure_code` and `cure_arguments` are the
/// messages as data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Remark {
    /// Path of the key.
    pub key: String,
    /// Its line in the file; 0 if it is missing.
    pub line: usize,
    /// The value as written; empty if it is missing.
    pub value: String,
    /// The reason of the remark.
    pub why: Message,
    /// The proposed action.
    pub cure: Message,
}

impl Serialize for Remark {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { key, line, value, why, cure } = self;
        let mut fields = serializer.serialize_struct("Remark", 9)?;
        fields.serialize_field("key", key)?;
        fields.serialize_field("line", line)?;
        fields.serialize_field("value", value)?;
        fields.serialize_field("why", &why.in_language(Language::English))?;
        fields.serialize_field("cure", &cure.in_language(Language::English))?;
        fields.serialize_field("why_code", &why.code)?;
        fields.serialize_field("why_arguments", &why.named_arguments())?;
        fields.serialize_field("cure_code", &cure.code)?;
        fields.serialize_field("cure_arguments", &cure.named_arguments())?;
        fields.end()
    }
}

struct Remarks<'a> {
    file: &'a Document<MachineFile>,
    all: Vec<Remark>,
}

impl Remarks<'_> {
    fn add(&mut self, key: &str, why: Message, cure: Message) {
        let place = self.file.error_at(key, "", "");
        // A missing key has the line of its table, and no value.
        let value = if place.value.len() < 60 { place.value } else { String::new() };
        self.all.push(Remark { key: key.to_owned(), line: place.line, value, why, cure });
    }

    fn missing(&mut self, key: &str, why: Message, cure: Message) {
        self.all.push(Remark { key: key.to_owned(), line: 0, value: String::new(), why, cure });
    }
}

/// Lists unusual values of a machine file: likely other units or mistakes. `check/thresholds.rs` has the thresholds with
/// their reasons.
pub fn remarks(file: &Document<MachineFile>, machine: &Machine) -> Vec<Remark> {
    let mut remarks = Remarks { file, all: Vec::new() };
    let period = machine.servo_period_s;
    if !(SHORT_PERIOD_S..=LONG_PERIOD_S).contains(&period) {
        let why = Message::new("machine-remark-period").with("period", readable(1e3 * period, Unit::Ms));
        remarks.add("servo_period_ms", why, Message::new("machine-cure-period"));
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
                    let why = Message::new("machine-remark-displacement").value("limit", 1e-3 * FAR_MM, Unit::M);
                    remarks.add(&format!("{path}.fixed"), why, Message::new("machine-cure-displacement"));
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
        let why = Message::new("machine-remark-no-shapes");
        return remarks.missing("shapes", why, Message::new("machine-cure-no-shapes"));
    }
    // An invalid scene is reported as an error elsewhere.
    let Ok(around) = Surroundings::new(machine, &Clamped::default()) else { return };
    let home = machine.home();
    if around.is_clear(&home) {
        return;
    }
    let Some((watch, found)) = around.nearest(&home, around.greatest_least_mm() + 1.0) else { return };
    let (first, second) = around.bodies(watch);
    let min = around.scene().watches()[watch].least_mm();
    let why = Message::new("machine-remark-home-collision")
        .message("first", first)
        .message("second", second)
        .with("distance", readable(found.distance, Unit::Mm))
        .with("min", readable(min, Unit::Mm));
    remarks.missing("home", why, Message::new("machine-cure-home-collision"));
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
    let why = |code| Message::new(code).axis("axis", &axis.name);
    match axis.kind {
        AxisKind::Linear if span > LONG_MM => {
            let why = why("machine-remark-range-long").with("travel", readable(1e-3 * span, Unit::M));
            remarks.add(key, why, Message::new("machine-cure-range-long"));
        }
        AxisKind::Linear if span < SHORT_MM => {
            let why = why("machine-remark-range-short").with("travel", readable(span, Unit::Mm));
            remarks.add(key, why, Message::new("machine-cure-range-short"));
        }
        AxisKind::Rotary if span > MANY_DEG => {
            let why = why("machine-remark-turns").with("turns", readable(span / 360.0, Unit::One));
            remarks.add(key, why, Message::new("machine-cure-turns"));
        }
        AxisKind::Rotary if span < FEW_DEG => {
            let why = why("machine-remark-range-narrow").with("travel", readable(span, Unit::Deg));
            remarks.add(key, why, Message::new("machine-cure-range-narrow"));
        }
        AxisKind::Rotary if span <= RADIANS_SPAN_DEG => {
            let quarter = |v: f64| {
                let quarters = (v / std::f64::consts::FRAC_PI_2).round();
                (v - quarters * std::f64::consts::FRAC_PI_2).abs() <= RADIANS_ROUNDED
            };
            let sure = quarter(low) && quarter(high);
            let why = why(if sure { "machine-remark-range-quarter-turns" } else { "machine-remark-range-radians" })
                .with("travel", readable(span, Unit::Deg))
                .with("low", readable(low.to_degrees(), Unit::Deg))
                .with("high", readable(high.to_degrees(), Unit::Deg));
            remarks.add(key, why, Message::new("machine-cure-range-radians"));
        }
        _ => {}
    }
}

fn about_speed(remarks: &mut Remarks, key: &str, axis: &Axis) {
    let speed = axis.to_file(axis.max_speed);
    let (slow, fast) = axis.one_of((SLOW_MM_S, FAST_MM_S), (SLOW_DEG_S, FAST_DEG_S));
    let why = |code| Message::new(code).with("speed", readable(speed, axis.speed_unit()));
    if speed > fast {
        let cure = axis.one_of("machine-cure-linear-speed-high", "machine-cure-rotary-speed-high");
        return remarks.add(key, why("machine-remark-speed-high"), Message::new(cure));
    }
    if speed < slow {
        let cure = axis.one_of("machine-cure-linear-speed-low", "machine-cure-rotary-speed-low");
        return remarks.add(key, why("machine-remark-speed-low"), Message::new(cure));
    }
    // Acceleration and deceleration phases at full acceleration need v^2 / a.
    let (room, needed) = (axis.range.map(|(l, h)| h - l), axis.max_speed.powi(2) / axis.max_acceleration);
    if let Some(room) = room.filter(|room| needed > *room) {
        let why = Message::new("machine-remark-speed-unreached")
            .axis("axis", &axis.name)
            .with("needed", readable(axis.to_file(needed), axis.position_unit()))
            .with("travel", readable(axis.to_file(room), axis.position_unit()));
        let cure = axis.one_of("machine-cure-linear-speed-unreached", "machine-cure-rotary-speed-unreached");
        remarks.add(key, why, Message::new(cure));
    }
}

fn about_acceleration(remarks: &mut Remarks, key: &str, axis: &Axis) {
    let time = axis.max_speed / axis.max_acceleration;
    let cure = Message::new(axis.one_of("machine-cure-linear-acceleration", "machine-cure-rotary-acceleration"));
    if time > LONG_RUN_UP_S {
        let why = Message::new("machine-remark-acceleration-low").axis("axis", &axis.name);
        let cure = axis.one_of("machine-cure-linear-acceleration-low", "machine-cure-rotary-acceleration-low");
        remarks.add(key, why.with("time", readable(time, Unit::S)), Message::new(cure));
    } else if time < SHORT_RUN_UP_S {
        let why = Message::new("machine-remark-acceleration-high").axis("axis", &axis.name);
        remarks.add(key, why.with("time", readable(1e3 * time, Unit::Ms)), cure);
    } else if axis.kind == AxisKind::Linear && axis.max_acceleration > HARD_MM_S2 {
        let factor = readable(axis.max_acceleration / 9807.0, Unit::One);
        remarks.add(key, Message::new("machine-remark-gravity").with("factor", factor), cure);
    }
}

fn about_jerk(remarks: &mut Remarks, path: &str, key: &str, axis: &Axis) {
    let (unit, time) = (axis.unit(), axis.max_acceleration / axis.max_jerk);
    if axis.max_jerk.is_infinite() {
        let why = Message::new("machine-remark-jerk-missing").axis("axis", &axis.name);
        let cure = Message::new("machine-cure-jerk-missing").key("key", format!("max_jerk_{unit}_s3"));
        remarks.add(path, why, cure);
    } else if time > LONG_JERK_S {
        let why = Message::new("machine-remark-jerk-low").with("time", readable(time, Unit::S));
        remarks.add(key, why, Message::new(axis.one_of("machine-cure-linear-jerk", "machine-cure-rotary-jerk")));
    }
}

fn about_drive(remarks: &mut Remarks, axis: &Axis, period: f64) {
    let table = format!("drives.{}", axis.name);
    let Some(drive) = &axis.drive else {
        let of_axis = |code| Message::new(code).axis("axis", &axis.name);
        return remarks.missing(&table, of_axis("machine-remark-drive-missing"), of_axis("machine-cure-drive-missing"));
    };
    // Forces are in N and kg m/s^2, limits in mm.
    let (scale, peak_key, inertia_key, force) = match axis.kind {
        AxisKind::Linear => (1e-3, "peak_force_n", "mass_kg", Unit::N),
        AxisKind::Rotary => (1.0, "peak_torque_n_m", "inertia_kg_m2", Unit::NM),
    };
    let load = &drive.load;
    let moving = load.inertia * scale * axis.max_acceleration;
    let needed = moving + load.coulomb + load.viscous * scale * axis.max_speed;
    if needed > load.peak {
        let why = Message::new("machine-remark-drive-weak").axis("axis", &axis.name);
        let why = why.with("needed", readable(needed, force));
        remarks.add(&format!("{table}.{peak_key}"), why, Message::new("machine-cure-drive-weak"));
    } else if load.peak > STRONG * needed {
        let why = Message::new("machine-remark-drive-strong");
        let why = why.with("factor", readable(load.peak / needed, Unit::One));
        let cure = axis.one_of("machine-cure-linear-drive-strong", "machine-cure-rotary-drive-strong");
        remarks.add(&format!("{table}.{inertia_key}"), why, Message::new(cure));
    }
    let count = axis.to_file(1.0 / drive.encoder_counts_per_unit);
    let unit = axis.unit();
    if count > COARSE {
        let key = format!("{table}.encoder_counts_per_{unit}");
        let why = Message::new("machine-remark-encoder").with("count", readable(count, axis.position_unit()));
        let cure = axis.one_of("machine-cure-linear-encoder", "machine-cure-rotary-encoder");
        remarks.add(&key, why, Message::new(cure));
    }
    // A velocity loop's period must span several periods of the position loop.
    if drive.velocity_bandwidth_hz * period > 0.25 {
        let why = Message::new("machine-remark-velocity-loop")
            .with("bandwidth", readable(drive.velocity_bandwidth_hz, Unit::Hz))
            .with("period", readable(1e3 * period, Unit::Ms));
        let key = format!("{table}.velocity_bandwidth_hz");
        remarks.add(&key, why, Message::new("machine-cure-velocity-loop"));
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
        let why = Message::new("machine-remark-pitch").axis("axis", &axis.name);
        let why = why.with("error", readable(worst, axis.position_unit()));
        let cure = Message::new(axis.one_of("machine-cure-linear-pitch", "machine-cure-rotary-pitch"));
        remarks.add(&format!("pitch_error.{}.error_{unit}", axis.name), why, cure);
    }
}

/// A value rounded for reading: at most four decimals, none from 1000 on.
fn readable(value: f64, unit: Unit) -> Argument {
    let scale = if value.abs() >= 1000.0 { 1.0 } else { 1e4 };
    Argument::Quantity(Quantity::exact((value * scale).round() / scale, unit))
}
