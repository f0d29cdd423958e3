use super::hill_climb::climb;
use super::random::{Random, ranges};
use super::round_trip::file_units;
use super::task::Task;
use crate::axis::AxisKind;
use crate::chain::Joints;
use glam::DVec3;
use seamwright_geometry::numeric::bisect;
use seamwright_message::{Argument, Message, Quantity, Unit};
use serde::Serialize;
use std::f64::consts::FRAC_PI_2;

/// Maximum conditioning of a singular configuration, at which the search ends.
const SINGULAR: f64 = 1e-7;
pub(super) const LOOKED_AT: u32 = 3000;
/// Number of searches from the worst of them, and from any of them.
const SEARCHES: (usize, usize) = (24, 16);
/// Displacement of an axis to test if a configuration depends on it: rad, or fraction of a stroke.
const MOVED: (f64, f64) = (0.05, 0.05);
/// A configuration depends on an axis if moving it raises the conditioning above this.
const DEPENDS: f64 = 1e-4;

/// Number of other positions at which a singularity by one axis alone must persist, and the maximum conditioning there.
const ELSEWHERE: u32 = 3;
const NEARLY: f64 = 1e-5;
/// Minimum distance of separate singular positions of an axis, mm or degrees.
const APART: f64 = 0.5;

/// Singular configurations, and the distance from them that welding needs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Singularities {
    /// Singular configurations inside the ranges, each kind once.
    pub places: Vec<SingularPlace>,
    /// Conditioning of the best and the worst positions found: the smallest singular value of the decided axes'
    /// Jacobian, with a rad weighted as 100 mm; 0 is singular.
    pub conditioning: (f64, f64),
    /// The worst-conditioned positions, in file units.
    pub worst_at: Vec<f64>,
    /// Fraction of the ranges in which some typical weld exceeds the speed of a rotary axis.
    pub too_fast: f64,
    /// The typical weld: speed, mm/s, and radius of its bend, mm.
    pub typical: (f64, f64),
}

/// A singular configuration, or a family of them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SingularPlace {
    /// Description of the singularity.
    #[serde(serialize_with = "super::english::one")]
    pub what: Message,
    /// Linear axes that follow the freed motion.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub following: Vec<String>,
    /// The axes that determine it, with one set of positions in file units.
    pub at: Vec<(String, f64)>,
    /// For a single axis: other positions with the same singularity, in file units.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<f64>,
    /// True if other combinations of these axes give the same singularity.
    pub family: bool,
    /// Minimum distance of the axis in `at` for a typical weld (mm or degrees), and the axis that is too slow below it;
    /// none if several axes determine the singularity.
    pub margin: Option<(f64, String)>,
}

impl SingularPlace {
    /// Describes the configuration with its positions; `unit` gives the unit of an axis.
    pub fn description(&self, unit: impl Fn(&str) -> Unit) -> Message {
        let mut what = self.what.clone();
        if !self.following.is_empty() {
            let axes = self.following.iter().cloned().map(Argument::Axis);
            what = Message::new("machine-singular-following").message("what", what).list("axes", axes);
        }
        if self.at.is_empty() {
            return what;
        }
        let rounded = |v: &f64| (v * 1e3).round() / 1e3 + 0.0;
        let position = |(axis, v): &(String, f64)| {
            let values = std::iter::once(v).chain(&self.also).map(rounded);
            let values = values.map(|v| Argument::Quantity(Quantity::exact(v, unit(axis))));
            Message::new("machine-singular-position").axis("axis", axis).list("values", values)
        };
        let code = if self.family { "machine-singular-for-example" } else { "machine-singular-at" };
        let positions = self.at.iter().map(|at| Argument::Message(Box::new(position(at))));
        Message::new(code).message("what", what).list("positions", positions)
    }
}

/// Searches singular configurations of a task inside the ranges; those of the arm, if one carries the torch.
pub(super) fn find(task: &Task, seed: u64, step: &mut dyn FnMut()) -> Singularities {
    let arm = Task::of_arm(task.machine);
    let task = arm.as_ref().unwrap_or(task);
    let machine = task.machine;
    let mut random = Random::new(seed, 4);
    let mut looked: Vec<(f64, Joints)> = Vec::new();
    let mut too_fast = 0u32;
    for k in 0..LOOKED_AT {
        step();
        let q = if k == 0 { machine.home() } else { random.joints(machine) };
        looked.push((task.conditioning(&q), q));
        let need = task.need(&q);
        too_fast += u32::from((0..need.len()).any(|i| task.is_rotary(i) && need[i] > 1.0));
    }
    let any: Vec<Joints> = looked.iter().take(SEARCHES.1).map(|l| l.1).collect();
    looked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let best = looked.last().map_or(0.0, |l| l.0);
    let starts = looked.iter().take(SEARCHES.0).map(|l| l.1).chain(any);
    let mut places: Vec<SingularPlace> = Vec::new();
    let mut worst = looked[0];
    for start in starts {
        let (q, height) = climb(machine, &start, -SINGULAR, |q| -task.conditioning(q));
        if -height < worst.0 {
            worst = (-height, q);
        }
        if -height <= SINGULAR {
            let place = describe(task, &q);
            if !places.iter().any(|p| same(p, &place)) {
                places.push(place);
            }
        }
    }
    places.sort_by(|a, b| a.at.iter().map(|x| x.1).sum::<f64>().total_cmp(&b.at.iter().map(|x| x.1).sum::<f64>()));
    let places = grouped(places);
    Singularities {
        places,
        conditioning: (best, worst.0),
        worst_at: file_units(machine, &worst.1),
        too_fast: f64::from(too_fast) / f64::from(LOOKED_AT),
        typical: (super::TYPICAL_SPEED_MM_S, super::TYPICAL_RADIUS_MM),
    }
}

/// True for the same kind of configuration; a family at other positions counts as the same.
fn same(a: &SingularPlace, b: &SingularPlace) -> bool {
    let near = a.at.iter().zip(&b.at).all(|(x, y)| (x.1 - y.1).abs() < 0.01);
    is_one_kind(a, b) && (a.family || near)
}

fn is_one_kind(a: &SingularPlace, b: &SingularPlace) -> bool {
    // The following linear axes depend on their positions.
    let axes = |p: &SingularPlace| p.at.iter().map(|x| x.0.clone()).collect::<Vec<_>>();
    a.what == b.what && axes(a) == axes(b)
}

/// Merges configurations of one kind that differ in the position of one axis, with the largest margin.
fn grouped(places: Vec<SingularPlace>) -> Vec<SingularPlace> {
    let mut groups: Vec<SingularPlace> = Vec::new();
    for place in places {
        match groups.iter_mut().find(|group| group.at.len() == 1 && is_one_kind(group, &place)) {
            Some(group) => {
                let known = |v: f64| std::iter::once(&group.at[0].1).chain(&group.also).any(|k| (k - v).abs() < APART);
                let value = place.at[0].1;
                if !known(value) {
                    group.also.push(value);
                }
                let by = |margin: &Option<(f64, String)>| margin.as_ref().map_or(0.0, |m| m.0);
                if by(&place.margin) > by(&group.margin) {
                    group.margin = place.margin;
                }
            }
            None => groups.push(place),
        }
    }
    groups
}

fn describe(task: &Task, q: &Joints) -> SingularPlace {
    if task.is_arm() {
        return of_arm(task, q);
    }
    let machine = task.machine;
    let lost = task.lost(q);
    let greatest = |rotary: bool| {
        let rates = (0..lost.len()).filter(|&i| task.is_rotary(i) == rotary).map(|i| lost[i].abs());
        rates.fold(0.0, f64::max)
    };
    // A rad moves a point 100 mm away by 100 mm.
    let (turns, moves) = (super::TYPICAL_RADIUS_MM * greatest(true), greatest(false));
    let all = turns.max(moves);
    let part = |i: &usize| {
        let scale = if task.is_rotary(*i) { super::TYPICAL_RADIUS_MM } else { 1.0 };
        scale * lost[*i].abs() > 1e-4 * all
    };
    let involved: Vec<usize> = (0..lost.len()).filter(part).collect();
    let (rotary, linear): (Vec<usize>, Vec<usize>) = involved.into_iter().partition(|&i| task.is_rotary(i));
    let defining: Vec<usize> = machine.heads[0].chain.axes().iter().filter(|&axis| depends(task, q, axis)).collect();
    let (what, following) = if task.axes.len() < 5 && task.point_conditioning(q) <= SINGULAR {
        (point_lost(task, q), Vec::new())
    } else {
        freedom_lost(task, q, &rotary, &linear)
    };
    let margin = match defining.as_slice() {
        [axis] => margin(task, q, *axis),
        _ => None,
    };
    let value = |&axis: &usize| (machine.axes[axis].name.clone(), machine.axes[axis].to_file(q[axis]));
    let at: Vec<(String, f64)> = defining.iter().map(value).collect();
    SingularPlace { what, following, family: at.len() > 1, at, also: Vec::new(), margin }
}

/// True if a small displacement of the axis removes the singularity.
fn depends(task: &Task, q: &Joints, axis: usize) -> bool {
    let (low, high) = ranges(task.machine)[axis];
    let by = match task.machine.axes[axis].kind {
        AxisKind::Rotary => MOVED.0.min(0.4 * (high - low)),
        AxisKind::Linear => MOVED.1 * (high - low),
    };
    let mut moved = *q;
    moved[axis] += if q[axis] + by <= high { by } else { -by };
    task.conditioning(&moved) > DEPENDS
}

/// Direction of a decided axis and a point on it, in the work frame.
fn line(task: &Task, q: &Joints, i: usize) -> (DVec3, DVec3) {
    let motion = task.machine.link_frames(q);
    task.machine.links.screw_at(task.axes[i], &motion).map_or((DVec3::ZERO, DVec3::ZERO), |s| (s.direction, s.at))
}

/// Describes a motion of the decided axes that leaves the torch at rest, and gives the linear axes that follow it.
fn freedom_lost(task: &Task, q: &Joints, rotary: &[usize], linear: &[usize]) -> (Message, Vec<String>) {
    let tip = task.machine.forward(q);
    let names = |of: &[usize]| of.iter().map(|&i| task.name(i).to_owned()).collect::<Vec<_>>();
    let list = |of: &[usize]| names(of).into_iter().map(Argument::Axis);
    let following = names(linear);
    match rotary {
        [] => (Message::new("machine-singular-linear").list("axes", list(linear)), Vec::new()),
        [one] => {
            let along = line(task, q, *one).0.cross(tip.direction).length() < 1e-5;
            let name = task.name(*one);
            match along {
                true => (Message::new("machine-singular-along-axis").axis("axis", name), following),
                false => {
                    let what = Message::new("machine-singular-undone").axis("axis", name);
                    (what.list("axes", list(linear)), Vec::new())
                }
            }
        }
        [a, b] => {
            let [u, v] = [a, b].map(|&i| line(task, q, i).0);
            let parallel = u.cross(v).length() < 1e-5;
            let what = Message::new(if parallel { "machine-singular-parallel" } else { "machine-singular-tilt" });
            (what.axis("first", task.name(*a)).axis("second", task.name(*b)), following)
        }
        _ => (Message::new("machine-singular-undo").list("axes", list(rotary)), following),
    }
}

/// Names the singularity of a six-axis arm. Wrist and elbow singularities depend on one axis alone; the remaining one
/// is that of the shoulder.
fn of_arm(task: &Task, q: &Joints) -> SingularPlace {
    let machine = task.machine;
    let [j1, j2, j3, j4, j5, j6] = [0, 1, 2, 3, 4, 5].map(|i| task.axes[i]);
    let name = |axis: usize| machine.axes[axis].name.clone();
    let alone = |axis: usize| {
        (1..=ELSEWHERE).all(|k| {
            let mut elsewhere = machine.spread(k);
            elsewhere[axis] = q[axis];
            task.conditioning(&elsewhere) < NEARLY
        })
    };
    let place = |what: Message, by: &[usize], margin| SingularPlace {
        what,
        following: Vec::new(),
        at: by.iter().map(|&axis| (name(axis), machine.axes[axis].to_file(q[axis]))).collect(),
        also: Vec::new(),
        family: by.len() > 1,
        margin,
    };
    if alone(j5) {
        let what = Message::new("machine-singular-wrist").axis("first", name(j4)).axis("second", name(j6));
        return place(what, &[j5], margin(task, q, j5));
    }
    if alone(j3) {
        return place(Message::new("machine-singular-elbow"), &[j3], margin(task, q, j3));
    }
    place(Message::new("machine-singular-shoulder").axis("axis", name(j1)), &[j2, j3], None)
}

/// Describes the lost direction of motion of the tip on a machine with few axes.
fn point_lost(task: &Task, q: &Joints) -> Message {
    let tip = task.machine.forward(q).point;
    if let Some((a, b)) = in_line(task, q, tip) {
        return Message::new("machine-singular-stretched").axis("first", a).axis("second", b);
    }
    let on = (0..task.axes.len()).filter(|&i| task.is_rotary(i)).find(|&i| {
        let (direction, at) = line(task, q, i);
        direction.cross(tip - at).length() < 1e-3
    });
    if let Some(i) = on {
        return Message::new("machine-singular-tip-on-axis").axis("axis", task.name(i));
    }
    // The direction that the tip's motions have the least part in.
    let points = task.columns(q).fixed_rows::<3>(0).into_owned();
    let motions = (&points * points.transpose()).symmetric_eigen();
    let lost = DVec3::from_slice(motions.eigenvectors.column(motions.eigenvalues.imin()).as_slice());
    let what = Message::new("machine-singular-direction");
    what.number("x", lost.x, 2).number("y", lost.y, 2).number("z", lost.z, 2)
}

/// Finds two parallel rotary axes with the tip in the plane of both: both move the tip in the same direction.
fn in_line<'a>(task: &'a Task, q: &Joints, tip: DVec3) -> Option<(&'a str, &'a str)> {
    let rotary: Vec<usize> = (0..task.axes.len()).filter(|&i| task.is_rotary(i)).collect();
    let lines: Vec<(DVec3, DVec3)> = rotary.iter().map(|&i| line(task, q, i)).collect();
    for (k, (u, a)) in lines.iter().enumerate() {
        for (l, (v, b)) in lines.iter().enumerate().take(k) {
            let (first, second) = (u.cross(tip - *a), v.cross(tip - *b));
            let scale = first.length() * second.length();
            let parallel = u.cross(*v).length() < 1e-9;
            if parallel && scale > 1e-3 && first.cross(second).length() < 1e-3 * scale {
                return Some((task.name(rotary[l]), task.name(rotary[k])));
            }
        }
    }
    None
}

/// Minimum distance of the axis from the singularity with all rotary axes fast enough, in file units, and the axis too
/// slow below it.
fn margin(task: &Task, q: &Joints, axis: usize) -> Option<(f64, String)> {
    let rotary: Vec<usize> = (0..task.axes.len()).filter(|&i| task.is_rotary(i)).collect();
    let judged: Vec<usize> = if rotary.is_empty() { (0..task.axes.len()).collect() } else { rotary };
    let at = |by: f64| {
        let mut moved = *q;
        moved[axis] += by;
        let need = task.need(&moved);
        let worst = judged.iter().max_by(|a, b| need[**a].total_cmp(&need[**b]));
        worst.map_or((0.0, String::new()), |&i| (need[i], task.name(i).to_owned()))
    };
    let (low, high) = ranges(task.machine)[axis];
    let linear = task.machine.axes[axis].kind == AxisKind::Linear;
    const NEAR: f64 = 1e-9;
    let mut widest: Option<(f64, String)> = None;
    for (sense, room) in [(1.0, high - q[axis]), (-1.0, q[axis] - low)] {
        let far = if linear { room } else { room.min(FRAC_PI_2) };
        if far < 1e-6 {
            continue;
        }
        let (need, name) = at(sense * NEAR);
        if need <= 1.0 || at(sense * far).0 > 1.0 {
            continue;
        }
        let (_, clear) = bisect(NEAR, far, 60, |by| at(sense * by).0 > 1.0);
        if widest.as_ref().is_none_or(|w| clear > w.0) {
            widest = Some((clear, name));
        }
    }
    widest.map(|(by, name)| (task.machine.axes[axis].to_file(by), name))
}
