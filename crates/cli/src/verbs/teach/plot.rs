//! The taught line as a drawing and as curves over its length.

use super::report::Report;
use crate::verbs::reduce::plot::{charts, ends, lines_and_arcs, words};
use glam::DVec3;
use seamwright_report::{Axis, Chart, LimitLine, Series, Style, sheet};
use seamwright_teaching::{Curves, TaughtPoint};

pub(super) fn draw(report: &Report) -> String {
    let points: Vec<DVec3> = report.outcome.smooth.iter().map(|p| p.point).collect();
    let mut all = match &report.reduced.curves {
        Curves::Arcs(arcs) => charts(&points, &lines_and_arcs(&points, &arcs.spans), &ends(&points, &arcs.spans)),
        Curves::Spline(spline) => {
            let knots: Vec<DVec3> = spline.kept.iter().map(|i| points[*i]).collect();
            charts(&points, &[(words("cli-draw-spline"), report.figures.path.clone())], &knots)
        }
    };
    all.extend(curves(report));
    sheet(&words("cli-draw-taught-line"), &all)
}

fn curves(report: &Report) -> Vec<Chart> {
    let over =
        |value: &dyn Fn(&TaughtPoint) -> f64| report.figures.raw.iter().map(|p| (p.way, value(p))).collect::<Vec<_>>();
    let chart = |title, label, unit, series: Vec<Series>| Chart {
        title: words(title),
        x: Axis::new("s", "mm"),
        y: Axis::new(words(label), unit),
        series,
        ..Chart::default()
    };
    let dots = |name, points, colour| Series::line(words(name), points).styled(Style::Points).coloured(colour);
    if report.figures.raw.is_empty() {
        return Vec::new();
    }
    let nominal = |pick: fn((f64, f64)) -> f64| over(&|p| p.from_nominal.map_or(f64::NAN, pick));
    let overlap = report.outcome.notes.iter().filter_map(|n| Some((n.way, n.overlap_mm?))).collect();
    let beside = vec![dots("cli-draw-across", nominal(|n| n.0), 0), dots("cli-draw-above", nominal(|n| n.1), 1)];
    let from_program = vec![dots("cli-draw-raw-points", over(&|p| p.from_program), 2)];
    let overlap = vec![Series::line(words("cli-draw-overlap"), overlap).coloured(3)];
    let confidence = vec![dots("cli-draw-raw-points", over(&|p| p.confidence), 2)];
    vec![
        chart("cli-draw-from-nominal", "cli-draw-distance", "mm", beside),
        Chart {
            limits: vec![LimitLine::new(words("cli-draw-tolerance"), report.tolerance)],
            ..chart("cli-draw-raw-from-program", "cli-draw-distance", "mm", from_program)
        },
        chart("cli-draw-frame-against-frame", "cli-draw-distance", "mm", overlap),
        Chart {
            y_range: Some((0.0, 1.05)),
            ..chart("cli-draw-confidence-title", "cli-draw-confidence", "", confidence)
        },
    ]
}
