use crate::{Attitude, SeamCurve};
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive, SchemaVersion, Transform};
use seamwright_program::{OnLimit, Pass, ProcessValues, Program, Seam, SeamStart, Sequence, Span, Tolerance, Torch};
use serde::{Deserialize, Serialize};

/// A job file: what is to be welded, how, and on which machine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Title, for people and for the report.
    pub title: String,
    /// The machine: a name of one that ships, or a path to a machine file from the job's folder.
    pub machine: String,
    /// The seam's frame in the machine's work frame.
    #[serde(default)]
    pub placement: Transform,
    /// The seam.
    pub seam: Seam,
    /// Where on the seam welding starts, which way it goes, how far it overlaps.
    #[serde(default)]
    pub start: SeamStart,
    /// Torch angles.
    #[serde(default)]
    pub torch: Torch,
    /// How far from what was asked the weld may be.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Times before and after the travel.
    #[serde(default)]
    pub sequence: Sequence,
    /// Speed and process.
    pub weld: Weld,
}

/// Speed and process of the weld.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Weld {
    /// Speed of the torch tip along the seam, relative to the work, mm/s.
    pub speed_mm_s: Positive,
    /// What to do where an axis cannot keep that speed.
    #[serde(default)]
    pub on_limit: OnLimit,
    /// Process values by name; the name ends in its unit: `current_a`, `voltage_v`, `wire_feed_m_min` and so on.
    #[serde(default)]
    pub process: ProcessValues,
}

impl Job {
    /// Reads a job file.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        let job = Document::<Self>::read(file, text)?;
        for (name, value) in &job.value.weld.process {
            check_process(&job, name, *value)?;
        }
        Ok(job)
    }

    /// The program that welds `job` along its `seam`, in one pass.
    ///
    /// # Errors
    /// With the key's address: torch angles that do not fit the seam.
    pub fn program(job: &Document<Self>, seam: &SeamCurve) -> Result<Program, DocumentError> {
        let j = &job.value;
        Attitude::new(job, "torch", &j.torch, seam)?;
        let whole = |what: &str, value: f64| {
            let message = format!("the {what} has no length");
            Positive::new(value).ok_or_else(|| job.error_at("seam", message, "a seam with a length"))
        };
        let span = Span {
            from_mm: NonNegative::default(),
            to_mm: whole("weld", seam.weld_length())?,
            speed_mm_s: j.weld.speed_mm_s,
            process: j.weld.process.clone(),
        };
        let pass = Pass {
            name: "pass 1".to_owned(),
            on_limit: j.weld.on_limit,
            sequence: j.sequence,
            torch: j.torch.clone(),
            tolerance: j.tolerance,
            spans: vec![span],
        };
        Ok(Program {
            schema: SchemaVersion,
            title: j.title.clone(),
            machine: j.machine.clone(),
            placement: j.placement,
            seam: j.seam.clone(),
            start: j.start,
            passes: vec![pass],
        })
    }
}

/// A process value's name becomes a column: plain letters, ending in a unit.
fn check_process(job: &Document<Job>, name: &str, value: Finite) -> Result<(), DocumentError> {
    let path = format!("weld.process.{name}");
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if !name.chars().all(plain) || !name.contains('_') {
        let allowed = "lower-case letters, digits and _, ending in the unit, like current_a";
        return Err(job.error_at(&path, "this is no name of a process value", allowed));
    }
    if ["t_s", "s_mm", "speed_mm_s", "tip_s_mm", "path_error_mm"].contains(&name) {
        return Err(job.error_at(&path, "another column has this name", "a name of its own"));
    }
    if value.get() < 0.0 {
        return Err(job.error_at(&path, "a process value is not negative", "0 or greater"));
    }
    Ok(())
}
