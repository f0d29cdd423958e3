use super::branches::{Branches, Query, Unreachable};
use super::vectors::in_plane;
use crate::chain::Chain;
use seamwright_geometry::angle_between;

/// Maximum distance (mm) of a point from the plane of two linear axes that counts as in it.
const IN_PLANE_MM: f64 = 1e-6;

/// Two linear axes alone (ELLIPSE-2015): points of one plane, one direction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct TwoLinear {
    linear: [usize; 2],
}

impl TwoLinear {
    pub(crate) fn new(chain: &Chain, linear: [usize; 2]) -> Option<Self> {
        let [a, b] = linear.map(|l| &chain.screws[l]);
        crate::inverse::vectors::independent(a, b).then_some(Self { linear })
    }

    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let Query { chain, pose, .. } = query;
        let [a, b] = self.linear.map(|l| &chain.screws[l]);
        let (x, y, rest) = in_plane(a.direction, b.direction, pose.point - chain.zero.point);
        if rest.length() > IN_PLANE_MM {
            return Err(Unreachable::Point { by: rest.length() });
        }
        let solution = branches.add();
        solution.joints[a.axis] = x;
        solution.joints[b.axis] = y;
        solution.attitude_error = angle_between(chain.zero.direction, pose.direction);
        Ok(())
    }
}
