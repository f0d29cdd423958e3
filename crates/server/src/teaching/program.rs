use super::state::{Found, Teaching};
use crate::wire::{TaughtProgram, TeachProgram};
use glam::DVec3;
use seamwright_geometry::reduce::Method;
use seamwright_message::{Message, Unit};
use seamwright_project::Failure;
use seamwright_teaching::{self as teaching, Figures, Kind, ReductionTolerances, bridged};
use std::sync::Arc;

/// Converts the taught points to a program.
/// Fails if no points were taught, or numbers are not allowed.
pub(crate) fn program(teaching: &Teaching, asked: &TeachProgram) -> Result<TaughtProgram, Failure> {
    let wrong = |what: &str, value: f64, most: f64| {
        let message = Message::new("server-teach-above").key("key", what);
        Failure::input(message.value("value", value, Unit::One).value("max", most, Unit::One))
    };
    for (what, value, most) in [("tolerance_mm", asked.tolerance_mm, 5.0), ("attitude_deg", asked.attitude_deg, 90.0)] {
        if !(value > 0.0 && value <= most) {
            return Err(wrong(what, value, most));
        }
    }
    let kind = match asked.method.as_str() {
        "greedy" => Kind::Arcs(Method::Greedy),
        "fewest" => Kind::Arcs(Method::Fewest),
        "spline" => Kind::Spline,
        other => {
            return Err(Failure::input(
                Message::new("server-teach-method").text("method", other).text("allowed", "greedy, fewest, spline"),
            ));
        }
    };
    let found: Option<Arc<Found>> = teaching.state().found.clone();
    let found = found.filter(|found| found.outcome.smooth.len() > 1);
    let found = found.ok_or_else(|| Failure::input(Message::new("server-teach-nothing")))?;
    let Found { loaded, nominal, outcome, truth } = &*found;
    let tolerances = ReductionTolerances { path_mm: asked.tolerance_mm, attitude_rad: asked.attitude_deg.to_radians() };
    let (reduced, text) =
        teaching::reduced(&loaded.welding, nominal, &outcome.smooth, tolerances, kind, "taught.toml")?;
    let figures = Figures::new(nominal, outcome, &reduced);
    let from_nominal = figures.raw.iter().filter_map(|p| p.from_nominal);
    Ok(TaughtProgram {
        text,
        counts: reduced.curves.counts(),
        length_mm: outcome.smooth.windows(2).map(|w| w[0].point.distance(w[1].point)).sum(),
        error_mm: reduced.curves.max_error(),
        raw_error_mm: figures.raw_error().filter(|e| e.is_finite()),
        from_nominal_mm: from_nominal.map(|(a, b)| (a.abs(), b.abs())).reduce(|m, p| (m.0.max(p.0), m.1.max(p.1))),
        bridged_mm: bridged(outcome),
        truth_mm: truth.map(|t| (t.across_max, t.height_max)).filter(|t| t.0.is_finite() && t.1.is_finite()),
        path: figures.path.iter().map(DVec3::to_array).collect(),
    })
}
