//! Assembles axes, links and heads from the file's steps, with an address for every error.

mod axis;
mod controls;
mod drive;
mod interlocks;
mod pitch_error;
mod sensors;
mod solids;
mod stepper;
mod tree;

use crate::axis::Axis;
use crate::chain::MAX_AXES;
use crate::file::{DeflectionFile, File, Load, StepFile};
use crate::head_pair::Pair;
use crate::machine::{Machine, UserFrame};
use glam::DVec3;
use seamwright_document::{Direction, DocumentError, Positive, Transform};
use seamwright_message::{Message, Unit};
use std::collections::BTreeMap;

const MAX_HEADS: usize = 2;

pub(crate) fn machine(file: &File, load: Load) -> Result<Machine, DocumentError> {
    let m = &file.value;
    check_heads(file)?;
    let mut axes = axes(file)?;
    let tables = m.drives.keys().map(|k| ("drives", k)).chain(m.pitch_error.keys().map(|k| ("pitch_error", k)));
    for (table, name) in tables {
        if !axes.iter().any(|a| &a.name == name) {
            let known: Vec<&str> = axes.iter().map(|a| a.name.as_str()).collect();
            return Err(file.unknown_name(&format!("{table}.{name}"), name, &known));
        }
    }
    for axis in &mut axes {
        axis.drive = m.drives.get(&axis.name).map(|d| drive::drive(file, axis, d)).transpose()?;
        let stepper = m.drives.get(&axis.name).and_then(|d| d.stepper.as_ref());
        axis.stepper = stepper.map(|s| stepper::stepper(file, axis, s)).transpose()?;
        axis.pitch_error =
            m.pitch_error.get(&axis.name).map(|t| pitch_error::pitch_error(file, axis, t)).transpose()?;
    }
    check_io(file)?;
    controls::check(file, &axes)?;
    interlocks::check(file)?;
    let devices = crate::devices::devices(file, &axes)?;
    let (links, heads) = tree::tree(m, &axes);
    let solids = solids::solids(file, &links, load)?;
    let sensors = sensors::sensors(file, &links)?;
    Ok(Machine {
        name: m.name.clone(),
        title: m.title.clone(),
        home_order: home_order(file, &axes)?,
        on_panel_lost: file.value.on_panel_lost,
        servo_period_s: m.servo_period_ms.map_or(1e-3, |p| p.get() * 1e-3),
        longest_gap_s: longest_gap_s(file)?,
        io: m.io.clone(),
        interlocks: m.interlocks.clone(),
        source: m.source.source(),
        devices,
        controls: m.controls.clone(),
        tip: m.tip.limits(),
        stick_out_mm: m.torch.as_ref().and_then(|torch| torch.stick_out_mm).map(Positive::get),
        deflection: m.torch.as_ref().and_then(|torch| torch.deflection).map(DeflectionFile::beam),
        up: m.up.map_or(DVec3::Z, Direction::unit),
        pair: Pair::new(&heads),
        has_pitch_error: axes.iter().any(|a| a.pitch_error.is_some()),
        links,
        solids,
        sensors,
        user_frames: user_frames(file)?,
        heads,
        axes,
    })
}

/// Maximum length of the name of a user frame, characters.
const MAX_FRAME_NAME: usize = 40;
/// Names of frames that every machine has.
const KNOWN_FRAMES: [&str; 5] = ["base", "world", "work", "tool", "flange"];

/// The user frames, each with a name of its own.
fn user_frames(file: &File) -> Result<Vec<UserFrame>, DocumentError> {
    let frame = |(name, frame): (&String, &Transform)| {
        let is_valid = (1..=MAX_FRAME_NAME).contains(&name.chars().count())
            && !name.chars().any(char::is_control)
            && !KNOWN_FRAMES.contains(&name.as_str());
        if !is_valid {
            let allowed = Message::new("machine-frame-name-allowed").count("max", MAX_FRAME_NAME);
            let fault = Message::new("machine-frame-name").text("name", name);
            return Err(file.error_at("frames", fault, allowed.text("names", KNOWN_FRAMES.join(", "))));
        }
        Ok(UserFrame { name: name.clone(), in_base: frame.affine() })
    };
    file.value.frames.iter().map(frame).collect()
}

/// Range of the longest gap in the cycle, ms.
const GAP_MS: [f64; 2] = [1.0, 1000.0];

/// Returns the longest gap in the cycle, s, if the file limits it.
fn longest_gap_s(file: &File) -> Result<Option<f64>, DocumentError> {
    let Some(gap_ms) = file.value.longest_gap_ms.map(Positive::get) else { return Ok(None) };
    let [min, max] = GAP_MS;
    if (min..=max).contains(&gap_ms) {
        return Ok(Some(1e-3 * gap_ms));
    }
    let allowed = Message::new("document-between").value("min", min, Unit::Ms).value("max", max, Unit::Ms);
    Err(file.error_at("longest_gap_ms", Message::new("machine-out-of-range"), allowed))
}

/// Checks for one torch, or up to two heads with steps and unique names.
fn check_heads(file: &File) -> Result<(), DocumentError> {
    let m = &file.value;
    match (m.torch.is_some(), m.heads.len()) {
        (true, 0) | (false, 1..=MAX_HEADS) => {}
        (true, _) => {
            return Err(file.fault_at("torch", "machine-torch-and-heads", "machine-torch-or-heads"));
        }
        (false, 0) => {
            return Err(file.fault_at("", "machine-torch-missing", "machine-torch-form"));
        }
        (false, n) => {
            let path = format!("heads[{MAX_HEADS}]");
            let allowed = Message::new("document-at-most").value("max", MAX_HEADS as f64, Unit::One);
            return Err(file.error_at(&path, Message::new("machine-heads-many").count("n", n), allowed));
        }
    }
    for (i, head) in m.heads.iter().enumerate() {
        let path = format!("heads[{i}]");
        if head.steps.is_empty() {
            let message = Message::new("machine-head-without-steps").text("head", &head.name);
            return Err(file.error_at(&path, message, Message::new("machine-head-steps")));
        }
        let taken = ["base", "work"].contains(&head.name.as_str());
        let twice = m.heads[..i].iter().any(|other| other.name == head.name);
        let steps = m.tool.iter().chain(&m.work).chain(m.heads.iter().flat_map(|h| &h.steps));
        if taken || twice || steps.into_iter().any(|s| s.axis.as_ref() == Some(&head.name)) {
            return Err(file.fault_at(&format!("{path}.name"), "machine-head-name-taken", "document-own-name"));
        }
    }
    Ok(())
}

fn axes(file: &File) -> Result<Vec<Axis>, DocumentError> {
    let m = &file.value;
    let mut branches: Vec<(String, &[StepFile])> = vec![("tool".to_owned(), &m.tool)];
    branches.extend(m.heads.iter().enumerate().map(|(i, h)| (format!("heads[{i}].steps"), h.steps.as_slice())));
    branches.push(("work".to_owned(), &m.work));
    let mut axes: Vec<Axis> = Vec::new();
    for (branch, steps) in branches {
        for (i, step) in steps.iter().enumerate() {
            let Some(axis) = axis::axis(file, &format!("{branch}[{i}]"), step)? else { continue };
            if axes.iter().any(|a| a.name == axis.name) {
                let path = format!("{branch}[{i}].axis");
                return Err(file.fault_at(&path, "machine-axis-name-taken", "document-own-name"));
            }
            if axis.letter.is_some() && axes.iter().any(|a| a.letter == axis.letter) {
                let path = format!("{branch}[{i}].letter");
                return Err(file.fault_at(&path, "machine-axis-letter-taken", "machine-own-letter"));
            }
            axes.push(axis);
        }
    }
    if axes.is_empty() || axes.len() > MAX_AXES {
        let found = Message::new("machine-axes-count").count("n", axes.len());
        let allowed = Message::new("machine-axes-allowed").text("max", MAX_AXES.to_string());
        return Err(file.error_at("tool", found, allowed));
    }
    Ok(axes)
}

fn home_order(file: &File, axes: &[Axis]) -> Result<Vec<usize>, DocumentError> {
    let mut order = Vec::new();
    for (i, name) in file.value.home_order.iter().enumerate() {
        let path = format!("home_order[{i}]");
        let Some(axis) = axes.iter().position(|axis| &axis.name == name) else {
            let known: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
            return Err(file.unknown_name(&path, name, &known));
        };
        if order.contains(&axis) {
            return Err(file.fault_at(&path, "machine-home-order-twice", "machine-each-axis-once"));
        }
        order.push(axis);
    }
    Ok(order)
}

/// Checks that outputs are unique: otherwise the arc would strike with the gas.
fn check_io(file: &File) -> Result<(), DocumentError> {
    let io = &file.value.io;
    let digital = [("arc", io.arc), ("gas", io.gas), ("wire", io.wire)];
    for (i, (name, output)) in digital.iter().enumerate() {
        if let Some((other, _)) = digital[..i].iter().find(|(_, o)| o.is_some() && o == output) {
            let message = Message::new("machine-output-taken").text("name", *other);
            return Err(file.error_at(&format!("io.{name}"), message, Message::new("machine-own-output")));
        }
    }
    let mut taken = BTreeMap::new();
    for (name, output) in &io.analog {
        if let Some(other) = taken.insert(output, name) {
            let message = Message::new("machine-output-taken").text("name", other);
            return Err(file.error_at(&format!("io.analog.{name}"), message, Message::new("machine-own-output")));
        }
    }
    Ok(())
}
