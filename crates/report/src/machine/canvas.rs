//! One view of a machine: symbols, moved apart where they would overlap, then names.

use super::drawing::{DrawnAxis, MachineDrawing, along};
use crate::Words as _;
use crate::glyph::{self, Point, Seen, distance, shifted, unit};
use crate::label_placement::Name;
use crate::layout::Map;
use crate::svg::{Anchor, Rect, Svg};

/// Minimum in-plane part of a direction; below it the symbol points towards or away from the viewer.
const OUT_OF_PLANE: f64 = 0.35;
/// Minimum length of a linear axis' arrow, px.
const SHORTEST: f64 = 34.0;
/// Length of a beam, px.
const BEAM: f64 = 44.0;
/// Half length of a rotary axis' centre line, px.
const CENTRE_LINE: f64 = 30.0;
/// Radius of a turn's ring, px.
const RING: f64 = 15.0;
/// Distance of parallel bars, px.
const APART: f64 = 11.0;
/// Radius of the symbols for towards and away, px.
const DOT: f64 = 6.5;
const ARROW: f64 = 11.0;

pub(super) struct Canvas<'a> {
    svg: &'a mut Svg,
    map: Map,
    frame: Rect,
    /// Names to draw, each with its position and colour (0: none).
    labels: Vec<(String, Point, u8)>,
    taken: Vec<Rect>,
    ink: Vec<Point>,
    bars: Vec<(Point, Point)>,
    dots: Vec<Point>,
    rings: Vec<(Point, f64)>,
}

impl<'a> Canvas<'a> {
    pub(super) fn new(svg: &'a mut Svg, map: Map, frame: Rect) -> Self {
        let (labels, taken, ink) = (Vec::new(), Vec::new(), Vec::new());
        Self { svg, map, frame, labels, taken, ink, bars: Vec::new(), dots: Vec::new(), rings: Vec::new() }
    }

    pub(super) fn draw(&mut self, drawing: &MachineDrawing) {
        for line in drawing.outlines.iter().chain(&drawing.links) {
            let points: Vec<Point> = line.iter().map(|p| self.map.px(*p)).collect();
            self.svg.path("line outline", &glyph::polyline(&points));
            points.windows(2).for_each(|w| self.note(w[0], w[1]));
        }
        // Beams end at their torch tips, and bars keep off them. Bars are drawn first, below rings, beams and marks.
        for (_, tip, direction) in &drawing.heads {
            self.bars.extend(self.beam_line(*tip, *direction));
        }
        let (rotary, linear): (Vec<&DrawnAxis>, Vec<&DrawnAxis>) = drawing.axes.iter().partition(|a| a.rotary);
        linear.into_iter().for_each(|axis| self.linear(axis));
        rotary.into_iter().for_each(|axis| self.rotary(axis));
        for (name, tip, direction) in &drawing.heads {
            self.beam(name, *tip, *direction);
        }
        self.origins(drawing);
        self.corners(drawing);
        self.names();
    }

    fn seen(&self, direction: [f64; 3]) -> Seen {
        let (u, v) = self.map.view.project(direction);
        let t = self.map.view.toward();
        (u, v, (0..3).map(|i| t[i] * direction[i]).sum())
    }

    /// Adds a line to the ink that names avoid.
    fn note(&mut self, a: Point, b: Point) {
        let n = ((b.0 - a.0).hypot(b.1 - a.1) / 5.0).ceil().clamp(1.0, 400.0);
        let part = |i: u32| (a.0 + (b.0 - a.0) * f64::from(i) / n, a.1 + (b.1 - a.1) * f64::from(i) / n);
        self.ink.extend((0..=n as u32).map(part));
    }

    fn colour(axis: &DrawnAxis) -> u8 {
        if axis.moves_work { 2 } else { 1 }
    }

    fn linear(&mut self, axis: &DrawnAxis) {
        let seen = self.seen(axis.direction);
        let at = self.map.px(axis.at);
        let colour = Self::colour(axis);
        if seen.0.hypot(seen.1) < OUT_OF_PLANE {
            let p = self.free_dot(at);
            self.dot(p, colour, seen.2 > 0.0);
            self.labels.push((axis.label.clone(), p, colour));
            return;
        }
        let way = unit((seen.0, -seen.1));
        let mut ends = [axis.stroke.0, axis.stroke.1].map(|by| self.map.px(along(axis.at, axis.direction, by)));
        let length = (ends[1].0 - ends[0].0) * way.0 + (ends[1].1 - ends[0].1) * way.1;
        if length < SHORTEST {
            let middle = (0.5 * (ends[0].0 + ends[1].0), 0.5 * (ends[0].1 + ends[1].1));
            ends = [-0.25, 0.75].map(|part| shifted(middle, way, part * SHORTEST));
        }
        let room = self.frame.inset(14.0);
        let (inside, cut) = clipped(ends, room);
        let by = self.free_bar(inside, way);
        let across = (-way.1, way.0);
        let [low, high] = inside.map(|p| shifted(p, across, by));
        self.bars.push((low, high));
        self.svg.line(&format!("bar c{colour}"), low.0, low.1, high.0, high.1);
        let neck = shifted(high, way, -0.8 * ARROW);
        self.svg.line(&format!("line c{colour}"), low.0, low.1, neck.0, neck.1);
        self.svg.path(&format!("f{colour}"), &glyph::arrow_head(high, way, ARROW));
        for (end, sense, was_cut) in [(low, 1.0, cut[0]), (high, -1.0, cut[1])] {
            if was_cut {
                let at = shifted(end, way, sense * (ARROW + 8.0));
                self.svg.path(&format!("line c{colour}"), &glyph::zigzag(at, way));
            }
        }
        // Current position of the carriage.
        if length >= SHORTEST {
            let here = shifted(at, across, by);
            self.svg.circle(&format!("mark c{colour}"), here.0, here.1, 2.8);
        }
        self.note(low, high);
        self.taken.push(Rect::around(shifted(high, way, -5.0), 6.0));
        self.labels.push((axis.label.clone(), shifted(high, way, -3.0), colour));
    }

    fn rotary(&mut self, axis: &DrawnAxis) {
        let seen = self.seen(axis.direction);
        let at = self.map.px(axis.at);
        let colour = Self::colour(axis);
        let flat = seen.0.hypot(seen.1);
        let mut centre = at;
        if flat >= OUT_OF_PLANE {
            let way = unit((seen.0, -seen.1));
            let half = CENTRE_LINE * flat;
            // Towards the positive end, clear of other rings on the axis.
            centre = shifted(at, way, 0.6 * half);
            while self.rings.iter().any(|r| distance(r.0, centre) < 14.0) {
                centre = shifted(centre, way, 14.0);
            }
            let (a, b) = (shifted(at, way, -half), shifted(centre, way, 0.8 * half));
            self.svg.line(&format!("centre c{colour}"), a.0, a.1, b.0, b.1);
            self.note(a, b);
        }
        let mut radius = RING;
        while self.rings.iter().any(|r| distance(r.0, centre) < 10.0 && (r.1 - radius).abs() < 5.0) {
            radius += 8.0;
        }
        self.rings.push((centre, radius));
        let points = glyph::turn(centre, seen, radius);
        let drawn = &points[..points.len() - 2];
        self.svg.path(&format!("line fat c{colour}"), &glyph::polyline(drawn));
        drawn.windows(2).for_each(|w| self.note(w[0], w[1]));
        let tip = points[points.len() - 1];
        let before = points[points.len() - 4];
        self.svg.path(&format!("f{colour}"), &glyph::arrow_head(tip, unit((tip.0 - before.0, tip.1 - before.1)), 10.0));
        if flat < OUT_OF_PLANE {
            self.svg.circle(&format!("mark c{colour}"), centre.0, centre.1, 1.6);
        }
        self.taken.push(Rect::around(tip, 6.0));
        self.labels.push((axis.label.clone(), points[points.len() / 2], colour));
    }

    /// Returns back end and tip of a beam, px; `None` if it points towards or away from the viewer.
    fn beam_line(&self, tip: [f64; 3], direction: [f64; 3]) -> Option<(Point, Point)> {
        let seen = self.seen(direction);
        let flat = seen.0.hypot(seen.1);
        let at = self.map.px(tip);
        (flat >= OUT_OF_PLANE).then(|| (shifted(at, unit((seen.0, -seen.1)), -BEAM * flat), at))
    }

    fn beam(&mut self, name: &str, tip: [f64; 3], direction: [f64; 3]) {
        let Some((back, at)) = self.beam_line(tip, direction) else {
            let p = self.free_dot(self.map.px(tip));
            self.dot(p, 3, self.seen(direction).2 > 0.0);
            self.labels.push((name.to_owned(), p, 3));
            return;
        };
        let way = unit((at.0 - back.0, at.1 - back.1));
        let neck = shifted(at, way, -8.0);
        self.svg.line("line fat c3", back.0, back.1, neck.0, neck.1);
        self.svg.path("f3", &glyph::arrow_head(at, way, ARROW));
        self.note(back, at);
        self.taken.push(Rect::around(shifted(at, way, -5.0), 6.0));
        self.labels.push((name.to_owned(), back, 3));
    }

    fn origins(&mut self, drawing: &MachineDrawing) {
        let (base, work) = (self.map.px([0.0; 3]), self.map.px(drawing.work));
        let together = distance(base, work) < 6.0;
        let [base_name, work_name] =
            ["report-machine-base", "report-machine-work"].map(|code| drawing.language.words(code));
        let marks = match together {
            true => vec![(format!("{base_name}, {work_name}"), base)],
            false => vec![(base_name, base), (work_name, work)],
        };
        for (name, p) in marks {
            self.svg.path("origin", &glyph::polyline(&[(p.0 - 5.0, p.1), (p.0 + 5.0, p.1)]));
            self.svg.path("origin", &glyph::polyline(&[(p.0, p.1 - 5.0), (p.0, p.1 + 5.0)]));
            self.labels.push((name, p, 0));
        }
    }

    /// Draws the directions of the base frame, and up, each in the emptiest remaining corner.
    fn corners(&mut self, drawing: &MachineDrawing) {
        let (left, right) = (self.frame.x + 34.0, self.frame.right() - 34.0);
        let (top, bottom) = (self.frame.y + 36.0, self.frame.bottom() - 34.0);
        let mut places = vec![(left, bottom), (right, bottom), (right, top), (left, top)];
        let mut emptiest = |ink: &[Point]| {
            let near = |c: &Point| ink.iter().filter(|p| (p.0 - c.0).abs() < 42.0 && (p.1 - c.1).abs() < 42.0).count();
            let best = (0..places.len()).min_by_key(|&i| near(&places[i])).unwrap_or(0);
            places.remove(best)
        };
        let (frame, up) = (emptiest(&self.ink), emptiest(&self.ink));
        for (direction, name) in [([1.0, 0.0, 0.0], "x"), ([0.0, 1.0, 0.0], "y"), ([0.0, 0.0, 1.0], "z")] {
            self.compass(frame, direction, name);
        }
        self.compass(up, drawing.up, &drawing.language.words("report-machine-up"));
        self.taken.extend([Rect::around(frame, 34.0), Rect::around(up, 30.0)]);
    }

    fn compass(&mut self, at: Point, direction: [f64; 3], name: &str) {
        let (line, fill) = ("symbol", "symbol-dot");
        let seen = self.seen(direction);
        let flat = seen.0.hypot(seen.1);
        if flat < 0.1 {
            self.svg.circle(line, at.0, at.1, 4.5);
            match seen.2 > 0.0 {
                true => self.svg.circle(fill, at.0, at.1, 1.6),
                false => self.svg.path(line, &glyph::cross(at.0, at.1, 3.2)),
            }
            self.svg.text("tick", at.0 - 9.0, at.1 + 12.0, Anchor::Middle, name);
            return;
        }
        let way = unit((seen.0, -seen.1));
        let tip = shifted(at, way, 21.0 * flat);
        self.svg.line(line, at.0, at.1, tip.0, tip.1);
        self.svg.path(fill, &glyph::arrow_head(tip, way, 6.5));
        let text = shifted(tip, way, 7.0);
        self.svg.text("tick", text.0, text.1 + 4.0, Anchor::Middle, name);
    }

    /// Draws a circle with a dot (towards the viewer) or a cross (away).
    fn dot(&mut self, p: Point, colour: u8, towards: bool) {
        self.svg.circle(&format!("ring c{colour}"), p.0, p.1, DOT);
        match towards {
            true => self.svg.circle(&format!("f{colour}"), p.0, p.1, 2.3),
            false => self.svg.path(&format!("line c{colour}"), &glyph::cross(p.0, p.1, DOT - 0.5)),
        }
        self.dots.push(p);
        self.taken.push(Rect::around(p, DOT + 1.0));
    }

    /// Returns the position nearest to `at` where a circle does not overlap another.
    fn free_dot(&self, at: Point) -> Point {
        let clear = |p: &Point| self.dots.iter().all(|d| distance(*d, *p) > 2.0 * DOT + 2.0);
        let rings = (0..5).flat_map(|ring| {
            let count = if ring == 0 { 1 } else { 8 };
            (0..count).map(move |turn| (f64::from(ring) * (DOT + 2.0), f64::from(turn) * std::f64::consts::FRAC_PI_4))
        });
        rings.map(|(r, turn)| (at.0 + r * turn.cos(), at.1 + r * turn.sin())).find(clear).unwrap_or(at)
    }

    /// Returns the lateral shift of a bar, px, that avoids overlapping another along it.
    fn free_bar(&self, [low, high]: [Point; 2], way: Point) -> f64 {
        let across = (-way.1, way.0);
        let covers = |by: f64| {
            self.bars.iter().any(|(a, b)| {
                let other = unit((b.0 - a.0, b.1 - a.1));
                let parallel = (other.0 * way.1 - other.1 * way.0).abs() < 0.1;
                let to = |p: &Point, d: Point| (p.0 - low.0) * d.0 + (p.1 - low.1) * d.1;
                let beside = (to(a, across) - by).abs() < APART - 1.0;
                let (from, until) = (to(a, way).min(to(b, way)), to(a, way).max(to(b, way)));
                parallel && beside && until > 0.0 && from < distance(low, high)
            })
        };
        let places = [0.0, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0];
        places.map(|k| k * APART).into_iter().find(|by| !covers(*by)).unwrap_or(0.0)
    }

    /// Draws names beside their symbols, with a leader line in crowded places.
    fn names(&mut self) {
        for (name, p, colour) in std::mem::take(&mut self.labels) {
            let name = Name { text: &name, at: p, leader: &format!("lead c{colour}"), near: 12.0 };
            name.write(self.svg, self.frame, &mut self.taken, &self.ink);
        }
    }
}

/// Clips a line to a rectangle and returns which ends were cut; a line outside is unchanged.
fn clipped(ends: [Point; 2], room: Rect) -> ([Point; 2], [bool; 2]) {
    let (dx, dy) = (ends[1].0 - ends[0].0, ends[1].1 - ends[0].1);
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for (d, low, high) in
        [(dx, room.x - ends[0].0, room.right() - ends[0].0), (dy, room.y - ends[0].1, room.bottom() - ends[0].1)]
    {
        if d.abs() > 1e-9 {
            (from, to) = (from.max((low / d).min(high / d)), to.min((low / d).max(high / d)));
        }
    }
    if from >= to {
        return (ends, [false; 2]);
    }
    ([from, to].map(|t| (ends[0].0 + t * dx, ends[0].1 + t * dy)), [from > 1e-9, to < 1.0 - 1e-9])
}
