//! The operator's desk: orders in their turn, events in words, the record.

use super::Ended;
use super::orders::Line;
use super::table::Table;
use crate::verbs::row_destination::Happened;
use seamwright_executive::realtime::{RealtimeRights, Shown, ShutdownCause};
use seamwright_executive::{Alarm, Ask, Command, Event, Missing, Mode, Note, Place, Raised, Reaction};
use seamwright_machine::Machine;
use seamwright_message::{Language, Message, Unit};
use seamwright_project::devices;
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::power_loss::Watch;
use seamwright_project::weld_events;
use seamwright_record::journal::{Journal, Position};
use seamwright_record::library::{self, WeldResult};
use seamwright_record::{Moment, Outcome, joined};
use serde_json::{Value, json};
use std::collections::VecDeque;
use std::io::{IsTerminal as _, Write as _};

/// Typed order that must not wait.
pub(in crate::verbs) fn is_urgent(text: &str) -> Option<Ask> {
    match text.trim() {
        "stop" => Some(Ask::Stop),
        "hold" => Some(Ask::Hold),
        _ => None,
    }
}

/// Words of files and of output for programs.
fn english(message: &Message) -> String {
    message.in_language(Language::English)
}

/// The line of an event at time `t` (s).
fn printed(t: f64, kind: &str, text: &Message) -> String {
    let time = Message::new("quantity").quantity("value", t, Unit::S, 3).to_string();
    format!("{time:>12}  {kind:<8} {text}")
}

/// Source of the orders, and record of their results.
pub(in crate::verbs) struct Desk {
    axes: Vec<String>,
    conditions: Vec<String>,
    lines: VecDeque<Line>,
    /// A person types them.
    terminal: bool,
    /// No more lines will come.
    ended: bool,
    /// The order that was given has not been taken or refused yet, or no cycle has been seen since.
    pending: bool,
    answered: bool,
    /// Since when the first line waits, s.
    waits: Option<f64>,
    now: Option<Shown>,
    table: Option<Table>,
    record: Option<Failure>,
    json: bool,
    /// Events are not printed.
    quiet: bool,
    events: Vec<Value>,
    refused: Option<Message>,
    /// The first alarm that held the program or took the cell down.
    stopped: Option<Message>,
    /// External cause that ended the program.
    ended_by: Option<ShutdownCause>,
    passes: Vec<Place>,
    alarms: Vec<library::Alarm>,
    kept: Vec<library::Event>,
    /// Decides when its position is recorded.
    places: Watch,
}

impl Desk {
    pub(in crate::verbs) fn new(machine: &Machine, table: Option<Table>, lines: Vec<Option<Line>>, json: bool) -> Self {
        Self {
            axes: machine.axes.iter().map(|a| a.name.clone()).collect(),
            conditions: machine.interlocks.iter().map(|i| i.name.clone()).collect(),
            lines: lines.into_iter().flatten().collect(),
            terminal: std::io::stdin().is_terminal(),
            ended: false,
            pending: false,
            answered: true,
            waits: None,
            now: None,
            table,
            record: None,
            json,
            quiet: false,
            events: Vec::new(),
            refused: None,
            stopped: None,
            ended_by: None,
            passes: Vec::new(),
            alarms: Vec::new(),
            kept: Vec::new(),
            places: Watch::default(),
        }
    }

    /// Does not print events.
    pub(in crate::verbs) fn quiet(self) -> Self {
        Self { quiet: true, ..self }
    }

    /// Ends everything after an unrecoverable fault.
    pub(in crate::verbs) fn give_up(&mut self, why: Message) {
        self.refused.get_or_insert(why);
    }

    /// Rights that the system grants to the cycle: missing ones are recorded and reported at once.
    pub(in crate::verbs) fn granted(&mut self, footing: &RealtimeRights) {
        if footing.is_whole() {
            return;
        }
        // Errors are ignored: standard error may be closed.
        let _ = writeln!(std::io::stderr(), "{}", Message::new("cli-run-rights").message("footing", footing.message()));
        let missing: Vec<&str> = footing.missing().collect();
        let text = RealtimeRights::event(&missing);
        self.event_now("realtime", &text, json!({ "missing": missing }));
        let place = library::Place { pass: None, s_mm: None, t_s: None };
        self.kept.push(library::Event { at: Moment::now(), text, place });
    }

    /// A signal or a fault of the program has ended the cell.
    pub(in crate::verbs) fn ended_by(&mut self, cause: ShutdownCause) {
        if self.ended_by.replace(cause) == Some(cause) {
            return;
        }
        let text = Message::new("cell-note-stopped").message("cause", cause.message());
        self.event_now("ended", &text, json!({ "ended_by": english(&cause.message()) }));
        let place = library::Place { pass: None, s_mm: None, t_s: self.now.map(|now| now.t) };
        self.kept.push(library::Event { at: Moment::now(), text, place });
    }

    pub(in crate::verbs) fn typed(&mut self, text: &str) {
        // Orders that stop have been sent already, past everything that waits.
        if self.terminal && is_urgent(text).is_some() {
            self.lines.clear();
            self.waits = None;
            return;
        }
        match Line::read(text) {
            Ok(line) => self.lines.extend(line),
            Err(error) => {
                self.refused.get_or_insert(error.clone());
                self.event_now("mistake", &error, json!({ "mistake": english(&error) }));
            }
        }
    }

    /// No more lines will come.
    pub(in crate::verbs) fn ends(&mut self) {
        self.ended = true;
    }

    /// True once the record cannot be written.
    pub(in crate::verbs) fn record_fails(&self) -> bool {
        self.record.is_some()
    }

    pub(in crate::verbs) fn shown(&mut self, shown: &Shown) {
        self.now = Some(*shown);
        self.pending &= !self.answered;
        // Rows that fail to be written are lost and counted; with free disk space again the trace goes on.
        if let Some(table) = &mut self.table
            && let Err(failure) = table.row(shown)
        {
            self.record.get_or_insert(failure);
        }
    }

    /// The next order, if its turn has come.
    pub(in crate::verbs) fn next(&mut self) -> Option<Command> {
        let now = self.now?;
        if self.pending {
            return None;
        }
        if self.gives_up(now.mode) {
            self.lines.clear();
        }
        let Some(line) = self.lines.front().copied() else {
            // At the end everything comes to rest, then the power goes.
            let last = match now.mode {
                _ if !self.ended => return None,
                Mode::Off | Mode::Fault => Ask::Quit,
                Mode::Idle | Mode::Ready => Ask::SwitchOff,
                _ => Ask::Stop,
            };
            return Some(Command::of(last));
        };
        let since = *self.waits.get_or_insert(now.t);
        let passes = match line {
            Line::Ask(ask) => return Some(Command::of(ask)),
            Line::Mode(mode) => now.mode == mode,
            Line::Seconds(s) => now.t - since >= s,
            Line::Place(mm) => now.place.pass > 0 && now.place.s_mm >= mm,
            Line::State => {
                self.state(&now);
                return Some(Command::of(Ask::Why(Event::Weld)));
            }
        };
        if passes {
            self.lines.pop_front();
            self.waits = None;
        }
        None
    }

    /// A script does not go on after an alarm or a refused order: it runs unattended.
    fn gives_up(&self, mode: Mode) -> bool {
        let waited_for = matches!(self.lines.front(), Some(Line::Mode(wanted)) if *wanted == mode);
        let down = matches!(mode, Mode::Fault | Mode::Hold) && self.stopped.is_some() && !waited_for;
        self.ended && (self.refused.is_some() || down)
    }

    pub(in crate::verbs) fn sent(&mut self) {
        (self.pending, self.answered) = (true, false);
        if matches!(self.lines.front(), Some(Line::Ask(_) | Line::State)) {
            self.lines.pop_front();
        }
        self.waits = None;
    }

    fn state(&mut self, now: &Shown) {
        let text = Message::new("cli-run-state")
            .message("mode", now.mode.message())
            .pass("pass", now.place.pass)
            .quantity("s", now.place.s_mm, Unit::Mm, 2)
            .text("inputs", format!("{:b}", now.reports.inputs));
        self.event_now(
            "state",
            &text,
            json!({ "mode": now.mode.name(), "pass": now.place.pass, "s_mm": now.place.s_mm }),
        );
    }

    fn ends_now(&self) -> bool {
        self.ended && self.lines.is_empty()
    }

    /// Adds a note of the cycle to the record and the events.
    pub(in crate::verbs) fn handle_note(&mut self, t: f64, note: Note) {
        let here = self.now.map_or_else(Place::default, |now| now.place);
        let event = weld_events::event(t, &note, here);
        let text = event.as_ref().map_or_else(Message::default, |event| event.text.clone());
        self.kept.extend(event);
        match note {
            Note::Mode(from, to) => {
                let more = json!({ "from": from.name(), "to": to.name() });
                self.event(t, "mode", &text, more);
            }
            Note::Taken(command) => {
                self.answered = true;
                self.event(t, "order", &command.ask.message(), json!({ "order": command.ask.name() }));
            }
            Note::Lacks(_, missing) => {
                let why = self.why(missing);
                self.event(t, "lacks", &why, json!({ "why": english(&why) }));
            }
            Note::Refused(command, missing) => {
                self.answered = true;
                self.refuse(t, command, missing);
            }
            Note::Alarm(raised) => self.alarm(t, &raised),
            Note::Cleared(alarm, detail) => {
                let title = alarm.title_of(self.about(alarm, detail));
                let text = Message::new("cli-run-cleared").message("alarm", title);
                self.event(t, "cleared", &text, json!({ "alarm": alarm.entry().name }));
            }
            Note::Missed(cycles, longest_ms) => {
                self.event(t, "missed", &text, json!({ "cycles": cycles, "longest_ms": longest_ms }));
            }
            Note::PassEnds(place) => {
                self.passes.push(place);
                self.event(t, "pass", &text, json!({ "pass": place.pass, "s_mm": place.s_mm }));
            }
            Note::Left(place) => {
                self.event(t, "left", &text, json!({ "pass": place.pass, "welded_mm": place.s_mm }));
            }
        }
    }

    fn refuse(&mut self, t: f64, command: Command, missing: Missing) {
        // An order that is refused for a moment is repeated.
        if matches!(missing, Missing::Power | Missing::Moving) && !self.ends_now() {
            self.lines.push_front(Line::Ask(command.ask));
            return;
        }
        // At the end quitting is asked for until everything rests.
        if self.ends_now() && matches!(command.ask, Ask::Quit | Ask::SwitchOff) {
            return;
        }
        let why = self.why(missing);
        let text = Message::new("cli-run-refused").message("order", command.ask.message()).message("why", why.clone());
        self.refused.get_or_insert(text.clone());
        self.event(t, "refused", &text, json!({ "order": command.ask.name(), "why": english(&why) }));
    }

    fn why(&self, missing: Missing) -> Message {
        let axes: Vec<&str> = self.axes.iter().map(String::as_str).collect();
        let conditions: Vec<&str> = self.conditions.iter().map(String::as_str).collect();
        missing.message(&axes, &conditions)
    }

    fn alarm(&mut self, t: f64, raised: &Raised) {
        let entry = raised.alarm.entry();
        let title = raised.alarm.title_of(self.about(raised.alarm, raised.detail));
        let shown = raised.alarm.title_of(self.about_raised(raised));
        let in_pass = raised.place.pass > 0;
        let text = Message::new(if in_pass { "cli-run-alarm-at" } else { "cli-run-alarm" });
        let text = text.message("alarm", shown.clone()).message("reaction", raised.reaction.message());
        let text = text.message("action", entry.action.clone());
        let text = if in_pass { text.quantity("at", raised.place.s_mm, Unit::Mm, 2) } else { text };
        if raised.reaction >= Reaction::Hold {
            let stopped = Message::new("cli-run-alarm-action").message("alarm", shown);
            self.stopped.get_or_insert(stopped.message("action", entry.action.clone()));
        }
        self.alarms.push(library::Alarm {
            name: title,
            cause: raised.cause(),
            priority: raised.alarm.priority(raised.reaction).name().to_owned(),
            place: library::Place {
                pass: in_pass.then_some(raised.place.pass as u32),
                s_mm: in_pass.then_some(raised.place.s_mm),
                t_s: Some(t),
            },
            raised: Moment::now(),
            first_out: raised.first_out,
            acknowledged: None,
        });
        let of = self.about_raised(raised).map(|of| english(&of));
        let more = json!({
            "alarm": entry.name, "of": of, "first_out": raised.first_out,
            "priority": raised.alarm.priority(raised.reaction).name(),
            "pass": raised.place.pass, "s_mm": raised.place.s_mm, "cell": raised.reaction.name(),
            "gap_ms": raised.gap_s.map(|gap_s| 1e3 * gap_s),
            "cause": english(&raised.cause()), "consequence": english(&entry.consequence),
            "action": english(&entry.action),
        });
        self.event(t, "alarm", &text, more);
    }

    /// Axis, interlock or trouble that an alarm is about.
    fn about(&self, alarm: Alarm, detail: u8) -> Option<Message> {
        let axes: Vec<&str> = self.axes.iter().map(String::as_str).collect();
        let conditions: Vec<&str> = self.conditions.iter().map(String::as_str).collect();
        alarm.about(detail, &axes, &conditions)
    }

    /// Object of an alarm, or the length of its gap.
    fn about_raised(&self, raised: &Raised) -> Option<Message> {
        let axes: Vec<&str> = self.axes.iter().map(String::as_str).collect();
        let conditions: Vec<&str> = self.conditions.iter().map(String::as_str).collect();
        raised.about(&axes, &conditions)
    }

    fn event(&mut self, t: f64, kind: &'static str, text: &Message, more: Value) {
        let mut event = json!({ "t_s": t, "event": kind });
        if let (Value::Object(event), Value::Object(more)) = (&mut event, more) {
            event.extend(more);
        }
        let line = if self.json { event.to_string() } else { printed(t, kind, text) };
        self.print(&line);
        self.events.push(event);
    }

    fn event_now(&mut self, kind: &'static str, text: &Message, more: Value) {
        let t = self.now.map_or(0.0, |now| now.t);
        self.event(t, kind, text, more);
    }

    fn print(&mut self, line: &str) {
        if self.quiet {
            return;
        }
        let mut out = std::io::stdout().lock();
        // Errors are ignored: the reader may have gone, but the cell goes on.
        let _ = writeln!(out, "{line}").and_then(|()| out.flush());
    }

    /// The journal for power loss, if the weld is recorded.
    pub(in crate::verbs) fn journal(&self) -> Result<Option<Journal>, Failure> {
        self.table.as_ref().map_or(Ok(None), Table::journal)
    }

    /// Position of the weld, if it is due to be recorded.
    pub(super) fn position(&mut self) -> Option<Position> {
        let weld = self.table.as_ref().and_then(Table::weld)?;
        self.places.position(&self.now?, weld)
    }

    /// Log of the events, a line each, and the end of the run.
    pub(in crate::verbs) fn files(&self, title: &str, ended: &Ended) -> [(&'static str, String); 2] {
        let mut lines = String::new();
        for event in &self.events {
            lines += &event.to_string();
            lines.push('\n');
        }
        let timing = ended.timing.as_ref().map(|(footing, latency)| {
            json!({ "footing": english(&footing.message()), "cycles": latency.count(), "missed": latency.missed(),
                "late_us": { "median": latency.quantile_us(0.5), "p99_9": latency.quantile_us(0.999), "most": latency.most_us() } })
        });
        let place = |place: Place| json!({ "pass": place.pass, "welded_mm": place.s_mm });
        let run = json!({
            "title": title,
            "mode": self.now.map(|now| now.mode.name()),
            "passes": self.passes.iter().map(|p| place(*p)).collect::<Vec<_>>(),
            "left": ended.left.map(place),
            "stopped_by": self.stopped.as_ref().map(english),
            "ended_by": self.ended_by.map(|cause| english(&cause.message())),
            "refused": self.refused.as_ref().map(english),
            "timing": timing,
            "devices": devices::traffic_report(&ended.lines),
        });
        [("events.jsonl", lines), ("run.json", format!("{run:#}\n"))]
    }

    /// Alarms and events, for the library.
    pub(in crate::verbs) fn happened(&self) -> Happened<'_> {
        Happened { alarms: &self.alarms, events: &self.kept }
    }

    /// True if an alarm held the program or took the cell down.
    pub(in crate::verbs) fn was_stopped(&self) -> bool {
        self.stopped.is_some()
    }

    /// Puts the record into `output`, and into the library if requested.
    pub(in crate::verbs) fn close(&mut self, output: &mut Output, title: &str, ended: &Ended) -> Result<(), Failure> {
        let files = self.files(title, ended);
        for (name, text) in &files {
            output.text(name, text)?;
        }
        let Some(table) = self.table.take() else { return Ok(()) };
        let undisturbed = self.stopped.is_none() && self.ended_by.is_none();
        let done = undisturbed && ended.left.is_none() && !self.passes.is_empty();
        let result = if done { WeldResult::Good } else { WeldResult::Stopped };
        let stopped = |cause: &ShutdownCause| Message::new("cell-note-stopped").message("cause", cause.message());
        let mut notes: Vec<Message> = self.ended_by.iter().map(stopped).collect();
        match ended.left {
            Some(left) => {
                let note = Message::new("cell-note-left").pass("pass", left.pass);
                notes.push(note.quantity("at", left.s_mm, Unit::Mm, 2));
            }
            None if self.passes.is_empty() => notes.push(Message::new("cell-note-nothing-welded")),
            None => {}
        }
        let note = joined(notes);
        let files = files.map(|(name, text)| (name.to_owned(), text)).into();
        table.finish(&Outcome { result, note, files }, self.happened(), output)
    }

    /// The exit code that follows.
    pub(in crate::verbs) fn judge(self) -> Result<(), Failure> {
        if let Some(failure) = self.record {
            return Err(failure);
        }
        if let Some(cause) = self.ended_by {
            return Err(Failure::environment(Message::new("cli-run-stopped-by").message("cause", cause.message())));
        }
        match (self.stopped, self.refused) {
            (Some(alarm), _) => {
                Err(Failure::environment(Message::new("cli-run-stopped-by-alarm").message("alarm", alarm)))
            }
            (None, Some(_)) => Err(Failure::Printed),
            (None, None) => Ok(()),
        }
    }
}
