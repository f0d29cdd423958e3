use crate::domain::Domain;
use crate::glyph::{Point, closed};
use crate::number::quantity;
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::{fit, width};
use crate::ticks::Ticks;
use crate::{Drawing, Language, Words as _};
use seamwright_message::{Message, Unit};

/// Height of title and key above the drawing, px.
const HEAD: f64 = 44.0;
/// Room for the angles above the rows and for path lengths below them, px.
const SCALE: f64 = 22.0;
/// Width of the names left of the rows, px.
const NAMES: f64 = 176.0;
/// Room right of the rows for half a label, px.
const RIGHT: f64 = 18.0;
/// Maximum and minimum height of a row, px.
const ROW: (f64, f64) = (24.0, 9.0);
/// Maximum height of all rows, px: a printed page with head and caption.
const TALLEST: f64 = 760.0;
/// Ratio of a bar's height to that of its row.
const BAR: f64 = 0.62;

/// The weld unrolled: path length along the seam to the right, a row for each bead in the order of welding, and in it
/// the pieces in which the bead is welded, each with start, stop and direction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WeldMap {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// A line below it.
    pub key: String,
    /// Length of the seam, mm.
    pub length_mm: f64,
    /// True if the seam comes round: a piece that leaves it at the end goes on at the start.
    pub round: bool,
    /// Marks above the rows: path length in mm and label.
    pub marks: Vec<(f64, String)>,
    /// The rows, the first at the top.
    pub rows: Vec<MapRow>,
}

/// A row of a [`WeldMap`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapRow {
    /// Name of the bead.
    pub name: String,
    /// Colour number, from 1 to 3.
    pub colour: usize,
    /// The pieces in the order of welding.
    pub pieces: Vec<MapPiece>,
}

/// A piece of a row, welded in one go.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapPiece {
    /// Path length on the seam at which it starts, mm; outside the seam on a round one.
    pub start_mm: f64,
    /// Path length on the seam at which it stops, mm; less than the start if it is welded backwards.
    pub stop_mm: f64,
    /// Number of its pass.
    pub label: String,
}

impl MapPiece {
    /// Returns the parts of the piece on the seam, from its start on: each in the direction of welding.
    fn parts(&self, length: f64, round: bool) -> Vec<(f64, f64)> {
        let (low, high) = (self.start_mm.min(self.stop_mm), self.start_mm.max(self.stop_mm));
        if !round || length <= 0.0 {
            return vec![(self.start_mm, self.stop_mm)];
        }
        let first = (low / length).floor();
        // A piece ends on a border of the seam, not behind it.
        let count = ((high / length - 1e-9).floor() - first).max(0.0) as usize + 1;
        let part = |k: usize| {
            let from = (first + k as f64) * length;
            (low.max(from) - from, high.min(from + length) - from)
        };
        let parts = (0..count).map(part);
        if self.stop_mm < self.start_mm { parts.rev().map(|(a, b)| (b, a)).collect() } else { parts.collect() }
    }
}

impl WeldMap {
    fn row_height(&self) -> f64 {
        (TALLEST / self.rows.len().max(1) as f64).clamp(ROW.1, ROW.0)
    }

    fn draw_scales(&self, svg: &mut Svg, frame: Rect, x: &dyn Fn(f64) -> f64) {
        for (s, label) in &self.marks {
            svg.line("grid", x(*s), frame.y, x(*s), frame.bottom());
            svg.line("symbol", x(*s), frame.y - 4.0, x(*s), frame.y);
            svg.text("tick", x(*s), frame.y - 7.0, Anchor::Middle, label);
        }
        let ticks = Ticks::new(Domain { lo: 0.0, hi: self.length_mm }, 8);
        for s in &ticks.values {
            svg.line("symbol", x(*s), frame.bottom(), x(*s), frame.bottom() + 4.0);
        }
        let labels = ticks.labels_in(self.language);
        let labels = ticks.values.iter().zip(labels);
        svg.ticks(frame.bottom() + 16.0, labels.map(|(s, label)| (x(*s), label)));
        let unit = format!("s, {}", self.language.symbol(Unit::Mm));
        svg.text("tick", frame.x - 12.0, frame.bottom() + 16.0, Anchor::End, &unit);
    }
}

impl Drawing for WeldMap {
    fn label(&self) -> String {
        let message = Message::new("report-map-label").text("title", &self.title).count("n", self.rows.len());
        message.message("length", quantity(self.length_mm, Unit::Mm, 5)).in_language(self.language)
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        svg.text("quiet", 0.0, 33.0, Anchor::Start, &self.key);
        if self.length_mm.is_nan() || self.length_mm <= 0.0 {
            return (svg, HEAD);
        }
        let high = self.row_height();
        let frame =
            Rect { x: NAMES, y: HEAD + SCALE, w: WIDTH - NAMES - RIGHT, h: high * self.rows.len().max(1) as f64 };
        let x = |s: f64| frame.x + frame.w * (s / self.length_mm).clamp(0.0, 1.0);
        svg.rect("area", frame);
        self.draw_scales(&mut svg, frame, &x);
        for (i, row) in self.rows.iter().enumerate() {
            let middle = frame.y + (i as f64 + 0.5) * high;
            if i > 0 {
                svg.line("grid", frame.x, middle - 0.5 * high, frame.right(), middle - 0.5 * high);
            }
            svg.text("tick", frame.x - 8.0, middle + 4.0, Anchor::End, &fit(&row.name, 11.0, NAMES - 12.0));
            for piece in &row.pieces {
                let parts = piece.parts(self.length_mm, self.round);
                let ends: Vec<(f64, f64)> = parts.iter().map(|(from, to)| (x(*from), x(*to))).collect();
                draw_piece(&mut svg, &ends, middle, BAR * high, row.colour, &piece.label);
            }
        }
        svg.rect("edge", frame);
        (svg, frame.bottom() + SCALE)
    }
}

/// Draws the parts of a piece as bars: a dot where it starts, a stroke where it stops, an arrow and the number of the
/// pass in the middle of the longest.
fn draw_piece(svg: &mut Svg, parts: &[(f64, f64)], y: f64, high: f64, colour: usize, label: &str) {
    let half = 0.5 * high;
    for &(from, to) in parts {
        let bar = Rect { x: from.min(to), y: y - half, w: (to - from).abs().max(1.0), h: high };
        svg.rect(&format!("stretch s{colour}"), bar);
    }
    let long = |part: &&(f64, f64)| (part.1 - part.0).abs();
    if let Some(&(from, to)) = parts.iter().max_by(|a, b| long(a).total_cmp(&long(b))) {
        let (room, size) = ((to - from).abs(), 0.7 * half);
        let way = if to < from { -1.0 } else { 1.0 };
        let middle = 0.5 * (from + to);
        let words = width(label, 11.0);
        let fits = room > words + 6.0 * size && high > 11.0;
        // The arrow stands beside the number, or alone where there is no room for both.
        let tip = if fits { middle + way * (0.5 * words + 2.0 * size + 3.0) } else { middle + way * size };
        if room > 5.0 * size {
            svg.path(&format!("f{colour}"), &arrow((tip, y), way, size));
        }
        if fits {
            svg.text("tick-strong", middle, y + 4.0, Anchor::Middle, label);
        } else {
            svg.text("tick halo", middle, y - half - 1.5, Anchor::Middle, if high > 11.0 { label } else { "" });
        }
    }
    if let (Some((start, _)), Some((_, stop))) = (parts.first(), parts.last()) {
        svg.line(&format!("line fat c{colour}"), *stop, y - half - 1.0, *stop, y + half + 1.0);
        svg.circle(&format!("f{colour}"), *start, y, (0.42 * high).clamp(2.0, 4.5));
    }
}

/// Returns a triangle with its tip at `tip`, pointing right or (`way` -1) left, as path data.
fn arrow(tip: Point, way: f64, size: f64) -> String {
    let foot = tip.0 - 1.8 * way * size;
    closed(&[tip, (foot, tip.1 - size), (foot, tip.1 + size)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    fn piece(start_mm: f64, stop_mm: f64) -> MapPiece {
        MapPiece { start_mm, stop_mm, label: "5".to_owned() }
    }

    #[test]
    fn a_piece_beyond_the_end_goes_on_at_the_start() {
        assert_eq!(piece(80.0, 110.0).parts(100.0, true), [(80.0, 100.0), (0.0, 10.0)]);
        assert_eq!(piece(10.0, -20.0).parts(100.0, true), [(10.0, 0.0), (100.0, 80.0)]);
        assert_eq!(piece(0.0, 100.0).parts(100.0, true), [(0.0, 100.0)]);
        assert_eq!(piece(20.0, 140.0).parts(100.0, true), [(20.0, 100.0), (0.0, 40.0)]);
        assert_eq!(piece(80.0, 110.0).parts(100.0, false), [(80.0, 110.0)]);
    }

    #[test]
    fn parts_cover_the_length_of_their_piece() {
        let mut random = Random::new(46);
        for _ in 0..5000 {
            let length = random.within(1.0, 5000.0);
            let start = random.within(-2.0, 2.0) * length;
            let stop = start + random.within(-1.5, 1.5) * length;
            let parts = piece(start, stop).parts(length, true);
            let covered: f64 = parts.iter().map(|(from, to)| to - from).sum();
            assert!((covered - (stop - start)).abs() < 1e-6 * length, "{start} {stop} {length} {parts:?}");
            let eps = 1e-9 * length;
            assert!(parts.iter().all(|(a, b)| a.min(*b) >= -eps && a.max(*b) <= length + eps), "{parts:?}");
            // Each part starts where the one before left the seam.
            for pair in parts.windows(2) {
                let gap = (pair[1].0 - pair[0].1).abs();
                assert!((gap - length).abs() < 1e-6 * length, "{parts:?}");
            }
        }
    }

    #[test]
    fn maps_are_well_formed_and_have_a_bar_for_each_part() {
        let row = |n: usize| MapRow {
            name: format!("{n} <root>"),
            colour: 1 + n % 3,
            pieces: vec![piece(80.0, 110.0), piece(10.0, 12.0)],
        };
        for n in [0, 1, 14, 120] {
            let map = WeldMap {
                title: "Map".to_owned(),
                key: "a < b".to_owned(),
                length_mm: 100.0,
                round: true,
                marks: vec![(0.0, "0°".to_owned()), (50.0, "180°".to_owned())],
                rows: (0..n).map(row).collect(),
                ..WeldMap::default()
            };
            for svg in [map.to_svg(), map.to_svg_standalone()] {
                let document = roxmltree::Document::parse(&svg).unwrap();
                let bars = document.descendants().filter(|e| {
                    e.tag_name().name() == "rect" && e.attribute("class").is_some_and(|c| c.starts_with("stretch"))
                });
                assert_eq!(bars.count(), 3 * n);
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            }
        }
        assert!(!WeldMap::default().to_svg().contains("NaN"));
    }
}
