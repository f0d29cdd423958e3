//! Fault injection: every fault of every device in every situation of a cell, compared with the required results.

mod case;
mod expected;
mod outcome;
mod trial;
mod trial_operator;

pub use case::{Case, Situation};
pub use expected::{Expected, expected};
pub use outcome::Outcome;
pub use trial::{Stage, TrackedStage, Trial};
pub use trial_operator::TrialOperator;

use crate::devices::fault::{Device, FaultKind};
use crate::error::Error;
use seamwright_executive::Mode;
use seamwright_machine::{Level, Machine};
use seamwright_message::{Message, Unit};

/// Returns all cases: every device, fault and situation; inverted inputs once per level; missed cycles. Sensor faults
/// are included if there is a weld with tracking.
pub fn cases(stage: &Stage<'_>) -> Vec<Case> {
    let of = |level: Level| stage.machine.interlocks.iter().position(|i| i.level == level).map(|i| i as u8);
    let levels: Vec<u8> = [Level::Power, Level::Motion, Level::Process].into_iter().filter_map(of).collect();
    let mut cases = Vec::new();
    for device in Device::ALL {
        if device == Device::Sensors && stage.tracked.is_none() {
            continue;
        }
        for kind in FaultKind::ALL {
            let inputs = device == Device::Inputs && kind == FaultKind::Wrong;
            let which = if inputs { levels.clone() } else { vec![0] };
            for which in which {
                cases.extend(Situation::ALL.map(|situation| Case { device, kind, which, situation }));
            }
        }
    }
    let (device, kind) = (Device::Cycle, FaultKind::Slow);
    cases.extend(Situation::ALL.map(|situation| Case { device, kind, which: 0, situation }));
    cases
}

/// Runs one case. `seed` sets the exact time of the fault: soon after the start of the situation, or with `anywhere` at
/// any moment of a weld's first twenty seconds.
///
/// # Errors
/// Invalid drive values of the machine.
pub fn run(stage: Stage<'_>, case: Case, seed: u64, anywhere: bool) -> Result<Outcome, Error> {
    Trial::new(stage, case, seed, anywhere)?.run()
}

/// Returns the outcomes as Markdown: one row per device and fault, one column per situation, with the resulting mode
/// and the first alarm.
pub fn table(machine: &Machine, outcomes: &[Outcome]) -> String {
    let mut text = String::from("| fault |");
    Situation::ALL.iter().for_each(|s| text += &format!(" {} |", s.name()));
    text += "\n|---|";
    text += &"---|".repeat(Situation::ALL.len());
    let mut rows: Vec<(Case, Vec<&Outcome>)> = Vec::new();
    for outcome in outcomes {
        let key = Case { situation: Situation::Off, ..outcome.case };
        match rows.iter_mut().find(|(row, _)| *row == key) {
            Some((_, row)) => row.push(outcome),
            None => rows.push((key, vec![outcome])),
        }
    }
    for (case, row) in rows {
        let which = match (case.device, case.kind) {
            (Device::Inputs, FaultKind::Wrong) => machine
                .interlocks
                .get(usize::from(case.which))
                .map_or(String::new(), |i| format!(" ({})", i.level.name())),
            _ => String::new(),
        };
        text += &format!("\n| {} {}{which} |", case.device.name(), case.kind.name());
        for outcome in row {
            let alarm = outcome.first_alarm.map_or(String::new(), |a| format!(" ({})", a.number()));
            let kept = if outcome.is_kept() { "" } else { "**!** " };
            text += &format!(" {kept}{}{alarm} |", outcome.mode);
        }
    }
    text + "\n"
}

/// Returns a summary in a few words.
pub fn summary(outcomes: &[Outcome]) -> Message {
    let kept = outcomes.iter().filter(|o| o.is_kept()).count();
    let stops = outcomes.iter().map(|o| o.stop_mm).fold(0.0, f64::max);
    let bound = 100.0 * outcomes.iter().map(|o| o.stop_part).fold(0.0, f64::max);
    let cycles = outcomes.iter().map(|o| o.off_cycles).max().unwrap_or(0);
    let faults = outcomes.iter().filter(|o| o.mode == Mode::Fault).count();
    Message::new("cell-fault-injection-summary")
        .number("kept", kept as f64, 0)
        .number("all", outcomes.len() as f64, 0)
        .number("faults", faults as f64, 0)
        .count("cycles", cycles as usize)
        .quantity("stop", stops, Unit::Mm, 2)
        .quantity("bound", bound, Unit::Percent, 0)
}
