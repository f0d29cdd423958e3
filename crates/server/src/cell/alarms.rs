use super::names::Names;
use crate::wire::AlarmView;
use seamwright_cell::executive::{Alarm, AlarmList, Ask, Note};
use seamwright_record::library;

/// The executive's list of alarms, kept in step by what it notes; and those that nobody has acknowledged before this program began.
pub(super) struct Mirror {
    /// They have returned as far as anybody knows: what is there still is raised anew.
    before: Vec<AlarmView>,
    list: AlarmList,
}

impl Mirror {
    pub(super) fn new(unknown: &[library::Alarm]) -> Self {
        Self { before: unknown.iter().filter_map(returned).collect(), list: AlarmList::default() }
    }

    /// True if the list has changed.
    pub(super) fn noted(&mut self, note: &Note) -> bool {
        if matches!(note, Note::Taken(command) if command.ask == Ask::Acknowledge) {
            self.before.clear();
        }
        self.list.follow(note)
    }

    /// Another machine has an executive of its own: what it raises, it raises anew.
    pub(super) fn forget(&mut self) {
        self.list = AlarmList::default();
    }

    pub(super) fn views(&self, names: &Names) -> Vec<AlarmView> {
        self.before.iter().cloned().chain(self.list.iter().map(|raised| names.alarm(raised))).collect()
    }
}

/// An alarm as the library has it, `NAME (OF)`; none if this version has no such alarm.
fn returned(kept: &library::Alarm) -> Option<AlarmView> {
    let split = |text: &str| text.strip_suffix(')')?.split_once(" (").map(|(a, b)| (a.to_owned(), b.to_owned()));
    let (name, of) = split(&kept.name).map_or_else(|| (kept.name.clone(), None), |(name, of)| (name, Some(of)));
    let alarm = Alarm::ALL.into_iter().find(|alarm| alarm.entry().name == name)?;
    let entry = alarm.entry();
    Some(AlarmView {
        number: alarm.number() as u8,
        name,
        of,
        cause: entry.cause.to_owned(),
        consequence: entry.consequence.to_owned(),
        action: entry.action.to_owned(),
        reaction: entry.reaction.name().to_owned(),
        state: "returned".to_owned(),
        first_out: kept.first_out,
        t: kept.place.t_s.unwrap_or(0.0),
        pass: kept.place.pass.unwrap_or(0),
        s_mm: kept.place.s_mm.unwrap_or(0.0),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_record::Moment;

    #[test]
    fn what_is_kept_is_found_in_the_catalogue() {
        for alarm in Alarm::ALL {
            for of in ["", " (theta)", " (door (left))"] {
                let name = format!("{}{of}", alarm.entry().name);
                let kept = library::Alarm {
                    name,
                    cause: String::new(),
                    place: library::Place::default(),
                    raised: Moment(0),
                    first_out: true,
                    acknowledged: None,
                };
                let view = returned(&kept).unwrap();
                assert_eq!((usize::from(view.number), view.state.as_str()), (alarm.number(), "returned"));
                assert_eq!(view.of.map_or(String::new(), |of| format!(" ({of})")), of);
            }
        }
    }
}
