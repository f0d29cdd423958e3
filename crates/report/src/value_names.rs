//! Names of values and curves in files, in the language of a page. Names without words stay as they are.

use crate::Language;
use crate::Words as _;
use crate::words::value_name;
use seamwright_message::Message;
use seamwright_record::figures::HEAT_INPUT;

/// Returns the name of a process value without its unit, such as `Current`.
pub(crate) fn value_title(language: Language, name: &str) -> String {
    let (title, _) = value_name(name);
    language.named("value", title).unwrap_or_else(|| title.replace('_', " "))
}

pub(crate) fn value_parts(language: Language, name: &str) -> [String; 2] {
    [value_title(language, name), value_name(name).1.map_or_else(String::new, |unit| language.symbol(unit))]
}

/// Returns a process value, whose name in files ends in its unit, as `Current, A`.
pub(crate) fn value(language: Language, name: &str) -> String {
    let [title, unit] = value_parts(language, name);
    // A unit must not break over lines.
    if unit.is_empty() { title } else { format!("{title}, {}", unit.replace('/', "/\u{2060}")) }
}

/// Returns the name of a curve by its column, which ends in the name of the head if there are several.
pub(crate) fn curve(language: Language, column: &str) -> String {
    let of = |start: &str, code| Some((language.words(code), column.strip_prefix(start)?));
    let known = of("miss_lateral_mm", "track-lateral")
        .or_else(|| of("miss_height_mm", "track-height"))
        .or_else(|| of("path_error_mm", "report-label-torch-tip"))
        .or_else(|| of(HEAT_INPUT, "value-heat-input"));
    match known.map(|(words, head)| (words, head.trim_start_matches('_'))) {
        Some((words, "")) => words,
        Some((words, head)) => {
            Message::new("report-curve-of-head").text("curve", words).text("head", head).in_language(language)
        }
        None => column.to_owned(),
    }
}
