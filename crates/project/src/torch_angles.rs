//! Torch angles of passes that the job asks to search.

use crate::failure::Failure;
use crate::load::Loaded;
use crate::planning::{Clocked, Planning};
use seamwright_document::{Finite, Positive};
use seamwright_machine::{Machine, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::{AngleChange, AngleLimits, AngleSearch, AngleTask, search_angles};
use seamwright_program::{Finding, Pass, PathRange, Run, SAME_POSITION_MM, Torch, TorchAt, TorchPath, Window};
use seamwright_weld::PassPath;
use serde::{Deserialize, Serialize};

/// Stick-out beyond which the arc is no longer that of the given current and wire feed, mm: the upper end of what
/// handbooks name for wires of 1.0 to 1.2 mm (10 to 25 mm).
const MAX_USUAL_STICK_OUT_MM: f64 = 25.0;

/// The torch of a pass with the angles that were searched.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SearchedTorch {
    /// The pass, counted from 0.
    pub pass: usize,
    /// Its torch.
    pub torch: Torch,
}

impl Loaded {
    /// The torches whose angles were searched, to be given to [`Loaded::with_searched_torches`] in another process.
    pub fn searched_torches(&self) -> &[SearchedTorch] {
        &self.searched_torches
    }

    /// Gives the passes the torches of a search that was made before.
    ///
    /// # Errors
    /// Torches of passes that ask for no search, passes that ask for one and get no torch, angles out of range.
    pub fn with_searched_torches(mut self, torches: Vec<SearchedTorch>) -> Result<Self, Failure> {
        let asks = |i: usize| self.welding.program.value.passes.get(i).is_some_and(|pass| pass.torch.search.is_some());
        if !torches.iter().all(|searched| asks(searched.pass)) {
            return Err(self.fault(Message::new("project-angles-of-another-plan")));
        }
        for SearchedTorch { pass, torch } in &torches {
            self.welding = self.welding.with_torch(*pass, torch.clone())?;
        }
        if self.asks_for_angles() {
            return Err(self.fault(Message::new("project-angles-of-another-plan")));
        }
        self.searched_torches = torches;
        Ok(self)
    }

    /// Searches angles for the passes that ask for it, with the weld metal of earlier passes as an obstacle, within the
    /// limits of `planning`. A plan of the weld needs them first; a pass without any becomes a finding of the plan.
    ///
    /// # Errors
    /// Faults of the job, [`Failure::Cancelled`].
    pub fn with_torch_angles(mut self, planning: &Planning) -> Result<Self, Failure> {
        if !self.asks_for_angles() {
            return Ok(self);
        }
        let clocked = Clocked::new(planning, self.searching);
        let mut torches = Vec::new();
        let mut findings = Vec::new();
        {
            let around = self.surroundings()?;
            let metal = self.welding.metal();
            let mut metal = metal.as_ref().map(seamwright_weld::Metal::by_pass);
            for (i, pass) in self.welding.program.value.passes.iter().enumerate() {
                let mut torch = Torch { search: None, ..pass.torch.clone() };
                if !is_stopped(&findings) {
                    let before = metal.as_mut().and_then(Iterator::next).unwrap_or_else(|| Ok(Vec::new()));
                    if pass.torch.search.is_none() {
                        continue;
                    }
                    let around = before.and_then(|solids| around.with_part(&solids));
                    let around = around.map_err(|e| self.fault(e.message()))?;
                    self.search_pass(i, &around, &clocked, &mut torch, &mut findings);
                }
                torches.push(SearchedTorch { pass: i, torch });
            }
        }
        if clocked.is_cancelled() {
            return Err(Failure::Cancelled);
        }
        self = self.with_searched_torches(torches)?;
        self.angle_findings = findings;
        self.searching = clocked.spent();
        Ok(self)
    }

    /// True if the angles of a pass are to be searched still.
    pub(crate) fn asks_for_angles(&self) -> bool {
        self.welding.program.value.passes.iter().any(|pass| pass.torch.search.is_some())
    }

    /// Searches the angles of pass `i` and changes its `torch`.
    fn search_pass(
        &self,
        i: usize,
        around: &Surroundings,
        clocked: &Clocked,
        torch: &mut Torch,
        findings: &mut Vec<Finding>,
    ) {
        let program = &self.welding.program.value;
        let (pass, machine) = (&program.passes[i], &self.machine);
        let line = self.welding.path(i);
        let (Some(search), Some(path)) = (pass.torch.search, line.along_seam()) else { return };
        let run = program.procedure.as_ref().and_then(|p| p.run_of(i + 1, pass));
        let stick_out = torch.stick_out_or(machine.stick_out_mm);
        let limits = AngleLimits {
            stick_out: max_longer(pass, run, machine),
            work: search.max_work_deg.get().to_radians(),
            travel: search.max_travel_deg.get().to_radians(),
        };
        let rows: Vec<f64> = torch.at.iter().map(|row| path.stretch.own_s(row.s_mm.get())).collect();
        let task = AngleTask {
            path,
            number: i + 1,
            passes: program.passes.len(),
            period: path.seam.all_round().then(|| path.seam.length()),
            rows: &rows,
            limits,
            allowed: &|change| is_allowed(path, run, stick_out, change),
            watch: Some(clocked),
        };
        match search_angles(machine, around, task) {
            AngleSearch::Unchanged => {}
            AngleSearch::Changed(changes) => {
                *torch = with_changes(path, &changes, torch, machine);
                findings.extend(long_stick_out(i + 1, path, run, torch));
            }
            AngleSearch::Blocked(found) => findings.extend(found),
        }
    }
}

/// True if the search was stopped: a plan would be, too.
pub(crate) fn is_stopped(findings: &[Finding]) -> bool {
    findings.iter().any(|finding| finding.kind == "search")
}

/// Maximum addition to the stick-out of a pass, mm: up to its own limit and that of the procedure's `run`.
fn max_longer(pass: &Pass, run: Option<&Run>, machine: &Machine) -> f64 {
    let allowed = run.and_then(|run| run.stick_out_mm).map_or(f64::INFINITY, |window| window.ends().1);
    let most = pass.torch.search.and_then(|search| search.max_stick_out_mm);
    let own = pass.torch.stick_out_or(machine.stick_out_mm);
    most.zip(own).map_or(0.0, |(most, own)| (most.get().min(allowed) - own).max(0.0))
}

/// A warning if the search made the stick-out longer than usual and no procedure says that it may be.
fn long_stick_out(number: usize, path: &PassPath, run: Option<&Run>, torch: &Torch) -> Option<Finding> {
    let found = torch.stick_out_mm.map(Positive::get).filter(|found| *found > MAX_USUAL_STICK_OUT_MM)?;
    if run.is_some_and(|run| run.stick_out_mm.is_some()) {
        return None;
    }
    let message = Message::new("project-long-stick-out").quantity("found", found, Unit::Mm, 0).value(
        "usual",
        MAX_USUAL_STICK_OUT_MM,
        Unit::Mm,
    );
    let range = PathRange::up_to(path.length());
    let finding = Finding::error("plausible", message, number, range, Message::new("project-cure-long-stick-out"));
    Some(Finding { allowed: true, ..finding })
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
fn with_changes(path: &PassPath, changes: &[AngleChange], torch: &Torch, machine: &Machine) -> Torch {
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
