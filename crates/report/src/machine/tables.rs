//! The tables of a check.

use crate::number::{NONE, Significant as _, fixed, from_to, number, quantity, range, small};
use crate::{Block, Language, Table, Words as _};
use seamwright_machine::check::{AxisFigures, Check, HeadCheck, RoundTrip, SingularPlace};
use seamwright_message::{Message, Unit};

pub(super) fn unit(check: &Check, name: &str) -> Unit {
    let axis = check.axes.iter().find(|a| a.name == name);
    axis.and_then(|a| Unit::from_symbol(a.unit)).unwrap_or(Unit::One)
}

pub(super) fn axes(check: &Check, language: Language) -> Block {
    let number = |value| number(value, language);
    let limits = |a: &AxisFigures| match a.range {
        Some(ends) => range("report-range", ends, unit(check, &a.name)).in_language(language),
        None => language.words("report-check-no-end-stops"),
    };
    let kind = |a: &AxisFigures| if a.kind == "linear" { "report-check-linear" } else { "report-check-rotary" };
    let moves = |a: &AxisFigures| if a.moves == "torch" { "report-check-torch" } else { "report-check-work" };
    Table::of(language, &check.axes)
        .text("report-column-axis", |a| a.name.clone())
        .text("report-check-column-letter", |a| a.letter.map_or(NONE.to_owned(), String::from))
        .text("report-check-column-kind", |a| language.words(kind(a)))
        .text("report-check-column-moves", |a| language.words(moves(a)))
        .text("report-column-range", |a| limits(a))
        .number("report-check-column-home", |a| number(a.home))
        .number("report-check-column-speed", |a| number(a.max_speed))
        .number("report-check-column-acceleration", |a| number(a.max_acceleration))
        .number("report-check-column-jerk", |a| a.max_jerk.map_or(NONE.to_owned(), number))
        .number("report-check-column-time", |a| number(a.to_speed_s))
        .captioned("report-check-caption-axes")
}

pub(super) fn results(check: &Check, language: Language) -> Block {
    let small = |value| small(value, language);
    let unsolved = |r: &RoundTrip| match r.off_centre {
        0 => r.unsolved.to_string(),
        n => Message::new("report-check-off-centre")
            .count("unsolved", (r.unsolved - n) as usize)
            .count("n", n as usize)
            .in_language(language),
    };
    let heads = check.heads.iter().map(|h| (h.name.clone(), &h.round_trip));
    let pair = check.pair.iter().map(|r| (language.words("report-check-both-heads"), r));
    Table::of(language, heads.chain(pair))
        .text("report-column-head", |(name, _)| name.clone())
        .text("report-check-column-result", |(_, r)| result(r.passed, language))
        .number("report-check-column-poses", |(_, r)| r.poses.to_string())
        .number("report-column-tip-mm", |(_, r)| small(r.point_mm))
        .number("report-check-column-direction", |(_, r)| small(r.direction_deg))
        .number("report-check-column-axes", |(_, r)| small(r.axes_mm_or_deg))
        .number("report-check-column-near-singular", |(_, r)| r.near_singular.to_string())
        .number("report-check-column-unsolved", |(_, r)| unsolved(r))
        .number("report-check-column-branch-missing", |(_, r)| r.branch_missed.to_string())
        .captioned("report-check-caption-results")
}

fn result(passed: bool, language: Language) -> String {
    language.words(if passed { "report-check-result-passed" } else { "report-check-result-failed" })
}

pub(super) fn structure(check: &Check, language: Language) -> Block {
    Table::of(language, &check.heads)
        .text("report-column-head", |h| h.name.clone())
        .text("report-check-column-inverse", |h| h.structure.in_language(language))
        .text("report-check-jacobian", |h| result(h.jacobian.passed, language))
        .number("report-check-column-difference", |h| small(h.jacobian.relative, language))
        .text("report-check-column-worst-axis", |h| h.jacobian.axis.clone())
        .captioned("report-check-caption-structure")
}

/// Describes a singular configuration with its positions.
pub(super) fn place(check: &Check, place: &SingularPlace, language: Language) -> String {
    place.description(|name| unit(check, name)).in_language(language)
}

pub(super) fn singular(check: &Check, of: &HeadCheck, language: Language) -> Block {
    let margin = |p: &SingularPlace| {
        let (by, axis) = p.margin.as_ref()?;
        let unit = p.at.first().map_or(Unit::One, |a| unit(check, &a.0));
        let message = Message::new("report-check-margin").significant("distance", *by, unit, 3);
        Some(message.axis("axis", axis).in_language(language))
    };
    let caption = Message::new("report-check-caption-singular").text("head", &of.name).in_language(language);
    let table = Table::of(language, &of.singular.places)
        .text("report-check-column-configuration", |p| place(check, p, language))
        .text("report-check-column-distance", |p| margin(p).unwrap_or_else(|| NONE.to_owned()));
    Block::Table(table.table(caption))
}

pub(super) fn reach(check: &Check, language: Language) -> Block {
    let boxes = check.heads.iter().flat_map(|h| {
        let boxes =
            [("report-check-tip-in-work", h.reach.work_box_mm), ("report-check-tip-in-base", h.reach.base_box_mm)];
        boxes.map(|(what, ends)| (&h.name, what, ends))
    });
    let mut table = Table::of(language, boxes)
        .text("report-column-head", |(name, ..)| (*name).clone())
        .text("report-check-column-box", |(_, what, _)| language.words(what));
    for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
        table = table.column(axis.to_owned(), true, |(.., [low, high])| {
            from_to(fixed(low[i], 1, language), fixed(high[i], 1, language), language)
        });
    }
    table.captioned("report-check-caption-reach")
}

/// Returns the measure of a head's reach with its standard deviation.
pub(super) fn measure(head: &HeadCheck) -> Message {
    let v = &head.reach.volume;
    if v.part_of_box <= 0.0 {
        return Message::new("report-check-no-volume");
    }
    // Metres are easier to grasp than mm.
    let (value, deviation, unit) = match v.dimensions {
        3 => (v.measure * 1e-9, v.deviation * 1e-9, Unit::M3),
        2 => (v.measure * 1e-6, v.deviation * 1e-6, Unit::M2),
        1 => (v.measure * 1e-3, v.deviation * 1e-3, Unit::M),
        _ => return Message::new("report-check-point"),
    };
    match deviation > 0.0 {
        true => {
            let size = Message::new("report-check-size").significant("value", value, Unit::One, 4);
            size.significant("deviation", deviation, unit, 1)
        }
        false => quantity(value, unit, 4),
    }
}
