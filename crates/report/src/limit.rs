//! Horizontal limits of a chart.

use crate::Language;
use crate::domain::{Domain, usable};
use crate::number;
use seamwright_message::Message;

/// A value that the data should not cross.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LimitLine {
    /// Name, for example `limit`; the value is written behind it.
    pub label: String,
    /// The value, in the unit of the y axis.
    pub value: f64,
}

impl LimitLine {
    /// Creates a limit.
    pub fn new(label: impl Into<String>, value: f64) -> Self {
        Self { label: label.into(), value }
    }

    pub(crate) fn text(&self, language: Language) -> String {
        format!("{} {}", self.label, number::significant(self.value, 5, language)).trim().into()
    }
}

/// Maximum ratio of an axis with its limits to the range of the data.
const STRETCH: f64 = 4.0;

/// Fraction of a limit below which data about zero are rounding noise.
const NOISE: f64 = 1e-6;

/// Returns the range of the data, or of the limits if the data are only noise about zero.
pub(crate) fn significant(data: Domain, limits: &[LimitLine]) -> Domain {
    let largest = limits.iter().map(|l| l.value.abs()).filter(|v| usable(*v)).fold(0.0, f64::max);
    if data.lo.abs().max(data.hi.abs()) < NOISE * largest { Domain { lo: -largest, hi: largest } } else { data }
}

/// Extends the range of the data to the limits, nearest first, while the data keep a quarter of the axis.
pub(crate) fn stretch(data: Domain, limits: &[LimitLine]) -> Domain {
    let room = STRETCH * data.settled().span();
    let mut values: Vec<f64> = limits.iter().map(|l| l.value).filter(|v| usable(*v)).collect();
    let beyond = |v: &f64| (data.lo - v).max(v - data.hi);
    values.sort_by(|a, b| beyond(a).total_cmp(&beyond(b)));
    values.into_iter().fold(data, |reached, v| {
        let further = reached.including(v);
        if further.span() <= room { further } else { reached }
    })
}

/// Returns notes on limits outside `shown`, one each, or one for a pair of `±` limits. Each has a shorter form without
/// the side, for narrow places.
pub(crate) fn notes(limits: &[LimitLine], shown: Domain, unit: &str, language: Language) -> Vec<[String; 2]> {
    let mut outside: Vec<&LimitLine> = limits.iter().filter(|l| usable(l.value) && !shown.contains(l.value)).collect();
    let mut notes = Vec::new();
    while let Some(limit) = outside.pop() {
        let opposite = outside.iter().position(|other| {
            other.label == limit.label && (other.value + limit.value).abs() <= 1e-9 * limit.value.abs()
        });
        let (sign, value, side) = match opposite {
            Some(i) => {
                outside.remove(i);
                ("±", limit.value.abs(), "report-limit-outside")
            }
            None => ("", limit.value, if limit.value > shown.hi { "report-limit-above" } else { "report-limit-below" }),
        };
        let amount =
            format!("{} {sign}{} {unit}", limit.label, number::significant(value, 5, language)).trim().to_owned();
        notes.push([Message::new(side).text("limit", &amount).in_language(language), amount]);
    }
    notes.reverse();
    notes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn limits(values: &[f64]) -> Vec<LimitLine> {
        values.iter().map(|v| LimitLine::new("limit", *v)).collect()
    }

    #[test]
    fn near_limits_are_shown_far_ones_noted() {
        let data = Domain { lo: 0.0, hi: 10.0 };
        assert_eq!(stretch(data, &limits(&[30.0])), Domain { lo: 0.0, hi: 30.0 });
        assert_eq!(stretch(data, &limits(&[50.0])), data);
        assert_eq!(stretch(data, &limits(&[-500.0, 12.0])), Domain { lo: 0.0, hi: 12.0 });
        let notes = |values: &[f64], unit| {
            let notes = notes(&limits(values), data, unit, Language::English);
            notes.into_iter().map(|[whole, _]| whole).collect::<Vec<_>>()
        };
        assert_eq!(notes(&[50.0], "deg/s"), ["limit 50 deg/s, above"]);
        assert_eq!(notes(&[-5.0, 8.0], "mm"), ["limit -5 mm, below"]);
        assert_eq!(notes(&[-50.0, 50.0], "mm"), ["limit ±50 mm, outside"]);
    }

    #[test]
    fn constant_data_and_unusable_limits() {
        let still = Domain { lo: 0.0, hi: 0.0 };
        assert_eq!(stretch(still, &limits(&[30.0, f64::NAN, f64::INFINITY])), still);
        let steady = Domain { lo: 8.0, hi: 8.0 };
        assert_eq!(stretch(steady, &limits(&[10.0])), Domain { lo: 8.0, hi: 10.0 });
        assert!(notes(&limits(&[f64::NAN, f64::INFINITY]), still, "mm", Language::English).is_empty());
    }
}
