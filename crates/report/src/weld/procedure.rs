//! Comparison of a pass with its welding procedure: figures, charts and tables.

use super::charts::{chart, line};
use super::page::{number, table};
use crate::Phrases as _;
use crate::{Band, Block, Chart, Language, LimitLine, Stretch, said};
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
            run: held.run.clone(),
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
            line(language, "slope (+ uphill)", curve(|at| at.slope)),
            line(language, "rotation of the face (0 up, 180 down)", curve(|at| at.rotation)),
        ];
        Self {
            heat_input: (!held.heat_input.is_empty()).then(|| heat_input(held, language)),
            positions: Chart { strip: strip.collect(), ..chart(language, "Welding position", ("angle", "deg"), lie) },
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
        label: language.say(if o.above { "too high" } else { "too low" }).to_owned(),
        from: o.from_mm,
        to: o.to_mm,
    });
    let limit = |label, value| LimitLine::new(language.say(label), value);
    let limits = window.into_iter().flat_map(|(low, high)| [limit("limit.least", low), limit("limit.greatest", high)]);
    let series = vec![line(language, "heat input", held.heat_input.clone())];
    Chart {
        limits: limits.collect(),
        bands: bands.collect(),
        y_range,
        height: Some(170.0),
        ..chart(language, "Heat input along the seam", ("heat input", "kJ/mm"), series)
    }
}

/// Describes procedure, run and calculation of heat input.
pub(super) fn procedure_text(procedure: &ProcedureFigures, pass: &PassProcedureFigures, language: Language) -> String {
    let run = match &pass.run {
        Some(run) => language.fill("run {0}", &[run]),
        None => language.say("no run of it is for this pass").to_owned(),
    };
    let joint = match pass.joint {
        FilletOrButt::Fillet => "fillet",
        FilletOrButt::Butt => "butt",
    };
    language.fill(
        "{0} ({1}), {2}. Process {3}: {4}. Heat input is {5} times the power over the planned speed. Positions are those of a {6} weld.",
        &[
            &procedure.number,
            &procedure.title,
            &run,
            &procedure.process.to_string(),
            language.say(procedure.process_name),
            &number(procedure.thermal_efficiency),
            language.say(joint),
        ],
    )
}

/// Returns the planned values against the allowed ones.
pub(super) fn windows_table(figures: &PassProcedureFigures, language: Language) -> Block {
    let rows = figures.quantities.iter().map(|q| window_row(q, verdict(q, language), language));
    windows(language.say("The plan against the procedure"), rows.collect(), language)
}

pub(super) fn windows(caption: &str, rows: Vec<Vec<String>>, language: Language) -> Block {
    let head = ["Value", "least", "greatest", "allowed", ""].map(|head| language.say(head));
    table(caption, &head, rows, 1..3)
}

pub(super) fn window_row(q: &QuantityFigures, verdict: String, language: Language) -> Vec<String> {
    let (least, greatest) = match q.found {
        Some((least, greatest)) => (value(least, language), value(greatest, language)),
        None => ("–".to_owned(), "–".to_owned()),
    };
    let allowed = match q.allowed {
        Some((least, greatest)) => language.fill("{0} to {1}", &[&number(least), &number(greatest)]),
        None => language.say("not limited").to_owned(),
    };
    vec![said::named_value(language, &q.key), least, greatest, allowed, verdict]
}

/// Formats a value; rounding noise becomes zero.
fn value(v: f64, language: Language) -> String {
    match v {
        v if v.is_infinite() => language.say("no bound").to_owned(),
        v if v.abs() < 1e-6 => "0".to_owned(),
        v => number(v),
    }
}

pub(super) fn verdict(q: &QuantityFigures, language: Language) -> String {
    let place = |o: &Outside| language.fill("{0} to {1}", &[&number(o.from_mm), &number(o.to_mm)]);
    let say = |text| language.say(text).to_owned();
    match (q.found, q.allowed, q.outside.as_slice()) {
        (None, Some(_), _) if ["preheat_c", "interpass_c"].contains(&q.key.as_str()) => say("to be measured"),
        (None, Some(_), _) => say("not known: see the findings"),
        (_, None, _) => String::new(),
        (_, _, []) => say("within"),
        (_, _, [only]) => language.fill("outside: s = {0} mm", &[&place(only)]),
        (_, _, [first, more @ ..]) => {
            language.fill("outside: s = {0} mm and {1} more stretches", &[&place(first), &more.len().to_string()])
        }
    }
}

/// Returns the positions in order along the pass.
pub(super) fn positions_table(figures: &PassProcedureFigures, language: Language) -> Block {
    let rows = figures.positions.iter().map(|p| {
        vec![
            p.position.to_string(),
            number(p.from_mm),
            number(p.to_mm),
            degrees(p.slope_deg, language),
            degrees(p.rotation_deg, language),
            language.say(if p.allowed { "limit.allowed" } else { "not allowed" }).to_owned(),
        ]
    });
    let head = ["Position", "From", "To", "Slope", "Rotation", ""].map(|head| language.say(head));
    table(&positions_caption(figures, language), &head, rows.collect(), 1..5)
}

pub(super) fn positions_caption(figures: &PassProcedureFigures, language: Language) -> String {
    match &figures.positions_allowed {
        None => language.say("Welding positions (mm, degrees); the procedure allows any").to_owned(),
        Some(allowed) => {
            let names: Vec<String> = allowed.iter().map(WeldingPosition::to_string).collect();
            language.fill("Welding positions (mm, degrees); the procedure allows {0}", &[&names.join(", ")])
        }
    }
}

pub(super) fn degrees(ends: Option<(f64, f64)>, language: Language) -> String {
    let said = |(least, greatest)| language.fill("{0} to {1}", &[&format!("{least:.1}"), &format!("{greatest:.1}")]);
    ends.map_or("–".to_owned(), said)
}
