use crate::axis::AxisKind;
use crate::chain::{AxisSet, Joints, MAX_AXES, Screw};
use glam::{DAffine3, DQuat, DVec3};

/// Maximum number of rigid bodies of a machine: the clamped work, and one for each axis.
pub const MAX_LINKS: usize = MAX_AXES + 1;

/// Frames of the links at some axis positions, by link.
pub type LinkFrames = [DAffine3; MAX_LINKS];

/// A rigid body of the machine: the clamped work, the base, or the body moved by an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Link {
    /// The next link towards the work and the joint with it; none for the work itself.
    pub(crate) parent: Option<(usize, Screw)>,
    /// Axes between this link and the work.
    pub(crate) axes: AxisSet,
}

/// A named frame on a link, in which shapes are given and clearance is reported.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedFrame {
    /// Name of an axis, `base`, `work`, or a head (`torch` on machines with one).
    pub name: String,
    /// Its link, as an index into [`LinkFrames`].
    pub link: usize,
    /// The frame in the work frame with all axes at zero.
    pub zero: DAffine3,
}

/// Joint of a link with another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkJoint {
    /// The next link towards the work, on which it moves: before it in [`LinkFrames`].
    pub on: usize,
    /// The axis that moves it.
    pub axis: usize,
    /// Unit vector in the work frame with all axes at zero: the direction of a linear axis, or the axis of rotation.
    pub direction: DVec3,
    /// A point on a rotary axis, in the same frame, mm.
    pub at: DVec3,
}

/// The machine's links as a tree that grows from the clamped work through the base to the heads.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Links {
    pub(crate) links: Vec<Link>,
    pub(crate) frames: Vec<NamedFrame>,
    pub(crate) base: usize,
    /// The base frame in the work frame with all axes at zero.
    pub(crate) base_zero: DAffine3,
}

impl Links {
    /// Number of links.
    pub fn count(&self) -> usize {
        self.links.len()
    }

    /// All named frames.
    pub fn named(&self) -> &[NamedFrame] {
        &self.frames
    }

    /// The frame called `name`.
    pub fn frame(&self, name: &str) -> Option<&NamedFrame> {
        self.frames.iter().find(|f| f.name == name)
    }

    /// The link that is the machine's base.
    pub fn base(&self) -> usize {
        self.base
    }

    /// The joint of link `i` with the next one towards the work; none for the work itself.
    pub fn joint(&self, i: usize) -> Option<LinkJoint> {
        let joint = |(on, s): (usize, Screw)| LinkJoint { on, axis: s.axis, direction: s.direction, at: s.at };
        self.links[i].parent.map(joint)
    }

    pub(crate) fn parent(&self, i: usize) -> Option<usize> {
        self.links[i].parent.map(|(parent, _)| parent)
    }

    /// The axes from link `i` to the work.
    pub(crate) fn up(&self, i: usize) -> impl Iterator<Item = usize> + '_ {
        let mut link = i;
        std::iter::from_fn(move || {
            let (parent, screw) = self.links[link].parent?;
            link = parent;
            Some(screw.axis)
        })
    }

    /// Displacement of each link from its pose with all axes at zero, in the work frame, at the true positions `q`: a
    /// point `p` of a link at zero moves to `frames[link] * p`.
    pub fn motion(&self, q: &Joints) -> LinkFrames {
        let mut frames = [DAffine3::IDENTITY; MAX_LINKS];
        for (i, link) in self.links.iter().enumerate() {
            if let Some((parent, screw)) = &link.parent {
                frames[i] = frames[*parent] * screw.displacement(q[screw.axis]);
            }
        }
        frames
    }

    /// Direction (unit) and a point of axis `axis` in the work frame, given the links' motion: that of positive motion
    /// of the torch relative to the work.
    pub(crate) fn screw_at(&self, axis: usize, motion: &LinkFrames) -> Option<Screw> {
        self.links.iter().find_map(|l| l.parent.filter(|(_, s)| s.axis == axis)).map(|(parent, s)| Screw {
            direction: motion[parent].transform_vector3(s.direction),
            at: motion[parent].transform_point3(s.at),
            ..s
        })
    }
}

impl Screw {
    /// The rigid motion by `value`, mm or rad.
    pub(crate) fn displacement(&self, value: f64) -> DAffine3 {
        match self.kind {
            AxisKind::Linear => DAffine3::from_translation(value * self.direction),
            AxisKind::Rotary => {
                let turn = DQuat::from_axis_angle(self.direction, value);
                DAffine3::from_rotation_translation(turn, self.at - turn * self.at)
            }
        }
    }
}
