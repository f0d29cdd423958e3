//! Names of curves, beside or below a heading and outside the data.

use crate::series::{self, Series, Style};
use crate::svg::{Anchor, Svg};
use crate::text::{fit, width};

/// Height of one row of text, px.
pub(crate) const ROW: f64 = 18.0;

const SWATCH: f64 = 22.0;
const DASH: f64 = 18.0;
const GAP: f64 = 18.0;

/// Tolerance for rounding of the sums that place the last name at the right edge, px.
const HAIR: f64 = 0.01;

pub(crate) enum Entry {
    /// A curve, with the class of its stroke.
    Curve { class: String, dots: bool, name: String },
    /// A remark about a limit outside the plot, and a shorter form of it.
    Note([String; 2]),
}

impl Entry {
    pub(crate) fn curve(index: usize, series: &Series) -> Self {
        Self::Curve {
            class: series::class(series.colour.unwrap_or(index), series.style),
            dots: series.style == Style::Points,
            name: series.name.clone(),
        }
    }

    fn name(&self) -> &str {
        match self {
            Self::Curve { name, .. } | Self::Note([name, _]) => name,
        }
    }

    fn lead(&self) -> f64 {
        match self {
            Self::Curve { .. } => SWATCH + 6.0,
            Self::Note(_) => DASH + 6.0,
        }
    }

    fn width(&self) -> f64 {
        self.lead() + width(self.name(), 12.0)
    }

    fn draw(&self, svg: &mut Svg, x: f64, baseline: f64, room: f64) {
        let name = fit(self.name(), 12.0, room - self.lead());
        match self {
            Self::Curve { class, dots, .. } => {
                let y = baseline - 4.5;
                if *dots {
                    svg.path(class, &format!("M{:.1},{y:.1}h0m8,0h0", x + 7.0));
                } else {
                    svg.line(class, x, y, x + SWATCH, y);
                }
                svg.text("", x + self.lead(), baseline, Anchor::Start, &name);
            }
            Self::Note([_, short]) => {
                let name = if name == self.name() { name } else { fit(short, 12.0, room - self.lead()) };
                svg.line("limit", x, baseline - 4.5, x + DASH, baseline - 4.5);
                svg.text("quiet", x + self.lead(), baseline, Anchor::Start, &name);
            }
        }
    }
}

/// Entries in rows: a single row right of the heading if all of them fit there.
pub(crate) struct Legend {
    entries: Vec<Entry>,
    beside: bool,
    /// Row of each entry, and its x from the left of the row.
    places: Vec<(usize, f64)>,
    rows: usize,
    room: f64,
}

impl Legend {
    /// Places `entries` beside a heading `heading` px wide, or in rows `room` px wide below it.
    pub(crate) fn new(entries: Vec<Entry>, heading: f64, room: f64) -> Self {
        let total: f64 = entries.iter().map(|e| e.width() + GAP).sum::<f64>() - GAP;
        let beside = heading + 2.0 * GAP + total <= room;
        let (mut row, mut x) = (0, if beside { room - total } else { 0.0 });
        let mut places = Vec::with_capacity(entries.len());
        for entry in &entries {
            if !beside && x > 0.0 && x + entry.width() > room {
                (row, x) = (row + 1, 0.0);
            }
            places.push((row, x));
            x += entry.width() + GAP;
        }
        let rows = if entries.is_empty() || beside { 0 } else { row + 1 };
        Self { entries, beside, places, rows, room }
    }

    /// Returns the height needed below the row of the heading, px.
    pub(crate) fn height(&self) -> f64 {
        self.rows as f64 * ROW
    }

    /// Draws the legend; `baseline` is that of the heading.
    pub(crate) fn draw(&self, svg: &mut Svg, left: f64, baseline: f64) {
        let first = if self.beside { baseline } else { baseline + ROW };
        for (entry, (row, x)) in self.entries.iter().zip(&self.places) {
            entry.draw(svg, left + x, first + *row as f64 * ROW, self.room - x + HAIR);
        }
    }
}
