use super::motors::Motor;
use super::stepped::{Clock, Stepped};
use super::{Place, Play};
use crate::failure::Failure;
use seamwright_message::{Message, Unit};
use seamwright_motion::pulses::{Edge, Error, Generator};
use seamwright_program::{Finding, PathRange};

/// Figures of the pulses, found without writing them.
pub(super) struct Checked {
    pub(super) periods: u64,
    /// Level of each direction line at the start: the direction of the first pulse.
    pub(super) positive: Vec<bool>,
    /// The generators as they are at the end.
    pub(super) generators: Vec<Generator>,
    /// Loss of each motor, if it was asked for and the file has the motor.
    pub(super) motors: Vec<Option<Loss>>,
}

/// Full steps lost for good.
#[derive(Debug, Clone, Copy)]
pub(super) struct Loss {
    pub(super) steps: i64,
    /// Time (s) and position up to which no step was lost; `None` without pulses.
    held: Option<(f64, Place)>,
}

/// Makes all pulses once, for the motors only.
pub(super) fn check(play: &mut Play, stepped: &[Stepped], with_motors: bool) -> Result<Checked, Failure> {
    let mut positive: Vec<Option<bool>> = vec![None; stepped.len()];
    let motor = |axis: &Stepped| if with_motors { Motor::new(axis) } else { Ok(None) };
    let mut motors = stepped.iter().map(motor).collect::<Result<Vec<_>, _>>()?;
    let clock = play.clock;
    let lines = play.pulses(stepped, |place, _, event| {
        if let Edge::Direction(first) = event.edge {
            positive[event.axis].get_or_insert(first);
        }
        if let Some(motor) = &mut motors[event.axis] {
            motor.hear(event, place, &clock);
        }
        Ok(())
    })?;
    let lost = |motor: &mut Option<Motor>| {
        let motor = motor.as_mut()?;
        let steps = motor.lost();
        Some(Loss { steps, held: motor.held.map(|(tick, place)| (clock.seconds(tick), place)) })
    };
    Ok(Checked {
        periods: play.motion.count(clock.period_s(), play.home).saturating_sub(1),
        positive: positive.into_iter().map(|p| p.unwrap_or(true)).collect(),
        generators: lines.iter().flat_map(|l| l.generators().copied()).collect(),
        motors: motors.iter_mut().map(lost).collect(),
    })
}

impl Checked {
    /// Motors that lose steps, as findings.
    pub(super) fn lost(&self, stepped: &[Stepped]) -> Vec<Finding> {
        let mut findings = Vec::new();
        for (axis, motor) in stepped.iter().zip(&self.motors) {
            let Some(Loss { steps, held: Some((t, place)) }) = motor.filter(|m| m.steps != 0) else { continue };
            let message = Message::new("cli-pulses-lost-steps").axis("axis", &axis.name);
            let message = message.count("steps", steps.unsigned_abs() as usize).quantity("time", t, Unit::S, 3);
            findings.push(place.finding("steps", message, "cli-cure-lost-steps"));
        }
        findings
    }
}

/// Pulses too close to each other, as a finding with axis, time and operator action.
pub(super) fn crowded(axis: &Stepped, clock: &Clock, place: &Place, periods: u64, error: Error) -> Failure {
    let what = match error {
        Error::TooFast { asked, .. } => Message::new("cli-pulses-too-fast")
            .number("asked", asked / clock.period_s(), 0)
            .count("microsteps", axis.choice.microsteps as usize)
            .number("max", axis.timing.max_hz(clock.tick_s()), 0),
        other => other.message(),
    };
    let cure = match error {
        Error::TooFast { .. } => "cli-cure-pulses-too-fast",
        Error::Crowded { .. } => "cli-cure-pulses-crowded",
        Error::Position { .. } | Error::Period { .. } => "cli-cure-fewer-microsteps",
    };
    let t = clock.seconds(periods * clock.ticks);
    let code = if place.pass == 0 { "cli-pulses-crowded-in-transfer" } else { "cli-pulses-crowded" };
    let message = Message::new(code).axis("axis", &axis.name).quantity("time", t, Unit::S, 6).message("fault", what);
    Failure::Findings(vec![place.finding("pulses", message, cure)])
}

impl Place {
    /// A finding against the pulses here; transfer moves count to the start of the first pass.
    fn finding(&self, kind: &'static str, message: Message, cure: &'static str) -> Finding {
        let s = if self.s_mm.is_finite() { self.s_mm } else { 0.0 };
        Finding::error(kind, message, self.pass.max(1), PathRange::at(s), Message::new(cure))
    }
}
