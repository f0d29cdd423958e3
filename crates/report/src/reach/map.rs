use crate::glyph;
use crate::number::significant;
use crate::svg::{Anchor, Rect, Svg};
use crate::text::fit;
use crate::{Drawing, Language, Words as _};
use seamwright_message::{Message, Unit};

/// Height of title and key above the map, px.
const HEAD: f64 = 48.0;
/// Room left of the map for the scale of y, px.
const LEFT: f64 = 64.0;
/// Room below the map for the scale of x, px.
const FOOT: f64 = 40.0;
/// Maximum size of a cell, px.
const CELL: f64 = 64.0;
/// Maximum width and height of the map, px.
const LARGEST: (f64, f64) = (640.0, 560.0);
/// Distance of the key from the map, px.
const KEY: f64 = 28.0;
/// Size of a sample in the key, px.
const SAMPLE: f64 = 16.0;
/// Upper ends of the margins of the shades, as fractions of a range; the last shade has no end.
const SHADES: [f64; 4] = [0.02, 0.05, 0.1, 0.2];

/// A map of placements: a cell for each displacement along x and y, shaded by its margin, or with the reason why it
/// fails.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReachMap {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// A line below it.
    pub key: String,
    /// Displacements of the columns along x, mm, increasing.
    pub columns: Vec<f64>,
    /// Displacements of the rows along y, mm, increasing; the first is at the bottom.
    pub rows: Vec<f64>,
    /// The cells that were judged.
    pub cells: Vec<ReachCell>,
    /// The best placement along x and y, mm.
    pub best: Option<(f64, f64)>,
}

/// A cell of a [`ReachMap`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ReachCell {
    /// Column, from 0.
    pub column: usize,
    /// Row, from 0.
    pub row: usize,
    /// Margin of a weldable placement, as a fraction of a range; none if it fails.
    pub margin: Option<f64>,
    /// Reason of a failure in a word: an axis or a kind.
    pub label: String,
}

impl ReachMap {
    fn frame(&self) -> (Rect, f64) {
        let (columns, rows) = (self.columns.len().max(1) as f64, self.rows.len().max(1) as f64);
        let size = (LARGEST.0 / columns).min(LARGEST.1 / rows).min(CELL);
        (Rect { x: LEFT, y: HEAD, w: size * columns, h: size * rows }, size)
    }

    /// The class of a margin's shade.
    fn shade(margin: f64) -> String {
        format!("heat h{}", 1 + SHADES.iter().filter(|end| margin >= **end).count())
    }

    fn draw_cells(&self, svg: &mut Svg, frame: Rect, size: f64) {
        for cell in &self.cells {
            let x = frame.x + size * cell.column as f64;
            let y = frame.bottom() - size * (cell.row + 1) as f64;
            let rect = Rect { x, y, w: size, h: size };
            let (middle, base) = (x + 0.5 * size, y + 0.5 * size + 4.0);
            match cell.margin {
                Some(margin) => {
                    svg.rect(&Self::shade(margin), rect);
                    let percent = format!("{:.0}", 100.0 * margin);
                    svg.text("tick-strong", middle, base, Anchor::Middle, &fit(&percent, 11.0, size - 2.0));
                }
                None => {
                    svg.rect("band", rect);
                    svg.text("tick", middle, base, Anchor::Middle, &fit(&cell.label, 11.0, size - 2.0));
                }
            }
        }
    }

    fn draw_scales(&self, svg: &mut Svg, frame: Rect, size: f64) {
        let label = |v: &f64| significant(*v, 4, self.language);
        let columns = self.columns.iter().enumerate();
        svg.ticks(frame.bottom() + 16.0, columns.map(|(i, v)| (frame.x + size * (i as f64 + 0.5), label(v))));
        for (i, v) in self.rows.iter().enumerate() {
            let y = frame.bottom() - size * (i as f64 + 0.5) + 4.0;
            svg.text("tick", frame.x - 8.0, y, Anchor::End, &label(v));
        }
        let unit = self.language.symbol(Unit::Mm);
        svg.text("tick", frame.x + 0.5 * frame.w, frame.bottom() + 34.0, Anchor::Middle, &format!("x, {unit}"));
        svg.text("tick", 0.0, frame.y + 10.0, Anchor::Start, &format!("y, {unit}"));
    }

    /// Draws the present placement as a cross, and the best one as a ring.
    fn draw_marks(&self, svg: &mut Svg, frame: Rect, size: f64) {
        let place = |values: &[f64], at: f64| match values {
            [first, .., last] => {
                let part = (at - first) / (last - first);
                (0.0..=1.0).contains(&part).then_some(size * (0.5 + part * (values.len() - 1) as f64))
            }
            _ => Some(0.5 * size),
        };
        let px =
            |at: (f64, f64)| Some((frame.x + place(&self.columns, at.0)?, frame.bottom() - place(&self.rows, at.1)?));
        if let Some((x, y)) = px((0.0, 0.0)) {
            svg.path("line fat c6", &glyph::cross(x, y, 0.3 * size.min(40.0)));
        }
        if let Some((x, y)) = self.best.and_then(px) {
            svg.circle("leader", x, y, 0.42 * size.min(40.0));
            svg.circle("line fat c1", x, y, 0.36 * size.min(40.0));
        }
    }

    fn draw_key(&self, svg: &mut Svg, frame: Rect) {
        let x = frame.right() + KEY;
        let mut y = frame.y;
        let mut row = |svg: &mut Svg, draw: &dyn Fn(&mut Svg, Rect), words: &str| {
            draw(svg, Rect { x, y, w: SAMPLE, h: SAMPLE });
            svg.text("tick", x + SAMPLE + 8.0, y + 12.0, Anchor::Start, words);
            y += SAMPLE + 6.0;
        };
        let percent = |part: f64| significant(100.0 * part, 3, self.language);
        for i in (0..=SHADES.len()).rev() {
            let words = match SHADES.get(i) {
                Some(end) => {
                    let low = if i == 0 { 0.0 } else { SHADES[i - 1] };
                    Message::new("report-reach-shade").text("from", percent(low)).text("to", percent(*end))
                }
                None => Message::new("report-reach-shade-above").text("from", percent(SHADES[i - 1])),
            };
            let class = format!("heat h{}", i + 1);
            row(svg, &|svg, rect| svg.rect(&class, rect), &words.in_language(self.language));
        }
        let centre = |r: Rect| (r.x + 0.5 * r.w, r.y + 0.5 * r.h);
        row(svg, &|svg, rect| svg.rect("band", rect), &self.language.words("report-reach-fails"));
        let cross = |svg: &mut Svg, r: Rect| svg.path("line fat c6", &glyph::cross(centre(r).0, centre(r).1, 6.0));
        row(svg, &cross, &self.language.words("report-reach-present"));
        let ring = |svg: &mut Svg, r: Rect| svg.circle("line fat c1", centre(r).0, centre(r).1, 7.0);
        row(svg, &ring, &self.language.words("report-reach-best"));
    }
}

impl Drawing for ReachMap {
    fn label(&self) -> String {
        Message::new("report-reach-label").text("title", &self.title).in_language(self.language)
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        svg.text("quiet", 0.0, 33.0, Anchor::Start, &self.key);
        let (frame, size) = self.frame();
        svg.rect("area", frame);
        self.draw_cells(&mut svg, frame, size);
        for i in 1..self.columns.len() {
            let x = frame.x + size * i as f64;
            svg.line("grid", x, frame.y, x, frame.bottom());
        }
        for i in 1..self.rows.len() {
            let y = frame.y + size * i as f64;
            svg.line("grid", frame.x, y, frame.right(), y);
        }
        svg.rect("edge", frame);
        self.draw_scales(&mut svg, frame, size);
        self.draw_marks(&mut svg, frame, size);
        self.draw_key(&mut svg, frame);
        // The key has eight rows.
        let key = 8.0 * (SAMPLE + 6.0);
        (svg, HEAD + frame.h.max(key) + FOOT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_has_a_rectangle_for_each_cell() {
        let cell = |column, margin| ReachCell { column, row: 0, margin, label: "j3".into() };
        let map = ReachMap {
            title: "Reach".into(),
            columns: vec![-10.0, 0.0, 10.0],
            rows: vec![0.0],
            cells: vec![cell(0, Some(0.31)), cell(1, Some(0.07)), cell(2, None)],
            best: Some((-10.0, 0.0)),
            ..ReachMap::default()
        };
        let svg = map.to_svg();
        // One of each shade is in the key.
        assert_eq!(svg.matches("heat h5").count(), 2);
        assert_eq!(svg.matches("heat h3").count(), 2);
        assert_eq!(svg.matches("heat h4").count(), 1);
        assert!(svg.contains(">j3<") && svg.contains(">31<"), "{svg}");
    }
}
