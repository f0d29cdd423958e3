//! Edits of whole passes, their events, and the settings common to all of them.

use super::draft::{Draft, EventDraft, PassDraft, from_to};
use super::report::Report;
use crate::pass::{Pass, Role};
use crate::points::PointEvent;
use crate::repeat::Repeat;
use schemars::JsonSchema;
use seamwright_document::{DocumentError, Finite};
use seamwright_message::{Argument, Message, Unit};
use serde::{Deserialize, Serialize};

/// Sets the work offset in force.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetOffset {
    /// A name among the document's `offsets`; none: the part's frame is the machine's work frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// Sets a variable, a new one too.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetVariable {
    /// Its name.
    pub name: String,
    /// Its number; without, it is taken out, if no expression uses it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<Finite>,
}

/// Sets what is given; the rest stays.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetPass {
    /// The pass, from 1.
    pub pass: usize,
    /// Name, for people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Role of the pass.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub role: Option<Role>,
    /// Whether arc or beam is on, through points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arc: Option<bool>,
    /// Number of times that the pass is welded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeat: Option<Repeat>,
}

/// Adds a pass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AddPass {
    /// Its place in the order, from 1; last if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<usize>,
    /// The pass, with the keys of the program file.
    pub new: Box<Pass>,
}

/// Deletes a pass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeletePass {
    /// The pass, from 1.
    pub pass: usize,
}

/// Moves a pass to another place in the order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovePass {
    /// The pass, from 1.
    pub pass: usize,
    /// Its new place, from 1.
    pub to: usize,
}

/// Puts a copy of a pass behind it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DuplicatePass {
    /// The pass, from 1.
    pub pass: usize,
    /// Name of the copy; that of the pass with " copy" if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
}

/// Adds an event to a pass through points, behind those at the same point.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AddEvent {
    /// The pass, from 1.
    pub pass: usize,
    /// The event, with the keys of the program file.
    pub event: PointEvent,
}

/// Deletes an event of a pass through points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeleteEvent {
    /// The pass, from 1.
    pub pass: usize,
    /// The event's place in the list, from 1.
    pub event: usize,
}

impl SetOffset {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        draft.head.offset.clone_from(&self.name);
        Ok(Report::new(match &self.name {
            Some(name) => Message::new("program-edit-offset").text("name", name),
            None => Message::new("program-edit-no-offset"),
        }))
    }
}

impl SetVariable {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        draft.is_recomputed = true;
        let variables = &mut draft.head.variables;
        let words = match self.value {
            Some(value) => {
                variables.insert(self.name.clone(), value);
                Message::new("program-edit-variable").text("name", &self.name).value("value", value.get(), Unit::One)
            }
            None => {
                if variables.remove(&self.name).is_none() {
                    let known: Vec<&str> = variables.keys().map(String::as_str).collect();
                    return Err(draft.file.unknown_name("variables", &self.name, &known));
                }
                Message::new("program-edit-variable-removed").text("name", &self.name)
            }
        };
        Ok(Report::new(words))
    }
}

impl SetPass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        if *self == (Self { pass: self.pass, ..Self::default() }) {
            return Err(draft.wrong(Message::new("program-nothing-to-set"), "name, role, arc, repeat"));
        }
        let there = draft.pass(self.pass)?;
        if let Some(name) = &self.name {
            there.pass.name.clone_from(name);
        }
        there.pass.role = self.role.or(there.pass.role);
        there.pass.repeat = self.repeat.unwrap_or(there.pass.repeat);
        if let Some(arc) = self.arc {
            draft.points(self.pass)?.arc = arc;
        }
        let given = [
            self.name.as_ref().map(|name| Message::new("program-edit-pass-name").text("name", name)),
            self.role.map(|role| Message::new("program-edit-pass-role").message("role", role.message())),
            self.arc.map(|on| Message::new(if on { "program-edit-arc-on" } else { "program-edit-arc-off" })),
            self.repeat.map(|repeat| Message::new("program-edit-repeat").count("times", repeat.get().into())),
        ];
        let given = given.into_iter().flatten().map(|change| Argument::Message(Box::new(change)));
        let words = Message::new("program-edit-pass").pass("pass", self.pass).list("changes", given);
        Ok(Report::new(words).pass(self.pass))
    }
}

impl Draft<'_> {
    /// Index for a new pass at a position from 1.
    fn place(&self, at: usize, count: usize) -> Result<usize, DocumentError> {
        if (1..=count).contains(&at) {
            return Ok(at - 1);
        }
        Err(self.wrong(Message::new("program-no-order-position").number("at", at as f64, 0), from_to(1, count)))
    }
}

impl AddPass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let count = draft.passes.len() + 1;
        let at = draft.place(self.at.unwrap_or(count), count)?;
        draft.passes.insert(at, PassDraft::new(&self.new, None));
        Ok(Report::new(Message::new("program-edit-pass-added").text("name", &self.new.name)).pass(at + 1))
    }
}

impl DeletePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let i = draft.index(self.pass)?;
        if draft.passes.len() == 1 {
            return Err(draft.wrong(Message::new("program-only-pass"), Message::new("program-at-least-one-pass")));
        }
        let gone = draft.passes.remove(i);
        let words = Message::new("program-edit-pass-deleted").pass("pass", self.pass).text("name", gone.pass.name);
        Ok(Report::new(words).pass(self.pass))
    }
}

impl MovePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let (from, to) = (draft.index(self.pass)?, draft.place(self.to, draft.passes.len())?);
        let pass = draft.passes.remove(from);
        draft.passes.insert(to, pass);
        let words = Message::new("program-edit-pass-moved").pass("pass", self.pass).pass("to", self.to);
        Ok(Report::new(words).pass(self.to))
    }
}

impl DuplicatePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let i = draft.index(self.pass)?;
        let mut copy = draft.passes[i].clone();
        copy.pass.name = self.name.clone().unwrap_or_else(|| format!("{} copy", copy.pass.name));
        draft.passes.insert(i + 1, copy);
        Ok(Report::new(Message::new("program-edit-pass-copied").pass("pass", self.pass)).pass(self.pass + 1))
    }
}

impl AddEvent {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let points = draft.points(self.pass)?;
        let after = self.event.after;
        let at = points.events.iter().rposition(|e| e.event.after <= after).map_or(0, |i| i + 1);
        points.events.insert(at, EventDraft { event: self.event.clone(), from: None });
        let words = Message::new("program-edit-event-added").pass("pass", self.pass).number("point", after as f64, 0);
        Ok(Report::new(words).points(self.pass, after, after))
    }
}

impl DeleteEvent {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let points = draft.points(self.pass)?;
        let count = points.events.len();
        if !(1..=count).contains(&self.event) {
            let allowed = if count == 0 { Message::new("program-pass-with-events") } else { from_to(1, count) };
            let message = Message::new("program-no-event").number("event", self.event as f64, 0);
            return Err(draft.wrong_in(self.pass, message, allowed));
        }
        let gone = points.events.remove(self.event - 1);
        let words = Message::new("program-edit-event-deleted").pass("pass", self.pass);
        let words = words.number("event", self.event as f64, 0);
        Ok(Report::new(words).points(self.pass, gone.event.after, gone.event.after))
    }
}
