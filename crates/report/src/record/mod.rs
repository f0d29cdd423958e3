//! Report of a recorded weld against its procedure, to be signed.

mod charts;
mod tables;

use crate::Phrases as _;
use crate::said;
use crate::weld::table;
use crate::{Block, Language, Page, Severity, Tile, Verdict, format_number};
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
        blocks.push(Block::Heading(language.say(heading).to_owned()));
        blocks.extend(content);
    };
    section("Procedure against actual values", vec![tables::values(&detail.values, language)]);
    section("value.heat_input", vec![charts::heat_input(figures, &detail.values, language)]);
    section("Deviations", charts::deviations(figures, language));
    section("bottom.alarms", vec![tables::alarms(&detail.alarms, language)]);
    if !detail.events.is_empty() {
        section("bottom.events", vec![tables::events(&detail.events, language)]);
    }
    section("Record", vec![tables::made_from(weld, language), tables::files(&detail.files, language)]);
    section("program", vec![Block::Code { caption: weld.program.0.clone(), text: program.to_owned() }]);
    section("Signatures", vec![signatures(weld, language)]);
    let procedure = weld.procedure.as_ref().map_or(language.say("none"), |(name, _)| name);
    let subtitle = if weld.simulated { "Weld record {0}, simulated: no metal was welded" } else { "Weld record {0}" };
    let meta = [
        ("record.part", weld.part.clone()),
        ("record.welder", weld.welder.clone().unwrap_or_default()),
        ("record.machine", weld.machine.0.clone()),
        ("record.procedure", procedure.to_owned()),
        ("record.begun", weld.begun.to_string()),
        ("Ended", weld.ended.map_or(language.say("not yet").to_owned(), |at| at.to_string())),
        ("Page made", date.to_owned()),
        ("Made by", format!("Seamwright {}", env!("CARGO_PKG_VERSION"))),
    ];
    Page {
        language,
        title: weld.title.clone(),
        subtitle: language.fill(subtitle, &[&weld.id.to_string()]),
        meta: meta.map(|(name, value)| (language.say(name).to_owned(), value)).into(),
        verdict: Some(verdict(detail, figures, language)),
        blocks,
    }
    .render()
}

fn signatures(weld: &WeldRecord, language: Language) -> Block {
    let row = |who, name| vec![language.say(who).to_owned(), name, String::new(), String::new()];
    let rows = vec![row("record.welder", weld.welder.clone().unwrap_or_default()), row("Inspector", String::new())];
    let head = ["", "Name", "Date", "Signature"].map(|head| language.say(head));
    table(language.say("To be filled in by hand"), &head, rows, 4..4)
}

fn verdict(detail: &WeldDetail, figures: &Figures, language: Language) -> Verdict {
    let outside: Vec<String> =
        detail.values.iter().filter(|v| v.outside_s > 0.0).map(|v| outside(v, figures, language)).collect();
    let said = match detail.weld.result {
        WeldResult::Good => "Welded to its end, within its tolerance.",
        WeldResult::Deviating => "Welded to its end, but not all of it as asked.",
        WeldResult::Stopped => "Stopped before its end.",
        WeldResult::Interrupted => "Interrupted: the program or the power failed.",
        WeldResult::Running => "Not ended: it runs, or a crash left it so.",
    };
    let windows = match (outside.as_slice(), detail.weld.procedure.is_some()) {
        (_, false) => language.say("There is no procedure to hold it against.").to_owned(),
        ([], _) => language.say("All values within the procedure's windows.").to_owned(),
        (list, _) => language.fill("Outside the procedure's windows: {0}.", &[&list.join("; ")]),
    };
    let note = match &detail.weld.note {
        note if note.is_empty() => String::new(),
        note => language.fill("Note: {0}.", &[&said::recorded(language, note, said::note)]),
    };
    let ok = detail.weld.result == WeldResult::Good && outside.is_empty() && detail.weld.note.is_empty();
    Verdict { ok, text: [language.say(said), &windows, &note].join(language.between_sentences()).trim_end().to_owned() }
}

/// Formats a value outside its window and the location, preferably from the trace, which is more detailed than the
/// library.
fn outside(value: &Value, figures: &Figures, language: Language) -> String {
    let name = said::value(language, &value.name);
    let known = figures.values.iter().find(|v| (v.pass, &v.name) == (value.pass, &value.name));
    match known.unwrap_or(value).outside_along {
        Some((from, to)) => {
            let [from, to] = [from, to].map(|mm| format_number(mm, 5));
            language.fill("{0} in pass {1}, s = {2} to {3} mm", &[&name, &value.pass.to_string(), &from, &to])
        }
        None => language.fill("{0} in pass {1}", &[&name, &value.pass.to_string()]),
    }
}

fn tiles(weld: &WeldRecord, figures: &Figures, alarms: usize, language: Language) -> Vec<Tile> {
    let tile = |label, value: String, unit, note: String| Tile {
        label: language.say(label).to_owned(),
        value,
        unit: language.say(unit).to_owned(),
        note,
        ..Tile::default()
    };
    let number = |value: f64| format_number(value, 3);
    let mut tiles = vec![tile("Arc-on time", format_number(figures.arc_on_s, 4), "s", String::new())];
    if let Some([least, mean, greatest]) = weld.heat_input_kj_mm {
        let note = language.fill("mean; {0} to {1}", &[&number(least), &number(greatest)]);
        tiles.push(tile("value.heat_input", number(mean), "kJ/mm", note));
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        let note = language.fill("greatest, at s = {0} mm", &[&format_number(at, 5)]);
        tiles.push(tile("Deviation", number(worst), "mm", note));
    }
    let severity = (alarms > 0).then_some(Severity::Warning);
    tiles.push(Tile { severity, ..tile("bottom.alarms", alarms.to_string(), "", String::new()) });
    tiles
}

#[cfg(test)]
mod tests;
