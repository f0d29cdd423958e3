use crate::axis::{Axis, AxisKind, Drive, EncoderSide, Load};
use crate::file::{DriveFile, File};
use seamwright_document::{DocumentError, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_servo::{self as servo, BacklashCompensation, FrictionCompensation, Gains, NotchSettings, Transmission};

const NOTCHES: usize = 2;
/// Default damping of a resonance: a steel structure with guides.
const DAMPING: f64 = 0.02;

/// The keys of one kind of axis, in mm or degrees; those of the other kind must be missing.
#[derive(PartialEq, Default)]
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

struct Table<'a> {
    file: &'a File,
    axis: &'a Axis,
    d: &'a DriveFile,
    keys: Keys,
}

pub(super) fn drive(file: &File, axis: &Axis, d: &DriveFile) -> Result<Drive, DocumentError> {
    let path = format!("drives.{}", axis.name);
    let (other, what, needed) = match axis.kind {
        AxisKind::Linear => {
            (AxisKind::Rotary, "machine-drive-of-linear", "mass_kg, peak_force_n, encoder_counts_per_mm")
        }
        AxisKind::Rotary => {
            (AxisKind::Linear, "machine-drive-of-rotary", "inertia_kg_m2, peak_torque_n_m, encoder_counts_per_deg")
        }
    };
    if keys(d, other) != Keys::default() {
        return Err(file.error_at(&path, Message::new(what), needed));
    }
    let keys = keys(d, axis.kind);
    let (Some(inertia), Some(peak), Some(counts)) = (keys.inertia, keys.peak, keys.counts) else {
        return Err(file.error_at(&path, Message::new("machine-drive-key-missing"), needed));
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

/// Allowed: only together with `key`.
fn beside(key: &str) -> Message {
    Message::new("machine-together-with").key("key", key)
}

fn fraction() -> Message {
    Message::new("document-between").value("min", 0.0, Unit::One).value("max", 1.0, Unit::One)
}

impl Table<'_> {
    fn error(&self, key: &str, code: &'static str, allowed: Message) -> DocumentError {
        self.error_of(key, Message::new(code), allowed)
    }

    fn error_of(&self, key: &str, message: Message, allowed: Message) -> DocumentError {
        self.file.error_at(&format!("drives.{}{key}", self.axis.name), message, allowed)
    }

    fn named<'k>(&self, linear: &'k str, rotary: &'k str) -> &'k str {
        if self.axis.kind == AxisKind::Linear { linear } else { rotary }
    }

    fn limit(&self, peak: f64) -> Result<Option<f64>, DocumentError> {
        match self.keys.limit.map(Positive::get) {
            Some(limit) if limit > peak || limit <= value(self.keys.friction) => {
                let key = self.named(".force_limit_n", ".torque_limit_n_m");
                let unit = if self.axis.kind == AxisKind::Linear { Unit::N } else { Unit::NM };
                let allowed = Message::new("document-more-than-up-to").value("min", value(self.keys.friction), unit);
                Err(self.error(key, "machine-drive-limit-range", allowed.value("max", peak, unit)))
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
                Some((key, _)) => Err(self.error(key, "machine-drive-without-resonance", beside("resonance_hz"))),
                None => Ok(None),
            };
        };
        let Some(load_ratio) = d.load_ratio else {
            return Err(self.error(".resonance_hz", "machine-drive-resonance-alone", beside("load_ratio")));
        };
        let part = |key: &str, v: Option<NonNegative>, missing: f64| match v.map_or(missing, NonNegative::get) {
            v if v > 1.0 => Err(self.error(key, "machine-fraction-too-large", fraction())),
            v => Ok(v),
        };
        Ok(Some(Transmission {
            resonance_hz: resonance_hz.get(),
            damping: part(".resonance_damping", d.resonance_damping, DAMPING)?,
            load_ratio: load_ratio.get(),
            backlash: self.axis.from_file(value(self.keys.backlash)),
            motor_friction: part(".motor_friction", d.motor_friction, 0.0)?,
            encoder_on: match d.encoder_on.unwrap_or_default() {
                EncoderSide::Motor => servo::EncoderSide::Motor,
                EncoderSide::Load => servo::EncoderSide::Load,
            },
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

    fn notches(&self) -> Result<Vec<NotchSettings>, DocumentError> {
        if self.d.notches.len() > NOTCHES {
            let allowed = Message::new("document-at-most").value("max", NOTCHES as f64, Unit::One);
            return Err(self.error(".notches", "machine-notches-many", allowed));
        }
        let half_rate = 0.5 / self.file.value.servo_period_ms.map_or(1e-3, |p| p.get() * 1e-3);
        let notch = |(i, n): (usize, &crate::file::NotchFile)| {
            let key = |name| format!(".notches[{i}].{name}");
            for (name, hz) in [("frequency_hz", n.frequency_hz.get()), ("width_hz", n.width_hz.get())] {
                if hz >= 0.999 * half_rate {
                    let message = Message::new("machine-notch-too-high").value("frequency", hz, Unit::Hz);
                    let allowed = Message::new("document-less-than").value("max", half_rate, Unit::Hz);
                    return Err(self.error_of(&key(name), message, allowed));
                }
            }
            if n.depth.get() > 1.0 {
                return Err(self.error(&key("depth"), "machine-notch-depth", fraction()));
            }
            let (frequency_hz, width_hz) = (n.frequency_hz.get(), n.width_hz.get());
            Ok(NotchSettings { frequency_hz, depth: n.depth.get(), width_hz })
        };
        self.d.notches.iter().enumerate().map(notch).collect()
    }

    fn friction_compensation(&self) -> Result<Option<FrictionCompensation>, DocumentError> {
        match (self.keys.friction_compensation, self.keys.smoothing) {
            (None, Some(_)) => {
                let key = self.named(".friction_smoothing_mm_s", ".friction_smoothing_deg_s");
                let other = self.named("friction_compensation_n", "friction_compensation_n_m");
                Err(self.error(key, "machine-friction-smoothing-alone", beside(other)))
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
                Err(self.error(".backlash_compensation_ms", "machine-backlash-time-alone", beside(other)))
            }
            (width, time) => Ok(width.map(|width| BacklashCompensation {
                width: self.axis.from_file(width.get()),
                time_s: time.map_or(BacklashCompensation::TIME_S, |t| t.get() * 1e-3),
            })),
        }
    }
}
