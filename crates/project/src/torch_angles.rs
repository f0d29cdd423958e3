//! Torch angles of passes that the job asks to search.

use crate::failure::Failure;
use seamwright_document::{Finite, Positive};
use seamwright_machine::{Clamped, Machine, Surroundings};
use seamwright_motion::{AngleChange, AngleLimits, AngleSearch, AngleTask, search_angles};
use seamwright_program::{Finding, Run, SAME_POSITION_MM, Torch, TorchAt, TorchPath, Window};
use seamwright_weld::{PassPath, Welding};

/// Searches angles for the passes of `welding` that ask for it, with the weld metal of earlier passes as an obstacle.
/// Returns the weld with the angles found, and a finding for each pass without any.
pub(crate) fn searched(
    mut welding: Welding,
    machine: &Machine,
    clamped: &Clamped,
) -> Result<(Welding, Vec<Finding>), Failure> {
    let mut blocked = Vec::new();
    if welding.program.value.passes.iter().all(|pass| pass.torch.search.is_none()) {
        return Ok((welding, blocked));
    }
    let fault = |why| Failure::Input(why);
    let around = Surroundings::new(machine, clamped).map_err(|e| fault(e.message()))?;
    let metal = welding.metal().map_or(Ok(Vec::new()), |metal| metal.by_pass()).map_err(|e| fault(e.message()))?;
    for pass in 0..welding.program.value.passes.len() {
        let Some(search) = welding.program.value.passes[pass].torch.search else { continue };
        let around = around.with_part(metal.get(pass).map_or(&[], Vec::as_slice)).map_err(|e| fault(e.message()))?;
        let limits = AngleLimits {
            stick_out: longer(&welding, pass, machine),
            work: search.max_work_deg.get().to_radians(),
            travel: search.max_travel_deg.get().to_radians(),
        };
        let mut torch = Torch { search: None, ..welding.program.value.passes[pass].torch.clone() };
        if let Some(path) = welding.path(pass).along_seam() {
            let turn = Some(path.seam.length()).filter(|turn| path.seam.all_round() && path.length() >= *turn);
            let program = &welding.program.value;
            let run = program.procedure.as_ref().and_then(|p| p.run_of(pass + 1, &program.passes[pass]));
            let stick_out = torch.stick_out_or(machine.stick_out_mm);
            let allowed = |change: AngleChange| is_allowed(path, run, stick_out, change);
            let task = AngleTask { path, number: pass + 1, turn, limits, allowed: &allowed };
            match search_angles(machine, &around, task) {
                AngleSearch::Unchanged => {}
                AngleSearch::Changed(changes) => torch = changed(path, &changes, &torch, machine),
                AngleSearch::Blocked(finding) => blocked.push(*finding),
            }
        }
        welding = welding.with_torch(pass, torch)?;
    }
    Ok((welding, blocked))
}

/// Maximum addition to the stick-out of a pass, mm.
fn longer(welding: &Welding, pass: usize, machine: &Machine) -> f64 {
    let torch = &welding.program.value.passes[pass].torch;
    let most = torch.search.and_then(|search| search.max_stick_out_mm);
    most.zip(torch.stick_out_or(machine.stick_out_mm)).map_or(0.0, |(most, own)| (most.get() - own).max(0.0))
}

/// Beyond these angles the torch lies on a face or along the seam, degrees.
const MAX_WORK_DEG: f64 = 85.0;
const MAX_TRAVEL_DEG: f64 = 70.0;

/// True if the angles are possible, and within the windows of the procedure's `run` where it has any. `stick_out` is that
/// of the pass, mm.
fn is_allowed(path: &PassPath, run: Option<&Run>, stick_out: Option<f64>, change: AngleChange) -> bool {
    let (given_work, given_travel) = path.angles(change.s);
    let [work, travel] = [given_work + change.work, given_travel + change.travel].map(f64::to_degrees);
    let is_within = |window: Option<Window>, angle: f64, given: f64| {
        // Angles that are outside as they are given are for the check to report.
        window.is_none_or(|window| {
            let (low, high) = window.ends();
            (low..=high).contains(&angle) || !(low..=high).contains(&given)
        })
    };
    work.abs() < MAX_WORK_DEG
        && travel.abs() < MAX_TRAVEL_DEG
        && run.is_none_or(|run| {
            is_within(run.work_angle_deg, work, given_work.to_degrees())
                && stick_out.is_none_or(|given| is_within(run.stick_out_mm, given + change.stick_out, given))
                && is_within(run.travel_angle_deg, travel, given_travel.to_degrees())
        })
}

/// A row of angles nearer than this to a row of the bead or a knot of the seam is moved there, mm: between two rows a hair
/// apart, derivatives of the axes are lost in rounding.
const NEAR_MM: f64 = 0.05;

/// The torch of a pass with changes: a row of angles for each of them.
fn changed(path: &PassPath, changes: &[AngleChange], torch: &Torch, machine: &Machine) -> Torch {
    let seam = path.seam;
    let on_seam = |s: f64| {
        let at = path.stretch.seam_s(s);
        if seam.all_round() { at.rem_euclid(seam.length()) } else { at.clamp(0.0, seam.weld_length()) }
    };
    // Rounded to a thousandth of a degree and a tenth of a micrometre.
    let rounded = |value: f64, digits: f64| Finite::new((value * digits).round() / digits).unwrap_or_default();
    let knots = path.knots();
    let placed = |s: f64| match knots.iter().find(|knot| (**knot - s).abs() < NEAR_MM) {
        Some(knot) => Finite::new(on_seam(*knot)).unwrap_or_default(),
        None => rounded(on_seam(s), 1e4),
    };
    let mut rows: Vec<TorchAt> = changes
        .iter()
        .map(|change| {
            let (work, travel) = path.attitude.angles(on_seam(change.s));
            TorchAt {
                s_mm: placed(change.s),
                work_angle_deg: rounded((work + change.work).to_degrees(), 1e3),
                travel_angle_deg: rounded((travel + change.travel).to_degrees(), 1e3),
            }
        })
        .collect();
    rows.sort_by(|a, b| a.s_mm.get().total_cmp(&b.s_mm.get()));
    // A row at the end of a seam welded all round is the one at its start.
    let end = seam.length() - SAME_POSITION_MM;
    rows.retain(|row| !seam.all_round() || row.s_mm.get() < end);
    rows.dedup_by(|a, b| a.s_mm.get() - b.s_mm.get() < SAME_POSITION_MM);
    let longer = changes.first().map_or(0.0, |change| change.stick_out);
    let stick_out_mm = match torch.stick_out_or(machine.stick_out_mm).filter(|_| longer > 0.0) {
        Some(own) => Positive::new(own + longer),
        None => torch.stick_out_mm,
    };
    Torch { at: rows, stick_out_mm, ..Torch::default() }
}
