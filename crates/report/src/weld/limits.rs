//! Binding limits along the path, in words and tables.

use super::blocks::{number, table};
use super::certificate::{CertificateFigures, IntervalFigures, TIP, UseFigures};
use super::chart_parts::units;
use super::plan::AxisFigures;
use super::range::Range;
use crate::block::Block;
use crate::number::{Significant as _, format_number, from_to, significant};
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};

/// Maximum number of listed stretches, for a readable report; report.json has all of them.
const LISTED: usize = 24;

/// Describes requested and planned speed of the pass in one paragraph.
pub(super) fn speed_text(c: &CertificateFigures, language: Language) -> String {
    let reached = Range { min: c.least_speed_mm_s, max: c.greatest_speed_mm_s };
    Message::new("report-speed-reached")
        .message("requested", speeds(Range::from(c.asked_speed_mm_s)))
        .message("reached", speeds(reached))
        .significant("part", without_noise(c.at_asked_percent), Unit::Percent, 3)
        .in_language(language)
}

/// Returns a speed, or a range of speeds that are printed differently.
fn speeds(mm_s: Range) -> Message {
    let Range { min, max } = mm_s;
    match format_number(min, 5) == format_number(max, 5) {
        true => Message::new("quantity").significant("value", max, Unit::MmPerS, 5),
        false => {
            Message::new("report-range").significant("from", min, Unit::One, 5).significant("to", max, Unit::MmPerS, 5)
        }
    }
}

/// Returns the bounds of the speed, stretch by stretch.
pub(super) fn bounds_table(c: &CertificateFigures, language: Language) -> Block {
    let last = c.intervals.len();
    let rows = c.intervals.iter().take(LISTED).enumerate().map(|(i, interval)| {
        let part = match interval.between {
            true => "report-section-weld",
            false if i + 1 == last || interval.from_mm >= c.run_down_start_mm => "report-deceleration-phase",
            false => "report-acceleration-phase",
        };
        let speeds = [interval.least_speed_mm_s, interval.greatest_speed_mm_s];
        let [from, to] = [interval.from_mm, interval.to_mm].map(|value| number(value, language));
        let [least, greatest] = speeds.map(|value| number(value, language));
        vec![from, to, language.words(part), least, greatest, what_binds(interval, language)]
    });
    let caption = match last.saturating_sub(LISTED) {
        0 => Message::new("report-caption-binding"),
        more => Message::new("report-caption-binding-first").count("n", LISTED).count("more", more),
    };
    let head = [
        "report-column-from",
        "report-column-to",
        "report-column-section",
        "report-column-min-speed",
        "report-column-max-speed",
        "report-column-binding",
    ];
    let mut block = table(&caption.in_language(language), &head.map(|head| language.words(head)), rows.collect(), 0..5);
    if let Block::Table(table) = &mut block {
        table.numeric[2] = false;
    }
    block
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

/// Returns the name of a bound.
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

/// Returns the maximum use of each axis' limits.
pub(super) fn uses_table(uses: &[UseFigures], language: Language) -> Block {
    let rows = uses.iter().map(|u| {
        let [_, per_s, per_s2, per_s3] = units(u.unit);
        let limit =
            |value: f64, unit| Message::new("quantity").significant("value", value, unit, 5).in_language(language);
        vec![
            u.axis.clone(),
            percent(u.speed_percent, language),
            limit(u.max_speed, per_s),
            percent(u.acceleration_percent, language),
            limit(u.max_acceleration, per_s2),
            percent(u.jerk_percent, language),
            limit(u.max_jerk, per_s3),
        ]
    });
    let head = [
        "report-column-axis",
        "report-column-speed-used",
        "report-column-of",
        "report-column-acceleration-used",
        "report-column-of",
        "report-column-jerk-used",
        "report-column-of",
    ];
    let head = head.map(|head| language.words(head));
    table(&language.words("report-caption-uses"), &head, rows.collect(), 1..7)
}

/// Returns the positions of each axis against its range.
pub(super) fn axes_table(axes: &[AxisFigures], language: Language) -> Block {
    let rows = axes.iter().map(|a| {
        let range = match a.range {
            Some((least, greatest)) => from_to(number(least, language), number(greatest, language), language),
            None => language.words("report-continuous"),
        };
        let [least, greatest] = [a.min, a.max].map(|value| number(value, language));
        vec![a.axis.clone(), language.symbol(units(a.unit)[0]), least, greatest, range]
    });
    let head =
        ["report-column-axis", "report-column-unit", "report-column-min", "report-column-max", "report-column-range"]
            .map(|head| language.words(head));
    table(&language.words("report-caption-ranges"), &head, rows.collect(), 2..5)
}

/// Formats a percentage of a limit; rounding noise becomes 0.
fn percent(value: f64, language: Language) -> String {
    significant(without_noise(value), 3, language)
}

fn without_noise(percent: f64) -> f64 {
    if percent < 1e-4 { 0.0 } else { percent }
}
