use crate::block::paragraph;
use crate::{Axis, Block, Chart, Drawing, Language, LimitLine, Series, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_record::figures::{BIN_MM, Curve, Figures, HEAT_INPUT, Value};

/// Maximum number of curves in a chart: the palette has eight colours.
const MAX_CURVES: usize = 8;

/// Returns a figure of `curves` over path length, up to the maximum number. Its title and caption are codes; the caption
/// describes a point.
fn figure(title: &'static str, caption: &'static str, chart: Chart, curves: &[&Curve], language: Language) -> Block {
    let several = curves.iter().any(|c| c.pass != curves[0].pass);
    let called = |c: &Curve| {
        let name = value_names::curve(language, &c.name);
        match several {
            true => Message::new("report-pass-named").pass("pass", c.pass as usize).text("name", name),
            false => Message::verbatim(name),
        }
        .in_language(language)
    };
    let series = curves.iter().take(MAX_CURVES).map(|c| Series::line(called(c), c.points.clone())).collect();
    let chart = Chart { limits: chart.limits, height: Some(170.0), ..Chart::along(language, title, chart.y, series) };
    let mut caption = vec![Message::new(caption).value("bin", BIN_MM, Unit::Mm).in_language(language)];
    if curves.len() > MAX_CURVES {
        let message = Message::new("report-curves-shown").count("shown", MAX_CURVES).count("all", curves.len());
        caption.push(message.in_language(language));
    }
    Block::Figure { svg: chart.to_svg(), caption: language.sentences(&caption) }
}

/// Returns heat input along the passes, with the window if all share one.
pub(super) fn heat_input(figures: &Figures, values: &[Value], language: Language) -> Block {
    let curves: Vec<&Curve> = figures.heat_input.iter().collect();
    if curves.is_empty() {
        return paragraph("report-heat-input-unknown", language);
    }
    let mut windows: Vec<(f64, f64)> =
        values.iter().filter(|v| v.name == HEAT_INPUT).filter_map(|v| v.allowed).collect();
    windows.dedup();
    let limit = |word, value| LimitLine::new(language.words(word), value);
    let limits = match windows.as_slice() {
        [(least, greatest)] => vec![limit("report-limit-at-least", *least), limit("report-limit-at-most", *greatest)],
        _ => Vec::new(),
    };
    let chart = Chart { y: Axis::of(language, "value-heat-input", Unit::KiloJPerMm), limits, ..Chart::default() };
    figure("report-chart-heat-input", "report-caption-heat-input-bins", chart, &curves, language)
}

pub(super) fn deviations(figures: &Figures, language: Language) -> Vec<Block> {
    let (path, seam): (Vec<&Curve>, Vec<&Curve>) = figures.deviations.iter().partition(|c| c.name == "path_error_mm");
    let drawn = [
        ("report-chart-tip-off-path", "report-caption-tip-off-path", path),
        ("report-chart-weld-off-joint", "report-caption-weld-off-joint", seam),
    ];
    let blocks = drawn.into_iter().filter(|(.., curves)| !curves.is_empty()).map(|(title, caption, curves)| {
        let chart = Chart { y: Axis::of(language, "report-label-distance", Unit::Mm), ..Chart::default() };
        figure(title, caption, chart, &curves, language)
    });
    let blocks: Vec<Block> = blocks.collect();
    if blocks.is_empty() { vec![paragraph("report-no-values", language)] } else { blocks }
}
