//! One draw: its job and machine, planned.

use super::figures::measure;
use super::open::{Quantity, Study, step_of};
use crate::plan_row::{Status, counted, status_of};
use glam::{DAffine3, DQuat, DVec3, EulerRot};
use seamwright_document::{Change, TomlText};
use seamwright_message::{Language, Message};
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, MachineFound, load_text_on_from, machine_text_from};
use seamwright_project::placing::placed;
use seamwright_project::planning::Planning;
use seamwright_record::sha256;
use seamwright_study::{Target, WorkError};
use seamwright_weld::Welding;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// Result of a draw.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DrawResult {
    /// Outcome.
    pub status: Status,
    /// Figures in the order of the study's; none if the plan does not have them.
    pub figures: Vec<Option<f64>>,
    /// Number of findings by code.
    pub findings: BTreeMap<String, usize>,
    /// Number of findings that prevent the weld.
    pub blocking: usize,
    /// The fault of an invalid or failed draw, in the language of the process.
    pub error: Option<String>,
}

/// Limits of a draw.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DrawTerms<'a> {
    /// Time limit of its searches.
    pub(crate) limit: Duration,
    /// Set to cancel it.
    pub(crate) cancel: Option<&'a AtomicBool>,
    /// Language of faults.
    pub(crate) language: Language,
}

impl DrawResult {
    fn without_plan(status: Status, error: String) -> Self {
        Self { status, figures: Vec::new(), findings: BTreeMap::new(), blocking: 0, error: Some(error) }
    }

    /// A draw whose planner failed.
    pub(crate) fn failed(language: Language) -> Self {
        Self::without_plan(Status::Failed, Message::new("study-planner-failed").in_language(language))
    }
}

/// A change that sets a number; whole numbers are written as such, since a key may demand them.
fn set(path: &str, value: f64) -> Change {
    let value = if value.fract() == 0.0 && value.abs() < 1e15 { json!(value as i64) } else { json!(value) };
    Change::Set { path: path.to_owned(), value }
}

fn set_all(numbers: Vec<(String, f64)>) -> Vec<Change> {
    numbers.into_iter().map(|(path, value)| set(&path, value)).collect()
}

impl Study {
    /// Hash of everything that the result of a draw with these values depends on.
    pub(crate) fn hash_of(&self, values: &[f64], limit: Duration) -> u64 {
        let bits: Vec<String> = values.iter().map(|value| format!("{:x}", value.to_bits())).collect();
        let hash = sha256(format!("{}\n{limit:?}\n{}", self.hash, bits.join(" ")).as_bytes());
        // 64 bits: among ten million draws two are alike with a probability of 3e-6.
        u64::from_str_radix(&hash[..16], 16).unwrap_or_default()
    }

    /// Plans the draw with these values.
    ///
    /// # Errors
    /// [`Failure::Cancelled`] only: a fault of the draw is a result.
    pub(crate) fn plan(&self, values: &[f64], terms: DrawTerms) -> Result<DrawResult, Failure> {
        let planning = Planning { limit: Some(terms.limit), cancel: terms.cancel, progress: None };
        match catch_unwind(AssertUnwindSafe(|| self.try_plan(values, &planning))) {
            Ok(Ok(result)) => Ok(result),
            Ok(Err(Failure::Cancelled)) => Err(Failure::Cancelled),
            Ok(Err(failure)) => Ok(DrawResult::without_plan(Status::Invalid, failure.text_in(terms.language))),
            Err(_) => Ok(DrawResult::failed(terms.language)),
        }
    }

    fn try_plan(&self, values: &[f64], planning: &Planning) -> Result<DrawResult, Failure> {
        let loaded = self.loaded(values)?.with_torch_angles(planning)?;
        let motion = loaded.try_plan_under(&loaded.machine, planning)?;
        let figures = measure(&self.figures, &self.nominal, &loaded, motion.as_ref());
        let (findings, planned) = match &motion {
            Ok(motion) => (&motion.findings, Status::Weldable),
            Err(findings) => (findings, status_of(findings)),
        };
        let (blocking, by_code) = counted(findings);
        let status = if planned == Status::Weldable && blocking > 0 { Status::NotWeldable } else { planned };
        Ok(DrawResult { status, figures, findings: by_code, blocking, error: None })
    }

    /// Job and machine with these values.
    pub(crate) fn loaded(&self, values: &[f64]) -> Result<Loaded, Failure> {
        let machine = self.machine(values)?;
        let text = self.job_text(values)?;
        load_text_on_from(&self.file.value.job, &text, &self.job.folder, machine, &self.store)
    }

    /// Values of the quantities that are of a kind, each with what it varies.
    fn of<T>(&self, values: &[f64], part: impl Fn(&Target) -> Option<T>) -> Vec<(T, f64)> {
        let one = |(quantity, value): (&Quantity, &f64)| Some((part(&quantity.target)?, *value));
        self.quantities.iter().zip(values).filter_map(one).collect()
    }

    fn job_text(&self, values: &[f64]) -> Result<String, Failure> {
        let name = &self.file.value.job;
        let changes =
            set_all(self.of(values, |t| if let Target::JobKey(path) = t { Some(path.clone()) } else { None }));
        let text = match changes.is_empty() {
            true => self.job.text.clone(),
            false => TomlText::parse(name, &self.job.text)?.changed(name, &changes)?.text().to_owned(),
        };
        let errors = self.of(values, |t| if let Target::Work(error) = t { Some(*error) } else { None });
        if errors.is_empty() {
            return Ok(text);
        }
        // Changed keys may move the seam's frame.
        let places = |path: &str| ["placement", "offset", "copies", "rows"].iter().any(|key| path.starts_with(key));
        let moves = changes.iter().any(|change| matches!(change, Change::Set { path, .. } if places(path)));
        let changed = moves.then(|| Welding::read(name, &text)).transpose()?;
        let program = changed.as_ref().map_or(&self.loaded.welding.program, |welding| &welding.program);
        let origin = program.value.copy_in_work(0).translation;
        Ok(placed(&text, program, &displacement(&errors, origin))?.text)
    }

    fn machine(&self, values: &[f64]) -> Result<MachineFound, Failure> {
        let file = self.loaded.machine_file.clone();
        let keys = |target: &Target| if let Target::MachineKey(path) = target { Some(path.clone()) } else { None };
        let axes = |target: &Target| if let Target::AxisError(axis) = target { Some(axis.clone()) } else { None };
        let mut changes = set_all(self.of(values, keys));
        let errors = self.of(values, axes);
        if changes.is_empty() && errors.is_empty() {
            return Ok(MachineFound { machine: self.loaded.machine.clone(), file });
        }
        changes.extend(axis_changes(&self.machine_text, errors));
        let name = file.as_ref().map_or_else(|| self.loaded.machine.name.clone(), |path| path.display().to_string());
        let text = TomlText::parse(&name, &self.machine_text)?.changed(&name, &changes)?;
        let folder = self.loaded.folder();
        Ok(MachineFound { machine: machine_text_from(&name, text.text(), Path::new(folder), &self.store)?, file })
    }
}

/// The displacement of the work by these errors: turned about `origin`, about x first, then moved.
fn displacement(errors: &[(WorkError, f64)], origin: DVec3) -> DAffine3 {
    let of = |wanted: WorkError| errors.iter().find(|(error, _)| *error == wanted).map_or(0.0, |(_, value)| *value);
    let moved = DVec3::new(of(WorkError::XMm), of(WorkError::YMm), of(WorkError::ZMm));
    let [x, y, z] = [WorkError::TurnXDeg, WorkError::TurnYDeg, WorkError::TurnZDeg].map(|turn| of(turn).to_radians());
    let turn = DQuat::from_euler(EulerRot::ZYX, z, y, x);
    DAffine3::from_translation(moved + origin) * DAffine3::from_quat(turn) * DAffine3::from_translation(-origin)
}

/// Fixed displacements in front of axes, which then stand further by their errors, mm or degrees, than they indicate.
fn axis_changes(machine: &str, errors: Vec<(String, f64)>) -> Vec<Change> {
    let table: toml::Table = toml::from_str(machine).unwrap_or_default();
    let change = |(axis, value): (String, f64)| {
        let (list, nth) = step_of(&table, &axis)?;
        let step = table.get(list)?.as_array()?.get(nth)?;
        Some(((list, nth), fixed_step(step, value)?))
    };
    let mut found: Vec<((&str, usize), Value)> = errors.into_iter().filter_map(change).collect();
    // From the last one on, so that the indices of the others stay.
    found.sort_by(|a, b| b.0.cmp(&a.0));
    let insert =
        |((list, nth), value): ((&str, usize), Value)| Change::Insert { path: format!("{list}[{nth}]"), value };
    found.into_iter().map(insert).collect()
}

/// The step that moves what follows it as its axis does by `error`, mm or degrees.
fn fixed_step(step: &toml::Value, error: f64) -> Option<Value> {
    let vector = |value: &toml::Value| {
        let number = |v: &toml::Value| v.as_float().or_else(|| v.as_integer().map(|n| n as f64));
        let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(number).collect();
        <[f64; 3]>::try_from(numbers?).ok().map(DVec3::from_array)
    };
    if let Some(direction) = step.get("move").and_then(vector) {
        return Some(json!({ "fixed": { "move_mm": (direction.normalize_or_zero() * error).to_array() } }));
    }
    let axis = step.get("turn").and_then(vector)?;
    let at = step.get("at_mm").and_then(vector).unwrap_or(DVec3::ZERO);
    let turned = DQuat::from_axis_angle(axis.normalize_or(DVec3::Z), error.to_radians()) * at;
    Some(json!({ "fixed": { "turn": axis.to_array(), "angle_deg": error, "move_mm": (at - turned).to_array() } }))
}
