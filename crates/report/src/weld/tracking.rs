//! Deviation of a weld from a displaced joint, with and without tracking.

use super::charts::{chart, line};
use super::curves::{Envelope, SimulationCurves};
use crate::Phrases as _;
use crate::{Chart, ChartGrid, Language, Series, Style, Table, format_number, said};
use seamwright_cell::tracking::{BeamFit, HeadSample, HeadSummary};

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
        let chart = |what: &'static str, series: Vec<Series>| Chart {
            title: format!("{name}{}", language.say(what)),
            height: Some(110.0),
            ..chart(language, "", ("distance", "mm"), series)
        };
        let line = |name, points| line(language, name, points);
        let pair = |of: &[Envelope; 2]| {
            vec![line("lateral", of[0].points()), line("height", of[1].points()).styled(Style::Dashed)]
        };
        charts.push(chart(
            "the joint beside the planned path (a weld without tracking misses it by this)",
            pair(&curves.seam),
        ));
        let beside = match head.lateral_only {
            true => vec![line("lateral", curves.miss[0].points())],
            false => pair(&curves.miss),
        };
        charts.push(chart("the weld beside the joint", beside));
        let deflected = curves.beam[0].points();
        if !deflected.is_empty() {
            let carried = line("gun carried by the axes", curves.beam[1].points()).styled(Style::Dashed);
            let title = "what corrects it, lateral: the beam's deflection; dashed, the gun carried by the axes";
            charts.push(chart(title, vec![line("deflection", deflected), carried]));
        }
        let sigma = curves.sigma.points();
        if !sigma.is_empty() {
            charts.push(chart("how well the joint is known (standard deviation)", vec![line("sigma", sigma)]));
        }
    }
    (!charts.is_empty()).then(|| ChartGrid { title: language.say("Joint and weld").to_owned(), columns: 1, charts })
}

/// Returns the deviations of each head with and without tracking.
pub(super) fn table(heads: &[HeadSummary], language: Language) -> Table {
    // A head that has not welded has no deviations.
    let mm =
        |value: f64| if value.is_finite() { format_number(value, 3) } else { language.say("none welded").to_owned() };
    let row = |h: &HeadSummary| {
        let most = h.used.map(|used| used.into_iter().fold(0.0, f64::max));
        vec![
            h.head.clone(),
            mm(h.untracked_p99_mm),
            mm(h.untracked_most_mm),
            if h.tracked { mm(h.miss_p99_mm) } else { language.say("not tracked").to_owned() },
            if h.tracked { mm(h.miss_most_mm) } else { String::new() },
            most.map_or_else(String::new, |part| format!("{:.0} %", 100.0 * part)),
            h.stopped_mm.map_or_else(String::new, |s| format!("{s:.1}")),
        ]
    };
    Table {
        caption: language
            .say(match heads.iter().any(|head| head.lateral_only) {
                true => "Distance of the weld from the joint, lateral: a beam has no height",
                false => "Distance of the weld from the joint, lateral and height together",
            })
            .to_owned(),
        head: [
            "Head",
            "untracked, 99 % (mm)",
            "at most",
            "tracked, 99 % (mm)",
            "at most",
            "of what corrections may do",
            "stopped at (mm)",
        ]
        .map(|head| language.say(head).to_owned())
        .into(),
        rows: heads.iter().map(row).collect(),
        numeric: (0..7).map(|column| column > 0).collect(),
    }
}

/// Returns the corrections of beams; `None` without a beam.
pub(super) fn beam_table(heads: &[HeadSummary], language: Language) -> Option<Table> {
    let number = format_number;
    let row = |h: &HeadSummary| {
        let beam = h.beam.as_ref()?;
        let stored =
            |fit: &BeamFit| language.fill("{0} ({1} points)", &[&number(fit.within_mm, 3), &fit.points.to_string()]);
        Some(vec![
            language.say(if beam.replayed { "stored deviations" } else { "what the beam saw" }).to_owned(),
            language.fill("{0} of {1}", &[&number(beam.deflected_mm, 3), &number(beam.range_mm, 3)]),
            number(beam.carried_mm, 3),
            number(beam.away_percent, 3),
            number(beam.longest_away_ms, 3),
            beam.fit.as_ref().map_or_else(String::new, stored),
        ])
    };
    let rows: Vec<_> = heads.iter().filter_map(row).collect();
    (!rows.is_empty()).then(|| Table {
        caption: language.say("The beam").to_owned(),
        head: [
            "corrected by",
            "deflected by up to (mm)",
            "gun carried by up to (mm)",
            "away from the weld (% of its time)",
            "longest (ms)",
            "nine of ten points from what is stored (mm)",
        ]
        .map(|head| language.say(head).to_owned())
        .into(),
        rows,
        numeric: (0..6).map(|column| column > 0).collect(),
    })
}

/// Describes the alarms that the operator should check.
pub(super) fn text(heads: &[HeadSummary], language: Language) -> String {
    let alarms = heads.iter().flat_map(|h| h.alarms.iter().map(move |a| (h, a)));
    let told = alarms.map(|(h, a)| {
        let of = [&h.head, &format!("{:.1}", a.at_mm), &said::sentence(language, &a.text())];
        language.fill("{0} at {1} mm: {2}", &of.map(String::as_str))
    });
    let told: Vec<String> = told.collect();
    let then = match told.is_empty() {
        true if heads.iter().all(|h| h.tracked) => language.say("Tracking had nothing to tell.").to_owned(),
        true => language.say("It was welded as planned.").to_owned(),
        false => language.fill("To be looked at: {0}.", &[&told.join("; ")]),
    };
    [language.say("The part lies elsewhere than planned."), &then].join(language.between_sentences())
}
