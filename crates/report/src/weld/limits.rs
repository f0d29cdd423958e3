//! Binding limits along the path, in words and tables.

use super::CertificateFigures;
use super::axis_units::units;
use super::certificate::{IntervalFigures, TIP, UseFigures};
use super::plan::AxisFigures;
use crate::number::{Significant as _, from_to, number, quantity, range, significant};
use crate::{Block, Language, Table, Words as _, format_number};
use seamwright_message::{Message, Unit};

/// Maximum number of listed stretches, for a readable report; report.json has all of them.
const LISTED: usize = 24;

/// Describes requested and planned speed of the pass in one paragraph.
pub(super) fn speed_text(c: &CertificateFigures, language: Language) -> String {
    Message::new("report-speed-reached")
        .message("requested", speeds(c.asked_speed_mm_s))
        .message("reached", speeds((c.least_speed_mm_s, c.greatest_speed_mm_s)))
        .significant("part", without_noise(c.at_asked_percent), Unit::Percent, 3)
        .in_language(language)
}

/// Returns a speed, or a range of speeds that are printed differently.
fn speeds(ends: (f64, f64)) -> Message {
    match format_number(ends.0, 5) == format_number(ends.1, 5) {
        true => quantity(ends.1, Unit::MmPerS, 5),
        false => range("report-range", ends, Unit::MmPerS),
    }
}

pub(super) fn bounds_table(c: &CertificateFigures, language: Language) -> Block {
    let last = c.intervals.len();
    let part = |i: usize, interval: &IntervalFigures| match interval.between {
        true => "report-section-weld",
        false if i + 1 == last || interval.from_mm >= c.run_down_start_mm => "report-deceleration-phase",
        false => "report-acceleration-phase",
    };
    let caption = match last.saturating_sub(LISTED) {
        0 => Message::new("report-caption-binding"),
        more => Message::new("report-caption-binding-first").count("n", LISTED).count("more", more),
    };
    let table = Table::of(language, c.intervals.iter().take(LISTED).enumerate())
        .number("report-column-from", |(_, interval)| number(interval.from_mm, language))
        .number("report-column-to", |(_, interval)| number(interval.to_mm, language))
        .text("report-column-section", |(i, interval)| language.words(part(*i, interval)))
        .number("report-column-min-speed", |(_, interval)| number(interval.least_speed_mm_s, language))
        .number("report-column-max-speed", |(_, interval)| number(interval.greatest_speed_mm_s, language))
        .text("report-column-binding", |(_, interval)| what_binds(interval, language));
    Block::Table(table.table(caption.in_language(language)))
}

fn what_binds(interval: &IntervalFigures, language: Language) -> String {
    let message = match (&interval.axis, interval.limit, &interval.unit) {
        (Some(axis), Some(limit), Some(unit)) => Message::new("report-binding")
            .message("what", bound(interval.bound))
            .message("owner", owner(axis))
            .significant("limit", limit, Unit::from_symbol(unit).unwrap_or(Unit::One), 5),
        _ => Message::new("report-no-binding"),
    };
    message.in_language(language)
}

/// Returns the name of the binding axis, or of the torch tip.
fn owner(axis: &str) -> Message {
    if axis == TIP { Message::new("report-torch-tip") } else { Message::new("report-axis").axis("axis", axis) }
}

fn bound(bound: &str) -> Message {
    Message::new(match bound {
        "speed" => "report-label-speed",
        "acceleration" => "report-label-acceleration",
        "jerk" => "report-label-jerk",
        _ => "report-requested-speed",
    })
}

/// Names the bound in short form: `axis c, jerk`.
pub(super) fn binds(interval: &IntervalFigures, language: Language) -> String {
    let bound = bound(interval.bound).in_language(language);
    match &interval.axis {
        Some(axis) => format!("{}, {bound}", owner(axis).in_language(language)),
        None => bound,
    }
}

pub(super) fn uses_table(uses: &[UseFigures], language: Language) -> Block {
    let limit =
        |value: f64, of: &UseFigures, order: usize| quantity(value, units(of.unit)[order], 5).in_language(language);
    Table::of(language, uses)
        .text("report-column-axis", |u| u.axis.clone())
        .number("report-column-speed-used", |u| percent(u.speed_percent, language))
        .number("report-column-of", |u| limit(u.max_speed, u, 1))
        .number("report-column-acceleration-used", |u| percent(u.acceleration_percent, language))
        .number("report-column-of", |u| limit(u.max_acceleration, u, 2))
        .number("report-column-jerk-used", |u| percent(u.jerk_percent, language))
        .number("report-column-of", |u| limit(u.max_jerk, u, 3))
        .captioned("report-caption-uses")
}

pub(super) fn axes_table(axes: &[AxisFigures], language: Language) -> Block {
    let number = |value| number(value, language);
    let range = |axis: &AxisFigures| match axis.range {
        Some((low, high)) => from_to(number(low), number(high), language),
        None => language.words("report-continuous"),
    };
    Table::of(language, axes)
        .text("report-column-axis", |a| a.axis.clone())
        .text("report-column-unit", |a| language.symbol(units(a.unit)[0]))
        .number("report-column-min", |a| number(a.min))
        .number("report-column-max", |a| number(a.max))
        .number("report-column-range", |a| range(a))
        .captioned("report-caption-ranges")
}

/// Formats a percentage of a limit; rounding noise becomes 0.
fn percent(value: f64, language: Language) -> String {
    significant(without_noise(value), 3, language)
}

fn without_noise(percent: f64) -> f64 {
    if percent < 1e-4 { 0.0 } else { percent }
}
