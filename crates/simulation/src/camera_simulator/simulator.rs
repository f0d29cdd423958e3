//! The camera simulator: frames of the actual seam from the machine's true pose.

use super::random::Random;
use super::scene::{Canvas, Disturbances, Texture};
use glam::{DAffine3, DVec2, DVec3};
use seamwright_frames::{FrameError, FrameSource, TimedFrame};
use seamwright_geometry::HeightTable;
use seamwright_machine::{Joints, Machine, Sensor, Sight};
use seamwright_teaching::{SeamLine, Station};
use seamwright_vision::Image;
use std::collections::VecDeque;

/// The camera does not see a surface that is tilted away by more than 75 degrees (minimum cosine).
const FACING: f64 = 0.26;
/// Number of steps along the optical axis to the surface.
const STEPS: usize = 8;

/// Appearance of the work.
#[derive(Debug, Clone, PartialEq)]
pub struct Appearance {
    /// Width of the joint, mm: full width at half of its depth.
    pub width_mm: f64,
    /// Stretches of the seam (path lengths, mm) where a tack hides the joint.
    pub tacks: Vec<(f64, f64)>,
    /// Maximum error of a height found by focus, mm; `None`: heights are not measured.
    pub height_error_mm: Option<f64>,
    /// Grey value of the metal, 0 to 255.
    pub metal: f64,
    /// Darkness of the joint relative to the metal, grey values.
    pub contrast: f64,
    /// Disturbances of a frame.
    pub disturbances: Disturbances,
}

impl Default for Appearance {
    fn default() -> Self {
        // A ground surface in uneven light: contrast to noise 5.
        let disturbances = Disturbances {
            noise: 8.0,
            ramp: [12.0, -8.0],
            vignette: 20.0,
            texture: Texture { deviation: 4.0, direction: 0.4 },
            jitter: 0.2,
            charging: 1.5,
            salt: 0.001,
            defocus: 0,
        };
        let (tacks, height_error_mm) = (Vec::new(), Some(0.03));
        Self { width_mm: 0.6, tacks, height_error_mm, metal: 150.0, contrast: 45.0, disturbances }
    }
}

/// A camera of a machine, and the actual seam before it.
#[derive(Debug, Clone)]
pub struct CameraSimulator<'a> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    table: &'a HeightTable,
    actual: SeamLine,
    appearance: Appearance,
    random: Random,
    exposures: VecDeque<(f64, Joints)>,
}

impl<'a> CameraSimulator<'a> {
    /// Creates the camera simulator for `sensor` of `machine` over the `actual` seam; `None` if the sensor is not a
    /// camera.
    pub fn new(
        machine: &'a Machine,
        sensor: &'a Sensor,
        actual: SeamLine,
        appearance: Appearance,
        seed: u64,
    ) -> Option<Self> {
        let Sight::Camera(camera) = &sensor.sight else { return None };
        let random = Random::new(seed ^ 0xe7e5);
        Some(Self { machine, sensor, table: &camera.table, actual, appearance, random, exposures: VecDeque::new() })
    }

    /// Returns the seam that it sees: the hidden truth.
    pub fn actual(&self) -> &SeamLine {
        &self.actual
    }

    /// Requests a frame at time `t_s` with the axes at `q`.
    pub fn expose(&mut self, t_s: f64, q: &Joints) {
        self.exposures.push_back((t_s, *q));
    }

    /// Returns the height of the actual surface on the optical axis, mm in the camera's frame; `None` off the seam.
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
        let error = self.random.within(-1.0, 1.0);
        let height_mm = self.appearance.height_error_mm.and_then(|most| Some(true_height? + most * error));
        let image = self.paint(&camera, true_height.unwrap_or(0.0));
        let axes = self.machine.axes.iter().zip(q).map(|(axis, value)| axis.to_file(*value)).collect();
        TimedFrame { t_s, image, axes: Some(axes), height_mm }
    }

    /// Paints the visible part of the joint, and the tacks on it.
    fn paint(&mut self, camera: &DAffine3, height: f64) -> Image {
        let (width, rows) = self.table.size_px();
        let Appearance { width_mm, metal, contrast, ref disturbances, .. } = self.appearance;
        let mut canvas = Canvas::new(width, rows, metal);
        let mut seen = Vec::new();
        if let Ok(map) = self.table.at(height) {
            let corner = DVec2::new(width as f64, rows as f64);
            let corners = map.to_mm(DVec2::ZERO).zip(map.to_mm(corner));
            let reach = corners.map_or(100.0, |(a, b)| a.length().max(b.length()));
            let scale = map.scale_at(0.5 * corner).unwrap_or(1.0);
            for piece in self.pieces(camera, height, 1.5 * reach) {
                canvas.line(&piece, width_mm / scale, contrast, |_| 1.0);
                seen.extend(piece);
            }
            for (from, to) in &self.appearance.tacks {
                let (middle, _) = self.actual.at(0.5 * (from + to));
                if let Some(at) = self.px(camera, &middle) {
                    canvas.tack(at, 0.5 * (to - from) / scale, metal, &mut self.random);
                }
            }
        }
        canvas.finish(disturbances, &seen, 0.0, &mut self.random)
    }

    /// Returns the joint in pixels within `reach` of the centre of view: the pieces that face the camera.
    fn pieces(&self, camera: &DAffine3, height: f64, reach: f64) -> Vec<Vec<DVec2>> {
        let centre = camera.transform_point3(DVec3::Z * height);
        let mut pieces: Vec<Vec<DVec2>> = Vec::new();
        let mut before = None;
        for i in self.actual.around(centre, reach) {
            let Some(at) = self.px(camera, &self.actual.stations()[i]) else { continue };
            match pieces.last_mut().filter(|_| before.is_some_and(|before| before + 1 == i)) {
                Some(piece) => piece.push(at),
                None => pieces.push(vec![at]),
            }
            before = Some(i);
        }
        pieces
    }

    /// Returns the pixel of a point of the seam; `None` if it is tilted away.
    fn px(&self, camera: &DAffine3, station: &Station) -> Option<DVec2> {
        let facing = camera.transform_vector3(DVec3::Z).dot(station.normal) < -FACING;
        facing.then(|| self.table.to_px(camera.inverse().transform_point3(station.point)).ok()).flatten()
    }
}

impl FrameSource for CameraSimulator<'_> {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let Some((t_s, q)) = self.exposures.pop_front() else { return Ok(None) };
        Ok(Some(self.frame(t_s, &q)))
    }
}
