use crate::Phrases as _;
use crate::said;
use crate::{Axis, Block, Chart, Language, LimitLine, Series};
use seamwright_record::figures::{BIN_MM, Curve, Figures, HEAT_INPUT, Value};

/// Maximum number of curves in a chart: the palette has eight colours.
const MAX_CURVES: usize = 8;

/// Returns a chart of `curves` over path length, up to the maximum number, with a caption that describes a point.
fn figure(
    (title, caption): (&'static str, &'static str),
    y: Axis,
    curves: &[&Curve],
    limits: Vec<LimitLine>,
    language: Language,
) -> Block {
    let several = curves.iter().any(|c| c.pass != curves[0].pass);
    let called = |c: &Curve| {
        let name = said::curve(language, &c.name);
        if several { language.fill("pass {0}: {1}", &[&c.pass.to_string(), &name]) } else { name }
    };
    let chart = Chart {
        language,
        title: language.say(title).to_owned(),
        x: Axis::new(language.say("path length s"), language.say("mm")),
        y,
        series: curves.iter().take(MAX_CURVES).map(|c| Series::line(called(c), c.points.clone())).collect(),
        limits,
        height: Some(170.0),
        ..Chart::default()
    };
    let mut caption = language.fill(caption, &[&BIN_MM.to_string()]);
    if curves.len() > MAX_CURVES {
        let [most, all] = [MAX_CURVES, curves.len()].map(|n| n.to_string());
        caption += language.between_sentences();
        caption += &language.fill("{0} of {1} curves; all are in the trace.", &[&most, &all]);
    }
    Block::Figure { svg: chart.to_svg(), caption }
}

/// Returns heat input along the passes, with the window if all share one.
pub(super) fn heat_input(figures: &Figures, values: &[Value], language: Language) -> Block {
    let curves: Vec<&Curve> = figures.heat_input.iter().collect();
    if curves.is_empty() {
        let why = "Not known: without a procedure nothing says what power is.";
        return Block::Paragraph(language.say(why).to_owned());
    }
    let mut windows: Vec<(f64, f64)> =
        values.iter().filter(|v| v.name == HEAT_INPUT).filter_map(|v| v.allowed).collect();
    windows.dedup();
    let limit = |word, value| LimitLine::new(language.say(word), value);
    let limits = match windows.as_slice() {
        [(least, greatest)] => vec![limit("at least", *least), limit("at most", *greatest)],
        _ => Vec::new(),
    };
    let said = ("Heat input along the seam", "Energy over the way of the torch tip, of each {0} mm.");
    let heat = Axis::new(language.say("value.heat_input"), language.say("kJ/mm"));
    figure(said, heat, &curves, limits, language)
}

/// Returns deviations along the passes.
pub(super) fn deviations(figures: &Figures, language: Language) -> Vec<Block> {
    let (path, seam): (Vec<&Curve>, Vec<&Curve>) = figures.deviations.iter().partition(|c| c.name == "path_error_mm");
    let drawn = |said, curves: &[&Curve]| {
        let distance = Axis::new(language.say("distance"), language.say("mm"));
        (!curves.is_empty()).then(|| figure(said, distance, curves, Vec::new(), language))
    };
    let of_tip = (
        "Torch tip beside the planned path",
        "Distance of the true torch tip from the seam, normal to it, of each {0} mm the greatest.",
    );
    let of_weld = (
        "Weld beside the joint",
        "Where the weld lies beside the joint, lateral and in height, of each {0} mm the greatest.",
    );
    let blocks: Vec<Block> = drawn(of_tip, &path).into_iter().chain(drawn(of_weld, &seam)).collect();
    match blocks.is_empty() {
        true => vec![Block::Paragraph(language.say("Nothing of it is known.").to_owned())],
        false => blocks,
    }
}
