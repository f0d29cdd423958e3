use crate::domain::Domain;
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::fit;
use crate::ticks::Ticks;
use crate::{Axis, Drawing, Language};

/// Height of a row, px, and of the bar in it.
const ROW: f64 = 26.0;
const BAR: f64 = 16.0;
/// Height of the heading, px, and room below for the axis.
const HEAD: f64 = 26.0;
const FOOT: f64 = 40.0;
/// Width of the names, px, and of the notes.
const NAMES: f64 = 190.0;
const NOTES: f64 = 190.0;

/// Effects of quantities on a figure: a bar from its value at the low end of each to that at the high end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tornado {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// The figure.
    pub axis: Axis,
    /// Its value without any of the effects.
    pub nominal: f64,
    /// The quantities, the one with the largest effect first.
    pub rows: Vec<TornadoRow>,
}

/// The effect of one quantity.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TornadoRow {
    /// Its name.
    pub name: String,
    /// The figure at its low end; `None` if it is missing.
    pub at_low: Option<f64>,
    /// The figure at its high end.
    pub at_high: Option<f64>,
    /// Remark at the right; may be empty.
    pub note: String,
}

impl Tornado {
    fn domain(&self) -> Domain {
        let ends = self.rows.iter().flat_map(|row| [row.at_low, row.at_high]).flatten();
        let (lo, hi) = ends.fold((self.nominal, self.nominal), |(lo, hi), v| (lo.min(v), hi.max(v)));
        let room = 0.05 * (hi - lo).max(1e-6 * hi.abs().max(1e-6));
        Domain { lo: lo - room, hi: hi + room }
    }
}

impl Drawing for Tornado {
    fn label(&self) -> String {
        self.title.clone()
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        let frame = Rect { x: NAMES, y: HEAD, w: WIDTH - NAMES - NOTES, h: ROW * self.rows.len() as f64 };
        svg.rect("area", frame);
        let domain = self.domain();
        let x = |value: f64| frame.x + frame.w * (value - domain.lo) / (domain.hi - domain.lo);
        let ticks = Ticks::new(domain, 6);
        for (value, label) in ticks.values.iter().zip(ticks.labels_in(self.language)) {
            svg.line("grid", x(*value), frame.y, x(*value), frame.bottom());
            svg.text("tick", x(*value), frame.bottom() + 15.0, Anchor::Middle, &label);
        }
        let nominal = x(self.nominal);
        for (i, row) in self.rows.iter().enumerate() {
            let top = frame.y + ROW * i as f64 + 0.5 * (ROW - BAR);
            svg.text("tick", NAMES - 8.0, top + 12.0, Anchor::End, &fit(&row.name, 11.0, NAMES - 10.0));
            // The low end in one shade, the high end in another.
            for (value, class) in [(row.at_low, "gantt even"), (row.at_high, "gantt odd")] {
                let Some(end) = value.map(&x) else { continue };
                let bar = Rect { x: end.min(nominal), y: top, w: (end - nominal).abs(), h: BAR };
                svg.rect(class, bar);
            }
            svg.text("tick", frame.right() + 8.0, top + 12.0, Anchor::Start, &row.note);
        }
        svg.line("line thin c6", nominal, frame.y, nominal, frame.bottom());
        svg.rect("edge", frame);
        svg.text("quiet", frame.right(), frame.bottom() + 33.0, Anchor::End, &self.axis.text());
        (svg, frame.bottom() + FOOT)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_begin_at_the_nominal_value() {
        let row =
            |name: &str, at_low, at_high| TornadoRow { name: name.into(), at_low, at_high, note: "S 40 %".into() };
        let tornado = Tornado {
            title: "Effect".into(),
            axis: Axis::new("margin", "mm"),
            nominal: 10.0,
            rows: vec![row("height", Some(4.0), Some(16.0)), row("tilt", Some(9.0), None)],
            ..Tornado::default()
        };
        let svg = tornado.to_svg_standalone();
        assert_eq!(svg.matches("class=\"gantt").count(), 3);
        assert!(svg.contains("height") && svg.contains("S 40 %"));
        // Nothing has an effect: no division by zero.
        let still = Tornado { rows: vec![row("none", Some(10.0), Some(10.0))], ..tornado };
        assert!(!still.to_svg_standalone().contains("NaN"));
    }
}
