//! A curve in space, drawn in three views.

use crate::layout::{HEAD, Layout, Map, whole};
use crate::legend::{Entry, Legend, ROW};
use crate::place::{self, Size};
use crate::projection::Projection::Pictorial;
use crate::series::{self, Style};
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::{fit, width};
use crate::thin::thin;
use crate::words::Words as _;
use seamwright_message::Language;

/// A named point, such as the start of the weld.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mark {
    /// Name.
    pub label: String,
    /// Position, mm.
    pub at: [f64; 3],
}

/// A path in space with vectors along it, in mm. First-angle projection at one scale shows front (x-z), side (y-z, from
/// the left) and top (x-y), beside a small pictorial view.
///
/// Points with a non-finite coordinate are gaps. Of more than 400 vectors an even selection is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ThreeViews {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading; may be empty.
    pub title: String,
    /// The path.
    pub path: Vec<[f64; 3]>,
    /// The path returns to its first point.
    pub closed: bool,
    /// Name of the path in the legend; may be empty, as may the next two.
    pub path_name: String,
    /// Vectors from base to tip, such as the torch from the seam outward.
    pub vectors: Vec<([f64; 3], [f64; 3])>,
    /// Name of the vectors.
    pub vectors_name: String,
    /// Further polylines, drawn thin: edges of the part.
    pub outlines: Vec<Vec<[f64; 3]>>,
    /// Name of the outlines.
    pub outlines_name: String,
    /// Points with labels.
    pub marks: Vec<Mark>,
}

crate::svg::both_forms!(ThreeViews);

impl ThreeViews {
    fn label(&self) -> String {
        if self.title.is_empty() { self.language.words("report-three-views") } else { self.title.clone() }
    }

    fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        let ends = self.vectors.iter().flat_map(|(a, b)| [*a, *b]);
        let outlines = self.outlines.iter().flatten().copied();
        self.path.iter().copied().chain(ends).chain(outlines).chain(self.marks.iter().map(|m| m.at)).filter(whole)
    }

    fn closed_path(&self) -> Vec<[f64; 3]> {
        let mut path = self.path.clone();
        path.extend(self.path.first().filter(|_| self.closed));
        path
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let title = fit(&self.title, 16.0, WIDTH - 60.0);
        svg.text("title", 0.0, 14.0, Anchor::Start, &title);
        first_angle(&mut svg, WIDTH - 46.0, 9.0);
        let mut top = 26.0;
        let legend = Legend::new(self.entries(), f64::INFINITY, WIDTH);
        legend.draw(&mut svg, 0.0, top + 12.0 - ROW);
        top += legend.height() + if legend.height() > 0.0 { 4.0 } else { 0.0 } + HEAD;

        let layout = Layout::new(self.points(), top);
        for (view, frame) in layout.frames() {
            svg.text("head", frame.x, frame.y - 7.0, Anchor::Start, &self.language.words(view.name()));
            svg.rect("area", frame);
            let map = match view {
                Pictorial => Map::fitting(view, self.points(), frame.inset(26.0)),
                _ => layout.map(view, frame),
            };
            if view != Pictorial {
                layout.draw_axes(&mut svg, &map, frame, self.language);
            }
            svg.rect("edge", frame);
            let ink = self.draw_view(&mut svg, &map, frame);
            if view == Pictorial {
                draw_triad(&mut svg, frame, &ink);
            }
        }
        (svg, layout.bottom())
    }

    fn entries(&self) -> Vec<Entry> {
        let names = [
            ("line fat c1", &self.path_name, self.path.is_empty()),
            ("line thin c2", &self.vectors_name, self.vectors.is_empty()),
            ("line outline", &self.outlines_name, self.outlines.is_empty()),
        ];
        let shown = names.into_iter().filter(|(_, name, missing)| !missing && !name.is_empty());
        shown.map(|(class, name, _)| Entry::Curve { class: class.into(), dots: false, name: name.clone() }).collect()
    }

    /// Draws one view; returns points along all its curves, px.
    fn draw_view(&self, svg: &mut Svg, map: &Map, frame: Rect) -> Vec<(f64, f64)> {
        let polyline = |svg: &mut Svg, class: &str, points: &[[f64; 3]]| {
            series::draw(svg, class, Style::Line, points.iter().map(|p| map.px(*p)));
        };
        for outline in &self.outlines {
            polyline(svg, "line outline", outline);
        }
        let every = self.vectors.len().div_ceil(400).max(1);
        let gap = [f64::NAN; 3];
        let vectors: Vec<[f64; 3]> = self.vectors.iter().step_by(every).flat_map(|(a, b)| [*a, *b, gap]).collect();
        polyline(svg, "line thin c2", &vectors);
        let path = self.closed_path();
        polyline(svg, "line fat c1", &path);

        let mut ink: Vec<(f64, f64)> = Vec::new();
        for curve in [&path, &vectors].into_iter().chain(&self.outlines) {
            for run in thin(curve.iter().map(|p| map.px(*p))) {
                run.windows(2).for_each(|w| sample(&mut ink, w[0], w[1]));
            }
        }
        let marks: Vec<_> = self.marks.iter().filter(|m| whole(&m.at)).map(|m| (m, map.px(m.at))).collect();
        let dot = |(_, p): &(&Mark, (f64, f64))| Rect { x: p.0 - 4.0, y: p.1 - 4.0, w: 8.0, h: 8.0 };
        let mut taken: Vec<Rect> = marks.iter().map(dot).collect();
        for (mark, p) in &marks {
            if map.view != Pictorial {
                let size = Size { w: width(&mark.label, 12.0) + 4.0, h: 15.0 };
                let label = place::beside(*p, size, frame.inset(3.0), &taken, &ink);
                let near = (p.0.clamp(label.x, label.right()), p.1.clamp(label.y, label.bottom()));
                svg.line("leader", p.0, p.1, near.0, near.1);
                svg.text("halo", label.x + 0.5 * label.w, label.y + 11.5, Anchor::Middle, &mark.label);
                taken.push(label);
            }
            svg.circle("mark", p.0, p.1, 3.2);
        }
        ink
    }
}

/// Adds points every 5 px from `a` to `b`.
fn sample(ink: &mut Vec<(f64, f64)>, a: (f64, f64), b: (f64, f64)) {
    let length = (b.0 - a.0).hypot(b.1 - a.1);
    if length < 1e4 {
        let n = (length / 5.0).ceil().max(1.0);
        ink.extend((0..n as u32).map(f64::from).map(|i| (a.0 + (b.0 - a.0) * i / n, a.1 + (b.1 - a.1) * i / n)));
    }
}

/// Draws the directions of the axes in the pictorial view, in the emptiest corner.
fn draw_triad(svg: &mut Svg, frame: Rect, ink: &[(f64, f64)]) {
    let (left, right) = (frame.x + 26.0, frame.right() - 36.0);
    let (top, bottom) = (frame.y + 40.0, frame.bottom() - 24.0);
    let corners = [(left, bottom), (right, bottom), (left, top), (right, top)];
    let near = |(x, y): &(f64, f64)| ink.iter().filter(|p| (p.0 - x).abs() < 36.0 && (p.1 - y).abs() < 36.0).count();
    let (x, y) = corners.into_iter().min_by_key(near).unwrap_or(corners[0]);
    for (axis, name) in [([1.0, 0.0, 0.0], "x"), ([0.0, 1.0, 0.0], "y"), ([0.0, 0.0, 1.0], "z")] {
        let (u, v) = Pictorial.project(axis);
        svg.line("symbol", x, y, x + 20.0 * u, y - 20.0 * v);
        svg.text("tick", x + 28.0 * u, y - 28.0 * v + 4.0, Anchor::Middle, name);
    }
}

/// Draws the symbol of first-angle projection (ISO 5456-2): a cone's frustum, and its view from the left.
pub(crate) fn first_angle(svg: &mut Svg, x: f64, y: f64) {
    svg.path("symbol", &format!("M{x},{}l18,-4v16l-18,-4z", y - 4.0));
    svg.circle("symbol", x + 34.0, y, 8.0);
    svg.circle("symbol", x + 34.0, y, 4.0);
    svg.line("symbol", x - 3.0, y, x + 45.0, y);
}
