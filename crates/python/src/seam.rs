//! The seam of a job as arrays, by path length.

use crate::arrays::table;
use numpy::{PyArray2, PyArray3, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use seamwright::glam::{DAffine3, DVec3};
use seamwright::project::load::Loaded;
use seamwright::weld::{SeamCurve, SeamPoint};
use std::sync::Arc;

/// The seam of a job in the work frame, in the direction of welding.
#[pyclass(frozen, module = "seamwright")]
pub(crate) struct Seam {
    loaded: Arc<Loaded>,
    frame: DAffine3,
}

#[pymethods]
impl Seam {
    /// Length of the whole seam, mm.
    #[getter]
    fn length_mm(&self) -> PyResult<f64> {
        Ok(self.curve()?.length())
    }

    /// Length that is welded, mm.
    #[getter]
    fn weld_length_mm(&self) -> PyResult<f64> {
        Ok(self.curve()?.weld_length())
    }

    /// Points on the seam: x, y, z in a row for each path length.
    fn points<'py>(&self, py: Python<'py>, s_mm: Vec<f64>) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let curve = self.curve()?;
        let mut numbers = Vec::with_capacity(3 * s_mm.len());
        for s in s_mm {
            numbers.extend(self.frame.transform_point3(at(curve, s)?.point).to_array());
        }
        table(py, numbers, 3)
    }

    /// Frames along the seam: 4 x 4 matrices with the columns along the seam, towards the first part, out of the joint,
    /// and the point.
    fn frames<'py>(&self, py: Python<'py>, s_mm: Vec<f64>) -> PyResult<Bound<'py, PyArray3<f64>>> {
        let curve = self.curve()?;
        let count = s_mm.len();
        let mut numbers = Vec::with_capacity(16 * count);
        for s in s_mm {
            let p = at(curve, s)?;
            let axes = [p.along, p.towards_first, p.bisector].map(|axis| self.frame.transform_vector3(axis));
            let columns = [axes[0], axes[1], axes[2], self.frame.transform_point3(p.point)];
            for row in 0..3 {
                numbers.extend(columns.map(|column: DVec3| column.to_array()[row]));
            }
            numbers.extend([0.0, 0.0, 0.0, 1.0]);
        }
        table(py, numbers, 16)?.reshape([count, 4, 4])
    }

    /// Angle between the two faces, seen from the torch, at each path length, degrees.
    fn dihedral_deg(&self, s_mm: Vec<f64>) -> PyResult<Vec<f64>> {
        let curve = self.curve()?;
        s_mm.into_iter().map(|s| Ok(at(curve, s)?.dihedral.to_degrees())).collect()
    }

    fn __repr__(&self) -> PyResult<String> {
        Ok(format!("<seam: {:.3} mm>", self.curve()?.length()))
    }
}

impl Seam {
    /// The seam of a job; none if its passes go through points.
    pub(crate) fn of(loaded: &Arc<Loaded>) -> Option<Self> {
        loaded.welding.seam.as_ref()?;
        Some(Self { loaded: Arc::clone(loaded), frame: loaded.welding.program.value.seam_in_work() })
    }

    fn curve(&self) -> PyResult<&SeamCurve> {
        let missing = || PyValueError::new_err("the job has no seam");
        self.loaded.welding.seam.as_ref().ok_or_else(missing)
    }
}

/// The seam at path length `s`: of a closed seam any number, of an open one within its length.
fn at(curve: &SeamCurve, s: f64) -> PyResult<SeamPoint> {
    if s.is_finite() {
        return Ok(curve.at(s));
    }
    Err(PyValueError::new_err(format!("s = {s}: a path length is a finite number")))
}
