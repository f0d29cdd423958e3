//! Events of a weld beside alarms, as the library records them.

use seamwright_cell::executive::{Ask, Note, Place};
use seamwright_message::{Message, Unit};
use seamwright_record::Moment;
use seamwright_record::library::{Event, Place as Recorded};

/// Code of the event that a pass was left.
const LEFT: &str = "project-event-left";

/// The event of `note` at time `t` (s) with the torch at `here`; `None` for notes that are no event of a weld.
pub fn event(t: f64, note: &Note, here: Place) -> Option<Event> {
    let (text, place) = match note {
        Note::Mode(from, to) => {
            let modes = Message::new("project-event-mode").text("from", from.to_string());
            (modes.text("to", to.to_string()), here)
        }
        Note::Taken(command) => (order(&command.ask)?, here),
        Note::Missed(cycles, longest_ms) => {
            let missed = Message::new("project-event-cycles-missed").number("cycles", f64::from(*cycles), 0);
            (missed.quantity("longest", *longest_ms, Unit::Ms, 0), here)
        }
        Note::PassEnds(place) => (Message::new("project-event-pass-ends").pass("pass", place.pass), *place),
        Note::Left(place) => {
            let left = Message::new(LEFT).pass("pass", place.pass).quantity("welded", place.s_mm, Unit::Mm, 2);
            (left, *place)
        }
        Note::Refused(..) | Note::Lacks(..) | Note::Alarm(_) | Note::Cleared(..) => return None,
    };
    let in_pass = place.pass > 0;
    let place =
        Recorded { pass: in_pass.then_some(place.pass as u32), s_mm: in_pass.then_some(place.s_mm), t_s: Some(t) };
    Some(Event { at: Moment::now(), text, place })
}

/// Position at which a weld of these events was left last, as reported by [`event`]: pass from 1, and the path length
/// up to which it is welded (mm).
pub fn left(events: &[Event]) -> Option<(u32, f64)> {
    let left = events.iter().rfind(|event| event.text.code == LEFT)?;
    left.place.pass.zip(left.place.s_mm)
}

/// An order that changes how a weld goes.
fn order(ask: &Ask) -> Option<Message> {
    match ask {
        Ask::Override(part) => {
            Some(Message::new("project-event-override").quantity("override", 100.0 * part, Unit::Percent, 0))
        }
        Ask::Hold | Ask::Resume | Ask::Reverse | Ask::Stop => Some(Message::verbatim(ask.name())),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_cell::executive::{Command, Mode};

    #[test]
    fn events_have_their_place() {
        let here = Place { pass: 2, s_mm: 12.5 };
        let held = event(3.0, &Note::Mode(Mode::Weld, Mode::Hold), here).unwrap();
        assert_eq!(
            (held.text.to_string().as_str(), held.place.pass, held.place.s_mm),
            ("weld -> hold", Some(2), Some(12.5))
        );
        let slow = Note::Taken(Command::of(Ask::Override(0.5)));
        assert_eq!(event(3.0, &slow, Place::default()).unwrap().text.to_string(), "override 50 %");
        assert_eq!(event(3.0, &slow, Place::default()).unwrap().place.pass, None);
        let left = event(4.0, &Note::Left(here), Place::default()).unwrap();
        assert_eq!(
            (left.text.to_string().as_str(), left.place.s_mm),
            ("pass 2 was left, welded up to 12.50 mm", Some(12.5))
        );
        assert_eq!(event(4.0, &Note::Taken(Command::of(Ask::Acknowledge)), here), None);
        assert_eq!(
            (super::left(&[held.clone(), left.clone(), held.clone()]), super::left(&[held])),
            (Some((2, 12.5)), None)
        );
    }
}
