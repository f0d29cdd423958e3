//! How far a weld lies from a joint that is elsewhere than planned, with and without tracking.

use super::curves::{Envelope, SimulationCurves};
use crate::{Axis, Chart, ChartGrid, Series, Style, Table, format_number};
use seamwright_cell::tracking::{HeadSample, HeadSummary};

/// One head's curves over path length, gathered sample by sample; mm.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HeadCurves {
    /// Where the joint truly is: lateral, height.
    seam: [Envelope; 2],
    miss: [Envelope; 2],
    sigma: Envelope,
}

impl HeadCurves {
    pub(super) fn new(length: f64) -> Self {
        let empty = || Envelope::new(length);
        Self { seam: [empty(), empty()], miss: [empty(), empty()], sigma: empty() }
    }

    pub(super) fn add(&mut self, s: f64, head: &HeadSample) {
        for k in 0..2 {
            self.seam[k].add(s, head.seam[k]);
            self.miss[k].add(s, head.miss[k]);
        }
        if let Some((sigma, _)) = head.known.filter(|(sigma, _)| sigma.is_finite()) {
            self.sigma.add(s, sigma);
        }
    }
}

/// Before and after: of each head the joint beside the planned path, and the weld beside the joint.
pub(super) fn charts(curves: &SimulationCurves, heads: &[HeadSummary]) -> Option<ChartGrid> {
    let mut charts = Vec::new();
    for (head, curves) in heads.iter().zip(&curves.heads) {
        let name = if heads.len() > 1 { format!("{}: ", head.head) } else { String::new() };
        let chart = |what: &str, series: Vec<Series>| Chart {
            title: format!("{name}{what}"),
            x: Axis::new("path length s", "mm"),
            y: Axis::new("distance", "mm"),
            series,
            height: Some(110.0),
            ..Chart::default()
        };
        let pair = |of: &[Envelope; 2]| {
            vec![Series::line("lateral", of[0].points()), Series::line("height", of[1].points()).styled(Style::Dashed)]
        };
        charts.push(chart(
            "the joint beside the planned path (a weld without tracking misses it by this)",
            pair(&curves.seam),
        ));
        charts.push(chart("the weld beside the joint", pair(&curves.miss)));
        let sigma = curves.sigma.points();
        if !sigma.is_empty() {
            charts.push(chart("how well the joint is known (standard deviation)", vec![Series::line("sigma", sigma)]));
        }
    }
    (!charts.is_empty()).then(|| ChartGrid { title: "Joint and weld".to_owned(), columns: 1, charts })
}

/// Both numbers of each head.
pub(super) fn table(heads: &[HeadSummary]) -> Table {
    let mm = |value: f64| format_number(value, 3);
    let row = |h: &HeadSummary| {
        let most = h.used.map(|used| used.into_iter().fold(0.0, f64::max));
        vec![
            h.head.clone(),
            mm(h.untracked_p99_mm),
            mm(h.untracked_most_mm),
            if h.tracked { mm(h.miss_p99_mm) } else { "not tracked".to_owned() },
            if h.tracked { mm(h.miss_most_mm) } else { String::new() },
            most.map_or_else(String::new, |part| format!("{:.0} %", 100.0 * part)),
            h.stopped_mm.map_or_else(String::new, |s| format!("{s:.1}")),
        ]
    };
    Table {
        caption: "Distance of the weld from the joint, lateral and height together".to_owned(),
        head: [
            "Head",
            "untracked, 99 % (mm)",
            "at most",
            "tracked, 99 % (mm)",
            "at most",
            "of what corrections may do",
            "stopped at (mm)",
        ]
        .map(str::to_owned)
        .into(),
        rows: heads.iter().map(row).collect(),
        numeric: (0..7).map(|column| column > 0).collect(),
    }
}

/// What the operator should look at.
pub(super) fn text(heads: &[HeadSummary]) -> String {
    let told = heads
        .iter()
        .flat_map(|h| h.alarms.iter().map(move |a| format!("{} at {:.1} mm: {}", h.head, a.at_mm, a.text())));
    let told: Vec<String> = told.collect();
    let first = "The part lies elsewhere than planned. ";
    match told.is_empty() {
        true if heads.iter().all(|h| h.tracked) => format!("{first}Tracking had nothing to tell."),
        true => format!("{first}It was welded as planned."),
        false => format!("{first}To be looked at: {}.", told.join("; ")),
    }
}
