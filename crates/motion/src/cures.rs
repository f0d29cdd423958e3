//! Cures of findings about ranges, reach and clearance: changes of the job that were tried out.
//!
//! A change is made to the torch's path alone, which is what moving the work or another work angle do to it, and the path
//! is surveyed again. A change that leaves a finding is not offered.

use crate::JointPath;
use crate::effort::SearchStage;
use crate::follower::Follower;
use crate::pass_clearance::pass_clearance;
use crate::pass_motion::{Before, along_axes};
use crate::survey::{Lack, Survey, range_between, range_on_path};
use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Machine, Surroundings, Target};
use seamwright_program::{AxisPositions, Finding, Groove, Pass, TorchPath};

/// Changes of the work angle that are tried, degrees, the least first.
const LEANS_DEG: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0];
/// Those that are tried against collisions.
const CLEARING_LEANS_DEG: [f64; 3] = [5.0, 10.0, 15.0];
/// Room beyond what is lacking, mm and degrees.
const ROOM: f64 = 0.1;
/// Units of effort of a survey.
const SURVEY_WORK: u64 = 1440;

/// What plans a pass.
#[derive(Clone, Copy)]
pub(crate) struct Trial<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) path: &'a dyn TorchPath,
    pub(crate) pass: &'a Pass,
    pub(crate) number: usize,
    pub(crate) before: Before<'a>,
}

/// A change of the job.
#[derive(Clone, Copy, PartialEq)]
enum Change {
    /// The work is moved, mm in the work frame.
    Move(DVec3),
    /// The work angle grows, degrees.
    Lean(f64),
}

impl Change {
    /// What to do, in words.
    fn words(self) -> String {
        match self {
            Self::Move(by) => {
                format!("move the work by {:.1}, {:.1}, {:.1} mm along x, y, z (placement.move_mm)", by.x, by.y, by.z)
            }
            Self::Lean(by) => format!("change torch.work_angle_deg by {by:+.1} degrees"),
        }
    }
}

impl Trial<'_> {
    /// Replaces the cures of findings of kind `range` and `reach` by a change that leaves none of them, or by the reason
    /// why none was found.
    pub(crate) fn cure_ranges(&self, findings: &mut [Finding]) {
        let is_meant = |f: &Finding| !f.allowed && ["range", "reach"].contains(&f.kind);
        if !findings.iter().any(is_meant) || self.path.axes(0.0).is_some() {
            return;
        }
        let cure = self.cure();
        findings.iter_mut().filter(|f| is_meant(f)).for_each(|f| f.cure.clone_from(&cure));
    }

    fn cure(&self) -> String {
        let effort = self.before.effort;
        effort.begin(SearchStage::Cure);
        if self.is_redundant() {
            // Each trial would take a search.
            return "no change was tried with redundant axes: place the work nearer to the middle of the axes' ranges"
                .to_owned();
        }
        let lacks = self.survey(self.path).map_or_else(|_| Vec::new(), |survey| survey.lacks);
        let changes = self.changes(&lacks);
        let count = changes.len() as f64;
        let found = changes
            .iter()
            .enumerate()
            .find(|(i, change)| effort.spend(SURVEY_WORK, *i as f64 / count) && self.is_cured_by(**change));
        if let Some((_, change)) = found {
            return format!("{}: tried, every axis then stays in its range", change.words());
        }
        if effort.is_stopped() {
            return "no change was tried in the time that is allowed".to_owned();
        }
        let reason = both_ends(self.machine, &lacks).map_or_else(String::new, |why| format!("; {why}"));
        format!("none was found: moving the work and changing the work angle were tried{reason}")
    }

    /// True if axes are chosen along the whole path.
    fn is_redundant(&self) -> bool {
        !self.machine.free().is_empty() && self.path.second(0.0).is_none()
    }

    fn is_cured_by(&self, change: Change) -> bool {
        let Some(joints) = self.joints(&Changed { path: self.path, change }) else { return false };
        range_on_path(self.machine, &joints, self.number).is_empty()
            && range_between(self.machine, &joints, self.number).is_empty()
    }

    fn survey(&self, path: &dyn TorchPath) -> Result<Survey, Vec<Finding>> {
        along_axes(self.machine, path, self.pass, self.number, self.before).map(|(_, survey)| survey)
    }

    /// Changes that are worth trying, the least first.
    fn changes(&self, lacks: &[Lack]) -> Vec<Change> {
        let shifts: Vec<DVec3> = lacks.iter().filter_map(|lack| self.shift_against(lack)).collect();
        let mut changes: Vec<Change> = shifts.iter().copied().map(Change::Move).collect();
        if shifts.len() > 1 {
            changes.insert(0, Change::Move(shifts.iter().sum()));
        }
        if self.path.groove(0.0).is_some() && self.path.second(0.0).is_none() {
            let rotary = lacks.iter().filter(|lack| self.machine.axes[lack.axis].kind == AxisKind::Rotary);
            let just = rotary.map(|lack| (lack.by.abs().to_degrees() * 10.0).ceil() / 10.0 + ROOM).reduce(f64::max);
            let leans = just.into_iter().filter(|by| *by < LEANS_DEG[LEANS_DEG.len() - 1]).chain(LEANS_DEG);
            changes.extend(leans.flat_map(|by| [Change::Lean(by), Change::Lean(-by)]));
        }
        changes
    }

    /// The least shift of the work after which a linear axis lacks nothing at the place where it lacks most, if the tip's
    /// place decides the axis there: by differences of the inverse.
    fn shift_against(&self, lack: &Lack) -> Option<DVec3> {
        if self.machine.axes[lack.axis].kind == AxisKind::Rotary {
            return None;
        }
        const STEP_MM: f64 = 0.01;
        let at = |step: DVec3| {
            let moved = Changed { path: self.path, change: Change::Move(step) };
            let target = Target { first: moved.pose(lack.s), second: moved.second(lack.s) };
            self.machine.inverse_next(target, &lack.q).ok().map(|s| s.joints[lack.axis])
        };
        let here = at(DVec3::ZERO)?;
        let slope = |way: DVec3| Some((at(STEP_MM * way)? - here) / STEP_MM);
        let slope = DVec3::new(slope(DVec3::X)?, slope(DVec3::Y)?, slope(DVec3::Z)?);
        let by = lack.by + ROOM.copysign(lack.by);
        // Rounded away from zero to what is printed.
        let away = |v: f64| if v.abs() < 0.05 { 0.0 } else { ((v.abs() * 10.0).ceil() / 10.0).copysign(v) };
        let shift = -by * slope / slope.length_squared();
        (slope.length() > 1e-3).then(|| DVec3::from_array(shift.to_array().map(away)))
    }

    /// Replaces the cures of clearance findings by a work angle with which nothing comes too near, if there is one.
    pub(crate) fn cure_clearance(&self, around: &Surroundings, findings: &mut [Finding]) {
        const LESS: &str = "allow less with clearance.least_mm if the shapes are right";
        self.before.effort.begin(SearchStage::Cure);
        let can_lean = self.path.groove(0.0).is_some() && self.path.second(0.0).is_none() && !self.is_redundant();
        let leans = CLEARING_LEANS_DEG.into_iter().flat_map(|by| [Change::Lean(by), Change::Lean(-by)]);
        let clears = |change: &Change| {
            let moved = Changed { path: self.path, change: *change };
            self.before.effort.spend(SURVEY_WORK, 0.5)
                && self.is_cured_by(*change)
                && self.joints(&moved).is_some_and(|joints| pass_clearance(around, &joints, self.number).1.is_empty())
        };
        let cure = match leans.clone().filter(|_| can_lean).find(clears) {
            Some(change) => format!("{}: tried, nothing then comes too near; or {LESS}", change.words()),
            None if can_lean => {
                format!(
                    "none was found: work angles up to 15 degrees from this one do not clear it; move what is in the way, or {LESS}"
                )
            }
            None => format!("move what is in the way, or {LESS}"),
        };
        findings.iter_mut().filter(|f| f.kind == "clearance").for_each(|f| f.cure.clone_from(&cure));
    }

    /// The axes along a path, turned as the pass before asks for, if they can follow it.
    fn joints(&self, path: &dyn TorchPath) -> Option<JointPath> {
        let (free, survey) = along_axes(self.machine, path, self.pass, self.number, self.before).ok()?;
        let mut joints = JointPath::new(Follower { machine: self.machine, path, free: &free }, &survey.start).ok()?;
        if let Some(last) = self.before.last {
            joints.turn_towards(self.machine, last);
        }
        // Ranges are looked at along the path.
        survey.findings.iter().all(|f| f.allowed || f.kind == "range").then_some(joints)
    }
}

/// A linear axis that lacks stroke at both ends of its range: no shift along it helps.
fn both_ends(machine: &Machine, lacks: &[Lack]) -> Option<String> {
    lacks.iter().find_map(|low| {
        let high = lacks.iter().find(|high| high.axis == low.axis && low.by < 0.0 && high.by > 0.0)?;
        let axis = &machine.axes[low.axis];
        let (from, to) = axis.range?;
        let needed = axis.to_file(to - from + high.by - low.by);
        let (has, unit) = (axis.to_file(to - from), axis.unit());
        Some(format!("axis {} would need {needed:.3} {unit} along the seam, its range is {has:.3} {unit}", axis.name))
    })
}

/// A path with a change.
struct Changed<'a> {
    path: &'a dyn TorchPath,
    change: Change,
}

impl Changed<'_> {
    fn of(&self, pose: Pose, s: f64) -> Pose {
        match self.change {
            Change::Move(by) => Pose { point: pose.point + by, ..pose },
            Change::Lean(by) => {
                let Some(groove) = self.path.groove(s) else { return pose };
                // The torch, seen from the work, leans towards the first part.
                let Some(about) = (-pose.direction).cross(groove.towards_first).try_normalize() else { return pose };
                Pose { direction: DQuat::from_axis_angle(about, by.to_radians()) * pose.direction, ..pose }
            }
        }
    }
}

impl TorchPath for Changed<'_> {
    fn length(&self) -> f64 {
        self.path.length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.of(self.path.pose(s), s)
    }

    fn rate(&self, s: f64) -> f64 {
        self.path.rate(s)
    }

    fn is_timed(&self) -> bool {
        self.path.is_timed()
    }

    fn reached(&self, points: usize) -> Option<f64> {
        self.path.reached(points)
    }

    fn stops(&self) -> Vec<f64> {
        self.path.stops()
    }

    fn axes(&self, s: f64) -> Option<AxisPositions> {
        self.path.axes(s)
    }

    fn face(&self, s: f64) -> DVec3 {
        self.path.face(s)
    }

    fn groove(&self, s: f64) -> Option<Groove> {
        self.path.groove(s)
    }

    fn second(&self, s: f64) -> Option<Pose> {
        self.path.second(s).map(|pose| self.of(pose, s))
    }

    fn swing(&self, s: f64) -> Option<DVec3> {
        self.path.swing(s)
    }

    fn knots(&self) -> Vec<f64> {
        self.path.knots()
    }

    fn bends(&self) -> Vec<f64> {
        self.path.bends()
    }
}
