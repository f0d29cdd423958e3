use crate::domain::Domain;
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::ticks::Ticks;
use crate::{Drawing, Language, Words as _};
use seamwright_message::Unit;

/// Height of a row, px, and of the bar in it.
const ROW: f64 = 26.0;
const BAR: f64 = 16.0;
/// Height of the heading, px, and room below for the axis.
const HEAD: f64 = 26.0;
const FOOT: f64 = 40.0;
/// Width of the names, px.
const NAMES: f64 = 150.0;

/// Machines and the parts that occupy them, over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Gantt {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// The machines.
    pub rows: Vec<GanttRow>,
}

/// One machine.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GanttRow {
    /// Its name.
    pub name: String,
    /// Its parts in order.
    pub bars: Vec<GanttBar>,
}

/// One part; times in hours.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GanttBar {
    /// Its name.
    pub name: String,
    /// Beginning of the set-up.
    pub from_h: f64,
    /// Beginning of the weld.
    pub begin_h: f64,
    /// End.
    pub to_h: f64,
}

impl Drawing for Gantt {
    fn label(&self) -> String {
        self.title.clone()
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        svg.text("title", 0.0, 14.0, Anchor::Start, &self.title);
        let end = self.rows.iter().flat_map(|row| &row.bars).map(|bar| bar.to_h).fold(0.0, f64::max);
        let frame = Rect { x: NAMES, y: HEAD, w: WIDTH - NAMES - 1.0, h: ROW * self.rows.len() as f64 };
        svg.rect("area", frame);
        let x = |hours: f64| frame.x + frame.w * hours / end.max(1e-9);
        let ticks = Ticks::new(Domain { lo: 0.0, hi: end.max(1e-9) }, 8);
        for (value, label) in ticks.values.iter().zip(ticks.labels_in(self.language)) {
            svg.line("grid", x(*value), frame.y, x(*value), frame.bottom());
            svg.text("tick", x(*value), frame.bottom() + 15.0, Anchor::Middle, &label);
        }
        for (i, row) in self.rows.iter().enumerate() {
            let top = frame.y + ROW * i as f64 + 0.5 * (ROW - BAR);
            svg.text("tick", NAMES - 8.0, top + 12.0, Anchor::End, &row.name);
            for (k, bar) in row.bars.iter().enumerate() {
                let part = |from: f64, to: f64| Rect { x: x(from), y: top, w: (x(to) - x(from)).max(0.0), h: BAR };
                svg.rect("gantt setup", part(bar.from_h, bar.begin_h));
                // Neighbours in two shades.
                svg.rect(if k % 2 == 0 { "gantt even" } else { "gantt odd" }, part(bar.begin_h, bar.to_h));
                let room = x(bar.to_h) - x(bar.begin_h);
                if crate::text::width(&bar.name, 10.0) + 6.0 < room {
                    svg.text("inbar", 0.5 * (x(bar.begin_h) + x(bar.to_h)), top + 12.0, Anchor::Middle, &bar.name);
                }
            }
        }
        svg.rect("edge", frame);
        svg.text("quiet", frame.right(), frame.bottom() + 33.0, Anchor::End, &self.language.symbol(Unit::H));
        (svg, frame.bottom() + FOOT)
    }
}
