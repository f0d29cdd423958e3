//! Findings: faults of a weld, and notes about it.

use crate::fault::spoken;
use crate::values::from_json;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use seamwright::message::Language;
use seamwright::program::Severity;

/// A fault that keeps a weld from being made as requested, or a note about it.
#[pyclass(frozen, eq, module = "seamwright")]
#[derive(Clone, PartialEq)]
pub(crate) struct Finding(pub(crate) seamwright::program::Finding);

#[pymethods]
impl Finding {
    /// Short kind, stable for programs, such as `range` or `clearance`.
    #[getter]
    fn kind(&self) -> &str {
        &self.0.kind
    }

    /// Code of the message, stable for programs; see the reference of messages.
    #[getter]
    fn code(&self) -> &str {
        &self.0.message.code
    }

    /// `error` prevents the weld, `warning` asks for an action, `note` informs.
    #[getter]
    fn severity(&self) -> &'static str {
        match self.0.severity() {
            Severity::Error => "error",
            Severity::Warning => "warning",
            Severity::Note => "note",
        }
    }

    /// Number of the pass, from 1.
    #[getter]
    fn pass_number(&self) -> usize {
        self.0.pass
    }

    /// Path length where it begins, mm.
    #[getter]
    #[expect(clippy::wrong_self_convention, reason = "the name of the key in JSON")]
    fn from_mm(&self) -> f64 {
        self.0.from_mm
    }

    /// Path length where it ends, mm.
    #[getter]
    fn to_mm(&self) -> f64 {
        self.0.to_mm
    }

    /// Description of the fault in a language.
    #[pyo3(signature = (language = "en"))]
    fn text(&self, language: &str) -> PyResult<String> {
        Ok(self.0.message.in_language(spoken(language)?))
    }

    /// The cure, in a language; None if nothing is needed.
    #[pyo3(signature = (language = "en"))]
    fn cure(&self, language: &str) -> PyResult<Option<String>> {
        let language = spoken(language)?;
        Ok(self.0.cure.as_ref().map(|cure| cure.in_language(language)))
    }

    /// Everything as data, as `seamwright check --json` prints it.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let value = serde_json::to_value(&self.0).unwrap_or_default();
        from_json(py, &value)
    }

    /// Values of the message by name.
    #[getter]
    fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let value = serde_json::to_value(self.0.message.named_arguments()).unwrap_or_default();
        Ok(from_json(py, &value)?.cast_into()?)
    }

    fn __str__(&self) -> String {
        self.0.message.in_language(Language::English)
    }

    fn __repr__(&self) -> String {
        let (severity, code, pass) = (self.severity(), self.code(), self.0.pass);
        format!("<{severity} {code}: pass {pass}, s = {} to {} mm>", self.0.from_mm, self.0.to_mm)
    }
}
