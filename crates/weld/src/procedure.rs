//! The procedure that a job names.

use crate::job::Job;
use crate::outside_data::Outside;
use seamwright_document::{Document, DocumentError};
use seamwright_message::{Message, Unit};
use seamwright_program::{PROCEDURES, Procedure, shipped_procedure};
use std::path::Path;

/// The procedure of `job`; `outside` gets files by their paths from the job's folder. Fails with the address in the job
/// (no such procedure, another wire) or in the procedure file.
pub(crate) fn of_job(job: &Document<Job>, outside: &dyn Outside) -> Result<Option<Document<Procedure>>, DocumentError> {
    let Some(name) = &job.value.procedure else { return Ok(None) };
    let document = match shipped_procedure(name) {
        Some(shipped) => Procedure::read(shipped.name, shipped.text)?,
        None => {
            let bytes = outside.bytes(name).map_err(|e| {
                let names: Vec<&str> = PROCEDURES.iter().map(|p| p.name).collect();
                let allowed = Message::new("weld-allowed-procedure").text("names", names.join(", "));
                let message = Message::new("weld-procedure-unreadable").text("error", e.to_string());
                job.error_at("procedure", message, allowed)
            })?;
            let text = String::from_utf8(bytes).map_err(|_| {
                job.error_at("procedure", Message::new("weld-procedure-not-text"), Message::new("weld-allowed-toml"))
            })?;
            let folder = Path::new(job.file()).parent().unwrap_or(Path::new(""));
            Procedure::read(&folder.join(name).display().to_string(), &text)?
        }
    };
    check_wire(job, &document.value)?;
    Ok(Some(document))
}

/// Checks that the beads are planned with the procedure's wire.
fn check_wire(job: &Document<Job>, procedure: &Procedure) -> Result<(), DocumentError> {
    let beads = job.value.beads.as_ref().and_then(|beads| beads.wire_mm);
    match (beads, procedure.wire_diameter_mm) {
        (Some(of_job), Some(allowed)) if of_job != allowed => {
            let message = Message::new("weld-wrong-wire").text("procedure", &procedure.number);
            let message = message.value("wire", allowed.get(), Unit::Mm);
            let allowed = Message::new("weld-allowed-wire").value("wire", allowed.get(), Unit::Mm);
            Err(job.error_at("beads.wire_mm", message, allowed))
        }
        _ => Ok(()),
    }
}
