//! Search of torch angles that keep a pass clear.
//!
//! At stations along the pass, changes of the work angle are tried in steps, each with the machine's axes and every
//! watch of the surroundings. Dynamic programming chooses one at each station: small changes that turn slowly. On a pass
//! all round it starts and ends in the same angle, and an angle must be clear in every turn. The travel angle changes by
//! the same amount all along, and so does the stick-out; amounts are tried from the smallest on, every travel angle before
//! a longer stick-out. The chosen angles are checked again between the stations; a position where they fail becomes a
//! station, and more clearance is asked for. The effort is bounded, and the same pass always gives the same angles.

mod outcome;
mod steps;

pub use outcome::AngleSearch;

use crate::effort::{Effort, SearchStage, Watch};
use glam::DVec3;
use outcome::{Progress, Reason, Setback};
use seamwright_clearance::Evaluation;
use seamwright_geometry::{MonotoneCurve, Pose};
use seamwright_machine::{AxisKind, Joints, Machine, Surroundings, Target};
use seamwright_program::{Groove, TorchPath};
use std::f64::consts::TAU;
use steps::{Walk, both_senses, multiples};

/// Steps of the angles, degrees.
const STEP_DEG: f64 = 2.5;
const TRAVEL_STEP_DEG: f64 = 5.0;
/// Step of the stick-out, mm.
const STICK_OUT_STEP_MM: f64 = 1.0;
/// Distance of stations, mm, and their minimum and maximum number before some are added.
const STATION_MM: f64 = 8.0;
const STATIONS: (usize, usize) = (16, 96);
/// Maximum number of stations that are added, and their minimum distance from others, mm.
const ADDED: usize = 64;
const APART_MM: f64 = 1.0;
/// Maximum distance of checks between stations, mm, and their minimum number.
const CHECK_MM: f64 = 2.0;
const CHECKS: f64 = 4.0;
/// Clearance beyond the minimum that is asked for, mm: more in each round.
const MARGINS_MM: [f64; 3] = [0.1, 0.5, 1.2];
/// Clearance beyond the minimum that the chosen angles must keep between stations, mm: angles in files are rounded.
const KEPT_MM: f64 = 0.02;
/// Minimum angle of the torch to the faces of both parts, degrees.
const OFF_FACE_DEG: f64 = 0.5;

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

/// A pass whose torch angles are searched.
#[derive(Clone, Copy)]
pub struct AngleTask<'a> {
    /// Its path.
    pub path: &'a dyn TorchPath,
    /// Its number, from 1.
    pub number: usize,
    /// Number of passes of the weld.
    pub passes: usize,
    /// Length of a seam welded all round, mm: the angles repeat after it.
    pub period: Option<f64>,
    /// Path lengths at which the job gives angles, mm: they are stations, so that the angles between them stay.
    pub rows: &'a [f64],
    /// Limits of the changes.
    pub limits: AngleLimits,
    /// True if the procedure allows these changes at a path length.
    pub allowed: &'a dyn Fn(AngleChange) -> bool,
    /// Limits the duration of the search.
    pub watch: Option<&'a dyn Watch>,
}

/// Searches torch angles with which a pass is clear of everything watched.
pub fn search_angles(machine: &Machine, around: &Surroundings, task: AngleTask) -> AngleSearch {
    let line = task.path.weave().map(|weave| weave.slower(0.0));
    let path = line.as_deref().unwrap_or(task.path);
    if around.is_empty() || path.groove(0.0).is_none() || path.second(0.0).is_some() {
        return AngleSearch::Unchanged;
    }
    let Some(mut search) = Search::new(machine, around, task, path) else { return AngleSearch::Unchanged };
    search.effort.begin_pass(task.number, task.passes);
    search.effort.begin(SearchStage::TorchAngles);
    let unchanged = vec![0.0; search.places.len()];
    let changes = match search.conflict(&unchanged, EvenChange::default(), 0.0) {
        None => return AngleSearch::Unchanged,
        Some(_) => search.changes(),
    };
    match (search.effort.check(task.number, path.length()), changes) {
        (Err(stopped), _) => AngleSearch::Blocked(stopped),
        (Ok(()), Some(changes)) => AngleSearch::Changed(changes),
        (Ok(()), None) => AngleSearch::Blocked(vec![search.setback.finding(around, path, &task)]),
    }
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

/// The smallest margin beyond a minimum clearance in all turns of a pass.
#[derive(Debug, Clone, Copy)]
struct Nearest {
    /// The margin, mm.
    margin: f64,
    /// Path length, mm.
    s: f64,
    /// Watch and evaluation.
    at: Option<(usize, Evaluation)>,
}

/// A position where chosen angles are not clear.
struct Conflict {
    /// Path length in the first turn, mm.
    s: f64,
    /// `None` if the angle is not allowed there.
    nearest: Option<Nearest>,
}

struct Search<'a> {
    machine: &'a Machine,
    around: &'a Surroundings<'a>,
    task: AngleTask<'a>,
    path: &'a dyn TorchPath,
    effort: Effort<'a>,
    /// Part of the search that is done.
    part: f64,
    /// Length of one turn, mm, on a pass that goes all round.
    turn: Option<f64>,
    /// Stations along one turn, or along the pass.
    places: Vec<f64>,
    /// Axes at the stations with the angles as they are.
    axes: Vec<Joints>,
    /// Usual distance of stations, mm.
    spacing: f64,
    /// Number of stations at most.
    most: usize,
    /// Changes of the work angle that are tried, rad.
    works: Vec<f64>,
    /// Obstacle of the changes that came farthest.
    setback: Setback,
}

impl<'a> Search<'a> {
    /// None if the axes cannot follow the pass as it is.
    fn new(
        machine: &'a Machine,
        around: &'a Surroundings<'a>,
        task: AngleTask<'a>,
        path: &'a dyn TorchPath,
    ) -> Option<Self> {
        let turn = task.period.filter(|period| path.length() >= *period);
        let length = turn.unwrap_or(path.length());
        let count = ((length / STATION_MM).ceil() as usize).clamp(STATIONS.0, STATIONS.1);
        let ends = if turn.is_some() { count } else { count - 1 };
        let mut places: Vec<f64> = (0..count).map(|i| length * i as f64 / ends as f64).collect();
        for s in task.rows {
            let s = turn.map_or(*s, |turn| s.rem_euclid(turn));
            if (0.0..=length).contains(&s) && places.iter().all(|place| (place - s).abs() > APART_MM) {
                places.push(s);
            }
        }
        places.sort_by(f64::total_cmp);
        let mut near = machine.inverse_near(path.pose(0.0), &machine.home()).ok()?.joints;
        let mut axes = Vec::with_capacity(places.len());
        for s in &places {
            near = machine.inverse_near(path.pose(*s), &near).ok()?.joints;
            axes.push(near);
        }
        let works = both_senses(&multiples(STEP_DEG.to_radians(), task.limits.work));
        Some(Self {
            machine,
            around,
            task,
            path,
            effort: Effort::new(task.watch),
            part: 0.0,
            turn,
            most: places.len() + ADDED,
            places,
            axes,
            spacing: length / ends as f64,
            works,
            setback: Setback::default(),
        })
    }

    /// Changes with which the pass is clear; `None` without any, or if the search was stopped.
    fn changes(&mut self) -> Option<Vec<AngleChange>> {
        let travels = multiples(TRAVEL_STEP_DEG.to_radians(), self.task.limits.travel);
        let travels: Vec<f64> = travels.iter().flat_map(|t| [*t, -t]).skip(1).collect();
        let stick_outs = multiples(STICK_OUT_STEP_MM, self.task.limits.stick_out);
        let evens: Vec<EvenChange> = stick_outs
            .iter()
            .flat_map(|&stick_out| travels.iter().map(move |&travel| EvenChange { travel, stick_out }))
            .collect();
        let mut tightest = 0.0;
        for (i, even) in evens.iter().enumerate() {
            self.part = i as f64 / evens.len() as f64;
            let Some(mut margins) = self.margins(*even, &mut tightest) else { continue };
            for more in MARGINS_MM {
                if let Some(works) = self.works(*even, &mut margins, more) {
                    let changes = self.places.iter().zip(works);
                    return Some(changes.map(|(s, work)| even.at(*s, work)).collect());
                }
            }
            if self.effort.is_stopped() {
                return None;
            }
        }
        None
    }

    /// Changes of the work angle by station with which the pass is clear. `margins` are those of the stations, and get
    /// a row for each station that is added.
    fn works(&mut self, even: EvenChange, margins: &mut Vec<Vec<f64>>, more: f64) -> Option<Vec<f64>> {
        loop {
            let walk = Walk { places: &self.places, turn: self.turn, spacing: self.spacing, works: &self.works };
            let works = match walk.cheapest(margins, more) {
                Ok(works) => works,
                Err(at) => {
                    let too_fast = Reason::TurnsTooFast { within_mm: self.spacing };
                    self.setback.note(Progress::AllStations, self.places[at], too_fast);
                    return None;
                }
            };
            let Some(conflict) = self.conflict(&works, even, KEPT_MM) else { return Some(works) };
            self.setback.note_nearest(Progress::AnglesChosen, conflict.s, conflict.nearest);
            let at = self.added(conflict.s)?;
            let row = self.row(at, even);
            margins.insert(at, row.iter().map(|nearest| nearest.map_or(f64::NEG_INFINITY, |n| n.margin)).collect());
        }
    }

    /// Adds a station at `s` and returns its index; `None` if others are too near, there are too many, or the axes
    /// cannot follow.
    fn added(&mut self, s: f64) -> Option<usize> {
        let at = self.places.partition_point(|place| *place <= s);
        let is_near = self.places.iter().any(|place| (place - s).abs() < APART_MM);
        let at_end = self.turn.is_some_and(|turn| turn - s < APART_MM);
        if is_near || at_end || self.places.len() >= self.most {
            return None;
        }
        let near = self.axes[at.saturating_sub(1)];
        let axes = self.machine.inverse_near(self.path.pose(s), &near).ok()?.joints;
        self.places.insert(at, s);
        self.axes.insert(at, axes);
        Some(at)
    }

    /// The smallest margin with changed angles in all turns; `None` if the axes cannot reach a pose or may not.
    fn nearest(&self, near: &Joints, change: AngleChange) -> Option<Nearest> {
        let length = self.path.length();
        let turns = self.turn.map_or(0.0, |turn| ((length - change.s) / turn).floor().max(0.0)) as usize;
        let mut least: Option<Nearest> = None;
        for k in 0..=turns {
            let s = (change.s + k as f64 * self.turn.unwrap_or(0.0)).min(length);
            let found = self.nearest_at(near, AngleChange { s, ..change })?;
            if least.is_none_or(|least| found.margin < least.margin) {
                least = Some(found);
            }
        }
        least
    }

    /// The smallest margin at one path length.
    fn nearest_at(&self, near: &Joints, change: AngleChange) -> Option<Nearest> {
        if !self.effort.spend(1, self.part) || !(self.task.allowed)(change) {
            return None;
        }
        let arc = self.path.pose(change.s).ahead(self.path.drawn_back());
        let groove = self.path.groove(change.s)?;
        let turned = turned(arc, &groove, change);
        let [first, second] = groove.off_faces(-turned.direction);
        if first.min(second) < OFF_FACE_DEG.to_radians().sin() {
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
        let at = self.around.nearest(&q, limit);
        let margin =
            at.as_ref().map_or(f64::INFINITY, |(w, e)| e.distance - self.around.scene().watches()[*w].least_mm());
        Some(Nearest { margin, s: change.s, at })
    }

    /// The smallest margins at a station, by change of the work angle.
    fn row(&self, i: usize, even: EvenChange) -> Vec<Option<Nearest>> {
        self.works.iter().map(|work| self.nearest(&self.axes[i], even.at(self.places[i], *work))).collect()
    }

    /// Margins beyond the minimum clearance, mm, by station and change of the work angle. `None` if a station has none
    /// that is clear: the one at `tightest`, which is tried first, or another, whose path length that becomes.
    fn margins(&mut self, even: EvenChange, tightest: &mut f64) -> Option<Vec<Vec<f64>>> {
        let first = self.places.partition_point(|place| *place < *tightest).min(self.places.len() - 1);
        let mut rows = vec![Vec::new(); self.places.len()];
        for i in std::iter::once(first).chain((0..self.places.len()).filter(|i| *i != first)) {
            let row = self.row(i, even);
            let best = row.iter().flatten().copied().max_by(|a, b| a.margin.total_cmp(&b.margin));
            if best.is_none_or(|best| best.margin < MARGINS_MM[0]) {
                self.setback.note_nearest(Progress::SomeStations, self.places[i], best);
                *tightest = self.places[i];
                return None;
            }
            rows[i] = row.iter().map(|nearest| nearest.map_or(f64::NEG_INFINITY, |n| n.margin)).collect();
        }
        Some(rows)
    }

    /// The first position where the pass does not keep its minimum clearance and `more` with these changes: at stations,
    /// and between them, where the angles change as those of a pass do.
    fn conflict(&self, works: &[f64], even: EvenChange, more: f64) -> Option<Conflict> {
        let rows: Vec<(f64, f64)> = self.places.iter().copied().zip(works.iter().copied()).collect();
        let Ok(work) = MonotoneCurve::new(&rows, self.task.period) else {
            return Some(Conflict { s: 0.0, nearest: None });
        };
        self.checks().into_iter().find_map(|(i, s)| {
            let nearest = self.nearest(&self.axes[i], even.at(s, work.at(s)));
            let is_clear = nearest.is_some_and(|nearest| nearest.margin >= more);
            (!is_clear).then_some(Conflict { s, nearest })
        })
    }

    /// Positions that are checked, each with the station before it: the whole pass, or its first turn and its end.
    fn checks(&self) -> Vec<(usize, f64)> {
        let length = self.path.length();
        let count = self.places.len();
        let mut checks = Vec::new();
        for (i, &from) in self.places.iter().enumerate() {
            let Some(to) = self.places.get(i + 1).copied().or(self.turn) else { continue };
            let parts = ((to - from) / CHECK_MM).ceil().max(CHECKS);
            checks.extend((0..parts as usize).map(|k| (i, from + (to - from) * k as f64 / parts)));
        }
        let end = self.turn.map_or(length, |turn| length.rem_euclid(turn));
        let before = self.places.partition_point(|place| *place <= end).saturating_sub(1).min(count - 1);
        checks.push((before, end));
        checks
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
