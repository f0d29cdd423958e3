use crate::axis::AxisKind;
use crate::chain::Joints;
use crate::links::LinkFrames;
use crate::machine::Machine;
use glam::{DAffine3, DVec3};
use seamwright_geometry::Pose;

/// Side of the base of an axis: it moves the torch or the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// It carries the torch.
    Tool,
    /// It carries the work.
    Work,
}

/// Position and positive direction of an axis, in the base frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisPlace {
    /// Index of the axis.
    pub axis: usize,
    /// Its side: torch or work.
    pub side: Side,
    /// A point on it, mm: the carriage of a linear axis, or the work if it moves the work.
    pub at: DVec3,
    /// Unit direction: of positive motion of the carried body, or of its axis of rotation (right-hand rule).
    pub direction: DVec3,
}

/// A machine as lines at some positions, in its base frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Skeleton {
    /// Every axis, in machine-file order.
    pub axes: Vec<AxisPlace>,
    /// Lines through the axes from the base to each tip and to the work.
    pub links: Vec<Vec<DVec3>>,
    /// Name, tip and beam of each head.
    pub heads: Vec<(String, Pose)>,
    /// The work frame in the base frame.
    pub work: DAffine3,
}

impl Machine {
    /// The base frame in the work frame, given the links' motion.
    pub fn base_frame(&self, frames: &LinkFrames) -> DAffine3 {
        frames[self.links.base] * self.links.base_zero
    }

    /// The machine as lines at indicated positions `q`, in its base frame.
    pub fn skeleton(&self, q: &Joints) -> Skeleton {
        let frames = self.link_frames(q);
        let work = self.base_frame(&frames).inverse();
        let links = &self.links;
        // Links are ordered from the work: those up to the base are on its side.
        let place = |link: usize| {
            let (_, found) = links.links[link].parent.as_ref()?;
            let screw = links.screw_at(found.axis, &frames)?;
            let side = if link <= links.base { Side::Work } else { Side::Tool };
            // On the tool side the carriage has moved by the axis' own position.
            let moved = match (side, screw.kind) {
                (Side::Tool, AxisKind::Linear) => self.true_positions(q)[screw.axis] * screw.direction,
                _ => DVec3::ZERO,
            };
            let sense = if side == Side::Work { -1.0 } else { 1.0 };
            let at = work.transform_point3(screw.at + moved);
            Some(AxisPlace { axis: screw.axis, side, at, direction: sense * work.transform_vector3(screw.direction) })
        };
        let places: Vec<Option<AxisPlace>> = (0..links.count()).map(place).collect();
        let mut axes: Vec<AxisPlace> = places.iter().flatten().copied().collect();
        axes.sort_by_key(|a| a.axis);
        let heads: Vec<(String, Pose)> = (0..self.heads.len()).map(|head| self.head_in_base(head, q, &work)).collect();
        let mut lines = vec![self.line_to_work(&places, &work)];
        for (head, (_, tip)) in heads.iter().enumerate() {
            let carried = self.heads[head].chain.axes();
            let on_way = places.iter().flatten().filter(|p| p.side == Side::Tool && carried.has(p.axis)).map(|p| p.at);
            lines.push(std::iter::once(DVec3::ZERO).chain(on_way).chain([tip.point]).collect());
        }
        Skeleton { axes, links: lines, heads, work }
    }

    fn head_in_base(&self, head: usize, q: &Joints, work: &DAffine3) -> (String, Pose) {
        let tip = self.forward_of(head, q);
        let pose = Pose {
            point: work.transform_point3(tip.point),
            direction: work.transform_vector3(tip.direction).normalize_or_zero(),
        };
        (self.heads[head].name.clone(), pose)
    }

    fn line_to_work(&self, places: &[Option<AxisPlace>], work: &DAffine3) -> Vec<DVec3> {
        let on_way = places.iter().flatten().filter(|p| p.side == Side::Work).map(|p| p.at);
        let mut line: Vec<DVec3> = std::iter::once(work.translation).chain(on_way).chain([DVec3::ZERO]).collect();
        line.reverse();
        line
    }
}
