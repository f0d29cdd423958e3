//! Distribution of the cycle's notes to pages, record, library and audit log.

use super::audit_entry::Change;
use super::desk::{Desk, Welding};
use super::event::happening;
use super::names::WHY;
use super::progress::{Left, Progress};
use super::recorder::{Beginning, RecorderNews};
use crate::refusal::Lack;
use crate::wire::FromCell;
use seamwright_cell::protocol::Request;
use seamwright_executive::realtime::RealtimeRights;
use seamwright_executive::{Ask, Command, Missing, Mode, Note, Origin, Place, Raised};
use seamwright_message::{Message, Unit};
use seamwright_record::Plan;

impl Desk {
    pub(super) fn handle_note(&mut self, t: f64, note: Note) {
        // Name in the library; available only while the alarm is listed.
        let one = match note {
            Note::Taken(Command { ask: Ask::AcknowledgeOne(alarm, detail), .. }) => {
                Some(self.mirror.name(&self.names, alarm, detail))
            }
            _ => None,
        };
        let asked = if let Note::Taken(command) = note { self.hub.user(command.origin.station) } else { None };
        if self.mirror.update(&note, asked.as_deref().unwrap_or_default()) {
            self.hub.alarms(self.mirror.views(&self.names));
        }
        match note {
            Note::Mode(from, to) => {
                self.tell(happening(mode_changes(from, to)));
                if to == Mode::Weld && from != Mode::Hold {
                    self.begin_weld(Place::default());
                } else if to == Mode::Weld && self.welding.is_none() {
                    // It was held while the panel changed.
                    self.begin_weld(self.now.map_or_else(Place::default, |now| now.place));
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
                let title = alarm.entry().title;
                self.tell(happening(match self.names.about(alarm, detail) {
                    Some(of) => Message::new("server-event-cleared-of").message("alarm", title).message("object", of),
                    None => Message::new("server-event-cleared").message("alarm", title),
                }));
            }
            Note::Missed(cycles, longest_ms) => {
                let message = Message::new("server-event-cycles-missed").count("cycles", cycles as usize);
                self.tell(happening(message.quantity("longest", longest_ms, Unit::Ms, 0)));
            }
            Note::PassEnds(place) => {
                self.welding.iter_mut().for_each(|welding| welding.passes += 1);
                self.tell(happening(at_place("server-event-pass-ends", &place)));
            }
            Note::Left(place) => {
                self.welding.iter_mut().for_each(|welding| welding.is_left = true);
                let at = (place.pass as u32, place.s_mm);
                if let Some(of) = &self.to_weld {
                    let left = Left::now(at, self.recorder.weld(), of);
                    self.parts.note(of, Progress::Left(left.clone()));
                    (self.left, self.left_before) = (Some(left), None);
                }
                self.tell(happening(at_place("server-event-left", &place)));
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

    /// A weld begins, or is found at a position: then the passes before it are finished.
    pub(super) fn begin_weld(&mut self, at: Place) {
        let start = self.to_weld.as_ref().map_or(1, |of| of.start.0 as usize);
        let passes = at.pass.saturating_sub(start);
        self.welding = Some(Welding { passes, ..Welding::default() });
        self.left_before = self.left.take();
    }

    /// Begins the record of a weld.
    pub(super) fn begin_record(&mut self, start: u64) {
        let Some(of) = &self.to_weld else { return };
        let finished = self.welding.as_ref().map_or(0, |welding| welding.passes);
        let passes = of.passes.saturating_sub(finished);
        let plan = Plan { welder: Some(self.hub.holder().unwrap_or_default()), ..of.plan.clone() };
        let missing: Vec<&str> = self.footing.iter().flat_map(RealtimeRights::missing).collect();
        let (values, heads) = (self.names.values, self.names.heads);
        self.recorder.begin(Beginning { start, plan, passes, values, heads }, &missing);
    }

    /// Handles the start of a record, and the end of one whose cell has died.
    pub(super) fn handle_record(&mut self, news: RecorderNews) {
        match news {
            RecorderNews::Begun(start, _) => drop(self.cell.send(&Request::Record(start))),
            RecorderNews::NotBegun(start, e) => {
                self.cell.send(&Request::NoRecord { start });
                self.tell(happening(Message::new("server-event-not-recorded").message("reason", e.message())));
            }
            RecorderNews::Left(left) => self.left = left.or_else(|| self.left.take()),
        }
    }

    fn taken(&mut self, command: Command, one: Option<Message>) {
        let Origin { station, .. } = command.origin;
        if let Ask::Why(_) = command.ask {
            let lacks = self.lacks.remove(&(station, command.number)).unwrap_or_default();
            if let Some((ask, _)) = WHY.get(command.number as usize) {
                self.hub.tell(
                    station,
                    &FromCell::Why { ask: (*ask).to_owned(), lacks: lacks.into_iter().map(Into::into).collect() },
                );
            }
            return;
        }
        let user = self.hub.user(station);
        if command.ask == Ask::Acknowledge || one.is_some() {
            self.archive.acknowledge(user.as_deref().unwrap_or_default(), one.clone());
        }
        if !matches!(command.ask, Ask::Jog(_)) {
            self.tell(
                happening(Message::new("server-event-order").message("order", command.ask.message())).by(user.clone()),
            );
        }
        if station > 0 {
            self.hub.tell(station, &FromCell::Answer { seq: command.number, ok: true, why: None });
        }
        let text = match command.ask {
            Ask::Override(part) => {
                Message::new("server-audit-override").quantity("override", part * 100.0, Unit::Percent, 0)
            }
            Ask::AcknowledgeOne(..) => {
                Message::new("server-audit-acknowledge").message("alarm", one.unwrap_or_default())
            }
            ask => ask.message(),
        };
        let (station, accepted) = (page(station), Message::new("server-audit-accepted"));
        let user = user.as_deref().unwrap_or("");
        match command.ask {
            Ask::Acknowledge | Ask::AcknowledgeOne(..) => self.archive.repeatable(user, station, text, accepted),
            _ => self.archive.audit(user, station, text, Change::default(), accepted),
        }
    }

    fn refused(&mut self, command: Command, missing: Missing) {
        // At the end, quit commands repeat until everything is at rest.
        if self.quits || matches!(command.ask, Ask::Jog(_)) {
            return;
        }
        self.refuse(command, self.names.lack(missing));
    }

    pub(super) fn refuse(&self, command: Command, why: Lack) {
        let station = command.origin.station;
        let user = self.hub.user(station);
        let order = command.ask.message();
        let refused = Message::new("server-event-refused").message("order", order.clone());
        self.tell(happening(refused.message("reason", why.message.clone())).by(user.clone()));
        self.archive.refused(user.as_deref().unwrap_or(""), page(station), order, why.message.clone());
        self.hub.tell(station, &FromCell::Answer { seq: command.number, ok: false, why: Some(why.into()) });
    }

    fn alarm(&mut self, t: f64, raised: &Raised) {
        let about = self.names.about_raised(raised);
        let code = if about.is_some() { "server-event-alarm-of" } else { "server-event-alarm" };
        let event = Message::new(code).message("alarm", raised.alarm.entry().title);
        let event = event.message("reaction", raised.reaction.message());
        self.tell(happening(about.into_iter().fold(event, |event, of| event.message("object", of))));
        // The length of a gap is part of the cause: alarms are acknowledged by their names.
        let name = raised.alarm.title_of(self.names.about(raised.alarm, raised.detail));
        self.recorder.alarm(t, raised, &name);
    }
}

fn mode_changes(from: Mode, to: Mode) -> Message {
    let [from, to] = [from, to].map(Mode::message);
    Message::new("server-event-mode").message("from", from).message("to", to)
}

fn at_place(code: &'static str, place: &Place) -> Message {
    Message::new(code).pass("pass", place.pass).quantity("s", place.s_mm, Unit::Mm, 2)
}

/// Returns the words for a page, or for the panel itself.
fn page(station: u32) -> Message {
    match station {
        0 => Message::new("server-audit-panel"),
        _ => Message::new("server-audit-panel-number").number("number", f64::from(station), 0),
    }
}
