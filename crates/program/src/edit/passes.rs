//! Edits of whole passes, their events, and the settings common to all of them.

use super::draft::{Draft, EventDraft, PassDraft};
use super::report::Report;
use crate::{Pass, PointEvent, Repeat, Role};
use schemars::JsonSchema;
use seamwright_document::{DocumentError, Finite};
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
    /// What it is for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub role: Option<Role>,
    /// Whether arc or beam is on, through points.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arc: Option<bool>,
    /// How many times it is welded.
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
        let name = self.name.as_ref().map_or("none".to_owned(), |name| format!("`{name}`"));
        Ok(Report::new(format!("offset in force: {name}")))
    }
}

impl SetVariable {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        draft.is_recomputed = true;
        let variables = &mut draft.head.variables;
        let words = match self.value {
            Some(value) => {
                variables.insert(self.name.clone(), value);
                format!("variable {} = {}", self.name, value.get())
            }
            None => {
                if variables.remove(&self.name).is_none() {
                    let known: Vec<&str> = variables.keys().map(String::as_str).collect();
                    return Err(draft.file.unknown_name("variables", &self.name, &known));
                }
                format!("variable {} taken out", self.name)
            }
        };
        Ok(Report::new(words))
    }
}

impl SetPass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        if *self == (Self { pass: self.pass, ..Self::default() }) {
            return Err(draft.wrong("nothing is given to set", "name, role, arc, repeat"));
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
            self.name.as_ref().map(|name| format!("name `{name}`")),
            self.role.map(|role| format!("role {}", role.name())),
            self.arc.map(|arc| format!("arc {}", if arc { "on" } else { "off" })),
            self.repeat.map(|repeat| format!("welded {} times", repeat.get())),
        ];
        let given: Vec<String> = given.into_iter().flatten().collect();
        Ok(Report::new(format!("pass {}: {}", self.pass, given.join(", "))).pass(self.pass))
    }
}

impl Draft<'_> {
    /// Index for a new pass at a position from 1.
    fn place(&self, at: usize, count: usize) -> Result<usize, DocumentError> {
        if (1..=count).contains(&at) {
            return Ok(at - 1);
        }
        Err(self.wrong(format!("there is no place {at} in the order"), format!("1 to {count}")))
    }
}

impl AddPass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let count = draft.passes.len() + 1;
        let at = draft.place(self.at.unwrap_or(count), count)?;
        draft.passes.insert(at, PassDraft::new(&self.new, None));
        Ok(Report::new(format!("pass `{}` added", self.new.name)).pass(at + 1))
    }
}

impl DeletePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let i = draft.index(self.pass)?;
        if draft.passes.len() == 1 {
            return Err(draft.wrong("it is the only pass", "a program has at least one"));
        }
        let gone = draft.passes.remove(i);
        Ok(Report::new(format!("pass {} `{}` deleted", self.pass, gone.pass.name)).pass(self.pass))
    }
}

impl MovePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let (from, to) = (draft.index(self.pass)?, draft.place(self.to, draft.passes.len())?);
        let pass = draft.passes.remove(from);
        draft.passes.insert(to, pass);
        Ok(Report::new(format!("pass {} moved to {}", self.pass, self.to)).pass(self.to))
    }
}

impl DuplicatePass {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let i = draft.index(self.pass)?;
        let mut copy = draft.passes[i].clone();
        copy.pass.name = self.name.clone().unwrap_or_else(|| format!("{} copy", copy.pass.name));
        draft.passes.insert(i + 1, copy);
        Ok(Report::new(format!("pass {} copied", self.pass)).pass(self.pass + 1))
    }
}

impl AddEvent {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let points = draft.points(self.pass)?;
        let after = self.event.after;
        let at = points.events.iter().rposition(|e| e.event.after <= after).map_or(0, |i| i + 1);
        points.events.insert(at, EventDraft { event: self.event.clone(), from: None });
        let words = format!("pass {}: event added after point {after}", self.pass);
        Ok(Report::new(words).points(self.pass, after, after))
    }
}

impl DeleteEvent {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let points = draft.points(self.pass)?;
        let count = points.events.len();
        if !(1..=count).contains(&self.event) {
            let allowed = if count == 0 { "a pass with events".to_owned() } else { format!("1 to {count}") };
            return Err(draft.wrong_in(self.pass, format!("there is no event {}", self.event), allowed));
        }
        let gone = points.events.remove(self.event - 1);
        let words = format!("pass {}: event {} deleted", self.pass, self.event);
        Ok(Report::new(words).points(self.pass, gone.event.after, gone.event.after))
    }
}
