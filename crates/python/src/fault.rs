//! Failures as exceptions of Python.

use crate::finding::Finding;
use pyo3::prelude::*;
use seamwright::message::{Language, Message};
use seamwright::project::Failure;

/// Content of an exception: a code, an address and words. `seamwright._errors` has the exceptions.
#[pyclass(frozen, module = "seamwright._native")]
pub(crate) struct Fault {
    class: &'static str,
    message: Message,
    code: Option<String>,
    address: Option<Address>,
    allowed: Option<Message>,
    findings: Vec<seamwright::program::Finding>,
}

/// Address of the fault in a file.
struct Address {
    file: String,
    line: usize,
    column: usize,
    key: String,
}

#[pymethods]
impl Fault {
    /// Name of the exception.
    #[getter]
    fn class_name(&self) -> &'static str {
        self.class
    }

    #[getter]
    fn code(&self) -> Option<&str> {
        self.code.as_deref()
    }

    #[getter]
    fn file(&self) -> Option<&str> {
        self.address.as_ref().map(|address| address.file.as_str())
    }

    /// From 1; none if the whole file is meant.
    #[getter]
    fn line(&self) -> Option<usize> {
        self.address.as_ref().map(|address| address.line).filter(|line| *line > 0)
    }

    #[getter]
    fn column(&self) -> Option<usize> {
        self.address.as_ref().filter(|address| address.line > 0).map(|address| address.column)
    }

    #[getter]
    fn key(&self) -> Option<&str> {
        self.address.as_ref().map(|address| address.key.as_str()).filter(|key| !key.is_empty())
    }

    #[getter]
    fn findings(&self) -> Vec<Finding> {
        self.findings.iter().cloned().map(Finding).collect()
    }

    fn text(&self, language: &str) -> PyResult<String> {
        Ok(self.message.in_language(spoken(language)?).trim_end().to_owned())
    }

    fn allowed(&self, language: &str) -> PyResult<Option<String>> {
        let language = spoken(language)?;
        Ok(self.allowed.as_ref().map(|allowed| allowed.in_language(language)))
    }
}

impl Fault {
    fn new(failure: Failure) -> Self {
        let (message, code) = (failure.message(), failure.code());
        let class = match &failure {
            Failure::Findings(_) | Failure::Printed => "NotWeldable",
            Failure::Input(_) | Failure::Document(_) => "InvalidInput",
            Failure::Cancelled => "Cancelled",
            Failure::Environment(_) | Failure::ReaderGone => "EnvironmentFailed",
        };
        let plain = Self { class, message, code, address: None, allowed: None, findings: Vec::new() };
        match failure {
            Failure::Findings(findings) => {
                let first = findings.iter().find(|finding| !finding.allowed);
                Self { code: first.map(|finding| finding.message.code.to_string()), findings, ..plain }
            }
            Failure::Document(error) => Self {
                code: (!error.message.is_verbatim()).then(|| error.message.code.to_string()),
                allowed: error.allowed,
                address: Some(Address { file: error.file, line: error.line, column: error.column, key: error.key }),
                ..plain
            },
            _ => plain,
        }
    }
}

/// The exception for a failure.
pub(crate) fn exception(py: Python<'_>, failure: Failure) -> PyErr {
    let fault = Fault::new(failure);
    let class = fault.class;
    let made = py.import("seamwright._errors").and_then(|errors| errors.getattr(class)?.call1((fault,)));
    made.map_or_else(|error| error, PyErr::from_value)
}

/// The exception for bad input.
pub(crate) fn invalid(py: Python<'_>, message: Message) -> PyErr {
    exception(py, Failure::Input(message))
}

/// The language with a code such as `de`.
///
/// # Errors
/// `ValueError` for another code, with the codes that are allowed.
pub(crate) fn spoken(code: &str) -> PyResult<Language> {
    code.parse().map_err(|codes| pyo3::exceptions::PyValueError::new_err(format!("unknown language {code:?}; {codes}")))
}
