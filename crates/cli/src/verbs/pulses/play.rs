use super::timer::{Clock, Stepped};
use crate::progress::Progress;
use seamwright_machine::Joints;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_motion::pulses::{Error, Event, Lines};
use seamwright_program::Finding;
use seamwright_project::failure::Failure;

/// Plays the motion for its callers, and counts.
pub(super) struct Play<'a> {
    pub(super) motion: &'a WeldMotion,
    pub(super) clock: Clock,
    pub(super) home: bool,
    pub(super) progress: Progress,
}

/// A set-point: the pass (0 in the air), path length, and all axes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) pass: usize,
    pub(super) s_mm: f64,
    q: Joints,
}

impl Play<'_> {
    pub(super) fn each(&mut self, mut each: impl FnMut(&Place) -> Result<(), Failure>) -> Result<(), Failure> {
        self.motion.play(self.clock.period_s(), self.home, |pass, set, _| {
            self.progress.step();
            each(&Place { pass, s_mm: set.profile.s, q: set.q })
        })
    }

    /// The microstepping of every axis, for the fastest period of the motion.
    pub(super) fn choose(&mut self, stepped: &mut [Stepped]) -> Result<(), Failure> {
        let mut last: Option<Joints> = None;
        let mut longest = vec![0.0f64; stepped.len()];
        self.each(|place| {
            let before = last.replace(place.q).unwrap_or(place.q);
            for (way, axis) in longest.iter_mut().zip(stepped.iter()) {
                *way = way.max((place.q[axis.index] - before[axis.index]).abs());
            }
            Ok(())
        })?;
        let period = self.clock.period_s();
        stepped.iter_mut().zip(longest).for_each(|(axis, way)| axis.choose(way / period, &self.clock));
        Ok(())
    }

    /// Makes the pulses; `each` gets every event in the order of time, with the end of its period.
    pub(super) fn pulses(
        &mut self,
        stepped: &[Stepped],
        mut each: impl FnMut(&Place, &Lines, Event) -> Result<(), Failure>,
    ) -> Result<Option<Lines>, Failure> {
        let mut lines: Option<Lines> = None;
        let clock = self.clock;
        let (mut periods, mut end) = (0u64, None);
        self.each(|place| {
            end = Some(*place);
            let Some(lines) = &mut lines else {
                let start: Vec<_> = stepped.iter().map(|a| (a.timing, a.steps(&place.q))).collect();
                let failure = |(axis, e): (usize, _)| crowded(&stepped[axis], &clock, place, 0, e);
                lines = Some(Lines::new(&start).map_err(failure)?);
                return Ok(());
            };
            let to = stepped.iter().map(|a| a.steps(&place.q));
            lines.advance(to).map_err(|(axis, e)| crowded(&stepped[axis], &clock, place, periods, e))?;
            periods += 1;
            while let Some(event) = lines.event() {
                each(place, lines, event)?;
            }
            Ok(())
        })?;
        if let (Some(lines), Some(end)) = (&mut lines, end) {
            while let Some(event) = lines.last_event() {
                each(&end, lines, event)?;
            }
        }
        Ok(lines)
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
    pub(super) fn finding(&self, kind: &'static str, message: Message, cure: &'static str) -> Finding {
        let s = if self.s_mm.is_finite() { self.s_mm } else { 0.0 };
        Finding {
            kind: kind.into(),
            message,
            pass: self.pass.max(1),
            from_mm: s,
            to_mm: s,
            cure: Some(Message::new(cure)),
            allowed: false,
        }
    }
}
