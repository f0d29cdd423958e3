//! The methods drawn side by side (ELLIPSE-2015, figures 5 and 6): paths, a piece of them pulse by pulse, speed and
//! distance from the true curve.

use super::Named;
use crate::refusals::of_option;
use crate::verbs::reduce::plot::words;
use glam::DVec3;
use seamwright_interpolators::{Path, Point};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_report::{Axis, Chart, Series, Style, sheet};

/// Pulses shown on each side of the middle of the path in the close view.
const CLOSE_PULSES: f64 = 12.0;
/// Maximum number of points of one method in a drawing.
const MAX_POINTS: usize = 4_000_000;
/// Points of the true curve.
const CURVE: u32 = 2000;

pub(super) fn draw(requests: &[Named]) -> Result<String, Failure> {
    let path = requests[0].interpolate()?.path().clone();
    let flat = |title, series| Chart {
        title: words(title),
        x: Axis::new("x", "mm"),
        y: Axis::new("y", "mm"),
        series,
        equal_aspect: true,
        ..Chart::default()
    };
    let over_angle =
        |title, y| Chart { title: words(title), x: Axis::new(words("cli-draw-angle"), "°"), y, ..Chart::default() };
    let mut charts = [
        flat("cli-draw-paths", vec![true_curve(&path, path.start_rad(), path.end_rad())]),
        flat("cli-draw-close", close(&path, requests)),
        over_angle("cli-draw-steps", Axis::new(words("cli-draw-deviation"), "%")),
        over_angle("cli-draw-max-distance", Axis::new(words("cli-draw-distance"), "µm")),
    ];
    for (place, named) in requests.iter().enumerate() {
        let Named { name, request } = named;
        let points: Vec<Point> = named.interpolate()?.take(MAX_POINTS + 1).collect();
        if points.len() > MAX_POINTS {
            let fault = Message::new("cli-too-many-to-draw").text("method", *name);
            let message = of_option("--svg", fault.number("max", MAX_POINTS as f64, 0));
            return Err(Failure::refused(message, Message::new("cli-coarser-or-no-drawing")));
        }
        // Each method has one colour in all charts; the true curve has the first.
        let series = |points: Vec<(f64, f64)>| Series::line(*name, points).coloured(place + 1);
        charts[0].series.push(series(points.iter().map(|p| (p.position.x, p.position.y)).collect()));
        if request.method.is_pulse() {
            let close = near_middle(&path, &points, request.pulse_mm);
            charts[1].series.push(series(close));
        }
        charts[2].series.push(series(chords(&path, &points, request.period_s, request.step_mm())));
        charts[3].series.push(series(greatest_distances(&path, &points)));
    }
    let shown: Vec<Chart> = charts.into_iter().filter(|c| c.series.iter().any(|s| s.points.len() > 1)).collect();
    Ok(sheet(&words("cli-draw-interpolation"), &shown))
}

/// Angle gone since the start, degrees.
fn travelled(path: &Path, p: &Point) -> f64 {
    (p.u_rad - path.start_rad()).abs().to_degrees()
}

fn true_curve(path: &Path, from: f64, to: f64) -> Series {
    let points = (0..=CURVE).map(|i| path.point(from + (to - from) * f64::from(i) / f64::from(CURVE)));
    Series::line(words("cli-draw-true-curve"), points.map(|p| (p.x, p.y)).collect()).styled(Style::Dashed)
}

/// The true curve around the middle of the path, where the pulse methods are shown.
fn close(path: &Path, requests: &[Named]) -> Vec<Series> {
    let pulses = requests.iter().find(|n| n.request.method.is_pulse()).map(|n| n.request.pulse_mm);
    let half = pulses.map_or(0.0, |pulse| angle_of(path, CLOSE_PULSES * pulse));
    let middle = 0.5 * (path.start_rad() + path.end_rad());
    if half > 0.0 { vec![true_curve(path, middle - half, middle + half)] } else { Vec::new() }
}

/// The angle that a distance along the path takes at its middle, rad.
fn angle_of(path: &Path, distance: f64) -> f64 {
    let middle = 0.5 * (path.start_rad() + path.end_rad());
    let h = 1e-6;
    distance * h / path.point(middle + h).distance(path.point(middle))
}

fn near_middle(path: &Path, points: &[Point], pulse: f64) -> Vec<(f64, f64)> {
    let middle: DVec3 = path.point(0.5 * (path.start_rad() + path.end_rad()));
    let near = points.iter().map(|p| p.position).filter(|p| p.distance(middle) < CLOSE_PULSES * pulse);
    near.map(|p| (p.x, p.y)).collect()
}

/// Deviation (%) of the distance between positions a period apart from `step`, by angle travelled.
fn chords(path: &Path, points: &[Point], period: f64, step: f64) -> Vec<(f64, f64)> {
    let mut rows = Vec::new();
    let Some(mut before) = points.first() else { return rows };
    let (mut sample, mut current) = (1.0, before);
    for p in points {
        // A pulse method stays where it is between two pulses.
        while p.t_s > sample * period * (1.0 + 1e-12) {
            rows.push((travelled(path, current), 100.0 * (current.position.distance(before.position) / step - 1.0)));
            before = current;
            sample += 1.0;
        }
        current = p;
    }
    rows
}

/// Number of points at which the distance from the true curve is drawn.
const PLACES: usize = 240;

/// Maximum distance (um) of the points from the true curve within each part of the path, by angle travelled.
fn greatest_distances(path: &Path, points: &[Point]) -> Vec<(f64, f64)> {
    let width = path.span_rad().to_degrees() / PLACES as f64;
    let mut greatest = vec![None; PLACES];
    for p in points {
        let place = ((travelled(path, p) / width) as usize).min(PLACES - 1);
        let distance = 1000.0 * path.nearest(p.position).distance_mm;
        greatest[place] = Some(greatest[place].map_or(distance, |g: f64| g.max(distance)));
    }
    let middle = |place: usize| (place as f64 + 0.5) * width;
    greatest.iter().enumerate().filter_map(|(place, g)| g.map(|g| (middle(place), g))).collect()
}
