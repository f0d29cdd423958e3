use crate::glyph::{Point, closed, distance, polyline, shifted, unit};
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::{Drawing, Language};
use seamwright_message::Message;

/// Height of title and key above the drawing, px.
const HEAD: f64 = 44.0;
/// Margin around the drawing, px.
const ROOM: f64 = 34.0;
/// Maximum height of the drawing, px.
const TALLEST: f64 = 620.0;
/// Distance of a number from its line, px.
const BESIDE: f64 = 12.0;
/// Minimum length of a drawn transfer move, px.
const SHORTEST: f64 = 4.0;
/// Maximum gap of a closed line, as a fraction of its length.
const CLOSED: f64 = 0.1;

/// Lines in a plane in the order of travel: numbered, with arrows, and dashed transfer moves between them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OrderDrawing {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// A line below it.
    pub key: String,
    /// The lines in order.
    pub lines: Vec<OrderedLine>,
}

/// A line of an [`OrderDrawing`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OrderedLine {
    /// Its points, mm to the right and up.
    pub points: Vec<[f64; 2]>,
    /// Centre of the shape that the line goes around or belongs to, mm.
    pub middle: [f64; 2],
    /// The number is on the side away from the middle, and the line is drawn above the others.
    pub outside: bool,
    /// Colour number, from 1 to 3.
    pub colour: usize,
}

impl Drawing for OrderDrawing {
    fn label(&self) -> String {
        let message = Message::new("report-order-lines").text("title", &self.title).count("n", self.lines.len());
        message.in_language(self.language)
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        svg.text("quiet", 0.0, 33.0, Anchor::Start, &self.key);
        let points = || self.lines.iter().flat_map(|line| &line.points);
        if points().next().is_none() {
            return (svg, HEAD);
        }
        let low: [f64; 2] = std::array::from_fn(|k| points().map(|p| p[k]).fold(f64::INFINITY, f64::min));
        let high: [f64; 2] = std::array::from_fn(|k| points().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max));
        let size: [f64; 2] = std::array::from_fn(|k| (high[k] - low[k]).max(1e-6));
        let scale = ((WIDTH - 2.0 * ROOM) / size[0]).min((TALLEST - 2.0 * ROOM) / size[1]);
        let frame = Rect { x: 0.0, y: HEAD, w: WIDTH - 1.0, h: scale * size[1] + 2.0 * ROOM + 14.0 };
        let left = 0.5 * (WIDTH - scale * size[0]);
        let place = |p: &[f64; 2]| (left + scale * (p[0] - low[0]), HEAD + ROOM + scale * (high[1] - p[1]));
        svg.rect("area", frame);
        let lines: Vec<Vec<Point>> = self.lines.iter().map(|line| line.points.iter().map(place).collect()).collect();
        ways(&mut svg, &lines);
        for outside in [false, true] {
            for (line, points) in self.lines.iter().zip(&lines).filter(|(line, _)| line.outside == outside) {
                followed(&mut svg, points, line.colour);
            }
        }
        let places =
            self.lines.iter().zip(&lines).map(|(line, points)| beside(points, place(&line.middle), line.outside));
        numbers(&mut svg, places);
        svg.rect("edge", frame);
        svg.scale_bar(frame, scale, self.language);
        (svg, frame.bottom() + 1.0)
    }
}

/// Draws the transfer move from each line's end to the next one's start.
fn ways(svg: &mut Svg, lines: &[Vec<Point>]) {
    for pair in lines.windows(2) {
        let (Some(&from), Some(&to)) = (pair[0].last(), pair[1].first()) else { continue };
        if distance(from, to) > SHORTEST {
            svg.line("leader dashed", from.0, from.1, to.0, to.1);
            let middle = (0.5 * (from.0 + to.0), 0.5 * (from.1 + to.1));
            svg.path("symbol-dot", &arrow(middle, (to.0 - from.0, to.1 - from.1), 3.5));
        }
    }
}

/// Draws a line with a dot at its start and an arrow in its middle.
fn followed(svg: &mut Svg, points: &[Point], colour: usize) {
    let (Some(first), true) = (points.first(), points.len() > 1) else { return };
    svg.path(&format!("line fat c{colour}"), &polyline(points));
    let k = (points.len() / 2).clamp(1, points.len() - 1);
    let (a, b) = (points[k - 1], points[k]);
    let size = (0.2 * long(points)).clamp(3.0, 6.0);
    svg.path(&format!("f{colour}"), &arrow(b, (b.0 - a.0, b.1 - a.1), size));
    svg.circle(&format!("f{colour}"), first.0, first.1, 3.2);
}

/// Returns a triangle around a point, as path data; empty without a direction.
fn arrow(at: Point, along: Point, size: f64) -> String {
    if along.0.hypot(along.1) < 1e-9 {
        return String::new();
    }
    let way = unit(along);
    let foot = shifted(at, way, -size);
    let side = |by: f64| shifted(foot, (-way.1, way.0), by * 0.8 * size);
    closed(&[shifted(at, way, size), side(1.0), side(-1.0)])
}

/// Returns the position of a line's number: the middle of a closed line, or beside the middle of an open one.
fn beside(points: &[Point], middle: Point, outside: bool) -> Point {
    let (Some(&first), Some(&last)) = (points.first(), points.last()) else { return middle };
    if distance(first, last) < CLOSED * long(points) {
        return middle;
    }
    let at = points[points.len() / 2];
    let away = distance(at, middle);
    // Through its own middle, the line has the number to its left.
    let (x, y) = if away > BESIDE {
        ((middle.0 - at.0) / away, (middle.1 - at.1) / away)
    } else {
        let along = distance(first, last).max(1e-9);
        ((last.1 - first.1) / along, (first.0 - last.0) / along)
    };
    let away = if outside { -1.3 * BESIDE } else { 1.4 * BESIDE };
    (at.0 + away * x, at.1 + away * y)
}

/// Draws numbers from 1, with those of one position together.
fn numbers(svg: &mut Svg, places: impl Iterator<Item = Point>) {
    let mut together: Vec<(Point, Vec<String>)> = Vec::new();
    for (place, number) in places.zip(1..) {
        let number: i32 = number;
        match together.iter_mut().find(|(other, _)| distance(*other, place) < 0.5 * BESIDE) {
            Some((_, numbers)) => numbers.push(number.to_string()),
            None => together.push((place, vec![number.to_string()])),
        }
    }
    for ((x, y), numbers) in together {
        svg.text("head halo", x, y + 4.0, Anchor::Middle, &numbers.join(", "));
    }
}

/// Returns the length of a line.
fn long(points: &[Point]) -> f64 {
    points.windows(2).map(|w| distance(w[0], w[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(x: f64, y: f64) -> OrderedLine {
        let point = |i: i32| [x + f64::from(i).sin(), y + f64::from(i).cos()];
        OrderedLine { points: (0..=6).map(point).collect(), middle: [x, y], outside: false, colour: 1 }
    }

    #[test]
    fn every_line_has_its_number_and_numbers_of_one_place_stand_together() {
        let drawing = |lines| OrderDrawing {
            title: "Order".to_owned(),
            key: "a < b".to_owned(),
            lines,
            ..OrderDrawing::default()
        };
        let texts = |svg: &str| {
            let document = roxmltree::Document::parse(svg).unwrap();
            let heads = document.descendants().filter(|e| e.attribute("class") == Some("head halo"));
            heads.filter_map(|e| e.text().map(str::to_owned)).collect::<Vec<_>>()
        };
        let apart = drawing(vec![ring(0.0, 0.0), ring(5.0, 0.0), ring(5.0, 5.0)]);
        assert_eq!(texts(&apart.to_svg()), ["1", "2", "3"]);
        assert_eq!(apart.to_svg().matches("leader dashed").count(), 2);
        let twice = drawing(vec![ring(0.0, 0.0), ring(5.0, 0.0), ring(0.0, 0.0)]);
        assert_eq!(texts(&twice.to_svg_standalone()), ["1, 3", "2"]);
        for lines in [vec![], vec![OrderedLine::default()]] {
            let svg = drawing(lines).to_svg();
            assert!(roxmltree::Document::parse(&svg).is_ok() && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
    }
}
