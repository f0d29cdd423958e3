//! The procedure that a job names.

use crate::job::Job;
use crate::outside_data::Outside;
use seamwright_document::{Document, DocumentError, Positive};
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

/// Checks that beads and consumables have the procedure's wire.
fn check_wire(job: &Document<Job>, procedure: &Procedure) -> Result<(), DocumentError> {
    let Some(allowed) = procedure.wire_diameter_mm else { return Ok(()) };
    match wires(&job.value).into_iter().find(|(_, wire)| *wire != allowed) {
        Some((key, _)) => {
            let message = Message::new("weld-wrong-wire").text("procedure", &procedure.number);
            let message = message.value("wire", allowed.get(), Unit::Mm);
            let allowed = Message::new("weld-allowed-wire").value("wire", allowed.get(), Unit::Mm);
            Err(job.error_at(key, message, allowed))
        }
        None => Ok(()),
    }
}

/// Diameters of the wire in a job, each with its key, mm.
fn wires(job: &Job) -> Vec<(&'static str, Positive)> {
    let given = [
        ("beads.wire_mm", job.beads.as_ref().and_then(|beads| beads.wire_mm)),
        ("consumables.wire_mm", job.consumables.wire_mm),
    ];
    given.into_iter().filter_map(|(key, wire)| Some((key, wire?))).collect()
}

/// Checks that a job does not contradict itself about its wire. Fails with the second key's address.
pub(crate) fn check_one_wire(job: &Document<Job>) -> Result<(), DocumentError> {
    match wires(&job.value).as_slice() {
        [(first, wire), (second, other)] if wire != other => {
            let message = Message::new("weld-two-wires").key("other", *first).value("wire", wire.get(), Unit::Mm);
            let allowed = Message::new("weld-allowed-wire").value("wire", wire.get(), Unit::Mm);
            Err(job.error_at(second, message, allowed))
        }
        _ => Ok(()),
    }
}
