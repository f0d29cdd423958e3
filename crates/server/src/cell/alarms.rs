use super::chattering::Occurrences;
use super::names::Names;
use crate::refusal::panel_word;
use crate::view::written;
use crate::wire::{AlarmView, Shelving, WhoWhen};
use seamwright_executive::{Alarm, AlarmList, AlarmState, Ask, Note, Raised, Reaction};
use seamwright_message::Message;
use seamwright_record::{Moment, library};
use std::time::{Duration, Instant};

/// Maximum time for which an alarm is shelved, min: one shift.
const MAX_MINUTES: u32 = 480;

/// Copy of the executive's alarm list, updated from its notes. Adds unacknowledged alarms of earlier runs,
/// acknowledgements and shelving.
pub(super) struct Mirror {
    /// Alarms of earlier runs, shown as returned: the executive raises active ones anew. Details count down from the
    /// maximum.
    before: Vec<AlarmView>,
    /// Names of those in the library.
    known: Vec<Message>,
    list: AlarmList,
    said: Vec<Said>,
    occurrences: Occurrences,
    shelf: Vec<Shelved>,
}

/// Data of a listed alarm that the executive does not know.
struct Said {
    key: (Alarm, u8),
    at: Moment,
    acknowledged: Option<WhoWhen>,
    /// It came several times within a minute.
    chatters: bool,
}

/// A shelved alarm.
struct Shelved {
    view: AlarmView,
    ends: Instant,
}

fn key(view: &AlarmView) -> (u8, u8) {
    (view.number, view.detail)
}

impl Mirror {
    pub(super) fn new(unknown: &[library::Alarm]) -> Self {
        let (mut before, known): (Vec<AlarmView>, Vec<Message>) =
            unknown.iter().filter_map(|kept| Some((returned(kept)?, kept.name.clone()))).unzip();
        (0..=u8::MAX).rev().zip(&mut before).for_each(|(detail, view)| view.detail = detail);
        Self {
            before,
            known,
            list: AlarmList::default(),
            said: Vec::new(),
            occurrences: Occurrences::default(),
            shelf: Vec::new(),
        }
    }

    /// Updates the list from a note. Returns true if it changed; `user` gave the command, if there is one.
    pub(super) fn update(&mut self, note: &Note, user: &str) -> bool {
        let mut changed = false;
        match note {
            Note::Alarm(raised) => self.came(raised),
            Note::Taken(command) => {
                let one = match command.ask {
                    Ask::Acknowledge => None,
                    Ask::AcknowledgeOne(alarm, detail) => Some((alarm, detail)),
                    _ => return false,
                };
                changed = self.acknowledged(one, user);
            }
            _ => {}
        }
        let changed = self.list.follow(note) || changed;
        let list = &self.list;
        self.said.retain(|said| list.iter().any(|r| (r.alarm, r.detail) == said.key));
        changed
    }

    fn came(&mut self, raised: &Raised) {
        let key = (raised.alarm, raised.detail);
        self.said.retain(|said| said.key != key);
        let number = raised.alarm.number() as u8;
        let chatters = self.occurrences.chatters(number, raised.detail, Instant::now());
        self.said.push(Said { key, at: Moment::now(), acknowledged: None, chatters });
        // An alarm with a reaction beyond `Tell` is shown even if it was shelved.
        if raised.reaction != Reaction::Tell {
            self.shelf.retain(|shelved| self::key(&shelved.view) != (number, raised.detail));
        }
    }

    /// Acknowledges one alarm or all. Returns true if one of an earlier run was among them.
    fn acknowledged(&mut self, one: Option<(Alarm, u8)>, user: &str) -> bool {
        let before = self.before.len();
        let stays = |view: &AlarmView| one.is_some_and(|(a, d)| (a.number() as u8, d) != key(view));
        let mut views = self.before.iter();
        self.known.retain(|_| views.next().is_some_and(stays));
        self.before.retain(stays);
        for raised in self.list.iter().filter(|r| r.state == AlarmState::Unacknowledged) {
            let its = (raised.alarm, raised.detail);
            if one.is_none_or(|one| one == its)
                && let Some(said) = self.said.iter_mut().find(|said| said.key == its)
            {
                said.acknowledged = Some(WhoWhen { by: user.to_owned(), at: written(Moment::now()) });
            }
        }
        before != self.before.len()
    }

    /// Returns the library's name of an alarm that is acknowledged individually.
    pub(super) fn name(&self, names: &Names, alarm: Alarm, detail: u8) -> Message {
        let before = self.before.iter().zip(&self.known);
        let mut known = before.filter(|(view, _)| key(view) == (alarm.number() as u8, detail)).map(|(_, name)| name);
        known.next_back().cloned().unwrap_or_else(|| alarm.title_of(names.about(alarm, detail)))
    }

    /// Shelves an alarm for a time, or unshelves it. Returns its name.
    ///
    /// # Errors
    /// In words, if the alarm is not listed or its reaction is not `Tell`. Alarms that stop the process or prevent its
    /// start are never hidden.
    pub(super) fn shelve(&mut self, names: &Names, asked: &Shelving, by: &str) -> Result<Message, Message> {
        let wanted = (asked.number, asked.detail);
        if asked.minutes > MAX_MINUTES {
            let message = Message::new("server-shelve-time").number("minutes", f64::from(asked.minutes), 0);
            return Err(message.number("max", f64::from(MAX_MINUTES), 0));
        }
        let views = self.views(names);
        let Some(view) = views.into_iter().find(|view| key(view) == wanted) else {
            return Err(Message::new("server-alarm-not-listed"));
        };
        if asked.minutes > 0 && !view.tells {
            let message = Message::new("server-alarm-reacts").message("alarm", title(&view));
            return Err(message.message("reaction", panel_word("reaction", &view.reaction)));
        }
        self.shelf.retain(|shelved| key(&shelved.view) != wanted);
        let name = title(&view);
        if asked.minutes > 0 {
            let time = Duration::from_secs(60 * u64::from(asked.minutes));
            let until = Moment(Moment::now().0 + i64::from(asked.minutes) * 60_000);
            let shelved = Some(WhoWhen { by: by.to_owned(), at: written(until) });
            self.shelf.push(Shelved { view: AlarmView { shelved, ..view }, ends: Instant::now() + time });
        }
        Ok(name)
    }

    /// Unshelves alarms whose time is over. Returns their titles.
    pub(super) fn expire(&mut self) -> Vec<Message> {
        let now = Instant::now();
        self.shelf.extract_if(.., |shelved| shelved.ends <= now).map(|shelved| title(&shelved.view)).collect()
    }

    /// Clears the list: another machine has its own executive, which raises its alarms anew.
    pub(super) fn forget(&mut self) {
        self.list = AlarmList::default();
        self.said.clear();
        self.shelf.clear();
    }

    /// Returns all listed alarms, then those that are shelved and no longer listed.
    pub(super) fn views(&self, names: &Names) -> Vec<AlarmView> {
        let shelved = |view: &AlarmView| self.shelf.iter().find(|s| key(&s.view) == key(view)).map(|s| &s.view.shelved);
        let seen = self.list.iter().map(|raised| {
            let said = self.said.iter().find(|said| said.key == (raised.alarm, raised.detail));
            AlarmView {
                at: said.map_or_else(String::new, |said| written(said.at)),
                acknowledged: said.and_then(|said| said.acknowledged.clone()),
                chattering: said.is_some_and(|said| said.chatters),
                ..names.alarm(raised)
            }
        });
        let mut views: Vec<AlarmView> = self.before.iter().cloned().chain(seen).collect();
        for view in &mut views {
            view.shelved = shelved(view).cloned().flatten();
        }
        let away = self.shelf.iter().filter(|s| views.iter().all(|view| key(view) != key(&s.view)));
        let gone: Vec<AlarmView> =
            away.map(|s| AlarmView { state: "gone".to_owned(), first_out: false, ..s.view.clone() }).collect();
        views.extend(gone);
        views
    }
}

fn title(view: &AlarmView) -> Message {
    let known = Alarm::ALL.into_iter().find(|alarm| alarm.number() == usize::from(view.number));
    known.map_or_else(|| Message::verbatim(&*view.name), |alarm| alarm.entry().title)
}

/// Returns the view of a library alarm; `None` if this version has no such alarm.
fn returned(kept: &library::Alarm) -> Option<AlarmView> {
    let (alarm, of) = Alarm::from_title(&kept.name)?;
    let entry = alarm.entry();
    Some(AlarmView {
        number: alarm.number() as u8,
        name: entry.name.to_owned(),
        of: of.map(Into::into),
        cause: entry.cause.to_string(),
        consequence: entry.consequence.to_string(),
        action: entry.action.to_string(),
        reaction: entry.reaction.name().to_owned(),
        detail: 0,
        at: written(kept.raised),
        acknowledged: None,
        shelved: None,
        chattering: false,
        tells: alarm.is_shelvable(entry.reaction),
        priority: match kept.priority.as_str() {
            // Of an older version.
            "" => alarm.priority(entry.reaction).name().to_owned(),
            priority => priority.to_owned(),
        },
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
                let name = Message::verbatim(format!("{}{of}", alarm.name()));
                let kept = library::Alarm {
                    name,
                    cause: Message::default(),
                    priority: String::new(),
                    place: library::Place::default(),
                    raised: Moment(0),
                    first_out: true,
                    acknowledged: None,
                };
                let view = returned(&kept).unwrap();
                assert_eq!((usize::from(view.number), view.state.as_str()), (alarm.number(), "returned"));
                assert_eq!(view.of.map_or(String::new(), |of| format!(" ({})", of.text)), of);
            }
        }
    }

    fn names() -> Names {
        let text = seamwright_machine::shipped("ellipse-xy").unwrap().text;
        let machine = seamwright_machine::Machine::read("m.toml", text).unwrap();
        Names { machine, fingerprint: String::new(), values: 0, heads: 0 }
    }

    fn alarm(alarm: Alarm) -> Note {
        let place = seamwright_executive::Place::default();
        Note::Alarm(Raised {
            alarm,
            detail: 0,
            reaction: alarm.entry().reaction,
            state: AlarmState::Unacknowledged,
            first_out: false,
            t: 1.0,
            place,
            gap_s: None,
        })
    }

    fn asked(alarm: Alarm, minutes: u32) -> Shelving {
        Shelving { number: alarm.number() as u8, detail: 0, minutes }
    }

    /// Only alarms with reaction `Tell` can be shelved, for one shift at most.
    #[test]
    fn what_stops_the_process_is_never_shelved() {
        let names = names();
        for of in Alarm::ALL {
            let mirror = &mut Mirror::new(&[]);
            assert!(mirror.shelve(&names, &asked(of, 5), "ada").is_err(), "it is not there");
            mirror.update(&alarm(of), "");
            let tells = of.entry().reaction == Reaction::Tell && of != Alarm::Interlock;
            assert_eq!(mirror.shelve(&names, &asked(of, 5), "ada").is_ok(), tells, "{of:?}");
            assert!(mirror.shelve(&names, &asked(of, MAX_MINUTES + 1), "ada").is_err());
            let view = mirror.views(&names).pop().unwrap();
            assert_eq!(view.shelved.map(|s| s.by), tells.then(|| "ada".to_owned()), "{of:?}");
        }
    }

    /// A shelved alarm that returns with a stronger reaction is shown at once. A shelved alarm that has gone stays
    /// shelved until its time is over.
    #[test]
    fn a_shelf_hides_nothing_that_grows_worse() {
        let names = names();
        let mirror = &mut Mirror::new(&[]);
        mirror.update(&alarm(Alarm::JogStopped), "");
        mirror.shelve(&names, &asked(Alarm::JogStopped, 1), "ada").unwrap();
        mirror.update(&Note::Taken(seamwright_executive::Command::of(Ask::Acknowledge)), "eve");
        mirror.update(&Note::Cleared(Alarm::JogStopped, 0), "");
        let views = mirror.views(&names);
        assert_eq!((views.len(), views[0].state.as_str()), (1, "gone"));
        assert!(mirror.expire().is_empty());
        mirror.shelf[0].ends = Instant::now();
        assert_eq!(mirror.expire(), [Alarm::JogStopped.entry().title]);
        assert!(mirror.views(&names).is_empty());
        // A tracking warning, followed by its stop while still active.
        let Note::Alarm(told) = alarm(Alarm::Tracking) else { unreachable!() };
        let told = Raised { reaction: Reaction::Tell, ..told };
        mirror.update(&Note::Alarm(told), "");
        mirror.shelve(&names, &asked(Alarm::Tracking, 60), "ada").unwrap();
        mirror.update(&Note::Alarm(Raised { reaction: Reaction::Stop, ..told }), "");
        assert_eq!(mirror.views(&names).pop().unwrap().shelved, None);
    }

    /// An alarm that comes three times in a minute is marked as chattering.
    #[test]
    fn what_comes_and_goes_is_marked() {
        let (names, mirror) = (names(), &mut Mirror::new(&[]));
        for times in 1..=4 {
            mirror.update(&alarm(Alarm::FollowingError), "");
            assert_eq!(mirror.views(&names)[0].chattering, times >= 3);
            mirror.update(&Note::Cleared(Alarm::FollowingError, 0), "");
        }
    }

    /// The acknowledging user stays with the alarm until it is raised again.
    #[test]
    fn who_knows_of_an_alarm_is_told() {
        let names = names();
        let mirror = &mut Mirror::new(&[]);
        let one = |alarm| Note::Taken(seamwright_executive::Command::of(Ask::AcknowledgeOne(alarm, 0)));
        mirror.update(&alarm(Alarm::JogStopped), "");
        mirror.update(&alarm(Alarm::PanelSilent), "");
        assert!(mirror.update(&one(Alarm::PanelSilent), "ada"));
        let by = |mirror: &Mirror| -> Vec<Option<String>> {
            mirror.views(&names).into_iter().map(|view| view.acknowledged.map(|who| who.by)).collect()
        };
        assert_eq!(by(mirror), [None, Some("ada".to_owned())]);
        mirror.update(&Note::Taken(seamwright_executive::Command::of(Ask::Acknowledge)), "eve");
        assert_eq!(by(mirror), [Some("eve".to_owned()), Some("ada".to_owned())]);
        mirror.update(&Note::Cleared(Alarm::PanelSilent, 0), "");
        mirror.update(&alarm(Alarm::PanelSilent), "");
        assert_eq!(by(mirror), [Some("eve".to_owned()), None]);
    }
}
