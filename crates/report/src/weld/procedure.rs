//! Comparison of a pass with its welding procedure: figures, charts and tables.

use super::blocks::{number, table};
use super::chart_parts::{axis, chart, line};
use crate::block::Block;
use crate::chart::{Band, Chart, Stretch};
use crate::limit::LimitLine;
use crate::names;
use crate::number::{Significant as _, fixed, from_to};
use crate::words::Words as _;
use seamwright_message::{Language, Message, Unit};
use seamwright_motion::procedure::PassProcedure;
use seamwright_program::{FilletOrButt, Outside, Procedure, Run, WeldingPosition, Window};
use serde::Serialize;

/// The procedure of a weld.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ProcedureFigures {
    /// Its number.
    pub number: String,
    /// Its title.
    pub title: String,
    /// Number of the process in ISO 4063.
    pub process: u16,
    /// Name of the process.
    pub process_name: &'static str,
    /// Fraction of the power that counts as heat input.
    pub thermal_efficiency: f64,
}

impl ProcedureFigures {
    pub(super) fn new(procedure: &Procedure) -> Self {
        Self {
            number: procedure.number.clone(),
            title: procedure.title.clone(),
            process: procedure.process.number,
            process_name: procedure.process.name,
            thermal_efficiency: procedure.thermal_efficiency(),
        }
    }
}

/// Values of a pass and the limits of its procedure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PassProcedureFigures {
    /// Run of the procedure for this pass; `None` if it has no matching run.
    pub run: Option<String>,
    /// The same, for the page.
    #[serde(skip)]
    pub(super) run_label: Option<Message>,
    /// Kind of weld for the positions: `fillet` or `butt`.
    pub joint: FilletOrButt,
    /// Values along the pass.
    pub quantities: Vec<QuantityFigures>,
    /// Allowed positions; `None` allows any.
    pub positions_allowed: Option<Vec<WeldingPosition>>,
    /// Positions in order along the pass.
    pub positions: Vec<PositionFigures>,
}

/// A value along a pass.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct QuantityFigures {
    /// Key, which ends in the unit.
    pub key: String,
    /// Minimum and maximum value of the plan; `None` if it is to be measured or unknown.
    pub found: Option<(f64, f64)>,
    /// Minimum and maximum allowed value.
    pub allowed: Option<(f64, f64)>,
    /// Stretches outside the allowed range; a value without bound (a torch at rest) is null.
    pub outside: Vec<Outside>,
}

/// A stretch in one welding position.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PositionFigures {
    /// The position.
    pub position: WeldingPosition,
    /// Whether the procedure allows it.
    pub allowed: bool,
    /// Path length of its start, mm.
    pub from_mm: f64,
    /// Path length of its end, mm.
    pub to_mm: f64,
    /// Minimum and maximum slope in it, degrees.
    pub slope_deg: Option<(f64, f64)>,
    /// Minimum and maximum rotation in it, degrees.
    pub rotation_deg: Option<(f64, f64)>,
}

fn allows(run: Option<&Run>, position: WeldingPosition) -> bool {
    run.and_then(|r| r.positions.as_ref()).is_none_or(|allowed| allowed.contains(&position))
}

impl PassProcedureFigures {
    pub(super) fn new(held: &PassProcedure, run: Option<&Run>) -> Self {
        let degrees = |(least, greatest): (f64, f64)| (least.to_degrees(), greatest.to_degrees());
        let positions = held.positions.iter().map(|stretch| {
            let lie = held.inclination_in(stretch);
            PositionFigures {
                position: stretch.position,
                allowed: allows(run, stretch.position),
                from_mm: stretch.from_mm,
                to_mm: stretch.to_mm,
                slope_deg: lie.map(|lie| degrees(lie.0)),
                rotation_deg: lie.map(|lie| degrees(lie.1)),
            }
        });
        let quantities = held.quantities.iter().map(|q| QuantityFigures {
            key: q.key.clone(),
            found: q.found,
            allowed: q.allowed.map(Window::ends),
            outside: q.outside.clone(),
        });
        Self {
            run: held.run.as_ref().map(|run| run.in_language(Language::English)),
            run_label: held.run.clone(),
            joint: held.joint,
            quantities: quantities.collect(),
            positions_allowed: run.and_then(|r| r.positions.clone()),
            positions: positions.collect(),
        }
    }
}

/// Charts of a pass against its procedure.
#[derive(Debug, Clone)]
pub struct ProcedurePlots {
    /// Heat input over path length, if the pass gives its power.
    pub heat_input: Option<Chart>,
    /// Slope and rotation over path length, with the positions above.
    pub positions: Chart,
}

/// Maximum ratio of shown to allowed heat input: near a stop it has no bound.
const SHOWN: f64 = 2.5;

impl ProcedurePlots {
    pub(super) fn new(held: &PassProcedure, run: Option<&Run>, language: Language) -> Self {
        let strip = held.positions.iter().map(|p| Stretch {
            label: p.position.to_string(),
            from: p.from_mm,
            to: p.to_mm,
            colour: p.position as usize,
            fault: !allows(run, p.position),
        });
        let curve = |of: fn(&seamwright_program::Inclination) -> f64| {
            held.inclinations.iter().map(|(s, at)| (*s, of(at).to_degrees())).collect()
        };
        let lie = vec![
            line(language, "report-curve-slope", curve(|at| at.slope)),
            line(language, "report-curve-rotation", curve(|at| at.rotation)),
        ];
        Self {
            heat_input: (!held.heat_input.is_empty()).then(|| heat_input(held, language)),
            positions: Chart {
                strip: strip.collect(),
                ..chart(language, "report-chart-positions", axis(language, "report-label-angle", Unit::Deg), lie)
            },
        }
    }
}

fn heat_input(held: &PassProcedure, language: Language) -> Chart {
    let quantity = held.quantities.iter().find(|q| q.key == "heat_input_kj_mm");
    let window = quantity.and_then(|q| q.allowed).map(Window::ends);
    let values = || held.heat_input.iter().map(|p| p.1).filter(|v| v.is_finite());
    let (least, greatest) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
    let y_range = window.map(|(low, high)| {
        let (low, high) = (low.min(least), high.max(greatest.min(SHOWN * high)));
        let room = 0.12 * (high - low).max(0.01 * high);
        ((low - room).max(0.0), high + room)
    });
    let outside = quantity.into_iter().flat_map(|q| &q.outside);
    let bands = outside.map(|o| Band {
        label: language.words(if o.above { "report-too-high" } else { "report-too-low" }),
        from: o.from_mm,
        to: o.to_mm,
    });
    let limit = |label, value| LimitLine::new(language.words(label), value);
    let limits =
        window.into_iter().flat_map(|(low, high)| [limit("report-limit-min", low), limit("report-limit-max", high)]);
    let series = vec![line(language, "report-label-heat-input", held.heat_input.clone())];
    Chart {
        limits: limits.collect(),
        bands: bands.collect(),
        y_range,
        height: Some(170.0),
        ..chart(
            language,
            "report-chart-heat-input",
            axis(language, "report-label-heat-input", Unit::KiloJPerMm),
            series,
        )
    }
}

/// Describes procedure, run and calculation of heat input.
pub(super) fn procedure_text(procedure: &ProcedureFigures, pass: &PassProcedureFigures, language: Language) -> String {
    let run = match &pass.run_label {
        Some(run) => Message::new("report-run").message("run", run.clone()),
        None => Message::new("report-no-run"),
    };
    let joint = match pass.joint {
        FilletOrButt::Fillet => "fillet",
        FilletOrButt::Butt => "butt",
    };
    let process = procedure.process.to_string();
    let process_name = language.named("process", &process).unwrap_or_else(|| procedure.process_name.to_owned());
    Message::new("report-procedure")
        .text("number", &procedure.number)
        .text("title", &procedure.title)
        .message("run", run)
        .text("process", process)
        .text("process_name", process_name)
        .significant("efficiency", procedure.thermal_efficiency, Unit::One, 5)
        .text("joint", joint)
        .in_language(language)
}

/// Returns the planned values against the allowed ones.
pub(super) fn windows_table(figures: &PassProcedureFigures, language: Language) -> Block {
    let rows = figures.quantities.iter().map(|q| window_row(q, verdict(q, language), language));
    windows(&language.words("report-caption-plan-values"), rows.collect(), language)
}

pub(super) fn windows(caption: &str, rows: Vec<Vec<String>>, language: Language) -> Block {
    let head = ["report-column-value", "report-column-min", "report-column-max", "report-column-allowed", ""]
        .map(|head| language.words(head));
    table(caption, &head, rows, 1..3)
}

pub(super) fn window_row(q: &QuantityFigures, verdict: String, language: Language) -> Vec<String> {
    let (least, greatest) = match q.found {
        Some((least, greatest)) => (value(least, language), value(greatest, language)),
        None => ("–".to_owned(), "–".to_owned()),
    };
    let allowed = match q.allowed {
        Some((least, greatest)) => from_to(number(least, language), number(greatest, language), language),
        None => language.words("report-not-limited"),
    };
    vec![names::value(language, &q.key), least, greatest, allowed, verdict]
}

/// Formats a value; rounding noise becomes zero.
fn value(v: f64, language: Language) -> String {
    match v {
        v if v.is_infinite() => language.words("report-unbounded"),
        v if v.abs() < 1e-6 => "0".to_owned(),
        v => number(v, language),
    }
}

pub(super) fn verdict(q: &QuantityFigures, language: Language) -> String {
    let at = |code, o: &Outside| {
        Message::new(code).significant("from", o.from_mm, Unit::One, 5).significant("to", o.to_mm, Unit::Mm, 5)
    };
    let message = match (q.found, q.allowed, q.outside.as_slice()) {
        (None, Some(_), _) if ["preheat_c", "interpass_c"].contains(&q.key.as_str()) => {
            Message::new("report-to-be-measured")
        }
        (None, Some(_), _) => Message::new("report-unknown-see-findings"),
        (_, None, _) => return String::new(),
        (_, _, []) => Message::new("report-within"),
        (_, _, [only]) => at("report-outside-at", only),
        (_, _, [first, more @ ..]) => at("report-outside-at-more", first).count("n", more.len()),
    };
    message.in_language(language)
}

/// Returns the positions in order along the pass.
pub(super) fn positions_table(figures: &PassProcedureFigures, language: Language) -> Block {
    let rows = figures.positions.iter().map(|p| {
        vec![
            p.position.to_string(),
            number(p.from_mm, language),
            number(p.to_mm, language),
            degrees(p.slope_deg, language),
            degrees(p.rotation_deg, language),
            language.words(if p.allowed { "report-allowed" } else { "report-not-allowed" }),
        ]
    });
    let head = [
        "report-column-position",
        "report-column-from",
        "report-column-to",
        "report-column-slope",
        "report-column-rotation",
        "",
    ]
    .map(|head| language.words(head));
    table(&positions_caption(figures, language), &head, rows.collect(), 1..5)
}

pub(super) fn positions_caption(figures: &PassProcedureFigures, language: Language) -> String {
    match &figures.positions_allowed {
        None => language.words("report-caption-positions-any"),
        Some(allowed) => {
            let names: Vec<String> = allowed.iter().map(WeldingPosition::to_string).collect();
            let message = Message::new("report-caption-positions-allowed").text("positions", names.join(", "));
            message.in_language(language)
        }
    }
}

pub(super) fn degrees(ends: Option<(f64, f64)>, language: Language) -> String {
    let range = |(least, greatest)| from_to(fixed(least, 1, language), fixed(greatest, 1, language), language);
    ends.map_or_else(|| "–".to_owned(), range)
}
