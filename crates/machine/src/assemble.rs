//! From the file's steps to axes and chain, with an address for everything that does not fit.

use crate::chain::{Chain, MAX_AXES, Screw};
use crate::inverse::ClosedForm;
use crate::{Axis, AxisKind, Drive, DriveFile, Gains, Load, Machine, MachineFile, StepFile};
use glam::{DAffine3, DVec3};
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive, RESERVED_COLUMNS};
use seamwright_geometry::Pose;
use std::collections::BTreeMap;

type File = Document<MachineFile>;

/// Builds the machine.
pub(crate) fn machine(file: &File) -> Result<Machine, DocumentError> {
    let m = &file.value;
    let mut axes = Vec::new();
    for (branch, steps) in [("tool", &m.tool), ("work", &m.work)] {
        for (i, step) in steps.iter().enumerate() {
            if let Some(axis) = axis(file, &format!("{branch}[{i}]"), step)? {
                if axes.iter().any(|a: &Axis| a.name == axis.name) {
                    let path = format!("{branch}[{i}].axis");
                    return Err(file.error_at(&path, "another axis has this name", "a name of its own"));
                }
                if axis.letter.is_some() && axes.iter().any(|a| a.letter == axis.letter) {
                    let path = format!("{branch}[{i}].letter");
                    return Err(file.error_at(&path, "another axis has this letter", "a letter of its own"));
                }
                axes.push(axis);
            }
        }
    }
    if axes.is_empty() || axes.len() > MAX_AXES {
        let found = format!("the machine has {} axes", axes.len());
        return Err(file.error_at("tool", found, format!("1 to {MAX_AXES} axes in [[tool]] and [[work]]")));
    }
    for name in m.drives.keys() {
        if !axes.iter().any(|a| &a.name == name) {
            let names: Vec<_> = axes.iter().map(|a| a.name.as_str()).collect();
            return Err(file.error_at(&format!("drives.{name}"), "there is no such axis", names.join(", ")));
        }
    }
    for axis in &mut axes {
        if let Some(drive) = m.drives.get(&axis.name) {
            axis.drive = Some(self::drive(file, axis, drive)?);
        }
    }
    check_io(file)?;
    let chain = chain(m, &axes);
    Ok(Machine {
        name: m.name.clone(),
        title: m.title.clone(),
        servo_period_s: m.servo_period_ms.map_or(1e-3, |p| p.get() * 1e-3),
        io: m.io.clone(),
        closed_form: ClosedForm::of(&chain),
        chain,
        axes,
    })
}

/// No two things on one output: the arc would strike with the gas.
fn check_io(file: &File) -> Result<(), DocumentError> {
    let io = &file.value.io;
    if io.arc.is_some() && io.arc == io.gas {
        return Err(file.error_at("io.gas", "the arc has this output already", "an output of its own"));
    }
    let mut taken = BTreeMap::new();
    for (name, output) in &io.analog {
        if let Some(other) = taken.insert(output, name) {
            let message = format!("`{other}` has this output already");
            return Err(file.error_at(&format!("io.analog.{name}"), message, "an output of its own"));
        }
    }
    Ok(())
}

/// The axis of a step, or none if the step is fixed.
fn axis(file: &File, path: &str, step: &StepFile) -> Result<Option<Axis>, DocumentError> {
    let at = |key: &str| format!("{path}.{key}");
    let Some(name) = &step.axis else {
        let has_axis_keys = StepFile { fixed: None, ..step.clone() } != StepFile::default();
        if step.fixed.is_none() || has_axis_keys {
            return Err(file.error_at(
                path,
                "the step is neither an axis nor fixed",
                "either `axis` with its keys, or `fixed` alone",
            ));
        }
        return Ok(None);
    };
    if step.fixed.is_some() {
        return Err(file.error_at(
            &at("fixed"),
            "a step with an axis cannot be fixed",
            "a step of its own for `fixed`",
        ));
    }
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if name.is_empty() || !name.chars().all(plain) {
        return Err(file.error_at(&at("axis"), "the name cannot be a column", "lower-case letters, digits and _"));
    }
    if RESERVED_COLUMNS.contains(&name.as_str()) {
        return Err(file.error_at(&at("axis"), "another column has this name", "a name of its own"));
    }
    let kind = match (&step.turn, &step.direction) {
        (Some(_), None) => AxisKind::Rotary,
        (None, Some(_)) => AxisKind::Linear,
        _ => return Err(file.error_at(path, "an axis turns or moves", "exactly one of `turn` and `move`")),
    };
    if kind == AxisKind::Linear {
        for (key, given) in [("at_mm", step.at_mm.is_some()), ("continuous", step.continuous)] {
            if given {
                return Err(file.error_at(&at(key), "a linear axis has no such key", "only with `turn`"));
            }
        }
    }
    let range = range(file, path, step, kind)?;
    let home = unit_value(file, path, kind, ("home", ""), step.home_mm, step.home_deg)?.map_or(0.0, Finite::get);
    let limit = |what: &'static str, power: &'static str, mm, deg| -> Result<f64, DocumentError> {
        let value: Option<Positive> = unit_value(file, path, kind, (what, power), mm, deg)?;
        let key = format!("{what}_{}{power}", if kind == AxisKind::Linear { "mm" } else { "deg" });
        value.map(Positive::get).ok_or_else(|| {
            file.error_at(path, format!("axis `{name}` lacks `{key}`"), format!("{key} = a number greater than 0"))
        })
    };
    let max_speed = limit("max_speed", "_s", step.max_speed_mm_s, step.max_speed_deg_s)?;
    let max_acceleration = limit("max_acceleration", "_s2", step.max_acceleration_mm_s2, step.max_acceleration_deg_s2)?;
    let jerk = unit_value(file, path, kind, ("max_jerk", "_s3"), step.max_jerk_mm_s3, step.max_jerk_deg_s3)?;
    // Not used yet: without it an axis has no jerk limit.
    let max_jerk = jerk.map_or(f64::INFINITY, Positive::get);
    let mut axis = Axis {
        name: name.clone(),
        letter: None,
        kind,
        range: None,
        home,
        max_speed,
        max_acceleration,
        max_jerk,
        drive: None,
    };
    axis.letter = letter(file, &at("letter"), step)?;
    axis.range = range.map(|[low, high]| (axis.from_file(low), axis.from_file(high)));
    for value in [&mut axis.home, &mut axis.max_speed, &mut axis.max_acceleration, &mut axis.max_jerk] {
        if kind == AxisKind::Rotary {
            *value = value.to_radians();
        }
    }
    if let Some(limit) = axis.outside(axis.home) {
        let allowed = format!("within the range (limit {})", axis.to_file(limit));
        return Err(file.error_at(path, "the home position is outside the range", allowed));
    }
    Ok(Some(axis))
}

fn letter(file: &File, path: &str, step: &StepFile) -> Result<Option<char>, DocumentError> {
    let known = "ABCUVWXYZ";
    let single = |text: &str| -> Option<char> {
        let mut chars = text.chars();
        chars.next().filter(|c| known.contains(*c) && chars.next().is_none())
    };
    match &step.letter {
        Some(text) => {
            single(text).map(Some).ok_or_else(|| file.error_at(path, "not an axis letter", "A B C U V W X Y Z"))
        }
        None => Ok(step.axis.as_ref().and_then(|name| single(&name.to_uppercase()))),
    }
}

/// The one of two values that belongs to the axis' kind; the other must be missing.
fn unit_value<T: Copy>(
    file: &File,
    path: &str,
    kind: AxisKind,
    (what, power): (&str, &str),
    mm: Option<T>,
    deg: Option<T>,
) -> Result<Option<T>, DocumentError> {
    let (value, wrong, wrong_unit, unit) = match kind {
        AxisKind::Linear => (mm, deg, "deg", "mm"),
        AxisKind::Rotary => (deg, mm, "mm", "deg"),
    };
    if wrong.is_some() {
        let key = format!("{path}.{what}_{wrong_unit}{power}");
        let what_is_wrong =
            if kind == AxisKind::Linear { "a linear axis is in mm" } else { "a rotary axis is in degrees" };
        return Err(file.error_at(&key, what_is_wrong, format!("{what}_{unit}{power}")));
    }
    Ok(value)
}

fn range(file: &File, path: &str, step: &StepFile, kind: AxisKind) -> Result<Option<[f64; 2]>, DocumentError> {
    let range = unit_value(file, path, kind, ("range", ""), step.range_mm, step.range_deg)?;
    let key = if kind == AxisKind::Linear { "range_mm" } else { "range_deg" };
    match (range, step.continuous) {
        (Some(_), true) => Err(file.error_at(path, "a continuous axis has no range", "`continuous` or a range")),
        (None, true) => Ok(None),
        (None, false) => {
            let or = if kind == AxisKind::Rotary { ", or continuous = true" } else { "" };
            Err(file.error_at(path, "the axis has no range", format!("{key} = [lowest, highest]{or}")))
        }
        (Some([low, high]), false) if low.get() < high.get() => Ok(Some([low.get(), high.get()])),
        (Some(_), false) => Err(file.error_at(&format!("{path}.{key}"), "the range is empty", "[lowest, highest]")),
    }
}

/// Values of a load: mass or inertia, peak, Coulomb and viscous friction.
type LoadFile = (Option<Positive>, Option<Positive>, Option<NonNegative>, Option<NonNegative>);

fn drive(file: &File, axis: &Axis, d: &DriveFile) -> Result<Drive, DocumentError> {
    let path = format!("drives.{}", axis.name);
    let linear: LoadFile = (d.mass_kg, d.peak_force_n, d.friction_n, d.viscous_n_s_m);
    let rotary: LoadFile = (d.inertia_kg_m2, d.peak_torque_n_m, d.friction_n_m, d.viscous_n_m_s_rad);
    let none: LoadFile = (None, None, None, None);
    let (load, other, keys, encoder) = match axis.kind {
        AxisKind::Linear => (linear, rotary, "mass_kg, peak_force_n, encoder_counts_per_mm", d.encoder_counts_per_mm),
        AxisKind::Rotary => {
            (rotary, linear, "inertia_kg_m2, peak_torque_n_m, encoder_counts_per_deg", d.encoder_counts_per_deg)
        }
    };
    if other != none {
        let what = if axis.kind == AxisKind::Linear {
            "a linear axis' drive has mass and force"
        } else {
            "a rotary axis' drive has inertia and torque"
        };
        return Err(file.error_at(&path, what, keys));
    }
    let (Some(inertia), Some(peak), Some(counts)) = (load.0, load.1, encoder) else {
        return Err(file.error_at(&path, "the drive lacks a key", keys));
    };
    let any_gain = d.kp_per_s.or(d.ki_per_s2).or(d.kd).or(d.kvff).or(d.kaff_s).is_some();
    let value = |v: Option<NonNegative>| v.map_or(0.0, NonNegative::get);
    let per_unit = if axis.kind == AxisKind::Rotary { 1f64.to_degrees() } else { 1.0 };
    Ok(Drive {
        load: Load { inertia: inertia.get(), peak: peak.get(), coulomb: value(load.2), viscous: value(load.3) },
        encoder_counts_per_unit: counts.get() * per_unit,
        velocity_bandwidth_hz: d.velocity_bandwidth_hz.get(),
        current_time_constant_s: d.current_time_constant_ms.map_or(2e-4, |t| t.get() * 1e-3),
        gains: any_gain.then(|| Gains {
            kp: value(d.kp_per_s),
            ki: value(d.ki_per_s2),
            kd: value(d.kd),
            kvff: value(d.kvff),
            kaff: value(d.kaff_s),
        }),
    })
}

/// Folds both branches into one chain from the work to the torch.
fn chain(m: &MachineFile, axes: &[Axis]) -> Chain {
    let index = |step: &StepFile| axes.iter().position(|a| Some(&a.name) == step.axis.as_ref());
    let mut screws = Vec::new();
    let mut frame = DAffine3::IDENTITY;
    // From the work to the base: the work's steps backwards, each undone.
    let undone = m.work.iter().rev().map(|s| (s, -1.0));
    for (step, sense) in undone.chain(m.tool.iter().map(|s| (s, 1.0))) {
        if let Some(fixed) = &step.fixed {
            let t = fixed.affine();
            frame *= if sense < 0.0 { t.inverse() } else { t };
        } else if let (Some(axis), Some(local)) = (index(step), step.turn.or(step.direction)) {
            let at = step.at_mm.map_or(DVec3::ZERO, seamwright_document::Point::get);
            screws.push(Screw {
                axis,
                kind: axes[axis].kind,
                direction: sense * frame.transform_vector3(local.unit()),
                at: frame.transform_point3(at),
            });
        }
    }
    let zero = Pose {
        point: frame.transform_point3(DVec3::ZERO),
        direction: frame.transform_vector3(m.torch.direction.unit()).normalize(),
    };
    Chain { screws, zero }
}
