use crate::assemble;
use crate::axis::{Axis, AxisKind, RangeViolation};
use crate::beam_deflection::BeamDeflection;
use crate::cell::{InterlockFile, PanelLost, Source};
use crate::chain::{AxisSet, Joints, MAX_AXES};
use crate::devices::MachineDevices;
use crate::file::{ControlsFile, Io, MachineFile};
use crate::head_pair::Pair;
use crate::inverse;
use crate::inverse::{ArmConfiguration, ArmMargins, Branches, Inverse, PairFault, Query, Solution, Unreachable, Which};
use crate::lever::{Lever, PITCH, travel};
use crate::links::{LinkFrames, Links};
use crate::roll::RollReference;
use crate::sensor::Sensor;
use crate::solids::LinkSolids;
use crate::welding_head::Head;
use crate::{AxisLimits, Sight};
use arrayvec::ArrayVec;
use glam::{DAffine3, DMat3, DVec3};
use seamwright_document::DocumentError;
use seamwright_geometry::{HeightTable, Pose};
use std::f64::consts::TAU;

/// Number of positions of the redundant axes tried to reach a pose.
const FREE_PLACES: u32 = 500;
/// The golden section spreads any number of rotations about the torch evenly.
const GOLDEN: f64 = 0.618_033_988_75;
/// Maximum number of starts of [`Machine::inverse_from`].
const MAX_STARTS: usize = 16;

/// A machine: its axes, links and heads.
#[derive(Debug, Clone)]
pub struct Machine {
    /// Short name.
    pub name: String,
    /// Title, for people.
    pub title: String,
    /// Axes in machine-file order: tool side first, then work side, then the heads' own.
    pub axes: Vec<Axis>,
    /// Indices of the axes that move to their home positions, one after another, after all references are found.
    pub home_order: Vec<usize>,
    /// Reaction of a running program to the loss of its panel.
    pub on_panel_lost: PanelLost,
    /// Period of position loops and set-points, s.
    pub servo_period_s: f64,
    /// Maximum time without a cycle of the running cell, s, if the file limits it.
    pub longest_gap_s: Option<f64>,
    /// Outputs of the process.
    pub io: Io,
    /// Interlocks of the running cell.
    pub interlocks: Vec<InterlockFile>,
    /// Start and supervision of the process source.
    pub source: Source,
    /// Devices of the process source, inputs and outputs.
    pub devices: MachineDevices,
    /// Names of axes and process values on the controls.
    pub controls: ControlsFile,
    /// Heads, at least one: each with its chain from the work to its tip.
    pub heads: Vec<Head>,
    /// The rigid bodies.
    pub links: Links,
    /// Solids of the links, and zones.
    pub solids: LinkSolids,
    /// Sensors of the joint, by name.
    pub sensors: Vec<Sensor>,
    /// User frames, by name. No motion of a program depends on them.
    pub user_frames: Vec<UserFrame>,
    /// Limits of the first head's torch tip against the work.
    pub tip: AxisLimits,
    /// Wire between the torch's contact tip and its tip, mm, if the file has it.
    pub stick_out_mm: Option<f64>,
    /// Beam deflection of a machine whose torch is a beam.
    pub deflection: Option<BeamDeflection>,
    /// Unit vector against gravity in the machine's base frame.
    pub up: DVec3,
    pub(crate) pair: Option<Pair>,
    /// True if any axis has a pitch-error table.
    pub(crate) has_pitch_error: bool,
}

/// A frame that the user has named, at rest in the machine's base.
#[derive(Debug, Clone, PartialEq)]
pub struct UserFrame {
    /// Its name.
    pub name: String,
    /// The frame in the base frame, mm.
    pub in_base: DAffine3,
}

/// Target poses of one torch, or of two at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// Tip and direction of the first head's torch in the work frame.
    pub first: Pose,
    /// Tip and direction of the second head's torch, if both weld.
    pub second: Option<Pose>,
    /// Direction across the first head's torch (see [`Machine::across`]), on a six-axis arm; if missing, the rotation
    /// about the torch stays as near as possible to the current one.
    pub across: Option<DVec3>,
    /// Arm angle of a seven-axis arm (see [`Machine::arm_angle`]), rad; if missing, its third axis keeps its position.
    pub arm_angle: Option<f64>,
}

impl Target {
    /// Target of the first head's torch, and of the second one's if both weld.
    pub fn new(first: Pose, second: Option<Pose>) -> Self {
        Self { first, second, across: None, arm_angle: None }
    }
}

impl From<Pose> for Target {
    fn from(first: Pose) -> Self {
        Self::new(first, None)
    }
}

impl From<&Pose> for Target {
    fn from(first: &Pose) -> Self {
        Self::from(*first)
    }
}

impl Machine {
    /// Reads a machine file that names no other files.
    ///
    /// # Errors
    /// The first error, with its address.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        Self::read_with(file, text, &|_| Err(std::io::ErrorKind::NotFound.into()))
    }

    /// Reads a machine file; `load` reads the bytes of the STL files that it names.
    ///
    /// # Errors
    /// The first error, with its address.
    pub fn read_with(
        file: &str,
        text: &str,
        load: &dyn Fn(&str) -> std::io::Result<Vec<u8>>,
    ) -> Result<Self, DocumentError> {
        assemble::machine(&MachineFile::read(file, text)?, load)
    }

    /// The same machine with head `head` as the first, to which poses refer.
    #[must_use]
    pub fn with_first_head(mut self, head: usize) -> Self {
        self.heads.swap(0, head);
        self
    }

    /// The same machine with every axis' speed, acceleration and jerk reduced by the fraction `reserve`, which planning
    /// leaves to corrections.
    #[must_use]
    pub fn with_reserve(&self, reserve: f64) -> Self {
        let mut machine = self.clone();
        for axis in &mut machine.axes {
            axis.max_jerk = (1.0 - reserve) * axis.jerk();
            axis.max_speed *= 1.0 - reserve;
            axis.max_acceleration *= 1.0 - reserve;
        }
        machine
    }

    /// True if both heads can be brought to two poses at once.
    pub fn can_pair(&self) -> bool {
        self.pair.is_some()
    }

    /// The sensor called `name`.
    pub fn sensor(&self, name: &str) -> Option<&Sensor> {
        self.sensors.iter().find(|s| s.name == name)
    }

    /// The frame of `sensor` in the work frame at indicated positions `q`.
    pub fn sensor_frame(&self, sensor: &Sensor, q: &Joints) -> DAffine3 {
        self.link_frames(q)[sensor.link] * sensor.zero
    }

    /// Index of the axis called `name`.
    pub fn axis(&self, name: &str) -> Option<usize> {
        self.axes.iter().position(|a| a.name == name)
    }

    /// Returns the cameras, each with its map from pixels.
    pub fn cameras(&self) -> impl Iterator<Item = (&Sensor, &HeightTable)> {
        self.sensors.iter().filter_map(|sensor| match &sensor.sight {
            Sight::Camera(camera) => Some((sensor, &camera.table)),
            Sight::Stripe(_) => None,
        })
    }

    /// Converts axis positions in mm or degrees, in the machine file's order.
    pub fn joints_from_file(&self, given: &[f64]) -> Joints {
        let mut joints = Joints::default();
        for (value, (axis, given)) in joints.iter_mut().zip(self.axes.iter().zip(given)) {
            *value = axis.from_file(*given);
        }
        joints
    }

    /// Positions after homing.
    pub fn home(&self) -> Joints {
        let mut q = Joints::default();
        for (value, axis) in q.iter_mut().zip(&self.axes) {
            *value = axis.home;
        }
        q
    }

    /// True positions at the indicated ones: with the axes' pitch errors.
    pub fn true_positions(&self, indicated: &Joints) -> Joints {
        let mut q = *indicated;
        if self.has_pitch_error {
            for (value, axis) in q.iter_mut().zip(&self.axes) {
                *value = axis.pitch_error.as_ref().map_or(*value, |e| e.true_at(*value).0);
            }
        }
        q
    }

    /// Replaces the true `positions` by the indicated ones.
    fn indicated(&self, positions: &mut Joints) {
        if self.has_pitch_error {
            for (value, axis) in positions.iter_mut().zip(&self.axes) {
                *value = axis.pitch_error.as_ref().map_or(*value, |e| e.indicated_at(*value));
            }
        }
    }

    /// Torch tip and direction of the first head in the work frame at indicated positions `q`.
    pub fn forward(&self, q: &Joints) -> Pose {
        self.forward_of(0, q)
    }

    /// Torch tip and direction of head `head`.
    pub fn forward_of(&self, head: usize, q: &Joints) -> Pose {
        self.heads[head].chain.forward(&self.true_positions(q))
    }

    /// Direction across the first head's torch, in the work frame at indicated positions `q`: the x axis of the tool
    /// steps' last frame, made perpendicular to the torch.
    pub fn across(&self, q: &Joints) -> DVec3 {
        self.heads[0].chain.frame(&self.true_positions(q)).1
    }

    /// True if the rotation about the first head's torch is free: an arm with a closed form carries it.
    pub fn has_free_roll(&self) -> bool {
        self.heads[0].inverse.has_free_roll()
    }

    /// True if the pose of the first head's torch leaves axes or the rotation about the torch free.
    pub fn is_redundant(&self) -> bool {
        self.has_free_roll() || !self.free().is_empty()
    }

    /// Configuration of the six- or seven-axis arm at positions `q`; none for other machines.
    pub fn arm_configuration(&self, q: &Joints) -> Option<ArmConfiguration> {
        self.heads[0].inverse.configuration(&self.true_positions(q), &self.links.base_zero)
    }

    /// Distances of the six- or seven-axis arm from its singularities at positions `q`; none for other machines.
    pub fn arm_margins(&self, q: &Joints) -> Option<ArmMargins> {
        self.heads[0].inverse.margins(&self.true_positions(q))
    }

    /// Arm angle (rad) of a seven-axis arm at positions `q`: the angle of its elbow about the line from shoulder to wrist,
    /// from the half plane to which the first axis points. None for other machines.
    pub fn arm_angle(&self, q: &Joints) -> Option<f64> {
        self.heads[0].inverse.arm_angle(&self.true_positions(q))
    }

    /// Columns of the first head's Jacobian at indicated positions `q`: change of tip (mm) and direction per mm or rad.
    pub fn jacobian(&self, q: &Joints) -> [(DVec3, DVec3); MAX_AXES] {
        let mut columns = self.heads[0].chain.jacobian(&self.true_positions(q));
        for ((column, axis), value) in columns.iter_mut().zip(&self.axes).zip(q) {
            let slope = axis.pitch_error.as_ref().map_or(1.0, |e| e.true_at(*value).1);
            *column = (slope * column.0, slope * column.1);
        }
        columns
    }

    /// Maximum displacement (mm) of the first head's tip relative to the work. Each axis moves by up to `by` (mm or
    /// rad, either sign) from indicated positions `q`. It takes the levers at `q`, plus the displacements by the axes
    /// between.
    pub fn tip_travel(&self, q: &Joints, by: &Joints) -> f64 {
        let chain = &self.heads[0].chain;
        let columns = chain.jacobian(&self.true_positions(q));
        let lever = |axis: usize| {
            let Axis { kind, pitch_error, .. } = &self.axes[axis];
            let pitch = if pitch_error.is_some() { PITCH } else { 1.0 };
            Lever { axis, kind: *kind, arm: columns[axis].0.length(), pitch }
        };
        let levers: ArrayVec<Lever, MAX_AXES> = chain.screws.iter().rev().map(|s| lever(s.axis)).collect();
        travel(&levers, |i| by[i].abs())
    }

    /// Frames of the links in the work frame at indicated positions `q`: see [`Links::motion`].
    pub fn link_frames(&self, q: &Joints) -> LinkFrames {
        self.links.motion(&self.true_positions(q))
    }

    /// The last frame of the steps of head `head`, with its tip at [`crate::Head::tip`], in the work frame at indicated
    /// positions `q`.
    pub fn mount_frame(&self, head: usize, q: &Joints) -> DAffine3 {
        let head = &self.heads[head];
        let named = self.links.frames.iter().find(|frame| frame.name == head.name);
        named.map_or(DAffine3::IDENTITY, |frame| self.link_frames(q)[frame.link] * frame.zero)
    }

    /// The tool frame of the first head's torch in the work frame at indicated positions `q`: its tip, the x axis of
    /// [`Machine::across`], z from the torch to the work.
    pub fn tool_frame(&self, q: &Joints) -> DAffine3 {
        let Pose { point, direction: z } = self.forward(q);
        let x = self.across(q);
        DAffine3 { matrix3: DMat3::from_cols(x, z.cross(x), z), translation: point }
    }

    /// The user frame called `name`.
    pub fn user_frame(&self, name: &str) -> Option<&UserFrame> {
        self.user_frames.iter().find(|frame| frame.name == name)
    }

    /// The frame of `sensor` as a camera, in the work frame at indicated positions `q`: x to the right in the picture,
    /// y down, z away from the camera.
    pub fn camera_frame(&self, sensor: &Sensor, q: &Joints) -> DAffine3 {
        self.sensor_frame(sensor, q) * DAffine3::from_rotation_x(std::f64::consts::PI)
    }

    /// Unit vector against gravity, in the work frame at positions `q`.
    pub fn up_in_work(&self, q: &Joints) -> DVec3 {
        let base = self.link_frames(q)[self.links.base()];
        base.transform_vector3(self.links.base_zero.transform_vector3(self.up))
    }

    /// Redundant axes of the first head's pose: the machine has more axes than the pose needs.
    pub fn free(&self) -> AxisSet {
        self.heads[0].free()
    }

    /// The same machine with `held` among the redundant axes of the first head's pose, if the other axes can still
    /// reach every pose. The other redundant axes are chosen anew.
    pub fn freeing(&self, held: AxisSet) -> Option<Self> {
        let inverse = Inverse::holding(&self.heads[0].chain, &self.axes, held)?;
        let mut machine = self.clone();
        machine.heads[0].inverse = inverse;
        Some(machine)
    }

    /// The branches on which a solution continues: as [`Machine::inverse`] with a closed form. Newton's method only
    /// searches from `starts`, in a hundredth of the time.
    ///
    /// # Errors
    /// The reason why no branch exists.
    pub fn inverse_from(
        &self,
        target: impl Into<Target>,
        near: &Joints,
        starts: &[Joints],
    ) -> Result<Branches, Unreachable> {
        let mut branches = Branches::default();
        let truly: ArrayVec<Joints, MAX_STARTS> =
            starts.iter().take(MAX_STARTS).map(|start| self.true_positions(start)).collect();
        self.inverse_into(&target.into(), near, Which::From(&truly), &mut branches)?;
        Ok(branches)
    }

    /// The branch that continues from `near`: as [`Machine::inverse_near`], but Newton's method only starts from there.
    ///
    /// # Errors
    /// As [`Machine::inverse`].
    pub fn inverse_next(&self, target: impl Into<Target>, near: &Joints) -> Result<Solution, Unreachable> {
        let target = target.into();
        if target.second.is_some() || !self.heads[0].is_numeric() {
            return self.inverse_near(target, near);
        }
        self.inverse_from(target, near, &[*near]).map(|branches| branches[0])
    }

    /// All branches of positions that bring the torches to `target`, rotary axes within half a turn of `near`.
    /// Redundant axes ([`Head::free`]) keep their positions of `near`, as do the axes that a singular pose leaves free.
    /// Ranges are ignored: see [`Machine::reach`].
    ///
    /// # Errors
    /// The reason why no branch exists.
    pub fn inverse(&self, target: impl Into<Target>, near: &Joints) -> Result<Branches, Unreachable> {
        let mut branches = Branches::default();
        self.inverse_into(&target.into(), near, Which::All, &mut branches)?;
        Ok(branches)
    }

    /// Solves at true positions, and converts the solutions to indicated ones, each within half a true turn of `near`:
    /// a pitch-error table need not be periodic.
    fn inverse_into(
        &self,
        target: &Target,
        near: &Joints,
        which: Which,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        let near = &self.true_positions(near);
        if let Some(second) = &target.second {
            let pair = self.pair.as_ref().ok_or(Unreachable::Pair(PairFault::Axes))?;
            pair.solve(&self.heads, [&target.first, second], near, branches)?;
        } else {
            let Head { chain, inverse, .. } = &self.heads[0];
            let Target { first: pose, across, arm_angle, .. } = target;
            inverse.solve(Query { chain, pose, across: *across, arm_angle: *arm_angle, near, which }, branches)?;
            // Axes that do not carry the first head keep their positions.
            let idle = (0..self.axes.len()).filter(|&axis| !chain.axes().has(axis));
            idle.for_each(|axis| branches.iter_mut().for_each(|s| s.joints[axis] = near[axis]));
        }
        for solution in branches.iter_mut() {
            for (axis, (value, near)) in self.axes.iter().zip(solution.joints.iter_mut().zip(near)) {
                *value = axis.turn_near(*value, *near);
            }
            self.indicated(&mut solution.joints);
        }
        Ok(())
    }

    /// The branch nearest to `near`, by the angles of the rotary axes if these decide it.
    ///
    /// # Errors
    /// As [`Machine::inverse`].
    pub fn inverse_near(&self, target: impl Into<Target>, near: &Joints) -> Result<Solution, Unreachable> {
        let mut branches = Branches::default();
        self.inverse_into(&target.into(), near, Which::Nearest, &mut branches)?;
        let distance = |s: &Solution| -> f64 {
            let steps = self.axes.iter().zip(s.joints.iter().zip(near));
            steps.map(|(axis, (a, b))| ((a - b) / axis.max_speed).powi(2)).sum()
        };
        let nearest = branches.iter().map(|s| (distance(s), s)).min_by(|a, b| a.0.total_cmp(&b.0));
        Ok(nearest.map_or(branches[0], |(_, solution)| *solution))
    }

    /// The branches within all ranges, nearest to `near` first, rotary axes turned by whole turns as needed. If no
    /// branch fits, other positions of the redundant axes and other rotations about the torch are tried.
    ///
    /// # Errors
    /// The reason why no branch fits: for the closest branch, the axis and its excess.
    pub fn reach(&self, target: impl Into<Target>, near: &Joints) -> Result<Vec<Solution>, Unreachable> {
        let target = target.into();
        let mut reason = match self.reach_from(&target, near) {
            Ok(found) => return Ok(found),
            Err(reason) => reason,
        };
        let free = if target.second.is_some() { AxisSet::default() } else { self.free() };
        let rolls = self.has_free_roll() && target.second.is_none() && target.across.is_none();
        if free.is_empty() && !rolls {
            return Err(reason);
        }
        let reference = RollReference::new(&[target.first]);
        for k in 1..=FREE_PLACES {
            let spread = inverse::spread(&self.axes, k);
            let mut start = *near;
            free.iter().for_each(|axis| start[axis] = spread[axis]);
            let roll = TAU * (GOLDEN * f64::from(k)).fract();
            let across = rolls.then(|| reference.across(target.first.direction, roll)).or(target.across);
            match self.reach_from(&Target { across, ..target }, &start) {
                Ok(found) => return Ok(found),
                Err(other) if other.by() < reason.by() => reason = other,
                Err(_) => {}
            }
        }
        Err(reason)
    }

    fn reach_from(&self, target: &Target, near: &Joints) -> Result<Vec<Solution>, Unreachable> {
        let branches = self.inverse(*target, near)?;
        let mut inside = Vec::new();
        let mut nearest: Option<Unreachable> = None;
        for solution in branches.iter() {
            let joints = self.turned_into_range(&solution.joints);
            match self.beyond(&joints) {
                None => inside.push(Solution { joints, ..*solution }),
                Some(why) if nearest.as_ref().is_none_or(|n| why.by() < n.by()) => nearest = Some(why),
                Some(_) => {}
            }
        }
        match nearest {
            Some(why) if inside.is_empty() => Err(why),
            _ => Ok(inside),
        }
    }

    /// The reason why `q` is out of the ranges: linear axes before rotary ones, and of each kind the axis with the
    /// largest excess.
    fn beyond(&self, q: &Joints) -> Option<Unreachable> {
        let of_kind = |kind| {
            let axes = self.axes.iter().zip(q).enumerate().filter(move |(_, (axis, _))| axis.kind == kind);
            let outside = axes.filter_map(|(i, (axis, &value))| {
                axis.outside(value).map(|limit| RangeViolation { axis: i, value, limit })
            });
            outside.max_by(|a, b| a.by().total_cmp(&b.by()))
        };
        let Some(linear) = of_kind(AxisKind::Linear) else {
            return of_kind(AxisKind::Rotary).map(|v| self.range_error(&v));
        };
        let lacking = self.axes.iter().zip(q).filter(|(axis, _)| axis.kind == AxisKind::Linear);
        let by = lacking.filter_map(|(axis, &q)| axis.outside(q).map(|limit| (q - limit).powi(2))).sum::<f64>().sqrt();
        let axis = &self.axes[linear.axis];
        let (axis, value, beyond, limit) = (axis.name.clone(), linear.value, linear.by(), linear.limit);
        Some(Unreachable::OutOfReach { by, axis, value, beyond, limit })
    }

    /// A violated range as a reason, in the units of the file.
    pub fn range_error(&self, v: &RangeViolation) -> Unreachable {
        let axis = &self.axes[v.axis];
        let (value, by, limit) = (axis.to_file(v.value), axis.to_file(v.by()), axis.to_file(v.limit));
        Unreachable::Range { axis: axis.name.clone(), value, by, limit, unit: axis.position_unit() }
    }

    /// The `k`-th of positions spread evenly over the axes' ranges, one turn of each rotary axis: an additive
    /// recurrence.
    pub fn spread(&self, k: u32) -> Joints {
        inverse::spread(&self.axes, k)
    }

    /// `q` with its rotary axes on every combination of whole turns within their ranges; empty if an axis has no turn
    /// there. Continuous axes keep theirs.
    pub fn turns_in_range(&self, q: &Joints) -> Vec<Joints> {
        let mut all = vec![*q];
        for (i, axis) in self.axes.iter().enumerate() {
            let Some((low, high)) = axis.range else { continue };
            if axis.kind == AxisKind::Linear {
                all.retain(|q| axis.outside(q[i]).is_none());
                continue;
            }
            let (first, last) = (((low - q[i]) / TAU).ceil() as i32, ((high - q[i]) / TAU).floor() as i32);
            let turned = |q: &Joints, k: i32| {
                let mut turned = *q;
                turned[i] = axis.turned(q[i], f64::from(k));
                turned
            };
            all = (first..=last).flat_map(|k| all.iter().map(move |q| turned(q, k))).collect();
        }
        all
    }

    /// `q` with rotary axes turned by whole turns into their ranges, where that is possible.
    pub fn turned_into_range(&self, q: &Joints) -> Joints {
        let mut turned = *q;
        for (value, axis) in turned.iter_mut().zip(&self.axes) {
            if let (AxisKind::Rotary, Some((low, high))) = (axis.kind, axis.range) {
                let turns = if *value < low { ((low - *value) / TAU).ceil() } else { -((*value - high) / TAU).ceil() };
                let there = axis.turned(*value, turns);
                if (*value < low || *value > high) && there >= low && there <= high {
                    *value = there;
                }
            }
        }
        turned
    }

    /// The first axis whose position in `q` is outside its range.
    pub fn outside(&self, q: &Joints) -> Option<RangeViolation> {
        self.axes
            .iter()
            .zip(q)
            .enumerate()
            .find_map(|(axis, (a, &value))| a.outside(value).map(|limit| RangeViolation { axis, value, limit }))
    }
}
