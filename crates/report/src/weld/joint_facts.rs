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

/// Returns kind and sizes of the joint's preparation, under the names of their keys in job files.
fn preparation_facts(joint: &Joint, language: Language) -> Vec<Fact> {
    let kind = joint.preparation.key();
    let kind_name = language.named("key", kind).unwrap_or_else(|| kind.replace('_', " "));
    let mut facts = vec![(language.words("report-row-preparation"), kind_name)];
    let table = toml::Table::try_from(joint).unwrap_or_default();
    let preparation = table.get("preparation").and_then(|all| all.get(kind)).and_then(toml::Value::as_table);
    let cap = table.iter().filter(|(key, _)| *key == "cap_mm");
    facts.extend(preparation.into_iter().flatten().chain(cap).filter_map(|(key, value)| {
        let (title, unit) = value_name(key);
        let title = language.named("key", title).unwrap_or_else(|| value_names::value_title(language, key));
        let size = |value: f64| match unit {
            Some(unit) => quantity(value, unit, 5).in_language(language),
            None => number(value, language),
        };
        let text = match value {
            toml::Value::Float(value) => size(*value),
            toml::Value::Integer(value) => size(*value as f64),
            toml::Value::String(name) => language.named("key", name).unwrap_or_else(|| name.clone()),
            _ => return None,
        };
        Some((capitalised(&title), text))
    }));
    facts
}

/// Returns the text with a capital at its start, as other names of facts have.
pub(super) fn capitalised(text: &str) -> String {
    let mut rest = text.chars();
    rest.next().map_or_else(String::new, |first| first.to_uppercase().chain(rest).collect())
}
