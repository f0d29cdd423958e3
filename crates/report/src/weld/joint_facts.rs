//! The joint in words and numbers: seam, start, preparation of the edges.

use super::figures::{SeamFigures, WeldReport};
use super::range::Range;
use crate::number::{number, quantity};
use crate::words::value_name;
use crate::{Language, Words as _, value_names};
use seamwright_message::Unit;
use seamwright_program::{Joint, WeldDirection};

/// Kinds of seams that do not go around a tube.
const STRAIGHT: [&str; 3] = ["line", "T-joint", "spline"];

type Fact = (String, String);

impl WeldReport {
    pub(super) fn joint_facts(&self, language: Language) -> Vec<Fact> {
        let mut facts: Vec<Fact> = Vec::new();
        facts.extend(self.seam.iter().flat_map(|seam| self.seam_facts(seam, language)));
        facts.extend(self.joint.iter().flat_map(|joint| preparation_facts(joint, language)));
        facts.extend(self.material_facts(language));
        facts
    }

    fn seam_facts(&self, seam: &SeamFigures, language: Language) -> Vec<Fact> {
        let value = |value: f64, unit| quantity(value, unit, 5).in_language(language);
        let dihedral = Range::from((seam.dihedral_min_deg, seam.dihedral_max_deg)).short_text(language);
        let kind = language.named("key", seam.kind).unwrap_or_else(|| seam.kind.to_owned());
        let mut facts = vec![
            (language.words("report-row-seam"), kind),
            (language.words("report-row-seam-length"), value(seam.length_mm, Unit::Mm)),
            (language.words("report-row-dihedral"), format!("{dihedral}{}", language.symbol(Unit::Deg))),
        ];
        let start = &self.plan.start;
        if !STRAIGHT.contains(&seam.kind) {
            let direction = language.words(match start.direction {
                WeldDirection::CounterClockwise => "report-counter-clockwise",
                WeldDirection::Clockwise => "report-clockwise",
            });
            facts.extend([
                (language.words("report-row-start-angle"), value(start.phi_deg.get(), Unit::Deg)),
                (language.words("report-row-direction"), direction),
                (language.words("report-row-overlap"), value(start.overlap_mm.get(), Unit::Mm)),
            ]);
        }
        facts
    }
}

/// Returns kind and sizes of the joint's preparation, backing, insert and gouge, and what changes with the dihedral angle,
/// under the names of their keys in job files.
fn preparation_facts(joint: &Joint, language: Language) -> Vec<Fact> {
    let kind = joint.preparation.key();
    let mut facts = vec![(language.words("report-row-preparation"), key_name(kind, language))];
    let table = toml::Table::try_from(joint).unwrap_or_default();
    let preparation = table.get("preparation").and_then(|all| all.get(kind)).and_then(toml::Value::as_table);
    let own = table.iter().filter(|(key, _)| ["cap_mm", "side"].contains(&key.as_str()));
    let sizes = preparation.into_iter().flatten().chain(own);
    facts.extend(sizes.filter_map(|(key, value)| size_fact(key, value, language)));
    for key in ["backing", "insert", "gouge"] {
        let sizes = table.get(key).and_then(toml::Value::as_table);
        facts.extend(sizes.map(|sizes| (capitalised(&key_name(key, language)), sizes_text(sizes, language))));
    }
    let rows = table.get("at_dihedral").and_then(toml::Value::as_array);
    facts.extend(rows.map(|rows| {
        let rows = rows.iter().filter_map(toml::Value::as_table).map(|row| sizes_text(row, language));
        (capitalised(&key_name("at_dihedral", language)), rows.collect::<Vec<_>>().join("; "))
    }));
    facts
}

/// Returns the name of a key of job files, or of a value that is a name.
fn key_name(key: &str, language: Language) -> String {
    language.named("key", key).unwrap_or_else(|| key.replace('_', " "))
}

/// Returns the name and the value of a key; none of tables and lists.
fn size_fact(key: &str, value: &toml::Value, language: Language) -> Option<Fact> {
    let (title, unit) = value_name(key);
    let title = language.named("key", title).unwrap_or_else(|| value_names::value_title(language, key));
    let size = |value: f64| match unit {
        Some(unit) => quantity(value, unit, 5).in_language(language),
        None => number(value, language),
    };
    let text = match value {
        toml::Value::Float(value) => size(*value),
        toml::Value::Integer(value) => size(*value as f64),
        toml::Value::String(name) => key_name(name, language),
        _ => return None,
    };
    Some((capitalised(&title), text))
}

/// Returns the sizes of a table in one line, a kind first and without its title.
fn sizes_text(sizes: &toml::Table, language: Language) -> String {
    let kind = sizes.get("kind").and_then(toml::Value::as_str).map(|kind| key_name(kind, language));
    let others = sizes.iter().filter(|(key, _)| *key != "kind").filter_map(|(key, value)| {
        let (title, text) = size_fact(key, value, language)?;
        Some(format!("{} {text}", uncapitalised(&title, language)))
    });
    kind.into_iter().chain(others).collect::<Vec<_>>().join(", ")
}

/// Returns the text with a small letter at its start, except in German, whose nouns have capitals.
fn uncapitalised(text: &str, language: Language) -> String {
    let mut rest = text.chars();
    match rest.next() {
        Some(first) if language != Language::German => first.to_lowercase().chain(rest).collect(),
        _ => text.to_owned(),
    }
}

/// Returns the text with a capital at its start, as other names of facts have.
pub(super) fn capitalised(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
