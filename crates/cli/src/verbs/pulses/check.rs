use super::motors::Motor;
use super::stepped::{Clock, Stepped};
use super::{Place, Play};
use crate::failure::Failure;
use seamwright_motion::pulses::{Edge, Error, Generator};
use seamwright_program::Finding;

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
            let steps = steps.unsigned_abs();
            let message = format!("the motor of axis {} loses {steps} full steps, from t = {t:.3} s on", axis.name);
            let cure = "a lower speed or acceleration, or a motor with more torque";
            findings.push(place.finding("steps", message, cure));
        }
        findings
    }
}

/// Pulses too close to each other, as a finding with axis, time and operator action.
pub(super) fn crowded(
    stepped: &[Stepped],
    clock: &Clock,
    place: &Place,
    periods: u64,
    (axis, error): (usize, Error),
) -> Failure {
    let axis = &stepped[axis];
    let what = match error {
        Error::TooFast { asked, .. } => format!(
            "{:.0} pulses a second are asked for with {} microsteps, {:.0} is the most",
            asked / clock.period_s(),
            axis.choice.microsteps,
            axis.timing.max_hz(clock.tick_s())
        ),
        other => other.to_string(),
    };
    let cure = match error {
        Error::TooFast { .. } => {
            "a lower speed, a smaller `microsteps` or a greater `max_pulse_hz` of the driver, or a finer --tick-ns"
        }
        Error::Crowded { .. } => "a longer --period-ms, a lower acceleration, or a lower speed",
        Error::Position { .. } | Error::Period { .. } => "fewer microsteps",
    };
    let t = clock.seconds(periods * clock.ticks);
    let air = if place.pass == 0 { ", in an air move" } else { "" };
    let message = format!("axis {} at t = {t:.6} s{air}: {what}", axis.name);
    Failure::Findings(vec![place.finding("pulses", message, cure)])
}

impl Place {
    /// A finding against the pulses here; transfer moves count to the start of the first pass.
    fn finding(&self, kind: &'static str, message: String, cure: &str) -> Finding {
        let s = if self.s_mm.is_finite() { self.s_mm } else { 0.0 };
        Finding {
            kind,
            message: message.into(),
            pass: self.pass.max(1),
            from_mm: s,
            to_mm: s,
            cure: Some(cure.into()),
            allowed: false,
        }
    }
}
