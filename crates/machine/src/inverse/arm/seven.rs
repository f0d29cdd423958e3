//! Seven-axis arms with a spherical shoulder and a spherical wrist, by the arm angle or with a given third axis.
//!
//! Axes 1 to 3 meet in the shoulder S, axes 5 to 7 in the wrist W; axis 4 is the elbow. The distance of W from S decides
//! axis 4. The rest of the shoulder's rotation is free: the elbow swivels about the line from S to W (Kreutz-Delgado, Long
//! and Seraji, Kinematic analysis of 7-DOF manipulators, 1992; Shimizu et al., Analytical inverse kinematic computation for
//! 7-DOF redundant manipulators, 2008). Either the arm angle gives it: the angle of the elbow about that line, from the
//! half plane on which the first axis points. Or the third axis keeps its position, as the redundant axis of the planner.

use super::wrist::{ALIGNED, Wrist};
use super::{ArmConfiguration, ArmMargins, Elbow, MEET_MM, Shoulder, WristSide, goal, meeting, turns};
use crate::axis::AxisKind;
use crate::chain::{AxisSet, Chain, Joints, Screw, Turn};
use crate::inverse::branches::{Branches, Query, Unreachable};
use crate::inverse::rotaries;
use arrayvec::ArrayVec;
use glam::{DMat3, DVec3};

const AXES: usize = 7;
/// The redundant axis among the seven.
const THIRD: usize = 2;
/// Sine of the elbow's angle below which both elbows are one: it is the root of a difference, so that rounding alone makes
/// it 1e-8. The distance of the wrist changes by less than 1e-14 of itself.
const STRETCHED: f64 = 1e-7;

/// A seven-axis arm with a closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SevenAxisArm {
    /// Number of screws between work and arm.
    first: usize,
    axes: [usize; AXES],
    directions: [DVec3; AXES],
    /// The points where three axes meet, with all axes at zero.
    shoulder_at: DVec3,
    wrist_at: DVec3,
    /// From the shoulder to the point of the elbow's axis next to it, and from there to the wrist.
    upper: DVec3,
    fore: DVec3,
    /// 1 or -1: sign of the elbow's angle that puts the elbow above, with the third axis at zero and the wrist in front.
    up: f64,
    shoulder: Wrist,
    wrist: Wrist,
}

/// A position of the elbow.
struct ElbowTurn {
    turn: Turn,
    stretched: bool,
}

/// Positions of the first three axes.
struct ShoulderTurns {
    angles: [f64; 3],
    rotation: DMat3,
    singular: bool,
}

impl SevenAxisArm {
    /// The arm at the torch's end of `chain`; none if its axes have another structure.
    pub(crate) fn new(chain: &Chain) -> Option<Self> {
        let first = chain.screws.len().checked_sub(AXES)?;
        let s: &[Screw; AXES] = chain.screws[first..].try_into().ok()?;
        if s.iter().any(|s| s.kind != AxisKind::Rotary) {
            return None;
        }
        let passes = |s: &Screw, at: DVec3| (at - s.at).cross(s.direction).length() < MEET_MM;
        let shoulder_at = meeting(&s[0], &s[1]).filter(|at| passes(&s[2], *at))?;
        let wrist_at = meeting(&s[5], &s[6]).filter(|at| passes(&s[4], *at))?;
        let elbow = &s[3];
        let elbow_at = elbow.at + (shoulder_at - elbow.at).dot(elbow.direction) * elbow.direction;
        let (upper, fore) = (elbow_at - shoulder_at, wrist_at - elbow_at);
        let across = fore - fore.dot(elbow.direction) * elbow.direction;
        if upper.length() < MEET_MM || across.length() < MEET_MM {
            return None;
        }
        let directions = s.each_ref().map(|s| s.direction);
        let [a, b, c, _, e, f, g] = directions;
        let (shoulder, wrist) = (Wrist::new([a, b, c])?, Wrist::new([e, f, g])?);
        let axes = s.each_ref().map(|s| s.axis);
        let up = elbow.direction.cross(fore).dot(b.cross(a)).signum();
        Some(Self { first, axes, directions, shoulder_at, wrist_at, upper, fore, up, shoulder, wrist })
    }

    /// The axes that a frame decides: all but the third.
    pub(crate) fn decided(&self) -> AxisSet {
        self.axes.iter().enumerate().filter(|(i, _)| *i != THIRD).map(|(_, axis)| *axis).collect()
    }

    /// The redundant axis.
    pub(crate) fn third(&self) -> usize {
        self.axes[THIRD]
    }

    /// Adds all branches at the arm angle of the query, or with the third axis as in `near`.
    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let near = query.near;
        let goal = goal(self.first, query);
        let line = goal.transform_point3(self.wrist_at) - self.shoulder_at;
        let mut missed = None;
        for elbow in self.elbows(line.length()).map_err(|by| Unreachable::Point { by })? {
            let shoulders = match query.arm_angle {
                Some(angle) => self.at_arm_angle(&elbow, line, angle, near),
                None => self.at_third_axis(&elbow, line, near),
            };
            match shoulders {
                Ok(shoulders) => {
                    shoulders.iter().for_each(|s| self.add_wrists(s, &elbow, &goal.matrix3, near, branches));
                }
                Err(by) => missed = Some(Unreachable::Point { by }),
            }
        }
        branches.any(missed)
    }

    /// Turns of the elbow that bring the wrist to this distance from the shoulder, or the distance (mm) that is missing.
    fn elbows(&self, distance: f64) -> Result<ArrayVec<ElbowTurn, 2>, f64> {
        // |upper + R fore|^2 = distance^2: A cos q + B sin q = C.
        let axis = self.directions[3];
        let along = axis.dot(self.fore);
        let (a, b) = (self.upper.dot(self.fore - along * axis), self.upper.dot(axis.cross(self.fore)));
        let squares = self.upper.length_squared() + self.fore.length_squared();
        let fixed = axis.dot(self.upper) * along;
        let c = 0.5 * (distance * distance - squares) - fixed;
        let reach = a.hypot(b);
        if c.abs() > reach * (1.0 + 1e-12) {
            let limit = (squares + 2.0 * (fixed + reach.copysign(c))).max(0.0).sqrt();
            return Err((distance - limit).abs());
        }
        let sine = ((reach - c) * (reach + c)).max(0.0).sqrt();
        let stretched = sine < STRETCHED * reach;
        let half = if stretched { Turn::along(0.0, c.signum()) } else { Turn::along(sine, c) };
        let in_line = Turn::along(b, a);
        let mut found = ArrayVec::new();
        found.push(ElbowTurn { turn: in_line.and(half), stretched });
        if !stretched {
            found.push(ElbowTurn { turn: in_line.and(half.back()), stretched });
        }
        Ok(found)
    }

    /// From the shoulder to the wrist with the first three axes at zero.
    fn reached(&self, elbow: Turn) -> DVec3 {
        self.upper + elbow.of(self.directions[3], self.fore)
    }

    /// Turns of the first two axes with the third as in `near`, or the distance (mm) by which the wrist misses.
    fn at_third_axis(&self, elbow: &ElbowTurn, line: DVec3, near: &Joints) -> Result<ArrayVec<ShoulderTurns, 2>, f64> {
        let [d1, d2, d3, ..] = self.directions;
        let third = near[self.axes[THIRD]];
        let turned = Turn::by(third).of(d3, self.reached(elbow.turn));
        let (Some(from), Some(to)) = (turned.try_normalize(), line.try_normalize()) else { return Err(line.length()) };
        let pairs = rotaries::two(d1, d2, from, to).map_err(|angle| line.length() * angle)?;
        let with = |(q1, q2): rotaries::Pair| {
            let singular = q1.is_none() || q2.is_none();
            let [q1, q2] = [(q1, 0), (q2, 1)].map(|(turn, i)| turn.map_or(near[self.axes[i]], Turn::angle));
            let rotation = self.shoulder_rotation([q1, q2, third]);
            ShoulderTurns { angles: [q1, q2, third], rotation, singular }
        };
        Ok(pairs.map(with).into_iter().collect())
    }

    fn shoulder_rotation(&self, [q1, q2, q3]: [f64; 3]) -> DMat3 {
        let [d1, d2, d3, ..] = self.directions;
        Turn::by(q1).matrix(d1) * Turn::by(q2).matrix(d2) * Turn::by(q3).matrix(d3)
    }

    /// Turns of the first three axes that put the elbow at this angle about the line to the wrist.
    fn at_arm_angle(
        &self,
        elbow: &ElbowTurn,
        line: DVec3,
        angle: f64,
        near: &Joints,
    ) -> Result<ArrayVec<ShoulderTurns, 2>, f64> {
        let here = self.reached(elbow.turn);
        let (Some(from), Some(to)) = (here.try_normalize(), line.try_normalize()) else { return Err(line.length()) };
        let wanted = Turn::by(angle).of(to, self.upright(to));
        let rotation = framed(to, wanted) * framed(from, self.sideways(from)).transpose();
        let solved = self.shoulder.solve(&rotation, near[self.axes[0]]);
        let with = |s: &super::wrist::WristAngles| ShoulderTurns {
            angles: s.angles,
            rotation,
            singular: s.aligned || elbow.stretched,
        };
        Ok(solved.iter().map(with).collect())
    }

    /// Unit direction across the line `to` on the side to which the first axis points.
    fn upright(&self, to: DVec3) -> DVec3 {
        let up = self.directions[0];
        // On the first axis no side is its own: any fixed one serves.
        across(up, to, ALIGNED).unwrap_or_else(|| to.any_orthonormal_vector())
    }

    /// Unit direction of the elbow across the line to the wrist, with the first three axes at zero.
    fn sideways(&self, line: DVec3) -> DVec3 {
        // A stretched arm has no elbow: the plane of its bending takes its place.
        let elbow = across(self.upper.normalize_or_zero(), line, STRETCHED);
        let plane = || across(self.directions[3].cross(line), line, STRETCHED);
        elbow.or_else(plane).unwrap_or_else(|| line.any_orthonormal_vector())
    }

    fn add_wrists(
        &self,
        shoulder: &ShoulderTurns,
        elbow: &ElbowTurn,
        goal: &DMat3,
        near: &Joints,
        branches: &mut Branches,
    ) {
        let carried = shoulder.rotation * elbow.turn.matrix(self.directions[3]);
        for solved in self.wrist.solve(&(carried.transpose() * *goal), near[self.axes[4]]) {
            let [q1, q2, q3] = shoulder.angles;
            let [q5, q6, q7] = solved.angles;
            let solution = branches.add();
            solution.singular = shoulder.singular || elbow.stretched || solved.aligned;
            let joints = [q1, q2, q3, elbow.turn.angle(), q5, q6, q7];
            self.axes.iter().zip(joints).for_each(|(axis, angle)| solution.joints[*axis] = angle);
        }
    }

    /// Rotation of the shoulder and direction to the wrist at positions `q`.
    fn shoulder_at(&self, q: &Joints) -> (DMat3, DVec3) {
        let rotation = self.shoulder_rotation([0, 1, 2].map(|i| q[self.axes[i]]));
        let line = rotation * self.reached(Turn::by(q[self.axes[3]]));
        (rotation, line.normalize_or(self.directions[0]))
    }

    /// Arm angle at positions `q`, rad.
    pub(crate) fn arm_angle(&self, q: &Joints) -> f64 {
        let (rotation, line) = self.shoulder_at(q);
        let elbow = rotation * self.sideways(rotation.transpose() * line);
        let upright = self.upright(line);
        line.dot(upright.cross(elbow)).atan2(upright.dot(elbow))
    }

    /// Signed distances from the singularities of shoulder, elbow and wrist, the shoulder's with the third axis held.
    fn signed(&self, q: &Joints) -> [f64; 3] {
        let (_, line) = self.shoulder_at(q);
        let [d1, d2, ..] = self.directions;
        let second = Turn::by(q[self.axes[0]]).of(d1, d2);
        let axis = self.directions[3];
        let in_line = Turn::along(self.upper.dot(axis.cross(self.fore)), self.upper.dot(self.fore));
        let elbow = Turn::by(q[self.axes[3]]).and(in_line.back());
        [second.cross(d1).dot(line), self.up * elbow.sin(), self.wrist.bend(q[self.axes[5]]).sin()]
    }

    /// Configuration at positions `q`; the turns are those of all axes but the third.
    pub(crate) fn configuration(&self, q: &Joints) -> ArmConfiguration {
        let [shoulder, elbow, wrist] = self.signed(q);
        let [a, b, _, d, e, f, g] = self.axes;
        ArmConfiguration {
            shoulder: if shoulder >= 0.0 { Shoulder::Front } else { Shoulder::Back },
            elbow: if elbow >= 0.0 { Elbow::Up } else { Elbow::Down },
            wrist: if wrist >= 0.0 { WristSide::NoFlip } else { WristSide::Flip },
            turns: [a, b, d, e, f, g].map(|axis| turns(q[axis])),
        }
    }

    /// Distances from the singularities at positions `q`.
    pub(crate) fn margins(&self, q: &Joints) -> ArmMargins {
        let [shoulder, elbow, wrist] = self.signed(q).map(f64::abs);
        let distance = self.reached(Turn::by(q[self.axes[3]])).length();
        ArmMargins { shoulder_mm: distance * shoulder, shoulder, elbow, wrist }
    }
}

/// Unit direction of the part of `v` across the unit vector `line`; none if that is at most `min` long.
fn across(v: DVec3, line: DVec3, min: f64) -> Option<DVec3> {
    let across = v - v.dot(line) * line;
    let unit = across.try_normalize().filter(|_| across.length() > min)?;
    // Of a short part rounding lies along the line: once more.
    (unit - unit.dot(line) * line).try_normalize()
}

/// A frame with x along the unit vector `x` and y along the unit vector `y` across it.
fn framed(x: DVec3, y: DVec3) -> DMat3 {
    DMat3::from_cols(x, y, x.cross(y))
}
