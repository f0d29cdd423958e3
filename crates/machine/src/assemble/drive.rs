use super::File;
use crate::{
    Axis, AxisKind, BacklashCompensation, Drive, DriveFile, FrictionCompensation, Gains, Load, Notch, Transmission,
};
use seamwright_document::{DocumentError, NonNegative, Positive};

/// Maximum number of notches of a position loop.
const NOTCHES: usize = 2;
/// Default damping of a resonance: a steel structure with guides.
const DAMPING: f64 = 0.02;

/// The keys of one kind of axis, in mm or degrees; those of the other kind must be missing.
#[derive(PartialEq)]
struct Keys {
    inertia: Option<Positive>,
    peak: Option<Positive>,
    limit: Option<Positive>,
    friction: Option<NonNegative>,
    viscous: Option<NonNegative>,
    counts: Option<Positive>,
    backlash: Option<NonNegative>,
    friction_compensation: Option<NonNegative>,
    smoothing: Option<Positive>,
    backlash_compensation: Option<NonNegative>,
}

/// All keys missing.
const NO_KEYS: Keys = Keys {
    inertia: None,
    peak: None,
    limit: None,
    friction: None,
    viscous: None,
    counts: None,
    backlash: None,
    friction_compensation: None,
    smoothing: None,
    backlash_compensation: None,
};

fn keys(d: &DriveFile, kind: AxisKind) -> Keys {
    match kind {
        AxisKind::Linear => Keys {
            inertia: d.mass_kg,
            peak: d.peak_force_n,
            limit: d.force_limit_n,
            friction: d.friction_n,
            viscous: d.viscous_n_s_m,
            counts: d.encoder_counts_per_mm,
            backlash: d.backlash_mm,
            friction_compensation: d.friction_compensation_n,
            smoothing: d.friction_smoothing_mm_s,
            backlash_compensation: d.backlash_compensation_mm,
        },
        AxisKind::Rotary => Keys {
            inertia: d.inertia_kg_m2,
            peak: d.peak_torque_n_m,
            limit: d.torque_limit_n_m,
            friction: d.friction_n_m,
            viscous: d.viscous_n_m_s_rad,
            counts: d.encoder_counts_per_deg,
            backlash: d.backlash_deg,
            friction_compensation: d.friction_compensation_n_m,
            smoothing: d.friction_smoothing_deg_s,
            backlash_compensation: d.backlash_compensation_deg,
        },
    }
}

/// One `[drives.<axis>]` table.
struct Table<'a> {
    file: &'a File,
    axis: &'a Axis,
    d: &'a DriveFile,
    keys: Keys,
}

pub(super) fn drive(file: &File, axis: &Axis, d: &DriveFile) -> Result<Drive, DocumentError> {
    let path = format!("drives.{}", axis.name);
    let (other, what, needed) = match axis.kind {
        AxisKind::Linear => (
            AxisKind::Rotary,
            "a linear axis' drive has mass and force, and lengths in mm",
            "mass_kg, peak_force_n, encoder_counts_per_mm",
        ),
        AxisKind::Rotary => (
            AxisKind::Linear,
            "a rotary axis' drive has inertia and torque, and angles in degrees",
            "inertia_kg_m2, peak_torque_n_m, encoder_counts_per_deg",
        ),
    };
    if keys(d, other) != NO_KEYS {
        return Err(file.error_at(&path, what, needed));
    }
    let keys = keys(d, axis.kind);
    let (Some(inertia), Some(peak), Some(counts)) = (keys.inertia, keys.peak, keys.counts) else {
        return Err(file.error_at(&path, "the drive lacks a key", needed));
    };
    let (coulomb, viscous) = (value(keys.friction), value(keys.viscous));
    let table = Table { file, axis, d, keys };
    Ok(Drive {
        load: Load { inertia: inertia.get(), peak: peak.get(), coulomb, viscous },
        force_limit: table.limit(peak.get())?,
        encoder_counts_per_unit: 1.0 / axis.from_file(1.0 / counts.get()),
        velocity_bandwidth_hz: d.velocity_bandwidth_hz.get(),
        current_time_constant_s: d.current_time_constant_ms.map_or(Drive::CURRENT_TIME_CONSTANT_S, |t| t.get() * 1e-3),
        current_delay_s: d.current_delay_ms.map_or(0.0, |t| t.get() * 1e-3),
        transmission: table.transmission()?,
        gains: table.gains(),
        notches: table.notches()?,
        friction_compensation: table.friction_compensation()?,
        backlash_compensation: table.backlash_compensation()?,
    })
}

fn value(v: Option<NonNegative>) -> f64 {
    v.map_or(0.0, NonNegative::get)
}

impl Table<'_> {
    fn error(&self, key: &str, what: &str, allowed: &str) -> DocumentError {
        self.file.error_at(&format!("drives.{}{key}", self.axis.name), what, allowed)
    }

    /// The key's name on this kind of axis.
    fn named<'k>(&self, linear: &'k str, rotary: &'k str) -> &'k str {
        if self.axis.kind == AxisKind::Linear { linear } else { rotary }
    }

    fn limit(&self, peak: f64) -> Result<Option<f64>, DocumentError> {
        match self.keys.limit.map(Positive::get) {
            Some(limit) if limit > peak || limit <= value(self.keys.friction) => {
                let key = self.named(".force_limit_n", ".torque_limit_n_m");
                Err(self.error(key, "the limit is not between friction and peak", "above the friction, up to the peak"))
            }
            limit => Ok(limit),
        }
    }

    fn transmission(&self) -> Result<Option<Transmission>, DocumentError> {
        let d = self.d;
        let Some(resonance_hz) = d.resonance_hz else {
            let backlash = self.named(".backlash_mm", ".backlash_deg");
            let given = [
                (".resonance_damping", d.resonance_damping.is_some()),
                (".load_ratio", d.load_ratio.is_some()),
                (backlash, self.keys.backlash.is_some()),
                (".motor_friction", d.motor_friction.is_some()),
                (".encoder_on", d.encoder_on.is_some()),
            ];
            return match given.iter().find(|(_, given)| *given) {
                Some((key, _)) => {
                    Err(self.error(key, "motor and load are one mass without a resonance", "resonance_hz beside it"))
                }
                None => Ok(None),
            };
        };
        let Some(load_ratio) = d.load_ratio else {
            return Err(self.error(".resonance_hz", "a resonance takes two masses", "load_ratio beside it"));
        };
        let part = |key: &str, v: Option<NonNegative>, missing: f64| match v.map_or(missing, NonNegative::get) {
            v if v > 1.0 => Err(self.error(key, "a part of the whole", "0 to 1")),
            v => Ok(v),
        };
        Ok(Some(Transmission {
            resonance_hz: resonance_hz.get(),
            damping: part(".resonance_damping", d.resonance_damping, DAMPING)?,
            load_ratio: load_ratio.get(),
            backlash: self.axis.from_file(value(self.keys.backlash)),
            motor_friction: part(".motor_friction", d.motor_friction, 0.0)?,
            encoder_on: d.encoder_on.unwrap_or_default(),
        }))
    }

    fn gains(&self) -> Option<Gains> {
        let d = self.d;
        d.kp_per_s.or(d.ki_per_s2).or(d.kd).or(d.kvff).or(d.kaff_s)?;
        Some(Gains {
            kp: value(d.kp_per_s),
            ki: value(d.ki_per_s2),
            kd: value(d.kd),
            kvff: value(d.kvff),
            kaff: value(d.kaff_s),
        })
    }

    fn notches(&self) -> Result<Vec<Notch>, DocumentError> {
        if self.d.notches.len() > NOTCHES {
            return Err(self.error(".notches", "the position loop has places for two notches", "two or fewer"));
        }
        let half_rate = 0.5 / self.file.value.servo_period_ms.map_or(1e-3, |p| p.get() * 1e-3);
        let notch = |(i, n): (usize, &crate::NotchFile)| {
            let key = |name| format!(".notches[{i}].{name}");
            for (name, hz) in [("frequency_hz", n.frequency_hz.get()), ("width_hz", n.width_hz.get())] {
                if hz >= 0.999 * half_rate {
                    let what = format!("{hz} Hz is not below half the sampling rate");
                    return Err(self.error(&key(name), &what, &format!("below {half_rate} Hz")));
                }
            }
            if n.depth.get() > 1.0 {
                return Err(self.error(&key("depth"), "the gain at the centre", "0 to 1"));
            }
            Ok(Notch { frequency_hz: n.frequency_hz.get(), depth: n.depth.get(), width_hz: n.width_hz.get() })
        };
        self.d.notches.iter().enumerate().map(notch).collect()
    }

    fn friction_compensation(&self) -> Result<Option<FrictionCompensation>, DocumentError> {
        match (self.keys.friction_compensation, self.keys.smoothing) {
            (None, Some(_)) => {
                let key = self.named(".friction_smoothing_mm_s", ".friction_smoothing_deg_s");
                let other = self.named("friction_compensation_n", "friction_compensation_n_m");
                Err(self.error(key, "there is no friction compensation", &format!("{other} beside it")))
            }
            (force, smoothing) => Ok(force.map(|force| FrictionCompensation {
                force: force.get(),
                smoothing: smoothing
                    .map_or(FrictionCompensation::SMOOTHING * self.axis.max_speed, |v| self.axis.from_file(v.get())),
            })),
        }
    }

    fn backlash_compensation(&self) -> Result<Option<BacklashCompensation>, DocumentError> {
        match (self.keys.backlash_compensation, self.d.backlash_compensation_ms) {
            (None, Some(_)) => {
                let other = self.named("backlash_compensation_mm", "backlash_compensation_deg");
                let what = "there is no backlash compensation";
                Err(self.error(".backlash_compensation_ms", what, &format!("{other} beside it")))
            }
            (width, time) => Ok(width.map(|width| BacklashCompensation {
                width: self.axis.from_file(width.get()),
                time_s: time.map_or(BacklashCompensation::TIME_S, |t| t.get() * 1e-3),
            })),
        }
    }
}
