//! The machine that carries the eye.

use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine, Sensor, Surroundings};
use seamwright_tracking::teach::EyePose;

/// Steps in which axes are found that bring the eye somewhere.
const STEPS: usize = 40;
/// The eye is there when its axis passes so near, mm.
const THERE_MM: f64 = 1e-3;
/// Cosine of half the angle by which it may look elsewhere without another step.
const TURNED: f64 = 1.0 - 1e-9;
/// What may remain on machines that only come near to a direction, mm: the next frame shows where the eye truly is.
const NEAR_MM: f64 = 0.5;
/// Places at which a move is looked at: every so many mm or degrees of the axis that goes furthest.
const LOOKED_AT: f64 = 2.0;

/// Where axes to spare should be for a point of the work: near those of a plan.
pub type Guide<'a> = &'a dyn Fn(DVec3) -> Option<Joints>;

/// A machine with its eye, what is around it, and where its axes are.
pub struct Carrier<'a> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    around: &'a Surroundings<'a>,
    guide: Option<Guide<'a>>,
    axes: Joints,
    /// Height of the work in the camera's frame at which the eye sees best, mm.
    height: f64,
    /// Whether the way here is watched: the first move comes from wherever the operator has jogged to.
    watched: bool,
}

impl<'a> Carrier<'a> {
    /// The machine at `axes`. A `guide` says where axes to spare should be.
    pub fn new(
        machine: &'a Machine,
        sensor: &'a Sensor,
        around: &'a Surroundings<'a>,
        guide: Option<Guide<'a>>,
        axes: Joints,
    ) -> Self {
        Self { machine, sensor, around, guide, axes, height: 0.0, watched: false }
    }

    /// Positions of the axes.
    pub fn axes(&self) -> &Joints {
        &self.axes
    }

    /// The axes are at `axes`, wherever they were sent.
    pub fn stands(&mut self, axes: Joints) {
        self.axes = axes;
    }

    /// Moves the axes so that the eye's optical axis passes through `eye.point`, against its normal as well as the machine
    /// can, the point at the height where the eye sees best. Straight in the axes.
    ///
    /// # Errors
    /// In words: no such positions, an axis' range, what would come too near to what.
    pub fn to(&mut self, eye: &EyePose) -> Result<(), String> {
        let axes = self.positions(eye)?;
        if let Some(why) = self.too_near(&axes) {
            return Err(why);
        }
        (self.axes, self.watched) = (axes, true);
        Ok(())
    }

    /// Positions of the axes that bring the eye there, within their ranges; the way to them is not looked at.
    ///
    /// # Errors
    /// In words: no such positions, an axis' range.
    pub fn positions(&self, eye: &EyePose) -> Result<Joints, String> {
        let axes = self.solve(eye)?;
        match self.machine.outside(&axes) {
            Some(v) => Err(self.machine.range_error(&v).to_string()),
            None => Ok(axes),
        }
    }

    /// Positions that bring the eye there. The inverse knows torches: the torch is put where it was last seen from the eye,
    /// and again, until the eye is where it should be.
    fn solve(&self, eye: &EyePose) -> Result<Joints, String> {
        let guided = self.guide.and_then(|guide| guide(eye.point));
        let mut q = guided.unwrap_or(self.axes);
        for _ in 0..STEPS {
            let camera = self.machine.camera_frame(self.sensor, &q);
            let torch = self.machine.forward(&q);
            let at = camera.transform_point3(DVec3::Z * self.height);
            let off = eye.point - at;
            let turn = DQuat::from_rotation_arc(camera.transform_vector3(DVec3::Z), -eye.normal);
            if off.length() < THERE_MM && turn.w.abs() > TURNED {
                return Ok(self.machine.turned_into_range(&q));
            }
            // Shifted and turned apart: a machine with too few axes turns as far as it can, and the place still comes true.
            let pose = Pose { point: torch.point + off, direction: (turn * torch.direction).normalize() };
            let next = self.machine.inverse_near(pose, &q).map_err(|e| e.to_string())?.joints;
            let stands = next.iter().zip(&q).all(|(a, b)| (a - b).abs() < 1e-6);
            q = next;
            if stands {
                break;
            }
        }
        let at = self.machine.camera_frame(self.sensor, &q).transform_point3(DVec3::Z * self.height);
        let off = at.distance(eye.point);
        if off < NEAR_MM {
            return Ok(self.machine.turned_into_range(&q));
        }
        Err(format!("no positions of the axes bring the eye there: {off:.2} mm remain"))
    }

    /// What comes too near to what on the way to `axes`.
    fn too_near(&self, axes: &Joints) -> Option<String> {
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
            let names = nearest.map(|(watch, _)| self.around.names(watch));
            Some(names.map_or("something comes too near".to_owned(), |(a, b)| format!("{a} comes too near to {b}")))
        })
    }
}
