//! Points, lines, arcs and their ends, seen along the axes.

use glam::DVec3;
use seamwright_geometry::reduce::{Shape, Span};
use seamwright_geometry::{Arc, Curve};
use seamwright_message::Message;
use seamwright_report::{Axis, Chart, Series, Style, sheet};
use std::f64::consts::TAU;

/// Steps in which an arc is drawn, rad.
const STEP: f64 = 0.02;

/// Arms of the crosses at ends, as a part of the drawing.
const CROSS: f64 = 0.015;

/// The sheet: seen along z, and along y and x unless these views are flat.
pub(super) fn draw(points: &[DVec3], spans: &[Span]) -> String {
    let ends: Vec<DVec3> = ends(points, spans);
    sheet(&words("cli-draw-points-as-spans"), &charts(points, &lines_and_arcs(points, spans), &ends))
}

/// Words of a drawing in the language of the process.
pub(in crate::verbs) fn words(code: &'static str) -> String {
    Message::new(code).to_string()
}

pub(in crate::verbs) fn ends(points: &[DVec3], spans: &[Span]) -> Vec<DVec3> {
    spans.iter().map(|s| points[s.first]).chain(points.last().copied()).collect()
}

/// The spans as drawn, by their kind.
pub(in crate::verbs) fn lines_and_arcs(points: &[DVec3], spans: &[Span]) -> Vec<(String, Vec<DVec3>)> {
    let seen = |shape: fn(&Shape) -> bool| -> Vec<DVec3> {
        spans.iter().filter(|s| shape(&s.shape)).flat_map(|s| drawn(points, s)).collect()
    };
    let (lines, arcs) = (seen(|s| *s == Shape::Line), seen(|s| *s != Shape::Line));
    vec![(words("cli-draw-lines"), lines), (words("cli-draw-arcs"), arcs)]
}

/// The charts of the sheet: points, named curves through them, and the ends of these.
pub(in crate::verbs) fn charts(points: &[DVec3], curves: &[(String, Vec<DVec3>)], ends: &[DVec3]) -> Vec<Chart> {
    let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), p| (low.min(*p), high.max(*p)));
    let size = high - low;
    let arm = CROSS * size.max_element();
    let crosses: Vec<DVec3> = ends.iter().flat_map(|end| cross(*end, arm)).collect();
    let chart = |along: &str, (across, up): (usize, usize)| {
        let axis = |i: usize| Axis::new(["x", "y", "z"][i], "mm");
        let flat = |space: &[DVec3]| space.iter().map(|p| (p[across], p[up])).collect();
        Chart {
            title: Message::new("cli-draw-seen-along").text("axis", along).to_string(),
            x: axis(across),
            y: axis(up),
            series: std::iter::once(
                Series::line(words("cli-draw-points"), flat(points)).styled(Style::Points).coloured(2),
            )
            .chain(
                curves.iter().enumerate().map(|(k, (name, curve))| Series::line(name.clone(), flat(curve)).coloured(k)),
            )
            .chain([Series::line(words("cli-draw-ends"), flat(&crosses)).coloured(3)])
            .collect(),
            equal_aspect: true,
            ..Chart::default()
        }
    };
    let mut charts = vec![chart("z", (0, 1))];
    // A plane path is seen whole at once.
    if size.z > 1e-3 * size.max_element() {
        charts.push(chart("y", (0, 2)));
        charts.push(chart("x", (1, 2)));
    }
    charts
}

/// A cross that is visible in every view.
fn cross(at: DVec3, arm: f64) -> [DVec3; 9] {
    let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|way| [at - arm * way, at + arm * way, DVec3::NAN]);
    [x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]]
}

/// A span's points, and a gap after them.
fn drawn(points: &[DVec3], span: &Span) -> Vec<DVec3> {
    let (start, end) = (points[span.first], points[span.last]);
    let mut drawn = vec![start];
    if let Shape::Arc { centre, normal, .. } = span.shape {
        let (from, to) = (start - centre, end - centre);
        let sweep = normal.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(TAU);
        let steps = (sweep / STEP).ceil().max(8.0) as u32;
        if let Ok(arc) = Arc::new(centre, normal, start, sweep) {
            drawn.extend((1..steps).map(|i| arc.point(sweep * f64::from(i) / f64::from(steps))));
        }
    }
    drawn.extend([end, DVec3::NAN]);
    drawn
}
