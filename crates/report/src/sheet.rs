use crate::svg::Svg;
use crate::{Chart, Drawing};

/// Gap between two charts of a sheet, px.
const GAP: f64 = 26.0;

/// Draws several charts below each other, each with its own axes, as one SVG file called `title`.
pub fn sheet(title: &str, charts: &[Chart]) -> String {
    let mut all = Svg::default();
    let mut top = 0.0;
    for chart in charts {
        let (svg, height) = chart.draw();
        all.place(&svg, top);
        top += height + GAP;
    }
    all.standalone((top - GAP).max(1.0), title)
}
