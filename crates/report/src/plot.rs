//! The plot area of a chart: grid, bands, limits, curves and the labels around it.

use crate::Language;
use crate::Words as _;
use crate::chart::{Chart, STRIP};
use crate::domain::{Domain, usable};
use crate::label_placement::spread;
use crate::limit::{self, LimitLine};
use crate::number::significant;
use crate::series;
use crate::svg::{Anchor, EDGE, Rect, Svg};
use crate::text::{fit, minus, width};
use crate::ticks::Ticks;

/// Size of tick and limit labels, px.
const SMALL: f64 = 11.0;

pub(crate) struct Scale {
    /// Range of values, of their decimal logarithms on a logarithmic scale.
    pub(crate) domain: Domain,
    ticks: Ticks,
    logarithmic: bool,
}

impl Scale {
    /// Creates the x scale shared by `charts`, for a plot `length` px wide.
    pub(crate) fn x<'a>(charts: impl IntoIterator<Item = &'a Chart> + Clone, length: f64) -> Self {
        let logarithmic = charts.clone().into_iter().next().is_some_and(|c| c.log_x);
        match charts.into_iter().filter_map(Chart::x_extent).reduce(Domain::union) {
            Some(domain) if logarithmic => Self::decades(domain.settled(), length),
            Some(domain) => Self::across(domain.settled(), length),
            None => Self::blank(),
        }
    }

    /// Creates a logarithmic x scale over `domain`, a range of decimal logarithms.
    fn decades(domain: Domain, length: f64) -> Self {
        let most = ((length / 45.0) as usize).clamp(3, 14);
        Self { domain, ticks: Ticks::decades(domain, most), logarithmic: true }
    }

    fn place(&self, value: f64) -> f64 {
        if self.logarithmic { value.log10() } else { value }
    }

    /// Creates an x scale over `domain`, with ticks as close as their labels allow.
    pub(crate) fn across(domain: Domain, length: f64) -> Self {
        let most = ((length / 80.0) as usize).clamp(3, 8);
        let fits = |t: &Ticks| {
            let widest = t.labels().iter().fold(0.0f64, |w, l| w.max(width(l, SMALL)));
            (widest + 10.0) * t.values.len() as f64 <= length
        };
        let ticks = (3..=most).rev().map(|n| Ticks::new(domain, n)).find(fits);
        Self { domain, ticks: ticks.unwrap_or_else(|| Ticks::new(domain, 3)), logarithmic: false }
    }

    /// Creates the y scale of `chart`, for a plot `length` px high.
    pub(crate) fn y(chart: &Chart, length: f64) -> Self {
        y_domain(chart).map_or_else(Self::blank, |domain| Self::upward(domain, length))
    }

    /// Creates a y scale over `domain`.
    pub(crate) fn upward(domain: Domain, length: f64) -> Self {
        Self { domain, ticks: Ticks::new(domain, ((length / 36.0) as usize).clamp(3, 8)), logarithmic: false }
    }

    /// Creates the scale of an empty plot, without ticks.
    fn blank() -> Self {
        Self { domain: Domain { lo: 0.0, hi: 1.0 }, ticks: Ticks::default(), logarithmic: false }
    }

    /// Returns the room for tick labels left of the plot, px.
    pub(crate) fn label_width(&self) -> f64 {
        self.ticks.labels().iter().fold(0.0f64, |w, l| w.max(width(&minus(l), SMALL))) + 10.0
    }
}

fn y_domain(chart: &Chart) -> Option<Domain> {
    if let Some((lo, hi)) = chart.y_range.filter(|(lo, hi)| usable(*lo) && usable(*hi) && lo < hi) {
        return Some(Domain { lo, hi }.settled());
    }
    let Some(data) = chart.y_extent() else {
        let limits = Domain::of(chart.limits.iter().map(|l| l.value));
        return limits.map(|d| d.settled().padded(0.06));
    };
    let data = limit::significant(data, &chart.limits);
    let settled = data.settled();
    // Zero is shown if it is near.
    let near = settled.padded(0.5);
    let based = if near.contains(0.0) { settled.including(0.0) } else { settled };
    let whole = based.union(limit::stretch(data, &chart.limits));
    let padded = whole.padded(0.06);
    let floor = |edge: f64, padded: f64| if edge == 0.0 { 0.0 } else { padded };
    Some(Domain { lo: floor(whole.lo, padded.lo), hi: floor(whole.hi, padded.hi) })
}

/// One chart placed in a frame.
pub(crate) struct Plot<'a> {
    pub(crate) chart: &'a Chart,
    pub(crate) frame: Rect,
    pub(crate) x: &'a Scale,
    pub(crate) y: &'a Scale,
    /// Maximum width of a limit's label, px.
    pub(crate) aside: f64,
}

/// Returns the label with the value, or the value alone if both do not fit.
fn limit_text(limit: &LimitLine, room: f64, language: Language) -> String {
    let text = minus(&limit.text(language));
    if width(&text, SMALL) <= room { text } else { fit(&minus(&significant(limit.value, 5, language)), SMALL, room) }
}

impl Plot<'_> {
    /// Returns the room right of the plot, px, for its edge and the labels of its limits, at most `aside`.
    pub(crate) fn limit_width(chart: &Chart, y: &Scale, aside: f64) -> f64 {
        let inside = chart.limits.iter().filter(|l| y.domain.contains(l.value));
        inside.map(|l| width(&limit_text(l, aside, chart.language), SMALL) + 8.0).fold(EDGE, f64::max)
    }

    /// Returns the px of a point of a series; NaN if it cannot be drawn.
    fn px(&self, x: f64, y: f64) -> (f64, f64) {
        let x = self.x.place(x);
        if usable(x) && usable(y) { (self.at_x(x), self.at_y(y)) } else { (f64::NAN, f64::NAN) }
    }

    /// Returns the px of a coordinate in the domain of the x scale.
    fn at_x(&self, x: f64) -> f64 {
        self.x.domain.map(x, self.frame.x, self.frame.right())
    }

    fn at_y(&self, y: f64) -> f64 {
        self.y.domain.map(y, self.frame.bottom(), self.frame.y)
    }

    /// Draws everything inside the frame, and the labels of ticks and limits at its sides.
    pub(crate) fn draw(&self, svg: &mut Svg) {
        let f = self.frame;
        svg.rect("area", f);
        for (left, right) in self.chart.bands.iter().filter_map(|b| self.range(b.from, b.to)) {
            svg.rect("band", Rect { x: left, w: right - left, ..f });
        }
        for (v, label) in self.y.ticks.values.iter().zip(self.y.ticks.labels_in(self.chart.language)) {
            let y = self.at_y(*v);
            svg.line("grid", f.x, y, f.right(), y);
            svg.text("tick", f.x - 6.0, y + 4.0, Anchor::End, &label);
        }
        for v in &self.x.ticks.values {
            let x = self.at_x(*v);
            svg.line("grid", x, f.y, x, f.bottom());
        }
        if self.y.domain.lo < 0.0 && self.y.domain.hi > 0.0 {
            let y = self.at_y(0.0);
            svg.line("zero", f.x, y, f.right(), y);
        }
        svg.rect("edge", f);
        self.draw_limits(svg);
        // The wider clip keeps a stroke along the edge of the frame whole.
        svg.clipped(Rect { x: f.x - 2.0, y: f.y - 2.0, w: f.w + 4.0, h: f.h + 4.0 }, |svg| {
            for (i, s) in self.chart.series.iter().enumerate() {
                series::draw(
                    svg,
                    &series::class(s.colour.unwrap_or(i), s.style),
                    s.style,
                    s.points.iter().map(|(x, y)| self.px(*x, *y)),
                );
            }
        });
        if self.chart.y_extent().is_none() {
            let (x, y) = (f.x + 0.5 * f.w, f.y + 0.5 * f.h + 4.0);
            svg.text("quiet halo", x, y, Anchor::Middle, &self.chart.language.words("report-no-data"));
        }
    }

    fn draw_limits(&self, svg: &mut Svg) {
        let f = self.frame;
        let inside: Vec<_> = self.chart.limits.iter().filter(|l| self.y.domain.contains(l.value)).collect();
        let lines: Vec<f64> = inside.iter().map(|l| self.at_y(l.value)).collect();
        let labels = spread(&lines, &vec![12.0; lines.len()], f.y, f.bottom());
        for ((limit, line), label) in inside.iter().zip(&lines).zip(labels) {
            svg.line("limit", f.x, *line, f.right(), *line);
            let text = limit_text(limit, self.aside, self.chart.language);
            svg.text("limit-text", f.right() + 6.0, label + 4.0, Anchor::Start, &text);
        }
    }

    pub(crate) fn draw_x_labels(&self, svg: &mut Svg) {
        let places = self.x.ticks.values.iter().map(|v| self.at_x(*v));
        svg.ticks(self.frame.bottom() + 14.0, places.zip(self.x.ticks.labels_in(self.chart.language)));
    }

    /// Draws the names of the bands on one line above the plot; omits names that do not fit.
    pub(crate) fn draw_band_labels(&self, svg: &mut Svg) {
        let f = self.frame;
        let mut bands: Vec<_> =
            self.chart.bands.iter().filter_map(|b| Some((self.range(b.from, b.to)?, &b.label))).collect();
        bands.sort_by(|a, b| a.0.0.total_cmp(&b.0.0));
        let mut free = f64::NEG_INFINITY;
        for ((left, right), label) in bands.into_iter().filter(|(_, label)| !label.is_empty()) {
            let text = fit(label, SMALL, f.w);
            let half = 0.5 * width(&text, SMALL);
            let x = (0.5 * (left + right)).min(f.right() - half).max(f.x + half);
            if x - half >= free {
                svg.text("tick", x, f.y - 5.0 - self.chart.strip_height(), Anchor::Middle, &text);
                free = x + half + 8.0;
            }
        }
    }

    /// Draws the strip of named ranges above the plot.
    pub(crate) fn draw_strip(&self, svg: &mut Svg) {
        let y = self.frame.y - self.chart.strip_height();
        let drawn = self.chart.strip.iter().filter_map(|s| Some((s, self.range(s.from, s.to)?)));
        for (stretch, (left, right)) in drawn {
            let class =
                if stretch.fault { "stretch fault".to_owned() } else { format!("stretch s{}", stretch.colour % 8 + 1) };
            svg.rect(&class, Rect { x: left, y, w: right - left, h: STRIP });
            if width(&stretch.label, SMALL) + 4.0 <= right - left {
                let class = if stretch.fault { "limit-text" } else { "tick" };
                svg.text(class, 0.5 * (left + right), y + 12.5, Anchor::Middle, &stretch.label);
            }
        }
    }

    /// Returns left and right edge of a range of x inside the frame, px.
    fn range(&self, from: f64, to: f64) -> Option<(f64, f64)> {
        let (from, to) = (self.x.place(from), self.x.place(to));
        if from.is_nan() || to.is_nan() {
            return None;
        }
        let d = self.x.domain;
        let (from, to) = (from.min(to).max(d.lo), from.max(to).min(d.hi));
        (from < to).then(|| (self.at_x(from), self.at_x(to)))
    }
}
