//! Findings for a plan outside its procedure.

use super::PassProcedure;
use super::planned_pass::{PlannedPass, Quantity};
use seamwright_message::{Argument, Message, Unit};
use seamwright_program::{Finding, Outside, Pass, PathRange, PositionStretch, Procedure, Run, WeldingPosition};

/// Temperatures are measured before welding, not planned.
const MEASURED: [&str; 2] = ["preheat_c", "interpass_c"];

pub(super) fn findings(
    held: &PassProcedure,
    procedure: &Procedure,
    run: Option<&Run>,
    planned: PlannedPass,
) -> Vec<Finding> {
    let PlannedPass { pass, number, .. } = planned;
    let finding = |range: PathRange, message: Message, cure: Message| {
        Finding::error("procedure", message.text("procedure", procedure.number.as_str()), number, range, cure)
    };
    let whole = PathRange::up_to(pass.length());
    let Some(run) = run else {
        let message = Message::new("motion-procedure-no-run").pass("pass", number).text("name", pass.name.as_str());
        return vec![finding(whole, message, Message::new("motion-cure-procedure-run"))];
    };
    let of_run = |message: Message| message.message("run", label(run));
    let mut all = Vec::new();
    for quantity in &held.quantities {
        let Some(allowed) = quantity.allowed else { continue };
        let (least, greatest) = allowed.ends();
        let unit = unit(&quantity.key);
        let within =
            |message: Message| of_run(message).value("min", rounded(least), unit).value("max", rounded(greatest), unit);
        match quantity.found {
            None if !MEASURED.contains(&quantity.key.as_str()) => {
                let (message, cure) = unknown(&quantity.key, procedure, pass);
                all.push(finding(whole, within(message), cure));
            }
            _ => all.extend(quantity.outside.iter().map(|stretch| {
                let message = within(value(quantity, stretch));
                finding(
                    PathRange { from_mm: stretch.from_mm, to_mm: stretch.to_mm },
                    message,
                    cure(&quantity.key, stretch.above),
                )
            })),
        }
    }
    if let Some(allowed) = &run.positions {
        for stretch in held.positions.iter().filter(|stretch| !allowed.contains(&stretch.position)) {
            let names = allowed.iter().map(WeldingPosition::to_string).map(Argument::Text);
            let message = of_run(position(held, stretch)).list("positions", names);
            let cure = Message::new("motion-cure-procedure-position");
            all.push(finding(PathRange { from_mm: stretch.from_mm, to_mm: stretch.to_mm }, message, cure));
        }
    }
    all
}

/// Names the passes that `run` is for.
pub(super) fn label(run: &Run) -> Message {
    match (&run.name, &run.passes) {
        (Some(role), _) => Message::verbatim(role.name()),
        (None, Some(passes)) => {
            let passes = passes.to_string();
            let several = passes.contains(['-', ',']);
            Message::new(if several { "motion-run-passes" } else { "motion-run-pass" }).text("passes", passes)
        }
        (None, None) => Message::default(),
    }
}

/// Unit of a quantity; the keys of process values end in theirs.
fn unit(key: &str) -> Unit {
    match key {
        "speed_mm_s" => Unit::MmPerS,
        "heat_input_kj_mm" => Unit::KiloJPerMm,
        "travel_angle_deg" | "work_angle_deg" => Unit::Deg,
        "stick_out_mm" => Unit::Mm,
        _ => Unit::One,
    }
}

fn name(key: &str) -> Argument {
    let code = match key {
        "speed_mm_s" => "motion-quantity-speed",
        "heat_input_kj_mm" => "motion-quantity-heat-input",
        "travel_angle_deg" => "motion-quantity-travel-angle",
        "work_angle_deg" => "motion-quantity-work-angle",
        "stick_out_mm" => "motion-quantity-stick-out",
        _ => return Argument::Key(key.to_owned()),
    };
    Argument::Message(Box::new(Message::new(code)))
}

fn rounded(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

fn value(quantity: &Quantity, stretch: &Outside) -> Message {
    let message = match stretch.found.is_infinite() {
        true => Message::new("motion-procedure-unbounded"),
        false => {
            let found = rounded(stretch.found);
            Message::new("motion-procedure-outside").value("found", found, unit(&quantity.key))
        }
    };
    message.with("quantity", name(&quantity.key)).quantity("at", stretch.at_mm, Unit::Mm, 3)
}

/// Message for a value that is missing in the plan but has a window, and the operator action.
fn unknown(key: &str, procedure: &Procedure, pass: &Pass) -> (Message, Message) {
    let has = |name: &str| pass.spans.first().is_some_and(|span| span.process.contains_key(name));
    match key {
        "heat_input_kj_mm" => {
            let missing = procedure.power_names().filter(|name| !has(name));
            let missing: Vec<Argument> = missing.map(|name| Argument::Key(name.to_owned())).collect();
            (
                Message::new("motion-procedure-no-power").list("keys", missing.clone()),
                Message::new("motion-cure-procedure-power").list("keys", missing),
            )
        }
        "work_angle_deg" => {
            (Message::new("motion-procedure-no-faces"), Message::new("motion-cure-procedure-work-angle"))
        }
        "stick_out_mm" => {
            (Message::new("motion-procedure-no-stick-out"), Message::new("motion-cure-procedure-stick-out"))
        }
        _ => (
            Message::new("motion-procedure-missing").key("key", key),
            Message::new("motion-cure-procedure-missing").key("key", key),
        ),
    }
}

fn cure(key: &str, above: bool) -> Message {
    match (key, above) {
        ("speed_mm_s", true) => Message::new("motion-cure-procedure-slower"),
        ("speed_mm_s", false) => Message::new("motion-cure-procedure-faster"),
        ("heat_input_kj_mm", true) => Message::new("motion-cure-procedure-less-heat"),
        ("heat_input_kj_mm", false) => Message::new("motion-cure-procedure-more-heat"),
        ("travel_angle_deg" | "work_angle_deg", _) => Message::new("motion-cure-procedure-angles"),
        ("stick_out_mm", _) => Message::new("motion-cure-procedure-own-stick-out"),
        (_, true) => Message::new("motion-cure-procedure-lower").key("key", key),
        (_, false) => Message::new("motion-cure-procedure-raise").key("key", key),
    }
}

/// Reports a position and the weld's inclination in it.
fn position(held: &PassProcedure, stretch: &PositionStretch) -> Message {
    let position = |code| Message::new(code).text("position", stretch.position.to_string());
    match held.inclination_in(stretch) {
        None => position("motion-procedure-position"),
        Some((slope, rotation)) => {
            let degrees = |message: Message, min, max, (low, high): (f64, f64)| {
                message.quantity(min, low.to_degrees(), Unit::Deg, 1).quantity(max, high.to_degrees(), Unit::Deg, 1)
            };
            let message = degrees(position("motion-procedure-inclination"), "min_slope", "max_slope", slope);
            degrees(message, "min_rotation", "max_rotation", rotation)
        }
    }
}
