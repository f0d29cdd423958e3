//! Findings for a plan outside its procedure.

use super::{PassProcedure, Quantity};
use seamwright_program::{Finding, Outside, Pass, PositionStretch, Procedure, Run, WeldingPosition, Window};

/// Cure that applies to all of them.
const OTHERWISE: &str = "or use a procedure that is qualified for it";

/// The findings of a pass under `procedure`.
pub(super) fn findings(
    held: &PassProcedure,
    procedure: &Procedure,
    run: Option<&Run>,
    (pass, number): (&Pass, usize),
) -> Vec<Finding> {
    let finding = |(from_mm, to_mm): (f64, f64), message: String, cure: &str| Finding {
        kind: "procedure",
        message: message.into(),
        pass: number,
        from_mm,
        to_mm,
        cure: Some(format!("{cure}; {OTHERWISE}").into()),
        allowed: false,
    };
    let whole = (0.0, pass.length());
    let Some(run) = run else {
        let message = format!("no run of {} is for pass {number} ({})", procedure.number, pass.name);
        let cure = "add [[runs]] with the pass's name or number to the procedure file, or rename the pass";
        return vec![finding(whole, message, cure)];
    };
    let allows = format!("{} allows ({})", procedure.number, run.label());
    let mut all = Vec::new();
    for quantity in &held.quantities {
        let Some(allowed) = quantity.allowed else { continue };
        match quantity.found {
            None if !["preheat_c", "interpass_c"].contains(&quantity.key.as_str()) => {
                let (why, cure) = unknown(&quantity.key, procedure, pass);
                let message = format!("{why}: {allows} {} of {}", range(allowed), named(&quantity.key));
                all.push(finding(whole, message, &cure));
            }
            _ => all.extend(quantity.outside.iter().map(|stretch| {
                let message = format!("{}; {allows} {}", value(quantity, stretch), range(allowed));
                finding((stretch.from_mm, stretch.to_mm), message, &cure(&quantity.key, stretch.above))
            })),
        }
    }
    if let Some(allowed) = &run.positions {
        let names: Vec<String> = allowed.iter().map(WeldingPosition::to_string).collect();
        for stretch in held.positions.iter().filter(|stretch| !allowed.contains(&stretch.position)) {
            let message = format!("{}; {allows} {}", position(held, stretch), names.join(", "));
            let cure = "turn or tilt the part otherwise (placement, work offset, spare_axes), or weld the other way round \
                        where that makes uphill of downhill";
            all.push(finding((stretch.from_mm, stretch.to_mm), message, cure));
        }
    }
    all
}

/// Name and unit of a quantity.
fn parts(key: &str) -> (&str, &str) {
    match key {
        "speed_mm_s" => ("speed of the tip", "mm/s"),
        "heat_input_kj_mm" => ("heat input", "kJ/mm"),
        "travel_angle_deg" => ("travel angle", "degrees"),
        "work_angle_deg" => ("work angle", "degrees"),
        _ => (key, ""),
    }
}

fn named(key: &str) -> &str {
    parts(key).0
}

fn range(window: Window) -> String {
    let (least, greatest) = window.ends();
    format!("{} to {}", number(least), number(greatest))
}

/// Formats a number with at most four decimals.
fn number(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn value(quantity: &Quantity, stretch: &Outside) -> String {
    let (name, unit) = parts(&quantity.key);
    if stretch.found.is_infinite() {
        return format!("the {name} has no bound: the torch stops at s = {:.3} mm with the arc on", stretch.at_mm);
    }
    let (found, at) = (number(stretch.found), stretch.at_mm);
    match unit {
        "" => format!("{name} is {found} at s = {at:.3} mm"),
        unit => format!("the {name} is {found} {unit} at s = {at:.3} mm"),
    }
}

/// Reason for a value that is missing in the plan but has a window, and the cure.
fn unknown(key: &str, procedure: &Procedure, pass: &Pass) -> (String, String) {
    let has = |name: &str| pass.spans.first().is_some_and(|span| span.process.contains_key(name));
    match key {
        "heat_input_kj_mm" => {
            let lacking: Vec<&str> = procedure.power_names().filter(|name| !has(name)).collect();
            let lacking = lacking.join(" and ");
            (
                format!("the pass does not give {lacking}, so its heat input is not known"),
                format!(
                    "give {lacking} in weld.process, or set `power` in the procedure to the values that make the power"
                ),
            )
        }
        "work_angle_deg" => (
            "the faces of the joint are not known, so there is no work angle".to_owned(),
            "take work_angle_deg out of the run".to_owned(),
        ),
        _ => (
            format!("the pass does not give {key}"),
            format!("give {key} in weld.process, or take it out of [runs.ranges]"),
        ),
    }
}

fn cure(key: &str, above: bool) -> String {
    match (key, above) {
        ("speed_mm_s", true) => "ask for less speed there".to_owned(),
        ("speed_mm_s", false) => "ask for more speed there, or place the work so that the axes can keep it".to_owned(),
        ("heat_input_kj_mm", true) => "weld faster or with less power there".to_owned(),
        ("heat_input_kj_mm", false) => "weld slower or with more power there".to_owned(),
        ("travel_angle_deg" | "work_angle_deg", _) => {
            "change the torch angles there, or use a machine with axes enough for them".to_owned()
        }
        (_, true) => format!("lower {key} there (weld.process of the job, or spans of the program)"),
        (_, false) => format!("raise {key} there (weld.process of the job, or spans of the program)"),
    }
}

/// Words a position and the weld's inclination in it.
fn position(held: &PassProcedure, stretch: &PositionStretch) -> String {
    let degrees = |(low, high): (f64, f64)| format!("{:.1} to {:.1}", low.to_degrees(), high.to_degrees());
    let lie = held.inclination_in(stretch).map_or(String::new(), |(slope, rotation)| {
        format!(" (slope {} degrees, rotation {} degrees)", degrees(slope), degrees(rotation))
    });
    format!("the weld is in position {}{lie}", stretch.position)
}
