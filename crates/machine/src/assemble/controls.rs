use crate::axis::Axis;
use crate::file::{ControlFile, File};
use seamwright_document::DocumentError;
use seamwright_message::Message;

/// Events with a meaning of their own.
const EVENTS: &str = "arc_on, arc_off, gas_on, gas_off, wire_on, wire_off, exact_stop, continuous_path";

pub(super) fn check(file: &File, axes: &[Axis]) -> Result<(), DocumentError> {
    let controls = &file.value.controls;
    let all = [
        ("sinumerik", &controls.sinumerik),
        ("linuxcnc", &controls.linuxcnc),
        ("grblhal", &controls.grblhal),
        ("pmac", &controls.pmac),
    ];
    all.into_iter().try_for_each(|(name, control)| check_one(file, name, control, axes))
}

fn check_one(file: &File, name: &str, control: &ControlFile, axes: &[Axis]) -> Result<(), DocumentError> {
    let at = |table: &str, key: &str| format!("controls.{name}.{table}.{key}");
    if let Some(axis) = control.axes.keys().find(|key| !axes.iter().any(|a| &a.name == *key)) {
        let names: Vec<&str> = axes.iter().map(|a| a.name.as_str()).collect();
        return Err(file.unknown_name(&at("axes", axis), axis, &names));
    }
    let tables = [("axes", &control.axes), ("process", &control.process)];
    let mut taken: Vec<&str> = Vec::new();
    for (table, (key, address)) in tables.into_iter().flat_map(|(table, map)| map.iter().map(move |e| (table, e))) {
        let mut chars = address.chars();
        let good = chars.next().is_some_and(|c| c.is_ascii_uppercase())
            && chars.all(|c| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_');
        if !good || ["G", "N"].contains(&address.as_str()) {
            return Err(file.fault_at(&at(table, key), "machine-address-invalid", "machine-address-form"));
        }
        if taken.contains(&address.as_str()) {
            return Err(file.fault_at(&at(table, key), "machine-address-taken", "machine-own-address"));
        }
        taken.push(address);
    }
    for (code, does) in &control.codes {
        let number = code.strip_prefix(['G', 'M']).and_then(|rest| rest.parse::<f64>().ok());
        if number.is_none_or(|n| !(0.0..1e4).contains(&n)) {
            return Err(file.fault_at(&at("codes", code), "machine-code-invalid", "machine-code-form"));
        }
        if does.is_empty() || !does.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_') {
            let message = Message::new("machine-event-invalid");
            let allowed = Message::new("machine-event-names").text("names", EVENTS);
            return Err(file.error_at(&at("codes", code), message, allowed));
        }
    }
    if control.kinematics_output.is_some() && name != "linuxcnc" {
        let path = format!("controls.{name}.kinematics_output");
        return Err(file.error_at(&path, Message::new("machine-kinematics-output"), ""));
    }
    Ok(())
}
