use super::figures::{Figure, Nominal};
use crate::cluster::{Task, Work};
use crate::job_text::{JobText, Templates, carry, folder_of, template};
use crate::keys::Keys;
use schemars::schema_for;
use seamwright_document::{Document, DocumentError, Step, steps};
use seamwright_machine::MachineFile;
use seamwright_message::Message;
use seamwright_project::FileStore;
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, load_text_from};
use seamwright_study::{MAX_DRAWS, Resolved, Sampler, StudyFile, Target};
use seamwright_weld::Job;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Probabilities of the low and the high value of a quantity for the tornado chart.
pub(crate) const SWING: [f64; 2] = [0.05, 0.95];

/// A study, ready to run.
pub struct Study {
    pub(crate) file: Document<StudyFile>,
    pub(crate) path: PathBuf,
    /// The job with its nominal values.
    pub(crate) job: JobText,
    pub(crate) loaded: Loaded,
    pub(crate) machine_text: String,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) figures: Vec<Figure>,
    pub(crate) nominal: Nominal,
    /// Hash of everything besides the drawn values that a plan depends on.
    pub(crate) hash: String,
    /// Source of its files.
    pub(crate) store: FileStore,
    pub(crate) overrides: Overrides,
    sampler: Sampler,
    /// Draws for each combination of the sweeps' values.
    draws: u64,
    /// Number of these combinations.
    cells: u64,
}

/// An uncertain quantity.
#[derive(Debug, Clone)]
pub(crate) struct Quantity {
    pub(crate) name: String,
    pub(crate) target: Target,
    /// The value without uncertainty: as in the file, 0 of an error, of a key that no file gives the median.
    pub(crate) nominal: f64,
    pub(crate) distribution: Resolved,
}

/// Values that replace those of the study file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Overrides {
    /// Number of draws.
    pub draws: Option<u64>,
    /// Seed.
    pub seed: Option<u64>,
}

impl Study {
    /// Reads a study file with its job and machine, and checks them.
    ///
    /// # Errors
    /// With file, line and key: those of [`StudyFile::read`]; keys and axes that job or machine do not have; an invalid
    /// job or machine; too many draws.
    pub fn open(path: &Path, overrides: Overrides) -> Result<Self, Failure> {
        Self::open_from(path, overrides, FileStore::Disk)
    }

    /// The same with files of `store`.
    ///
    /// # Errors
    /// As [`Study::open`].
    pub(crate) fn open_from(path: &Path, overrides: Overrides, store: FileStore) -> Result<Self, Failure> {
        let name = path.display().to_string();
        let mut file = StudyFile::read(&name, &store.text(path)?)?;
        file.value.draws = overrides.draws.unwrap_or(file.value.draws);
        file.value.seed = overrides.seed.unwrap_or(file.value.seed);
        let job = template(folder_of(path), &file.value.job, &store).map_err(|why| {
            let message = Message::new("study-job-unreadable").message("why", why.message());
            Failure::from(file.error_at("job", message, Message::new("study-job-or-example")))
        })?;
        let loaded = load_text_from(&file.value.job, &job.text, &job.folder, &store)?;
        let machine_text = loaded.machine_text()?;
        let quantities = Sources::new(&job.text, &machine_text, &loaded).quantities(&file)?;
        let figures = Figure::all(&loaded.machine);
        check_columns(&file, &quantities, &figures)?;
        let cells = quantities.iter().filter_map(|q| q.distribution.values()).map(|values| values.len() as u64);
        let cells = cells.fold(1, u64::saturating_mul);
        let is_drawn = quantities.iter().any(|q| q.distribution.values().is_none());
        let draws = if is_drawn { file.value.draws } else { 1 };
        if draws == 0 || cells.saturating_mul(draws) > MAX_DRAWS {
            let allowed = Message::new("study-allowed-draws").number("max", MAX_DRAWS as f64, 0);
            return Err(file.error_at("draws", Message::new("study-draws-unfit"), allowed).into());
        }
        let targets: Vec<String> = quantities.iter().map(|q| q.target.to_string()).collect();
        let hash = Templates::default().hash(std::slice::from_ref(&job), &targets.join("\n"));
        let sampler = Sampler::new(file.value.sampling, file.value.seed, draws);
        let nominal = Nominal::of(&loaded);
        Ok(Self {
            file,
            path: path.to_owned(),
            job,
            loaded,
            machine_text,
            quantities,
            figures,
            nominal,
            hash,
            store,
            overrides,
            sampler,
            draws,
            cells,
        })
    }

    /// Task of the workers of a cluster for its draws.
    ///
    /// # Errors
    /// A file that has become unreadable.
    pub(crate) fn task(&self, limit: Duration) -> Result<Task, Failure> {
        let mut files = BTreeMap::new();
        let job = folder_of(&self.path).join(&self.file.value.job);
        for path in [Some(&self.path), Some(&job).filter(|job| job.is_file())].into_iter().flatten() {
            carry(path, &mut files)?;
        }
        Templates::default().carry(std::slice::from_ref(&self.job), &mut files)?;
        let Overrides { draws, seed } = self.overrides;
        Ok(Task::new(Work::Study { path: self.path.clone(), draws, seed }, limit, files))
    }

    /// Number of draws, for all combinations of the sweeps' values together.
    pub fn rows(&self) -> u64 {
        self.draws * self.cells
    }

    /// Values of row `row`, counted from 0, in the order of the quantities. They depend on the study file and the row only.
    pub fn values(&self, row: u64) -> Vec<f64> {
        let (mut cell, draw) = (row % self.cells, row / self.cells);
        let mut dimension = 0;
        let value = |quantity: &Quantity| match quantity.distribution.values() {
            Some(values) => {
                let at = cell % values.len() as u64;
                cell /= values.len() as u64;
                values[at as usize]
            }
            None => {
                dimension += 1;
                quantity.distribution.quantile(self.sampler.unit(draw, dimension - 1))
            }
        };
        self.quantities.iter().map(value).collect()
    }

    /// All quantities at their nominal values.
    pub(crate) fn nominal_values(&self) -> Vec<f64> {
        self.quantities.iter().map(|q| q.nominal).collect()
    }

    /// Quantity `i` at its low and its high value, the others at their nominal values.
    pub(crate) fn swing_values(&self, i: usize) -> [Vec<f64>; 2] {
        let ends = match self.quantities[i].distribution.values() {
            Some(values) => [f64::min, f64::max].map(|of| values.iter().copied().fold(values[0], of)),
            None => SWING.map(|u| self.quantities[i].distribution.quantile(u)),
        };
        ends.map(|end| {
            let mut values = self.nominal_values();
            values[i] = end;
            values
        })
    }
}

/// Files that give the nominal values.
struct Sources<'a> {
    job: toml::Table,
    machine: toml::Table,
    job_keys: Keys,
    machine_keys: Keys,
    loaded: &'a Loaded,
}

impl<'a> Sources<'a> {
    fn new(job: &str, machine: &str, loaded: &'a Loaded) -> Self {
        // Both texts have been read before.
        let table = |text: &str| toml::from_str(text).unwrap_or_default();
        Self {
            job: table(job),
            machine: table(machine),
            job_keys: Keys::of(&schema_for!(Job)),
            machine_keys: Keys::of(&schema_for!(MachineFile)),
            loaded,
        }
    }

    fn quantities(&self, file: &Document<StudyFile>) -> Result<Vec<Quantity>, DocumentError> {
        let quantity = |(i, given): (usize, &seamwright_study::QuantityFile)| {
            let nominal = self.nominal(file, i, &given.vary)?;
            let distribution = StudyFile::resolved(file, i, nominal)?;
            Ok(Quantity {
                name: given.label(),
                target: given.vary.clone(),
                nominal: nominal.unwrap_or_else(|| distribution.quantile(0.5)),
                distribution,
            })
        };
        file.value.quantities.iter().enumerate().map(quantity).collect()
    }

    /// The nominal value of what quantity `i` varies; none if it is a key that its file does not give.
    fn nominal(&self, file: &Document<StudyFile>, i: usize, target: &Target) -> Result<Option<f64>, DocumentError> {
        let at = format!("quantities[{i}].vary.{}", target.key());
        let (keys, table, path) = match target {
            Target::Work(_) => return Ok(Some(0.0)),
            Target::AxisError(name) => {
                let known: Vec<&str> = self.loaded.machine.axes.iter().map(|axis| axis.name.as_str()).collect();
                let found = step_of(&self.machine, name).map(|_| Some(0.0));
                return found.ok_or_else(|| file.unknown_name(&at, name, &known));
            }
            Target::JobKey(path) => (&self.job_keys, &self.job, path),
            Target::MachineKey(path) => (&self.machine_keys, &self.machine, path),
        };
        let unknown = || {
            let allowed = match keys.closest_path(path) {
                Some(meant) => Message::new("study-key-meant").key("name", &meant),
                None => Message::new("study-allowed-keys"),
            };
            file.error_at(&at, Message::new("study-key-unknown").key("key", path), allowed)
        };
        let steps = steps(path).filter(|_| keys.knows(path)).ok_or_else(unknown)?;
        match value_at(table, &steps) {
            None if matches!(target, Target::MachineKey(_)) => Err(unknown()),
            None => Ok(None),
            Some(toml::Value::Integer(value)) => Ok(Some(*value as f64)),
            Some(toml::Value::Float(value)) => Ok(Some(*value)),
            Some(_) => {
                let message = Message::new("study-not-a-number").key("key", path);
                Err(file.error_at(&at, message, Message::new("study-number-keys")))
            }
        }
    }
}

fn value_at<'a>(table: &'a toml::Table, path: &[Step]) -> Option<&'a toml::Value> {
    let (first, rest) = path.split_first()?;
    let Step::Key(key) = first else { return None };
    rest.iter().try_fold(table.get(key)?, |value, step| match step {
        Step::Key(key) => value.as_table()?.get(key),
        Step::Nth(nth) => value.as_array()?.get(*nth),
    })
}

/// The list of steps that an axis stands in, and its index there.
pub(crate) fn step_of(machine: &toml::Table, axis: &str) -> Option<(&'static str, usize)> {
    let in_list = |list: &'static str| {
        let steps = machine.get(list)?.as_array()?;
        let is_axis = |step: &toml::Value| step.get("axis").and_then(toml::Value::as_str) == Some(axis);
        Some((list, steps.iter().position(is_axis)?))
    };
    ["tool", "work"].into_iter().find_map(in_list)
}

/// Refuses names of quantities that are those of other columns.
fn check_columns(file: &Document<StudyFile>, quantities: &[Quantity], figures: &[Figure]) -> Result<(), DocumentError> {
    let figures: Vec<String> = figures.iter().map(|figure| figure.name.clone()).collect();
    let is_taken = |name: &str| super::columns::OWN.contains(&name) || figures.iter().any(|figure| figure == name);
    match quantities.iter().position(|q| is_taken(&q.name)) {
        None => Ok(()),
        Some(i) => {
            let message = Message::new("study-name-taken").text("name", &quantities[i].name);
            Err(file.error_at(&format!("quantities[{i}].name"), message, Message::new("study-unique-names")))
        }
    }
}
