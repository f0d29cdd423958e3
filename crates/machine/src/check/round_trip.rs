use super::random::Random;
use super::task::Task;
use crate::axis::AxisKind;
use crate::chain::Joints;
use crate::inverse::Solution;
use crate::machine::{Machine, Target};
use seamwright_geometry::{Pose, angle_between};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Below this conditioning the pose is near a singular one: in doubles it no longer determines every axis to 1e-9.
pub(super) const NEAR_SINGULAR: f64 = 1e-3;
/// Maximum error of a tip, mm per metre of the machine.
pub(super) const POINT: f64 = 1e-9;
/// Maximum error of a direction, rad: regular poses, and all poses.
const DIRECTION: (f64, f64) = (1e-9, 1e-6);
/// Maximum error of axes, mm or deg per metre: closed form, Newton's method.
const AXES: (f64, f64) = (1e-9, 1e-6);
/// With Newton's method only every n-th pose is also solved from elsewhere, which takes hundreds of starts.
const NUMERIC_STRIDE: u32 = 500;

/// Round-trip errors of positions solved from their own poses.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct RoundTrip {
    /// Random positions tried.
    pub poses: u32,
    /// Solutions compared: nearest ones, and all branches from elsewhere.
    pub solutions: u64,
    /// Worst distance of the tip, mm.
    pub point_mm: f64,
    /// Worst difference of the direction's error from the solution's attitude error, degrees.
    pub direction_deg: f64,
    /// Worst difference of an axis, mm or degrees, away from singular poses.
    pub axes_mm_or_deg: f64,
    /// Number of poses near a singular one, whose axes are not compared.
    pub near_singular: u32,
    /// Number of poses without a solution.
    pub unsolved: u32,
    /// Number of poses whose own positions are missing among the branches found from elsewhere.
    pub branch_missed: u32,
    /// Number of acceptable poses in [`RoundTrip::unsolved`]: slides off centre turn the pair of tips.
    pub off_centre: u32,
    /// Positions of the worst tip or direction, in file units.
    pub worst_at: Vec<f64>,
    /// True if all errors are within their limits.
    pub passed: bool,
    #[serde(skip)]
    regular_direction: f64,
}

impl RoundTrip {
    /// Compares tips and directions at `solution` with its target poses.
    pub fn compare(&mut self, machine: &Machine, poses: &[Pose], q: &Joints, solution: &Solution, regular: bool) {
        self.solutions += 1;
        let mut off = 0.0f64;
        let mut point = 0.0f64;
        for (head, pose) in poses.iter().enumerate() {
            let again = machine.forward_of(head, &solution.joints);
            // `f64::max` ignores NaN; here it counts as the worst value.
            let worst = |v: f64| if v.is_finite() { v } else { f64::INFINITY };
            point = point.max(worst((again.point - pose.point).length()));
            off = off.max(worst(angle_between(again.direction, pose.direction)));
        }
        let direction = (off - solution.attitude_error).abs();
        if point > self.point_mm || direction.to_degrees() > self.direction_deg {
            self.worst_at = file_units(machine, q);
        }
        self.point_mm = self.point_mm.max(point);
        self.direction_deg = self.direction_deg.max(direction.to_degrees());
        if regular {
            self.regular_direction = self.regular_direction.max(direction);
        }
    }

    /// Sets `passed` by the limits: of Newton's method if the inverse is `numeric`, for a machine of `size_m` metres.
    pub fn judge(&mut self, numeric: bool, size_m: f64) {
        let axes = if numeric { AXES.1 } else { AXES.0 };
        self.passed = self.point_mm <= POINT * size_m
            && self.regular_direction <= DIRECTION.0
            && self.direction_deg.to_radians() <= DIRECTION.1
            && self.axes_mm_or_deg <= axes * size_m
            && self.unsolved == self.off_centre
            && (numeric || self.branch_missed == 0);
    }
}

pub(super) fn file_units(machine: &Machine, q: &Joints) -> Vec<f64> {
    machine.axes.iter().zip(q).map(|(a, v)| a.to_file(*v)).collect()
}

/// Maximum difference of the axes in `of`, mm or degrees; with `turns`, whole turns count.
fn difference(machine: &Machine, of: &Task, a: &Joints, b: &Joints, turns: bool) -> f64 {
    let off = of.axes.iter().map(|&axis| {
        let d = a[axis] - b[axis];
        match machine.axes[axis].kind {
            AxisKind::Linear => d.abs(),
            AxisKind::Rotary if turns => d.abs().to_degrees(),
            AxisKind::Rotary => ((d + PI).rem_euclid(TAU) - PI).abs().to_degrees(),
        }
    });
    off.fold(0.0, f64::max)
}

/// Size of the machine, m, at least 1: the rounding of its positions is proportional to it.
fn size_m(machine: &Machine) -> f64 {
    let strokes = machine.axes.iter().filter(|a| a.kind == AxisKind::Linear).filter_map(|a| a.range);
    let far = strokes.map(|(low, high)| low.abs().max(high.abs())).fold(0.0, f64::max);
    let tip = machine.heads.iter().map(|h| h.chain.zero.point.length()).fold(0.0, f64::max);
    (1e-3 * far.max(tip)).max(1.0)
}

/// The first head alone: forward, inverse near the positions and from elsewhere, forward again.
pub(super) fn one_head(task: &Task, seed: u64, poses: u32, step: &mut dyn FnMut()) -> RoundTrip {
    let machine = task.machine;
    let numeric = machine.heads[0].is_numeric();
    let free = machine.heads[0].free();
    let mut random = Random::new(seed, 1);
    let mut found = RoundTrip { poses, ..RoundTrip::default() };
    for k in 0..poses {
        step();
        let (q, mut elsewhere) = (random.joints(machine), random.joints(machine));
        free.iter().for_each(|axis| elsewhere[axis] = q[axis]);
        let pose = machine.forward(&q);
        let regular = task.conditioning(&q) > NEAR_SINGULAR;
        found.near_singular += u32::from(!regular);
        match machine.inverse_near(pose, &q) {
            Ok(solution) => {
                found.compare(machine, &[pose], &q, &solution, regular);
                if regular {
                    found.axes_mm_or_deg =
                        found.axes_mm_or_deg.max(difference(machine, task, &solution.joints, &q, true));
                }
            }
            Err(_) => found.unsolved += 1,
        }
        if numeric && k % NUMERIC_STRIDE != 0 {
            continue;
        }
        let target = Target { across: Some(machine.across(&q)), ..Target::from(pose) };
        let Ok(branches) = machine.inverse(target, &elsewhere) else {
            found.branch_missed += u32::from(regular);
            continue;
        };
        for solution in branches.iter() {
            found.compare(machine, &[pose], &q, solution, regular && !solution.singular);
        }
        let own = branches.iter().any(|s| difference(machine, task, &s.joints, &q, false) < 1e-5);
        found.branch_missed += u32::from(regular && !own);
    }
    found.judge(numeric, size_m(machine));
    found
}

/// Both heads at once. With centred slides the positions must be recovered. Off centre they turn the pair relative to
/// its carrier, and some pairs of tips are unreachable; the others must be met exactly.
pub(super) fn pair(machine: &Machine, seed: u64, poses: u32, step: &mut dyn FnMut()) -> RoundTrip {
    let mut random = Random::new(seed, 2);
    let slides = machine.heads[0].slides.union(machine.heads[1].slides);
    let mut found = RoundTrip { poses, ..RoundTrip::default() };
    let everything = Task::new(machine);
    for k in 0..poses {
        step();
        let mut q = random.joints(machine);
        let centred = k % 2 == 0;
        if centred {
            slides.iter().for_each(|axis| q[axis] = 0.0);
        }
        let tips = [0, 1].map(|head| machine.forward_of(head, &q));
        let target = Target::new(tips[0], Some(tips[1]));
        let Ok(branches) = machine.inverse(target, &q) else {
            found.unsolved += 1;
            found.off_centre += u32::from(!centred);
            continue;
        };
        for solution in branches.iter() {
            found.near_singular += u32::from(solution.singular);
            found.compare(machine, &tips, &q, solution, !solution.singular);
        }
        if centred && branches.iter().all(|s| !s.singular) {
            let off = branches.iter().map(|s| difference(machine, &everything, &s.joints, &q, false));
            found.axes_mm_or_deg = found.axes_mm_or_deg.max(off.fold(f64::INFINITY, f64::min));
        }
    }
    // The frame between the tips is as long as their distance: with close tips a small error turns it far.
    let apart = (machine.heads[0].chain.zero.point - machine.heads[1].chain.zero.point).length().max(1e-3);
    let axes = found.axes_mm_or_deg;
    found.axes_mm_or_deg = 0.0;
    found.judge(false, size_m(machine));
    found.axes_mm_or_deg = axes;
    found.passed &= axes <= AXES.0 * size_m(machine) * (1e3 / apart).max(1.0);
    found
}
