//! Machines and their kinematics.

use crate::arrays::table;
use crate::fault::{exception, invalid};
use numpy::{AllowTypeChange, PyArray2, PyArrayLike2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use seamwright::glam::DVec3;
use seamwright::machine::{AxisKind, Joints, SHIPPED, Target};
use seamwright::project::load::{MachineFound, machine_text};
use std::path::{Path, PathBuf};

/// Numbers of a pose as a row: position and direction.
const POSE: usize = 6;

/// A machine: axes, limits, kinematics.
#[pyclass(frozen, module = "seamwright")]
#[derive(Clone)]
pub(crate) struct Machine(pub(crate) MachineFound);

/// Position of the torch tip and direction of the torch in the work frame, mm.
#[pyclass(frozen, eq, get_all, from_py_object, module = "seamwright")]
#[derive(Clone, PartialEq)]
pub(crate) struct Pose {
    /// Position of the torch tip: x, y, z, mm.
    point: [f64; 3],
    /// Unit vector in which the torch points.
    direction: [f64; 3],
}

/// Positions of all axes that bring the torch to a pose, mm or degrees.
#[pyclass(frozen, eq, get_all, module = "seamwright")]
#[derive(Clone, PartialEq)]
pub(crate) struct Solution {
    /// Positions of the axes, mm or degrees.
    joints: Vec<f64>,
    /// True if all axes are in their ranges.
    in_range: bool,
    /// Angle between requested and reached direction, degrees.
    attitude_error_deg: f64,
    /// True if the pose leaves an axis free.
    singular: bool,
}

/// An axis with its limits, mm or degrees.
#[pyclass(frozen, get_all, module = "seamwright")]
#[derive(Clone)]
pub(crate) struct Axis {
    /// Name in files.
    name: String,
    /// `mm` or `deg`.
    unit: &'static str,
    /// Lowest and highest position; None for an axis without ends.
    range: Option<(f64, f64)>,
    /// Position after homing.
    home: f64,
    /// Maximum speed, mm/s or degrees/s.
    max_speed: f64,
    /// Maximum acceleration, mm/s² or degrees/s².
    max_acceleration: f64,
}

/// Names of the machines that ship.
#[pyfunction]
#[pyo3(name = "machines")]
pub(crate) fn machine_names() -> Vec<&'static str> {
    SHIPPED.iter().map(|shipped| shipped.name).collect()
}

#[pymethods]
impl Pose {
    /// A pose; the direction may have any length.
    #[new]
    fn new(point: [f64; 3], direction: [f64; 3]) -> PyResult<Self> {
        let unit = DVec3::from_array(direction).try_normalize();
        let unit = unit.filter(|unit| unit.is_finite() && point.iter().all(|value| value.is_finite()));
        let unit =
            unit.ok_or_else(|| PyValueError::new_err("a pose needs finite numbers and a direction that is not 0"))?;
        Ok(Self { point, direction: unit.to_array() })
    }

    fn __repr__(&self) -> String {
        format!("Pose(point={:?}, direction={:?})", self.point, self.direction)
    }
}

#[pymethods]
impl Solution {
    fn __repr__(&self) -> String {
        let place = if self.in_range { "in range" } else { "beyond a range" };
        format!("<{:?}, {place}>", self.joints)
    }
}

#[pymethods]
impl Axis {
    fn __repr__(&self) -> String {
        format!("<axis {}, {}>", self.name, self.unit)
    }
}

#[pymethods]
impl Machine {
    /// Reads a machine file, or takes the machine of that name that ships.
    #[staticmethod]
    fn load(py: Python<'_>, name_or_path: PathBuf) -> PyResult<Self> {
        let name = name_or_path.display().to_string();
        let is_shipped = seamwright::machine::shipped(&name).is_some();
        let machine = py.detach(|| seamwright::project::load::machine(&name));
        let machine = machine.map_err(|failure| exception(py, failure))?;
        Ok(Self(MachineFound { machine, file: (!is_shipped).then_some(name_or_path) }))
    }

    /// The machine of a text in TOML; files that it names are relative to `folder`.
    #[staticmethod]
    #[pyo3(signature = (text, folder = PathBuf::from("."), name = "machine"))]
    fn from_toml(py: Python<'_>, text: &str, folder: PathBuf, name: &str) -> PyResult<Self> {
        let machine = py.detach(|| machine_text(name, text, &folder));
        let machine = machine.map_err(|failure| exception(py, failure))?;
        Ok(Self(MachineFound { machine, file: Some(folder.join(name)) }))
    }

    /// The machine of a dictionary with the keys of a machine file.
    #[staticmethod]
    #[pyo3(signature = (values, folder = PathBuf::from("."), name = "machine"))]
    fn from_dict(py: Python<'_>, values: &Bound<'_, PyDict>, folder: PathBuf, name: &str) -> PyResult<Self> {
        Self::from_toml(py, &crate::values::toml_text(values)?, folder, name)
    }

    /// Name, as jobs use it.
    #[getter]
    fn name(&self) -> &str {
        &self.0.machine.name
    }

    /// Title, for people.
    #[getter]
    fn title(&self) -> &str {
        &self.0.machine.title
    }

    /// Axes in the order of the machine file.
    #[getter]
    fn axes(&self) -> Vec<Axis> {
        let axis = |axis: &seamwright::machine::Axis| Axis {
            name: axis.name.clone(),
            unit: if axis.kind == AxisKind::Linear { "mm" } else { "deg" },
            range: axis.range.map(|(low, high)| (axis.to_file(low), axis.to_file(high))),
            home: axis.to_file(axis.home),
            max_speed: axis.to_file(axis.max_speed),
            max_acceleration: axis.to_file(axis.max_acceleration),
        };
        self.0.machine.axes.iter().map(axis).collect()
    }

    /// Positions of all axes after homing, mm or degrees.
    #[getter]
    fn home(&self) -> Vec<f64> {
        self.to_file(&self.0.machine.home())
    }

    /// Period of set-points, s.
    #[getter]
    fn servo_period_s(&self) -> f64 {
        self.0.machine.servo_period_s
    }

    /// The pose of the torch at these positions of the axes.
    fn forward(&self, joints: Vec<f64>) -> PyResult<Pose> {
        let pose = self.0.machine.forward(&self.joints(&joints)?);
        Ok(Pose { point: pose.point.to_array(), direction: pose.direction.to_array() })
    }

    /// The poses for a table of positions: a row each, position and direction.
    fn forward_table<'py>(
        &self,
        py: Python<'py>,
        joints: PyArrayLike2<'py, f64, AllowTypeChange>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let joints = joints.as_array();
        let mut numbers = Vec::with_capacity(POSE * joints.nrows());
        for row in joints.rows() {
            let pose = self.0.machine.forward(&self.joints(&row.to_vec())?);
            numbers.extend(pose.point.to_array());
            numbers.extend(pose.direction.to_array());
        }
        table(py, numbers, POSE)
    }

    /// All branches of positions for a pose, with rotary axes turned into their ranges if possible.
    #[pyo3(signature = (pose, near = None))]
    fn inverse(&self, py: Python<'_>, pose: &Pose, near: Option<Vec<f64>>) -> PyResult<Vec<Solution>> {
        let machine = &self.0.machine;
        let near = near.map_or_else(|| Ok(machine.home()), |near| self.joints(&near))?;
        let branches = machine.inverse(Self::target(pose), &near);
        let branches = branches.map_err(|reason| invalid(py, reason.message()))?;
        Ok(branches.iter().map(|solution| self.solution(solution)).collect())
    }

    /// The solutions within all ranges, nearest to `near` first; redundant axes are varied if none is.
    #[pyo3(signature = (pose, near = None))]
    fn reach(&self, py: Python<'_>, pose: &Pose, near: Option<Vec<f64>>) -> PyResult<Vec<Solution>> {
        let machine = &self.0.machine;
        let near = near.map_or_else(|| Ok(machine.home()), |near| self.joints(&near))?;
        let found = py.detach(|| machine.reach(Self::target(pose), &near));
        let found = found.map_err(|reason| invalid(py, reason.message()))?;
        Ok(found.iter().map(|solution| self.solution(solution)).collect())
    }

    fn __repr__(&self) -> String {
        format!("<machine {}: {} axes>", self.0.machine.name, self.0.machine.axes.len())
    }
}

impl Machine {
    /// The machine that a job names, as it is.
    pub(crate) fn of(machine: &seamwright::machine::Machine, file: Option<&Path>) -> Self {
        Self(MachineFound { machine: machine.clone(), file: file.map(Path::to_owned) })
    }

    /// The machine given: one that was read, or its name or path.
    ///
    /// # Errors
    /// Those of `Machine.load`.
    pub(crate) fn given(given: &Bound<'_, PyAny>) -> PyResult<MachineFound> {
        if let Ok(machine) = given.cast::<Self>() {
            return Ok(machine.get().0.clone());
        }
        Self::load(given.py(), given.extract()?).map(|machine| machine.0)
    }

    fn target(pose: &Pose) -> Target {
        let (point, direction) = (DVec3::from_array(pose.point), DVec3::from_array(pose.direction));
        Target::from(seamwright::geometry::Pose { point, direction })
    }

    fn joints(&self, given: &[f64]) -> PyResult<Joints> {
        let machine = &self.0.machine;
        if given.len() != machine.axes.len() || !given.iter().all(|value| value.is_finite()) {
            let names: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
            let (count, names) = (names.len(), names.join(", "));
            let message = format!("{} positions: {count} finite numbers are needed, for the axes {names}", given.len());
            return Err(PyValueError::new_err(message));
        }
        Ok(machine.joints_from_file(given))
    }

    fn to_file(&self, q: &Joints) -> Vec<f64> {
        self.0.machine.axes.iter().zip(q).map(|(axis, value)| axis.to_file(*value)).collect()
    }

    fn solution(&self, solution: &seamwright::machine::Solution) -> Solution {
        let machine = &self.0.machine;
        let joints = machine.turned_into_range(&solution.joints);
        Solution {
            joints: self.to_file(&joints),
            in_range: machine.outside(&joints).is_none(),
            attitude_error_deg: solution.attitude_error.to_degrees(),
            singular: solution.singular,
        }
    }
}
