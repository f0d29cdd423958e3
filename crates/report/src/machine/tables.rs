//! The tables of a check.

use crate::block::Table;
use crate::number::{Significant as _, fixed, from_to, significant};
use crate::words::Words as _;
use seamwright_machine::check::{AxisFigures, Check, HeadCheck, RoundTrip, SingularPlace};
use seamwright_message::{Language, Message, Unit};

fn number(value: f64, language: Language) -> String {
    significant(value, 5, language)
}

/// Formats a measured error to two digits.
pub(super) fn small(value: f64, language: Language) -> String {
    significant(value, 2, language)
}

/// Returns the unit of the axis called `name`.
pub(super) fn unit(check: &Check, name: &str) -> Unit {
    let axis = check.axes.iter().find(|a| a.name == name);
    axis.and_then(|a| Unit::from_symbol(a.unit)).unwrap_or(Unit::One)
}

fn head<const N: usize>(codes: [&'static str; N], language: Language) -> Vec<String> {
    codes.map(|code| language.words(code)).into()
}

pub(super) fn axes(check: &Check, language: Language) -> Table {
    let number = |value| number(value, language);
    let row = |a: &AxisFigures| {
        let range = a.range.map_or_else(
            || language.words("report-check-no-end-stops"),
            |(low, high)| {
                let range = Message::new("report-range").significant("from", low, Unit::One, 5);
                range.significant("to", high, unit(check, &a.name), 5).in_language(language)
            },
        );
        vec![
            a.name.clone(),
            a.letter.map_or("–".to_owned(), String::from),
            language.words(if a.kind == "linear" { "report-check-linear" } else { "report-check-rotary" }),
            language.words(if a.moves == "torch" { "report-check-torch" } else { "report-check-work" }),
            range,
            number(a.home),
            number(a.max_speed),
            number(a.max_acceleration),
            a.max_jerk.map_or("–".to_owned(), number),
            number(a.to_speed_s),
        ]
    };
    let codes = [
        "report-column-axis",
        "report-check-column-letter",
        "report-check-column-kind",
        "report-check-column-moves",
        "report-column-range",
        "report-check-column-home",
        "report-check-column-speed",
        "report-check-column-acceleration",
        "report-check-column-jerk",
        "report-check-column-time",
    ];
    Table {
        caption: language.words("report-check-caption-axes"),
        head: head(codes, language),
        rows: check.axes.iter().map(row).collect(),
        numeric: vec![false, false, false, false, false, true, true, true, true, true],
    }
}

pub(super) fn results(check: &Check, language: Language) -> Table {
    let round = |name: String, r: &RoundTrip| {
        let unsolved = match r.off_centre {
            0 => r.unsolved.to_string(),
            n => Message::new("report-check-off-centre")
                .count("unsolved", (r.unsolved - n) as usize)
                .count("n", n as usize)
                .in_language(language),
        };
        vec![
            name,
            result(r.passed, language),
            r.poses.to_string(),
            small(r.point_mm, language),
            small(r.direction_deg, language),
            small(r.axes_mm_or_deg, language),
            r.near_singular.to_string(),
            unsolved,
            r.branch_missed.to_string(),
        ]
    };
    let mut rows: Vec<_> = check.heads.iter().map(|h| round(h.name.clone(), &h.round_trip)).collect();
    rows.extend(check.pair.iter().map(|r| round(language.words("report-check-both-heads"), r)));
    let codes = [
        "report-column-head",
        "report-check-column-result",
        "report-check-column-poses",
        "report-column-tip-mm",
        "report-check-column-direction",
        "report-check-column-axes",
        "report-check-column-near-singular",
        "report-check-column-unsolved",
        "report-check-column-branch-missing",
    ];
    Table {
        caption: language.words("report-check-caption-results"),
        head: head(codes, language),
        rows,
        numeric: vec![false, false, true, true, true, true, true, true, true],
    }
}

fn result(passed: bool, language: Language) -> String {
    language.words(if passed { "report-check-result-passed" } else { "report-check-result-failed" })
}

pub(super) fn structure(check: &Check, language: Language) -> Table {
    let row = |h: &HeadCheck| {
        let j = &h.jacobian;
        let structure = h.structure.in_language(language);
        vec![h.name.clone(), structure, result(j.passed, language), small(j.relative, language), j.axis.clone()]
    };
    let codes = [
        "report-column-head",
        "report-check-column-inverse",
        "report-check-jacobian",
        "report-check-column-difference",
        "report-check-column-worst-axis",
    ];
    Table {
        caption: language.words("report-check-caption-structure"),
        head: head(codes, language),
        rows: check.heads.iter().map(row).collect(),
        numeric: vec![false, false, false, true, false],
    }
}

/// Describes a singular configuration with its positions.
pub(super) fn place(check: &Check, place: &SingularPlace, language: Language) -> String {
    place.description(|name| unit(check, name)).in_language(language)
}

pub(super) fn singular(check: &Check, of: &HeadCheck, language: Language) -> Table {
    let row = |p: &SingularPlace| {
        let margin = p.margin.as_ref().map_or_else(
            || "–".to_owned(),
            |(by, axis)| {
                let unit = p.at.first().map_or(Unit::One, |a| unit(check, &a.0));
                Message::new("report-check-margin")
                    .significant("distance", *by, unit, 3)
                    .axis("axis", axis)
                    .in_language(language)
            },
        );
        vec![place(check, p, language), margin]
    };
    Table {
        caption: Message::new("report-check-caption-singular").text("head", &of.name).in_language(language),
        head: head(["report-check-column-configuration", "report-check-column-distance"], language),
        rows: of.singular.places.iter().map(row).collect(),
        numeric: vec![],
    }
}

pub(super) fn reach(check: &Check, language: Language) -> Table {
    let mut rows = Vec::new();
    for h in &check.heads {
        let r = &h.reach;
        for (what, [low, high]) in
            [("report-check-tip-in-work", r.work_box_mm), ("report-check-tip-in-base", r.base_box_mm)]
        {
            let side = |i: usize| from_to(fixed(low[i], 1, language), fixed(high[i], 1, language), language);
            rows.push(vec![h.name.clone(), language.words(what), side(0), side(1), side(2)]);
        }
    }
    let mut head = head(["report-column-head", "report-check-column-box"], language);
    head.extend(["x", "y", "z"].map(str::to_owned));
    Table {
        caption: language.words("report-check-caption-reach"),
        head,
        rows,
        numeric: vec![false, false, true, true, true],
    }
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
        true => Message::new("report-check-size").significant("value", value, Unit::One, 4).significant(
            "deviation",
            deviation,
            unit,
            1,
        ),
        false => Message::new("quantity").significant("value", value, unit, 4),
    }
}
