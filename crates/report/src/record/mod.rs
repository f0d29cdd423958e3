//! Report of a recorded weld against its procedure, to be signed.

mod charts;
mod tables;

use crate::block::{sections, signatures, tile};
use crate::number::{Significant as _, range, significant};
use crate::{Block, Language, Page, Severity, Tile, Verdict, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_record::figures::{Figures, Value};
use seamwright_record::library::{WeldDetail, WeldRecord, WeldResult};

/// Renders the report as one self-contained HTML page in this language; `program` is the welded text, `date` that of
/// the page. Typed texts stay untranslated.
pub fn recorded_weld_page(
    detail: &WeldDetail,
    figures: &Figures,
    program: &str,
    date: &str,
    language: Language,
) -> String {
    let weld = &detail.weld;
    let source = Block::Code { caption: weld.program.0.clone(), text: program.to_owned() };
    let welder = weld.welder.clone().unwrap_or_default();
    let signers = [("report-meta-welder", welder.clone()), ("report-inspector", String::new())];
    let events = if detail.events.is_empty() { vec![] } else { vec![tables::events(&detail.events, language)] };
    let parts = [
        ("report-heading-values", vec![tables::values(&detail.values, language)]),
        ("value-heat-input", vec![charts::heat_input(figures, &detail.values, language)]),
        ("report-heading-deviations", charts::deviations(figures, language)),
        ("report-heading-alarms", vec![tables::alarms(&detail.alarms, language)]),
        ("report-heading-events", events),
        ("report-heading-record", vec![tables::made_from(weld, language), tables::files(&detail.files, language)]),
        ("report-heading-program", vec![source]),
        ("report-heading-signatures", vec![signatures(signers, language)]),
    ];
    let mut blocks = vec![Block::Tiles(tiles(weld, figures, detail.alarms.len(), language))];
    blocks.extend(sections(parts, language));
    let procedure = weld.procedure.as_ref().map_or_else(|| language.words("report-none"), |(name, _)| name.clone());
    let subtitle = if weld.simulated { "report-subtitle-record-simulated" } else { "report-subtitle-record" };
    let ended = weld.ended.map_or_else(|| language.words("report-not-yet"), |at| at.to_string());
    Page {
        language,
        title: weld.title.clone(),
        subtitle: Message::new(subtitle).text("id", weld.id.to_string()).in_language(language),
        meta: language.named_values([
            ("report-meta-part", weld.part.clone()),
            ("report-meta-welder", welder),
            ("report-meta-machine", weld.machine.0.clone()),
            ("report-meta-procedure", procedure),
            ("report-meta-started", weld.begun.to_string()),
            ("report-meta-ended", ended),
            ("report-meta-page-made", date.to_owned()),
            ("report-meta-made-by", format!("Seamwright {}", env!("CARGO_PKG_VERSION"))),
        ]),
        verdict: Some(verdict(detail, figures, language)),
        blocks,
    }
    .render()
}

fn verdict(detail: &WeldDetail, figures: &Figures, language: Language) -> Verdict {
    let outside: Vec<String> =
        detail.values.iter().filter(|v| v.outside_s > 0.0).map(|v| outside(v, figures, language)).collect();
    let result = match detail.weld.result {
        WeldResult::Good => "report-result-good",
        WeldResult::Deviating => "report-result-deviating",
        WeldResult::Stopped => "report-result-stopped",
        WeldResult::Interrupted => "report-result-interrupted",
        WeldResult::Running => "report-result-running",
    };
    let windows = match (outside.as_slice(), detail.weld.procedure.is_some()) {
        (_, false) => language.words("report-windows-without-procedure"),
        ([], _) => language.words("report-windows-within"),
        (list, _) => Message::new("report-windows-outside").text("values", list.join("; ")).in_language(language),
    };
    let note = match &detail.weld.note {
        note if note.is_empty() => String::new(),
        note => Message::new("report-record-note").message("note", note.clone()).in_language(language),
    };
    let ok = detail.weld.result == WeldResult::Good && outside.is_empty() && detail.weld.note.is_empty();
    Verdict { ok, text: language.sentences(&[language.words(result), windows, note]) }
}

/// Formats a value outside its window and the location, preferably from the trace, which is more detailed than the
/// library.
fn outside(value: &Value, figures: &Figures, language: Language) -> String {
    let name = value_names::value(language, &value.name);
    let known = figures.values.iter().find(|v| (v.pass, &v.name) == (value.pass, &value.name));
    let message = match known.unwrap_or(value).outside_along {
        Some(along) => range("report-value-outside-at", along, Unit::Mm),
        None => Message::new("report-value-outside"),
    };
    message.text("value", name).pass("pass", value.pass as usize).in_language(language)
}

fn tiles(weld: &WeldRecord, figures: &Figures, alarms: usize, language: Language) -> Vec<Tile> {
    let number = |value: f64| significant(value, 3, language);
    let arc_on = significant(figures.arc_on_s, 4, language);
    let mut tiles = vec![tile(language, "report-tile-arc-on", Unit::S, arc_on, String::new())];
    if let Some([least, mean, greatest]) = weld.heat_input_kj_mm {
        let note = Message::new("report-tile-mean").significant("from", least, Unit::One, 3);
        let note = note.significant("to", greatest, Unit::One, 3).in_language(language);
        tiles.push(tile(language, "value-heat-input", Unit::KiloJPerMm, number(mean), note));
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        let note = Message::new("report-tile-max-at").significant("s", at, Unit::Mm, 5).in_language(language);
        tiles.push(tile(language, "report-tile-deviation", Unit::Mm, number(worst), note));
    }
    let severity = (alarms > 0).then_some(Severity::Warning);
    let alarms = tile(language, "report-heading-alarms", Unit::One, alarms.to_string(), String::new());
    tiles.push(Tile { severity, ..alarms });
    tiles
}

#[cfg(test)]
mod tests;
