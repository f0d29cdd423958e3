//! Deviation of a weld from a displaced joint, with and without tracking.

use super::chart_parts::{axis, chart, line};
use super::curves::{Envelope, SimulationCurves};
use crate::block::Table;
use crate::chart::Chart;
use crate::grid::ChartGrid;
use crate::number::{Significant as _, fixed, significant};
use crate::series::{Series, Style};
use crate::words::Words as _;
use seamwright_executive::tracking::BeamFit;
use seamwright_simulation::tracking::HeadSummary;
use seamwright_message::{Language, Message, Unit};

/// Plots for each head the joint relative to the planned path, and the weld relative to the joint.
pub(super) fn charts(curves: &SimulationCurves, heads: &[HeadSummary], language: Language) -> Option<ChartGrid> {
    let mut charts = Vec::new();
    for (head, curves) in heads.iter().zip(&curves.heads) {
        let name = if heads.len() > 1 { format!("{}: ", head.head) } else { String::new() };
        let chart = |what: &'static str, series: Vec<Series>| Chart {
            title: format!("{name}{}", language.words(what)),
            height: Some(110.0),
            ..chart(language, "", axis(language, "report-label-distance", Unit::Mm), series)
        };
        let line = |name, points| line(language, name, points);
        let pair = |of: &[Envelope; 2]| {
            vec![
                line("report-curve-lateral", of[0].points()),
                line("report-curve-height", of[1].points()).styled(Style::Dashed),
            ]
        };
        charts.push(chart("report-chart-joint", pair(&curves.seam)));
        let beside = match head.lateral_only {
            true => vec![line("report-curve-lateral", curves.miss[0].points())],
            false => pair(&curves.miss),
        };
        charts.push(chart("report-chart-weld", beside));
        let deflected = curves.beam[0].points();
        if !deflected.is_empty() {
            let carried = line("report-curve-gun", curves.beam[1].points()).styled(Style::Dashed);
            let title = "report-chart-correction";
            charts.push(chart(title, vec![line("report-curve-deflection", deflected), carried]));
        }
        let sigma = curves.sigma.points();
        if !sigma.is_empty() {
            charts.push(chart("report-chart-sigma", vec![line("report-curve-sigma", sigma)]));
        }
    }
    (!charts.is_empty()).then(|| ChartGrid { title: language.words("report-chart-tracking"), columns: 1, charts })
}

/// Returns the deviations of each head with and without tracking.
pub(super) fn table(heads: &[HeadSummary], language: Language) -> Table {
    // A head that has not welded has no deviations.
    let mm = |value: f64| {
        if value.is_finite() { significant(value, 3, language) } else { language.words("report-not-welded") }
    };
    let row = |h: &HeadSummary| {
        let percent = |value| Message::new("quantity").quantity("value", value, Unit::Percent, 0).in_language(language);
        let most = h.used.map(|used| used.into_iter().fold(0.0, f64::max));
        vec![
            h.head.clone(),
            mm(h.untracked_p99_mm),
            mm(h.untracked_most_mm),
            if h.tracked { mm(h.miss_p99_mm) } else { language.words("report-not-tracked") },
            if h.tracked { mm(h.miss_most_mm) } else { String::new() },
            most.map_or_else(String::new, |part| percent(100.0 * part)),
            h.stopped_mm.map_or_else(String::new, |s| fixed(s, 1, language)),
        ]
    };
    Table {
        caption: language.words(match heads.iter().any(|head| head.lateral_only) {
            true => "report-caption-tracked-lateral",
            false => "report-caption-tracked",
        }),
        head: [
            "report-column-head",
            "report-column-untracked",
            "report-limit-at-most",
            "report-column-tracked",
            "report-limit-at-most",
            "report-column-correction-used",
            "report-column-stopped-at",
        ]
        .map(|head| language.words(head))
        .into(),
        rows: heads.iter().map(row).collect(),
        numeric: (0..7).map(|column| column > 0).collect(),
    }
}

/// Returns the corrections of beams; `None` without a beam.
pub(super) fn beam_table(heads: &[HeadSummary], language: Language) -> Option<Table> {
    let number = |value, digits| significant(value, digits, language);
    let row = |h: &HeadSummary| {
        let beam = h.beam.as_ref()?;
        let stored = |fit: &BeamFit| {
            Message::new("report-stored-points")
                .significant("value", fit.within_mm, Unit::One, 3)
                .count("n", fit.points)
                .in_language(language)
        };
        Some(vec![
            language.words(if beam.replayed { "report-stored-deviations" } else { "report-seen-by-beam" }),
            Message::new("report-part-of")
                .significant("value", beam.deflected_mm, Unit::One, 3)
                .significant("whole", beam.range_mm, Unit::One, 3)
                .in_language(language),
            number(beam.carried_mm, 3),
            number(beam.away_percent, 3),
            number(beam.longest_away_ms, 3),
            beam.fit.as_ref().map_or_else(String::new, stored),
        ])
    };
    let rows: Vec<_> = heads.iter().filter_map(row).collect();
    (!rows.is_empty()).then(|| Table {
        caption: language.words("report-caption-beam"),
        head: [
            "report-column-corrected-by",
            "report-column-deflected",
            "report-column-gun-carried",
            "report-column-away",
            "report-column-longest",
            "report-column-stored-within",
        ]
        .map(|head| language.words(head))
        .into(),
        rows,
        numeric: (0..6).map(|column| column > 0).collect(),
    })
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
