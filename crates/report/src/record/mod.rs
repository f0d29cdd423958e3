//! The report of a recorded weld: what was welded, against its procedure, to be signed.

mod charts;
mod tables;

use crate::weld::table;
use crate::{Block, Page, Severity, Tile, Verdict, format_number};
use seamwright_record::figures::Figures;
use seamwright_record::library::{WeldDetail, WeldRecord, WeldResult};

/// The report as one self-contained HTML page; `program` is the text that was welded, `date` when the page is made.
pub fn recorded_weld_page(detail: &WeldDetail, figures: &Figures, program: &str, date: &str) -> String {
    let weld = &detail.weld;
    let mut blocks = vec![Block::Tiles(tiles(weld, figures, detail.alarms.len()))];
    let mut section = |heading: &str, content: Vec<Block>| {
        blocks.push(Block::Heading(heading.to_owned()));
        blocks.extend(content);
    };
    section("Procedure against actual values", vec![tables::values(&detail.values)]);
    section("Heat input", vec![charts::heat_input(figures, &detail.values)]);
    section("Deviations", charts::deviations(figures));
    section("Alarms", vec![tables::alarms(&detail.alarms)]);
    if !detail.events.is_empty() {
        section("Events", vec![tables::events(&detail.events)]);
    }
    section("Record", vec![tables::made_from(weld), tables::files(&detail.files)]);
    section("Program", vec![Block::Code { caption: weld.program.0.clone(), text: program.to_owned() }]);
    let empty = |who: &str| vec![who.to_owned(), String::new(), String::new(), String::new()];
    let mut signed = vec![empty("Welder"), empty("Inspector")];
    signed[0][1] = weld.welder.clone().unwrap_or_default();
    section("Signatures", vec![table("To be filled in by hand", &["", "Name", "Date", "Signature"], signed, 4..4)]);
    let text = |value: &Option<(String, i64)>| value.as_ref().map_or("none".to_owned(), |(name, _)| name.clone());
    Page {
        title: weld.title.clone(),
        subtitle: format!(
            "Weld record {}{}",
            weld.id,
            if weld.simulated { ", simulated: no metal was welded" } else { "" }
        ),
        meta: vec![
            ("Part".to_owned(), weld.part.clone()),
            ("Welder".to_owned(), weld.welder.clone().unwrap_or_default()),
            ("Machine".to_owned(), weld.machine.0.clone()),
            ("Procedure".to_owned(), text(&weld.procedure)),
            ("Begun".to_owned(), weld.begun.to_string()),
            ("Ended".to_owned(), weld.ended.map_or("not yet".to_owned(), |at| at.to_string())),
            ("Page made".to_owned(), date.to_owned()),
            ("Made by".to_owned(), format!("Seamwright {}", env!("CARGO_PKG_VERSION"))),
        ],
        verdict: Some(verdict(detail)),
        blocks,
    }
    .render()
}

fn verdict(detail: &WeldDetail) -> Verdict {
    let outside = detail.values.iter().filter(|v| v.outside_s > 0.0).count();
    let said = match detail.weld.result {
        WeldResult::Good => "Welded to its end, within its tolerance.",
        WeldResult::Deviating => "Welded to its end, beyond its tolerance.",
        WeldResult::Stopped => "Stopped before its end.",
        WeldResult::Interrupted => "Interrupted: the program or the power failed.",
        WeldResult::Running => "Not ended: it runs, or a crash left it so.",
    };
    let windows = match (outside, detail.weld.procedure.is_some()) {
        (_, false) => " There is no procedure to hold it against.".to_owned(),
        (0, _) => " All values within the procedure's windows.".to_owned(),
        (1, _) => " One value left its window.".to_owned(),
        (n, _) => format!(" {n} values left their windows."),
    };
    let note = if detail.weld.note.is_empty() { String::new() } else { format!(" Note: {}.", detail.weld.note) };
    let ok = detail.weld.result == WeldResult::Good && outside == 0 && detail.weld.note.is_empty();
    Verdict { ok, text: format!("{said}{windows}{note}") }
}

fn tiles(weld: &WeldRecord, figures: &Figures, alarms: usize) -> Vec<Tile> {
    let tile = |label: &str, value: String, unit: &str, note: String| Tile {
        label: label.to_owned(),
        value,
        unit: unit.to_owned(),
        note,
        ..Tile::default()
    };
    let number = |value: f64| format_number(value, 3);
    let mut tiles = vec![tile("Arc-on time", format_number(figures.arc_on_s, 4), "s", String::new())];
    if let Some([least, mean, greatest]) = weld.heat_input_kj_mm {
        let note = format!("mean; {} to {}", number(least), number(greatest));
        tiles.push(tile("Heat input", number(mean), "kJ/mm", note));
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        tiles.push(tile("Deviation", number(worst), "mm", format!("greatest, at s = {} mm", format_number(at, 5))));
    }
    let severity = (alarms > 0).then_some(Severity::Warning);
    tiles.push(Tile { severity, ..tile("Alarms", alarms.to_string(), "", String::new()) });
    tiles
}

#[cfg(test)]
mod tests;
