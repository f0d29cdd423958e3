//! From the command line to an operation.

use crate::args::edit::{EditVerb, EventArgs};
use crate::refusals::{between, in_file, not_allowed, of_option};
use seamwright_document::serde_text;
use seamwright_message::Message;
use seamwright_program::edit::{
    AddEvent, AddPass, DeleteEvent, DeletePass, DeletePoints, DuplicatePass, InsertPoint, Interpolate, JoinSpans,
    Mirror, MovePass, Offset, Operation, Reduce, Renumber, ReversePass, ScaleSpeed, SetOffset, SetPass, SetPoint,
    SetProcess, SetVariable, ShiftStart, SplitSpan,
};
use seamwright_program::{PointEvent, Ramp, Repeat, SpanValue};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::path::Path;

/// The operation of a command line; `None` for those about the history.
pub(super) fn operation(verb: &EditVerb) -> Result<Option<Operation>, Failure> {
    use EditVerb as V;
    use Operation as O;
    Ok(Some(match verb.clone() {
        V::SetPoint { pass, point, set, speeds } => {
            let (set, speeds) = (set.into_iter().collect(), speeds.into_iter().collect());
            O::SetPoint(SetPoint { pass, point, set, speeds })
        }
        V::InsertPoint { pass, after, numbers } => O::InsertPoint(InsertPoint { pass, after, numbers }),
        V::DeletePoints { pass, from, to } => O::DeletePoints(DeletePoints { pass, from, to }),
        V::Interpolate { pass, span, along, via_mm, normal, pace } => {
            O::Interpolate(Interpolate { pass, span, along: word(&along)?, via_mm, normal, pace })
        }
        V::SplitSpan { pass, point, s_mm } => O::SplitSpan(SplitSpan { pass, point, s_mm }),
        V::JoinSpans { pass, span } => O::JoinSpans(JoinSpans { pass, span }),
        V::ReversePass { pass, seam_length_mm } => O::ReversePass(ReversePass { pass, seam_length_mm }),
        V::ShiftStart { pass, point, begin_mm, phi_deg } => {
            O::ShiftStart(ShiftStart { pass, point, begin_mm, phi_deg })
        }
        V::Mirror { pass, at_mm, normal, axis, about } => O::Mirror(Mirror { pass, at_mm, normal, axis, about }),
        V::Offset { pass, points, dx_mm, dy_mm, dz_mm, across_mm, out_mm, work_angle_deg } => {
            O::Offset(Offset { pass, points, dx_mm, dy_mm, dz_mm, across_mm, out_mm, work_angle_deg })
        }
        V::ScaleSpeed { pass, points, s_mm, factor } => O::ScaleSpeed(ScaleSpeed { pass, points, s_mm, factor }),
        V::SetProcess { pass, points, s_mm, name, value } => {
            let value = match value[..] {
                [from, to] => SpanValue::Ramp(Ramp { from, to }),
                [value] => SpanValue::Steady(value),
                _ => return Err(Failure::input(of_option("--value", Message::new("cli-edit-value")))),
            };
            O::SetProcess(SetProcess { pass, points, s_mm, name, value })
        }
        V::Renumber { pass, start, step } => O::Renumber(Renumber { pass, start, step }),
        V::Reduce { pass, tolerance_mm, axis_tolerance } => O::Reduce(Reduce { pass, tolerance_mm, axis_tolerance }),
        V::SetOffset { name } => O::SetOffset(SetOffset { name }),
        V::SetVariable { name, value } => O::SetVariable(SetVariable { name, value }),
        V::SetPass { pass, name, role, arc, repeat } => {
            let role = role.map(|role| word(&role)).transpose()?;
            let wrong = |times| not_allowed("--repeat", times, between(1.0, 1000.0));
            let repeat = repeat.map(|times| Repeat::new(times).ok_or_else(|| wrong(times))).transpose()?;
            O::SetPass(SetPass { pass, name, role, arc, repeat })
        }
        V::AddPass { at, from } => O::AddPass(AddPass { at, new: Box::new(json(&from)?) }),
        V::DeletePass { pass } => O::DeletePass(DeletePass { pass }),
        V::MovePass { pass, to } => O::MovePass(MovePass { pass, to }),
        V::DuplicatePass { pass, name } => O::DuplicatePass(DuplicatePass { pass, name }),
        V::AddEvent(args) => O::AddEvent(event(args)),
        V::DeleteEvent { pass, event } => O::DeleteEvent(DeleteEvent { pass, event }),
        V::Format => O::Format,
        V::Undo(_) | V::Redo(_) | V::History => return Ok(None),
    }))
}

fn event(args: EventArgs) -> AddEvent {
    let EventArgs { pass, after, gas, wire, output_number: output, on, message, call } = args;
    AddEvent { pass, event: PointEvent { after, gas, wire, output, on, message, call } }
}

/// One of a type's names, as files have it.
fn word<T: DeserializeOwned>(name: &str) -> Result<T, Failure> {
    serde_json::from_value(Value::String(name.to_owned())).map_err(|e| Failure::input(serde_text(&e.to_string())))
}

pub(super) fn json<T: DeserializeOwned>(path: &Path) -> Result<T, Failure> {
    let text = files::read(path)?;
    serde_json::from_str(&text).map_err(|e| {
        let fault = serde_text(&e.to_string());
        Failure::refused(in_file(&path.display().to_string(), fault), Message::new("cli-edit-see-schema"))
    })
}
