//! The planner as a Python module: `seamwright._native`, wrapped by the package `seamwright` in `python/`.
//!
//! | task | start at |
//! |---|---|
//! | a job: read, check, plan | `job.rs` |
//! | a planned weld: passes, set-points, posts | `plan.rs` |
//! | a machine: forward and inverse kinematics | `machine.rs` |
//! | the seam as arrays | `seam.rs` |
//! | findings | `finding.rs` |
//! | errors as exceptions | `fault.rs` |
//! | tables and studies, also by workers of a cluster | `many.rs` |
//!
//! **Units.** Python sees those of files: mm, degrees and s. Poses are in the work frame.
//!
//! **Lock of the interpreter.** Reading, planning and posting release it. A plan in the main thread looks for signals
//! every 50 ms, so Ctrl-C ends it.
//!
//! **Arrays.** NumPy takes over the numbers of a plan without a copy.
//!
//! Tests are in `tests/`, run by `scripts/python`.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]
// Arguments of Python arrive as values.
#![allow(clippy::needless_pass_by_value)]

mod arrays;
mod fault;
mod finding;
mod job;
mod machine;
mod many;
mod plan;
mod seam;
mod stoppable;
mod values;

use pyo3::prelude::*;

/// The module that the package `seamwright` imports from.
#[pymodule]
mod _native {
    #[pymodule_export]
    use crate::fault::Fault;
    #[pymodule_export]
    use crate::finding::Finding;
    #[pymodule_export]
    use crate::job::{Job, example_names};
    #[pymodule_export]
    use crate::machine::{Axis, Machine, Pose, Solution, machine_names};
    #[pymodule_export]
    use crate::many::{ScheduleSummary, Worker, schedule, study};
    #[pymodule_export]
    use crate::plan::{Plan, PlannedPass, post_names};
    #[pymodule_export]
    use crate::seam::Seam;

    use pyo3::prelude::*;
    use seamwright::message::Language;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("LANGUAGES", Language::ALL.map(Language::code).to_vec())
    }
}
