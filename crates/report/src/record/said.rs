//! What the library keeps in the cell's English, in the language of the page. What has no words there stays as it is.

use crate::Language;
use crate::language::value_name;
use seamwright_cell::executive::{Alarm as Catalogue, Entry};
use seamwright_record::figures::HEAT_INPUT;
use seamwright_record::library::Alarm;

/// A process value, whose name in files ends in its unit: `Current, A`.
pub(super) fn value(language: Language, name: &str) -> String {
    let (title, unit) = value_name(name);
    let title = language.named("value", title).map_or_else(|| title.replace('_', " "), str::to_owned);
    match unit {
        // A unit is not broken over lines.
        Some(unit) => format!("{title}, {}", language.known(unit).unwrap_or(unit).replace('/', "/\u{2060}")),
        None => title,
    }
}

/// A curve by the name of its column, which ends in the name of the head if there are several.
pub(super) fn curve(language: Language, column: &str) -> String {
    let of = |start: &str, word| Some((language.say(word), column.strip_prefix(start)?));
    let known = of("miss_lateral_mm", "track.lateral")
        .or_else(|| of("miss_height_mm", "track.height"))
        .or_else(|| of("path_error_mm", "torch tip"))
        .or_else(|| of(HEAT_INPUT, "value.heat_input"));
    match known.map(|(word, head)| (word, head.trim_start_matches('_'))) {
        Some((word, "")) => word.to_owned(),
        Some((word, head)) => language.fill("{0}, head {1}", &[word, head]),
        None => column.to_owned(),
    }
}

/// The entry of the catalogue that an alarm of the library is, and what it is about: `NAME`, `NAME (OF)` or `NAME: OF`.
fn entry(name: &str) -> Option<(Entry, &str)> {
    Catalogue::ALL.into_iter().find_map(|alarm| {
        let entry = alarm.entry();
        let rest = name.strip_prefix(entry.name)?;
        let about = rest.strip_prefix(" (").and_then(|rest| rest.strip_suffix(')')).or(rest.strip_prefix(": "));
        (about.is_some() || rest.is_empty()).then_some((entry, about.unwrap_or_default()))
    })
}

/// An alarm's title, with the axis, condition or trouble that it is about.
pub(super) fn alarm(language: Language, name: &str) -> String {
    let Some((words, about)) = entry(name).and_then(|(entry, about)| Some((language.alarm(entry.name)?, about))) else {
        return name.to_owned();
    };
    match about {
        "" => words.title.clone(),
        _ => {
            let condition = language.named("interlock", about).map(str::to_owned);
            format!("{} ({})", words.title, condition.unwrap_or_else(|| sentence(language, about)))
        }
    }
}

/// Why an alarm comes, if it is what the catalogue says.
pub(super) fn cause(language: Language, of: &Alarm) -> String {
    let known = entry(&of.name).filter(|(entry, _)| entry.cause == of.cause);
    let words = known.and_then(|(entry, _)| language.alarm(entry.name));
    words.map_or(&of.cause, |words| &words.cause).clone()
}

/// A sentence about a weld, or an alarm in one.
fn sentence(language: Language, text: &str) -> String {
    let own = alarm(language, text);
    if own != text {
        return own;
    }
    language.sentence(text, |of| sentence(language, of)).unwrap_or(own)
}

/// What happened: another mode, an order, or a sentence.
pub(super) fn event(language: Language, text: &str) -> String {
    if language == Language::English {
        return text.to_owned();
    }
    let modes = text.split_once(" -> ");
    if let Some((from, to)) = modes.and_then(|(a, b)| language.named("mode", a).zip(language.named("mode", b))) {
        return format!("{from} → {to}");
    }
    language.named("do", text).map_or_else(|| sentence(language, text), str::to_owned)
}

/// What a weld's note says, sentence by sentence.
pub(super) fn note(language: Language, text: &str) -> String {
    text.split("; ").map(|one| sentence(language, one)).collect::<Vec<_>>().join("; ")
}
