//! The machine that carries the camera.

use crate::events::CameraPose;
use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine, Sensor, Surroundings};
use seamwright_message::{Message, Unit};

/// Number of steps in which axis positions for a camera pose are found.
const STEPS: usize = 40;
/// Maximum distance of the optical axis from its target, mm.
const THERE_MM: f64 = 1e-3;
/// Cosine of half the angle by which the camera may deviate without another step.
const TURNED: f64 = 1.0 - 1e-9;
/// Remaining distance on machines that only approximate a direction, mm: the next frame shows the true pose.
const NEAR_MM: f64 = 0.5;
/// Spacing of checked positions of a move: mm or degrees of the axis that moves furthest.
const LOOKED_AT: f64 = 2.0;

/// Position of redundant axes for a point of the work: near those of a plan.
pub type Guide<'a> = &'a dyn Fn(DVec3) -> Option<Joints>;

/// A machine with its camera, its surroundings, and its axis positions.
pub struct Carrier<'a> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    around: &'a Surroundings<'a>,
    guide: Option<Guide<'a>>,
    axes: Joints,
    /// Height of the work in the camera's frame at which the camera sees best, mm.
    height: f64,
    /// True if the way here is checked: the first move starts from wherever the operator has jogged to.
    watched: bool,
}

impl<'a> Carrier<'a> {
    /// Creates the machine at `axes`. A `guide` gives the positions of redundant axes.
    pub fn new(
        machine: &'a Machine,
        sensor: &'a Sensor,
        around: &'a Surroundings<'a>,
        guide: Option<Guide<'a>>,
        axes: Joints,
    ) -> Self {
        Self { machine, sensor, around, guide, axes, height: 0.0, watched: false }
    }

    /// Returns the positions of the axes.
    pub fn axes(&self) -> &Joints {
        &self.axes
    }

    /// Sets the true positions of the axes, independent of the commanded ones.
    pub fn stands(&mut self, axes: Joints) {
        self.axes = axes;
    }

    /// Returns the time between a frame with the axes at `from` and one here, s: whole periods of the camera in which
    /// the slowest axis goes the way at half its speed.
    pub fn pause_s(&self, from: &Joints) -> f64 {
        let axes = self.machine.axes.iter().zip(from.iter().zip(&self.axes));
        let slowest = axes.map(|(axis, (a, b))| 2.0 * (b - a).abs() / axis.max_speed).fold(0.0, f64::max);
        self.sensor.period_s * (slowest / self.sensor.period_s).ceil().max(1.0)
    }

    /// Moves the axes, straight in axis space, so that the optical axis passes through `pose.point`. The camera looks
    /// against the normal as well as the machine can, with the point at the best height.
    ///
    /// # Errors
    /// No such positions, an axis' range, the pair that would come too near.
    pub fn to(&mut self, pose: &CameraPose) -> Result<(), Message> {
        let axes = self.positions(pose)?;
        if let Some(why) = self.too_near(&axes) {
            return Err(why);
        }
        (self.axes, self.watched) = (axes, true);
        Ok(())
    }

    /// Returns the axis positions that bring the camera there, within their ranges; the way is not checked.
    ///
    /// # Errors
    /// No such positions, an axis' range.
    pub fn positions(&self, pose: &CameraPose) -> Result<Joints, Message> {
        let axes = self.solve(pose)?;
        match self.machine.outside(&axes) {
            Some(v) => Err(self.machine.range_error(&v).message()),
            None => Ok(axes),
        }
    }

    /// Solves for positions that bring the camera there. The inverse kinematics handle torches: the torch is moved by
    /// the camera's error until the camera is in place.
    fn solve(&self, pose: &CameraPose) -> Result<Joints, Message> {
        let guided = self.guide.and_then(|guide| guide(pose.point));
        let mut q = guided.unwrap_or(self.axes);
        for _ in 0..STEPS {
            let camera = self.machine.camera_frame(self.sensor, &q);
            let torch = self.machine.forward(&q);
            let at = camera.transform_point3(DVec3::Z * self.height);
            let off = pose.point - at;
            let turn = DQuat::from_rotation_arc(camera.transform_vector3(DVec3::Z), -pose.normal);
            if off.length() < THERE_MM && turn.w.abs() > TURNED {
                return Ok(self.machine.turned_into_range(&q));
            }
            // Shifts and turns separately: a machine with too few axes turns as far as it can, and the position is
            // still reached.
            let pose = Pose { point: torch.point + off, direction: (turn * torch.direction).normalize() };
            let next = self.machine.inverse_near(pose, &q).map_err(|e| e.message())?.joints;
            let stands = next.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-6);
            q = next;
            if stands {
                break;
            }
        }
        let at = self.machine.camera_frame(self.sensor, &q).transform_point3(DVec3::Z * self.height);
        let off = at.distance(pose.point);
        if off < NEAR_MM {
            return Ok(self.machine.turned_into_range(&q));
        }
        Err(Message::new("cell-camera-out-of-reach").quantity("remaining", off, Unit::Mm, 2))
    }

    /// Returns the pair that comes too near on the way to `axes`.
    fn too_near(&self, axes: &Joints) -> Option<Message> {
        let machine = &self.machine.axes;
        let way = |(axis, (from, to)): (&seamwright_machine::Axis, (&f64, &f64))| {
            (axis.to_file(*to) - axis.to_file(*from)).abs()
        };
        let far = machine.iter().zip(self.axes.iter().zip(axes)).map(way).fold(0.0, f64::max);
        let steps = if self.watched { (far / LOOKED_AT).ceil().max(1.0) } else { 1.0 };
        (1..=steps as u32).find_map(|k| {
            let part = f64::from(k) / steps;
            let from = if self.watched { &self.axes } else { axes };
            let at: Joints = std::array::from_fn(|i| from[i] + part * (axes[i] - from[i]));
            if self.around.is_clear(&at) {
                return None;
            }
            let nearest = self.around.nearest(&at, self.around.greatest_least_mm() + 1.0);
            Some(match nearest.map(|(watch, _)| self.around.bodies(watch)) {
                Some((a, b)) => Message::new("cell-too-close").message("a", a).message("b", b),
                None => Message::new("cell-something-too-close"),
            })
        })
    }
}
