//! The simulated eye: frames of the actual seam from where the machine truly is.

use super::paint::{Canvas, Look};
use super::seam_line::SeamLine;
use crate::disturbance::uniform;
use crate::frames::{FrameError, FrameSource, TimedFrame};
use glam::{DAffine3, DVec2, DVec3};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use seamwright_geometry::HeightTable;
use seamwright_machine::{Joints, Machine, Sensor, Sight};
use seamwright_vision::Image;
use std::collections::VecDeque;

/// The surface is seen no longer where it is tilted away by more than 75 degrees.
const FACING: f64 = 0.26;
/// Steps along the optical axis to the surface.
const STEPS: usize = 8;

/// What the work looks like.
#[derive(Debug, Clone, PartialEq)]
pub struct Appearance {
    /// Width of the joint, mm: full width at half of its depth.
    pub width_mm: f64,
    /// Stretches of the seam (path lengths, mm) where a tack hides the joint.
    pub tacks: Vec<(f64, f64)>,
    /// Greatest error of a height that focus finds, mm; none: no heights are measured.
    pub height_error_mm: Option<f64>,
    /// Light and noise.
    pub look: Look,
}

impl Default for Appearance {
    fn default() -> Self {
        Self { width_mm: 0.6, tacks: Vec::new(), height_error_mm: Some(0.03), look: Look::default() }
    }
}

/// A camera of a machine, and the actual seam before it.
#[derive(Debug, Clone)]
pub struct Eye<'a> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    table: &'a HeightTable,
    actual: SeamLine,
    appearance: Appearance,
    random: Pcg64Mcg,
    exposures: VecDeque<(f64, Joints)>,
}

impl<'a> Eye<'a> {
    /// The eye `sensor` of `machine` over the `actual` seam; none if the sensor is no camera.
    pub fn new(
        machine: &'a Machine,
        sensor: &'a Sensor,
        actual: SeamLine,
        appearance: Appearance,
        seed: u64,
    ) -> Option<Self> {
        let Sight::Camera(camera) = &sensor.sight else { return None };
        let random = Pcg64Mcg::seed_from_u64(seed ^ 0xe7e5);
        Some(Self { machine, sensor, table: &camera.table, actual, appearance, random, exposures: VecDeque::new() })
    }

    /// The seam that it sees: the hidden truth.
    pub fn actual(&self) -> &SeamLine {
        &self.actual
    }

    /// Asks for a frame at time `t_s` with the axes at `q`.
    pub fn expose(&mut self, t_s: f64, q: &Joints) {
        self.exposures.push_back((t_s, *q));
    }

    /// Height of the actual surface on the optical axis, mm in the camera's frame; none off the seam.
    fn height(&self, camera: &DAffine3) -> Option<f64> {
        let axis = camera.transform_vector3(DVec3::Z);
        (0..STEPS).try_fold(0.0, |height, _| {
            let point = camera.transform_point3(DVec3::Z * height);
            let foot = self.actual.foot(point)?;
            let slope = axis.dot(foot.at.normal);
            (slope < -FACING).then(|| height - (point - foot.at.point).dot(foot.at.normal) / slope)
        })
    }

    fn frame(&mut self, t_s: f64, q: &Joints) -> TimedFrame {
        let camera = self.machine.camera_frame(self.sensor, q);
        let true_height = self.height(&camera);
        let error = 2.0 * uniform(&mut self.random) - 1.0;
        let height_mm = self.appearance.height_error_mm.and_then(|most| Some(true_height? + most * error));
        let size = self.table.size_px();
        let mut canvas = Canvas::new(size);
        self.draw(&camera, true_height.unwrap_or(0.0), &mut canvas);
        let pixels = canvas.finish(&self.appearance.look, &mut self.random);
        let axes = self.machine.axes.iter().zip(q).map(|(axis, value)| axis.to_file(*value)).collect();
        let image = Image::U8 { width: size.0, height: size.1, pixels };
        TimedFrame { t_s, image, axes: Some(axes), height_mm }
    }

    /// The joint's pieces that are in view, tacks left out.
    fn draw(&self, camera: &DAffine3, height: f64, canvas: &mut Canvas) {
        let back = camera.inverse();
        let axis = camera.transform_vector3(DVec3::Z);
        let (width, rows) = self.table.size_px();
        let corner = DVec2::new(width as f64, rows as f64);
        let Ok(map) = self.table.at(height) else { return };
        let reach = map.to_mm(DVec2::ZERO).zip(map.to_mm(corner)).map_or(100.0, |(a, b)| a.length().max(b.length()));
        let centre = camera.transform_point3(DVec3::Z * height);
        let px = |i: usize| {
            let station = &self.actual.stations()[i];
            let facing = axis.dot(station.normal) < -FACING;
            facing.then(|| self.table.to_px(back.transform_point3(station.point)).ok()).flatten()
        };
        let hidden = |way: f64| self.appearance.tacks.iter().any(|(from, to)| (*from..*to).contains(&way));
        let ways = self.actual.ways();
        for i in self.actual.around(centre, 1.5 * reach) {
            if i + 1 == ways.len() || hidden(ways[i]) || hidden(ways[i + 1]) {
                continue;
            }
            let (Some(a), Some(b)) = (px(i), px(i + 1)) else { continue };
            let scale = map.scale_at(0.5 * (a + b)).unwrap_or(1.0);
            canvas.line(a, b, self.appearance.width_mm / scale);
        }
    }
}

impl FrameSource for Eye<'_> {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let Some((t_s, q)) = self.exposures.pop_front() else { return Ok(None) };
        Ok(Some(self.frame(t_s, &q)))
    }
}
