//! Charts of the taught spans of a seam.

use crate::number::{Significant as _, range};
use crate::{Axis, Band, Chart, ChartGrid, Language, Series, Style, Words as _};
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use seamwright_motion::PassMotion;
use seamwright_weld::{SeamCurve, TaughtSpan};

/// Number of intervals over a span and the seam shown beside it.
const PLACES: u32 = 600;
/// Length of the seam shown to each side, as a fraction of the span.
const BESIDE: f64 = 0.2;

/// Plots of one span: its deviation from the nominal seam, and the torch motion along it.
pub(super) struct TaughtPlot {
    /// Description of the plots.
    pub(super) text: String,
    /// Distance, direction, curvature and speed over path length.
    pub(super) charts: ChartGrid,
}

pub(super) fn taught(machine: &Machine, seam: &SeamCurve, motion: &PassMotion, language: Language) -> Vec<TaughtPlot> {
    let spans = seam.taught().iter().enumerate();
    spans.map(|(i, span)| Shown { seam, span, number: i + 1, language }.plot(machine, motion)).collect()
}

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
        let chart = |title, (label, unit), series: Vec<Series>| Chart {
            bands: vec![Band { label: language.words("report-taught"), from, to }],
            height: Some(96.0),
            ..Chart::along(language, title, Axis::of(language, label, unit), series)
        };
        let line = |name, points| Series::named(language, name, points);
        let welded = |f: &dyn Fn(f64) -> f64| line("report-curve-as-welded", curve(f));
        let nominal = |f: &dyn Fn(f64) -> f64| line("report-curve-nominal", curve(f)).styled(Style::Dashed);
        let taught = line("report-curve-taught-points", points).styled(Style::Points);
        let speeds = curve(&speed);
        let fastest = speeds.iter().fold(0.0, |m: f64, p| m.max(p.1));
        let speeds = vec![line("report-curve-planned", speeds)];
        let off = vec![welded(&distance), nominal(&|_| 0.0), taught];
        let bends = vec![welded(&bend), nominal(&nominal_bend)];
        let angle = ("report-label-angle", Unit::Deg);
        let speed = chart("report-chart-tip-speed", ("report-label-speed", Unit::MmPerS), speeds);
        let charts = vec![
            chart("report-chart-off-nominal", ("report-label-distance", Unit::Mm), off),
            chart("report-chart-direction-off-nominal", angle, vec![welded(&turn)]),
            chart("report-chart-curvature", ("report-label-curvature", Unit::PerM), bends),
            Chart { y_range: Some((0.0, 1.2 * fastest)), ..speed },
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
        range("report-taught-span", (from, to), Unit::Mm)
            .pass("number", self.number)
            .significant("length", longer.abs(), Unit::Mm, 3)
            .message("change", Message::new(if longer < 0.0 { "report-shorter" } else { "report-longer" }))
            .count("n", self.span.points.len())
            .significant("distance", away, Unit::Mm, 3)
            .significant("angle", turn.to_degrees(), Unit::Deg, 3)
            .in_language(self.language)
    }
}
