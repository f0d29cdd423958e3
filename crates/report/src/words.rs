//! Words of pages, from the catalogues of messages.

use seamwright_message::{Catalogue, Language, Message, Unit};
use std::borrow::Cow;

pub(crate) trait Words: Copy {
    /// Returns the words of a code without arguments; empty for an empty code.
    fn words(self, code: &'static str) -> String;

    /// Returns the name of `name` in the family `kind` of shared words, if it has one: a process value, a mode, a kind
    /// of seam.
    fn named(self, kind: &str, name: &str) -> Option<String>;

    fn symbol(self, unit: Unit) -> String;

    fn named_values<const N: usize>(self, values: [(&'static str, String); N]) -> Vec<(String, String)>;

    /// Joins sentences: Chinese full stops include their space.
    fn sentences(self, sentences: &[String]) -> String;
}

impl Words for Language {
    fn words(self, code: &'static str) -> String {
        if code.is_empty() { String::new() } else { Message::new(code).in_language(self) }
    }

    fn named(self, kind: &str, name: &str) -> Option<String> {
        let code = format!("{kind}-{}", name.to_lowercase().replace([' ', '_'], "-"));
        let catalogue = Catalogue::of(self);
        catalogue.has(&code).then(|| catalogue.text(&Message { code: Cow::Owned(code), arguments: Vec::new() }))
    }

    fn symbol(self, unit: Unit) -> String {
        Catalogue::of(self).symbol(unit)
    }

    fn named_values<const N: usize>(self, values: [(&'static str, String); N]) -> Vec<(String, String)> {
        values.map(|(name, value)| (self.words(name), value)).into()
    }

    fn sentences(self, sentences: &[String]) -> String {
        let full: Vec<&str> = sentences.iter().map(String::as_str).filter(|sentence| !sentence.is_empty()).collect();
        full.join(if self == Self::Chinese { "" } else { " " })
    }
}

/// Units by the ends of the names of values in files.
const UNITS: [(&str, Unit); 22] = [
    ("a", Unit::A),
    ("v", Unit::V),
    ("kv", Unit::KiloV),
    ("ma", Unit::MilliA),
    ("w", Unit::W),
    ("kw", Unit::KiloW),
    ("mm", Unit::Mm),
    ("m_min", Unit::MPerMin),
    ("mm_s", Unit::MmPerS),
    ("mm_min", Unit::MmPerMin),
    ("l_min", Unit::LPerMin),
    ("hz", Unit::Hz),
    ("khz", Unit::KiloHz),
    ("deg", Unit::Deg),
    ("s", Unit::S),
    ("ms", Unit::Ms),
    ("percent", Unit::Percent),
    ("mbar", Unit::Mbar),
    ("bar", Unit::Bar),
    ("c", Unit::DegC),
    ("k", Unit::K),
    ("kj_mm", Unit::KiloJPerMm),
];

/// Splits the name of a value in files into title and unit.
pub(crate) fn value_name(name: &str) -> (&str, Option<Unit>) {
    let ends = UNITS.iter().filter_map(|(end, unit)| Some((name.strip_suffix(end)?.strip_suffix('_')?, *unit)));
    // `mm_s` is not `s`.
    let longest = ends.min_by_key(|(title, _)| title.len());
    longest.map_or((name, None), |(title, unit)| (title, Some(unit)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_program::WeldingProcess;

    #[test]
    fn names_in_files_have_words() {
        let source = include_str!("../../program/src/seam.rs");
        let kinds = source.split_once("fn kind").unwrap().1.split_once("    }\n}").unwrap().0;
        let kinds: Vec<&str> = kinds.split("=> \"").skip(1).map(|kind| kind.split('"').next().unwrap()).collect();
        assert!(kinds.len() > 10);
        for kind in kinds {
            assert!(Language::German.named("key", kind).is_some(), "{kind}");
        }
        for process in WeldingProcess::all() {
            assert!(Language::German.named("process", &process.number.to_string()).is_some(), "{}", process.name);
        }
        let windows =
            ["speed_mm_s", "heat_input_kj_mm", "travel_angle_deg", "work_angle_deg", "preheat_c", "interpass_c"];
        for value in windows.into_iter().chain(["current_a", "voltage_v", "laser_w", "beam_ma", "accelerating_kv"]) {
            let (title, unit) = value_name(value);
            assert!(unit.is_some() && Language::German.named("value", title).is_some(), "{value}");
        }
    }

    #[test]
    fn the_unit_of_a_value_is_the_longest_end_of_its_name() {
        for (name, parts) in [
            ("current_a", ("current", Some(Unit::A))),
            ("tip_speed_mm_s", ("tip_speed", Some(Unit::MmPerS))),
            ("heat_input_kj_mm", ("heat_input", Some(Unit::KiloJPerMm))),
            ("wire_feed_m_min", ("wire_feed", Some(Unit::MPerMin))),
            ("odd", ("odd", None)),
            ("a", ("a", None)),
        ] {
            assert_eq!(value_name(name), parts);
        }
    }

    #[test]
    fn units_have_symbols_without_a_number() {
        assert_eq!(Language::English.symbol(Unit::DegPerS2), "°/s²");
        assert_eq!(Language::Ukrainian.symbol(Unit::MmPerS), "мм/с");
        assert_eq!(Language::German.symbol(Unit::One), "");
    }
}
