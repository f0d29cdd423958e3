//! Figures of a plan that a study looks at.

use glam::DVec3;
use seamwright_machine::Machine;
use seamwright_message::{Argument, Message, Unit};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{Finding, TorchPath};
use seamwright_project::load::Loaded;
use seamwright_record::figures::HEAT_INPUT;
use seamwright_weld::BeadPlan;

/// Stations of a pass at which axes are looked at, and of a seam.
const STATIONS: u32 = 720;
/// Stations at which a drawn seam is compared with the nominal one.
const COMPARED: u32 = 180;

/// A figure of a plan.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Figure {
    /// Name of its column.
    pub(crate) name: String,
    pub(crate) unit: Unit,
    pub(crate) kind: FigureKind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum FigureKind {
    /// Least margin of all axes with a range, as a part of it.
    Margin,
    /// Least distance of an axis from an end of its range; negative beyond it.
    AxisMargin(usize),
    /// Minimum distance of everything watched, up to the planner's cut-off.
    Clearance,
    /// Maximum angle between requested and reached torch attitude.
    Attitude,
    /// Minimum planned speed as a part of the requested one.
    Speed,
    /// Maximum heat input.
    HeatInput,
    /// Deviation of the nominal plan's weld metal from what the drawn joint needs, the one that is largest in size.
    Fill,
    /// Maximum distance of the drawn seam from the nominal one, across it: what tracking must correct.
    Correction,
    /// Time from home to home.
    Time,
    /// Time with the arc on.
    ArcTime,
}

impl Figure {
    /// The figures of plans on a machine.
    pub(crate) fn all(machine: &Machine) -> Vec<Self> {
        let one = |name: &str, unit, kind| Self { name: name.to_owned(), unit, kind };
        let mut all = vec![one("margin_percent", Unit::Percent, FigureKind::Margin)];
        let ranged = machine.axes.iter().enumerate().filter(|(_, axis)| axis.range.is_some());
        all.extend(ranged.map(|(i, axis)| {
            let name = format!("margin_{}_{}", axis.name, axis.unit());
            one(&name, axis.position_unit(), FigureKind::AxisMargin(i))
        }));
        all.extend([
            one("clearance_mm", Unit::Mm, FigureKind::Clearance),
            one("attitude_error_deg", Unit::Deg, FigureKind::Attitude),
            one("speed_percent", Unit::Percent, FigureKind::Speed),
            one("heat_input_kj_mm", Unit::KiloJPerMm, FigureKind::HeatInput),
            one("fill_deviation_percent", Unit::Percent, FigureKind::Fill),
            one("correction_mm", Unit::Mm, FigureKind::Correction),
            one("total_s", Unit::S, FigureKind::Time),
            one("arc_s", Unit::S, FigureKind::ArcTime),
        ]);
        all
    }

    /// Its name for people.
    pub(crate) fn label(&self, machine: &Machine) -> Message {
        Message::new(match self.kind {
            FigureKind::Margin => "study-figure-margin",
            FigureKind::AxisMargin(i) => {
                return Message::new("study-figure-axis-margin").axis("axis", machine.axes[i].name.as_str());
            }
            FigureKind::Clearance => "study-figure-clearance",
            FigureKind::Attitude => "study-figure-attitude",
            FigureKind::Speed => "study-figure-speed",
            FigureKind::HeatInput => "study-figure-heat-input",
            FigureKind::Fill => "study-figure-fill",
            FigureKind::Correction => "study-figure-correction",
            FigureKind::Time => "study-figure-time",
            FigureKind::ArcTime => "study-figure-arc-time",
        })
    }
}

/// Reference that drawn plans are compared with.
#[derive(Debug, Clone, Default)]
pub(crate) struct Nominal {
    /// Points of the first pass with its direction, evenly along it.
    seam: Vec<Station>,
    /// The plan of the beads, if there is one.
    beads: Option<BeadPlan>,
}

#[derive(Debug, Clone, Copy)]
struct Station {
    point: DVec3,
    along: DVec3,
}

impl Nominal {
    pub(crate) fn of(loaded: &Loaded) -> Self {
        Self { seam: stations(loaded), beads: loaded.welding.plan.clone() }
    }
}

fn stations(loaded: &Loaded) -> Vec<Station> {
    let Some(path) = loaded.paths().into_iter().next() else { return Vec::new() };
    let length = path.length();
    let point = |i: f64| path.pose(length * i.clamp(0.0, f64::from(COMPARED)) / f64::from(COMPARED)).point;
    let station = |i: u32| {
        let i = f64::from(i);
        let along = (point(i + 0.01) - point(i - 0.01)).normalize_or_zero();
        Station { point: point(i), along }
    };
    (0..=COMPARED).map(station).collect()
}

/// Figures of a draw: of its plan, or of the findings that prevent one.
pub(crate) fn measure(
    figures: &[Figure],
    nominal: &Nominal,
    loaded: &Loaded,
    motion: Result<&WeldMotion, &Vec<Finding>>,
) -> Vec<Option<f64>> {
    let margins = match motion {
        Ok(motion) => planned_margins(&loaded.machine, motion),
        Err(findings) => violated_margins(&loaded.machine, findings),
    };
    let planned = motion.ok();
    let value = |figure: &Figure| match figure.kind {
        FigureKind::Margin => least_part(&loaded.machine, &margins),
        FigureKind::AxisMargin(axis) => margins[axis].map(|margin| loaded.machine.axes[axis].to_file(margin)),
        FigureKind::Fill => fill_deviation(nominal, loaded),
        FigureKind::Correction => correction(nominal, loaded),
        FigureKind::Clearance => planned.and_then(clearance),
        FigureKind::Attitude => planned
            .map(|motion| motion.passes.iter().map(|pass| pass.attitude_error.0).fold(0.0, f64::max).to_degrees()),
        FigureKind::Speed => planned.and_then(|motion| speed_percent(loaded, motion)),
        FigureKind::HeatInput => planned.and_then(heat_input),
        FigureKind::Time => planned.map(WeldMotion::total_s),
        FigureKind::ArcTime => planned.map(|motion| motion.passes.iter().map(PassMotion::arc_on_s).sum()),
    };
    figures.iter().map(|figure| value(figure).filter(|v| v.is_finite())).collect()
}

/// Least distance of each axis from an end of its range, mm or rad, over all passes; none without a range.
fn planned_margins(machine: &Machine, motion: &WeldMotion) -> Vec<Option<f64>> {
    let mut margins: Vec<Option<f64>> = machine.axes.iter().map(|axis| axis.range.map(|_| f64::INFINITY)).collect();
    for pass in &motion.passes {
        for i in 0..=STATIONS {
            let q = pass.path.at(pass.path.length() * f64::from(i) / f64::from(STATIONS));
            for (margin, (axis, q)) in margins.iter_mut().zip(machine.axes.iter().zip(q)) {
                if let (Some(margin), Some((low, high))) = (margin, axis.range) {
                    *margin = margin.min(q - low).min(high - q);
                }
            }
        }
    }
    margins
}

/// Margins below 0 of the axes that findings report beyond their range; nothing is known of others.
fn violated_margins(machine: &Machine, findings: &[Finding]) -> Vec<Option<f64>> {
    let mut margins = vec![None; machine.axes.len()];
    for finding in findings.iter().filter(|finding| finding.message.code == "motion-beyond-range") {
        let (Some(Argument::Axis(name)), Some(Argument::Quantity(by))) =
            (finding.message.argument("axis"), finding.message.argument("by"))
        else {
            continue;
        };
        if let Some(axis) = machine.axis(name) {
            let margin = -machine.axes[axis].from_file(by.value);
            margins[axis] = Some(margins[axis].map_or(margin, |known: f64| known.min(margin)));
        }
    }
    margins
}

/// Least margin as a part of its axis' range, %.
fn least_part(machine: &Machine, margins: &[Option<f64>]) -> Option<f64> {
    let part = |(axis, margin): (&seamwright_machine::Axis, &Option<f64>)| {
        let (low, high) = axis.range?;
        Some(100.0 * (*margin)? / (high - low))
    };
    machine.axes.iter().zip(margins).filter_map(part).reduce(f64::min)
}

fn clearance(motion: &WeldMotion) -> Option<f64> {
    let nearest = |pass: &seamwright_motion::PassClearance| pass.nearest.as_ref().map_or(pass.cutoff_mm, |n| n.0);
    motion.clearance.iter().flatten().map(nearest).reduce(f64::min)
}

fn speed_percent(loaded: &Loaded, motion: &WeldMotion) -> Option<f64> {
    let passes = loaded.welding.program.value.passes.iter().zip(&motion.passes);
    let part = |(pass, planned): (&seamwright_program::Pass, &PassMotion)| {
        100.0 * planned.tip_band(&loaded.machine).0 / pass.speeds().0
    };
    // Rounding may exceed the request.
    passes.map(part).reduce(f64::min).map(|percent| percent.min(100.0))
}

fn heat_input(motion: &WeldMotion) -> Option<f64> {
    let quantities = motion.procedure.iter().flat_map(|pass| &pass.quantities);
    quantities
        .filter(|quantity| quantity.key == HEAT_INPUT)
        .filter_map(|quantity| quantity.found)
        .map(|f| f.1)
        .reduce(f64::max)
}

/// Deviation of the nominal beads from the groove and cap of the drawn joint, %, where it is largest in size.
fn fill_deviation(nominal: &Nominal, loaded: &Loaded) -> Option<f64> {
    let (beads, drawn) = (nominal.beads.as_ref()?, loaded.welding.plan.as_ref()?);
    let end = |plan: &BeadPlan| plan.stations.last().copied().filter(|end| *end > 0.0);
    // Stations of both at the same part of the seam.
    let scale = end(beads)? / end(drawn)?;
    let deposited = |s: f64| (0..beads.count()).filter_map(|bead| beads.area(bead, s)).sum::<f64>();
    let deviation = |(s, total): (&f64, &f64)| 100.0 * (deposited(s * scale) / total - 1.0);
    let all = drawn.stations.iter().zip(&drawn.totals).filter(|(_, total)| **total > 0.0).map(deviation);
    all.reduce(|a, b| if b.abs() > a.abs() { b } else { a })
}

/// Maximum distance between the nominal and the drawn first pass, across the nominal one, mm.
fn correction(nominal: &Nominal, loaded: &Loaded) -> Option<f64> {
    let across = |(nominal, drawn): (&Station, Station)| {
        let by = drawn.point - nominal.point;
        (by - by.dot(nominal.along) * nominal.along).length()
    };
    nominal.seam.iter().zip(stations(loaded)).map(across).reduce(f64::max)
}
