//! Comparison of a pass with its welding procedure: figures, charts and tables.

use super::range::Range;
use crate::number::{NONE, Significant as _, allowed, fixed, from_to, number, range};
use crate::{Axis, Band, Block, Chart, Language, LimitLine, Series, Stretch, Table, Words as _, value_names};
use seamwright_message::{Message, Unit};
use seamwright_motion::procedure::PassProcedure;
use seamwright_program::{FilletOrButt, Inclination, Outside, Procedure, Run, WeldingPosition, Window};
use seamwright_record::figures::HEAT_INPUT;
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

/// Maximum ratio of shown to allowed heat input: near a stop it has no bound.
const SHOWN: f64 = 2.5;

/// Plots slope and rotation over path length, with the positions above.
pub(super) fn positions(held: &PassProcedure, run: Option<&Run>, language: Language) -> Chart {
    let strip = held.positions.iter().map(|p| Stretch {
        label: p.position.to_string(),
        from: p.from_mm,
        to: p.to_mm,
        colour: p.position as usize,
        fault: !allows(run, p.position),
    });
    let curve = |name, of: fn(&Inclination) -> f64| {
        let points = held.inclinations.iter().map(|(s, at)| (*s, of(at).to_degrees()));
        Series::named(language, name, points.collect())
    };
    let lie = vec![curve("report-curve-slope", |at| at.slope), curve("report-curve-rotation", |at| at.rotation)];
    let angle = Axis::of(language, "report-label-angle", Unit::Deg);
    Chart { strip: strip.collect(), ..Chart::along(language, "report-chart-positions", angle, lie) }
}

/// Plots heat input over path length, if the pass gives its power.
pub(super) fn heat_input(held: &PassProcedure, language: Language) -> Option<Chart> {
    if held.heat_input.is_empty() {
        return None;
    }
    let quantity = held.quantities.iter().find(|q| q.key == HEAT_INPUT);
    let window = quantity.and_then(|q| q.allowed).map(Window::ends);
    let Range { min, max } = Range::of(held.heat_input.iter().map(|p| p.1).filter(|v| v.is_finite()));
    let y_range = window.map(|(low, high)| {
        let (low, high) = (low.min(min), high.max(max.max(0.0).min(SHOWN * high)));
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
    let series = vec![Series::named(language, "report-label-heat-input", held.heat_input.clone())];
    let heat = Axis::of(language, "report-label-heat-input", Unit::KiloJPerMm);
    Some(Chart {
        limits: limits.collect(),
        bands: bands.collect(),
        y_range,
        height: Some(170.0),
        ..Chart::along(language, "report-chart-heat-input", heat, series)
    })
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

/// Returns the planned values, each with its verdict, against the allowed ones.
pub(super) fn windows_table(
    caption: String,
    rows: impl Iterator<Item = (QuantityFigures, String)>,
    language: Language,
) -> Block {
    let end = |end: Option<f64>| end.map_or_else(|| NONE.to_owned(), |v| value(v, language));
    let table = Table::of(language, rows)
        .text("report-column-value", |(q, _)| value_names::value(language, &q.key))
        .number("report-column-min", |(q, _)| end(q.found.map(|found| found.0)))
        .number("report-column-max", |(q, _)| end(q.found.map(|found| found.1)))
        .text("report-column-allowed", |(q, _)| allowed(q.allowed, language))
        .text("", |(_, verdict)| verdict.clone());
    Block::Table(table.table(caption))
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
    let at = |code, o: &Outside| range(code, (o.from_mm, o.to_mm), Unit::Mm);
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
    ends.map_or_else(|| NONE.to_owned(), range)
}
