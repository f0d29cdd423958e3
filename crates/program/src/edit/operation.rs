//! Edits of a program, as data.

use super::draft::Draft;
use super::report::Report;
use super::{mirror_and_offset, pass_direction, passes, points, reduce, spans, values};
use schemars::JsonSchema;
use seamwright_document::DocumentError;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};

/// An edit of a program. Passes, spans and events count from 1; points as events count them: 0 is the start, 1 the first
/// point reached. Numbers are those of files: mm, degrees, s.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "op", rename_all = "snake_case")]
pub enum Operation {
    /// Sets numbers of a point.
    SetPoint(points::SetPoint),
    /// Inserts a point.
    InsertPoint(points::InsertPoint),
    /// Deletes points; their times go to the next one left.
    DeletePoints(points::DeletePoints),
    /// Changes the way to the points of a span.
    Interpolate(spans::Interpolate),
    /// Splits a span in two.
    SplitSpan(spans::SplitSpan),
    /// Joins a span with the next one.
    JoinSpans(spans::JoinSpans),
    /// Turns a pass to run from its end to its start.
    ReversePass(pass_direction::ReversePass),
    /// Shifts where a closed run of points, a pass along the seam or the weld begins.
    ShiftStart(pass_direction::ShiftStart),
    /// Mirrors points: about a plane, or positions of an axis about a value.
    Mirror(mirror_and_offset::Mirror),
    /// Moves points by the torch's frame, or a pass beside the seam.
    Offset(mirror_and_offset::Offset),
    /// Makes the travel faster or slower.
    ScaleSpeed(values::ScaleSpeed),
    /// Sets a process value over a range.
    SetProcess(values::SetProcess),
    /// Numbers the points of a pass, or of all, in column `n`.
    Renumber(values::Renumber),
    /// Points joined by lines become as few lines and arcs as a tolerance lets them.
    Reduce(reduce::Reduce),
    /// Sets the work offset in force.
    SetOffset(passes::SetOffset),
    /// Sets a variable, or takes it out.
    SetVariable(passes::SetVariable),
    /// Sets name, role, arc or repetitions of a pass.
    SetPass(passes::SetPass),
    /// Adds a pass.
    AddPass(passes::AddPass),
    /// Deletes a pass.
    DeletePass(passes::DeletePass),
    /// Moves a pass to another place in the order.
    MovePass(passes::MovePass),
    /// Puts a copy of a pass behind it.
    DuplicatePass(passes::DuplicatePass),
    /// Adds an event to a pass through points.
    AddEvent(passes::AddEvent),
    /// Deletes an event.
    DeleteEvent(passes::DeleteEvent),
    /// Writes the document in the usual order and layout; the program stays the same.
    Format,
}

impl Operation {
    /// Makes the edit in a draft; `Format` leaves it unchanged.
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        match self {
            Self::SetPoint(o) => o.apply(draft),
            Self::InsertPoint(o) => o.apply(draft),
            Self::DeletePoints(o) => o.apply(draft),
            Self::Interpolate(o) => o.apply(draft),
            Self::SplitSpan(o) => o.apply(draft),
            Self::JoinSpans(o) => o.apply(draft),
            Self::ReversePass(o) => o.apply(draft),
            Self::ShiftStart(o) => o.apply(draft),
            Self::Mirror(o) => o.apply(draft),
            Self::Offset(o) => o.apply(draft),
            Self::ScaleSpeed(o) => o.apply(draft),
            Self::SetProcess(o) => o.apply(draft),
            Self::Renumber(o) => o.apply(draft),
            Self::Reduce(o) => o.apply(draft),
            Self::SetOffset(o) => o.apply(draft),
            Self::SetVariable(o) => o.apply(draft),
            Self::SetPass(o) => o.apply(draft),
            Self::AddPass(o) => o.apply(draft),
            Self::DeletePass(o) => o.apply(draft),
            Self::MovePass(o) => o.apply(draft),
            Self::DuplicatePass(o) => o.apply(draft),
            Self::AddEvent(o) => o.apply(draft),
            Self::DeleteEvent(o) => o.apply(draft),
            Self::Format => Ok(Report::new(Message::new("program-edit-formatted"))),
        }
    }
}
