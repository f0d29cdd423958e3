use crate::block::Block;
use crate::chart::{Axis, Chart};
use crate::limit::LimitLine;
use crate::names;
use crate::series::Series;
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_record::figures::{BIN_MM, Curve, Figures, HEAT_INPUT, Value};

/// Maximum number of curves in a chart: the palette has eight colours.
const MAX_CURVES: usize = 8;

/// Codes of the title of a chart, and of a caption that describes a point.
#[derive(Clone, Copy)]
struct Heading {
    title: &'static str,
    caption: &'static str,
}

/// Returns a chart of `curves` over path length, up to the maximum number.
fn figure(heading: Heading, y: Axis, curves: &[&Curve], limits: Vec<LimitLine>, language: Language) -> Block {
    let several = curves.iter().any(|c| c.pass != curves[0].pass);
    let called = |c: &Curve| {
        let name = names::curve(language, &c.name);
        let named = || {
            Message::new("report-pass-named").pass("pass", c.pass as usize).text("name", &name).in_language(language)
        };
        if several { named() } else { name }
    };
    let chart = Chart {
        language,
        title: language.words(heading.title),
        x: Axis::new(language.words("report-label-path-length"), language.symbol(Unit::Mm)),
        y,
        series: curves.iter().take(MAX_CURVES).map(|c| Series::line(called(c), c.points.clone())).collect(),
        limits,
        height: Some(170.0),
        ..Chart::default()
    };
    let mut caption = vec![Message::new(heading.caption).value("bin", BIN_MM, Unit::Mm).in_language(language)];
    if curves.len() > MAX_CURVES {
        let message = Message::new("report-curves-shown").count("shown", MAX_CURVES).count("all", curves.len());
        caption.push(message.in_language(language));
    }
    let caption = language.sentences(&caption);
    Block::Figure { svg: chart.to_svg(), caption }
}

/// Returns heat input along the passes, with the window if all share one.
pub(super) fn heat_input(figures: &Figures, values: &[Value], language: Language) -> Block {
    let curves: Vec<&Curve> = figures.heat_input.iter().collect();
    if curves.is_empty() {
        return Block::Paragraph(language.words("report-heat-input-unknown"));
    }
    let mut windows: Vec<(f64, f64)> =
        values.iter().filter(|v| v.name == HEAT_INPUT).filter_map(|v| v.allowed).collect();
    windows.dedup();
    let limit = |word, value| LimitLine::new(language.words(word), value);
    let limits = match windows.as_slice() {
        [(least, greatest)] => vec![limit("report-limit-at-least", *least), limit("report-limit-at-most", *greatest)],
        _ => Vec::new(),
    };
    let heading = Heading { title: "report-chart-heat-input", caption: "report-caption-heat-input-bins" };
    let heat = Axis::new(language.words("value-heat-input"), language.symbol(Unit::KiloJPerMm));
    figure(heading, heat, &curves, limits, language)
}

/// Returns deviations along the passes.
pub(super) fn deviations(figures: &Figures, language: Language) -> Vec<Block> {
    let (path, seam): (Vec<&Curve>, Vec<&Curve>) = figures.deviations.iter().partition(|c| c.name == "path_error_mm");
    let drawn = |heading, curves: &[&Curve]| {
        let distance = Axis::new(language.words("report-label-distance"), language.symbol(Unit::Mm));
        (!curves.is_empty()).then(|| figure(heading, distance, curves, Vec::new(), language))
    };
    let of_tip = Heading { title: "report-chart-tip-off-path", caption: "report-caption-tip-off-path" };
    let of_weld = Heading { title: "report-chart-weld-off-joint", caption: "report-caption-weld-off-joint" };
    let blocks: Vec<Block> = drawn(of_tip, &path).into_iter().chain(drawn(of_weld, &seam)).collect();
    match blocks.is_empty() {
        true => vec![Block::Paragraph(language.words("report-no-values"))],
        false => blocks,
    }
}
