//! Which limits bind where, in words and tables.

use super::CertificateFigures;
use super::certificate::IntervalFigures;
use super::page::{number, table};
use super::plan::AxisFigures;
use crate::{Block, format_number};

/// Stretches listed at most; a report is read, and report.json has all of them.
const LISTED: usize = 24;

/// What the pass reaches, in one paragraph.
pub(super) fn speed_text(c: &CertificateFigures) -> String {
    let (low, high) = c.asked_speed_mm_s;
    let asked = if high > low { format!("{} to {}", number(low), number(high)) } else { number(low) };
    let (least, greatest) = (number(c.least_speed_mm_s), number(c.greatest_speed_mm_s));
    let reached = if least == greatest { least } else { format!("{least} to {greatest}") };
    format!(
        "Asked: {asked} mm/s. Reached between run-up and run-down: {reached} mm/s. As fast as asked over {} % of the length.",
        percent(c.at_asked_percent)
    )
}

/// What bounds the speed, stretch by stretch.
pub(super) fn bounds_table(c: &CertificateFigures) -> Block {
    let last = c.intervals.len();
    let rows = c.intervals.iter().take(LISTED).enumerate().map(|(i, interval)| {
        let part = match interval.between {
            true => "weld",
            false if i + 1 == last || interval.from_mm >= c.run_down_start_mm => "run-down",
            false => "run-up",
        };
        let (from, to) = (number(interval.from_mm), number(interval.to_mm));
        let (least, greatest) = (number(interval.least_speed_mm_s), number(interval.greatest_speed_mm_s));
        vec![from, to, part.to_owned(), least, greatest, what_binds(interval)]
    });
    let caption = match last.saturating_sub(LISTED) {
        0 => "What bounds the speed (mm, mm/s)".to_owned(),
        more => format!("What bounds the speed (mm, mm/s): the first {LISTED} stretches, {more} more in report.json"),
    };
    let head = ["From", "To", "Part", "Least speed", "Greatest speed", "What binds"];
    let mut block = table(&caption, &head, rows.collect(), 0..5);
    if let Block::Table(table) = &mut block {
        table.numeric[2] = false;
    }
    block
}

fn what_binds(interval: &IntervalFigures) -> String {
    match (interval.whose(), interval.limit, &interval.unit) {
        (Some(whose), Some(limit), Some(unit)) => {
            format!(
                "the {} of {whose}, {} {}",
                interval.bound,
                number(limit),
                unit.replace("^2", "²").replace("^3", "³")
            )
        }
        _ => "nothing: it is as fast as asked".to_owned(),
    }
}

/// The greatest use of each axis' limits.
pub(super) fn uses_table(c: &CertificateFigures) -> Block {
    let rows = c.uses.iter().map(|u| {
        let limit = |value: f64, per: &str| format!("{} {}/s{per}", number(value), u.unit);
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
    table("Greatest use of each axis' limits", &head, rows.collect(), 1..7)
}

/// Where each axis goes.
pub(super) fn axes_table(axes: &[AxisFigures]) -> Block {
    let rows = axes.iter().map(|a| {
        let range = a.range.map_or("continuous".to_owned(), |(l, h)| format!("{} to {}", number(l), number(h)));
        vec![a.axis.clone(), a.unit.to_owned(), number(a.min), number(a.max), range]
    });
    let head = ["Axis", "Unit", "Least", "Greatest", "Range"];
    table("Positions of the axes against their ranges", &head, rows.collect(), 2..5)
}

/// Parts of a limit; 0 where there is nothing but rounding.
fn percent(value: f64) -> String {
    if value < 1e-4 { "0".to_owned() } else { format_number(value, 3) }
}
