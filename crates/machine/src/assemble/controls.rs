use super::File;
use crate::{Axis, ControlFile};
use seamwright_document::DocumentError;

/// Checks the controls of the file: existing axes, unique and valid addresses, valid codes.
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
            let allowed = "a capital letter other than G and N, then capitals, digits and _, like X or CW";
            return Err(file.error_at(&at(table, key), "this is no address", allowed));
        }
        if taken.contains(&address.as_str()) {
            return Err(file.error_at(&at(table, key), "something else has this address", "an address of its own"));
        }
        taken.push(address);
    }
    for (code, does) in &control.codes {
        let number = code.strip_prefix(['G', 'M']).and_then(|rest| rest.parse::<f64>().ok());
        if number.is_none_or(|n| !(0.0..1e4).contains(&n)) {
            return Err(file.error_at(&at("codes", code), "this is no code", "G or M and a number, like M54"));
        }
        if does.is_empty() || !does.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_') {
            let allowed = "arc_on, arc_off, gas_on, gas_off, wire_on, wire_off, exact_stop, continuous_path, or a name \
                           of its own in lower-case letters, digits and _";
            return Err(file.error_at(&at("codes", code), "this is no event", allowed));
        }
    }
    if control.kinematics_output.is_some() && name != "linuxcnc" {
        let path = format!("controls.{name}.kinematics_output");
        return Err(file.error_at(&path, "only LinuxCNC switches kinematics by an output", ""));
    }
    Ok(())
}
