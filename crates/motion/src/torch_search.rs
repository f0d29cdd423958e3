//! Search of torch angles that keep a pass clear.
//!
//! At stations along the pass, changes of the work angle are tried in steps, each with the machine's axes and every
//! watch of the surroundings. Dynamic programming chooses one at each station: small changes that turn slowly. On a pass
//! all round it starts and ends in the same angle. The travel angle changes by the same amount all along; amounts are
//! tried from the smallest on. The chosen angles are checked again between the stations; if that fails, more clearance
//! is asked for, twice at most. So the effort is bounded, and the same pass always gives the same angles.

use crate::transfer::{RootAt, too_near};
use glam::DVec3;
use seamwright_clearance::Evaluation;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine, Surroundings, Target};
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Groove, PathRange, TorchPath};
use std::f64::consts::TAU;

/// Steps of the angles, degrees.
const STEP_DEG: f64 = 2.5;
const TRAVEL_STEP_DEG: f64 = 5.0;
/// Distance of stations, mm, and their minimum and maximum number.
const STATION_MM: f64 = 8.0;
const STATIONS: (usize, usize) = (16, 96);
/// Checks between two stations.
const CHECKS: usize = 4;
/// Clearance beyond the minimum that is asked for, mm: more in each round.
const MARGINS_MM: [f64; 3] = [0.1, 0.5, 1.2];
/// Maximum turn from one station to the next, degrees.
const MAX_TURN_DEG: f64 = 10.0;
/// Cost of turning beside that of the change itself: ten stations take up a change of 25 degrees at equal costs.
const TURNING: f64 = 8.0;

/// Limits of the search: changes of the angles in both senses, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleLimits {
    /// Of the work angle.
    pub work: f64,
    /// Of the travel angle.
    pub travel: f64,
}

/// Changes of the torch's angles at a path length of the pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleChange {
    /// Path length of the pass, mm.
    pub s: f64,
    /// Change of the work angle, rad, positive towards the first part.
    pub work: f64,
    /// Change of the travel angle, rad, positive to drag.
    pub travel: f64,
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
    /// True if the procedure allows these changes of work and travel angle (rad) at a path length.
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
    if search.is_clear(&vec![0.0; search.places.len()], 0.0, 0.0) {
        return AngleSearch::Unchanged;
    }
    let step = TRAVEL_STEP_DEG.to_radians();
    let count = (task.limits.travel / step + 1e-9).floor() as i32;
    let travels = std::iter::once(0).chain((1..=count).flat_map(|k| [k, -k])).map(|k| f64::from(k) * step);
    for travel in travels {
        let margins = search.margins(travel);
        for more in MARGINS_MM {
            let Some(works) = search.chosen(&margins, more) else { break };
            if search.is_clear(&works, travel, 0.0) {
                let changes = search.places.iter().zip(works);
                return AngleSearch::Changed(changes.map(|(s, work)| AngleChange { s: *s, work, travel }).collect());
            }
        }
    }
    search.blocked()
}

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

    /// The watch with the smallest margin with changed angles, its evaluation and the margin; `None` if the axes cannot
    /// reach the pose or may not.
    fn nearest(&self, near: &Joints, change: AngleChange) -> Option<(f64, Option<(usize, Evaluation)>)> {
        if !(self.task.allowed)(change) {
            return None;
        }
        let pose = turned(self.path.pose(change.s), &self.path.groove(change.s)?, change);
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

    /// Margins beyond the minimum clearance, mm, by station and change of the work angle.
    fn margins(&self, travel: f64) -> Vec<Vec<f64>> {
        let at = |(s, near): (&f64, &Joints)| {
            let one = |work: &f64| {
                let found = self.nearest(near, AngleChange { s: *s, work: *work, travel });
                found.map_or(f64::NEG_INFINITY, |(margin, _)| margin)
            };
            self.works.iter().map(one).collect()
        };
        self.places.iter().zip(&self.axes).map(at).collect()
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

    /// True if the pass keeps its minimum clearance and `more` with these changes, at stations and between them.
    fn is_clear(&self, works: &[f64], travel: f64, more: f64) -> bool {
        let count = self.places.len();
        let last = if self.task.turn.is_some() { count } else { count - 1 };
        let length = self.task.turn.unwrap_or_else(|| self.path.length());
        (0..last).all(|i| {
            let next = (i + 1) % count;
            let end = if next == 0 { length } else { self.places[next] };
            (0..CHECKS).all(|k| {
                let part = k as f64 / CHECKS as f64;
                let s = (self.places[i] + part * (end - self.places[i])).min(self.path.length());
                let work = works[i] + part * (works[next] - works[i]);
                let found = self.nearest(&self.axes[i], AngleChange { s, work, travel });
                found.is_some_and(|(margin, _)| margin >= more)
            })
        })
    }

    /// The reason why no angles are clear: at the station with the least room, the two bodies that are nearest with the
    /// best angles.
    fn blocked(&self) -> AngleSearch {
        let best = |i: usize| {
            let one =
                |work: &f64| self.nearest(&self.axes[i], AngleChange { s: self.places[i], work: *work, travel: 0.0 });
            self.works.iter().filter_map(one).max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let all = (0..self.places.len()).filter_map(|i| best(i).map(|found| (i, found)));
        let Some((i, (_, Some((watch, found))))) = all.min_by(|a, b| a.1.0.total_cmp(&b.1.0)) else {
            return AngleSearch::Unchanged;
        };
        let s = self.places[i];
        let root = RootAt::of(self.path, s);
        let degrees = |angle: f64| angle.to_degrees();
        let message = Message::new("motion-no-torch-angle")
            .quantity("work", degrees(self.task.limits.work), Unit::Deg, 1)
            .quantity("travel", degrees(self.task.limits.travel), Unit::Deg, 1)
            .message("reason", too_near(self.around, watch, &found, root.as_ref()));
        let cure = Message::new("motion-cure-torch-angle");
        let finding = Finding::error("clearance", message, self.task.number, PathRange::at(s), cure);
        AngleSearch::Blocked(Box::new(finding))
    }
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
