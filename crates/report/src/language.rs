//! Languages of a page and their words, which are data in `words/` at the root of the sources. Texts shared with the
//! panel are in a file for each language, which the panel sends. Sentences about plans are in `findings.json`, those
//! about welds in `notes.json`. Texts only of reports are in `report.json`, those only of plan reports in `plan.json`.

use seamwright_message::Language;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::HashMap;
use std::sync::LazyLock;

/// A phrase in each language, with placeholders `{0}`, `{1}` ..
pub(crate) type Row = [String; 5];

/// Texts of an alarm of the catalogue, for the panel and reports.
#[derive(Deserialize)]
pub(crate) struct AlarmWords {
    pub(crate) title: String,
    pub(crate) cause: String,
}

/// Texts of a language, for the panel and reports; English alarms are the catalogue's own.
#[derive(Default, Deserialize)]
struct Tongue {
    words: HashMap<String, String>,
    #[serde(default)]
    alarms: HashMap<String, AlarmWords>,
}

struct Words {
    tongues: [Tongue; 5],
    /// Phrases by their English text.
    phrases: HashMap<String, Row>,
    /// Patterns of sentences, longest first, because a short pattern matches many texts.
    sentences: Vec<Row>,
    /// Units by the suffixes of value names.
    units: HashMap<String, String>,
}

/// Parses a file of the folder of words; an invalid file gives no words, and a test reads all of them.
fn read<T: DeserializeOwned + Default>(text: &str) -> T {
    serde_json::from_str(text).unwrap_or_default()
}

static WORDS: LazyLock<Words> = LazyLock::new(|| {
    let tongues: [Tongue; 5] = [
        include_str!("../../../words/en.json"),
        include_str!("../../../words/uk.json"),
        include_str!("../../../words/zh.json"),
        include_str!("../../../words/de.json"),
        include_str!("../../../words/ru.json"),
    ]
    .map(read);
    let of_report: Vec<Row> = read(include_str!("../../../words/report.json"));
    let of_plan: Vec<Row> = read(include_str!("../../../words/plan.json"));
    let of_welds: Vec<Row> = read(include_str!("../../../words/notes.json"));
    let phrases = of_report.iter().chain(&of_plan).chain(&of_welds).map(|row| (row[0].clone(), row.clone())).collect();
    let mut sentences: Vec<Row> = read(include_str!("../../../words/findings.json"));
    // `|` separates the pieces of which the sources compose a sentence, for a test of the panel.
    sentences.iter_mut().for_each(|row| row[0] = row[0].replace('|', ""));
    sentences.extend(of_welds);
    // The only event with the same words in the panel's list of events.
    sentences.push(std::array::from_fn(|i| tongues[i].words.get("said.left").cloned().unwrap_or_default()));
    sentences.sort_by_key(|row| {
        let (said, holes) = measure(&row[0]);
        (std::cmp::Reverse(said), holes)
    });
    Words { tongues, phrases, sentences, units: read(include_str!("../../../words/units.json")) }
});

/// Returns the first placeholder of a pattern: the text before it, its number, the text behind it. Other braces are
/// text.
fn hole(pattern: &str) -> Option<(&str, usize, &str)> {
    pattern.match_indices('{').find_map(|(i, _)| {
        let (number, behind) = pattern[i + 1..].split_once('}')?;
        Some((&pattern[..i], number.parse().ok()?, behind))
    })
}

/// Returns the length of a pattern without its placeholders, and their number.
fn measure(pattern: &str) -> (usize, usize) {
    let Some((before, _, behind)) = hole(pattern) else { return (pattern.len(), 0) };
    let (said, holes) = measure(behind);
    (before.len() + said, holes + 1)
}

/// Returns the arguments in the placeholders of `pattern`, with their numbers, if `text` matches it.
fn holes<'a>(pattern: &str, text: &'a str) -> Option<Vec<(usize, &'a str)>> {
    let Some((before, mut number, mut behind)) = hole(pattern) else { return (pattern == text).then(Vec::new) };
    let mut rest = text.strip_prefix(before)?;
    let mut found = Vec::new();
    while let Some((between, next, last)) = hole(behind) {
        let (of, after) = rest.split_once(between)?;
        found.push((number, of));
        (rest, number, behind) = (after, next, last);
    }
    found.push((number, rest.strip_suffix(behind)?));
    Some(found)
}

/// Fills the placeholders of `words` with `of` in one pass, so that placeholders inside arguments stay text.
fn filled(words: &str, of: &[&str]) -> String {
    let (mut text, mut rest) = (String::new(), words);
    while let Some((before, number, behind)) = hole(rest) {
        text.push_str(before);
        text.push_str(of.get(number).unwrap_or(&""));
        rest = behind;
    }
    text + rest
}

/// Words of a language for pages.
pub(crate) trait Phrases: Sized {
    /// Returns the text of an English phrase or of a key of the panel's words; `None` if both are unknown.
    fn known(self, text: &str) -> Option<&'static str>;

    /// Returns the text of an English phrase or of a key of the panel's words.
    fn say(self, text: &'static str) -> &'static str;

    /// Returns the text with `of` in the placeholders.
    fn fill(self, text: &'static str, of: &[&str]) -> String;

    /// Translates a unit or another known text; an unknown one is returned unchanged.
    fn unit(self, text: &str) -> &str;

    /// Returns the separator of two sentences: Chinese full stops include their space.
    fn between_sentences(self) -> &'static str;

    /// Returns the name of `name` in the panel's words for `kind`, if known.
    fn named(self, kind: &str, name: &str) -> Option<&'static str>;

    /// Returns the texts of an alarm of the catalogue; `None` in English, whose texts are the catalogue's.
    fn alarm(self, name: &str) -> Option<&'static AlarmWords>;

    /// Translates a sentence about a plan or a weld by its pattern; `word` translates its arguments.
    fn sentence(self, text: &str, word: impl Fn(&str) -> String) -> Option<String>;
}

impl Phrases for Language {
    fn known(self, text: &str) -> Option<&'static str> {
        let phrase = WORDS.phrases.get(text).map(|row| &row[self as usize]);
        phrase.or_else(|| WORDS.tongues[self as usize].words.get(text)).map(String::as_str)
    }

    fn say(self, text: &'static str) -> &'static str {
        let words = self.known(text);
        debug_assert!(words.is_some() || text.is_empty(), "`{text}` has no words");
        words.unwrap_or(text)
    }

    fn fill(self, text: &'static str, of: &[&str]) -> String {
        filled(self.say(text), of)
    }

    fn unit(self, text: &str) -> &str {
        self.known(text).unwrap_or(text)
    }

    fn between_sentences(self) -> &'static str {
        if self == Self::Chinese { "" } else { " " }
    }

    fn named(self, kind: &str, name: &str) -> Option<&'static str> {
        self.known(&format!("{kind}.{}", name.replace(' ', "_")))
    }

    fn alarm(self, name: &str) -> Option<&'static AlarmWords> {
        WORDS.tongues[self as usize].alarms.get(name)
    }

    fn sentence(self, text: &str, word: impl Fn(&str) -> String) -> Option<String> {
        WORDS.sentences.iter().find_map(|row| {
            let mut of: Vec<(usize, String)> =
                holes(&row[0], text)?.into_iter().map(|(number, of)| (number, word(of))).collect();
            of.sort_by_key(|(number, _)| *number);
            Some(filled(&row[self as usize], &of.iter().map(|(_, of)| of.as_str()).collect::<Vec<_>>()))
        })
    }
}

/// Splits the name of a value into title and unit.
pub(crate) fn value_name(name: &str) -> (&str, Option<&'static str>) {
    let ends = WORDS
        .units
        .iter()
        .filter_map(|(key, unit)| Some((name.strip_suffix(key.as_str())?.strip_suffix('_')?, unit.as_str())));
    // `mm_s` is not `s`.
    let longest = ends.min_by_key(|(title, _)| title.len());
    longest.map_or((name, None), |(title, unit)| (title, Some(unit)))
}

#[cfg(test)]
mod tests;
