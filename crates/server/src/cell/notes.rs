//! Distribution of the cycle's notes to pages, record, library and audit log.

use super::desk::{Desk, Welding};
use super::happening::happening;
use super::names::WHY;
use super::progress::{Left, Progress};
use crate::wire::{FromCell, LackView};
use seamwright_cell::executive::{Ask, Command, Missing, Mode, Note, Origin, Raised};
use seamwright_cell::realtime::Footing;
use seamwright_message::{Language, Message};

impl Desk {
    pub(super) fn noted(&mut self, t: f64, note: Note) {
        self.recorder.noted(t, &note);
        // Name in the library; available only while the alarm is listed.
        let one = match note {
            Note::Taken(Command { ask: Ask::AcknowledgeOne(alarm, detail), .. }) => {
                Some(self.mirror.name(&self.names, (alarm, detail)))
            }
            _ => None,
        };
        let asked = if let Note::Taken(command) = note { self.hub.user(command.origin.station) } else { None };
        if self.mirror.noted(&note, asked.as_deref().unwrap_or_default()) {
            self.hub.alarms(self.mirror.views(&self.names));
        }
        match note {
            Note::Mode(from, to) => {
                self.tell(happening("mode", [from, to].map(|mode| mode.name().to_owned())));
                if to == Mode::Weld && from != Mode::Hold {
                    self.welding = Some(Welding::default());
                    self.begin_record();
                }
                if !matches!(to, Mode::Weld | Mode::Hold) {
                    self.weld_is_over();
                }
            }
            Note::Taken(command) if command.ask == Ask::Load => self.loaded(None),
            Note::Refused(command, missing) if command.ask == Ask::Load => self.loaded(Some(missing)),
            Note::Lacks(command, missing) => {
                let lack = self.names.lack(missing);
                self.lacks.entry((command.origin.station, command.number)).or_default().push(lack);
            }
            Note::Taken(command) => self.taken(command, one),
            Note::Refused(command, missing) => self.refused(command, missing),
            Note::Alarm(raised) => self.alarm(t, &raised),
            Note::Cleared(alarm, detail) => {
                let name = alarm.entry().name.to_owned();
                self.tell(match self.names.detail(alarm, detail) {
                    Some(of) => happening("cleared_of", [name, of]),
                    None => happening("cleared", [name]),
                });
            }
            Note::Missed(cycles, longest_ms) => {
                self.tell(happening("cycles_missed", [cycles.to_string(), format!("{longest_ms:.0}")]));
            }
            Note::PassEnds(place) => {
                self.welding.iter_mut().for_each(|welding| welding.passes += 1);
                self.tell(happening("pass_ends", [place.pass.to_string(), format!("{:.2}", place.s_mm)]));
            }
            Note::Left(place) => {
                self.welding.iter_mut().for_each(|welding| welding.is_left = true);
                let at = (place.pass as u32, place.s_mm);
                if let Some(of) = &self.to_weld {
                    let left = Left::now(at, self.recorder.weld(), of);
                    self.parts.note(of, Progress::Left(left.clone()));
                    (self.left, self.left_before) = (Some(left), None);
                }
                self.tell(happening("left", [place.pass.to_string(), format!("{:.2}", place.s_mm)]));
            }
        }
    }

    /// Handles the end of a weld. Finished parts are known whether the weld was recorded or not.
    fn weld_is_over(&mut self) {
        let Some(welding) = self.welding.take() else { return };
        if let Some(of) = &mut self.to_weld
            && !welding.is_left
            && welding.passes >= of.passes
        {
            self.parts.note(of, Progress::Whole(self.recorder.weld()));
            self.left_before = None;
            // The next weld of this program is another part, from its start.
            of.plan.part.clear();
        }
    }

    fn begin_record(&mut self) {
        self.left_before = self.left.take();
        let Some(of) = &self.to_weld else { return };
        let welder = self.hub.holder().unwrap_or_default();
        let missing: Vec<&str> = self.footing.get().into_iter().flat_map(Footing::missing).collect();
        match self.recorder.begin(&of.plan, of.passes, &welder, &missing) {
            Ok(()) => {
                // Trouble of the previous record has been reported; this record is complete so far.
                self.outside.mend();
                self.trouble = None;
            }
            Err(e) => {
                self.outside.fail();
                self.tell(happening("not_recorded", [e.to_string()]));
            }
        }
    }

    fn taken(&mut self, command: Command, one: Option<Message>) {
        let Origin { station, .. } = command.origin;
        if let Ask::Why(_) = command.ask {
            let lacks = self.lacks.remove(&(station, command.number)).unwrap_or_default();
            if let Some((ask, _)) = WHY.get(command.number as usize) {
                self.hub.tell(station, &FromCell::Why { ask: (*ask).to_owned(), lacks });
            }
            return;
        }
        let user = self.hub.user(station);
        if command.ask == Ask::Acknowledge || one.is_some() {
            self.archive.acknowledge(user.as_deref().unwrap_or_default(), one.clone());
        }
        if !matches!(command.ask, Ask::Jog(_)) {
            self.tell(happening("order", [command.ask.name().to_owned()]).by(user.clone()));
        }
        if station > 0 {
            self.hub.tell(station, &FromCell::Answer { seq: command.number, ok: true, why: None });
        }
        let station = if station > 0 { format!("panel {station}") } else { String::from("panel") };
        let text = match command.ask {
            Ask::Override(part) => format!("override {:.0} %", part * 100.0),
            Ask::AcknowledgeOne(..) => {
                format!("acknowledge {}", one.unwrap_or_default().in_language(Language::English))
            }
            ask => ask.name().to_owned(),
        };
        let user = user.as_deref().unwrap_or("");
        match command.ask {
            Ask::Acknowledge | Ask::AcknowledgeOne(..) => self.archive.repeatable(user, &station, &text, "taken"),
            _ => self.archive.audit(user, &station, &text, ("", ""), "taken"),
        }
    }

    fn refused(&mut self, command: Command, missing: Missing) {
        // At the end, quit commands repeat until everything is at rest.
        if self.quits || matches!(command.ask, Ask::Jog(_)) {
            return;
        }
        self.refuse(command, self.names.lack(missing));
    }

    /// Reports a refused command to clients and audit log.
    pub(super) fn refuse(&self, command: Command, why: LackView) {
        let station = command.origin.station;
        let user = self.hub.user(station);
        let refused = happening("refused", [command.ask.name().to_owned(), why.text.clone()]);
        self.tell(refused.because(why.clone()).by(user.clone()));
        let from = format!("panel {station}");
        self.archive.repeatable(user.as_deref().unwrap_or(""), &from, command.ask.name(), &why.text);
        self.hub.tell(station, &FromCell::Answer { seq: command.number, ok: false, why: Some(why) });
    }

    fn alarm(&mut self, t: f64, raised: &Raised) {
        let (alarm, reaction) = (raised.alarm.entry().name.to_owned(), raised.reaction.name().to_owned());
        let about = self.names.about(raised.alarm, raised.detail);
        self.tell(match &about {
            Some(of) => happening("alarm_of", [alarm, reaction, of.to_string()]),
            None => happening("alarm", [alarm, reaction]),
        });
        self.recorder.alarm(t, raised, &raised.alarm.title_of(about));
    }
}
