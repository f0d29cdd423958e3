use crate::bead::Bead;
use crate::pass::Pass;
use crate::path_length::{is_before, is_beyond};
use crate::path_range::PathRange;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// A step-over: the torch goes over to the line of the next bead without stopping the arc.
///
/// The torch leaves the line of one bead at the start of the step-over and is on that of the next at its end. In between
/// position, work angle and area change by [`StepOver::part`] of the way, twice continuously differentiable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepOver {
    /// Middle of the step-over by the pass' own path length, mm.
    pub at_mm: Positive,
    /// Length of seam over which the torch goes over, mm.
    pub length_mm: Positive,
    /// The bead that it goes over to.
    pub bead: Bead,
}

impl StepOver {
    /// Range of the pass' own path length, mm.
    pub fn range(&self) -> PathRange {
        let half = 0.5 * self.length_mm.get();
        PathRange { from_mm: self.at_mm.get() - half, to_mm: self.at_mm.get() + half }
    }

    /// Part of the way to the next bead at the pass' own path length `s`, with its derivative per mm.
    ///
    /// It is the polynomial of degree 5 whose first and second derivatives vanish at both ends. The parts at equal
    /// distances before and after the middle sum to 1.
    pub fn part(&self, s: f64) -> (f64, f64) {
        let length = self.length_mm.get();
        let u = ((s - self.range().from_mm) / length).clamp(0.0, 1.0);
        let part = u * u * u * (10.0 + u * (6.0 * u - 15.0));
        (part, 30.0 * (u * (1.0 - u)).powi(2) / length)
    }

    /// The same step-over, earlier by `by` mm. `None` if its middle would not be inside the pass.
    fn earlier(&self, by: f64) -> Option<Self> {
        Some(Self { at_mm: Positive::new(self.at_mm.get() - by)?, ..self.clone() })
    }
}

impl Pass {
    /// The beads in the order of welding, each with the range of the pass' own path length on which it gets metal, mm.
    /// The ranges of neighbours overlap by their step-over.
    pub fn beads(&self) -> impl Iterator<Item = (&Bead, PathRange)> {
        let starts = std::iter::once(0.0).chain(self.step_overs.iter().map(|step| step.range().from_mm));
        let ends = self.step_overs.iter().map(|step| step.range().to_mm).chain(std::iter::once(self.length()));
        let beads = self.bead.iter().chain(self.step_overs.iter().map(|step| &step.bead));
        beads.zip(starts.zip(ends)).map(|(bead, (from_mm, to_mm))| (bead, PathRange { from_mm, to_mm }))
    }

    /// The bead and the step-overs of the part of the pass in a range of its own path length: those whose middle is in it.
    pub(crate) fn step_overs_within(&self, range: PathRange) -> (Option<Bead>, Vec<StepOver>) {
        let first = self.step_overs.partition_point(|step| step.at_mm.get() <= range.from_mm);
        let bead = first.checked_sub(1).map(|last| self.step_overs[last].bead.clone()).or_else(|| self.bead.clone());
        let after = self.step_overs[first..].iter().take_while(|step| step.at_mm.get() < range.to_mm);
        (bead, after.filter_map(|step| step.earlier(range.from_mm)).collect())
    }

    /// The bead and the step-overs of the same pass from its end to its start.
    pub(crate) fn step_overs_turned(&self) -> (Option<Bead>, Vec<StepOver>) {
        let length = self.length();
        let mut beads = self.bead.iter().chain(self.step_overs.iter().map(|step| &step.bead)).rev().cloned();
        let bead = beads.next();
        let turned = |(step, bead): (&StepOver, Bead)| {
            Some(StepOver { at_mm: Positive::new(length - step.at_mm.get())?, bead, ..step.clone() })
        };
        (bead, self.step_overs.iter().rev().zip(beads).filter_map(turned).collect())
    }

    /// Checks the step-overs: with a bead before the first one, one after the other, all within the pass. `path` is the
    /// pass' address in `file`. Fails with the key's address.
    pub(crate) fn check_step_overs<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        if self.bead.is_none() && !self.step_overs.is_empty() {
            let allowed = Message::new("program-at-least-one-table").key("table", "[passes.bead]");
            let key = format!("{path}.step_overs[0]");
            return Err(file.error_at(&key, Message::new("program-step-over-without-bead"), allowed));
        }
        let (mut end, length) = (0.0, self.length());
        for (i, step) in self.step_overs.iter().enumerate() {
            step.bead.check(file, &format!("{path}.step_overs[{i}].bead"))?;
            let PathRange { from_mm: from, to_mm: to } = step.range();
            if is_before(from, end) || is_beyond(to, length) {
                let half = 0.5 * step.length_mm.get();
                let message = Message::new("program-step-over-misplaced").quantity("from", from, Unit::Mm, 1).quantity(
                    "to",
                    to,
                    Unit::Mm,
                    1,
                );
                let allowed = Message::new("document-between").quantity("min", end + half, Unit::Mm, 3).quantity(
                    "max",
                    length - half,
                    Unit::Mm,
                    3,
                );
                return Err(file.error_at(&format!("{path}.step_overs[{i}].at_mm"), message, allowed));
            }
            end = to;
        }
        Ok(())
    }

    /// Adds to columns of all its beads.
    pub(crate) fn shift_beads(&mut self, by: BeadShift) {
        let steps = self.step_overs.iter_mut().map(|step| &mut step.bead);
        for bead in self.bead.iter_mut().chain(steps) {
            add(&mut bead.across_mm, by.across_mm);
            add(&mut bead.out_mm, by.out_mm);
            add(&mut bead.work_angle_deg, by.work_angle_deg);
        }
    }
}

/// Numbers to be added to the columns of a bead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BeadShift {
    pub(crate) across_mm: f64,
    pub(crate) out_mm: f64,
    pub(crate) work_angle_deg: f64,
}

fn add(column: &mut [Finite], by: f64) {
    for value in column {
        *value = Finite::new(value.get() + by).unwrap_or(*value);
    }
}
