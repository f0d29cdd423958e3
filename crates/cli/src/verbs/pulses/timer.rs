use crate::refusals::of_option;
use seamwright_machine::{Axis, Load, Machine, Stepper};
use seamwright_message::{Message, Unit};
use seamwright_motion::pulses::{Error, Microstepping, Timing};
use seamwright_project::failure::Failure;

/// The timer and the period in its ticks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    pub(super) ticks: u64,
    pub(super) tick_ns: u32,
}

impl Clock {
    /// A period that is a whole number of ticks.
    pub(super) fn new(period_ms: f64, tick_ns: u32) -> Result<Self, Failure> {
        let ticks = period_ms * 1e6 / f64::from(tick_ns);
        let whole = ticks.round();
        if !(1.0..=1e11).contains(&whole) || (ticks - whole).abs() > 1e-9 * ticks {
            let message = Message::new("cli-pulses-ticks").value("period", period_ms, Unit::Ms);
            let message = message.value("ticks", ticks, Unit::One).value("tick", f64::from(tick_ns), Unit::Ns);
            return Err(Failure::refused(message, Message::new("cli-pulses-whole-ticks")));
        }
        Ok(Self { ticks: whole as u64, tick_ns })
    }

    pub(super) fn tick_s(&self) -> f64 {
        f64::from(self.tick_ns) * 1e-9
    }

    pub(super) fn period_s(&self) -> f64 {
        self.seconds(self.ticks)
    }

    pub(super) fn nanoseconds(&self, tick: u64) -> u64 {
        tick * u64::from(self.tick_ns)
    }

    /// Rounded once, so that it prints with few digits.
    pub(super) fn seconds(&self, tick: u64) -> f64 {
        self.nanoseconds(tick) as f64 / 1e9
    }
}

#[derive(Debug, Clone)]
pub(super) struct Stepped {
    pub(super) name: String,
    /// Its index among the machine's axes.
    pub(super) index: usize,
    pub(super) axis: Axis,
    pub(super) stepper: Stepper,
    pub(super) load: Option<Load>,
    pub(super) timing: Timing,
    pub(super) choice: Microstepping,
}

impl Stepped {
    /// All axes of the machine with steppers; `None` without any.
    pub(super) fn all(machine: &Machine, clock: &Clock) -> Result<Option<Vec<Self>>, Failure> {
        let mut all = Vec::new();
        for (index, axis) in machine.axes.iter().enumerate() {
            let Some(stepper) = &axis.stepper else { continue };
            let timing = Timing::new(stepper, clock.tick_s(), clock.ticks)
                .map_err(|e: Error| Failure::input(of_option("--period-ms", e.message())))?;
            all.push(Self {
                name: axis.name.clone(),
                index,
                axis: axis.clone(),
                stepper: stepper.clone(),
                load: axis.drive.as_ref().map(|d| d.load),
                timing,
                choice: Microstepping::choose(stepper, 0.0, timing.max_hz(clock.tick_s())),
            });
        }
        Ok(Some(all).filter(|a| !a.is_empty()))
    }

    /// Chooses the microstepping for the highest speed of the motion, mm/s or rad/s.
    pub(super) fn choose(&mut self, speed: f64, clock: &Clock) {
        self.choice = Microstepping::choose(&self.stepper, speed, self.timing.max_hz(clock.tick_s()));
    }

    pub(super) fn steps(&self, q: &[f64]) -> f64 {
        q[self.index] * self.choice.steps_per_unit
    }
}
