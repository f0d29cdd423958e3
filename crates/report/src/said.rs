//! Translation of the English texts of the cell and the library; unknown texts stay as they are.

use crate::Language;
use crate::Phrases as _;
use crate::language::value_name;
use seamwright_cell::executive::{Alarm as Catalogue, Entry};
use seamwright_message::{Argument, Message};
use seamwright_record::figures::HEAT_INPUT;
use seamwright_record::library::Alarm;

/// Returns a process value without its unit, such as `Current`; in English its name in files.
pub(crate) fn value_title(language: Language, name: &str) -> String {
    if language == Language::English { name.to_owned() } else { title(language, name) }
}

/// Returns a process value with its unit, such as `Strom, A`; in English its name in files.
pub(crate) fn named_value(language: Language, name: &str) -> String {
    if language == Language::English { name.to_owned() } else { value(language, name) }
}

/// Returns title and unit of a process value; in English its name in files.
pub(crate) fn value_parts(language: Language, name: &str) -> [String; 2] {
    match language {
        Language::English => [name.to_owned(), "as named".to_owned()],
        _ => [
            title(language, name),
            value_name(name).1.map_or("", |unit| language.known(unit).unwrap_or(unit)).to_owned(),
        ],
    }
}

/// Translates the object of a clearance check; links and zones keep their names in files.
pub(crate) fn watched(language: Language, name: &str) -> String {
    let zone = |kind: &str, said| Some(language.fill(said, &[name.strip_prefix(kind)?.trim_start()]));
    let own = match name {
        "part" => Some(language.say("part").to_owned()),
        "fixtures" => Some(language.say("fixtures").to_owned()),
        _ => None,
    };
    // A solid of the job, with its owner.
    let of = |whose: &str, said| Some(language.fill(said, &[name.strip_suffix(whose)?]));
    own.or_else(|| of(" (part)", "{0} (part)"))
        .or_else(|| of(" (fixtures)", "{0} (fixtures)"))
        .or_else(|| zone("forbidden zone", "forbidden zone {0}"))
        .or_else(|| zone("permitted zone", "permitted zone {0}"))
        .unwrap_or_else(|| name.to_owned())
}

fn title(language: Language, name: &str) -> String {
    let (title, _) = value_name(name);
    language.named("value", title).map_or_else(|| title.replace('_', " "), str::to_owned)
}

/// Returns a process value, whose name in files ends in its unit, as `Current, A`.
pub(crate) fn value(language: Language, name: &str) -> String {
    let title = title(language, name);
    match value_name(name).1 {
        // A unit must not break over lines.
        Some(unit) => format!("{title}, {}", language.known(unit).unwrap_or(unit).replace('/', "/\u{2060}")),
        None => title,
    }
}

/// Translates a curve by the name of its column, which ends in the name of the head if there are several.
pub(crate) fn curve(language: Language, column: &str) -> String {
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

/// Returns the catalogue entry of a library alarm and its object: `NAME`, `NAME (OF)` or `NAME: OF`.
fn entry(name: &str) -> Option<(Entry, &str)> {
    Catalogue::ALL.into_iter().find_map(|alarm| {
        let entry = alarm.entry();
        let rest = name.strip_prefix(entry.name)?;
        let about = rest.strip_prefix(" (").and_then(|rest| rest.strip_suffix(')')).or(rest.strip_prefix(": "));
        (about.is_some() || rest.is_empty()).then_some((entry, about.unwrap_or_default()))
    })
}

/// Returns an alarm's title, with the axis, condition or tracking alarm that it names.
pub(crate) fn alarm(language: Language, name: &str) -> String {
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

/// Translates an alarm's cause if it is that of the catalogue.
pub(crate) fn cause(language: Language, of: &Alarm) -> String {
    let Some(cause) = sentence_of(&of.cause) else { return of.cause.in_language(language) };
    let name = of.name.in_language(Language::English);
    let known = entry(&name).filter(|(entry, _)| entry.cause.in_language(Language::English) == cause);
    let words = known.and_then(|(entry, _)| language.alarm(entry.name));
    words.map_or(cause, |words| &words.cause).to_owned()
}

/// Returns the sentence of a message without a code, as older versions have recorded it.
fn sentence_of(message: &Message) -> Option<&str> {
    match message.argument("text") {
        Some(Argument::Text(text)) if message.code == "text" => Some(text),
        _ => None,
    }
}

/// Returns the words of a recorded message; `old` translates the sentence of an older version.
pub(crate) fn recorded(language: Language, message: &Message, old: fn(Language, &str) -> String) -> String {
    sentence_of(message).map_or_else(|| message.in_language(language), |text| old(language, text))
}

/// Returns the words of a message; text without a code is looked up by its sentence.
pub(crate) fn message(language: Language, message: &Message) -> String {
    match message.argument("text") {
        Some(Argument::Text(text)) if message.code == "text" => sentence(language, text),
        _ => message.in_language(language),
    }
}

/// Translates a sentence about a plan or a weld, or an alarm in one. A machine's own messages start with its name.
pub(crate) fn sentence(language: Language, text: &str) -> String {
    if language == Language::English {
        return text.to_owned();
    }
    let own = alarm(language, text);
    if own != text {
        return own;
    }
    let found = language.sentence(text, |of| sentence(language, of));
    let named = || text.split_once(": ").filter(|(name, _)| !name.contains(';') && name.chars().count() <= 40);
    found
        .or_else(|| named().map(|(name, why)| [name, why].map(|part| sentence(language, part)).join(": ")))
        .unwrap_or(own)
}

/// Translates an event: a mode change, an order, or a sentence.
pub(crate) fn event(language: Language, text: &str) -> String {
    if language == Language::English {
        return text.to_owned();
    }
    let modes = text.split_once(" -> ");
    if let Some((from, to)) = modes.and_then(|(a, b)| language.named("mode", a).zip(language.named("mode", b))) {
        return format!("{from} → {to}");
    }
    language.named("do", text).map_or_else(|| sentence(language, text), str::to_owned)
}

/// Translates a weld's note, sentence by sentence.
pub(crate) fn note(language: Language, text: &str) -> String {
    text.split("; ").map(|one| sentence(language, one)).collect::<Vec<_>>().join("; ")
}
