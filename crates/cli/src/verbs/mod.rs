//! One module a verb.

pub(crate) mod bench;
pub(crate) mod cell;
pub(crate) mod check;
pub(crate) mod edit;
pub(crate) mod find_joint;
pub(crate) mod follow;
pub(crate) mod head_columns;
pub(crate) mod interpolate;
pub(crate) mod io;
mod job_limits;
pub(crate) mod kinematics;
pub(crate) mod latency;
pub(crate) mod licences;
pub(crate) mod lists;
mod log_settings;
pub(crate) mod machine;
pub(crate) mod motion;
pub(crate) mod move_to;
pub(crate) mod plan;
pub(crate) mod post;
mod process_columns;
pub(crate) mod pulses;
pub(crate) mod read;
pub(crate) mod records;
pub(crate) mod reduce;
mod row_destination;
pub(crate) mod run;
pub(crate) mod scan;
pub(crate) mod schedule;
pub(crate) mod schema;
pub(crate) mod seam;
mod seam_positions;
pub(crate) mod section;
pub(crate) mod serve;
pub(crate) mod shell;
pub(crate) mod simulate;
mod simulated_part;
pub(crate) mod stripe;
pub(crate) mod study;
pub(crate) mod teach;
mod weld_summary;

use crate::refusals::not_allowed;
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_project::failure::Failure;

/// A number from the command line that must be finite and greater than zero.
pub(crate) fn positive(name: &str, value: f64) -> Result<f64, Failure> {
    if value.is_finite() && value > 0.0 {
        return Ok(value);
    }
    Err(not_allowed(name, value, Message::new("document-positive-number")))
}

/// Period of the set-points, s: that of `--period-ms`, or the machine's.
fn period(period_ms: Option<f64>, machine: &Machine) -> Result<f64, Failure> {
    period_ms.map_or(Ok(machine.servo_period_s), |ms| Ok(positive("--period-ms", ms)? * 1e-3))
}
