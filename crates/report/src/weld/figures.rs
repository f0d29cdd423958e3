use super::samples::samples;
use super::{Plots, SimulationCurves};
use seamwright_cell::Summary;
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::{Finding, ProcessValues, Seam};
use seamwright_weld::Welding;
use serde::Serialize;

/// The numbers of one weld; mm, s, degrees. This is `report.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WeldReport {
    /// Version of Seamwright that made it.
    pub seamwright: &'static str,
    /// The job's title.
    pub title: String,
    /// The file it came from.
    pub file: String,
    /// The machine.
    pub machine: MachineFigures,
    /// The seam.
    pub seam: SeamFigures,
    /// The plan.
    pub plan: PlanFigures,
    /// The simulated weld, if it was simulated.
    pub simulation: Option<Summary>,
    /// Everything to be said about the weld.
    pub findings: Vec<Finding>,
}

/// Which machine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineFigures {
    /// Short name.
    pub name: String,
    /// Title.
    pub title: String,
}

/// The seam in numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeamFigures {
    /// `nozzle`, `ellipse` or `line`.
    pub kind: &'static str,
    /// Length once, mm.
    pub length_mm: f64,
    /// Length of the weld, with overlap or in part, mm.
    pub weld_length_mm: f64,
    /// Least angle between the faces over the weld, degrees.
    pub dihedral_min_deg: f64,
    /// Greatest angle between the faces over the weld, degrees.
    pub dihedral_max_deg: f64,
}

/// The plan in numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanFigures {
    /// Speed asked for, mm/s.
    pub asked_speed_mm_s: f64,
    /// Least planned speed between run-up and run-down, mm/s.
    pub least_speed_mm_s: f64,
    /// Greatest planned speed, mm/s.
    pub greatest_speed_mm_s: f64,
    /// Length of the run-up, mm.
    pub run_up_mm: f64,
    /// Length of the run-down, mm.
    pub run_down_mm: f64,
    /// Travel time from rest to rest, s.
    pub weld_s: f64,
    /// Time with the arc (or beam) on, s.
    pub arc_on_s: f64,
    /// Time from the first gas to the last, s.
    pub total_s: f64,
    /// Largest angle between the torch attitude asked for and the one the axes reach, degrees.
    pub attitude_error_deg: f64,
    /// Where that is, mm.
    pub attitude_error_at_mm: f64,
    /// Arc energy U I / v, kJ/mm, if current and voltage are given.
    pub arc_energy_kj_mm: Option<f64>,
    /// Process values.
    pub process: ProcessValues,
    /// Each axis' extremes against its limits.
    pub axes: Vec<AxisFigures>,
}

/// What the plan asks of one axis, in mm or degrees.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisFigures {
    /// Name.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: &'static str,
    /// Least position.
    pub min: f64,
    /// Greatest position.
    pub max: f64,
    /// Range, if it has one.
    pub range: Option<(f64, f64)>,
    /// Greatest speed, per s.
    pub speed: f64,
    /// Its limit.
    pub max_speed: f64,
    /// Greatest acceleration, per s^2.
    pub acceleration: f64,
    /// Its limit.
    pub max_acceleration: f64,
}

impl WeldReport {
    /// Gathers the numbers and plots of a planned, and perhaps simulated, weld.
    pub fn new(
        machine: &Machine,
        welding: &Welding,
        motion: &PassMotion,
        simulation: Option<(Summary, SimulationCurves)>,
    ) -> (Self, Plots) {
        let samples = samples(machine, welding, motion);
        let program = &welding.program.value;
        let (low, high) = welding.seam.dihedral_range();
        let band = motion.law.report();
        let span = &program.passes[0].spans[0];
        let value = |name: &str| span.process.get(name).map(|v| v.get());
        let energy = value("current_a").zip(value("voltage_v")).map(|(i, u)| i * u / span.speed_mm_s.get() / 1000.0);
        let axes = machine.axes.iter().enumerate().map(|(i, axis)| {
            let greatest =
                |f: fn(&(f64, f64, f64)) -> f64| samples.iter().map(|s| f(&s.axes[i])).fold(f64::MIN, f64::max);
            AxisFigures {
                axis: axis.name.clone(),
                unit: axis.unit(),
                min: -greatest(|a| -a.0),
                max: greatest(|a| a.0),
                range: axis.range.map(|(l, h)| (axis.to_file(l), axis.to_file(h))),
                speed: greatest(|a| a.1.abs()),
                max_speed: axis.to_file(axis.max_speed),
                acceleration: greatest(|a| a.2.abs()),
                max_acceleration: axis.to_file(axis.max_acceleration),
            }
        });
        let plan = PlanFigures {
            asked_speed_mm_s: span.speed_mm_s.get(),
            least_speed_mm_s: band.least,
            greatest_speed_mm_s: band.greatest,
            run_up_mm: band.run_up_end,
            run_down_mm: motion.path.length() - band.run_down_start,
            weld_s: motion.law.duration(),
            arc_on_s: motion.arc_on_s(),
            total_s: motion.total_s(),
            attitude_error_deg: motion.attitude_error.0.to_degrees(),
            attitude_error_at_mm: motion.attitude_error.1,
            arc_energy_kj_mm: energy,
            process: span.process.clone(),
            axes: axes.collect(),
        };
        let (summary, curves) = simulation.unzip();
        let report = Self {
            seamwright: env!("CARGO_PKG_VERSION"),
            title: program.title.clone(),
            file: welding.program.file().to_owned(),
            machine: MachineFigures { name: machine.name.clone(), title: machine.title.clone() },
            seam: SeamFigures {
                kind: match program.seam {
                    Seam::Nozzle(_) => "nozzle",
                    Seam::Ellipse(_) => "ellipse",
                    Seam::Line(_) => "line",
                },
                length_mm: welding.seam.length(),
                weld_length_mm: welding.seam.weld_length(),
                dihedral_min_deg: low.to_degrees(),
                dihedral_max_deg: high.to_degrees(),
            },
            plan,
            simulation: summary,
            findings: motion.findings.clone(),
        };
        let plots = Plots::new(machine, welding, motion, &samples, curves.as_ref());
        (report, plots)
    }
}
