use super::branches::{Branches, Query, Solution, Unreachable, Which};
use super::rotaries;
use super::vectors::in_plane;
use crate::chain::{Chain, MAX_AXES, Turn};
use seamwright_geometry::angle_between;

/// Two linear axes, with or without a tilt across their plane, on a rotary axis next to the work (SADDLE-2020).
///
/// The tip moves in a plane that turns with the rotary axis. The point decides the rotary axis (the plane passes
/// through it). The direction decides the tilt as closely as possible, and the linear axes follow. Four axes cannot
/// reach every direction: the solution's attitude error is the rest.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PlaneOnRotary {
    rotary: usize,
    linear: [usize; 2],
    tilt: Option<usize>,
}

impl PlaneOnRotary {
    pub(crate) fn new(chain: &Chain, linear: [usize; 2], rotary: &[usize]) -> Option<Self> {
        let (&first, rest) = rotary.split_first()?;
        let [a, b] = linear.map(|l| &chain.screws[l]);
        if first > linear[0] || rest.len() > 1 || !crate::inverse::vectors::independent(a, b) {
            return None;
        }
        let normal = a.direction.cross(b.direction).normalize();
        let tilt = rest.first().copied();
        let across = tilt.is_none_or(|t| chain.screws[t].direction.cross(normal).length() < 1e-9);
        let turns_the_plane = chain.screws[first].direction.cross(normal).length() > 1e-6;
        (first == 0 && across && turns_the_plane).then_some(Self { rotary: first, linear, tilt })
    }

    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let Query { chain, pose, near, which, .. } = query;
        let turn = &chain.screws[self.rotary];
        let [x, y] = self.linear.map(|l| chain.screws[l].direction);
        let n = x.cross(y).normalize();
        // n . R(-q) u = k, with u the point and k the plane's height over the axis: A cos q + B sin q = C.
        let u = pose.point - turn.at;
        let w = turn.direction;
        let a = n.dot(u) - n.dot(w) * w.dot(u);
        let b = -n.dot(w.cross(u));
        let c = n.dot(chain.zero.point - turn.at) - n.dot(w) * w.dot(u);
        let reach = a.hypot(b);
        if reach < c.abs() * (1.0 - 1e-12) {
            return Err(Unreachable::Point { by: c.abs() - reach });
        }
        let singular = reach < 1e-9;
        let here = Turn::by(near[turn.axis]);
        let turns = if singular {
            [here; 2]
        } else {
            let middle = Turn::along(b, a);
            let half = Turn::along(((reach - c) * (reach + c)).max(0.0).sqrt(), c);
            [middle.and(half), middle.and(half.back())]
        };
        let second_is_nearer = turns[1].cosine_to(here) > turns[0].cosine_to(here);
        let turns = match which {
            Which::Nearest if second_is_nearer => &turns[1..],
            Which::Nearest => &turns[..1],
            Which::All | Which::From(_) => &turns[..],
        };
        let mut flat = None;
        for &about in turns {
            let solution = branches.add();
            if let Err(reason) = self.in_plane(query, about, solution) {
                branches.take_back();
                flat = Some(reason);
                continue;
            }
            solution.joints[turn.axis] = if singular { near[turn.axis] } else { about.angle() };
            solution.singular |= singular;
        }
        branches.any(flat)
    }

    /// Solves with the rotary axis turned by `about`; the caller sets the rotary axis' own position.
    fn in_plane(&self, query: Query, about: Turn, solution: &mut Solution) -> Result<(), Unreachable> {
        let Query { chain, pose, near, .. } = query;
        let rotary = &chain.screws[self.rotary];
        let joints = &mut solution.joints;
        let mut turns = [Turn::NONE; MAX_AXES];
        let wanted = about.back().of(rotary.direction, pose.direction);
        if let Some(tilt) = self.tilt.map(|t| &chain.screws[t]) {
            let turn = rotaries::one(tilt.direction, chain.zero.direction, wanted);
            joints[tilt.axis] = turn.map_or(near[tilt.axis], Turn::angle);
            turns[tilt.axis] = turn.unwrap_or_else(|| Turn::by(near[tilt.axis]));
            solution.singular = turn.is_none();
        }
        // With the rotary axis at zero the tip is in the plane at zero.
        let target = rotary.turn_point(about.back(), pose.point);
        let [x, y] = self.linear.map(|l| {
            let screw = &chain.screws[l];
            match self.tilt.map(|t| (t, &chain.screws[t])) {
                Some((t, tilt)) if t < l => turns[tilt.axis].of(tilt.direction, screw.direction),
                _ => screw.direction,
            }
        });
        // A tilt between the two linear axes may have made them parallel.
        if x.cross(y).length_squared() < 1e-12 {
            return Err(Unreachable::Flat);
        }
        let at_zero = chain.forward_turned(joints, &turns);
        let (first, second, _) = in_plane(x, y, target - at_zero.point);
        joints[chain.screws[self.linear[0]].axis] = first;
        joints[chain.screws[self.linear[1]].axis] = second;
        solution.attitude_error = angle_between(at_zero.direction, wanted);
        Ok(())
    }
}
