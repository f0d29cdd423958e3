use crate::chain::{AxisSet, Joints};
use crate::inverse::{Branches, Frame, FrameInverse, PairFault, Unreachable, in_plane};
use crate::welding_head::Head;
use glam::DMat3;
use seamwright_geometry::{Pose, angle_between};

/// Two heads on one carrier (DUALBEAM-2013): the shared axes carry the frame of both tips. Each head's slides
/// compensate the difference of the points' distance from that of the tips with centred slides.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pair {
    carrier: FrameInverse,
    shared: AxisSet,
}

/// Maximum distance (mm) of a tip from its point.
const MET_MM: f64 = 1e-6;

impl Pair {
    pub(crate) fn new(heads: &[Head]) -> Option<Self> {
        let [first, second] = heads else { return None };
        let shared = first.chain.axes().both(second.chain.axes());
        Some(Self { carrier: FrameInverse::new(&first.chain, shared)?, shared })
    }

    pub(crate) fn solve(
        &self,
        heads: &[Head],
        poses: [&Pose; 2],
        near: &Joints,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        // The tips with carrier and slides at zero; other axes of a tail stay.
        let mut at_zero = *near;
        let slides = heads[0].slides.union(heads[1].slides);
        self.shared.union(slides).iter().for_each(|axis| at_zero[axis] = 0.0);
        let tips = [0, 1].map(|k| heads[k].chain.forward(&at_zero));
        let from = frame([&tips[0], &tips[1]])?;
        let to = frame(poses)?;
        let mut missed = None;
        for (mut joints, singular) in self.carrier.solve(&from, &to, &at_zero)? {
            let mut attitude_error = 0.0f64;
            let mut rest = 0.0f64;
            for (head, pose) in heads.iter().zip(poses) {
                rest = rest.max(slide(head, pose, &mut joints));
                attitude_error =
                    attitude_error.max(angle_between(head.chain.forward(&joints).direction, pose.direction));
            }
            if rest.is_nan() || rest > MET_MM {
                missed = Some(Unreachable::Point { by: rest });
                continue;
            }
            let solution = branches.add();
            (solution.joints, solution.singular, solution.attitude_error) = (joints, singular, attitude_error);
        }
        if branches.is_empty() { Err(missed.unwrap_or(Unreachable::Flat)) } else { Ok(()) }
    }
}

/// Moves the head's slides so that its tip is as near to the pose's point as possible; returns the remaining distance,
/// mm.
fn slide(head: &Head, pose: &Pose, joints: &mut Joints) -> f64 {
    let shift = pose.point - head.chain.forward(joints).point;
    let columns = head.chain.jacobian(joints);
    let mut slides = head.slides.iter();
    match (slides.next(), slides.next()) {
        (Some(a), Some(b)) => {
            if columns[a].0.cross(columns[b].0).length() < 1e-6 {
                return f64::INFINITY;
            }
            let (x, y, rest) = in_plane(columns[a].0, columns[b].0, shift);
            (joints[a], joints[b]) = (joints[a] + x, joints[b] + y);
            rest.length()
        }
        (Some(a), None) => {
            let x = columns[a].0.dot(shift);
            joints[a] += x;
            (shift - x * columns[a].0).length()
        }
        _ => shift.length(),
    }
}

/// The frame of two tips: its point between them, x from the first to the second, z against the sum of both directions.
fn frame([first, second]: [&Pose; 2]) -> Result<Frame, Unreachable> {
    let none = Unreachable::Pair(PairFault::SamePoint);
    let x = (second.point - first.point).try_normalize().ok_or(none)?;
    let back = -(first.direction + second.direction);
    let along = Unreachable::Pair(PairFault::Opposed);
    let z = (back - back.dot(x) * x).try_normalize().ok_or(along)?;
    Ok(Frame { point: 0.5 * (first.point + second.point), axes: DMat3::from_cols(x, z.cross(x), z) })
}
