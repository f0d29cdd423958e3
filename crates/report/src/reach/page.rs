use super::figures::{PlacementRow, ReachFigures, kind_words};
use super::map::ReachMap;
use crate::block::{figure, paragraph, sections, tile};
use crate::number::significant;
use crate::{Block, Language, Page, Table, Tile, Verdict, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_motion::reach::Moved;
use std::collections::BTreeMap;

/// Number of rows of the table of the best placements.
const BEST: usize = 10;

/// Renders a search for placements as one self-contained HTML page in this language; `file` is the job's name, `date` that
/// of the page.
pub fn reach_page(figures: &ReachFigures, map: &ReachMap, file: &str, date: &str, language: Language) -> String {
    let parts = [
        ("report-reach-heading-map", vec![figure(map, "report-reach-caption-map", language)]),
        ("report-reach-heading-best", best_table(figures, language).into_iter().collect()),
        ("report-reach-heading-reasons", reasons_table(figures, language).into_iter().collect()),
        (
            "report-reach-heading-method",
            vec![paragraph(of(figures, ["report-reach-method", "report-reach-method-base"]), language)],
        ),
    ];
    let mut blocks = vec![Block::Tiles(tiles(figures, language))];
    blocks.extend(sections(parts, language));
    Page {
        language,
        title: figures.title.clone(),
        subtitle: language.words(of(figures, ["report-reach-subtitle", "report-reach-subtitle-base"])),
        meta: language.named_values([
            ("report-meta-machine", figures.machine.clone()),
            ("report-column-file", file.to_owned()),
            ("report-column-date", date.to_owned()),
        ]),
        verdict: Some(Verdict { ok: figures.best.is_some(), text: verdict(figures).in_language(language) }),
        blocks,
    }
    .render()
}

/// The words for the work or for the base.
fn of(figures: &ReachFigures, [work, base]: [&'static str; 2]) -> &'static str {
    match figures.moved {
        Moved::Work => work,
        Moved::Base => base,
    }
}

fn verdict(figures: &ReachFigures) -> Message {
    match &figures.best {
        Some(best) => Message::new("report-reach-found")
            .quantity("x", best.row.x_mm, Unit::Mm, 1)
            .quantity("y", best.row.y_mm, Unit::Mm, 1)
            .quantity("z", best.row.z_mm, Unit::Mm, 1)
            .quantity("turn", best.row.turn_deg, Unit::Deg, 1),
        None => Message::new("report-reach-none"),
    }
}

fn tiles(figures: &ReachFigures, language: Language) -> Vec<Tile> {
    let percent = |row: &PlacementRow| row.range_margin.map(|v| significant(100.0 * v, 3, language));
    let none = || language.words("report-reach-fails");
    let present = figures.placements.first();
    let best = figures.best.as_ref();
    let axis = |row: Option<&PlacementRow>| row.and_then(|row| row.axis.clone()).unwrap_or_default();
    let margin = |label, row: Option<&PlacementRow>| {
        let value = row.and_then(percent);
        let unit = if value.is_some() { Unit::Percent } else { Unit::One };
        tile(language, label, unit, value.unwrap_or_else(none), axis(row))
    };
    let count = |label, n: usize| tile(language, label, Unit::One, n.to_string(), String::new());
    let mut tiles = vec![
        margin("report-reach-present", present),
        margin("report-reach-best", best.map(|best| &best.row)),
        count("report-reach-judged", figures.placements.len()),
        count("report-reach-weldable", figures.weldable()),
    ];
    if let Some(clearance) = best.and_then(|best| best.clearance_mm) {
        let value = significant(clearance, 3, language);
        tiles.push(tile(language, "report-reach-clearance", Unit::Mm, value, String::new()));
    }
    tiles
}

fn best_table(figures: &ReachFigures, language: Language) -> Option<Block> {
    let mut rows: Vec<&PlacementRow> = figures.placements.iter().filter(|row| row.weldable).collect();
    rows.sort_by(|a, b| b.score.total_cmp(&a.score));
    rows.truncate(BEST);
    let number = |v: f64| significant(v + 0.0, 4, language);
    let percent = |v: Option<f64>| v.map_or_else(String::new, |v| significant(100.0 * v, 3, language));
    let unit = |name: &str, unit| format!("{name}, {}", language.symbol(unit));
    (!rows.is_empty()).then(|| {
        Table::of(language, rows)
            .column(unit("x", Unit::Mm), true, |row| number(row.x_mm))
            .column(unit("y", Unit::Mm), true, |row| number(row.y_mm))
            .column(unit("z", Unit::Mm), true, |row| number(row.z_mm))
            .number("report-reach-column-turn", |row| number(row.turn_deg))
            .number("report-reach-column-margin", |row| percent(row.range_margin))
            .text("report-reach-column-axis", |row| row.axis.clone().unwrap_or_default())
            .number("report-reach-column-singular", |row| percent(row.singular_margin))
            .number("report-reach-column-speed", |row| percent(row.speed_use))
            .captioned("report-reach-caption-best")
    })
}

/// Placements that fail for the same reason.
struct Reason<'a> {
    count: usize,
    /// The placement that is nearest to being weldable.
    nearest: &'a PlacementRow,
}

fn reasons_table(figures: &ReachFigures, language: Language) -> Option<Block> {
    let mut reasons: BTreeMap<(&str, Option<&str>), Reason> = BTreeMap::new();
    for row in figures.placements.iter().filter(|row| !row.weldable) {
        let key = (row.fault.unwrap_or_default(), row.axis.as_deref());
        let reason = reasons.entry(key).or_insert(Reason { count: 0, nearest: row });
        reason.count += 1;
        if row.score > reason.nearest.score {
            reason.nearest = row;
        }
    }
    let mut reasons: Vec<_> = reasons.into_iter().collect();
    reasons.sort_by_key(|(_, reason)| std::cmp::Reverse(reason.count));
    (!reasons.is_empty()).then(|| {
        Table::of(language, reasons)
            .text("report-reach-column-kind", |((kind, _), _)| kind_words(kind).in_language(language))
            .text("report-reach-column-axis", |((_, axis), _)| axis.unwrap_or_default().to_owned())
            .number("report-reach-column-count", |(_, reason)| reason.count.to_string())
            .number("report-reach-column-pass", |(_, r)| r.nearest.pass.map_or_else(String::new, |p| p.to_string()))
            .number("report-reach-column-s", |(_, reason)| {
                reason.nearest.s_mm.map_or_else(String::new, |s| significant(s, 5, language))
            })
            .text("report-reach-column-reason", |(_, reason)| {
                reason.nearest.reason.as_ref().map_or_else(String::new, |message| message.in_language(language))
            })
            .captioned("report-reach-caption-reasons")
    })
}
