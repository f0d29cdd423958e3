//! A planned weld: passes, set-points, part programs.

use crate::arrays::table;
use crate::fault::exception;
use crate::finding::Finding;
use crate::machine::Machine;
use numpy::PyArray2;
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use seamwright::motion::{PassMotion, SetPoint, WeldMotion};
use seamwright::project::Failure;
use seamwright::project::load::Loaded;
use seamwright::project::posting::{PostTarget, Unproven};

/// Columns of `progress`.
const PROGRESS: usize = 4;

/// The motion of all axes for a weld, within every limit.
#[pyclass(frozen, module = "seamwright")]
pub(crate) struct Plan {
    loaded: Loaded,
    motion: WeldMotion,
}

/// A pass of a plan.
#[pyclass(frozen, get_all, module = "seamwright")]
#[derive(Clone)]
pub(crate) struct PlannedPass {
    /// Number, from 1.
    number: usize,
    /// Name.
    name: String,
    /// Length, mm.
    length_mm: f64,
    /// Time of travel, s.
    travel_s: f64,
    /// Time with gas before and after, s.
    total_s: f64,
    /// Time with arc or beam on, s.
    arc_on_s: f64,
    /// Minimum speed of the tip between acceleration and deceleration, mm/s.
    slowest_mm_s: f64,
    /// Maximum speed there, mm/s.
    fastest_mm_s: f64,
}

#[pymethods]
impl PlannedPass {
    fn __repr__(&self) -> String {
        format!("<pass {} {:?}: {:.3} mm in {:.3} s>", self.number, self.name, self.length_mm, self.travel_s)
    }
}

/// Names of the controls that part programs are written for.
#[pyfunction]
#[pyo3(name = "posts")]
pub(crate) fn post_names() -> Vec<&'static str> {
    PostTarget::all().map(PostTarget::name).collect()
}

#[pymethods]
impl Plan {
    /// Notes and warnings about the weld.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        self.motion.findings.iter().cloned().map(Finding).collect()
    }

    /// The machine of the plan.
    #[getter]
    fn machine(&self) -> Machine {
        Machine::of(&self.loaded.machine, self.loaded.machine_file.as_deref())
    }

    /// Passes in the order of welding.
    #[getter]
    fn passes(&self) -> Vec<PlannedPass> {
        let passes = self.loaded.welding.program.value.passes.iter().zip(&self.motion.passes);
        let planned = |(i, (pass, motion)): (usize, (&seamwright::program::Pass, &PassMotion))| {
            let (slowest_mm_s, fastest_mm_s) = motion.tip_band(&self.loaded.machine);
            PlannedPass {
                number: i + 1,
                name: pass.name.clone(),
                length_mm: motion.path.length(),
                travel_s: motion.profile.duration(),
                total_s: motion.total_s(),
                arc_on_s: motion.arc_on_s(),
                slowest_mm_s,
                fastest_mm_s,
            }
        };
        passes.enumerate().map(planned).collect()
    }

    /// Time from home to home, s.
    #[getter]
    fn total_s(&self) -> f64 {
        self.motion.total_s()
    }

    /// Time with arc or beam on, s.
    #[getter]
    fn arc_on_s(&self) -> f64 {
        self.motion.passes.iter().map(PassMotion::arc_on_s).sum()
    }

    /// Positions of the axes at every period of a pass, in the units of files: a row for each instant.
    #[pyo3(signature = (pass_number = 1, period_s = None))]
    fn set_points<'py>(
        &self,
        py: Python<'py>,
        pass_number: usize,
        period_s: Option<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let axes = &self.loaded.machine.axes;
        let row = |point: &SetPoint, numbers: &mut Vec<f64>| {
            numbers.extend(axes.iter().zip(&point.q).map(|(axis, value)| axis.to_file(*value)));
        };
        self.sampled(py, pass_number, period_s, axes.len(), row)
    }

    /// Progress at the same instants: time, path length, speed along the path, and 1 where arc or beam is on.
    #[pyo3(signature = (pass_number = 1, period_s = None))]
    fn progress<'py>(
        &self,
        py: Python<'py>,
        pass_number: usize,
        period_s: Option<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let row = |point: &SetPoint, numbers: &mut Vec<f64>| {
            let is_on = f64::from(u8::from(point.phase.arc()));
            numbers.extend([point.t, point.profile.s, point.profile.v, is_on]);
        };
        self.sampled(py, pass_number, period_s, PROGRESS, row)
    }

    /// The part program for a control, proven by reading it back.
    fn post(&self, py: Python<'_>, control: &str) -> PyResult<String> {
        let target = PostTarget::named(control).ok_or_else(|| {
            let names = post_names().join(", ");
            PyValueError::new_err(format!("unknown control {control:?}; allowed: {names}"))
        })?;
        let proven = py.detach(|| target.proven(&self.loaded, &self.motion));
        let failure = |why: Unproven| match why {
            Unproven::Failure(failure) => failure,
            wrong @ Unproven::Wrong(_) => Failure::Input(wrong.message()),
        };
        proven.map(|(text, _)| text).map_err(|why| exception(py, failure(why)))
    }

    fn __repr__(&self) -> String {
        let (count, machine) = (self.motion.passes.len(), &self.loaded.machine.name);
        format!("<plan on {machine}: {count} passes, {:.3} s>", self.motion.total_s())
    }
}

impl Plan {
    pub(crate) fn new(loaded: Loaded, motion: WeldMotion) -> Self {
        Self { loaded, motion }
    }

    /// A row of `columns` numbers for every instant of a pass.
    fn sampled<'py>(
        &self,
        py: Python<'py>,
        pass_number: usize,
        period_s: Option<f64>,
        columns: usize,
        row: impl Fn(&SetPoint, &mut Vec<f64>) + Sync,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let count = self.motion.passes.len();
        let pass = pass_number.checked_sub(1).and_then(|i| self.motion.passes.get(i));
        let pass =
            pass.ok_or_else(|| PyIndexError::new_err(format!("pass {pass_number}: allowed are 1 to {count}")))?;
        let period = period_s.unwrap_or(self.loaded.machine.servo_period_s);
        if !(period > 0.0 && period.is_finite()) {
            return Err(PyValueError::new_err(format!("period_s = {period}: must be above 0")));
        }
        self.loaded.check_count(&self.motion, period).map_err(|failure| exception(py, failure))?;
        let numbers = py.detach(|| {
            let points = pass.set_points(period);
            let mut numbers = Vec::with_capacity(columns * points.size_hint().0);
            points.for_each(|point| row(&point, &mut numbers));
            numbers
        });
        table(py, numbers, columns)
    }
}
