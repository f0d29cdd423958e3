use super::motors::Motor;
use super::play::{Place, Play};
use super::timer::Stepped;
use seamwright_message::{Message, Unit};
use seamwright_motion::pulses::{Edge, Generator};
use seamwright_program::Finding;
use seamwright_project::failure::Failure;

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
