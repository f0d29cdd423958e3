//! The tables of a check.

use crate::{Table, format_number};
use seamwright_machine::check::{AxisFigures, Check, HeadCheck, RoundTrip, SingularPlace};

pub(super) fn number(value: f64) -> String {
    format_number(value, 5)
}

/// Formats a measured error to two digits.
pub(super) fn small(value: f64) -> String {
    format_number(value, 2)
}

/// Returns the unit of the axis called `name`.
pub(super) fn unit(check: &Check, name: &str) -> &'static str {
    check.axes.iter().find(|a| a.name == name).map_or("", |a| a.unit)
}

pub(super) fn axes(check: &Check) -> Table {
    let row = |a: &AxisFigures| {
        let range =
            a.range.map_or("no end stops".to_owned(), |(l, h)| format!("{} to {} {}", number(l), number(h), a.unit));
        vec![
            a.name.clone(),
            a.letter.map_or("–".to_owned(), String::from),
            a.kind.to_owned(),
            a.moves.to_owned(),
            range,
            number(a.home),
            number(a.max_speed),
            number(a.max_acceleration),
            a.max_jerk.map_or("–".to_owned(), number),
            number(a.to_speed_s),
        ]
    };
    let head = [
        "Axis",
        "Letter",
        "Kind",
        "Moves",
        "Range",
        "Home",
        "Speed, /s",
        "Acceleration, /s²",
        "Jerk, /s³",
        "To speed, s",
    ];
    Table {
        caption: "Axes; linear ones in mm, rotary ones in degrees. The last column is the time from rest to the highest speed.".to_owned(),
        head: head.map(str::to_owned).into(),
        rows: check.axes.iter().map(row).collect(),
        numeric: vec![false, false, false, false, false, true, true, true, true, true],
    }
}

pub(super) fn results(check: &Check) -> Table {
    let round = |name: &str, r: &RoundTrip| {
        vec![
            name.to_owned(),
            word(r.passed),
            r.poses.to_string(),
            small(r.point_mm),
            small(r.direction_deg),
            small(r.axes_mm_or_deg),
            r.near_singular.to_string(),
            match r.off_centre {
                0 => r.unsolved.to_string(),
                n => format!("{} (and {n} with slides off centre)", r.unsolved - n),
            },
            r.branch_missed.to_string(),
        ]
    };
    let mut rows: Vec<_> = check.heads.iter().map(|h| round(&h.name, &h.round_trip)).collect();
    rows.extend(check.pair.iter().map(|r| round("both at once", r)));
    let head = [
        "Head",
        "Result",
        "Poses",
        "Tip, mm",
        "Direction, deg",
        "Axes, mm or deg",
        "Near singular",
        "Unsolved",
        "Own branch missing",
    ];
    Table {
        caption: "Round trip: random positions, their pose, all positions for that pose, and again the pose. Worst differences; axes away from singular poses.".to_owned(),
        head: head.map(str::to_owned).into(),
        rows,
        numeric: vec![false, false, true, true, true, true, true, true, true],
    }
}

fn word(passed: bool) -> String {
    if passed { "passed" } else { "failed" }.to_owned()
}

pub(super) fn structure(check: &Check) -> Table {
    let row = |h: &HeadCheck| {
        let j = &h.jacobian;
        vec![h.name.clone(), h.structure.to_string(), word(j.passed), small(j.relative), j.axis.clone()]
    };
    Table {
        caption: "How positions are found for a pose, and the Jacobian beside central differences: the worst difference as a part of its column.".to_owned(),
        head: ["Head", "Inverse", "Jacobian", "Difference", "Worst axis"].map(str::to_owned).into(),
        rows: check.heads.iter().map(row).collect(),
        numeric: vec![false, false, false, true, false],
    }
}

pub(super) fn singular(check: &Check, head: &HeadCheck) -> Table {
    let row = |p: &SingularPlace| {
        let margin = p.margin.as_ref().map_or_else(
            || "–".to_owned(),
            |(by, axis)| {
                let unit = p.at.first().map_or("", |a| unit(check, &a.0));
                format!("{} {unit} ({axis} too slow nearer by)", format_number(*by, 3))
            },
        );
        vec![p.sentence(|name| unit(check, name)).to_string(), margin]
    };
    Table {
        caption: format!(
            "Singular places of head {} inside the ranges, and the distance that a typical weld needs from them.",
            head.name
        ),
        head: ["Where", "Distance needed"].map(str::to_owned).into(),
        rows: head.singular.places.iter().map(row).collect(),
        numeric: vec![],
    }
}

pub(super) fn reach(check: &Check) -> Table {
    let mut rows = Vec::new();
    for h in &check.heads {
        let r = &h.reach;
        for (what, [low, high]) in [("tip in the work frame", r.work_box_mm), ("tip in the base frame", r.base_box_mm)]
        {
            let side = |i: usize| format!("{:.1} to {:.1}", low[i] + 0.0, high[i] + 0.0);
            rows.push(vec![h.name.clone(), what.to_owned(), side(0), side(1), side(2)]);
        }
    }
    Table {
        caption: "Box around everything that a tip can reach, mm.".to_owned(),
        head: ["Head", "Box of the", "x", "y", "z"].map(str::to_owned).into(),
        rows,
        numeric: vec![false, false, true, true, true],
    }
}

/// Formats the measure of a head's reach with its standard deviation.
pub(super) fn measure(head: &HeadCheck) -> String {
    let v = &head.reach.volume;
    if v.part_of_box <= 0.0 {
        return "no volume: the tip stays on a surface or a line".to_owned();
    }
    // Metres are easier to grasp than mm.
    let (value, deviation, unit) = match v.dimensions {
        3 => (v.measure * 1e-9, v.deviation * 1e-9, "m³"),
        2 => (v.measure * 1e-6, v.deviation * 1e-6, "m²"),
        1 => (v.measure * 1e-3, v.deviation * 1e-3, "m"),
        _ => return "a point".to_owned(),
    };
    match deviation > 0.0 {
        true => format!("{} ± {} {unit}", format_number(value, 4), format_number(deviation, 1)),
        false => format!("{} {unit}", format_number(value, 4)),
    }
}
