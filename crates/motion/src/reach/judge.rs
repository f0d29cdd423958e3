use super::margin::{FaultKind, Judgement, PlacementFault, PlacementMargin, places};
use crate::effort::{Effort, Watch};
use crate::follower::Follower;
use crate::joint_path::{JointPath, JointPoint};
use crate::pass_motion::{Request, along_axes};
use crate::placed_path::PlacedPath;
use crate::redundancy::{AllowedPositions, FreeAxes, holding};
use crate::singular;
use glam::DAffine3;
use seamwright_machine::{AxisSet, Joints, Machine, Target, Unreachable};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Inclination, OnLimit, Pass, Procedure, TorchPath};

/// Stations along a pass at which reach is explained.
const STATIONS: u32 = 24;

/// A weld that is to be placed: its passes as they stand now.
#[derive(Clone, Copy)]
pub struct PlacementTask<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// The passes in order, with their paths at the present placement.
    pub passes: &'a [(&'a dyn TorchPath, &'a Pass)],
    /// Procedure whose allowed welding positions are kept.
    pub procedure: Option<&'a Procedure>,
}

impl PlacementTask<'_> {
    /// Judges the work moved by the rigid displacement `by` in the work frame. None if `watch` stopped it.
    pub fn judge(&self, by: DAffine3, watch: Option<&dyn Watch>) -> Option<Judgement> {
        let effort = Effort::new(watch);
        let paths: Vec<PlacedPath> = self.passes.iter().map(|(path, _)| PlacedPath::new(*path, by)).collect();
        let weld: Vec<(&dyn TorchPath, &Pass)> =
            paths.iter().zip(self.passes).map(|(path, (_, pass))| (path as &dyn TorchPath, *pass)).collect();
        let mut margin = PlacementMargin::default();
        let mut last: Option<Joints> = None;
        for (number, &(path, pass)) in (1..).zip(&weld) {
            effort.begin_pass(number, weld.len());
            let request = Request {
                path,
                pass,
                number,
                effort: &effort,
                procedure: self.procedure,
                last: last.as_ref(),
                explains: false,
                weld: &weld,
                clearance: None,
                is_quick: true,
            };
            let judged = self.judge_pass(&request, &mut margin);
            if effort.is_stopped() {
                return None;
            }
            match judged {
                Ok(end) => last = Some(end),
                Err(fault) => return Some(Judgement::Fails(fault)),
            }
        }
        Some(Judgement::Weldable(margin))
    }

    /// Lowers `margin` to that of a pass, and returns the positions at its end.
    fn judge_pass(&self, request: &Request, margin: &mut PlacementMargin) -> Result<Joints, PlacementFault> {
        let number = request.number;
        let held = holding(self.machine, &request.pass.spare_axes)
            .map_err(|e| fault(FaultKind::Reach, number, 0.0, e.message))?;
        let (free, survey) = along_axes(&held, *request).map_err(|found| explain(&held, request, found))?;
        // The axes' path is checked for ranges below.
        let broken = survey.findings.into_iter().find(|f| !f.allowed && f.kind != "range");
        if let Some(broken) = broken {
            return Err(fault(FaultKind::Reach, number, broken.from_mm, broken.message));
        }
        let follower = Follower { machine: &held, path: request.path, free: &free };
        let mut joints = JointPath::new(follower, &survey.start).map_err(|at| jump(number, at.s))?;
        joints.turn_to_start(&held, request);
        let walk = Walk { machine: &held, request, joints: &joints, free: &free };
        walk.measure(margin)?;
        Ok(joints.at(joints.length()))
    }
}

fn fault(kind: FaultKind, pass: usize, s: f64, reason: Message) -> PlacementFault {
    PlacementFault { kind, pass, s, axis: None, reason, shortfall: 1.0 }
}

fn jump(pass: usize, s: f64) -> PlacementFault {
    fault(FaultKind::Jump, pass, s, Message::new("motion-reach-jump"))
}

/// The reason why the axes do not follow a pass: the station that is out of reach by most, if one is. The shortfall is 1
/// plus the part of stations out of reach.
fn explain(machine: &Machine, request: &Request, found: Vec<Finding>) -> PlacementFault {
    let number = request.number;
    let described = |found: Vec<Finding>| {
        let first = found.into_iter().find(|f| !f.allowed);
        first.map_or_else(|| jump(number, 0.0), |f| fault(FaultKind::Reach, number, f.from_mm, f.message))
    };
    // Without a closed form the reach at a station takes a second.
    if machine.heads[0].is_numeric() {
        return described(found);
    }
    let path = request.path;
    let stations = (0..=STATIONS).map(|i| path.length() * f64::from(i) / f64::from(STATIONS));
    let missed: Vec<(f64, Unreachable)> = stations
        .filter_map(|s| {
            request.effort.spend(1, s / path.length());
            let target = Target::new(path.pose(s), path.second(s));
            machine.reach(target, &machine.home()).err().map(|why| (s, why))
        })
        .collect();
    let part = missed.len() as f64 / f64::from(STATIONS + 1);
    let worst =
        missed.into_iter().reduce(|worst, other| if excess(&other.1) > excess(&worst.1) { other } else { worst });
    match worst {
        None => described(found),
        Some((s, why)) => PlacementFault {
            axis: axis_of(&why).and_then(|name| machine.axis(name)),
            shortfall: 1.0 + part,
            ..fault(FaultKind::Reach, number, s, why.message())
        },
    }
}

/// Orders reasons: a point out of reach before a range that is left.
fn excess(why: &Unreachable) -> f64 {
    const POINT: f64 = 1e6;
    match why {
        Unreachable::Range { by, .. } => *by,
        Unreachable::Point { by } | Unreachable::OutOfReach { by, .. } => POINT + by,
        Unreachable::Direction { by } => POINT + by.to_degrees(),
        Unreachable::Flat | Unreachable::Pair(_) => POINT,
    }
}

fn axis_of(why: &Unreachable) -> Option<&str> {
    match why {
        Unreachable::OutOfReach { axis, .. } | Unreachable::Range { axis, .. } => Some(axis),
        _ => None,
    }
}

/// The axes' path of a pass, to be measured against limits.
struct Walk<'a> {
    machine: &'a Machine,
    request: &'a Request<'a>,
    joints: &'a JointPath,
    free: &'a FreeAxes,
}

impl Walk<'_> {
    /// Lowers `margin` to the minimum over the path.
    fn measure(&self, margin: &mut PlacementMargin) -> Result<(), PlacementFault> {
        let Request { path, pass, number, procedure, .. } = *self.request;
        let decided: AxisSet = (0..self.machine.axes.len()).filter(|&i| !self.free.has(i)).collect();
        let allowed = procedure.and_then(|procedure| AllowedPositions::of(procedure, path, pass, number));
        let mut worst: Option<PlacementFault> = None;
        for s in places(self.joints) {
            let point = self.joints.point(s, s > 0.0);
            let range = self.range(s, &point.q, margin);
            let position = allowed.as_ref().and_then(|allowed| self.position(s, &point.q, allowed));
            let speed = self.speed(s, &point, margin);
            for found in [range, position, speed].into_iter().flatten() {
                if worst.as_ref().is_none_or(|worst| found.shortfall > worst.shortfall) {
                    worst = Some(found);
                }
            }
            let singular = singular::distance(self.machine, decided, &point.q);
            margin.singular = [margin.singular, singular].into_iter().flatten().reduce(f64::min);
        }
        worst.map_or(Ok(()), Err)
    }

    /// Lowers `margin` to the distance of the axes at `q` from the ends of their ranges; the axis farthest beyond one.
    fn range(&self, s: f64, q: &Joints, margin: &mut PlacementMargin) -> Option<PlacementFault> {
        let number = self.request.number;
        margin.lower_range(self.machine, q, number, s);
        let mut worst: Option<PlacementFault> = None;
        for (i, axis) in self.machine.axes.iter().enumerate() {
            let Some((low, high)) = axis.range else { continue };
            let part = (q[i] - low).min(high - q[i]) / (high - low);
            let Some(limit) = axis.outside(q[i]) else { continue };
            if worst.as_ref().is_none_or(|worst| -part > worst.shortfall) {
                let by = axis.to_file((q[i] - limit).abs());
                let reason = Message::new("motion-axis-beyond").axis("axis", axis.name.as_str());
                let reason = reason.quantity("by", by, axis.position_unit(), 3);
                let shortfall = (-part).clamp(f64::MIN_POSITIVE, 1.0);
                worst = Some(PlacementFault { axis: Some(i), shortfall, ..fault(FaultKind::Range, number, s, reason) });
            }
        }
        worst
    }

    /// Raises the use of speed in `margin`; the axis that is too slow for a pass that does not slow down.
    fn speed(&self, s: f64, point: &JointPoint, margin: &mut PlacementMargin) -> Option<PlacementFault> {
        let Request { pass, number, .. } = *self.request;
        let asked = pass.speed_at(s);
        let rate = asked / self.joints.speed_rate(self.machine, s);
        let uses = self.machine.axes.iter().enumerate().map(|(i, axis)| (i, point.d1[i].abs() * rate / axis.max_speed));
        let (axis, used) = uses.max_by(|a, b| a.1.total_cmp(&b.1))?;
        margin.speed_use = margin.speed_use.max(used);
        (used > 1.0 && pass.on_limit == OnLimit::Refuse).then(|| {
            let reason = Message::new("motion-reach-speed")
                .axis("axis", self.machine.axes[axis].name.as_str())
                .quantity("used", 100.0 * used, Unit::Percent, 0)
                .quantity("asked", asked, Unit::MmPerS, 3);
            PlacementFault {
                axis: Some(axis),
                shortfall: (used - 1.0).clamp(f64::MIN_POSITIVE, 1.0),
                ..fault(FaultKind::Speed, number, s, reason)
            }
        })
    }

    /// A welding position that the procedure does not allow.
    fn position(&self, s: f64, q: &Joints, allowed: &AllowedPositions) -> Option<PlacementFault> {
        let path = self.request.path;
        let tangent = path.groove(s).map_or_else(|| path.line(s).1, |groove| groove.tangent);
        let beyond = allowed.beyond(Inclination::new(tangent, path.face(s), self.machine.up_in_work(q)));
        (beyond > 0.0).then(|| {
            let reason = Message::new("motion-reach-position").quantity("by", beyond, Unit::Deg, 1);
            let shortfall = (beyond / 180.0).clamp(f64::MIN_POSITIVE, 1.0);
            PlacementFault { shortfall, ..fault(FaultKind::Position, self.request.number, s, reason) }
        })
    }
}
