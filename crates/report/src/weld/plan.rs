use super::samples::Sample;
use seamwright_machine::Machine;
use seamwright_motion::{Leg, PassMotion};
use seamwright_program::{ArcTime, Pass, ProcessValues, SeamStart, Sequence, Tolerance, TorchPath};
use seamwright_weld::Welding;
use serde::Serialize;

/// Figures of the plan.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanFigures {
    /// Minimum and maximum requested speed, mm/s; they differ between spans and in ramps.
    pub asked_speed_mm_s: (f64, f64),
    /// True if every axis can hold the requested speed everywhere.
    pub speed_held: bool,
    /// Length of the way of the torch tip without its weave, mm: that of the bead, not of the seam beside it.
    pub length_mm: f64,
    /// Minimum planned speed between acceleration and deceleration phase, mm/s.
    pub least_speed_mm_s: f64,
    /// Maximum planned speed, mm/s.
    pub greatest_speed_mm_s: f64,
    /// Length of the acceleration phase, mm.
    pub run_up_mm: f64,
    /// Length of the deceleration phase, mm.
    pub run_down_mm: f64,
    /// Travel time from rest to rest, s.
    pub weld_s: f64,
    /// Time with the arc (or beam) on, s.
    pub arc_on_s: f64,
    /// Time from the start of gas preflow to the end of postflow, s.
    pub total_s: f64,
    /// Maximum angle between the requested torch attitude and that of the axes, degrees.
    pub attitude_error_deg: f64,
    /// Path length of that maximum, mm.
    pub attitude_error_at_mm: f64,
    /// Minimum and maximum arc energy U I / v at the planned speed between acceleration and deceleration phase, kJ/mm,
    /// if current and voltage are given.
    pub arc_energy_kj_mm: Option<(f64, f64)>,
    /// Start, direction and overlap of the weld.
    pub start: SeamStart,
    /// Times before and after the travel.
    pub sequence: Sequence,
    /// Allowed deviation of the weld from the request.
    pub tolerance: Tolerance,
    /// Process values of the first span.
    pub process: ProcessValues,
    /// Extremes of each axis against its limits.
    pub axes: Vec<AxisFigures>,
}

/// Motion of one axis in the plan, in mm or degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisFigures {
    /// Name.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Minimum position.
    pub min: f64,
    /// Maximum position.
    pub max: f64,
    /// Range, if it has one.
    pub range: Option<(f64, f64)>,
    /// Maximum speed, per s.
    pub speed: f64,
    /// Speed limit.
    pub max_speed: f64,
    /// Maximum acceleration, per s^2.
    pub acceleration: f64,
    /// Acceleration limit.
    pub max_acceleration: f64,
    /// Maximum jerk, per s^3.
    pub jerk: f64,
    /// Jerk limit.
    pub max_jerk: f64,
}

/// Returns minimum and maximum arc energy (kJ/mm) at the planned speed in the steady part of `legs`, if current and
/// voltage are given there.
fn arc_energy(pass: &Pass, samples: &[Sample], legs: &[Leg]) -> Option<(f64, f64)> {
    let steady = |s: f64| legs.iter().any(|leg| s > leg.run_up_end && s < leg.run_down_start);
    let inside = samples.iter().filter(|s| steady(s.s) && s.speed > 0.0);
    let energies = inside.map(|s| {
        let value = |name: &str| pass.process_at(name, s.s, ArcTime::TRAVEL);
        let power = value("current_a")? * value("voltage_v")?;
        Some(power / s.speed / 1000.0)
    });
    let energies = energies.collect::<Option<Vec<f64>>>().filter(|e| !e.is_empty())?;
    let bound = |better: fn(f64, f64) -> f64| energies.iter().copied().reduce(better);
    bound(f64::min).zip(bound(f64::max))
}

impl PlanFigures {
    /// Computes the figures of pass `index` of the program, planned as `motion`.
    pub(crate) fn new(
        machine: &Machine,
        welding: &Welding,
        index: usize,
        motion: &PassMotion,
        samples: &[Sample],
    ) -> Self {
        let program = &welding.program.value;
        let pass = &program.passes[index];
        let band = motion.profile.report();
        let (least, greatest) = motion.tip_band(machine);
        Self {
            asked_speed_mm_s: pass.speeds(),
            speed_held: !motion.findings.iter().any(|f| f.kind == "speed"),
            least_speed_mm_s: least,
            greatest_speed_mm_s: greatest,
            length_mm: way_mm(&welding.path(index), samples),
            run_up_mm: band.run_up_end,
            run_down_mm: motion.path.length() - band.run_down_start,
            weld_s: motion.profile.duration(),
            arc_on_s: motion.arc_on_s(),
            total_s: motion.total_s(),
            attitude_error_deg: motion.attitude_error.0.to_degrees(),
            attitude_error_at_mm: motion.attitude_error.1,
            arc_energy_kj_mm: arc_energy(pass, samples, &motion.profile.legs()),
            start: program.start,
            sequence: pass.sequence.clone(),
            tolerance: pass.tolerance,
            process: pass.spans[0].process.clone(),
            axes: axes(machine, motion, samples),
        }
    }
}

/// Returns the way of the tip along a pass without its weave, mm: the length of its bead. Trapezoids between samples.
fn way_mm(path: &dyn TorchPath, samples: &[Sample]) -> f64 {
    samples.windows(2).map(|pair| (pair[1].s - pair[0].s) * 0.5 * (path.rate(pair[0].s) + path.rate(pair[1].s))).sum()
}

fn axes(machine: &Machine, motion: &PassMotion, samples: &[Sample]) -> Vec<AxisFigures> {
    let figures = |(i, axis): (usize, &seamwright_machine::Axis)| {
        let positions = || samples.iter().map(|s| s.axes[i][0]);
        let used = motion.certificate.uses[i];
        let (max_speed, max_acceleration) = (axis.to_file(axis.max_speed), axis.to_file(axis.max_acceleration));
        let max_jerk = axis.to_file(axis.jerk());
        AxisFigures {
            axis: axis.name.clone(),
            unit: axis.unit(),
            min: positions().fold(f64::INFINITY, f64::min),
            max: positions().fold(f64::NEG_INFINITY, f64::max),
            range: axis.range.map(|(l, h)| (axis.to_file(l), axis.to_file(h))),
            speed: used.speed * max_speed,
            max_speed,
            acceleration: used.acceleration * max_acceleration,
            max_acceleration,
            jerk: used.jerk * max_jerk,
            max_jerk,
        }
    };
    machine.axes.iter().enumerate().map(figures).collect()
}
