//! Binding limits along the path, in words and tables.

use super::CertificateFigures;
use super::certificate::{IntervalFigures, TIP, UseFigures};
use super::page::{number, table};
use super::plan::AxisFigures;
use crate::Phrases as _;
use crate::{Block, Language, format_number};

/// Maximum number of listed stretches, for a readable report; report.json has all of them.
const LISTED: usize = 24;

/// Describes requested and planned speed of the pass in one paragraph.
pub(super) fn speed_text(c: &CertificateFigures, language: Language) -> String {
    let (low, high) = c.asked_speed_mm_s;
    let range = |least: &str, greatest: &str| language.fill("{0} to {1}", &[least, greatest]);
    let asked = if high > low { range(&number(low), &number(high)) } else { number(low) };
    let (least, greatest) = (number(c.least_speed_mm_s), number(c.greatest_speed_mm_s));
    let reached = if least == greatest { least } else { range(&least, &greatest) };
    language.fill(
        "Asked: {0} mm/s. Reached between run-up and run-down: {1} mm/s. As fast as asked over {2} % of the length.",
        &[&asked, &reached, &percent(c.at_asked_percent)],
    )
}

/// Returns the bounds of the speed, stretch by stretch.
pub(super) fn bounds_table(c: &CertificateFigures, language: Language) -> Block {
    let last = c.intervals.len();
    let rows = c.intervals.iter().take(LISTED).enumerate().map(|(i, interval)| {
        let part = match interval.between {
            true => "weld",
            false if i + 1 == last || interval.from_mm >= c.run_down_start_mm => "run-down",
            false => "run-up",
        };
        let (from, to) = (number(interval.from_mm), number(interval.to_mm));
        let (least, greatest) = (number(interval.least_speed_mm_s), number(interval.greatest_speed_mm_s));
        vec![from, to, language.say(part).to_owned(), least, greatest, what_binds(interval, language)]
    });
    let caption = match last.saturating_sub(LISTED) {
        0 => language.say("What bounds the speed (mm, mm/s)").to_owned(),
        more => language.fill(
            "What bounds the speed (mm, mm/s): the first {0} stretches, {1} more in report.json",
            &[&LISTED.to_string(), &more.to_string()],
        ),
    };
    let head = ["From", "To", "Part", "Least speed", "Greatest speed", "What binds"];
    let mut block = table(&caption, &head.map(|head| language.say(head)), rows.collect(), 0..5);
    if let Block::Table(table) = &mut block {
        table.numeric[2] = false;
    }
    block
}

fn what_binds(interval: &IntervalFigures, language: Language) -> String {
    match (&interval.axis, interval.limit, &interval.unit) {
        (Some(axis), Some(limit), Some(unit)) => {
            let unit = unit.replace("^2", "²").replace("^3", "³");
            let of = [language.say(interval.bound), &whose(axis, language), &number(limit), language.unit(&unit)];
            language.fill("the {0} of {1}, {2} {3}", &of)
        }
        _ => language.say("nothing: it is as fast as asked").to_owned(),
    }
}

/// Returns the name of the binding axis, or of the torch tip.
fn whose(axis: &str, language: Language) -> String {
    if axis == TIP { language.say("the torch tip").to_owned() } else { language.fill("axis {0}", &[axis]) }
}

/// Names the bound in short form: `axis c, jerk`.
pub(super) fn binds(interval: &IntervalFigures, language: Language) -> String {
    match &interval.axis {
        Some(axis) => format!("{}, {}", whose(axis, language), language.say(interval.bound)),
        None => language.say("asked speed").to_owned(),
    }
}

/// Returns the maximum use of each axis' limits.
pub(super) fn uses_table(uses: &[UseFigures], language: Language) -> Block {
    let rows = uses.iter().map(|u| {
        let limit =
            |value: f64, per: &str| format!("{} {}", number(value), language.unit(&format!("{}/s{per}", u.unit)));
        vec![
            u.axis.clone(),
            percent(u.speed_percent),
            limit(u.max_speed, ""),
            percent(u.acceleration_percent),
            limit(u.max_acceleration, "²"),
            percent(u.jerk_percent),
            limit(u.max_jerk, "³"),
        ]
    });
    let head = ["Axis", "Speed, %", "of", "Acceleration, %", "of", "Jerk, %", "of"];
    let head = head.map(|head| language.say(head));
    table(language.say("Greatest use of each axis' limits"), &head, rows.collect(), 1..7)
}

/// Returns the positions of each axis against its range.
pub(super) fn axes_table(axes: &[AxisFigures], language: Language) -> Block {
    let rows = axes.iter().map(|a| {
        let range = match a.range {
            Some((least, greatest)) => language.fill("{0} to {1}", &[&number(least), &number(greatest)]),
            None => language.say("continuous").to_owned(),
        };
        vec![a.axis.clone(), language.unit(a.unit).to_owned(), number(a.min), number(a.max), range]
    });
    let head = ["Axis", "Unit", "least", "greatest", "Range"].map(|head| language.say(head));
    table(language.say("Positions of the axes against their ranges"), &head, rows.collect(), 2..5)
}

/// Formats a percentage of a limit; rounding noise becomes 0.
fn percent(value: f64) -> String {
    if value < 1e-4 { "0".to_owned() } else { format_number(value, 3) }
}
