//! What the cell and the library say in English, in the language of the page. What has no words there stays as it is.

use crate::Language;
use crate::language::value_name;
use seamwright_cell::executive::{Alarm as Catalogue, Entry};
use seamwright_record::figures::HEAT_INPUT;
use seamwright_record::library::Alarm;

/// A process value without its unit: `Current`; in English by its name in files.
pub(crate) fn value_title(language: Language, name: &str) -> String {
    if language == Language::English { name.to_owned() } else { title(language, name) }
}

/// A process value with its unit: `Strom, A`; in English by its name in files.
pub(crate) fn named_value(language: Language, name: &str) -> String {
    if language == Language::English { name.to_owned() } else { value(language, name) }
}

/// The same in two: title and unit; in English its name in files.
pub(crate) fn value_parts(language: Language, name: &str) -> [String; 2] {
    match language {
        Language::English => [name.to_owned(), "as named".to_owned()],
        _ => [
            title(language, name),
            value_name(name).1.map_or("", |unit| language.known(unit).unwrap_or(unit)).to_owned(),
        ],
    }
}

/// What clearance is watched of: links and zones by their names in files.
pub(crate) fn watched(language: Language, name: &str) -> String {
    let zone = |kind: &str, said| Some(language.fill(said, &[name.strip_prefix(kind)?.trim_start()]));
    let own = match name {
        "part" => Some(language.say("part").to_owned()),
        "fixtures" => Some(language.say("fixtures").to_owned()),
        _ => None,
    };
    // A solid of the job, with whose it is.
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

/// A process value, whose name in files ends in its unit: `Current, A`.
pub(crate) fn value(language: Language, name: &str) -> String {
    let title = title(language, name);
    match value_name(name).1 {
        // A unit is not broken over lines.
        Some(unit) => format!("{title}, {}", language.known(unit).unwrap_or(unit).replace('/', "/\u{2060}")),
        None => title,
    }
}

/// A curve by the name of its column, which ends in the name of the head if there are several.
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

/// Why an alarm comes, if it is what the catalogue says.
pub(crate) fn cause(language: Language, of: &Alarm) -> String {
    let known = entry(&of.name).filter(|(entry, _)| entry.cause == of.cause);
    let words = known.and_then(|(entry, _)| language.alarm(entry.name));
    words.map_or(&of.cause, |words| &words.cause).clone()
}

/// A sentence about a plan or a weld, or an alarm in one. What a machine says of itself begins with its name.
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

/// What happened: another mode, an order, or a sentence.
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

/// What a weld's note says, sentence by sentence.
pub(crate) fn note(language: Language, text: &str) -> String {
    text.split("; ").map(|one| sentence(language, one)).collect::<Vec<_>>().join("; ")
}
