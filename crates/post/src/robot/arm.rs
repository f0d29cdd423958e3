use super::language::RobotLanguage;
use super::pose::RobotPose;
use crate::error::Error;
use glam::{DAffine3, DVec3};
use seamwright_machine::{AxisKind, Joints, LinkJoint, Machine};

/// Sine of the angle below which two axes are parallel.
const PARALLEL: f64 = 1e-9;

/// An axis beside those of the arm: a rail, or an axis of a positioner.
#[derive(Debug, Clone, PartialEq)]
pub struct External {
    /// Its index among the machine's axes.
    pub axis: usize,
    /// Its name in the machine file.
    pub name: String,
    /// Kind of its motion: mm or degrees.
    pub kind: AxisKind,
    /// True if it moves the work.
    pub carries_work: bool,
}

/// A machine as a robot: its six arm axes, its external axes and the frames that its control knows.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotArm {
    /// Indices of the arm's axes, from the base on.
    pub joints: [usize; 6],
    /// External axes: those that carry the arm, then those that carry the work, both from the base on.
    pub externals: Vec<External>,
    /// The tool centre point in the flange.
    pub tool: RobotPose,
    /// The work frame in the base frame with all external axes at zero; with a positioner in the frame of its last axis.
    pub work: RobotPose,
    /// The work frame in the base frame with all external axes at zero.
    pub work_at_zero: RobotPose,
    /// Height of the second axis above the base frame, mm.
    pub shoulder_height_mm: f64,
}

/// Refuses more external axes than the language has.
fn check_externals(machine: &Machine, language: RobotLanguage, externals: &[External]) -> Result<(), Error> {
    let (positioner, carriers): (Vec<_>, Vec<_>) = externals.iter().partition(|external| external.carries_work);
    let refused = |axes: Vec<&External>, max| {
        let axes = axes.into_iter().map(|external| external.name.clone()).collect();
        Err(Error::ExternalAxes { machine: machine.name.clone(), language, axes, max })
    };
    if carriers.len() > language.max_carriers() {
        return refused(carriers, language.max_carriers());
    }
    if positioner.len() > language.max_positioner_axes() {
        return refused(positioner, language.max_positioner_axes());
    }
    if externals.len() > language.max_externals() {
        return refused(externals.iter().collect(), language.max_externals());
    }
    Ok(())
}

/// Refuses axes that carry the arm unless they are linear along x, y or z of the base frame: INFORM counts their positions
/// along these. `base` is that frame in the work frame.
fn check_base_axes(machine: &Machine, carriers: &[LinkJoint], base: &DAffine3) -> Result<(), Error> {
    for joint in carriers {
        let (axis, along) = (&machine.axes[joint.axis], base.inverse().transform_vector3(joint.direction));
        let is_along = [DVec3::X, DVec3::Y, DVec3::Z].iter().any(|unit| along.distance(*unit) < PARALLEL);
        if axis.kind != AxisKind::Linear || !is_along {
            return Err(Error::BaseAxis { machine: machine.name.clone(), axis: axis.name.clone() });
        }
    }
    Ok(())
}

impl RobotArm {
    /// The robot that `machine` is, for `language`.
    ///
    /// # Errors
    /// [`Error::NotAnArm`], [`Error::WrongArm`], [`Error::ExternalAxes`], [`Error::BaseAxis`], [`Error::TwoTorches`],
    /// [`Error::FrameNotFinite`].
    pub fn new(machine: &Machine, language: RobotLanguage) -> Result<Self, Error> {
        let no_arm = || Error::NotAnArm { machine: machine.name.clone(), language };
        if machine.heads.len() > 1 {
            return Err(Error::TwoTorches);
        }
        if !machine.has_free_roll() {
            return Err(no_arm());
        }
        let mut chain = Vec::new();
        let mut link = machine.links.frame(&machine.heads[0].name).ok_or_else(no_arm)?.link;
        let mut base_at = 0;
        while let Some(joint) = machine.links.joint(link) {
            chain.push(joint);
            link = joint.on;
            if link == machine.links.base() {
                base_at = chain.len();
            }
        }
        if base_at < 6 {
            return Err(no_arm());
        }
        let joints: [usize; 6] = std::array::from_fn(|i| chain[5 - i].axis);
        let is_parallel = chain[2].direction.cross(chain[3].direction).length() < PARALLEL;
        if is_parallel != language.has_parallel_axes() {
            return Err(Error::WrongArm { machine: machine.name.clone(), language });
        }
        let carriers = chain[6..base_at].iter().rev().map(|joint| (joint.axis, false));
        let positioner = chain[base_at..].iter().map(|joint| (joint.axis, true));
        let externals: Vec<External> = carriers
            .chain(positioner)
            .map(|(axis, carries_work)| {
                let of = &machine.axes[axis];
                External { axis, name: of.name.clone(), kind: of.kind, carries_work }
            })
            .collect();
        check_externals(machine, language, &externals)?;
        let work_at_zero = machine.links.named().iter().find(|frame| frame.name == "base").ok_or_else(no_arm)?.zero;
        let on_positioner = externals.iter().rev().find(|external| external.carries_work);
        let last = on_positioner.and_then(|external| machine.links.frame(&external.name));
        let work = last.map_or(work_at_zero, |frame| frame.zero).inverse();
        if language == RobotLanguage::Inform {
            check_base_axes(machine, &chain[6..base_at], &work_at_zero)?;
        }
        let second = work_at_zero.inverse().transform_point3(chain[4].at);
        let arm = Self {
            joints,
            externals,
            tool: RobotPose::of(&machine.heads[0].tool),
            work: RobotPose::of(&work),
            work_at_zero: RobotPose::of(&work_at_zero.inverse()),
            shoulder_height_mm: second.z,
        };
        let finite = arm.tool.is_finite() && arm.work.is_finite() && arm.work_at_zero.is_finite();
        if finite { Ok(arm) } else { Err(Error::FrameNotFinite { machine: machine.name.clone() }) }
    }

    /// True if external axes move the work.
    pub fn has_positioner(&self) -> bool {
        self.externals.iter().any(|external| external.carries_work)
    }

    /// Number of external axes that carry the arm; those of the positioner follow them.
    pub(crate) fn carriers(&self) -> usize {
        self.externals.iter().filter(|external| !external.carries_work).count()
    }

    /// Displacement of the work frame by the positioner from its place with all external axes at zero, in that frame.
    pub(crate) fn carried(&self, machine: &Machine, externals: &[f64]) -> DAffine3 {
        let mut q = Joints::default();
        for (external, position) in self.externals.iter().zip(externals) {
            q[external.axis] = machine.axes[external.axis].from_file(*position);
        }
        machine.link_frames(&q)[machine.links.base()].inverse()
    }

    /// Positions of the arm's axes in degrees.
    pub fn arm_deg(&self, q: &Joints) -> [f64; 6] {
        self.joints.map(|axis| q[axis].to_degrees())
    }

    /// Positions of the external axes, mm or degrees.
    pub fn external_positions(&self, machine: &Machine, q: &Joints) -> Vec<f64> {
        self.externals.iter().map(|external| machine.axes[external.axis].to_file(q[external.axis])).collect()
    }

    /// The tool centre point in the work frame at positions `q`.
    pub fn pose(machine: &Machine, q: &Joints) -> RobotPose {
        let tip = DAffine3::from_translation(machine.heads[0].tip);
        RobotPose::of(&(machine.mount_frame(0, q) * tip))
    }

    /// Direction across the torch at the orientation of `pose`, as the machine's inverse kinematics take it.
    pub fn across(pose: &RobotPose, direction: DVec3) -> DVec3 {
        let x = pose.turn * DVec3::X;
        (x - x.dot(direction) * direction).try_normalize().unwrap_or_else(|| direction.any_orthonormal_vector())
    }
}
