use super::check::Checked;
use super::stepped::{Clock, Stepped};
use crate::load::Loaded;
use seamwright_motion::pulses::Bound;
use serde::Serialize;

/// Summary of the pulses.
#[derive(Debug, Serialize)]
pub(super) struct Summary {
    job: String,
    machine: String,
    period_ms: f64,
    tick_ns: u32,
    duration_s: f64,
    axes: Vec<AxisSummary>,
    /// Axes of the machine without a stepper: they get no pulses.
    without_stepper: Vec<String>,
}

#[derive(Debug, Serialize)]
struct AxisSummary {
    axis: String,
    unit: &'static str,
    microsteps: u32,
    /// What decided: `resolution`, `frequency` or `driver`.
    decided_by: &'static str,
    /// Way of a pulse, in the unit.
    resolution: f64,
    resolution_wanted: f64,
    steps_per_unit: f64,
    highest_hz: f64,
    allowed_hz: f64,
    start_steps: i64,
    end_steps: i64,
    /// In both directions.
    pulses: u64,
    remark: Option<String>,
    /// With --motors, where the file describes the motor.
    lost_full_steps: Option<i64>,
}

impl Summary {
    pub(super) fn new(loaded: &Loaded, clock: &Clock, stepped: &[Stepped], checked: &Checked) -> Self {
        let mut axes = Vec::new();
        for ((axis, generator), motor) in stepped.iter().zip(&checked.generators).zip(&checked.motors) {
            let (choice, unit) = (&axis.choice, axis.axis.unit());
            let resolution = axis.axis.to_file(choice.resolution);
            let wanted = axis.axis.to_file(axis.stepper.resolution);
            let allowed_hz = axis.timing.max_hz(clock.tick_s());
            let (decided_by, why) = match choice.bound {
                Bound::Resolution => ("resolution", None),
                Bound::Frequency => {
                    ("frequency", Some(format!("more would need over {allowed_hz:.0} pulses a second")))
                }
                Bound::Driver => ("driver", Some("the driver has no finer setting".to_owned())),
                Bound::None => ("frequency", Some("even these are too fast".to_owned())),
            };
            let remark = why.map(|why| {
                let microsteps = choice.microsteps;
                format!(
                    "axis {} moves {resolution:.4} {unit} a pulse with {microsteps} microsteps, {wanted} {unit} is wanted: {why}",
                    axis.name
                )
            });
            axes.push(AxisSummary {
                axis: axis.name.clone(),
                unit,
                microsteps: choice.microsteps,
                decided_by,
                resolution,
                resolution_wanted: wanted,
                steps_per_unit: 1.0 / resolution,
                highest_hz: generator.fastest() / clock.period_s(),
                allowed_hz,
                start_steps: generator.start(),
                end_steps: generator.count(),
                pulses: generator.pulses(),
                remark,
                lost_full_steps: motor.map(|m| m.steps),
            });
        }
        let without = loaded.machine.axes.iter().filter(|a| a.stepper.is_none());
        Self {
            job: loaded.welding.program.value.title.clone(),
            machine: loaded.machine.name.clone(),
            period_ms: clock.period_s() * 1e3,
            tick_ns: clock.tick_ns,
            duration_s: clock.seconds(checked.periods * clock.ticks),
            axes,
            without_stepper: without.map(|a| a.name.clone()).collect(),
        }
    }

    pub(super) fn job(&self) -> &str {
        &self.job
    }

    /// A line an axis.
    pub(super) fn texts(&self) -> impl Iterator<Item = String> + '_ {
        self.axes.iter().map(|a| {
            let lost = a.lost_full_steps.map_or(String::new(), |n| format!(", motor loses {n} full steps"));
            format!(
                "{}: {} microsteps by {}, {:.4} {unit} a pulse ({} {unit} wanted), {} pulses from {} to {} steps, up to {:.0} of {:.0} Hz{lost}",
                a.axis,
                a.microsteps,
                a.decided_by,
                a.resolution,
                a.resolution_wanted,
                a.pulses,
                a.start_steps,
                a.end_steps,
                a.highest_hz,
                a.allowed_hz,
                unit = a.unit,
            )
        })
    }

    /// Axes whose resolution is not met.
    pub(super) fn remarks(&self) -> impl Iterator<Item = &str> {
        self.axes.iter().filter_map(|a| a.remark.as_deref())
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let mut text = format!(
            "{}: {:.3} s in periods of {} ms, ticks of {} ns\n",
            self.job, self.duration_s, self.period_ms, self.tick_ns
        );
        self.texts().for_each(|line| text.push_str(&format!("{line}\n")));
        self.remarks().for_each(|line| text.push_str(&format!("note: {line}\n")));
        if !self.without_stepper.is_empty() {
            text.push_str(&format!("without stepper, so without pulses: {}\n", self.without_stepper.join(", ")));
        }
        text
    }
}
