//! Search of torch angles that keep a pass clear.
//!
//! At stations along the pass, changes of the work angle are tried in steps, each with the machine's axes and every
//! watch of the surroundings. Dynamic programming chooses one at each station: small changes that turn slowly. On a pass
//! all round it starts and ends in the same angle. The travel angle changes by the same amount all along, and so does the
//! stick-out; amounts are tried from the smallest on, every travel angle before a longer stick-out. The chosen angles are
//! checked again between the stations; if that fails, more clearance is asked for, twice at most. So the effort is bounded, and the same pass always gives the same angles.

use crate::transfer::{RootAt, too_near};
use glam::DVec3;
use seamwright_clearance::Evaluation;
use seamwright_geometry::{MonotoneCurve, Pose};
use seamwright_machine::{AxisKind, Joints, Machine, Surroundings, Target};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Groove, PathRange, TorchPath};
use std::f64::consts::TAU;

/// Steps of the angles, degrees.
const STEP_DEG: f64 = 2.5;
const TRAVEL_STEP_DEG: f64 = 5.0;
/// Step of the stick-out, mm.
const STICK_OUT_STEP_MM: f64 = 1.0;
/// Distance of stations, mm, and their minimum and maximum number.
const STATION_MM: f64 = 8.0;
const STATIONS: (usize, usize) = (16, 96);
/// Checks between two stations.
const CHECKS: usize = 4;
/// Clearance beyond the minimum that is asked for, mm: more in each round.
const MARGINS_MM: [f64; 3] = [0.1, 0.5, 1.2];
/// Clearance beyond the minimum that the chosen angles must keep between stations, mm: angles in files are rounded.
const KEPT_MM: f64 = 0.02;
/// Minimum angle of the torch to the faces of both parts, degrees.
const OFF_FACE_DEG: f64 = 0.5;
/// Maximum turn from one station to the next, degrees.
const MAX_TURN_DEG: f64 = 10.0;
/// Cost of turning beside that of the change itself: ten stations take up a change of 25 degrees at equal costs.
const TURNING: f64 = 8.0;

/// Limits of the search: changes of the angles in both senses, rad, and of the stick-out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleLimits {
    /// Of the work angle.
    pub work: f64,
    /// Of the travel angle.
    pub travel: f64,
    /// Maximum addition to the stick-out, mm.
    pub stick_out: f64,
}

/// Changes of the torch's angles and stick-out at a path length of the pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleChange {
    /// Path length of the pass, mm.
    pub s: f64,
    /// Change of the work angle, rad, positive towards the first part.
    pub work: f64,
    /// Change of the travel angle, rad, positive to drag.
    pub travel: f64,
    /// Addition to the stick-out, mm.
    pub stick_out: f64,
}

/// Result of [`search_angles`].
#[derive(Debug, Clone, PartialEq)]
pub enum AngleSearch {
    /// The pass is clear as it is, or the axes cannot follow it: nothing is changed.
    Unchanged,
    /// With these changes it is clear.
    Changed(Vec<AngleChange>),
    /// No angles within the limits are clear.
    Blocked(Box<Finding>),
}

/// A pass whose torch angles are searched.
#[derive(Clone, Copy)]
pub struct AngleTask<'a> {
    /// Its path.
    pub path: &'a dyn TorchPath,
    /// Its number, from 1.
    pub number: usize,
    /// Length of the seam once, if the pass runs all round: the angles repeat after it.
    pub turn: Option<f64>,
    /// Limits of the changes.
    pub limits: AngleLimits,
    /// True if the procedure allows these changes at a path length.
    pub allowed: &'a dyn Fn(AngleChange) -> bool,
}

/// Searches torch angles with which a pass is clear of everything watched.
pub fn search_angles(machine: &Machine, around: &Surroundings, task: AngleTask) -> AngleSearch {
    let line = task.path.weave().map(|weave| weave.slower(0.0));
    let path = line.as_deref().unwrap_or(task.path);
    if around.is_empty() || path.groove(0.0).is_none() || path.second(0.0).is_some() {
        return AngleSearch::Unchanged;
    }
    let Some(search) = Search::new(machine, around, task, path) else { return AngleSearch::Unchanged };
    if search.is_clear(&vec![0.0; search.places.len()], EvenChange::default(), 0.0) {
        return AngleSearch::Unchanged;
    }
    let mut tightest = 0;
    for even in search.even_changes() {
        let Some(margins) = search.margins(even, &mut tightest) else { continue };
        for more in MARGINS_MM {
            let Some(works) = search.chosen(&margins, more) else { break };
            if search.is_clear(&works, even, KEPT_MM) {
                let changes = search.places.iter().zip(works);
                return AngleSearch::Changed(changes.map(|(s, work)| even.at(*s, work)).collect());
            }
        }
    }
    search.blocked()
}

/// Changes that are the same all along a pass.
#[derive(Debug, Clone, Copy, Default)]
struct EvenChange {
    travel: f64,
    stick_out: f64,
}

impl EvenChange {
    /// The changes at `s` with one of the work angle.
    fn at(self, s: f64, work: f64) -> AngleChange {
        AngleChange { s, work, travel: self.travel, stick_out: self.stick_out }
    }
}

/// The smallest margin beyond a minimum clearance, mm, with the watch that has it and its evaluation.
type Nearest = (f64, Option<(usize, Evaluation)>);

struct Search<'a> {
    machine: &'a Machine,
    around: &'a Surroundings<'a>,
    task: AngleTask<'a>,
    path: &'a dyn TorchPath,
    /// Stations along one turn, or along the pass.
    places: Vec<f64>,
    /// Axes at the stations with the angles as they are.
    axes: Vec<Joints>,
    /// Changes of the work angle that are tried, rad.
    works: Vec<f64>,
}

impl<'a> Search<'a> {
    /// None if the axes cannot follow the pass as it is.
    fn new(
        machine: &'a Machine,
        around: &'a Surroundings<'a>,
        task: AngleTask<'a>,
        path: &'a dyn TorchPath,
    ) -> Option<Self> {
        let length = task.turn.map_or(path.length(), |turn| turn.min(path.length()));
        let count = ((length / STATION_MM).ceil() as usize).clamp(STATIONS.0, STATIONS.1);
        let ends = if task.turn.is_some() { count } else { count - 1 };
        let places: Vec<f64> = (0..count).map(|i| length * i as f64 / ends as f64).collect();
        let home: Joints = std::array::from_fn(|i| machine.axes.get(i).map_or(0.0, |axis| axis.home));
        let mut near = machine.inverse_near(path.pose(0.0), &home).ok()?.joints;
        let mut axes = Vec::with_capacity(count);
        for s in &places {
            near = machine.inverse_near(path.pose(*s), &near).ok()?.joints;
            axes.push(near);
        }
        let step = STEP_DEG.to_radians();
        let steps = (task.limits.work / step + 1e-9).floor() as i32;
        let works = (-steps..=steps).map(|k| f64::from(k) * step).collect();
        Some(Self { machine, around, task, path, places, axes, works })
    }

    /// Additions to the stick-out that are tried, mm.
    fn stick_outs(&self) -> impl Iterator<Item = f64> + use<> {
        let steps = (self.task.limits.stick_out / STICK_OUT_STEP_MM + 1e-9).floor() as i32;
        (0..=steps).map(|k| f64::from(k) * STICK_OUT_STEP_MM)
    }

    /// The changes all along that are tried, in this order.
    fn even_changes(&self) -> impl Iterator<Item = EvenChange> + use<> {
        let travel = self.task.limits.travel;
        let step = TRAVEL_STEP_DEG.to_radians();
        let count = (travel / step + 1e-9).floor() as i32;
        let travels =
            move || std::iter::once(0).chain((1..=count).flat_map(|k| [k, -k])).map(move |k| f64::from(k) * step);
        self.stick_outs().flat_map(move |stick_out| travels().map(move |travel| EvenChange { travel, stick_out }))
    }

    /// The watch with the smallest margin with changed angles, its evaluation and the margin; `None` if the axes cannot
    /// reach the pose or may not.
    fn nearest(&self, near: &Joints, change: AngleChange) -> Option<Nearest> {
        if !(self.task.allowed)(change) {
            return None;
        }
        let arc = self.path.pose(change.s).ahead(self.path.drawn_back());
        let groove = self.path.groove(change.s)?;
        let turned = turned(arc, &groove, change);
        if is_in_face(&groove, -turned.direction) {
            return None;
        }
        let pose = turned.ahead(-self.path.drawn_back() - change.stick_out);
        let target: Target = pose.into();
        let q = self.machine.inverse_near(target, near).ok()?.joints;
        // An axis that is out of range with the angles as they are is for the plan to report, and so are whole turns.
        let is_beyond = |i: usize, q: &Joints| {
            let axis = &self.machine.axes[i];
            let turns = axis.kind == AxisKind::Rotary;
            let range = axis.range.filter(|(low, high)| !turns || high - low < TAU);
            range.is_some_and(|(low, high)| !(low..=high).contains(&q[i]))
        };
        if (0..self.machine.axes.len()).any(|i| is_beyond(i, &q) && !is_beyond(i, near)) {
            return None;
        }
        let limit = self.around.greatest_least_mm() + 2.0 * MARGINS_MM[MARGINS_MM.len() - 1];
        let nearest = self.around.nearest(&q, limit);
        let margin = nearest
            .as_ref()
            .map_or(f64::INFINITY, |(watch, e)| e.distance - self.around.scene().watches()[*watch].least_mm());
        Some((margin, nearest))
    }

    /// Margins beyond the minimum clearance, mm, by station and change of the work angle. `None` if a station has none
    /// that is clear: the `tightest`, which is tried first, and becomes that one.
    fn margins(&self, even: EvenChange, tightest: &mut usize) -> Option<Vec<Vec<f64>>> {
        let row = |i: usize| -> Vec<f64> {
            let one = |work: &f64| {
                let found = self.nearest(&self.axes[i], even.at(self.places[i], *work));
                found.map_or(f64::NEG_INFINITY, |(margin, _)| margin)
            };
            self.works.iter().map(one).collect()
        };
        let is_open = |row: &[f64]| row.iter().any(|margin| *margin >= MARGINS_MM[0]);
        if !is_open(&row(*tightest)) {
            return None;
        }
        let mut rows = Vec::with_capacity(self.places.len());
        for i in 0..self.places.len() {
            rows.push(row(i));
            if !is_open(&rows[i]) {
                *tightest = i;
                return None;
            }
        }
        Some(rows)
    }

    /// Changes of the work angle by station that keep `more` than the minimum clearance, changing least.
    fn chosen(&self, margins: &[Vec<f64>], more: f64) -> Option<Vec<f64>> {
        let order: Vec<usize> = (0..self.places.len()).collect();
        let open = self.path_through(margins, more, &order, None)?;
        if self.task.turn.is_none() {
            return Some(open.into_iter().map(|k| self.works[k]).collect());
        }
        // All round: from the middle of the open solution once round, and back to the same angle.
        let half = order.len() / 2;
        let round: Vec<usize> = (0..=order.len()).map(|i| (half + i) % order.len()).collect();
        let closed = self.path_through(margins, more, &round, Some(open[half]))?;
        let mut works = vec![0.0; order.len()];
        round.iter().zip(closed).for_each(|(i, k)| works[*i] = self.works[k]);
        Some(works)
    }

    /// The cheapest steps through the stations in `order`; with `end` it starts and ends there.
    fn path_through(&self, margins: &[Vec<f64>], more: f64, order: &[usize], end: Option<usize>) -> Option<Vec<usize>> {
        let count = self.works.len();
        let own = |place: usize, at: usize, k: usize| {
            let is_end = place == 0 || place + 1 == order.len();
            let open = margins[at][k] >= more && end.is_none_or(|end| !is_end || end == k);
            if open { self.works[k] * self.works[k] } else { f64::INFINITY }
        };
        let reach = (MAX_TURN_DEG / STEP_DEG) as usize;
        let mut costs: Vec<f64> = (0..count).map(|k| own(0, order[0], k)).collect();
        let mut from: Vec<Vec<usize>> = Vec::with_capacity(order.len());
        for (place, &at) in order.iter().enumerate().skip(1) {
            let mut next = vec![f64::INFINITY; count];
            let mut came = vec![0; count];
            for k in 0..count {
                let first = k.saturating_sub(reach);
                for (j, before) in costs.iter().enumerate().take(k + reach + 1).skip(first) {
                    let turn = self.works[k] - self.works[j];
                    let cost = before + TURNING * turn * turn + own(place, at, k);
                    if cost < next[k] {
                        (next[k], came[k]) = (cost, j);
                    }
                }
            }
            costs = next;
            from.push(came);
        }
        let last = (0..count).min_by(|a, b| costs[*a].total_cmp(&costs[*b]))?;
        if costs[last].is_infinite() {
            return None;
        }
        let mut steps = vec![last];
        for came in from.iter().rev() {
            steps.push(came[steps[steps.len() - 1]]);
        }
        steps.reverse();
        Some(steps)
    }

    /// True if the pass keeps its minimum clearance and `more` with these changes, at stations and between them, where
    /// the angles change as those of a pass do.
    fn is_clear(&self, works: &[f64], even: EvenChange, more: f64) -> bool {
        let rows: Vec<(f64, f64)> = self.places.iter().copied().zip(works.iter().copied()).collect();
        let Ok(work) = MonotoneCurve::new(&rows, self.task.turn) else { return false };
        let count = self.places.len();
        let last = if self.task.turn.is_some() { count } else { count - 1 };
        let length = self.task.turn.unwrap_or_else(|| self.path.length());
        (0..last).all(|i| {
            let end = self.places.get(i + 1).copied().unwrap_or(length);
            (0..CHECKS).all(|k| {
                let part = k as f64 / CHECKS as f64;
                let s = (self.places[i] + part * (end - self.places[i])).min(self.path.length());
                let found = self.nearest(&self.axes[i], even.at(s, work.at(s)));
                found.is_some_and(|(margin, _)| margin >= more)
            })
        })
    }

    /// The reason why no angles are clear: a station where none is allowed, the two bodies that are nearest with the best
    /// angles where there is least room, or angles that change too fast along the seam.
    fn blocked(&self) -> AngleSearch {
        let longest = self.stick_outs().last().unwrap_or(0.0);
        let even = EvenChange { travel: 0.0, stick_out: longest };
        let mut least: Option<(Nearest, f64)> = None;
        for (s, near) in self.places.iter().zip(&self.axes) {
            let found = self.works.iter().filter_map(|work| self.nearest(near, even.at(*s, *work)));
            let Some(best) = found.max_by(|a, b| a.0.total_cmp(&b.0)) else {
                return self.no_angle(*s, Message::new("motion-angle-none-allowed"));
            };
            if least.as_ref().is_none_or(|(known, _)| best.0 < known.0) {
                least = Some((best, *s));
            }
        }
        match least {
            Some(((margin, Some((watch, found))), s)) if margin < MARGINS_MM[0] => {
                let root = RootAt::of(self.path, s);
                self.no_angle(s, too_near(self.around, watch, &found, root.as_ref()))
            }
            _ => {
                let reason = Message::new("motion-angle-turns-too-fast")
                    .value("turn", MAX_TURN_DEG, Unit::Deg)
                    .quantity("way", self.places[1] - self.places[0], Unit::Mm, 1);
                self.no_angle(least.map_or(0.0, |(_, s)| s), reason)
            }
        }
    }

    /// No angles are clear at `s`, for this reason.
    fn no_angle(&self, s: f64, reason: Message) -> AngleSearch {
        let AngleLimits { work, travel, stick_out } = self.task.limits;
        let code = if stick_out > 0.0 { "motion-no-torch-angle-longer" } else { "motion-no-torch-angle" };
        let mut message = Message::new(code)
            .quantity("work", work.to_degrees(), Unit::Deg, 1)
            .quantity("travel", travel.to_degrees(), Unit::Deg, 1)
            .message("reason", reason);
        if stick_out > 0.0 {
            message = message.quantity("longer", stick_out, Unit::Mm, 1);
        }
        let cure = Message::new("motion-cure-torch-angle");
        let finding = Finding::error("clearance", message, self.task.number, PathRange::at(s), cure);
        AngleSearch::Blocked(Box::new(finding))
    }
}

/// True if the unit vector `torch`, from joint to torch, points into a face of the joint.
fn is_in_face(groove: &Groove, torch: DVec3) -> bool {
    let (sin, cos) = (0.5 * groove.dihedral).sin_cos();
    let off = |side: f64| torch.dot(sin * groove.face - side * cos * groove.towards_first);
    off(1.0).min(off(-1.0)) < OFF_FACE_DEG.to_radians().sin()
}

/// The pose with changed angles: about the tangent by the work angle, and in the plane of torch and tangent by the
/// travel angle.
fn turned(pose: Pose, groove: &Groove, change: AngleChange) -> Pose {
    let torch = -pose.direction;
    let (t, out, aside) = (groove.tangent, groove.face, groove.towards_first);
    let travel = torch.dot(t).clamp(-1.0, 1.0).asin() + change.travel;
    let work = torch.dot(aside).atan2(torch.dot(out)) + change.work;
    let across: DVec3 = work.cos() * out + work.sin() * aside;
    Pose { direction: -(travel.cos() * across + travel.sin() * t), ..pose }
}
