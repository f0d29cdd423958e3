use super::check::Checked;
use super::timer::{Clock, Stepped};
use crate::refusals::unit_of;
use crate::rows::in_english;
use seamwright_message::{Message, Unit};
use seamwright_motion::pulses::Bound;
use seamwright_project::load::Loaded;
use serde::Serialize;

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
    /// Deciding limit: `resolution`, `frequency` or `driver`.
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
    #[serde(serialize_with = "in_english")]
    remark: Option<Message>,
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
                    let why = Message::new("cli-pulses-bound-frequency").number("max", allowed_hz, 0);
                    ("frequency", Some(why))
                }
                Bound::Driver => ("driver", Some(Message::new("cli-pulses-bound-driver"))),
                Bound::None => ("frequency", Some(Message::new("cli-pulses-bound-none"))),
            };
            let remark = why.map(|why| {
                Message::new("cli-pulses-resolution")
                    .axis("axis", &axis.name)
                    .quantity("resolution", resolution, unit_of(unit), 4)
                    .count("microsteps", choice.microsteps as usize)
                    .value("wanted", wanted, unit_of(unit))
                    .message("why", why)
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

    pub(super) fn axis_messages(&self) -> impl Iterator<Item = Message> + '_ {
        self.axes.iter().map(AxisSummary::message)
    }

    /// Axes whose resolution is not met.
    pub(super) fn remarks(&self) -> impl Iterator<Item = &Message> {
        self.axes.iter().filter_map(|a| a.remark.as_ref())
    }

    pub(super) fn text(&self) -> String {
        let heading = Message::new("cli-pulses-heading")
            .text("job", &self.job)
            .quantity("time", self.duration_s, Unit::S, 3)
            .value("period", self.period_ms, Unit::Ms)
            .value("tick", f64::from(self.tick_ns), Unit::Ns);
        let note = |remark: &Message| Message::new("project-note").message("note", remark.clone());
        let mut lines = vec![heading];
        lines.extend(self.axis_messages());
        lines.extend(self.remarks().map(note));
        if !self.without_stepper.is_empty() {
            let axes = self.without_stepper.join(", ");
            lines.push(Message::new("cli-pulses-without-stepper").text("axes", axes));
        }
        lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

impl AxisSummary {
    fn message(&self) -> Message {
        let unit = unit_of(self.unit);
        let axis = Message::new("cli-pulses-axis")
            .axis("axis", &self.axis)
            .number("microsteps", f64::from(self.microsteps), 0)
            .message("bound", Message::new(bound(self.decided_by)))
            .quantity("resolution", self.resolution, unit, 4)
            .value("wanted", self.resolution_wanted, unit)
            .number("pulses", self.pulses as f64, 0)
            .number("start", self.start_steps as f64, 0)
            .number("end", self.end_steps as f64, 0)
            .number("highest", self.highest_hz, 0)
            .quantity("max", self.allowed_hz, Unit::Hz, 0);
        match self.lost_full_steps {
            Some(steps) => {
                let loses = Message::new("cli-pulses-axis-loses").message("axis", axis);
                loses.count("steps", steps.unsigned_abs() as usize)
            }
            None => axis,
        }
    }
}

fn bound(decided_by: &str) -> &'static str {
    match decided_by {
        "resolution" => "cli-pulses-by-resolution",
        "driver" => "cli-pulses-by-driver",
        _ => "cli-pulses-by-frequency",
    }
}
