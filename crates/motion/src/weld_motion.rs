use crate::effort::{Effort, Watch};
use crate::pass_clearance::PassClearance;
use crate::pass_motion::PassMotion;
use crate::pass_order::{Obstacles, Order};
use crate::pass_time::{MAX_PASS_S, at_most};
use crate::procedure::{PassProcedure, PlannedPass, pool_check};
use crate::redundancy::holding;
use crate::set_points::{Phase, SetPoint};
use crate::speed_profile::ProfilePoint;
use crate::transfer::{Leg, TransferMove, obstacle, route_within};
use seamwright_clearance::{ClearanceError, Solid};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, AxisSet, Joints, Machine, Surroundings, Target};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Pass, PathRange, Procedure, TorchPath};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::f64::consts::PI;

/// A whole program as motion: its passes, and the transfer moves before, between and after them.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct WeldMotion {
    /// The passes in order.
    pub passes: Vec<PassMotion>,
    /// Clearance along each pass; none if the machine file has no shapes.
    pub clearance: Vec<Option<PassClearance>>,
    /// Transfer moves, one more than passes: from home to the first, from each to the next, from the last back home.
    pub transfers: Vec<TransferMove>,
    /// Comparison of each pass with the welding procedure specification, if any.
    pub procedure: Vec<PassProcedure>,
    /// Notes on a feasible weld.
    #[serde(with = "seamwright_program::finding_data")]
    pub findings: Vec<Finding>,
}

/// Weld metal in the work frame before each pass, and after the last one.
pub type MetalByPass<'a> = Box<dyn Iterator<Item = Result<Vec<Solid>, ClearanceError>> + 'a>;

/// Conditions of planning beside the passes.
#[derive(Default)]
pub struct Terms<'a> {
    /// Procedure whose allowed welding positions take precedence over the preferred ones.
    pub procedure: Option<&'a Procedure>,
    /// Watches the searches.
    pub watch: Option<&'a dyn Watch>,
    /// Weld metal, if any: an obstacle.
    pub metal: Option<MetalByPass<'a>>,
}

impl WeldMotion {
    /// Plans every pass along its path, and the transfer moves between them: from the end of a weld back along the
    /// torch by `retract_mm`, on a clear path to the same distance before the next start, and down to it. Wound-up
    /// rotary axes unwind in the transfer moves; axes without end stops need not.
    ///
    /// # Errors
    /// Every finding against it: those of [`PassMotion::plan`], too little clearance, a transfer move without a clear
    /// path.
    pub fn plan(
        machine: &Machine,
        around: &Surroundings,
        passes: &[(&dyn TorchPath, &Pass)],
        retract_mm: f64,
    ) -> Result<Self, Vec<Finding>> {
        Self::plan_under(machine, around, passes, retract_mm, Terms::default())
    }

    /// Plans as [`WeldMotion::plan`], under `terms`.
    ///
    /// # Errors
    /// As [`WeldMotion::plan`]; also one finding of kind `search` if the watch stopped planning.
    pub fn plan_under(
        machine: &Machine,
        around: &Surroundings,
        passes: &[(&dyn TorchPath, &Pass)],
        retract_mm: f64,
        terms: Terms,
    ) -> Result<Self, Vec<Finding>> {
        let effort = Effort::new(terms.watch);
        // Axes held by a pass also rest in its retract and approach; each pass has been planned with them.
        let machines: Vec<Cow<Machine>> = passes
            .iter()
            .map(|(_, pass)| holding(machine, &pass.spare_axes).unwrap_or(Cow::Borrowed(machine)))
            .collect();
        let ends: Vec<PassEnd> = passes
            .iter()
            .zip(&machines)
            .map(|(&(path, pass), machine)| PassEnd {
                q: Joints::default(),
                torches: Torches::new(path, pass),
                machine,
            })
            .collect();
        let order = Order { machine, passes, procedure: terms.procedure, effort: &effort, retract_mm, ends: &ends };
        let mut planned = order.plan(&mut Obstacles::new(around, terms.metal))?;
        if around.is_empty() {
            planned.findings.push(unchecked(machine));
        }
        if planned.findings.iter().any(|f| !f.allowed) { Err(planned.findings) } else { Ok(planned) }
    }

    /// Compares the planned `passes` of `machine` with `procedure`: every value outside its window gives a finding
    /// against the weld.
    pub fn hold_to(&mut self, procedure: &Procedure, machine: &Machine, passes: &[(&dyn TorchPath, &Pass)]) {
        let held = (1..).zip(passes).zip(&self.passes);
        self.procedure = held
            .map(|((number, &(path, pass)), motion)| {
                PassProcedure::new(procedure, PlannedPass { machine, path, pass, number, motion })
            })
            .collect();
        self.findings.extend(self.procedure.iter().flat_map(|p| p.findings.iter().cloned()));
    }

    /// Compares the beads of the planned `passes` of `machine` with what surface tension holds in their positions, or what
    /// `procedure` permits. Each bead that is larger gives a warning. `period` is the length of a seam welded all round,
    /// mm.
    pub fn check_pools(
        &mut self,
        procedure: Option<&Procedure>,
        machine: &Machine,
        passes: &[(&dyn TorchPath, &Pass)],
        period: Option<f64>,
    ) {
        let planned = (1..).zip(passes).zip(&self.passes);
        let findings: Vec<Finding> = planned
            .filter_map(|((number, &(path, pass)), motion)| {
                let covered = passes[number..].iter().any(|(_, later)| later.copy == pass.copy && later.bead.is_some());
                pool_check::finding(procedure, PlannedPass { machine, path, pass, number, motion }, covered, period)
            })
            .collect();
        self.findings.extend(findings);
    }

    /// Adds the transfer move before pass `i`, counted from 0, or home after the last; its findings go into `findings`.
    pub(crate) fn transfer_move(
        &mut self,
        settings: &TransferSettings,
        i: usize,
        ends: &[PassEnd],
        findings: &mut Vec<Finding>,
    ) {
        let before = i.checked_sub(1).map(|k| &self.passes[k].path);
        let after = self.passes.get(i).map(|p| &p.path);
        let end = before.map(|p| PassEnd { q: p.at(p.length()), ..ends[i - 1] });
        let start = after.map(|p| PassEnd { q: p.at(0.0), ..ends[i] });
        if let (Some(end), Some(start)) = (end, start)
            && end.torches == Torches::Given
            && start.torches == Torches::Given
            && is_same(&end.q, &start.q)
        {
            // The second pass continues from the end of the first.
            self.transfers.push(TransferMove::new(settings.machine, &[start.q]));
            return;
        }
        let (pass, s) = if i == 0 { (1, 0.0) } else { (i, before.map_or(0.0, super::joint_path::JointPath::length)) };
        let finding = |kind, message, cure, allowed| {
            let cure = Message::new(cure);
            Finding { allowed, ..Finding::error(kind, message, pass, PathRange::at(s), cure) }
        };
        let name = match i {
            0 => Message::new("motion-transfer-from-home"),
            _ if start.is_none() => Message::new("motion-transfer-home"),
            _ => Message::new("motion-transfer-between").pass("from", i).pass("to", i + 1),
        };
        let about = |code| Message::new(code).message("move", name.clone());
        match settings.way(end, start) {
            Ok((planned, _)) if planned.duration() > MAX_PASS_S => {
                let message = about("motion-transfer-too-long").quantity("time", planned.duration(), Unit::S, 0);
                findings.push(finding("air", at_most(message), "motion-cure-transfer-too-long", false));
            }
            Ok((planned, retracts)) => {
                for back in retracts {
                    let message = match back {
                        Some(mm) => about("motion-retract-short").quantity("distance", mm, Unit::Mm, 1).value(
                            "asked",
                            settings.retract_mm,
                            Unit::Mm,
                        ),
                        None => about("motion-retract-none"),
                    };
                    findings.push(finding("retract", message, "motion-cure-retract", true));
                }
                if let (Some(from), Some(to)) = (&end, &start) {
                    for (axis, by) in unwound(settings.machine, &from.q, &to.q) {
                        let message =
                            about("motion-unwind").axis("axis", axis).quantity("by", by.to_degrees(), Unit::Deg, 1);
                        findings.push(Finding::note("unwind", message, pass, PathRange::at(s)));
                    }
                }
                self.transfers.push(planned);
            }
            Err(blocked) => {
                let message = about("motion-transfer-blocked").message("reason", blocked);
                findings.push(finding("air", message, "motion-cure-transfer-blocked", false));
            }
        }
    }

    /// Passes and transfer moves in the order in which they are played; those from home and back home only with `home`.
    pub fn stages(&self, home: bool) -> impl Iterator<Item = Stage<'_>> {
        let last = self.passes.len();
        (0..=last).flat_map(move |i| {
            let played = home || (i > 0 && i < last);
            let transfer = self.transfers.get(i).filter(|_| played).map(Stage::Transfer);
            transfer.into_iter().chain(self.passes.get(i).map(|p| Stage::Pass(i, p)))
        })
    }

    /// Number of set-points of [`WeldMotion::play`].
    pub fn count(&self, period: f64, home: bool) -> u64 {
        self.stages(home).map(|stage| stage.count(period)).sum()
    }

    /// Plays the whole motion, one set-point a period: the pass (counted from 1; 0 in a transfer move), the set-point,
    /// and speeds and accelerations of the axes. In transfer moves the arc is off, and path length and speed along it
    /// are NaN.
    ///
    /// # Errors
    /// The first error of `each`, which ends the motion.
    pub fn play<E>(
        &self,
        period: f64,
        home: bool,
        mut each: impl FnMut(usize, SetPoint, (Joints, Joints)) -> Result<(), E>,
    ) -> Result<(), E> {
        let mut begun = 0;
        for stage in self.stages(home) {
            stage.play(period, begun, &mut each)?;
            begun += stage.count(period);
        }
        Ok(())
    }

    /// Speed of the torch tip of `machine` at a set-point of pass `pass` from [`WeldMotion::play`], mm/s; NaN in
    /// transfer moves.
    pub fn tip_speed(&self, machine: &Machine, pass: usize, set: &SetPoint) -> f64 {
        let planned = pass.checked_sub(1).and_then(|i| self.passes.get(i));
        planned.map_or(f64::NAN, |planned| planned.tip_speed(machine, set.profile))
    }

    /// Time from home to home, s.
    pub fn total_s(&self) -> f64 {
        self.passes.iter().map(PassMotion::total_s).sum::<f64>() + self.air_s() + self.wait_s()
    }

    /// Time of the transfer moves, s, without waits in them.
    pub fn air_s(&self) -> f64 {
        self.transfers.iter().map(|transfer| transfer.duration() - transfer.rest_s()).sum()
    }

    /// Time of the waits between passes, s.
    pub fn wait_s(&self) -> f64 {
        self.transfers.iter().map(TransferMove::rest_s).sum()
    }
}

/// A part of the motion.
#[derive(Debug, Clone, Copy)]
pub enum Stage<'a> {
    /// A pass, counted from 0.
    Pass(usize, &'a PassMotion),
    /// A transfer move.
    Transfer(&'a TransferMove),
}

impl Stage<'_> {
    /// Number of set-points, one a period.
    pub fn count(&self, period: f64) -> u64 {
        match self {
            Self::Pass(_, motion) => motion.set_points(period).size_hint().0 as u64,
            Self::Transfer(transfer) => transfer.count(period),
        }
    }

    /// Plays the stage alone as [`WeldMotion::play`], with times from set-point `begun` on.
    ///
    /// # Errors
    /// The first error of `each`, which ends the motion.
    pub fn play<E>(
        &self,
        period: f64,
        begun: u64,
        each: &mut impl FnMut(usize, SetPoint, (Joints, Joints)) -> Result<(), E>,
    ) -> Result<(), E> {
        let at = |k: u64| (begun + k) as f64 * period;
        match self {
            Self::Pass(i, motion) => {
                for (k, set) in (0..).zip(motion.set_points(period)) {
                    each(i + 1, SetPoint { t: at(k), ..set }, set.rates(motion))?;
                }
            }
            Self::Transfer(transfer) => {
                for k in 0..transfer.count(period) {
                    let Some((leg, t)) = transfer.leg(k as f64 * period) else { break };
                    let profile = ProfilePoint { s: f64::NAN, v: f64::NAN, a: f64::NAN, j: f64::NAN };
                    let set = SetPoint { t: at(k), phase: Phase::Transfer, profile, q: leg.at_time(t) };
                    each(0, set, leg.rates(t))?;
                }
            }
        }
        Ok(())
    }
}

/// Positions closer than this are equal, mm or rad.
const SAME: f64 = 1e-9;

fn is_same(a: &Joints, b: &Joints) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < SAME)
}

/// Kind of retract from the end of a pass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Torches {
    /// The torch retracts along its axis.
    One,
    /// Two torches retract along the middle of both.
    Two,
    /// The taught points of the pass define its start and end.
    Given,
}

impl Torches {
    fn new(path: &dyn TorchPath, pass: &Pass) -> Self {
        match path.second(0.0) {
            _ if pass.points.is_some() => Self::Given,
            Some(_) => Self::Two,
            None => Self::One,
        }
    }
}

#[derive(Clone, Copy)]
pub(crate) struct PassEnd<'a> {
    q: Joints,
    torches: Torches,
    /// The machine with the axes that the pass holds free of the pose.
    machine: &'a Machine,
}

pub(crate) struct TransferSettings<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) around: &'a Surroundings<'a>,
    pub(crate) retract_mm: f64,
    pub(crate) effort: &'a Effort<'a>,
}

impl TransferSettings<'_> {
    /// The move from the end of a weld (or home) to the start of the next (or home), with retract and approach; and the
    /// retract distances (mm) that are less than requested, none for a missing retract.
    fn way(&self, end: Option<PassEnd>, start: Option<PassEnd>) -> Result<(TransferMove, Vec<Option<f64>>), Message> {
        let home = self.machine.home();
        let [back_end, back_start] = [end, start].map(|e| e.and_then(|end| self.back_from(&end)));
        let place = |back: Option<(Joints, f64)>, weld: Option<PassEnd>| {
            back.map(|b| b.0).or(weld.map(|w| w.q)).unwrap_or(home)
        };
        let (from, to) = (place(back_end, end), place(back_start, start));
        // A continuous axis goes home by the shortest turn.
        let to = if start.is_none() { self.nearest_turn(&to, &from) } else { to };
        let mut points = Vec::new();
        if let (Some(PassEnd { q, .. }), Some(_)) = (end, back_end) {
            self.straight("motion-transfer-retract", &q, &from)?;
            points.push(q);
        }
        points.extend(route_within(self.effort, self.machine, self.around, &from, &to, AxisSet::default())?);
        if let (Some(PassEnd { q, .. }), Some(_)) = (start, back_start) {
            self.straight("motion-transfer-approach", &to, &q)?;
            points.push(q);
        }
        points.dedup();
        let short = |weld: Option<PassEnd>, back: Option<(Joints, f64)>| match (weld, back) {
            (Some(PassEnd { torches: Torches::Given, .. }), None) => None,
            (Some(_), None) => Some(None),
            (Some(_), Some((_, part))) if part < 1.0 => Some(Some(part * self.retract_mm)),
            _ => None,
        };
        let shorter = [short(end, back_end), short(start, back_start)].into_iter().flatten().collect();
        let planned = TransferMove {
            retracts: back_end.is_some(),
            approaches: back_start.is_some(),
            ..TransferMove::new(self.machine, &points)
        };
        Ok((planned, shorter))
    }

    fn nearest_turn(&self, q: &Joints, near: &Joints) -> Joints {
        let mut q = *q;
        for (i, axis) in self.machine.axes.iter().enumerate().filter(|(_, a)| a.range.is_none()) {
            q[i] = axis.turn_near(q[i], near[i]);
        }
        q
    }

    /// Checks the torch's straight move from or to the weld; else the error `code` with the obstacle.
    fn straight(&self, code: &'static str, from: &Joints, to: &Joints) -> Result<(), Message> {
        let leg = Leg::new(self.machine, from, to);
        let blocked = obstacle(self.around, &leg).map(|obstacle| Message::new(code).message("obstacle", obstacle));
        blocked.map_or(Ok(()), Err)
    }

    /// Positions of the torch retracted along its axis (two torches: along the middle of both), and the fraction of the
    /// requested distance that the axes reach. None if they cannot retract it.
    fn back_from(&self, PassEnd { q, torches, machine }: &PassEnd) -> Option<(Joints, f64)> {
        if *torches == Torches::Given {
            return None;
        }
        for part in [1.0, 0.5, 0.25] {
            let poses: Vec<Pose> = (0..machine.heads.len()).map(|head| machine.forward_of(head, q)).collect();
            let first = poses[0];
            let both = poses.get(1).filter(|_| *torches == Torches::Two);
            let along = both.map_or(first.direction, |second| (first.direction + second.direction).normalize());
            let back = |p: Pose| Pose { point: p.point - part * self.retract_mm * along, ..p };
            let target = Target::new(back(first), both.map(|p| back(*p)));
            if let Ok(solution) = machine.inverse_near(target, q)
                && machine.outside(&solution.joints).is_none()
            {
                return Some((solution.joints, part));
            }
        }
        None
    }
}

/// Note for a machine without shapes.
fn unchecked(machine: &Machine) -> Finding {
    let message = Message::new("motion-no-shapes").text("machine", machine.name.as_str());
    let cure = Message::new("motion-cure-no-shapes");
    Finding { allowed: true, ..Finding::error("unchecked", message, 1, PathRange::at(0.0), cure) }
}

/// Axes that turn by more than half a turn in a transfer move, with the angle, rad.
fn unwound<'m>(machine: &'m Machine, from: &Joints, to: &Joints) -> Vec<(&'m str, f64)> {
    let axes = machine.axes.iter().enumerate().filter(|(_, a)| a.kind == AxisKind::Rotary);
    let turned = axes.map(|(i, a)| (a.name.as_str(), (to[i] - from[i]).abs()));
    turned.filter(|(_, by)| *by > PI).collect()
}
