//! A chart: curves over one axis, against limits.

use crate::domain::{Domain, usable};
use crate::legend::{Entry, Legend, ROW};
use crate::limit::{self, LimitLine};
use crate::plot::{Plot, Scale};
use crate::series::Series;
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::{fit, width};
use crate::{Drawing, Language, Words as _};
use seamwright_message::Unit;

/// Quantity and unit of an axis.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Axis {
    /// Name of the quantity.
    pub label: String,
    /// Unit; empty without one.
    pub unit: String,
}

impl Axis {
    /// Creates an axis for `label` in `unit`.
    pub fn new(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self { label: label.into(), unit: unit.into() }
    }

    /// Creates an axis for the words of a code.
    pub(crate) fn of(language: Language, label: &'static str, unit: Unit) -> Self {
        Self::new(language.words(label), language.symbol(unit))
    }

    pub(crate) fn text(&self) -> String {
        with_unit(&self.label, &self.unit)
    }
}

/// Returns `label, unit`, or the one that is not empty.
pub(crate) fn with_unit(label: &str, unit: &str) -> String {
    let comma = if label.is_empty() || unit.is_empty() { "" } else { ", " };
    format!("{label}{comma}{unit}")
}

/// A shaded range of x, for example an acceleration phase.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Band {
    /// Name, written above the plot.
    pub label: String,
    /// One end.
    pub from: f64,
    /// The other end.
    pub to: f64,
}

/// A named range of x in the strip above a plot, for example a welding position.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stretch {
    /// Name, written inside if it fits.
    pub label: String,
    /// One end.
    pub from: f64,
    /// The other end.
    pub to: f64,
    /// Index in the palette, from 0.
    pub colour: usize,
    /// Not allowed: drawn in the colour of limits.
    pub fault: bool,
}

/// Series over a common x axis. Set the needed fields and take the rest from [`Chart::default`].
///
/// The y axis fits the data and those limits that do not squash them. A limit farther away than about three times the
/// range of the data is named above the plot instead. Data that differ by less than a millionth of their magnitude
/// count as constant.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Heading; may be empty.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves, in the order of the palette. Eight colours; more series repeat them.
    pub series: Vec<Series>,
    /// Horizontal limits.
    pub limits: Vec<LimitLine>,
    /// Shaded ranges of x.
    pub bands: Vec<Band>,
    /// Ranges of x in a strip of their own above the plot. Not drawn in a [`ChartGrid`](crate::ChartGrid).
    pub strip: Vec<Stretch>,
    /// Equal scales of x and y, as for a path in a plane. Ignored in a [`ChartGrid`](crate::ChartGrid).
    pub equal_aspect: bool,
    /// Logarithmic x axis; values not above zero are gaps. In a [`ChartGrid`](crate::ChartGrid) the first chart
    /// decides.
    pub log_x: bool,
    /// Minimum and maximum y shown; fitted to the data if `None`.
    pub y_range: Option<(f64, f64)>,
    /// Height of the plot area in px at a width of 920 px. If `None`: 220, or with equal aspect the height that fits
    /// the data.
    pub height: Option<f64>,
}

/// Maximum width of a limit's label, px.
const ASIDE: f64 = 150.0;

/// Height of the strip, px.
pub(crate) const STRIP: f64 = 17.0;

/// Minimum room left of a plot, px, so that plots below each other align.
const LEFT: f64 = 58.0;

impl Chart {
    /// Creates a chart over path length with the title of a code.
    pub(crate) fn along(language: Language, title: &'static str, y: Axis, series: Vec<Series>) -> Self {
        let x = Axis::of(language, "report-label-path-length", Unit::Mm);
        Self { language, title: language.words(title), x, y, series, ..Self::default() }
    }

    fn drawn(&self) -> impl Iterator<Item = (f64, f64)> {
        let visible = |p: &(f64, f64)| usable(p.0) && usable(p.1) && (!self.log_x || p.0 > 0.0);
        self.series.iter().flat_map(|s| &s.points).copied().filter(visible)
    }

    /// Returns the range of x, of its decimal logarithm on a logarithmic axis.
    pub(crate) fn x_extent(&self) -> Option<Domain> {
        Domain::of(self.drawn().map(|p| if self.log_x { p.0.log10() } else { p.0 }))
    }

    pub(crate) fn y_extent(&self) -> Option<Domain> {
        Domain::of(self.drawn().map(|p| p.1))
    }

    /// Returns names of the curves that differ from the headings, and notes on limits outside the plot.
    pub(crate) fn entries(&self, y: &Scale) -> Vec<Entry> {
        let told = |s: &Series| s.name.is_empty() || s.name == self.y.label || s.name == self.title;
        let curves = self.series.iter().enumerate();
        let named = curves.filter(|(_, s)| if self.series.len() > 1 { !s.name.is_empty() } else { !told(s) });
        let mut entries: Vec<Entry> = named.map(|(i, s)| Entry::curve(i, s)).collect();
        entries.extend(limit::notes(&self.limits, y.domain, &self.y.unit, self.language).into_iter().map(Entry::Note));
        entries
    }

    pub(crate) fn has_band_labels(&self) -> bool {
        self.bands.iter().any(|b| !b.label.is_empty())
    }

    /// Returns the height of the strip above the plot, px.
    pub(crate) fn strip_height(&self) -> f64 {
        if self.strip.is_empty() { 0.0 } else { STRIP + 5.0 }
    }

    /// Returns scales and size of the plot area.
    fn measure(&self) -> (Scale, Scale, Rect) {
        let height = self.height.filter(|h| h.is_finite()).map(|h| h.clamp(40.0, 2000.0));
        let high = height.unwrap_or(220.0);
        let y = Scale::y(self, high);
        let right = Plot::limit_width(self, &y, ASIDE);
        if !self.equal_aspect {
            let left = y.label_width().max(LEFT);
            let w = WIDTH - left - right;
            return (Scale::x([self], w), y, Rect { x: left, w, h: high, ..Rect::default() });
        }
        let w = WIDTH - LEFT - right;
        let x = Scale::x([self], w).domain.padded(0.03);
        let h = height.unwrap_or_else(|| (w * y.domain.span() / x.span()).clamp(160.0, 460.0));
        let unit = (x.span() / w).max(y.domain.span() / h);
        let (x, y) = (x.widened_to(unit * w), y.domain.widened_to(unit * h));
        (Scale::across(x, w), Scale::upward(y, h), Rect { x: LEFT, w, h, ..Rect::default() })
    }
}

impl Drawing for Chart {
    fn label(&self) -> String {
        if self.title.is_empty() { self.y.text() } else { self.title.clone() }
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let (x, y, mut frame) = self.measure();
        let mut top = 0.0;
        if !self.title.is_empty() {
            svg.text("title", 0.0, 14.0, Anchor::Start, &fit(&self.title, 16.0, WIDTH));
            top += 24.0;
        }
        let heading = fit(&self.y.text(), 12.0, WIDTH);
        let legend = Legend::new(self.entries(&y), width(&heading, 12.0), WIDTH);
        svg.text("quiet", 0.0, top + 12.0, Anchor::Start, &heading);
        legend.draw(&mut svg, 0.0, top + 12.0);
        top += ROW + legend.height() + if self.has_band_labels() { 17.0 } else { 2.0 };
        top += self.strip_height();
        frame.y = top;
        let plot = Plot { chart: self, frame, x: &x, y: &y, aside: ASIDE };
        plot.draw(&mut svg);
        plot.draw_band_labels(&mut svg);
        plot.draw_strip(&mut svg);
        plot.draw_x_labels(&mut svg);
        let label = fit(&self.x.text(), 12.0, frame.w);
        svg.text("quiet", frame.x + 0.5 * frame.w, frame.bottom() + 31.0, Anchor::Middle, &label);
        (svg, frame.bottom() + if label.is_empty() { 18.0 } else { 36.0 })
    }
}
