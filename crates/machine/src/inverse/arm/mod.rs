//! Six- and seven-axis arms in closed form, recognised from the lines of their axes.
//!
//! Two structures, both with a second axis parallel to the third:
//!
//! - **Spherical wrist**: axes 4, 5 and 6 meet in a point (Pieper, 1968). The ortho-parallel arms of Brandstötter, Angerer
//!   and Hofbaur (2014) are among them; here axes may be at any angle and offset otherwise. The wrist's centre decides
//!   axes 1 to 3, the rest of the orientation axes 4 to 6.
//! - **Three parallel axes**: axis 4 is parallel to 2 and 3, axis 5 across it; 5 and 6 meet at right angles (Universal Robots).
//!   The point where they meet decides axis 1, the direction of the last axis 5 and 6, and a plane problem the rest.
//!
//! Seven-axis arms with spherical shoulder and wrist have a redundant axis more: see `seven`.
//!
//! An arm reaches a whole frame, a torch's pose is a point with a direction: the rotation about the torch is free. A
//! [`Target`](crate::Target) gives it, or it stays as near as possible to that of the current positions. External axes
//! between work and arm (rail, positioner) keep their positions.
//!
//! Lines count as parallel below a sine of 1e-9, and as meeting below 1e-6 mm: positions are exact to rounding without
//! iteration. Other arms are solved by Newton's method.

mod configuration;
mod seven;
mod two_links;
mod wrist;

use super::branches::{Branches, Query, Unreachable};
use super::rotaries;
use crate::axis::AxisKind;
use crate::chain::{AxisSet, Chain, Joints, Screw, Turn};
use crate::roll::carried;
use arrayvec::ArrayVec;
use configuration::turns;
pub use configuration::{ArmConfiguration, ArmMargins, Elbow, Shoulder, WristSide};
use glam::{DAffine3, DMat3, DVec2, DVec3};
pub(crate) use seven::SevenAxisArm;
use two_links::{LinkTurns, TwoLinks};
use wrist::{ALIGNED, Wrist};

const AXES: usize = 6;
/// Sine below which axes are parallel, and cosine below which they are perpendicular.
const PARALLEL: f64 = 1e-9;
/// Distance below which axes meet, mm.
const MEET_MM: f64 = 1e-6;
/// Distance of the wrist from its place on the first axis below which that axis is free, mm.
const ON_AXIS_MM: f64 = 1e-9;

/// A six-axis arm with a closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Arm {
    /// Number of screws between work and arm.
    first: usize,
    axes: [usize; AXES],
    /// A point and the direction of the first axis, and the direction of the second.
    base: DVec3,
    upright: DVec3,
    normal: DVec3,
    /// Horizontal direction in which the centre lies with all axes at zero.
    forward: DVec3,
    /// The point that the shoulder moves: the wrist's centre, or the meeting point of the last two axes.
    centre: DVec3,
    links: TwoLinks,
    /// 1 or -1: sense of the third axis relative to the second.
    third: f64,
    tail: Tail,
}

#[derive(Debug, Clone, PartialEq)]
enum Tail {
    Wrist(Wrist),
    Parallel(ParallelTail),
}

/// The axes after two of three parallel ones.
#[derive(Debug, Clone, PartialEq)]
struct ParallelTail {
    /// 1 or -1: sense of the fourth axis relative to the second.
    fourth: f64,
    /// From the centre to the fourth axis.
    offset: DVec3,
    fifth: DVec3,
    sixth: DVec3,
}

/// Turns of axes with the arm's first axis undone.
struct Shoulders {
    turn: Turn,
    is_free: bool,
    rotation: DMat3,
    centre: DVec3,
}

impl Arm {
    /// The arm at the torch's end of `chain`; none if its axes have another structure.
    pub(crate) fn new(chain: &Chain) -> Option<Self> {
        let first = chain.screws.len().checked_sub(AXES)?;
        let s: &[Screw; AXES] = chain.screws[first..].try_into().ok()?;
        let [s1, s2, s3, s4, s5, s6] = s;
        let is_parallel = |a: &Screw, b: &Screw| a.direction.cross(b.direction).length() < PARALLEL;
        if s.iter().any(|s| s.kind != AxisKind::Rotary) || !is_parallel(s2, s3) || !super::vectors::independent(s1, s2)
        {
            return None;
        }
        let normal = s2.direction;
        let sense = |s: &Screw| s.direction.dot(normal).signum();
        let centre = meeting(s5, s6)?;
        let (tail, end) = if is_parallel(s3, s4) {
            let square = |a: &Screw, b: &Screw| a.direction.dot(b.direction).abs() < PARALLEL;
            if !square(s4, s5) || !square(s5, s6) {
                return None;
            }
            let (fifth, sixth) = (s5.direction, s6.direction);
            (Tail::Parallel(ParallelTail { fourth: sense(s4), offset: s4.at - centre, fifth, sixth }), s4.at)
        } else {
            let off = (centre - s4.at).cross(s4.direction).length();
            let wrist = Wrist::new([s4.direction, s5.direction, s6.direction])?;
            (off < MEET_MM).then_some((Tail::Wrist(wrist), centre))?
        };
        let across = normal.cross(s1.direction).normalize();
        let forward = if across.dot(centre - s1.at) < -MEET_MM { -across } else { across };
        let links = links(s2, s3, end, forward)?;
        Some(Self {
            first,
            axes: s.map(|s| s.axis),
            base: s1.at,
            upright: s1.direction,
            normal,
            forward,
            centre,
            links,
            third: sense(s3),
            tail,
        })
    }

    /// The arm's axes.
    pub(crate) fn axes(&self) -> AxisSet {
        self.axes.iter().copied().collect()
    }

    /// Code of the structure's name.
    pub(crate) fn method(&self) -> &'static str {
        match self.tail {
            Tail::Wrist(_) => "machine-method-spherical-wrist",
            Tail::Parallel(_) => "machine-method-three-parallel",
        }
    }

    /// Adds all branches; the axes of the chain before the arm are as in `near`.
    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let near = query.near;
        let goal = goal(self.first, query);
        let mut nearest = None;
        let mut miss = |reason: Unreachable| {
            if nearest.as_ref().is_none_or(|n: &Unreachable| reason.by() < n.by()) {
                nearest = Some(reason);
            }
        };
        let shoulders = self.shoulders(&goal, near);
        if let Err(by) = shoulders {
            miss(Unreachable::Point { by });
        }
        for shoulder in shoulders.into_iter().flatten() {
            let solved = match &self.tail {
                Tail::Wrist(wrist) => self.with_wrist(wrist, &shoulder, near, branches),
                Tail::Parallel(tail) => self.with_parallel(tail, &shoulder, near, branches),
            };
            if let Err(reason) = solved {
                miss(reason);
            }
        }
        branches.any(nearest)
    }

    /// Turns of the first axis that bring the centre to the distance from the plane of the links that these keep, or
    /// the distance (mm) that is missing.
    fn shoulders(&self, goal: &DAffine3, near: &Joints) -> Result<ArrayVec<Shoulders, 2>, f64> {
        let (n, w) = (self.normal, self.upright);
        let u = goal.transform_point3(self.centre) - self.base;
        // n . R(-q) u = k: A cos q + B sin q = C.
        let a = n.dot(u) - n.dot(w) * w.dot(u);
        let b = -n.dot(w.cross(u));
        let c = n.dot(self.centre - self.base) - n.dot(w) * w.dot(u);
        let reach = a.hypot(b);
        if reach < c.abs() * (1.0 - 1e-12) - ON_AXIS_MM {
            return Err(c.abs() - reach);
        }
        let at = |turn: Turn, is_free| {
            let undo = turn.back().matrix(w);
            Shoulders { turn, is_free, rotation: undo * goal.matrix3, centre: self.base + undo * u }
        };
        let mut found = ArrayVec::new();
        if reach < ON_AXIS_MM {
            found.push(at(Turn::by(near[self.axes[0]]), true));
            return Ok(found);
        }
        let middle = Turn::along(b, a);
        let sine = ((reach - c) * (reach + c)).max(0.0).sqrt();
        let half = Turn::along(sine, c);
        found.push(at(middle.and(half), false));
        if sine > ON_AXIS_MM {
            found.push(at(middle.and(half.back()), false));
        }
        Ok(found)
    }

    fn with_wrist(
        &self,
        wrist: &Wrist,
        shoulder: &Shoulders,
        near: &Joints,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        let target = self.links.coordinates(shoulder.centre);
        let turns = self.links.solve(target).map_err(|by| Unreachable::Point { by })?;
        for LinkTurns { first, second, stretched } in turns {
            let is_free = first.is_none();
            let first = first.unwrap_or_else(|| Turn::by(near[self.axes[1]]));
            let rotation = first.and(second).back().matrix(self.normal) * shoulder.rotation;
            let angles = [
                if shoulder.is_free { near[self.axes[0]] } else { shoulder.turn.angle() },
                if is_free { near[self.axes[1]] } else { first.angle() },
                self.third * second.angle(),
            ];
            for solved in wrist.solve(&rotation, near[self.axes[3]]) {
                let [q1, q2, q3] = angles;
                let [q4, q5, q6] = solved.angles;
                let singular = shoulder.is_free || is_free || stretched || solved.aligned;
                self.add([q1, q2, q3, q4, q5, q6], singular, branches);
            }
        }
        Ok(())
    }

    fn with_parallel(
        &self,
        tail: &ParallelTail,
        shoulder: &Shoulders,
        near: &Joints,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        let n = self.normal;
        let first = if shoulder.is_free { near[self.axes[0]] } else { shoulder.turn.angle() };
        // The fifth axis turns the sixth to its angle from the parallel axes.
        let sixth = shoulder.rotation * tail.sixth;
        let (sine, cosine) = (n.cross(sixth).length(), n.dot(sixth));
        let aligned = sine < ALIGNED;
        let straight = tail.straight(n);
        let bends = if aligned { [Some(0.0), None] } else { [Some(sine), Some(-sine)] };
        let mut missed = None;
        for bend in bends.into_iter().flatten() {
            let fifth = straight.and(Turn::along(bend, cosine));
            let wanted = shoulder.rotation.transpose() * n;
            let last = if aligned { None } else { rotaries::one(tail.sixth, fifth.back().of(tail.fifth, n), wanted) };
            let last = last.map_or_else(|| Turn::by(near[self.axes[5]]), Turn::back);
            let turned = shoulder.rotation * last.back().of(tail.sixth, tail.fifth);
            let Some(sum) = rotaries::one(n, tail.fifth, turned) else { continue };
            let target = self.links.coordinates(shoulder.centre + sum.of(n, tail.offset));
            let turns = match self.links.solve(target) {
                Ok(turns) => turns,
                Err(by) => {
                    missed = Some(Unreachable::Point { by });
                    continue;
                }
            };
            let (q5, q6) = (fifth.angle(), if aligned { near[self.axes[5]] } else { last.angle() });
            for LinkTurns { first: second, second: third, stretched } in turns {
                let is_free = second.is_none();
                let second = second.unwrap_or_else(|| Turn::by(near[self.axes[1]]));
                let fourth = sum.and(second.and(third).back());
                let q2 = if is_free { near[self.axes[1]] } else { second.angle() };
                let joints = [first, q2, self.third * third.angle(), tail.fourth * fourth.angle(), q5, q6];
                self.add(joints, shoulder.is_free || is_free || stretched || aligned, branches);
            }
        }
        missed.map_or(Ok(()), Err)
    }

    fn add(&self, angles: [f64; AXES], singular: bool, branches: &mut Branches) {
        let solution = branches.add();
        solution.singular = singular;
        self.axes.iter().zip(angles).for_each(|(axis, angle)| solution.joints[*axis] = angle);
    }

    /// The centre in the plane of the links, with the first axis at zero, at positions `q`.
    fn centre_at(&self, q: &Joints) -> DVec3 {
        let [second, third] = [(1, 1.0), (2, self.third)].map(|(i, sense)| Turn::by(sense * q[self.axes[i]]));
        let mut sum = second.and(third);
        let folded = second.of_plane(self.links.folded(third));
        let mut centre = self.links.origin + folded.x * self.links.x + folded.y * self.links.y;
        // The links keep the distance along their axes.
        centre += self.normal.dot(self.centre - self.links.origin) * self.normal;
        if let Tail::Parallel(tail) = &self.tail {
            sum = sum.and(Turn::by(tail.fourth * q[self.axes[3]]));
            let offset = tail.offset - self.normal.dot(tail.offset) * self.normal;
            centre -= sum.of(self.normal, offset);
        }
        centre
    }
}

impl ParallelTail {
    /// The turn of the fifth axis that aligns the sixth with the parallel axes.
    fn straight(&self, normal: DVec3) -> Turn {
        Turn::along(normal.dot(self.fifth.cross(self.sixth)), normal.dot(self.sixth))
    }
}

/// Displacement of the flange from zero that reaches the target, with the `first` axes before the arm
/// undone.
fn goal(first: usize, Query { chain, pose, near, across, .. }: Query) -> DAffine3 {
    let zero = &chain.zero;
    let across = across.unwrap_or_else(|| {
        let (here, across) = chain.frame(near);
        carried(here.direction, pose.direction, across)
    });
    let across = (across - across.dot(pose.direction) * pose.direction).normalize();
    let from = frame(zero.direction, chain.across);
    let matrix3 = frame(pose.direction, across) * from.transpose();
    let goal = DAffine3 { matrix3, translation: pose.point - matrix3 * zero.point };
    if first == 0 {
        return goal;
    }
    let carried = chain.screws[..first]
        .iter()
        .fold(DAffine3::IDENTITY, |moved, screw| moved * screw.displacement(near[screw.axis]));
    let back = carried.matrix3.transpose();
    DAffine3 { matrix3: back * goal.matrix3, translation: back * (goal.translation - carried.translation) }
}

/// The point where two axes meet; none if they are parallel or pass each other.
fn meeting(a: &Screw, b: &Screw) -> Option<DVec3> {
    let across = a.direction.cross(b.direction);
    if !super::vectors::independent(a, b) {
        return None;
    }
    let between = b.at - a.at;
    let along = between.cross(b.direction).dot(across) / across.length_squared();
    let apart = between.dot(across).abs() / across.length();
    (apart < MEET_MM).then_some(a.at + along * a.direction)
}

/// The links from the second axis over the third to `end`; none if two of these coincide.
fn links(second: &Screw, third: &Screw, end: DVec3, forward: DVec3) -> Option<TwoLinks> {
    let normal = second.direction;
    let (x, y) = (forward, normal.cross(forward));
    let plane = |v: DVec3| DVec2::new(v.dot(x), v.dot(y));
    let (first, last) = (plane(third.at - second.at), plane(end - third.at));
    let is_flat = first.length() < MEET_MM || last.length() < MEET_MM;
    (!is_flat).then_some(TwoLinks { origin: second.at, x, y, first, second: last })
}

/// Directions of a torch's frame as columns.
fn frame(direction: DVec3, across: DVec3) -> DMat3 {
    DMat3::from_cols(across, direction.cross(across), direction)
}
