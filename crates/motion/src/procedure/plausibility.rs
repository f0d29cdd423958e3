//! Comparison of current, voltage and wire feed of a pass with one another.

use super::planned_pass::PlannedPass;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, PathRange, Procedure, Role};

/// Warnings about values of the pass that do not go with its current.
pub(super) fn findings(procedure: &Procedure, planned: PlannedPass) -> Vec<Finding> {
    let PlannedPass { machine, pass, number, .. } = planned;
    let stick_out = pass.torch.stick_out_or(machine.stick_out_mm);
    // A cosmetic pass may have any arc.
    let Some(span) = pass.spans.first().filter(|_| pass.known_role() != Some(Role::Cosmetic)) else {
        return Vec::new();
    };
    let at_start = |name: &str| span.process.get(name).map(|value| value.at(0.0));
    let Some(current) = at_start("current_a").filter(|current| *current > 0.0) else { return Vec::new() };
    let mut all = Vec::new();
    for expected in procedure.expected(current, stick_out) {
        let Some(found) = at_start(expected.name) else { continue };
        let percent = 100.0 * (found / expected.value - 1.0);
        if percent.abs() > procedure.plausibility.percent.get() {
            let message = Message::new("motion-implausible")
                .key("key", expected.name)
                .value("found", found, Unit::One)
                .value("current", current, Unit::A)
                .quantity("expected", expected.value, Unit::One, 1)
                .value("percent", procedure.plausibility.percent.get(), Unit::Percent);
            let cure = Message::new("motion-cure-implausible").key("key", expected.name);
            let range = PathRange::at(0.0);
            all.push(Finding { allowed: true, ..Finding::error("plausible", message, number, range, cure) });
        }
    }
    all
}
