//! Work that Ctrl-C ends, with the interpreter's lock released.

use crate::fault::exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use seamwright::motion::SearchProgress;
use seamwright::project::Failure;
use seamwright::project::planning::Planning;
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time between looks for signals.
const SIGNALS_EVERY: Duration = Duration::from_millis(50);
/// Maximum time limit of a plan, s.
const MAX_LIMIT_S: f64 = 1e6;

/// Calls the handlers of signals that have arrived; those of Python raise exceptions.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method is not general in its lifetime")]
fn handle_signals() -> PyResult<()> {
    Python::attach(|py| py.check_signals())
}

/// A time limit given in seconds.
///
/// # Errors
/// `ValueError` for anything that is no positive number up to 1e6.
pub(crate) fn limit(time_limit_s: f64) -> PyResult<Duration> {
    if time_limit_s > 0.0 && time_limit_s <= MAX_LIMIT_S {
        return Ok(Duration::from_secs_f64(time_limit_s));
    }
    Err(PyValueError::new_err(format!("time_limit_s = {time_limit_s}: must be above 0 and at most {MAX_LIMIT_S}")))
}

/// Plans without the interpreter's lock. A signal whose handler raises ends the plan with that exception.
pub(crate) fn plan<T: Send>(
    py: Python<'_>,
    limit: Duration,
    work: impl FnOnce(&Planning) -> Result<T, Failure> + Send,
) -> PyResult<T> {
    let raised: Mutex<Option<PyErr>> = Mutex::new(None);
    let cancel = AtomicBool::new(false);
    let result = py.detach(|| {
        let last = Cell::new(Instant::now());
        let look = |_: &SearchProgress| {
            if last.get().elapsed() < SIGNALS_EVERY {
                return;
            }
            last.set(Instant::now());
            if let Err(error) = handle_signals() {
                *raised.lock().unwrap_or_else(PoisonError::into_inner) = Some(error);
                cancel.store(true, Ordering::Relaxed);
            }
        };
        work(&Planning { limit: Some(limit), cancel: Some(&cancel), progress: Some(&look) })
    });
    match raised.into_inner().unwrap_or_else(PoisonError::into_inner) {
        Some(error) => Err(error),
        None => result.map_err(|failure| exception(py, failure)),
    }
}

/// Runs work of many plans in a thread of its own, without the interpreter's lock. A signal whose handler raises sets the
/// flag that the work gets, waits for its end, and raises that exception.
pub(crate) fn run<T: Send>(py: Python<'_>, work: impl FnOnce(&AtomicBool) -> Result<T, Failure> + Send) -> PyResult<T> {
    let cancel = AtomicBool::new(false);
    let (result, raised) = py.detach(|| {
        std::thread::scope(|scope| {
            let (done, ended) = channel::<()>();
            let cancel = &cancel;
            let thread = scope.spawn(move || {
                let result = work(cancel);
                drop(done);
                result
            });
            let mut raised = None;
            while ended.recv_timeout(SIGNALS_EVERY) == Err(RecvTimeoutError::Timeout) {
                if raised.is_none()
                    && let Err(error) = handle_signals()
                {
                    raised = Some(error);
                    cancel.store(true, Ordering::Relaxed);
                }
            }
            (thread.join(), raised)
        })
    });
    match (raised, result) {
        (Some(error), _) => Err(error),
        (None, Ok(result)) => result.map_err(|failure| exception(py, failure)),
        (None, Err(panic)) => std::panic::resume_unwind(panic),
    }
}
