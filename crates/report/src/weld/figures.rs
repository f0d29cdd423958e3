use super::CertificateFigures;
use super::charts::PlottedPass;
use super::materials::MaterialsFigures;
use super::plan::PlanFigures;
use super::procedure::{PassProcedureFigures, ProcedureFigures};
use super::samples::samples;
use super::totals::{self, TotalsFigures, Wire};
use super::{Plots, PostFigures, SimulationCurves};
use crate::Language;
use seamwright_document::Positive;
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_motion::procedure::PassProcedure;
use seamwright_motion::{PassClearance, PassHeat, WeldMotion};
use seamwright_program::{Finding, Joint, Pass, Role, Seam};
use seamwright_simulation::Summary;
use seamwright_weld::{BeadNumbers, SeamCurve, Welding};
use serde::Serialize;
use std::collections::BTreeMap;

/// Figures of one weld; mm, s, degrees. This is `report.json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WeldReport {
    /// Version of Seamwright that created the report.
    pub seamwright: &'static str,
    /// The job's title.
    pub title: String,
    /// Source file of the job.
    pub file: String,
    /// The machine.
    pub machine: MachineFigures,
    /// The welding procedure, if there is one.
    pub procedure: Option<ProcedureFigures>,
    /// The seam, if any pass runs along one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seam: Option<SeamFigures>,
    /// The joint as in the job, if it has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<Joint>,
    /// Base materials and weld metal, if the job has them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub materials: Option<MaterialsFigures>,
    /// The plan of the first pass.
    pub plan: PlanFigures,
    /// The simulated first pass, if it was simulated.
    pub simulation: Option<Summary>,
    /// Totals of all passes.
    pub totals: TotalsFigures,
    /// All passes.
    pub passes: Vec<PassFigures>,
    /// Time of the transfer moves: from home, between passes and back home, s; without waits.
    pub air_s: f64,
    /// Time from home to home, s.
    pub total_s: f64,
    /// Part programs written with the plan, each verified.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub posts: Vec<PostFigures>,
    /// All findings about the weld.
    pub findings: Vec<Finding>,
}

/// The machine of a weld.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MachineFigures {
    /// Short name.
    pub name: String,
    /// Title.
    pub title: String,
    /// Axes without a drive in the file, for which the simulation assumes one.
    pub assumed_drives: Vec<String>,
}

/// Figures of the seam.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SeamFigures {
    /// `nozzle`, `ellipse`, `line`, `T-joint` or `girth`.
    pub kind: &'static str,
    /// Length of one turn, mm.
    pub length_mm: f64,
    /// Length of the weld, with overlap or of a part, mm.
    pub weld_length_mm: f64,
    /// Minimum angle between the faces over the weld, degrees.
    pub dihedral_min_deg: f64,
    /// Maximum angle between the faces over the weld, degrees.
    pub dihedral_max_deg: f64,
}

impl SeamFigures {
    fn new(seam: &Seam, curve: &SeamCurve) -> Self {
        let (low, high) = curve.dihedral_range();
        Self {
            kind: seam.kind(),
            length_mm: curve.length(),
            weld_length_mm: curve.weld_length(),
            dihedral_min_deg: low.to_degrees(),
            dihedral_max_deg: high.to_degrees(),
        }
    }
}

/// Figures of one pass.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PassFigures {
    /// Its name.
    pub name: String,
    /// Name of the copy of the seam on which it is welded, if there are copies.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub copy: Option<String>,
    /// Role: `tack`, `root`, `fill`, `cap` or `cosmetic`, if known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub role: Option<&'static str>,
    /// Number of its bead in the cross-sections.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bead: Option<usize>,
    /// Number of its last bead, if it welds several with step-overs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub last_bead: Option<usize>,
    /// Minimum and maximum of the smaller weld toe angle of its beads along the seam, degrees: with a procedure and without a weave as it sags in its position, otherwise in flat position.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub toe_deg: Option<(f64, f64)>,
    /// Minimum and maximum of each process value in the pass, by name.
    pub process_range: BTreeMap<String, (f64, f64)>,
    /// Stick-out, mm, if it is not the machine's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stick_out_mm: Option<f64>,
    /// Arc energy U I t, kJ; `None` without current and voltage.
    pub arc_energy_kj: Option<f64>,
    /// Length of wire, m; `None` without a wire feed.
    pub wire_m: Option<f64>,
    /// Mass of wire, kg; `None` also without its diameter.
    pub wire_kg: Option<f64>,
    /// Mass of weld metal, kg.
    pub weld_metal_kg: Option<f64>,
    /// Time of the transfer move before it, s.
    pub air_before_s: f64,
    /// Time of the wait before it, s.
    pub wait_before_s: f64,
    /// Preheat and cooling time by EN 1011-2, if the job has materials.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub heat: Option<PassHeat>,
    /// The plan.
    pub plan: PlanFigures,
    /// Speeds of the pass and their bounds.
    pub certificate: CertificateFigures,
    /// Values of the pass against its procedure.
    pub procedure: Option<PassProcedureFigures>,
    /// Minimum distance, if the machine file has shapes.
    pub clearance: Option<ClearanceFigures>,
    /// The simulated pass, if it was simulated.
    pub simulation: Option<Summary>,
}

/// Minimum distance between two checked objects.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ClearanceFigures {
    /// Distance, mm; a lower bound if `between` is `None`.
    pub nearest_mm: f64,
    /// Path length of the minimum, mm.
    pub at_mm: Option<f64>,
    /// Names of both objects.
    pub between: Option<String>,
    /// All checked objects.
    pub watched: Vec<String>,
    /// Both objects, for the page.
    #[serde(skip)]
    pub nearest: Option<[Message; 2]>,
    /// All checked objects, for the page.
    #[serde(skip)]
    pub(super) objects: Vec<Message>,
}

impl WeldReport {
    /// Collects the figures of a planned, and perhaps simulated, weld, and the plots of each pass in this language.
    pub fn new(
        machine: &Machine,
        welding: &Welding,
        motion: &WeldMotion,
        simulation: Option<(Vec<Summary>, Vec<SimulationCurves>)>,
        language: Language,
    ) -> (Self, Vec<Plots>) {
        let program = &welding.program.value;
        let (summaries, curves) = simulation.unzip();
        let mut findings = motion.findings.clone();
        let (mut passes, mut plots) = (Vec::new(), Vec::new());
        let wire = Wire::of(&program.consumables, program.procedure.as_ref());
        let heat = motion.heat(program);
        let beads = welding.bead_numbers();
        for (i, (pass, planned)) in program.passes.iter().zip(&motion.passes).enumerate() {
            let samples = samples(machine, welding, i, planned);
            let certificate = CertificateFigures::new(machine, pass, planned);
            let summary = summaries.as_ref().and_then(|s| s.get(i)).cloned();
            findings.extend(summary.iter().flat_map(|s| s.findings(&pass.tolerance, i + 1)));
            let held = motion.procedure.get(i).zip(program.procedure.as_ref());
            let procedure = held.map(|(held, procedure)| (held, procedure.run_of(i + 1, pass)));
            let plotted = PlottedPass {
                index: i,
                motion: planned,
                clearance: motion.clearance[i].as_ref(),
                samples: &samples,
                certificate: &certificate,
                procedure,
                curves: curves.as_ref().and_then(|c| c.get(i)),
                summary: summary.as_ref(),
            };
            plots.push(Plots::new(machine, welding, &plotted, language));
            let wire_m = totals::wire_m(pass, planned);
            let wire_kg = wire.mass_kg(wire_m);
            let turn = welding.seam.as_ref().map_or(f64::INFINITY, SeamCurve::length);
            let insert_kg = totals::insert_kg(program, pass, planned.path.length().min(turn));
            passes.push(PassFigures {
                name: pass.name.clone(),
                copy: program.copy_name(pass.copy).map(str::to_owned),
                role: pass.known_role().map(Role::name),
                bead: beads.get(i).and_then(|beads| beads.first),
                last_bead: beads.get(i).and_then(|beads| beads.last),
                toe_deg: beads.get(i).and_then(|beads| toe_deg(welding, i, *beads, motion.procedure.get(i))),
                process_range: process_range(pass),
                stick_out_mm: pass.torch.stick_out_mm.map(Positive::get),
                arc_energy_kj: totals::arc_energy_kj(pass, planned),
                wire_m,
                wire_kg,
                weld_metal_kg: wire.weld_metal_kg(wire_kg).map(|of_wire| of_wire + insert_kg),
                air_before_s: motion.transfers[i].duration() - motion.transfers[i].rest_s(),
                wait_before_s: motion.transfers[i].rest_s(),
                heat: heat.get(i).copied().flatten(),
                plan: PlanFigures::new(machine, welding, i, planned, &samples),
                certificate,
                procedure: procedure.map(|(held, run)| PassProcedureFigures::new(held, run)),
                clearance: motion.clearance[i].as_ref().map(clearance),
                simulation: summary,
            });
        }
        let report = Self {
            seamwright: env!("CARGO_PKG_VERSION"),
            title: program.title.clone(),
            file: welding.program.file().to_owned(),
            machine: MachineFigures {
                name: machine.name.clone(),
                title: machine.title.clone(),
                assumed_drives: machine.axes.iter().filter(|a| a.drive.is_none()).map(|a| a.name.clone()).collect(),
            },
            procedure: program.procedure.as_ref().map(ProcedureFigures::new),
            seam: program.seam.as_ref().zip(welding.seam.as_ref()).map(|(seam, curve)| SeamFigures::new(seam, curve)),
            joint: program.joint.clone(),
            materials: program.materials.as_ref().map(MaterialsFigures::new),
            plan: passes[0].plan.clone(),
            simulation: passes[0].simulation.clone(),
            totals: TotalsFigures::new(&passes, program, motion),
            passes,
            air_s: motion.air_s(),
            total_s: motion.total_s(),
            posts: Vec::new(),
            findings,
        };
        (report, plots)
    }
}

impl PassFigures {
    /// Returns minimum and maximum heat input, kJ/mm, if the procedure gives the thermal efficiency; infinite at a
    /// stop.
    pub fn heat_input_kj_mm(&self) -> Option<(f64, f64)> {
        let quantities = self.procedure.iter().flat_map(|procedure| &procedure.quantities);
        quantities.filter(|q| q.key == "heat_input_kj_mm").find_map(|q| q.found)
    }
}

/// Returns minimum and maximum of the smaller toe angle along pass `i`, with the numbers of its beads in the
/// cross-sections.
fn toe_deg(welding: &Welding, i: usize, numbers: BeadNumbers, held: Option<&PassProcedure>) -> Option<(f64, f64)> {
    let toes = welding.toes(i, numbers, held.map_or(&[][..], |held| &held.inclinations));
    let angles = toes.iter().map(|toe| toe.angle.to_degrees());
    angles.fold(None, |ends: Option<(f64, f64)>, a| Some(ends.map_or((a, a), |(l, h)| (l.min(a), h.max(a)))))
}

fn process_range(pass: &Pass) -> BTreeMap<String, (f64, f64)> {
    let names = pass.spans.iter().flat_map(|span| span.process.keys());
    names.filter_map(|name| Some((name.clone(), pass.process_range(name)?))).collect()
}

fn clearance(c: &PassClearance) -> ClearanceFigures {
    let english = |message: &Message| message.in_language(Language::English);
    let (nearest_mm, at_mm, nearest) = match &c.nearest {
        Some((mm, s, nearest)) => (*mm, Some(*s), Some(nearest.clone())),
        None => (c.cutoff_mm, None, None),
    };
    ClearanceFigures {
        nearest_mm,
        at_mm,
        between: nearest.as_ref().map(|both| both.each_ref().map(english).join(" and ")),
        watched: c.watched.iter().map(english).collect(),
        nearest,
        objects: c.watched.clone(),
    }
}
