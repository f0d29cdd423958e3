use crate::wire::{AxisParameters, HeadView, ParameterView, ParametersView};
use seamwright_machine::{Axis, AxisKind, Drive, Machine};
use seamwright_project::Failure;
use seamwright_project::own_machine::{OwnMachine, Step};
use seamwright_servo::{BacklashCompensation, FrictionCompensation};

use AxisKind::{Linear, Rotary};

/// Numbers of an axis (`axis`) and its drive: key of the machine file, group, kind of axis that has it.
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

/// Returns axes, drives and tools of the machine file.
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
            let without = without(axis, key);
            ParameterView { key: (*key).to_owned(), group: group.to_owned(), value, without }
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

/// Returns the default of a number that is missing in the machine file, in its units.
fn without(axis: &Axis, key: &str) -> Option<f64> {
    match key {
        "home_mm" | "home_deg" => return Some(0.0),
        "max_jerk_mm_s3" | "max_jerk_deg_s3" => {
            return Some(axis.to_file(Axis { max_jerk: f64::INFINITY, ..axis.clone() }.jerk()));
        }
        _ => {}
    }
    let drive = axis.drive.as_ref()?;
    match key {
        // A missing gain is 0 if another one is given. If all are missing, the first one written replaces all.
        "kp_per_s" | "ki_per_s2" | "kd" | "kvff" | "kaff_s" => drive.gains.map(|_| 0.0),
        "force_limit_n" | "torque_limit_n_m" => Some(drive.load.peak),
        "current_time_constant_ms" => Some(1e3 * Drive::CURRENT_TIME_CONSTANT_S),
        "friction_smoothing_mm_s" | "friction_smoothing_deg_s" => {
            drive.friction_compensation.map(|_| axis.to_file(FrictionCompensation::SMOOTHING * axis.max_speed))
        }
        "backlash_compensation_ms" => drive.backlash_compensation.map(|_| 1e3 * BacklashCompensation::TIME_S),
        "current_delay_ms" | "friction_n" | "friction_n_m" | "viscous_n_s_m" | "viscous_n_m_s_rad" => Some(0.0),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::SHIPPED;
    use seamwright_project::own_machine::Setting;

    /// Returns the effective values of an axis, from the file or by default.
    fn acts(axis: &Axis) -> Vec<f64> {
        let mut all = vec![axis.home, axis.jerk()];
        let Some(d) = &axis.drive else { return all };
        all.extend([d.load.inertia, d.load.peak, d.load.coulomb, d.load.viscous, d.force_limit.unwrap_or(d.load.peak)]);
        all.extend([d.velocity_bandwidth_hz, d.current_time_constant_s, d.current_delay_s]);
        all.extend(d.gains.iter().flat_map(|g| [g.kp, g.ki, g.kd, g.kvff, g.kaff]));
        all.extend(d.friction_compensation.iter().flat_map(|f| [f.force, f.smoothing]));
        all.extend(d.backlash_compensation.iter().flat_map(|b| [b.width, b.time_s]));
        all
    }

    /// Writing a default into the file changes nothing.
    #[test]
    fn what_holds_without_a_number_is_told() {
        let mut told = 0;
        for shipped in SHIPPED {
            let own = |text: String| OwnMachine { path: "machine.toml".into(), text };
            // Both compensations are on, so that their defaults apply.
            let mut of = own(shipped.text.to_owned());
            let machine = of.check(&of.text).unwrap();
            for axis in machine.axes.iter().filter(|axis| axis.drive.is_some()) {
                let keys = match axis.kind {
                    Linear => ["friction_compensation_n", "backlash_compensation_mm"],
                    Rotary => ["friction_compensation_n_m", "backlash_compensation_deg"],
                };
                let table = [Step::Table("drives"), Step::Table(&axis.name)];
                of = own(of.with(&table, &keys.map(|key| (key, Setting::Number(Some(0.5))))).unwrap());
            }
            let machine = of.check(&of.text).unwrap();
            let view = parameters_view(&of, &machine).unwrap();
            for (i, axis) in view.axes.iter().enumerate() {
                let missing = axis.values.iter().filter(|v| v.value.is_none());
                for (key, group, value) in missing.filter_map(|v| Some((&v.key, &v.group, v.without?))) {
                    let table = match group.as_str() {
                        "axis" => of.axis_table(&axis.name).unwrap(),
                        _ => vec![Step::Table("drives"), Step::Table(&axis.name)],
                    };
                    let text = of.with(&table, &[(key, Setting::Number(Some(value)))]).unwrap();
                    let (before, after) = (acts(&machine.axes[i]), acts(&of.check(&text).unwrap().axes[i]));
                    assert_eq!(before.len(), after.len());
                    for (a, b) in before.iter().zip(&after) {
                        assert!((a - b).abs() <= 1e-12 * a.abs(), "{} {} {key}: {a} {b}", shipped.name, axis.name);
                    }
                    told += 1;
                }
            }
        }
        assert!(told > 60, "{told}");
    }
}
