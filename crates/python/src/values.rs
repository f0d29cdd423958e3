//! Values of files as values of Python.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};

/// Maximum depth of nested values: more is a value that contains itself.
const MAX_DEPTH: u32 = 64;

/// A value of JSON as one of Python.
pub(crate) fn from_json<'py>(py: Python<'py>, value: &serde_json::Value) -> PyResult<Bound<'py, PyAny>> {
    use serde_json::Value;
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(truth) => PyBool::new(py, *truth).to_owned().into_any(),
        Value::Number(number) => match number.as_i64() {
            Some(whole) => whole.into_pyobject(py)?.into_any(),
            None => number.as_f64().unwrap_or(f64::NAN).into_pyobject(py)?.into_any(),
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(list) => {
            let items = list.iter().map(|item| from_json(py, item)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, items)?.into_any()
        }
        Value::Object(table) => {
            let dict = PyDict::new(py);
            for (key, value) in table {
                dict.set_item(key, from_json(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// A value of TOML as one of Python; dates are texts.
pub(crate) fn from_toml<'py>(py: Python<'py>, value: &toml::Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        toml::Value::String(text) => PyString::new(py, text).into_any(),
        toml::Value::Integer(number) => number.into_pyobject(py)?.into_any(),
        toml::Value::Float(number) => number.into_pyobject(py)?.into_any(),
        toml::Value::Boolean(truth) => PyBool::new(py, *truth).to_owned().into_any(),
        toml::Value::Datetime(date) => PyString::new(py, &date.to_string()).into_any(),
        toml::Value::Array(list) => {
            let items = list.iter().map(|item| from_toml(py, item)).collect::<PyResult<Vec<_>>>()?;
            PyList::new(py, items)?.into_any()
        }
        toml::Value::Table(table) => {
            let dict = PyDict::new(py);
            for (key, value) in table {
                dict.set_item(key, from_toml(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// The text of a file with the values of a dictionary.
///
/// # Errors
/// `TypeError` for a value that no file can have, with its path.
pub(crate) fn toml_text(dict: &Bound<'_, PyDict>) -> PyResult<String> {
    let table = to_toml(dict.as_any(), "", 0)?;
    toml::to_string(&table).map_err(|e| PyTypeError::new_err(e.to_string()))
}

fn to_toml(value: &Bound<'_, PyAny>, path: &str, depth: u32) -> PyResult<toml::Value> {
    let refused = |what: &str| Err(PyTypeError::new_err(format!("{path}: a file cannot have {what}")));
    if depth > MAX_DEPTH {
        return refused("a value that contains itself");
    }
    // Of NumPy's scalars those of one number have `item`.
    let plain = match value.hasattr("item")? && !value.is_instance_of::<PyDict>() {
        true => value.call_method0("item")?,
        false => value.clone(),
    };
    if let Ok(truth) = plain.cast::<PyBool>() {
        return Ok(toml::Value::Boolean(truth.is_true()));
    }
    if plain.is_instance_of::<PyInt>() {
        return Ok(toml::Value::Integer(plain.extract()?));
    }
    if plain.is_instance_of::<PyFloat>() {
        return Ok(toml::Value::Float(plain.extract()?));
    }
    if let Ok(text) = plain.cast::<PyString>() {
        return Ok(toml::Value::String(text.to_str()?.to_owned()));
    }
    if let Ok(dict) = plain.cast::<PyDict>() {
        let mut table = toml::Table::new();
        for (key, value) in dict {
            let Ok(key) = key.extract::<String>() else { return refused("a key that is no text") };
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            table.insert(key, to_toml(&value, &path, depth + 1)?);
        }
        return Ok(toml::Value::Table(table));
    }
    if plain.is_instance_of::<PyList>() || plain.is_instance_of::<PyTuple>() {
        let items = plain.try_iter()?.enumerate();
        let item = |(i, item): (usize, PyResult<Bound<'_, PyAny>>)| to_toml(&item?, &format!("{path}[{i}]"), depth + 1);
        return Ok(toml::Value::Array(items.map(item).collect::<PyResult<_>>()?));
    }
    refused(&format!("a {}", plain.get_type().name()?))
}
