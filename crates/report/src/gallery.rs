use crate::glyph::closed;
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::lines;
use crate::{Drawing, Language};
use seamwright_message::Message;

/// Height of a line of text above a section, px.
const LINE: f64 = 18.0;
/// Size of that text, px.
const TEXT: f64 = 12.0;
/// Room between sections, px.
const GAP: f64 = 14.0;
/// Margin around a drawing, px.
const ROOM: f64 = 10.0;
/// Ratio of height to width of a section's drawing.
const TALL: f64 = 0.72;

/// Cross-sections side by side, at one scale, as macro-sections in a welding handbook.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gallery {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading; may be empty.
    pub title: String,
    /// The sections.
    pub sections: Vec<SectionDrawing>,
}

/// One cross-section, mm, y up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SectionDrawing {
    /// Title: the position along the seam.
    pub title: String,
    /// A line below the title.
    pub note: String,
    /// A line about the torch; may be empty.
    pub torch_note: String,
    /// Outlines of the parts.
    pub parts: Vec<Vec<[f64; 2]>>,
    /// The groove, from toe to toe around.
    pub groove: Vec<[f64; 2]>,
    /// Beads in the order of welding.
    pub beads: Vec<DrawnBead>,
    /// The consumable insert before it is fused; empty without one.
    pub insert: Vec<[f64; 2]>,
    /// Wire target in each bead, or at the seam, and the direction back to the torch.
    pub torches: Vec<([f64; 2], [f64; 2])>,
}

/// A bead of a cross-section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DrawnBead {
    /// Its number, written into it.
    pub number: usize,
    /// Its outline, mm.
    pub outline: Vec<[f64; 2]>,
    /// Number of its colour, from 1.
    pub colour: usize,
}

impl SectionDrawing {
    /// Returns the bounds of the groove and the beads, with room for the parts beside them.
    fn extent(&self) -> ([f64; 2], [f64; 2]) {
        let points = self.groove.iter().chain(self.beads.iter().flat_map(|bead| &bead.outline));
        let grow = |(low, high): ([f64; 2], [f64; 2]), p: &[f64; 2]| {
            ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
        };
        let (low, high) = points.fold(([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]), grow);
        let more = 0.35 * (high[0] - low[0]).max(high[1] - low[1]);
        ([low[0] - more, low[1] - more], [high[0] + more, high[1] + more])
    }

    fn middle(&self) -> [f64; 2] {
        let (low, high) = self.extent();
        [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])]
    }
}

impl Gallery {
    fn columns(&self) -> usize {
        match self.sections.len() {
            0 | 1 => 1,
            2 | 4 => 2,
            _ => 3,
        }
    }
}

impl Drawing for Gallery {
    fn label(&self) -> String {
        let message = Message::new("report-sections").text("title", &self.title).count("n", self.sections.len());
        message.in_language(self.language)
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let columns = self.columns();
        let w = (WIDTH - GAP * (columns as f64 - 1.0)) / columns as f64;
        let h = if columns == 1 { 0.5 * w } else { TALL * w };
        // One scale for all sections, px per mm.
        let scale = self.sections.iter().map(SectionDrawing::extent).fold(f64::INFINITY, |scale, (low, high)| {
            let fits = ((w - 2.0 * ROOM) / (high[0] - low[0])).min((h - 2.0 * ROOM) / (high[1] - low[1]));
            scale.min(fits)
        });
        let top = if self.title.is_empty() { 0.0 } else { 26.0 };
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        let heads: Vec<Vec<Caption>> = self.sections.iter().map(|section| section.captions(w)).collect();
        // Sections of a row stand side by side.
        let head = LINE * heads.iter().map(Vec::len).max().unwrap_or(0) as f64 + ROOM;
        let mut bottom = top;
        for (i, section) in self.sections.iter().enumerate() {
            let x = (i % columns) as f64 * (w + GAP);
            let y = top + (i / columns) as f64 * (head + h + GAP);
            for (line, caption) in (1..).zip(&heads[i]) {
                svg.text(caption.class, x, y + LINE * f64::from(line) - 2.0, Anchor::Start, &caption.text);
            }
            let frame = Rect { x, y: y + head, w, h };
            if scale.is_finite() {
                section.draw(&mut svg, frame, scale, self.language);
            }
            bottom = y + head + h;
        }
        (svg, bottom + 1.0)
    }
}

/// A line of text above a section.
struct Caption {
    class: &'static str,
    text: String,
}

impl SectionDrawing {
    /// Returns title and notes in lines of at most `room` px.
    fn captions(&self, room: f64) -> Vec<Caption> {
        let texts = [("head", &self.title), ("quiet", &self.note), ("quiet", &self.torch_note)];
        let lines = texts
            .into_iter()
            .flat_map(|(class, text)| lines(text, TEXT, room).into_iter().map(move |text| Caption { class, text }));
        lines.collect()
    }

    fn draw(&self, svg: &mut Svg, frame: Rect, scale: f64, language: Language) {
        let middle = self.middle();
        let place = |p: &[f64; 2]| {
            let (x, y) = (scale * (p[0] - middle[0]), scale * (p[1] - middle[1]));
            (frame.x + 0.5 * frame.w + x, frame.y + 0.5 * frame.h - y)
        };
        let outline = |points: &[[f64; 2]]| closed(&points.iter().map(place).collect::<Vec<_>>());
        svg.rect("area", frame);
        svg.clipped(frame, |svg| {
            for part in &self.parts {
                svg.path("metal", &outline(part));
            }
            svg.path("groove", &outline(&self.groove));
            for bead in &self.beads {
                svg.path(&format!("bead f{}", bead.colour), &outline(&bead.outline));
            }
            for bead in &self.beads {
                svg.path("bead-edge", &outline(&bead.outline));
            }
            if !self.insert.is_empty() {
                svg.path("insert", &outline(&self.insert));
            }
            let long = 0.09 * frame.w;
            for (tip, back) in &self.torches {
                let (x, y) = place(tip);
                svg.line("wire", x, y, x + long * back[0], y - long * back[1]);
                svg.circle("wire-tip", x, y, 2.0);
            }
            for bead in &self.beads {
                let (x, y) = place(&centroid(&bead.outline));
                svg.text("bead-number", x, y + 4.0, Anchor::Middle, &bead.number.to_string());
            }
        });
        svg.rect("edge", frame);
        svg.scale_bar(frame, scale, language);
    }
}

/// Returns the centroid of a polygon's area, or of its corners if the area is zero.
fn centroid(points: &[[f64; 2]]) -> [f64; 2] {
    let (mut area, mut sum, mut plain) = (0.0, [0.0; 2], [0.0; 2]);
    let from = points.first().copied().unwrap_or_default();
    for (i, p) in points.iter().enumerate() {
        let q = points[(i + 1) % points.len()];
        let (a, b) = ([p[0] - from[0], p[1] - from[1]], [q[0] - from[0], q[1] - from[1]]);
        let cross = a[0] * b[1] - a[1] * b[0];
        area += cross;
        (0..2).for_each(|k| sum[k] += cross * (a[k] + b[k]) / 3.0);
        (0..2).for_each(|k| plain[k] += a[k] / points.len() as f64);
    }
    let middle = if area.abs() > 1e-12 { sum.map(|s| s / area) } else { plain };
    [from[0] + middle[0], from[1] + middle[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64, y: f64, side: f64) -> Vec<[f64; 2]> {
        vec![[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
    }

    fn bead(number: usize, x: f64, y: f64, colour: usize) -> DrawnBead {
        DrawnBead { number, outline: square(x, y, 5.0), colour }
    }

    #[test]
    fn centroids_are_those_of_areas() {
        let c = centroid(&square(3.0, -1.0, 2.0));
        assert!((c[0] - 4.0).abs() < 1e-12 && c[1].abs() < 1e-12);
        assert!(centroid(&[[2.0, 5.0]]).map(f64::to_bits) == [2.0, 5.0].map(f64::to_bits));
    }

    #[test]
    fn drawings_are_well_formed() {
        let section = SectionDrawing {
            title: "s = 10 < 20 mm".to_owned(),
            note: "90 degrees".to_owned(),
            torch_note: "work angle 5 degrees".to_owned(),
            parts: vec![square(0.0, 0.0, 20.0), square(-20.0, 0.0, 20.0)],
            groove: square(-5.0, -10.0, 10.0),
            insert: Vec::new(),
            beads: vec![bead(1, -5.0, -10.0, 1), bead(4, 0.0, -5.0, 3)],
            torches: vec![([0.0, -10.0], [0.0, 1.0])],
        };
        for n in [0, 1, 2, 7] {
            let gallery =
                Gallery { title: "Beads".to_owned(), sections: vec![section.clone(); n], ..Gallery::default() };
            for svg in [gallery.to_svg(), gallery.to_svg_standalone()] {
                let document = roxmltree::Document::parse(&svg).unwrap();
                let numbers = document.descendants().filter(|e| e.attribute("class") == Some("bead-number"));
                assert_eq!(numbers.count(), 2 * n);
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            }
        }
    }
}
