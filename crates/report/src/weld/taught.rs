//! Charts of the taught spans of a seam.

use super::chart_parts::{axis, chart, line};
use crate::chart::{Band, Chart};
use crate::grid::ChartGrid;
use crate::number::Significant as _;
use crate::series::{Series, Style};
use crate::words::Words as _;
use seamwright_machine::Machine;
use seamwright_message::{Language, Message, Unit};
use seamwright_motion::PassMotion;
use seamwright_weld::{SeamCurve, TaughtSpan};

/// Number of intervals over a span and the seam shown beside it.
const PLACES: u32 = 600;
/// Length of the seam shown to each side, as a fraction of the span.
const BESIDE: f64 = 0.2;

/// Plots of one span: its deviation from the nominal seam, and the torch motion along it.
#[derive(Debug, Clone)]
pub struct TaughtPlot {
    /// Description of the plots.
    pub text: String,
    /// Distance, direction, curvature and speed over path length.
    pub charts: ChartGrid,
}

/// Plots all taught spans of `seam` in one pass.
pub(crate) fn taught(machine: &Machine, seam: &SeamCurve, motion: &PassMotion, language: Language) -> Vec<TaughtPlot> {
    let spans = seam.taught().iter().enumerate();
    spans.map(|(i, span)| Shown { seam, span, number: i + 1, language }.plot(machine, motion)).collect()
}

/// A span to plot.
struct Shown<'a> {
    seam: &'a SeamCurve,
    span: &'a TaughtSpan,
    number: usize,
    language: Language,
}

impl Shown<'_> {
    fn plot(&self, machine: &Machine, motion: &PassMotion) -> TaughtPlot {
        let language = self.language;
        let (from, to) = self.span.seam;
        let places = self.places();
        let curve = |f: &dyn Fn(f64) -> f64| places.iter().map(|s| (*s, f(*s))).collect::<Vec<_>>();
        let distance = |s: f64| self.seam.off_nominal(self.span, s).0;
        let turn = |s: f64| self.seam.off_nominal(self.span, s).1.to_degrees();
        let speed = |s: f64| motion.tip_speed(machine, motion.profile.at(motion.profile.time(s), &mut 0));
        let bend = |s: f64| 1e3 * self.seam.curvature(s).length();
        let nominal_bend = |s: f64| 1e3 * self.seam.nominal().curvature(self.nominal_s(s)).length();
        let points = self.span.points.iter().map(|s| (*s, distance(*s))).collect();
        let chart = |title, y, series: Vec<Series>| Chart {
            bands: vec![Band { label: language.words("report-taught"), from, to }],
            height: Some(96.0),
            ..chart(language, title, y, series)
        };
        let line = |name, points| line(language, name, points);
        let speeds = curve(&speed);
        let fastest = speeds.iter().fold(0.0, |m: f64, p| m.max(p.1));
        let charts = vec![
            chart(
                "report-chart-off-nominal",
                axis(language, "report-label-distance", Unit::Mm),
                vec![
                    line("report-curve-as-welded", curve(&distance)),
                    line("report-curve-nominal", curve(&|_| 0.0)).styled(Style::Dashed),
                    line("report-curve-taught-points", points).styled(Style::Points),
                ],
            ),
            chart(
                "report-chart-direction-off-nominal",
                axis(language, "report-label-angle", Unit::Deg),
                vec![line("report-curve-as-welded", curve(&turn))],
            ),
            chart(
                "report-chart-curvature",
                axis(language, "report-label-curvature", Unit::PerM),
                vec![
                    line("report-curve-as-welded", curve(&bend)),
                    line("report-curve-nominal", curve(&nominal_bend)).styled(Style::Dashed),
                ],
            ),
            Chart {
                y_range: Some((0.0, 1.2 * fastest)),
                ..chart(
                    "report-chart-tip-speed",
                    axis(language, "report-label-speed", Unit::MmPerS),
                    vec![line("report-curve-planned", speeds)],
                )
            },
        ];
        let title = Message::new("report-chart-taught").pass("number", self.number).in_language(language);
        TaughtPlot { text: self.text(&places), charts: ChartGrid { title, columns: 1, charts } }
    }

    /// Returns the stations of the charts: evenly spaced, plus joins and taught points.
    fn places(&self) -> Vec<f64> {
        let (from, to) = self.span.seam;
        let beside = BESIDE * (to - from);
        let (low, high) = ((from - beside).max(0.0), (to + beside).min(self.seam.weld_length()));
        let mut places: Vec<f64> =
            (0..=PLACES).map(|i| low + (high - low) * f64::from(i) / f64::from(PLACES)).collect();
        places.extend([from, to]);
        places.extend(&self.span.points);
        places.sort_by(f64::total_cmp);
        places
    }

    /// Returns the station of the nominal seam that corresponds to `s`.
    fn nominal_s(&self, s: f64) -> f64 {
        let ((from, to), (a, b)) = (self.span.seam, self.span.nominal);
        match (s - from) / (to - from) {
            ..0.0 => a + s - from,
            part @ 0.0..=1.0 => a + part * (b - a),
            _ => b + s - to,
        }
    }

    fn text(&self, places: &[f64]) -> String {
        let (from, to) = self.span.seam;
        let inside = places.iter().filter(|s| **s >= from && **s <= to);
        let off = inside.map(|s| self.seam.off_nominal(self.span, *s));
        let (away, turn) = off.fold((0.0, 0.0), |(a, t): (f64, f64), o| (a.max(o.0), t.max(o.1)));
        let longer = (to - from) - (self.span.nominal.1 - self.span.nominal.0);
        Message::new("report-taught-span")
            .pass("number", self.number)
            .significant("from", from, Unit::One, 5)
            .significant("to", to, Unit::Mm, 5)
            .significant("length", longer.abs(), Unit::Mm, 3)
            .message("change", Message::new(if longer < 0.0 { "report-shorter" } else { "report-longer" }))
            .count("n", self.span.points.len())
            .significant("distance", away, Unit::Mm, 3)
            .significant("angle", turn.to_degrees(), Unit::Deg, 3)
            .in_language(self.language)
    }
}
