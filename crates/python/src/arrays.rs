//! Numbers handed over to NumPy without a copy.

use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

/// An array with `columns` columns that owns `numbers`, row by row.
pub(crate) fn table(py: Python<'_>, numbers: Vec<f64>, columns: usize) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let rows = numbers.len().checked_div(columns).unwrap_or(0);
    let array = Array2::from_shape_vec((rows, columns), numbers).map_err(|e| PyValueError::new_err(e.to_string()))?;
    Ok(array.into_pyarray(py))
}
