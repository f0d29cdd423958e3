use super::File;
use crate::{Axis, AxisKind, Drive, DriveFile, Gains, Load};
use seamwright_document::{DocumentError, NonNegative, Positive};

/// Values of a load: mass or inertia, peak, Coulomb and viscous friction.
type LoadFile = (Option<Positive>, Option<Positive>, Option<NonNegative>, Option<NonNegative>);

pub(super) fn drive(file: &File, axis: &Axis, d: &DriveFile) -> Result<Drive, DocumentError> {
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
