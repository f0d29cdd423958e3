//! Jobs: read, checked, planned.

use crate::fault::exception;
use crate::finding::Finding;
use crate::machine::Machine;
use crate::plan::Plan;
use crate::seam::Seam;
use crate::stoppable::{limit, plan};
use crate::values::{from_toml, toml_text};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use seamwright::motion::WeldMotion;
use seamwright::project::Failure;
use seamwright::project::examples::{EXAMPLES, example};
use seamwright::project::load::{Loaded, MachineFound, load, load_text, load_text_on};
use seamwright::project::planning::Planning;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A job: a seam, torch angles, speed, and the machine that welds it.
#[pyclass(frozen, module = "seamwright")]
pub(crate) struct Job {
    loaded: Arc<Loaded>,
    source: Source,
}

/// Source from which a job is read again for each plan.
#[derive(Clone)]
enum Source {
    Example(String),
    Text { name: String, text: String, folder: PathBuf },
}

impl Source {
    fn load(&self, on: Option<MachineFound>) -> Result<Loaded, Failure> {
        match (self, on) {
            (Self::Example(name), None) => load(Path::new(name)),
            (Self::Example(name), Some(machine)) => {
                let text = example(name).map_or("", |example| example.text);
                load_text_on(&format!("{name}.toml"), text, Path::new("."), machine)
            }
            (Self::Text { name, text, folder }, None) => load_text(name, text, folder),
            (Self::Text { name, text, folder }, Some(machine)) => load_text_on(name, text, folder, machine),
        }
    }
}

/// Names of the examples.
#[pyfunction]
#[pyo3(name = "examples")]
pub(crate) fn example_names() -> Vec<&'static str> {
    EXAMPLES.iter().map(|example| example.name).collect()
}

#[pymethods]
impl Job {
    /// Reads a job file, or takes the example of that name.
    #[staticmethod]
    fn load(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let name = path.display().to_string();
        let read = py.detach(|| {
            if example(&name).is_some() && !path.is_file() {
                return Ok(Source::Example(name));
            }
            // For a file that is missing the error says which examples there are.
            let text = match path.exists() {
                true => seamwright::project::files::read(&path)?,
                false => load(&path)?.welding.program.text().to_owned(),
            };
            let folder = path.parent().unwrap_or(Path::new(".")).to_owned();
            Ok(Source::Text { name, text, folder })
        });
        Self::read(py, read.map_err(|failure| exception(py, failure))?)
    }

    /// The job of a text in TOML; files that it names are relative to `folder`.
    #[staticmethod]
    #[pyo3(signature = (text, folder = PathBuf::from("."), name = "job"))]
    fn from_toml(py: Python<'_>, text: &str, folder: PathBuf, name: &str) -> PyResult<Self> {
        Self::read(py, Source::Text { name: name.to_owned(), text: text.to_owned(), folder })
    }

    /// The job of a dictionary with the keys of a job file.
    #[staticmethod]
    #[pyo3(signature = (values, folder = PathBuf::from("."), name = "job"))]
    fn from_dict(py: Python<'_>, values: &Bound<'_, PyDict>, folder: PathBuf, name: &str) -> PyResult<Self> {
        Self::from_toml(py, &toml_text(values)?, folder, name)
    }

    /// Title of the job.
    #[getter]
    fn title(&self) -> &str {
        &self.loaded.welding.program.value.title
    }

    /// The machine that the job names.
    #[getter]
    fn machine(&self) -> Machine {
        Machine::of(&self.loaded.machine, self.loaded.machine_file.as_deref())
    }

    /// The seam; None if all passes go through points.
    #[getter]
    fn seam(&self) -> Option<Seam> {
        Seam::of(&self.loaded)
    }

    /// The job as a text in TOML.
    #[getter]
    fn toml(&self) -> &str {
        self.loaded.welding.program.text()
    }

    /// The keys of the job file.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        // The text was read before.
        let table: toml::Table = toml::from_str(self.toml()).unwrap_or_default();
        Ok(from_toml(py, &toml::Value::Table(table))?.cast_into()?)
    }

    /// Plans the weld, or raises `NotWeldable` with the findings.
    #[pyo3(signature = (machine = None, *, time_limit_s = 60.0))]
    fn plan(&self, py: Python<'_>, machine: Option<&Bound<'_, PyAny>>, time_limit_s: f64) -> PyResult<Plan> {
        let planned = self.try_plan(py, machine, time_limit_s)?;
        let (loaded, motion) = (planned.0, planned.1);
        match motion {
            Ok(motion) if motion.findings.iter().all(|finding| finding.allowed) => Ok(Plan::new(loaded, motion)),
            Ok(motion) => Err(exception(py, Failure::Findings(motion.findings))),
            Err(findings) => Err(exception(py, Failure::Findings(findings))),
        }
    }

    /// All findings of a plan; the weld can be made if none of them is an error.
    #[pyo3(signature = (machine = None, *, time_limit_s = 60.0))]
    fn check(&self, py: Python<'_>, machine: Option<&Bound<'_, PyAny>>, time_limit_s: f64) -> PyResult<Vec<Finding>> {
        let (_, motion) = self.try_plan(py, machine, time_limit_s)?;
        let findings = motion.map_or_else(|findings| findings, |motion| motion.findings);
        Ok(findings.into_iter().map(Finding).collect())
    }

    fn __repr__(&self) -> String {
        format!("<job {:?} on {}>", self.title(), self.loaded.machine.name)
    }
}

/// A job with searched torch angles, and its motion or the findings that prevent it.
type Planned = (Loaded, Result<WeldMotion, Vec<seamwright::program::Finding>>);

impl Job {
    fn read(py: Python<'_>, source: Source) -> PyResult<Self> {
        let loaded = py.detach(|| source.load(None)).map_err(|failure| exception(py, failure))?;
        Ok(Self { loaded: Arc::new(loaded), source })
    }

    fn try_plan(&self, py: Python<'_>, machine: Option<&Bound<'_, PyAny>>, time_limit_s: f64) -> PyResult<Planned> {
        let (limit, on) = (limit(time_limit_s)?, machine.map(Machine::given).transpose()?);
        plan(py, limit, |planning: &Planning| {
            let loaded = self.source.load(on)?.with_torch_angles(planning)?;
            let motion = loaded.try_plan_under(&loaded.machine, planning)?;
            Ok((loaded, motion))
        })
    }
}
