use crate::{Axis, Block, Chart, LimitLine, Series};
use seamwright_record::figures::{BIN_MM, Curve, Figures, HEAT_INPUT, Value};

/// Curves of one chart at most: eight colours tell that many apart.
const MOST: usize = 8;

fn chart(title: &str, y: Axis, curves: &[&Curve], limits: Vec<LimitLine>) -> Chart {
    let several = curves.iter().any(|c| c.pass != curves[0].pass);
    let name = |c: &Curve| match several {
        true => format!("pass {}: {}", c.pass, c.name),
        false => c.name.clone(),
    };
    Chart {
        title: title.to_owned(),
        x: Axis::new("path length s", "mm"),
        y,
        series: curves.iter().map(|c| Series::line(name(c), c.points.clone())).collect(),
        limits,
        height: Some(170.0),
        ..Chart::default()
    }
}

fn figure(chart: &Chart, caption: String) -> Block {
    Block::Figure { svg: chart.to_svg(), caption }
}

/// Heat input along the passes, with the window if all have the same.
pub(super) fn heat_input(figures: &Figures, values: &[Value]) -> Block {
    let curves: Vec<&Curve> = figures.heat_input.iter().take(MOST).collect();
    if curves.is_empty() {
        return Block::Paragraph("Not known: without a procedure nothing says what power is.".to_owned());
    }
    let mut windows: Vec<(f64, f64)> =
        values.iter().filter(|v| v.name == HEAT_INPUT).filter_map(|v| v.allowed).collect();
    windows.dedup();
    let limits = match windows.as_slice() {
        [(least, greatest)] => vec![LimitLine::new("least", *least), LimitLine::new("greatest", *greatest)],
        _ => Vec::new(),
    };
    let chart = chart("Heat input along the seam", Axis::new("heat input", "kJ/mm"), &curves, limits);
    let caption =
        format!("Energy over the way of the torch tip, of each {BIN_MM} mm{}.", left_out(figures.heat_input.len()));
    figure(&chart, caption)
}

/// Deviations along the passes.
pub(super) fn deviations(figures: &Figures) -> Vec<Block> {
    let (path, seam): (Vec<&Curve>, Vec<&Curve>) = figures.deviations.iter().partition(|c| c.name == "path_error_mm");
    let drawn = |title: &str, curves: &[&Curve], caption: &str| {
        let shown = &curves[..curves.len().min(MOST)];
        let chart = chart(title, Axis::new("distance", "mm"), shown, Vec::new());
        let caption = format!("{caption}, of each {BIN_MM} mm the greatest{}.", left_out(curves.len()));
        (!curves.is_empty()).then(|| figure(&chart, caption))
    };
    let path =
        drawn("Torch tip beside the planned path", &path, "Distance of the true torch tip from the seam, normal to it");
    let seam = drawn("Weld beside the joint", &seam, "Where the weld lies beside the joint, lateral and in height");
    let blocks: Vec<Block> = path.into_iter().chain(seam).collect();
    if blocks.is_empty() { vec![Block::Paragraph("Nothing of them is known.".to_owned())] } else { blocks }
}

fn left_out(curves: usize) -> String {
    if curves > MOST { format!("; {MOST} of {curves} curves, all are in the trace") } else { String::new() }
}
