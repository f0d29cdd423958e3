//! Deviation of a weld from a displaced joint, with and without tracking.

use super::curves::{Envelope, SimulationCurves};
use crate::number::{Significant as _, fixed, significant};
use crate::{Axis, Chart, ChartGrid, Language, Series, Style, Table, Words as _};
use seamwright_executive::tracking::{BeamFit, BeamSummary};
use seamwright_message::{Message, Unit};
use seamwright_simulation::tracking::{HeadSample, HeadSummary};

/// One head's curves over path length, gathered sample by sample; mm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HeadCurves {
    /// Actual position of the joint: lateral, height.
    seam: [Envelope; 2],
    miss: [Envelope; 2],
    sigma: Envelope,
    /// Correction by the beam's deflection, and by the axes that carry the gun.
    beam: [Envelope; 2],
}

impl HeadCurves {
    pub(super) fn new(length: f64) -> Self {
        let empty = || Envelope::new(length);
        Self { seam: [empty(), empty()], miss: [empty(), empty()], sigma: empty(), beam: [empty(), empty()] }
    }

    pub(super) fn add(&mut self, s: f64, head: &HeadSample) {
        for k in 0..2 {
            self.seam[k].add(s, head.seam[k]);
            self.miss[k].add(s, head.miss[k]);
        }
        if let Some(beam) = head.beam {
            self.beam[0].add(s, beam.deflection_mm);
            self.beam[1].add(s, head.correction.x - beam.deflection_mm);
        }
        if let Some(sigma) = head.tracked.map(|tracked| tracked.sigma_mm).filter(|sigma| sigma.is_finite()) {
            self.sigma.add(s, sigma);
        }
    }
}

/// Plots for each head the joint relative to the planned path, and the weld relative to the joint.
pub(super) fn charts(curves: &SimulationCurves, heads: &[HeadSummary], language: Language) -> Option<ChartGrid> {
    let mut charts = Vec::new();
    for (head, curves) in heads.iter().zip(&curves.heads) {
        let name = if heads.len() > 1 { format!("{}: ", head.head) } else { String::new() };
        let mut chart = |what: &'static str, series: Vec<Series>| {
            charts.push(Chart {
                title: format!("{name}{}", language.words(what)),
                height: Some(110.0),
                ..Chart::along(language, "", Axis::of(language, "report-label-distance", Unit::Mm), series)
            });
        };
        let line = |name, of: &Envelope| Series::named(language, name, of.points());
        let pair = |of: &[Envelope; 2]| {
            vec![line("report-curve-lateral", &of[0]), line("report-curve-height", &of[1]).styled(Style::Dashed)]
        };
        chart("report-chart-joint", pair(&curves.seam));
        let mut beside = pair(&curves.miss);
        beside.truncate(if head.lateral_only { 1 } else { 2 });
        chart("report-chart-weld", beside);
        let deflected = line("report-curve-deflection", &curves.beam[0]);
        if !deflected.points.is_empty() {
            let carried = line("report-curve-gun", &curves.beam[1]).styled(Style::Dashed);
            chart("report-chart-correction", vec![deflected, carried]);
        }
        let sigma = line("report-curve-sigma", &curves.sigma);
        if !sigma.points.is_empty() {
            chart("report-chart-sigma", vec![sigma]);
        }
    }
    (!charts.is_empty()).then(|| ChartGrid { title: language.words("report-chart-tracking"), columns: 1, charts })
}

pub(super) fn table(heads: &[HeadSummary], language: Language) -> Table {
    // A head that has not welded has no deviations.
    let mm = |value: f64| match value.is_finite() {
        true => significant(value, 3, language),
        false => language.words("report-not-welded"),
    };
    let percent = |value| Message::new("quantity").quantity("value", value, Unit::Percent, 0).in_language(language);
    let used = |h: &HeadSummary| h.used.map(|used| percent(100.0 * used.into_iter().fold(0.0, f64::max)));
    let not_tracked = || language.words("report-not-tracked");
    let caption = match heads.iter().any(|head| head.lateral_only) {
        true => "report-caption-tracked-lateral",
        false => "report-caption-tracked",
    };
    Table::of(language, heads)
        .text("report-column-head", |h| h.head.clone())
        .number("report-column-untracked", |h| mm(h.untracked_p99_mm))
        .number("report-limit-at-most", |h| mm(h.untracked_most_mm))
        .number("report-column-tracked", |h| if h.tracked { mm(h.miss_p99_mm) } else { not_tracked() })
        .number("report-limit-at-most", |h| if h.tracked { mm(h.miss_most_mm) } else { String::new() })
        .number("report-column-correction-used", |h| used(h).unwrap_or_default())
        .number("report-column-stopped-at", |h| h.stopped_mm.map(|s| fixed(s, 1, language)).unwrap_or_default())
        .table(language.words(caption))
}

pub(super) fn beam_table(heads: &[HeadSummary], language: Language) -> Option<Table> {
    let number = |value| significant(value, 3, language);
    let deflected = |beam: &BeamSummary| {
        Message::new("report-part-of")
            .significant("value", beam.deflected_mm, Unit::One, 3)
            .significant("whole", beam.range_mm, Unit::One, 3)
            .in_language(language)
    };
    let stored = |fit: &BeamFit| {
        let message = Message::new("report-stored-points").significant("value", fit.within_mm, Unit::One, 3);
        message.count("n", fit.points).in_language(language)
    };
    let source = |replayed| if replayed { "report-stored-deviations" } else { "report-seen-by-beam" };
    let table = Table::of(language, heads.iter().filter_map(|h| h.beam.as_ref()))
        .text("report-column-corrected-by", |beam| language.words(source(beam.replayed)))
        .number("report-column-deflected", |beam| deflected(beam))
        .number("report-column-gun-carried", |beam| number(beam.carried_mm))
        .number("report-column-away", |beam| number(beam.away_percent))
        .number("report-column-longest", |beam| number(beam.longest_away_ms))
        .number("report-column-stored-within", |beam| beam.fit.as_ref().map(stored).unwrap_or_default())
        .table(language.words("report-caption-beam"));
    (!table.rows.is_empty()).then_some(table)
}

/// Describes the alarms that the operator should check.
pub(super) fn text(heads: &[HeadSummary], language: Language) -> String {
    let alarms = heads.iter().flat_map(|h| h.alarms.iter().map(move |a| (h, a)));
    let alarms: Vec<String> = alarms
        .map(|(h, a)| {
            Message::new("report-alarm-at")
                .text("head", &h.head)
                .quantity("s", a.at_mm, Unit::Mm, 1)
                .message("alarm", a.message())
                .in_language(language)
        })
        .collect();
    let then = match alarms.is_empty() {
        true if heads.iter().all(|h| h.tracked) => Message::new("report-tracking-without-alarms"),
        true => Message::new("report-welded-as-planned"),
        false => Message::new("report-to-be-checked").text("alarms", alarms.join("; ")),
    };
    language.sentences(&[language.words("report-part-displaced"), then.in_language(language)])
}
