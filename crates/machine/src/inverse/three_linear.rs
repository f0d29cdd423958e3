use super::branches::{Branches, Query, Unreachable, Which};
use super::rotaries::{self, Pair};
use crate::chain::{Chain, Joints, MAX_AXES, Screw, Turn, Turns};
use glam::DVec3;
use seamwright_geometry::angle_between;

/// Three linear axes and up to two rotary ones, in any order and on either side: the rotary axes follow from the
/// direction, then the linear ones from a 3 x 3 system.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ThreeLinear {
    /// Indices into the chain's screws.
    linear: [usize; 3],
    rotary: Vec<usize>,
}

impl ThreeLinear {
    pub(crate) fn new(chain: &Chain, linear: [usize; 3], rotary: &[usize]) -> Option<Self> {
        if let &[a, b] = rotary
            && !crate::inverse::vectors::independent(&chain.screws[a], &chain.screws[b])
        {
            return None;
        }
        Some(Self { linear, rotary: rotary.to_vec() })
    }

    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let Query { chain, pose, near, which, .. } = query;
        let zero = chain.zero.direction;
        let axis = |i: usize| chain.screws[self.rotary[i]].direction;
        let pairs: [Option<Pair>; 2] = match self.rotary.len() {
            0 => [Some((None, None)), None],
            1 => [Some((rotaries::one(axis(0), zero, pose.direction), None)), None],
            _ => rotaries::two(axis(0), axis(1), zero, pose.direction)
                .map_err(|by| Unreachable::Direction { by })?
                .map(Some),
        };
        let pairs = match (which, pairs) {
            (Which::Nearest, [Some(p), Some(q)]) => [Some(self.nearer(chain, near, p, q)), None],
            _ => pairs,
        };
        let exact = self.rotary.len() == 2;
        let mut flat = None;
        for (first, second) in pairs.into_iter().flatten() {
            let mut turns = [Turn::NONE; MAX_AXES];
            let solution = branches.add();
            for (&screw, turn) in self.rotary.iter().zip([first, second]) {
                let at = chain.screws[screw].axis;
                turns[at] = turn.unwrap_or_else(|| Turn::by(near[at]));
                solution.joints[at] = turn.map_or(near[at], Turn::angle);
                solution.singular |= turn.is_none();
            }
            match self.solve_linear(query, &turns, &mut solution.joints) {
                Ok(reached) if !exact => solution.attitude_error = angle_between(reached, pose.direction),
                Ok(_) => {}
                Err(reason) => {
                    branches.take_back();
                    flat = Some(reason);
                }
            }
        }
        branches.any(flat)
    }

    /// The pair of turns nearer to `near`, by the chords of the angle differences.
    fn nearer(&self, chain: &Chain, near: &Joints, p: Pair, q: Pair) -> Pair {
        let here = [0, 1].map(|i| Turn::by(near[chain.screws[self.rotary[i]].axis]));
        let closeness = |pair: Pair| {
            let closeness = |turn: Option<Turn>, here| turn.map_or(1.0, |t| t.cosine_to(here));
            closeness(pair.0, here[0]) + closeness(pair.1, here[1])
        };
        if closeness(p) >= closeness(q) { p } else { q }
    }

    /// Sets the linear positions that put the tip on its point at the rotary axes' turns; returns the torch's direction
    /// there.
    fn solve_linear(&self, query: Query, turns: &Turns, joints: &mut Joints) -> Result<DVec3, Unreachable> {
        let Query { chain, pose, .. } = query;
        // The linear axes are still at zero in `joints`.
        let at_zero = chain.forward_turned(joints, turns);
        move_linear(&chain.screws, self.linear, &self.rotary, turns, pose.point - at_zero.point, joints)?;
        Ok(at_zero.direction)
    }
}

/// Sets the positions of three linear axes so that the tip moves by `shift`. It starts with them at zero and the rotary
/// axes at their turns. Each linear axis is turned by the rotary axes between it and the work.
pub(crate) fn move_linear(
    screws: &[Screw],
    linear: [usize; 3],
    rotary: &[usize],
    turns: &Turns,
    shift: DVec3,
    joints: &mut Joints,
) -> Result<(), Unreachable> {
    let [a, b, c] = linear.map(|l| {
        rotary
            .iter()
            .rev()
            .filter(|&&r| r < l)
            .fold(screws[l].direction, |v, &r| turns[screws[r].axis].of(screws[r].direction, v))
    });
    let volume = a.cross(b).dot(c);
    if volume.abs() < 1e-6 {
        return Err(Unreachable::Flat);
    }
    // Cramer's rule.
    let rest = shift / volume;
    let values = [rest.dot(b.cross(c)), rest.dot(c.cross(a)), rest.dot(a.cross(b))];
    for (l, value) in linear.into_iter().zip(values) {
        joints[screws[l].axis] = value;
    }
    Ok(())
}
