//! Parts of the charts.

use crate::chart::{Axis, Chart};
use crate::series::Series;
use crate::words::Words as _;
use seamwright_message::{Language, Unit};

pub(super) fn axis(language: Language, label: &'static str, unit: Unit) -> Axis {
    Axis::new(language.words(label), language.symbol(unit))
}

pub(super) fn along(language: Language) -> Axis {
    axis(language, "report-label-path-length", Unit::Mm)
}

pub(super) fn line(language: Language, name: &'static str, points: Vec<(f64, f64)>) -> Series {
    Series::line(language.words(name), points)
}

/// Creates a chart over path length.
pub(super) fn chart(language: Language, title: &'static str, y: Axis, series: Vec<Series>) -> Chart {
    let title = language.words(title);
    Chart { language, title, x: along(language), y, series, ..Chart::default() }
}

/// Returns the units of position, speed, acceleration and jerk of an axis whose positions are in `unit`.
pub(super) fn units(unit: &str) -> [Unit; 4] {
    match unit {
        "deg" => [Unit::Deg, Unit::DegPerS, Unit::DegPerS2, Unit::DegPerS3],
        _ => [Unit::Mm, Unit::MmPerS, Unit::MmPerS2, Unit::MmPerS3],
    }
}
