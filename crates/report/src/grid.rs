//! Small charts over one x axis.

use crate::chart::{Chart, with_unit};
use crate::legend::{Entry, Legend, ROW};
use crate::plot::{Plot, Scale};
use crate::svg::{Anchor, Rect, Svg, WIDTH};
use crate::text::{fit, width};
use crate::{Drawing, Words as _};

/// Small multiples: charts that share an x axis. For example one row per machine axis, with position, speed and
/// acceleration.
///
/// The x range covers all charts. Each keeps its own y range, limits and bands. The names of the series are written
/// once, from the chart with the largest number, so equal series should have equal order. About eight rows fit on a
/// page of paper.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ChartGrid {
    /// Heading; may be empty.
    pub title: String,
    /// Charts in a row; 0 counts as 1.
    pub columns: usize,
    /// The charts, row by row.
    pub charts: Vec<Chart>,
}

/// Height of a plot area unless the chart sets it, px.
const HIGH: f64 = 84.0;

/// Maximum width of a limit's label, as a fraction of the width of a column.
const ASIDE: f64 = 0.25;

/// Gap between columns, px.
const GUTTER: f64 = 20.0;

impl ChartGrid {
    fn columns(&self) -> usize {
        self.columns.clamp(1, self.charts.len().max(1))
    }

    /// Draws the names of the series of the first chart with the largest number, if it has several; returns their
    /// height.
    fn draw_legend(&self, svg: &mut Svg, top: f64) -> f64 {
        let Some(fullest) = self.charts.iter().rev().max_by_key(|c| c.series.len()).filter(|c| c.series.len() > 1)
        else {
            return 0.0;
        };
        let entries = fullest.series.iter().enumerate().map(|(i, s)| Entry::curve(i, s)).collect();
        let legend = Legend::new(entries, f64::INFINITY, WIDTH);
        legend.draw(svg, 0.0, top + 12.0 - ROW);
        legend.height() + 4.0
    }
}

impl Drawing for ChartGrid {
    fn label(&self) -> String {
        let language = self.charts.first().map(|chart| chart.language).unwrap_or_default();
        if self.title.is_empty() { language.words("report-charts") } else { self.title.clone() }
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let columns = self.columns();
        let width = (WIDTH - GUTTER * (columns - 1) as f64) / columns as f64;
        let mut top = 0.0;
        if !self.title.is_empty() {
            svg.text("title", 0.0, 14.0, Anchor::Start, &fit(&self.title, 16.0, WIDTH));
            top += 26.0;
        }
        top += self.draw_legend(&mut svg, top);
        let mut cells: Vec<Cell> = self.charts.iter().map(|c| Cell::new(c, width)).collect();
        for column in 0..columns {
            align(cells.iter_mut().skip(column).step_by(columns), width);
        }
        let narrowest = cells.iter().map(|c| c.frame.w).fold(width, f64::min);
        let x = Scale::x(&self.charts, narrowest);
        let count = cells.len();
        let mut bottom = top;
        for (row, cells) in cells.chunks_mut(columns).enumerate() {
            let head = cells.iter().map(|c| c.head(row == 0)).fold(0.0, f64::max);
            for (column, cell) in cells.iter_mut().enumerate() {
                let last = (row + 1) * columns + column >= count;
                cell.place(column as f64 * (width + GUTTER), top + head);
                cell.draw(&mut svg, top, &x, row == 0, last);
                bottom = f64::max(bottom, cell.frame.bottom() + if last { 36.0 } else { 0.0 });
            }
            top = cells.iter().map(|c| c.frame.bottom()).fold(top, f64::max) + 12.0;
        }
        (svg, bottom.max(1.0))
    }
}

struct Cell<'a> {
    chart: &'a Chart,
    y: Scale,
    /// Left edge, at the tick labels.
    left: f64,
    width: f64,
    /// The plot area.
    frame: Rect,
}

impl<'a> Cell<'a> {
    fn new(chart: &'a Chart, width: f64) -> Self {
        let h = chart.height.filter(|h| h.is_finite()).map_or(HIGH, |h| h.clamp(40.0, 2000.0));
        Self { chart, y: Scale::y(chart, h), left: 0.0, width, frame: Rect { h, ..Rect::default() } }
    }

    fn place(&mut self, left: f64, y: f64) {
        self.left = left;
        self.frame.x += left;
        self.frame.y = y;
    }

    fn room(&self) -> f64 {
        self.frame.right() - self.left
    }

    fn heading(&self) -> String {
        let Chart { title, y, .. } = self.chart;
        with_unit(if title.is_empty() { &y.label } else { title }, &y.unit)
    }

    fn notes(&self) -> Legend {
        let notes = self.chart.entries(&self.y).into_iter().filter(|e| matches!(e, Entry::Note(_)));
        Legend::new(notes.collect(), width(&self.heading(), 13.5), self.room())
    }

    /// Returns the height above the plot area. Names of bands are written in the first row only.
    fn head(&self, first: bool) -> f64 {
        let bands = if first && self.chart.has_band_labels() { 16.0 } else { 2.0 };
        ROW + self.notes().height() + bands
    }

    fn draw(&self, svg: &mut Svg, top: f64, x: &Scale, first: bool, last: bool) {
        svg.text("head", self.left, top + 12.0, Anchor::Start, &fit(&self.heading(), 13.5, self.room()));
        self.notes().draw(svg, self.left, top + 12.0);
        let plot = Plot { chart: self.chart, frame: self.frame, x, y: &self.y, aside: ASIDE * self.width };
        plot.draw(svg);
        if first {
            plot.draw_band_labels(svg);
        }
        if last {
            plot.draw_x_labels(svg);
            let label = fit(&self.chart.x.text(), 12.0, self.frame.w);
            let middle = self.frame.x + 0.5 * self.frame.w;
            svg.text("quiet", middle, self.frame.bottom() + 31.0, Anchor::Middle, &label);
        }
    }
}

/// Gives the plots of one column equal left and right edges.
fn align<'a, 'b: 'a>(cells: impl Iterator<Item = &'a mut Cell<'b>>, width: f64) {
    let cells: Vec<_> = cells.collect();
    let left = cells.iter().map(|c| c.y.label_width()).fold(36.0, f64::max);
    let right = cells.iter().map(|c| Plot::limit_width(c.chart, &c.y, ASIDE * width)).fold(0.0, f64::max);
    for cell in cells {
        cell.frame.x = left;
        cell.frame.w = (width - left - right).max(40.0);
    }
}
