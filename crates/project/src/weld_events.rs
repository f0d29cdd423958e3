//! Events of a weld beside alarms, as the library records them.

use seamwright_executive::{Ask, Note, Place};
use seamwright_message::{Argument, Message};
use seamwright_record::{Event, Moment, Place as Recorded};

/// The event of `note` at time `t` (s) with the torch at `here`; `None` for notes that are no event of a weld.
pub fn event(t: f64, note: &Note, here: Place) -> Option<Event> {
    let place = match note {
        Note::Taken(command) if !changes_weld(&command.ask) => return None,
        Note::PassEnds(place) | Note::Left(place) => *place,
        _ => here,
    };
    let text = note.message()?;
    let in_pass = place.pass > 0;
    let place =
        Recorded { pass: in_pass.then_some(place.pass as u32), s_mm: in_pass.then_some(place.s_mm), t_s: Some(t) };
    Some(Event { at: Moment::now(), text, place })
}

/// Position at which a weld of these events was left last, as reported by [`event`]: pass from 1, and the path length
/// up to which it is welded (mm).
pub fn left(events: &[Event]) -> Option<(u32, f64)> {
    let left = events.iter().rfind(|event| is_left(&event.text))?;
    left.place.pass.zip(left.place.s_mm)
}

fn is_left(text: &Message) -> bool {
    match (text.code.as_ref(), text.argument("text")) {
        // A sentence of an older version.
        ("text", Some(Argument::Text(text))) => text.contains(" was left, welded up to "),
        (code, _) => code == "cell-event-pass-left",
    }
}

/// True for a command that changes how a weld goes.
fn changes_weld(ask: &Ask) -> bool {
    matches!(ask, Ask::Override(_) | Ask::Hold | Ask::Resume | Ask::Reverse | Ask::Stop)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_executive::{Command, Mode};

    #[test]
    fn events_have_their_place() {
        let here = Place { pass: 2, s_mm: 12.5 };
        let held = event(3.0, &Note::Mode(Mode::Weld, Mode::Hold), here).unwrap();
        assert_eq!(
            (held.text.to_string(), held.place.pass, held.place.s_mm),
            ("weld -> hold".to_owned(), Some(2), Some(12.5))
        );
        let slow = Note::Taken(Command::of(Ask::Override(0.5)));
        assert_eq!(event(3.0, &slow, Place::default()).unwrap().text.to_string(), "override 50 %");
        assert_eq!(event(3.0, &slow, Place::default()).unwrap().place.pass, None);
        let left = event(4.0, &Note::Left(here), Place::default()).unwrap();
        assert_eq!((left.text.code.as_ref(), left.place.s_mm), ("cell-event-pass-left", Some(12.5)));
        assert_eq!(event(4.0, &Note::Taken(Command::of(Ask::Acknowledge)), here), None);
        let old = Event { text: Message::verbatim("pass 2 was left, welded up to 12.50 mm"), ..left.clone() };
        assert_eq!(super::left(&[old, held.clone()]), Some((2, 12.5)));
        assert_eq!(
            (super::left(&[held.clone(), left.clone(), held.clone()]), super::left(&[held])),
            (Some((2, 12.5)), None)
        );
    }
}
