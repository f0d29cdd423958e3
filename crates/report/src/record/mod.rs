//! Report of a recorded weld against its procedure, to be signed.

mod charts;
mod tables;

use crate::block::{Block, Severity, Tile};
use crate::names;
use crate::number::{Significant as _, significant};
use crate::page::{Page, Verdict};
use crate::weld::table;
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
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
    let mut blocks = vec![Block::Tiles(tiles(weld, figures, detail.alarms.len(), language))];
    let mut section = |heading, content: Vec<Block>| {
        blocks.push(Block::Heading(language.words(heading)));
        blocks.extend(content);
    };
    section("report-heading-values", vec![tables::values(&detail.values, language)]);
    section("value-heat-input", vec![charts::heat_input(figures, &detail.values, language)]);
    section("report-heading-deviations", charts::deviations(figures, language));
    section("report-heading-alarms", vec![tables::alarms(&detail.alarms, language)]);
    if !detail.events.is_empty() {
        section("report-heading-events", vec![tables::events(&detail.events, language)]);
    }
    section("report-heading-record", vec![tables::made_from(weld, language), tables::files(&detail.files, language)]);
    section("report-heading-program", vec![Block::Code { caption: weld.program.0.clone(), text: program.to_owned() }]);
    section("report-heading-signatures", vec![signatures(weld, language)]);
    let procedure = weld.procedure.as_ref().map_or_else(|| language.words("report-none"), |(name, _)| name.clone());
    let subtitle = if weld.simulated { "report-subtitle-record-simulated" } else { "report-subtitle-record" };
    let meta = [
        ("report-meta-part", weld.part.clone()),
        ("report-meta-welder", weld.welder.clone().unwrap_or_default()),
        ("report-meta-machine", weld.machine.0.clone()),
        ("report-meta-procedure", procedure),
        ("report-meta-started", weld.begun.to_string()),
        ("report-meta-ended", weld.ended.map_or_else(|| language.words("report-not-yet"), |at| at.to_string())),
        ("report-meta-page-made", date.to_owned()),
        ("report-meta-made-by", format!("Seamwright {}", env!("CARGO_PKG_VERSION"))),
    ];
    Page {
        language,
        title: weld.title.clone(),
        subtitle: Message::new(subtitle).text("id", weld.id.to_string()).in_language(language),
        meta: meta.map(|(name, value)| (language.words(name), value)).into(),
        verdict: Some(verdict(detail, figures, language)),
        blocks,
    }
    .render()
}

fn signatures(weld: &WeldRecord, language: Language) -> Block {
    let row = |who, name| vec![language.words(who), name, String::new(), String::new()];
    let rows = vec![
        row("report-meta-welder", weld.welder.clone().unwrap_or_default()),
        row("report-inspector", String::new()),
    ];
    let head =
        ["", "report-column-name", "report-column-date", "report-column-signature"].map(|head| language.words(head));
    table(&language.words("report-caption-by-hand"), &head, rows, 4..4)
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
    let name = names::value(language, &value.name);
    let known = figures.values.iter().find(|v| (v.pass, &v.name) == (value.pass, &value.name));
    let message = match known.unwrap_or(value).outside_along {
        Some((from, to)) => Message::new("report-value-outside-at")
            .text("value", name)
            .pass("pass", value.pass as usize)
            .significant("from", from, Unit::One, 5)
            .significant("to", to, Unit::Mm, 5),
        None => Message::new("report-value-outside").text("value", name).pass("pass", value.pass as usize),
    };
    message.in_language(language)
}

fn tiles(weld: &WeldRecord, figures: &Figures, alarms: usize, language: Language) -> Vec<Tile> {
    let tile = |label, value: String, unit, note: String| Tile {
        label: language.words(label),
        value,
        unit: language.symbol(unit),
        note,
        ..Tile::default()
    };
    let number = |value: f64| significant(value, 3, language);
    let mut tiles =
        vec![tile("report-tile-arc-on", significant(figures.arc_on_s, 4, language), Unit::S, String::new())];
    if let Some([least, mean, greatest]) = weld.heat_input_kj_mm {
        let note = Message::new("report-tile-mean")
            .significant("from", least, Unit::One, 3)
            .significant("to", greatest, Unit::One, 3)
            .in_language(language);
        tiles.push(tile("value-heat-input", number(mean), Unit::KiloJPerMm, note));
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        let note = Message::new("report-tile-max-at").significant("s", at, Unit::Mm, 5).in_language(language);
        tiles.push(tile("report-tile-deviation", number(worst), Unit::Mm, note));
    }
    let severity = (alarms > 0).then_some(Severity::Warning);
    tiles.push(Tile { severity, ..tile("report-heading-alarms", alarms.to_string(), Unit::One, String::new()) });
    tiles
}

#[cfg(test)]
mod tests;
