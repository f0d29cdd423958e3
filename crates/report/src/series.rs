//! One curve of a chart.

use std::fmt::Write;

use crate::glyph;
use crate::number::px;
use crate::svg::Svg;
use crate::thinning::thin;
use crate::{Language, Words as _};

/// Drawing style of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Style {
    /// A solid line.
    #[default]
    Line,
    /// A dashed line.
    Dashed,
    /// Dots without a line.
    Points,
}

/// A named sequence of points `(x, y)` in the units of the axes.
///
/// A point with a non-finite coordinate is a gap. The number of points is unlimited: the drawing omits invisible points
/// and keeps all peaks.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Points in drawing order.
    pub points: Vec<(f64, f64)>,
    /// Drawing style.
    pub style: Style,
    /// Index in the palette, from 0, instead of its position in the chart: equal colours across charts.
    pub colour: Option<usize>,
}

impl Series {
    /// Creates a series drawn as a solid line.
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), points, style: Style::Line, colour: None }
    }

    /// Creates a solid line with the name of a code.
    pub(crate) fn named(language: Language, name: &'static str, points: Vec<(f64, f64)>) -> Self {
        Self::line(language.words(name), points)
    }

    /// Returns the series in the palette's colour `place`, from 0.
    #[must_use]
    pub fn coloured(mut self, place: usize) -> Self {
        self.colour = Some(place);
        self
    }

    /// Returns the series in another style.
    #[must_use]
    pub fn styled(mut self, style: Style) -> Self {
        self.style = style;
        self
    }
}

/// Returns the class of the `index`th of several curves, which sets its colour.
pub(crate) fn class(index: usize, style: Style) -> String {
    let kind = match style {
        Style::Line => "line",
        Style::Dashed => "line dashed",
        Style::Points => "dots",
    };
    format!("{kind} c{}", index % 8 + 1)
}

/// Draws px points, with NaN for gaps. A single point between gaps is drawn as a dot.
pub(crate) fn draw(svg: &mut Svg, class: &str, style: Style, points: impl Iterator<Item = (f64, f64)> + Clone) {
    let (mut curve, mut dots) = (String::new(), String::new());
    for run in thin(points) {
        match (style, run.as_slice()) {
            (Style::Points, run) => run.iter().for_each(|(x, y)| dot(&mut dots, *x, *y)),
            (_, [(x, y)]) => dot(&mut dots, *x, *y),
            (_, run) => curve += &glyph::polyline(run),
        }
    }
    svg.path(class, &curve);
    if style == Style::Points {
        svg.path(class, &dots);
    } else {
        svg.path(&class.replace("line dashed", "dots").replace("line", "dots"), &dots);
    }
}

/// Appends a stroke of zero length, which a round cap turns into a dot.
fn dot(d: &mut String, x: f64, y: f64) {
    let _ = write!(d, "M{},{}h0", px(x), px(y));
}
