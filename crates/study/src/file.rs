//! The study file.

use crate::distribution::{Distribution, Resolved};
use crate::sampling::Sampling;
use crate::sobol::DIMENSIONS;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, SchemaVersion};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::fmt;

/// Maximum number of draws.
pub const MAX_DRAWS: u64 = 10_000_000;
/// Maximum number of quantities: as many as the Sobol sequence has dimensions.
pub const MAX_QUANTITIES: usize = DIMENSIONS;
/// Maximum length of a quantity's name: it heads a column and a chart.
const MAX_NAME: usize = 60;

/// A study file: which quantities of a job are uncertain, and how many draws show what follows from that.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyFile {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Title, for people and for the report.
    #[serde(default)]
    pub title: String,
    /// The job: a job file relative to this file, or the name of an example.
    pub job: String,
    /// Number of draws, up to 10,000,000; 1000 if missing. A sweep makes that many for each of its values.
    #[serde(default = "default_draws")]
    pub draws: u64,
    /// Seed of the draws: the same seed gives the same draws.
    #[serde(default = "default_seed")]
    pub seed: u64,
    /// How values are drawn.
    #[serde(default)]
    pub sampling: Sampling,
    /// The uncertain quantities, up to 32.
    #[serde(default)]
    pub quantities: Vec<QuantityFile>,
}

fn default_draws() -> u64 {
    1000
}

fn default_seed() -> u64 {
    1
}

/// An uncertain quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuantityFile {
    /// Name in results; that of the key, error or axis if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The varied key, error or axis.
    pub vary: Target,
    /// Its distribution.
    pub draw: Distribution,
}

/// A key, an error or an axis that varies.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Target {
    /// A number of the job by the path of its key, as `joint.preparation.v.root_gap_mm` or `seam.nozzle.origin_mm[1]`.
    JobKey(String),
    /// A number of the machine file by the path of its key, as `tool[2].max_speed_mm_s`.
    MachineKey(String),
    /// An error in the position of the work, which moves seam and part.
    Work(WorkError),
    /// An error of an axis by the axis' name, mm or degrees: the axis stands this much further than it indicates. The plan
    /// compensates it, which takes range.
    AxisError(String),
}

/// An error in the position of the work, in the machine's work frame. Turns are about the origin of the seam's frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WorkError {
    /// Displacement along x, mm.
    XMm,
    /// Displacement along y, mm.
    YMm,
    /// Displacement along z, mm.
    ZMm,
    /// Tilt about x, degrees.
    TurnXDeg,
    /// Tilt about y, degrees.
    TurnYDeg,
    /// Turn about z, degrees.
    TurnZDeg,
}

impl WorkError {
    /// The word in the file.
    pub fn word(self) -> &'static str {
        match self {
            Self::XMm => "x_mm",
            Self::YMm => "y_mm",
            Self::ZMm => "z_mm",
            Self::TurnXDeg => "turn_x_deg",
            Self::TurnYDeg => "turn_y_deg",
            Self::TurnZDeg => "turn_z_deg",
        }
    }
}

impl Target {
    /// Key of this in `vary`.
    pub fn key(&self) -> &'static str {
        match self {
            Self::JobKey(_) => "job_key",
            Self::MachineKey(_) => "machine_key",
            Self::Work(_) => "work",
            Self::AxisError(_) => "axis_error",
        }
    }
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::JobKey(path) => f.write_str(path),
            Self::MachineKey(path) => write!(f, "machine.{path}"),
            Self::Work(error) => write!(f, "work.{}", error.word()),
            Self::AxisError(axis) => write!(f, "axis_error.{axis}"),
        }
    }
}

impl QuantityFile {
    /// Name in results.
    pub fn label(&self) -> String {
        self.name.clone().unwrap_or_else(|| self.vary.to_string())
    }
}

impl StudyFile {
    /// Reads a study file, called `file` in errors, and checks what needs neither job nor machine.
    ///
    /// # Errors
    /// With file, line and key: unknown keys, numbers out of range, no quantities, a quantity or a name twice.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        let document = Document::<Self>::read(file, text)?;
        let study = &document.value;
        if !(1..=MAX_DRAWS).contains(&study.draws) {
            let allowed = Message::new("study-allowed-draws").number("max", MAX_DRAWS as f64, 0);
            return Err(document.error_at("draws", Message::new("study-draws-unfit"), allowed));
        }
        let count = study.quantities.len();
        if !(1..=MAX_QUANTITIES).contains(&count) {
            let fault = if count == 0 { "study-no-quantities" } else { "study-too-many-quantities" };
            let allowed = Message::new("study-allowed-quantities").number("max", MAX_QUANTITIES as f64, 0);
            return Err(document.error_at("quantities", Message::new(fault), allowed));
        }
        for (i, quantity) in study.quantities.iter().enumerate() {
            let above = &study.quantities[..i];
            if above.iter().any(|other| other.vary == quantity.vary) {
                let message = Message::new("study-quantity-twice").text("name", quantity.vary.to_string());
                let path = format!("quantities[{i}].vary.{}", quantity.vary.key());
                return Err(document.error_at(&path, message, Message::new("study-once")));
            }
            let name = quantity.label();
            if name.is_empty() || quantity.name.as_ref().is_some_and(|name| name.chars().count() > MAX_NAME) {
                let allowed = Message::new("study-allowed-names").number("max", MAX_NAME as f64, 0);
                return Err(document.error_at(&name_key(i), Message::new("study-name-unfit"), allowed));
            }
            if above.iter().any(|other| other.label() == name) {
                let message = Message::new("study-name-twice").text("name", name);
                return Err(document.error_at(&name_key(i), message, Message::new("study-unique-names")));
            }
        }
        Ok(document)
    }

    /// The distribution of quantity `i` of a study file about its nominal value, `None` if no file gives it.
    ///
    /// # Errors
    /// At the key: missing or contradicting numbers, a minimum above the maximum, an invalid list of values.
    pub fn resolved(document: &Document<Self>, i: usize, nominal: Option<f64>) -> Result<Resolved, DocumentError> {
        let draw = &document.value.quantities[i].draw;
        draw.resolved(nominal).map_err(|fault| {
            document.error_at(&format!("quantities[{i}].draw.{}", fault.key), fault.message, fault.allowed)
        })
    }
}

fn name_key(i: usize) -> String {
    format!("quantities[{i}].name")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> DocumentError {
        StudyFile::read("study.toml", &format!("schema = 1\njob = \"saddle\"\n{text}")).unwrap_err()
    }

    const X: &str = "[[quantities]]\nvary.work = \"x_mm\"\ndraw.normal = { deviation = 1 }\n";

    #[test]
    fn a_study_has_defaults() {
        let study = StudyFile::read("study.toml", &format!("schema = 1\njob = \"saddle\"\n{X}")).unwrap().value;
        assert_eq!((study.draws, study.seed, study.sampling), (1000, 1, Sampling::LatinHypercube));
        assert_eq!(study.quantities[0].label(), "work.x_mm");
    }

    #[test]
    fn faults_name_the_key() {
        for (text, key) in [
            (String::new(), "quantities"),
            (format!("draws = 0\n{X}"), "draws"),
            (format!("{X}{X}"), "quantities[1].vary.work"),
            (X.replace("1 }", "-1 }"), "quantities[0].draw.normal.deviation"),
            (X.replace("deviation", "sigma"), "quantities[0].draw.normal"),
            (X.replace("x_mm", "x_cm"), "quantities[0].vary.work"),
            (
                format!("{X}name = \"a\"\n[[quantities]]\nname = \"a\"\nvary.axis_error = \"h\"\ndraw.values = [1]\n"),
                "quantities[1].name",
            ),
        ] {
            let error = fault(&text);
            assert!(error.key.starts_with(key), "{text}{error}");
        }
    }
}
