//! A planned job on its way from the panel to the cell.

use crate::devices::Connection;
use crate::prepared_task::{Prepared, fingerprint};
use crate::protocol::MAX_REQUEST;
use crate::task::{Planned, Task};
use seamwright_executive::Place;
use seamwright_machine::Joints;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_project::failure::Failure;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::simulated_part::Part;
use seamwright_project::torch_angles::SearchedTorch;
use seamwright_record::sha256;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// A planned job for the executive. The motion comes from the planner's process; the cell reads the job's text again, and
/// refuses both if they do not belong together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Program {
    /// The panel's number of this program.
    pub number: u32,
    /// Name of the job.
    pub job: String,
    /// Its text.
    pub text: String,
    /// Folder of jobs, in which files that the text names are looked for.
    pub folder: PathBuf,
    /// See [`fingerprint`]: of the machine for which it was planned.
    pub machine: String,
    /// The plan, see [`encode_plan`].
    #[serde(with = "bytes")]
    pub motion: Vec<u8>,
    /// SHA-256 of the motion.
    pub sha256: String,
    /// Start position, if not at the start of the first pass.
    pub from: Option<Place>,
    /// Returned unread to a panel that finds this cell running: what it needs to show the program.
    pub about: String,
    /// Deviation of a simulated part from the plan, see [`Part::distorted`].
    pub distortion: Option<String>,
}

/// Lists of bytes as such, not as lists of numbers.
mod bytes {
    use serde::de::{Error, Visitor};
    use serde::{Deserializer, Serializer};
    use std::fmt;

    pub(super) fn serialize<S: Serializer>(bytes: &[u8], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(bytes)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<u8>, D::Error> {
        struct Bytes;
        impl Visitor<'_> for Bytes {
            type Value = Vec<u8>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("bytes")
            }

            fn visit_bytes<E: Error>(self, bytes: &[u8]) -> Result<Vec<u8>, E> {
                Ok(bytes.to_vec())
            }

            fn visit_byte_buf<E: Error>(self, bytes: Vec<u8>) -> Result<Vec<u8>, E> {
                Ok(bytes)
            }
        }
        deserializer.deserialize_byte_buf(Bytes)
    }
}

/// Maximum size of an encoded plan, bytes: with its job it must fit into a request.
const MAX_PLAN: usize = MAX_REQUEST - (16 << 20);

/// The plan of a job as it crosses to another process: what its text does not say.
#[derive(Debug, Serialize, Deserialize)]
pub struct CrossingPlan<M = WeldMotion> {
    /// Torches whose angles were searched.
    pub torches: Vec<SearchedTorch>,
    /// The motion.
    pub motion: M,
}

/// Encodes the plan of `loaded` for another process: the `motion` and the torch angles that it was planned with.
///
/// # Errors
/// A plan that is too large to be sent to a cell.
pub fn encode_plan(loaded: &Loaded, motion: &WeldMotion) -> Result<Vec<u8>, Message> {
    let plan = CrossingPlan { torches: loaded.searched_torches().to_vec(), motion };
    let bytes = rmp_serde::to_vec_named(&plan).map_err(|e| Message::verbatim(e.to_string()))?;
    if bytes.len() <= MAX_PLAN {
        return Ok(bytes);
    }
    let mib = |bytes: usize| bytes as f64 / f64::from(1 << 20);
    let message = Message::new("cell-program-too-large").value("size", mib(bytes.len()).ceil(), Unit::MiB);
    Err(message.value("max", mib(MAX_PLAN), Unit::MiB))
}

/// Decodes the plan of [`encode_plan`] and checks that `loaded` can be run by its motion: [`WeldMotion::verify`]. The
/// torches are for [`Loaded::with_searched_torches`].
///
/// # Errors
/// Bytes that are no plan, or one of another job or machine.
pub fn decode_plan(bytes: &[u8], loaded: &Loaded) -> Result<CrossingPlan, Message> {
    let damaged = |e: rmp_serde::decode::Error| Message::new("cell-program-damaged").text("why", e.to_string());
    let plan: CrossingPlan = rmp_serde::from_slice(bytes).map_err(damaged)?;
    if plan.motion.passes.len() != loaded.welding.program.value.passes.len() {
        return Err(Message::new("cell-program-changed").text("job", loaded.welding.program.file()));
    }
    plan.motion.verify(&loaded.machine)?;
    Ok(plan)
}

impl Program {
    /// Reads and checks everything, and prepares it with the axes at the set-points of devices that serve it, or at home.
    ///
    /// # Errors
    /// Faults of the files, bytes that do not belong to them, or a position from which it cannot start.
    pub(crate) fn prepare(self, at: Option<(Connection, Joints)>) -> Result<Prepared, Message> {
        let Self { job, text, folder, machine, motion, sha256: hash, from, distortion, .. } = self;
        if sha256(&motion) != hash {
            return Err(Message::new("cell-program-damaged").text("why", "SHA-256"));
        }
        let loaded = load_foreign(&job, &text, &folder).map_err(|failure| failure.message())?;
        if fingerprint(&loaded.machine) != machine {
            return Err(Message::new("cell-program-changed").text("job", job));
        }
        let CrossingPlan { torches, motion } = decode_plan(&motion, &loaded)?;
        let loaded = loaded.with_searched_torches(torches).map_err(|failure| failure.message())?;
        let part = Part::distorted(distortion.as_deref()).map_err(|e| Failure::from(e).message())?;
        let values = loaded.welding.program.value.process_values();
        let at = at.filter(|(connection, _)| connection.serves(&machine, &values));
        let at = at.map_or(loaded.machine.home(), |(_, at)| at);
        Prepared::new(Task::Job(Box::new(Planned { loaded, motion, part })), &at, from).map_err(Message::verbatim)
    }
}

/// Performs all steps of [`Program`]'s preparation in a cell at home, and discards the result: a planner's process
/// does so first, within its limits of memory and time.
///
/// # Errors
/// See [`Program`].
pub fn try_program(program: Program) -> Result<(), Message> {
    program.prepare(None).map(drop)
}
