//! Layout of three views and a pictorial one, and the mapping from space to them.

use crate::domain::{Domain, usable};
use crate::legend::{Entry, Legend, ROW};
use crate::projection::Projection::{self, Front, Pictorial, Side, Top};
use crate::svg::{Anchor, EDGE, Rect, Svg, WIDTH};
use crate::text::fit;
use crate::ticks::Ticks;
use crate::{Language, Words as _};
use seamwright_message::Unit;

/// Height of the title, px.
pub(crate) const TITLE: f64 = 26.0;

/// Height above a view for its name, px.
pub(crate) const HEAD: f64 = 20.0;

/// Height below a view for tick labels and the name of the axis, px.
const FOOT: f64 = 36.0;

const LEFT: f64 = 58.0;
const GUTTER: f64 = 28.0;

/// Maximum height of the views together, px.
const HIGH: f64 = 580.0;

/// Minimum width and height of a view, px.
const MIN_SIZE: [f64; 2] = [190.0, 110.0];

/// Minimum distance of ticks, px.
const TICK: f64 = 42.0;

/// Returns whether the point can be drawn.
pub(crate) fn whole(p: &[f64; 3]) -> bool {
    p.iter().all(|v| usable(*v))
}

/// Maps space to px in one view.
pub(crate) struct Map {
    pub(crate) view: Projection,
    /// Scale, px per mm.
    scale: f64,
    /// Point in the middle of the frame, right and up.
    centre: (f64, f64),
    /// The middle of the frame, px.
    middle: (f64, f64),
}

impl Map {
    pub(crate) fn fitting(view: Projection, points: impl Iterator<Item = [f64; 3]>, frame: Rect) -> Self {
        let (u, v): (Vec<f64>, Vec<f64>) = points.map(|p| view.project(p)).unzip();
        let extent = |values| Domain::of(values).unwrap_or(Domain { lo: 0.0, hi: 0.0 }).settled();
        let (u, v) = (extent(u), extent(v));
        let scale = (frame.w / u.span()).min(frame.h / v.span());
        Self { view, scale, centre: (u.centre(), v.centre()), middle: middle(frame) }
    }

    pub(crate) fn px(&self, p: [f64; 3]) -> (f64, f64) {
        if !whole(&p) {
            return (f64::NAN, f64::NAN);
        }
        let (u, v) = self.view.project(p);
        (self.middle.0 + self.scale * (u - self.centre.0), self.middle.1 - self.scale * (v - self.centre.1))
    }
}

fn middle(r: Rect) -> (f64, f64) {
    (r.x + 0.5 * r.w, r.y + 0.5 * r.h)
}

/// Draws title, symbol of the projection and legend below the title; returns the height of the legend.
pub(crate) fn draw_head(svg: &mut Svg, title: &str, entries: Vec<Entry>) -> f64 {
    svg.text("title", 0.0, 14.0, Anchor::Start, &fit(title, 16.0, WIDTH - 60.0));
    first_angle(svg, WIDTH - 46.0, 9.0);
    let legend = Legend::new(entries, f64::INFINITY, WIDTH);
    legend.draw(svg, 0.0, TITLE + 12.0 - ROW);
    legend.height()
}

/// Draws the symbol of first-angle projection (ISO 5456-2): a cone's frustum, and its view from the left.
fn first_angle(svg: &mut Svg, x: f64, y: f64) {
    svg.path("symbol", &format!("M{x},{}l18,-4v16l-18,-4z", y - 4.0));
    svg.circle("symbol", x + 34.0, y, 8.0);
    svg.circle("symbol", x + 34.0, y, 4.0);
    svg.line("symbol", x - 3.0, y, x + 45.0, y);
}

/// Two columns and two rows: front and side above, top and pictorial below.
pub(crate) struct Layout {
    /// Middle of the object, mm.
    centre: [f64; 3],
    scale: f64,
    widths: [f64; 2],
    heights: [f64; 2],
    top: f64,
}

impl Layout {
    pub(crate) fn new(points: impl Iterator<Item = [f64; 3]>, top: f64) -> Self {
        let points: Vec<_> = points.collect();
        let extent = |i: usize| Domain::of(points.iter().map(|p| p[i])).unwrap_or(Domain { lo: 0.0, hi: 0.0 });
        let extents: [Domain; 3] = std::array::from_fn(extent);
        let widest = extents.iter().map(|e| e.span()).fold(0.0, f64::max);
        let spans = extents.map(|e| 1.1 * e.span().max(0.02 * if widest > 1e-9 { widest } else { 50.0 }));
        let [dx, dy, dz] = spans;
        let room = WIDTH - LEFT - GUTTER - EDGE;
        let pair =
            |room: f64, a: f64, b: f64, least: f64| (room / (a + b)).min((room - least) / a).min((room - least) / b);
        let scale = pair(room, dx, dy, MIN_SIZE[0]).min(pair(HIGH, dz, dy, MIN_SIZE[1]));
        let mut widths = [dx, dy].map(|d| (d * scale).max(MIN_SIZE[0]));
        let spare = room - widths[0] - widths[1];
        widths = widths.map(|w| w + 0.5 * spare);
        Self {
            centre: extents.map(Domain::centre),
            scale,
            widths,
            heights: [dz, dy].map(|d| (d * scale).max(MIN_SIZE[1])),
            top,
        }
    }

    fn frames(&self) -> [(Projection, Rect); 4] {
        let [w1, w2] = self.widths;
        let [h1, h2] = self.heights;
        let (x2, y2) = (LEFT + w1 + GUTTER, self.top + h1 + FOOT + HEAD);
        [
            (Front, Rect { x: LEFT, y: self.top, w: w1, h: h1 }),
            (Side, Rect { x: x2, y: self.top, w: w2, h: h1 }),
            (Top, Rect { x: LEFT, y: y2, w: w1, h: h2 }),
            (Pictorial, Rect { x: x2, y: y2, w: w2, h: h2 }),
        ]
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.top + self.heights[0] + self.heights[1] + HEAD + 2.0 * FOOT
    }

    fn map(&self, view: Projection, frame: Rect) -> Map {
        Map { view, scale: self.scale, centre: view.project(self.centre), middle: middle(frame) }
    }

    /// Draws the frame of each view with its name and axes, and its content by `draw`. `pictorial` maps space to the
    /// frame of the pictorial view.
    pub(crate) fn draw_views(
        &self,
        svg: &mut Svg,
        language: Language,
        pictorial: impl Fn(Rect) -> Map,
        mut draw: impl FnMut(&mut Svg, Map, Rect),
    ) {
        for (view, frame) in self.frames() {
            svg.text("head", frame.x, frame.y - 7.0, Anchor::Start, &language.words(view.name()));
            svg.rect("area", frame);
            let map = if view == Pictorial { pictorial(frame) } else { self.map(view, frame) };
            self.draw_axes(svg, &map, frame, language);
            svg.rect("edge", frame);
            draw(svg, map, frame);
        }
    }

    /// Draws grid, ticks and names of the axes of the view of `map`, in the frame `f`.
    fn draw_axes(&self, svg: &mut Svg, map: &Map, f: Rect, language: Language) {
        let view = map.view;
        let Some((across, up, sign)) = view.axes() else { return };
        let step = TICK / self.scale;
        let half = 0.5 * f.w / self.scale;
        let centre = sign * map.centre.0;
        let ticks = Ticks::spaced(Domain { lo: centre - half, hi: centre + half }, step);
        let at = |v: f64| map.middle.0 + self.scale * (sign * v - map.centre.0);
        for x in ticks.values.iter().map(|v| at(*v)) {
            svg.line("grid", x, f.y, x, f.bottom());
        }
        if view != Front {
            svg.ticks(f.bottom() + 14.0, ticks.values.iter().map(|v| at(*v)).zip(ticks.labels_in(language)));
            let name = format!("{across}, {}", language.symbol(Unit::Mm));
            svg.text("quiet", f.x + 0.5 * f.w, f.bottom() + 30.0, Anchor::Middle, &name);
        }
        let half = 0.5 * f.h / self.scale;
        let ticks = Ticks::spaced(Domain { lo: map.centre.1 - half, hi: map.centre.1 + half }, step);
        for (v, label) in ticks.values.iter().zip(ticks.labels_in(language)) {
            let y = map.middle.1 - self.scale * (v - map.centre.1);
            svg.line("grid", f.x, y, f.right(), y);
            if view != Side {
                svg.text("tick", f.x - 6.0, y + 4.0, Anchor::End, &label);
            }
        }
        if view != Side {
            svg.text("quiet", 0.0, f.y - 7.0, Anchor::Start, &format!("{up}, {}", language.symbol(Unit::Mm)));
        }
    }
}
