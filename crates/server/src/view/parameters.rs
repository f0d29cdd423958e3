use crate::wire::{AxisParameters, HeadView, ParameterView, ParametersView};
use seamwright_machine::{AxisKind, Machine};
use seamwright_project::Failure;
use seamwright_project::own_machine::{OwnMachine, Step};

use AxisKind::{Linear, Rotary};

/// Numbers of an axis (`axis`) and its drive that are set up: key of the machine file, group, kind of axis that has it.
pub(crate) const PARAMETERS: [(&str, &str, Option<AxisKind>); 37] = [
    ("home_mm", "axis", Some(Linear)),
    ("home_deg", "axis", Some(Rotary)),
    ("max_speed_mm_s", "axis", Some(Linear)),
    ("max_speed_deg_s", "axis", Some(Rotary)),
    ("max_acceleration_mm_s2", "axis", Some(Linear)),
    ("max_acceleration_deg_s2", "axis", Some(Rotary)),
    ("max_jerk_mm_s3", "axis", Some(Linear)),
    ("max_jerk_deg_s3", "axis", Some(Rotary)),
    ("velocity_bandwidth_hz", "loop", None),
    ("kp_per_s", "loop", None),
    ("ki_per_s2", "loop", None),
    ("kd", "loop", None),
    ("kvff", "loop", None),
    ("kaff_s", "loop", None),
    ("force_limit_n", "loop", Some(Linear)),
    ("torque_limit_n_m", "loop", Some(Rotary)),
    ("current_time_constant_ms", "loop", None),
    ("current_delay_ms", "loop", None),
    ("friction_compensation_n", "feedforward", Some(Linear)),
    ("friction_compensation_n_m", "feedforward", Some(Rotary)),
    ("friction_smoothing_mm_s", "feedforward", Some(Linear)),
    ("friction_smoothing_deg_s", "feedforward", Some(Rotary)),
    ("backlash_compensation_mm", "feedforward", Some(Linear)),
    ("backlash_compensation_deg", "feedforward", Some(Rotary)),
    ("backlash_compensation_ms", "feedforward", None),
    ("encoder_counts_per_mm", "mechanics", Some(Linear)),
    ("encoder_counts_per_deg", "mechanics", Some(Rotary)),
    ("mass_kg", "mechanics", Some(Linear)),
    ("inertia_kg_m2", "mechanics", Some(Rotary)),
    ("peak_force_n", "mechanics", Some(Linear)),
    ("peak_torque_n_m", "mechanics", Some(Rotary)),
    ("friction_n", "mechanics", Some(Linear)),
    ("friction_n_m", "mechanics", Some(Rotary)),
    ("viscous_n_s_m", "mechanics", Some(Linear)),
    ("viscous_n_m_s_rad", "mechanics", Some(Rotary)),
    ("resonance_hz", "mechanics", None),
    ("load_ratio", "mechanics", None),
];

/// What the machine file holds of axes, drives and tools.
///
/// # Errors
/// A file that cannot be read.
pub(crate) fn parameters_view(own: &OwnMachine, machine: &Machine) -> Result<ParametersView, Failure> {
    let mut axes = Vec::new();
    for axis in &machine.axes {
        let of = |(.., kind): &&(&str, &str, Option<AxisKind>)| kind.is_none_or(|kind| kind == axis.kind);
        let (keys, groups): (Vec<&str>, Vec<&str>) =
            PARAMETERS.iter().filter(of).map(|(key, group, _)| (*key, *group)).unzip();
        let of_axis = own.numbers(&own.axis_table(&axis.name).unwrap_or_default(), &keys)?;
        let of_drive = own.numbers(&[Step::Table("drives"), Step::Table(&axis.name)], &keys)?;
        let values = keys.iter().zip(groups).zip(of_axis.into_iter().zip(of_drive));
        let values = values.map(|((key, group), (of_axis, of_drive))| {
            let value = if group == "axis" { of_axis } else { of_drive };
            ParameterView { key: (*key).to_owned(), group: group.to_owned(), value }
        });
        let notches = axis.drive.as_ref().map_or(&[][..], |drive| &drive.notches);
        axes.push(AxisParameters {
            name: axis.name.clone(),
            unit: axis.unit().to_owned(),
            has_drive: axis.drive.is_some(),
            values: values.collect(),
            notches: notches.iter().map(|n| [n.frequency_hz, n.depth, n.width_hz]).collect(),
        });
    }
    let head = |head: &seamwright_machine::Head| HeadView { name: head.name.clone(), tip_mm: head.tip.to_array() };
    let heads = machine.heads.iter().map(head).collect();
    Ok(ParametersView { machine: machine.title.clone(), file: String::new(), pending: false, axes, heads })
}
