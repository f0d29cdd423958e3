use super::rotaries::{self, Pair};
use super::{Branches, Solution, Unreachable, angle_between};
use crate::chain::{Chain, Joints};
use glam::{DMat3, DVec3};
use seamwright_geometry::Pose;

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
            && !super::independent(&chain.screws[a], &chain.screws[b])
        {
            return None;
        }
        Some(Self { linear, rotary: rotary.to_vec() })
    }

    pub(crate) fn solve(&self, chain: &Chain, pose: &Pose, near: &Joints) -> Result<Branches, Unreachable> {
        let zero = chain.zero.direction;
        let axis = |i: usize| chain.screws[self.rotary[i]].direction;
        let pairs: [Option<Pair>; 2] = match self.rotary.len() {
            0 => [Some((None, None)), None],
            1 => [Some((rotaries::one(axis(0), zero, pose.direction), None)), None],
            _ => rotaries::two(axis(0), axis(1), zero, pose.direction)
                .map_err(|by| Unreachable::Direction { by })?
                .map(Some),
        };
        let mut branches = Branches::new();
        for (first, second) in pairs.into_iter().flatten() {
            let mut joints = Joints::default();
            let mut singular = false;
            for (&screw, angle) in self.rotary.iter().zip([first, second]) {
                let at = chain.screws[screw].axis;
                joints[at] = angle.unwrap_or(near[at]);
                singular |= angle.is_none();
            }
            self.solve_linear(chain, pose.point, &mut joints)?;
            let reached = chain.forward(&joints).direction;
            branches.push(Solution { joints, attitude_error: angle_between(reached, pose.direction), singular });
        }
        Ok(branches)
    }

    /// The linear positions that put the tip on `point` with the rotary positions already in `joints`.
    fn solve_linear(&self, chain: &Chain, point: DVec3, joints: &mut Joints) -> Result<(), Unreachable> {
        // Each linear axis is turned by the rotary axes between it and the work.
        let directions = self.linear.map(|l| {
            self.rotary.iter().rev().filter(|&&r| r < l).fold(chain.screws[l].direction, |v, &r| {
                let screw = &chain.screws[r];
                screw.turn_vector(joints[screw.axis], v)
            })
        });
        let matrix = DMat3::from_cols(directions[0], directions[1], directions[2]);
        if matrix.determinant().abs() < 1e-6 {
            return Err(Unreachable::Flat);
        }
        let values = matrix.inverse() * (point - chain.forward(joints).point);
        for (&screw, value) in self.linear.iter().zip(values.to_array()) {
            joints[chain.screws[screw].axis] = value;
        }
        Ok(())
    }
}
