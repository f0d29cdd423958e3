//! A curve in space, drawn in three views.

use crate::label_placement::Name;
use crate::layout::{self, HEAD, Layout, Map, TITLE, whole};
use crate::legend::Entry;
use crate::projection::Projection::Pictorial;
use crate::series::{self, Style};
use crate::svg::{Anchor, Rect, Svg};
use crate::thinning::thin;
use crate::{Drawing, Language, Words as _};

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
    /// Name of the path in the legend; may be empty, as may the next.
    pub path_name: String,
    /// Vectors from base to tip, such as the torch from the seam outward.
    pub vectors: Vec<([f64; 3], [f64; 3])>,
    /// Name of the vectors.
    pub vectors_name: String,
    /// Points with labels.
    pub marks: Vec<Mark>,
}

impl ThreeViews {
    fn points(&self) -> impl Iterator<Item = [f64; 3]> {
        let ends = self.vectors.iter().flat_map(|(a, b)| [*a, *b]);
        self.path.iter().copied().chain(ends).chain(self.marks.iter().map(|m| m.at)).filter(whole)
    }

    fn entries(&self) -> Vec<Entry> {
        let names = [
            ("line fat c1", &self.path_name, self.path.is_empty()),
            ("line thin c2", &self.vectors_name, self.vectors.is_empty()),
        ];
        let shown = names.into_iter().filter(|(_, name, missing)| !missing && !name.is_empty());
        shown.map(|(class, name, _)| Entry::Curve { class: class.into(), dots: false, name: name.clone() }).collect()
    }

    /// Draws one view; returns points along all its curves, px.
    fn draw_view(&self, svg: &mut Svg, map: &Map, frame: Rect) -> Vec<(f64, f64)> {
        let polyline = |svg: &mut Svg, class: &str, points: &[[f64; 3]]| {
            series::draw(svg, class, Style::Line, points.iter().map(|p| map.px(*p)));
        };
        let every = self.vectors.len().div_ceil(400).max(1);
        let gap = [f64::NAN; 3];
        let vectors: Vec<[f64; 3]> = self.vectors.iter().step_by(every).flat_map(|(a, b)| [*a, *b, gap]).collect();
        polyline(svg, "line thin c2", &vectors);
        polyline(svg, "line fat c1", &self.path);

        let mut ink: Vec<(f64, f64)> = Vec::new();
        for curve in [&self.path, &vectors] {
            for run in thin(curve.iter().map(|p| map.px(*p))) {
                run.windows(2).for_each(|w| sample(&mut ink, w[0], w[1]));
            }
        }
        let marks: Vec<_> = self.marks.iter().filter(|m| whole(&m.at)).map(|m| (m, map.px(m.at))).collect();
        let mut taken: Vec<Rect> = marks.iter().map(|(_, p)| Rect::around(*p, 4.0)).collect();
        for (mark, p) in &marks {
            if map.view != Pictorial {
                Name { text: &mark.label, at: *p, leader: "leader", near: 0.0 }.write(svg, frame, &mut taken, &ink);
            }
            svg.circle("mark", p.0, p.1, 3.2);
        }
        ink
    }
}

impl Drawing for ThreeViews {
    fn label(&self) -> String {
        if self.title.is_empty() { self.language.words("report-three-views") } else { self.title.clone() }
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let legend = layout::draw_head(&mut svg, &self.title, self.entries());
        let layout = Layout::new(self.points(), TITLE + legend + if legend > 0.0 { 4.0 } else { 0.0 } + HEAD);
        let pictorial = |frame: Rect| Map::fitting(Pictorial, self.points(), frame.inset(26.0));
        layout.draw_views(&mut svg, self.language, pictorial, |svg, map, frame| {
            let ink = self.draw_view(svg, &map, frame);
            if map.view == Pictorial {
                draw_triad(svg, frame, &ink);
            }
        });
        (svg, layout.bottom())
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
