use super::branches::Unreachable;
use super::rotaries;
use super::three_linear::move_linear;
use super::vectors::independent;
use crate::axis::AxisKind;
use crate::chain::{AxisSet, Chain, Joints, MAX_AXES, Screw, Turn};
use arrayvec::ArrayVec;
use glam::{DMat3, DVec3};

/// Three linear and three rotary axes that bring a whole frame (point and three directions) to a target, for two heads
/// on one carrier. The rotary axes follow from the frame's directions, the linear ones from its point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FrameInverse {
    /// Screws from the work to the carrier.
    screws: ArrayVec<Screw, MAX_AXES>,
    linear: [usize; 3],
    rotary: [usize; 3],
}

/// A point with three directions at right angles (columns).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Frame {
    pub(crate) point: DVec3,
    pub(crate) axes: DMat3,
}

impl FrameInverse {
    /// The inverse for the screws of `chain` that are in `shared`; none without three linear and three rotary axes of
    /// which neighbours are not parallel.
    pub(crate) fn new(chain: &Chain, shared: AxisSet) -> Option<Self> {
        let screws: ArrayVec<Screw, MAX_AXES> = chain.screws.iter().filter(|s| shared.has(s.axis)).copied().collect();
        let of_kind = |kind| -> Vec<usize> { (0..screws.len()).filter(|&i| screws[i].kind == kind).collect() };
        let linear: [usize; 3] = of_kind(AxisKind::Linear).try_into().ok()?;
        let rotary: [usize; 3] = of_kind(AxisKind::Rotary).try_into().ok()?;
        let [a, b, c] = rotary.map(|i| &screws[i]);
        (independent(a, b) && independent(b, c)).then_some(Self { screws, linear, rotary })
    }

    /// Positions of the shared axes that bring `from`, a frame fixed to the carrier and given at zero of all axes, to
    /// `to`; up to two branches. Free turns and the other axes are as in `near`.
    pub(crate) fn solve(
        &self,
        from: &Frame,
        to: &Frame,
        near: &Joints,
    ) -> Result<ArrayVec<(Joints, bool), 2>, Unreachable> {
        let [a, b, c] = self.rotary.map(|i| self.screws[i].direction);
        let turn = to.axes * from.axes.transpose();
        let pairs = rotaries::two(a, b, c, turn * c).map_err(|by| Unreachable::Direction { by })?;
        let mut found = ArrayVec::new();
        for (first, second) in pairs {
            let mut joints = *near;
            let mut singular = false;
            let mut turns = [Turn::NONE; MAX_AXES];
            let mut put = |i: usize, turn: Option<Turn>| {
                let axis = self.screws[self.rotary[i]].axis;
                singular |= turn.is_none();
                turns[axis] = turn.unwrap_or_else(|| Turn::by(near[axis]));
                joints[axis] = turn.map_or(near[axis], Turn::angle);
                turns[axis]
            };
            let (first, second) = (put(0, first), put(1, second));
            // Turn of the third axis: any direction across it shows the angle.
            let across = c.any_orthonormal_vector();
            let wanted = second.back().of(b, first.back().of(a, turn * across));
            put(2, rotaries::one(c, across, wanted));
            let at_zero = self
                .rotary
                .iter()
                .rev()
                .fold(from.point, |p, &r| self.screws[r].turn_point(turns[self.screws[r].axis], p));
            let shift = to.point - at_zero;
            if move_linear(&self.screws, self.linear, &self.rotary, &turns, shift, &mut joints).is_ok() {
                found.push((joints, singular));
            }
        }
        Ok(found)
    }
}
