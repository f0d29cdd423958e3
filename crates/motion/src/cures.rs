//! Cures of findings about ranges, reach and clearance: changes of the job that were tested by planning.
//!
//! A change modifies the torch's paths alone, as moving the work or another work angle does. It is searched on the pass
//! with the findings, which is then planned with it. Every other pass is checked too, since the change affects the
//! whole job. A change that leaves as many findings is not offered.

use crate::effort::SearchStage;
use crate::follower::Follower;
use crate::joint_path::JointPath;
use crate::pass_clearance::pass_clearance;
use crate::pass_motion::{PassMotion, Request, along_axes};
use crate::path_source::PathSource;
use crate::placed_path::PlacedPath;
use crate::redundancy::holding;
use crate::survey::{Lack, Survey, range_between, range_on_path};
use glam::{DAffine3, DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine, Surroundings, Target};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Groove, Pass, ThroughPoints, TorchPath, WovenPath};

/// Changes of the work angle that are tried, degrees, smallest first.
const LEANS_DEG: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0];
/// Changes of the work angle that are tried against collisions, degrees.
const CLEARING_LEANS_DEG: [f64; 3] = [5.0, 10.0, 15.0];
/// Margin added to the missing travel, mm and degrees.
const ROOM: f64 = 0.1;
/// Units of effort of a survey, and of planning a pass.
const SURVEY_WORK: u64 = 1440;
const PLAN_WORK: u64 = 6000;

#[derive(Clone, Copy)]
pub(crate) struct Trial<'a> {
    pub(crate) machine: &'a Machine,
    /// The machine with the axes free that the pass holds.
    pub(crate) held: &'a Machine,
    pub(crate) request: Request<'a>,
}

#[derive(Clone, Copy, PartialEq)]
enum Change {
    /// The work is moved, mm in the work frame.
    Move(DVec3),
    /// The work angle grows, degrees.
    Lean(f64),
}

impl Change {
    /// The path of a torch with this change.
    fn of<'a>(self, path: &'a dyn TorchPath) -> Box<dyn TorchPath + 'a> {
        match self {
            Self::Move(by) => Box::new(PlacedPath::new(path, DAffine3::from_translation(by))),
            Self::Lean(by) => Box::new(LeaningPath { path: PathSource::Lent(path), by }),
        }
    }

    fn message(self, pass: &Pass) -> Message {
        match self {
            Self::Move(by) => {
                let message = Message::new("motion-change-move").number("x", by.x, 1).number("y", by.y, 1);
                message.quantity("z", by.z, Unit::Mm, 1)
            }
            Self::Lean(by) => {
                let is_one = pass.torch.at.is_empty();
                let code = if is_one { "motion-change-work-angle" } else { "motion-change-work-angles" };
                Message::new(code).quantity("by", by, Unit::Deg, 1)
            }
        }
    }
}

/// Passes on which a change was tested.
#[derive(Clone, Copy, PartialEq)]
enum Scope {
    /// Every pass of the weld: with it none has such a finding.
    Weld,
    /// The pass with the finding; others are not known, could not be tried, or have findings with it as without it.
    Pass,
}

enum Outcome {
    Cured(Change, Scope),
    /// None of them cures.
    Exhausted,
    /// Planning was stopped after so many of them.
    Stopped(usize),
}

impl Trial<'_> {
    /// Replaces the cures of findings of kind `range` and `reach` by a change that removes all of them, or by the
    /// reason why the search failed.
    pub(crate) fn cure_ranges(&self, findings: &mut [Finding]) {
        if !findings.iter().any(is_of_range) || self.request.path.axes(0.0).is_some() {
            return;
        }
        let cure = self.range_cure(count_against(findings));
        findings.iter_mut().filter(|f| is_of_range(f)).for_each(|f| f.cure = Some(cure.clone()));
    }

    /// Returns a change with which the pass has fewer findings than `count`, or the reason why the search failed.
    fn range_cure(&self, count: usize) -> Message {
        self.request.effort.begin(SearchStage::Cure);
        if self.is_redundant() {
            // Each trial would take a search.
            return Message::new("motion-cure-redundant");
        }
        let lacks = self.survey(self.request.path).map_or_else(|_| Vec::new(), |survey| survey.lacks);
        let changes = self.changes(&lacks);
        match self.first_cure(&changes, |change| self.cures_range(change, count)) {
            Outcome::Cured(change, scope) => {
                let code = if scope == Scope::Weld { "motion-cure-range-weld" } else { "motion-cure-range-pass" };
                Message::new(code).message("change", change.message(self.request.pass))
            }
            Outcome::Stopped(0) => Message::new("motion-cure-range-no-time"),
            Outcome::Stopped(tried) => {
                Message::new("motion-cure-range-stopped").count("tried", tried).count("changes", changes.len())
            }
            Outcome::Exhausted => self.no_cure(&changes, &lacks),
        }
    }

    fn no_cure(&self, changes: &[Change], lacks: &[Lack]) -> Message {
        let moved = changes.iter().any(|change| matches!(change, Change::Move(_)));
        let leant = changes.iter().any(|change| matches!(change, Change::Lean(_)));
        let tried = Message::new(match (moved, leant) {
            (true, true) => "motion-cure-range-none",
            (true, false) => "motion-cure-range-none-moved",
            (false, true) => "motion-cure-range-none-angle",
            (false, false) => return Message::new("motion-cure-not-tried"),
        });
        match both_ends(self.held, lacks) {
            Some(stroke) => stroke.message("tried", tried),
            None => tried,
        }
    }

    /// True if axes are chosen along the whole path.
    fn is_redundant(&self) -> bool {
        self.held.is_redundant() && self.request.path.second(0.0).is_none()
    }

    /// The first of `changes` that `cures`.
    fn first_cure(&self, changes: &[Change], cures: impl Fn(Change) -> Option<Scope>) -> Outcome {
        let effort = self.request.effort;
        for (tried, &change) in changes.iter().enumerate() {
            effort.resume(SearchStage::Cure);
            let cured = effort.spend(SURVEY_WORK, tried as f64 / changes.len() as f64).then(|| cures(change)).flatten();
            // A stopped trial gives no result for the change.
            if effort.is_stopped() {
                return Outcome::Stopped(tried);
            }
            if let Some(scope) = cured {
                return Outcome::Cured(change, scope);
            }
        }
        if effort.is_stopped() { Outcome::Stopped(0) } else { Outcome::Exhausted }
    }

    /// Tries `change`: this pass must have fewer findings than `count`, none of them about a range, and no other pass
    /// more about ranges.
    fn cures_range(&self, change: Change, count: usize) -> Option<Scope> {
        let (beyond, _) = self.beyond(&*change.of(self.request.path))?;
        if beyond > 0 {
            return None;
        }
        let scope = self.spares_others(change)?;
        let left = self.planned_with(change).err().unwrap_or_default();
        (count_against(&left) < count && !left.iter().any(is_of_range)).then_some(scope)
    }

    fn planned_with(&self, change: Change) -> Result<PassMotion, Vec<Finding>> {
        let effort = self.request.effort;
        let changed = change.of(self.request.path);
        let planned = PassMotion::plan_once(self.machine, Request { path: &*changed, ..self.request });
        effort.resume(SearchStage::Cure);
        effort.spend(PLAN_WORK, effort.progress().part);
        planned
    }

    /// Tries `change` on all passes in order, since each starts on the turn on which the previous one ends. None if a
    /// pass has more range findings with it than without it, or if this pass has any.
    fn spares_others(&self, change: Change) -> Option<Scope> {
        if self.request.weld.is_empty() {
            return Some(Scope::Pass);
        }
        let mut scope = Scope::Weld;
        let mut last: Option<Joints> = None;
        for (number, &(path, pass)) in (1..).zip(self.request.weld) {
            let Ok(held) = holding(self.machine, &pass.spare_axes) else { return Some(Scope::Pass) };
            let request = Request { path, pass, number, last: last.as_ref(), ..self.request };
            let other = Trial { held: &held, request, ..*self };
            if !self.request.effort.spend(SURVEY_WORK, self.request.effort.progress().part) {
                return None;
            }
            if other.is_redundant() && path.axes(0.0).is_none() {
                (scope, last) = (Scope::Pass, None);
                continue;
            }
            let count = |found: Option<(usize, Joints)>| found.map_or(usize::MAX, |(beyond, _)| beyond);
            let found = other.beyond(&*change.of(path));
            if count(found) > 0 {
                if number == self.request.number || count(found) > count(other.beyond(path)) {
                    return None;
                }
                scope = Scope::Pass;
            }
            last = found.map(|(_, end)| end);
        }
        Some(scope)
    }

    /// Number of range findings along `path`, and the positions at its end; none if the axes cannot follow it.
    fn beyond(&self, path: &dyn TorchPath) -> Option<(usize, Joints)> {
        let joints = self.joints(path)?;
        let on_path = range_on_path(self.held, &joints, self.request.number).len();
        Some((on_path + range_between(self.held, &joints, self.request.number).len(), joints.at(joints.length())))
    }

    fn survey(&self, path: &dyn TorchPath) -> Result<Survey, Vec<Finding>> {
        along_axes(self.held, Request { path, ..self.request }).map(|(_, survey)| survey)
    }

    fn can_lean(&self) -> bool {
        self.request.path.groove(0.0).is_some() && self.request.path.second(0.0).is_none()
    }

    fn changes(&self, lacks: &[Lack]) -> Vec<Change> {
        let shifts: Vec<DVec3> = lacks.iter().filter_map(|lack| self.shift_against(lack)).collect();
        let mut changes: Vec<Change> = shifts.iter().copied().map(Change::Move).collect();
        if shifts.len() > 1 {
            changes.insert(0, Change::Move(shifts.iter().sum()));
        }
        if self.can_lean() {
            let rotary = lacks.iter().filter(|lack| self.held.axes[lack.axis].kind == AxisKind::Rotary);
            let just = rotary.map(|lack| (lack.by.abs().to_degrees() * 10.0).ceil() / 10.0 + ROOM).reduce(f64::max);
            let leans = just.into_iter().filter(|by| *by < LEANS_DEG[LEANS_DEG.len() - 1]).chain(LEANS_DEG);
            changes.extend(leans.flat_map(|by| [Change::Lean(by), Change::Lean(-by)]));
        }
        changes
    }

    /// Smallest shift of the work after which a linear axis is in range at its worst path length, if the tip's position
    /// determines the axis there. Uses differences of the inverse kinematics.
    fn shift_against(&self, lack: &Lack) -> Option<DVec3> {
        if self.held.axes[lack.axis].kind == AxisKind::Rotary {
            return None;
        }
        const STEP_MM: f64 = 0.01;
        let at = |step: DVec3| {
            let moved = Change::Move(step).of(self.request.path);
            let target = Target::new(moved.pose(lack.s), moved.second(lack.s));
            self.held.inverse_next(target, &lack.q).ok().map(|s| s.joints[lack.axis])
        };
        let here = at(DVec3::ZERO)?;
        let slope = |way: DVec3| Some((at(STEP_MM * way)? - here) / STEP_MM);
        let slope = DVec3::new(slope(DVec3::X)?, slope(DVec3::Y)?, slope(DVec3::Z)?);
        let by = lack.by + ROOM.copysign(lack.by);
        // Rounded away from zero to the printed decimals.
        let away = |v: f64| if v.abs() < 0.05 { 0.0 } else { ((v.abs() * 10.0).ceil() / 10.0).copysign(v) };
        let shift = -by * slope / slope.length_squared();
        (slope.length() > 1e-3).then(|| DVec3::from_array(shift.to_array().map(away)))
    }

    /// Replaces the cures of clearance findings by a work angle that keeps every clearance, if one is found.
    pub(crate) fn cure_clearance(&self, around: &Surroundings, findings: &mut [Finding]) {
        self.request.effort.begin(SearchStage::Cure);
        let leans: Vec<Change> = match self.can_lean() && !self.is_redundant() {
            true => CLEARING_LEANS_DEG.into_iter().flat_map(|by| [Change::Lean(by), Change::Lean(-by)]).collect(),
            false => Vec::new(),
        };
        let cure = match self.first_cure(&leans, |change| self.clears(change, around)) {
            _ if leans.is_empty() => Message::new("motion-cure-clearance-move"),
            Outcome::Cured(change, scope) => {
                let is_of_weld = scope == Scope::Weld;
                let code = if is_of_weld { "motion-cure-clearance-weld" } else { "motion-cure-clearance-pass" };
                Message::new(code).message("change", change.message(self.request.pass))
            }
            Outcome::Exhausted => {
                let tried = CLEARING_LEANS_DEG[CLEARING_LEANS_DEG.len() - 1];
                Message::new("motion-cure-clearance-none").value("angle", tried, Unit::Deg)
            }
            Outcome::Stopped(tried) => {
                Message::new("motion-cure-clearance-stopped").count("tried", tried).count("angles", leans.len())
            }
        };
        findings.iter_mut().filter(|f| f.kind == "clearance").for_each(|f| f.cure = Some(cure.clone()));
    }

    /// Tries `change`: this pass must have no findings and keep every clearance, and no other pass may exceed more
    /// ranges.
    fn clears(&self, change: Change, around: &Surroundings) -> Option<Scope> {
        let Request { path: torch, number, .. } = self.request;
        let is_clear = |path: &JointPath| pass_clearance(around, path, torch, number).1.is_empty();
        let joints = self.joints(&*change.of(self.request.path))?;
        let leaves = !range_on_path(self.held, &joints, self.request.number).is_empty();
        if leaves || !is_clear(&joints) {
            return None;
        }
        let scope = self.spares_others(change)?;
        self.planned_with(change).ok().filter(|motion| is_clear(&motion.path))?;
        // Clearance of other passes is not checked.
        Some(if self.request.weld.len() == 1 { scope } else { Scope::Pass })
    }

    /// The axes along a path, turned as the pass before asks for, if they can follow it.
    fn joints(&self, path: &dyn TorchPath) -> Option<JointPath> {
        let (free, survey) = along_axes(self.held, Request { path, ..self.request }).ok()?;
        let follower = Follower { machine: self.held, path, free: &free };
        let mut joints = JointPath::new(follower, &survey.start).ok()?;
        if !follower.is_given() {
            joints.turn_to_start(self.held, &Request { path, ..self.request });
        }
        // Ranges are checked along the path.
        survey.findings.iter().all(|f| f.allowed || f.kind == "range").then_some(joints)
    }
}

/// True for a finding against the weld that a shift of the work or another work angle may cure.
fn is_of_range(finding: &Finding) -> bool {
    !finding.allowed && ["range", "reach"].contains(&finding.kind.as_ref())
}

fn count_against(findings: &[Finding]) -> usize {
    findings.iter().filter(|finding| !finding.allowed).count()
}

/// A linear axis that lacks stroke at both ends of its range: no shift along it helps.
fn both_ends(machine: &Machine, lacks: &[Lack]) -> Option<Message> {
    lacks.iter().find_map(|low| {
        let high = lacks.iter().find(|high| high.axis == low.axis && low.by < 0.0 && high.by > 0.0)?;
        let axis = &machine.axes[low.axis];
        let (from, to) = axis.range?;
        let needed = axis.to_file(to - from + high.by - low.by);
        let unit = axis.position_unit();
        let message = Message::new("motion-cure-range-none-stroke")
            .axis("axis", axis.name.as_str())
            .quantity("needed", needed, unit, 3)
            .quantity("stroke", axis.to_file(to - from), unit, 3);
        Some(message)
    })
}

/// A path with the torch leaning by `by` degrees more, about the arc.
struct LeaningPath<'a> {
    path: PathSource<'a>,
    by: f64,
}

impl LeaningPath<'_> {
    fn path(&self) -> &dyn TorchPath {
        self.path.get()
    }

    fn of(&self, pose: Pose, s: f64) -> Pose {
        let Some(groove) = self.path().groove(s) else { return pose };
        // The torch, seen from the work, leans towards the first part.
        let Some(about) = (-pose.direction).cross(groove.towards_first).try_normalize() else { return pose };
        let back = self.path().drawn_back();
        let arc = pose.ahead(back).point;
        let direction = DQuat::from_axis_angle(about, self.by.to_radians()) * pose.direction;
        Pose { point: arc, direction }.ahead(-back)
    }
}

impl TorchPath for LeaningPath<'_> {
    fn length(&self) -> f64 {
        self.path().length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.of(self.path().pose(s), s)
    }

    fn rate(&self, s: f64) -> f64 {
        self.path().rate(s)
    }

    fn knots(&self) -> Vec<f64> {
        self.path().knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path().bends()
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        self.path().groove(s)
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.path().second(s).map(|pose| self.of(pose, s))
    }

    fn drawn_back(&self) -> f64 {
        self.path().drawn_back()
    }

    fn weave(&self) -> Option<&dyn WovenPath> {
        self.path().weave().map(|_| self as &dyn WovenPath)
    }

    fn points(&self) -> Option<&dyn ThroughPoints> {
        self.path().points()
    }
}

impl WovenPath for LeaningPath<'_> {
    fn swing(&self, s: f64) -> DVec3 {
        self.path().weave().map_or(DVec3::ZERO, |weave| weave.swing(s))
    }

    fn slower(&self, factor: f64) -> Box<dyn TorchPath + '_> {
        Box::new(LeaningPath { path: self.path.slower(factor), by: self.by })
    }
}
