//! From the command line to an operation.

use crate::args::edit::{EditVerb, EventArgs};
use crate::refusals::{between, in_file, not_allowed, of_option};
use seamwright_document::serde_text;
use seamwright_message::Message;
use seamwright_program::edit::{AddEvent, AddPass, Operation};
use seamwright_program::{PointEvent, Repeat};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use serde::de::DeserializeOwned;
use std::path::Path;

/// The operation of a command line; `None` for those about the history.
pub(super) fn operation(verb: &EditVerb) -> Result<Option<Operation>, Failure> {
    Ok(match verb {
        EditVerb::Undo(_) | EditVerb::Redo(_) | EditVerb::History => None,
        EditVerb::AddPass { at, from } => Some(Operation::AddPass(AddPass { at: *at, new: Box::new(json(from)?) })),
        EditVerb::AddEvent(args) => Some(Operation::AddEvent(event(args.clone()))),
        EditVerb::SetProcess { value, .. } if !(1..=2).contains(&value.len()) => {
            return Err(Failure::input(of_option("--value", Message::new("cli-edit-value"))));
        }
        EditVerb::SetPass { repeat: Some(times), .. } if Repeat::new(*times).is_none() => {
            return Err(not_allowed("--repeat", times, between(1.0, 1000.0)));
        }
        other => {
            let operation = serde_json::to_value(other).and_then(serde_json::from_value);
            Some(operation.map_err(|e| Failure::input(serde_text(&e.to_string())))?)
        }
    })
}

fn event(args: EventArgs) -> AddEvent {
    let EventArgs { pass, after, gas, wire, output_number: output, on, message, call } = args;
    AddEvent { pass, event: PointEvent { after, gas, wire, output, on, message, call } }
}

pub(super) fn json<T: DeserializeOwned>(path: &Path) -> Result<T, Failure> {
    let text = files::read(path)?;
    serde_json::from_str(&text).map_err(|e| {
        let fault = serde_text(&e.to_string());
        Failure::refused(in_file(&path.display().to_string(), fault), Message::new("cli-edit-see-schema"))
    })
}
