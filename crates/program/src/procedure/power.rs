use super::Procedure;
use crate::process::{ProcessValues, check_process_name};
use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;

/// Kind of a process value that determines power, with its factor to A, V or W.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Factor {
    Current(f64),
    Voltage(f64),
    Power(f64),
}

impl Factor {
    /// By the unit in which the name ends.
    fn of(name: &str) -> Option<Self> {
        match name.rsplit_once('_')?.1 {
            "ka" => Some(Self::Current(1e3)),
            "a" => Some(Self::Current(1.0)),
            "ma" => Some(Self::Current(1e-3)),
            "kv" => Some(Self::Voltage(1e3)),
            "v" => Some(Self::Voltage(1.0)),
            "kw" => Some(Self::Power(1e3)),
            "w" => Some(Self::Power(1.0)),
            _ => None,
        }
    }

    fn scale(self) -> f64 {
        match self {
            Self::Current(scale) | Self::Voltage(scale) | Self::Power(scale) => scale,
        }
    }
}

impl Procedure {
    /// Names of the process values whose product is the power.
    pub fn power_names(&self) -> impl Iterator<Item = &str> {
        let usual = self.process.power.iter().copied().filter(|_| self.power.is_none());
        self.power.iter().flatten().map(String::as_str).chain(usual)
    }

    /// The same, each with its factor to A, V or W.
    pub fn power_factors(&self) -> impl Iterator<Item = (&str, f64)> {
        self.power_names().filter_map(|name| Some((name, Factor::of(name)?.scale())))
    }

    /// Power, W, at a part (0 to 1) of a span with these process values; `None` if a value is missing.
    pub fn power_w(&self, values: &ProcessValues, part: f64) -> Option<f64> {
        let factor = |name: &str| Some(Factor::of(name)?.scale() * values.get(name)?.at(part));
        self.power_names().try_fold(1.0, |power, name| Some(power * factor(name)?))
    }

    /// Heat input, kJ/mm, of `power_w` at `speed_mm_s`: the thermal efficiency times the power over the speed
    /// (EN 1011-1, ISO/TR 17671-1). Infinite for a torch at rest.
    pub fn heat_input_kj_mm(&self, power_w: f64, speed_mm_s: f64) -> f64 {
        self.thermal_efficiency() * power_w / speed_mm_s / 1000.0
    }

    pub(super) fn check_power<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let Some(names) = &self.power else { return Ok(()) };
        for (i, name) in names.iter().enumerate() {
            check_process_name(file, &format!("{path}[{i}]"), name)?;
        }
        let factors: Vec<Option<Factor>> = names.iter().map(|name| Factor::of(name)).collect();
        match factors.as_slice() {
            [Some(Factor::Power(_))]
            | [Some(Factor::Current(_)), Some(Factor::Voltage(_))]
            | [Some(Factor::Voltage(_)), Some(Factor::Current(_))] => Ok(()),
            _ => Err(file.error_at(path, Message::new("program-no-power"), Message::new("program-power-values"))),
        }
    }
}
