use seamwright_cell::executive::{AlarmList, Ask, Note};

/// The executive's list of alarms, kept in step by what it notes.
#[derive(Default)]
pub(super) struct Mirror(AlarmList);

impl Mirror {
    /// True if the list has changed.
    pub(super) fn noted(&mut self, note: &Note) -> bool {
        match note {
            Note::Alarm(r) => drop(self.0.raise(r.alarm, r.detail, r.reaction, (r.t, r.place))),
            Note::Cleared(alarm, detail) => drop(self.0.clear(*alarm, *detail)),
            Note::Taken(command) if command.ask == Ask::Acknowledge => drop(self.0.acknowledge()),
            _ => return false,
        }
        true
    }

    pub(super) fn list(&self) -> &AlarmList {
        &self.0
    }
}
