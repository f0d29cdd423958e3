use super::super::Error;
use crate::eyes::{Appearance, Eye, Random, SeamLine};
use crate::frames::FrameSource;
use crate::teach::Midline;
use glam::{DAffine3, DVec2, DVec3};
use seamwright_geometry::HeightTable;
use seamwright_machine::{Joints, Machine, Sensor, Sight};
use seamwright_tracking::beam::Point;
use seamwright_tracking::lead::SeamFrame;
use seamwright_tracking::teach::Aim;

/// From where a frame is taken.
#[derive(Debug, Clone, Copy)]
pub struct Glance<'a> {
    /// When, s.
    pub t_s: f64,
    /// Where the axes are.
    pub axes: &'a Joints,
    /// The torch's frame: its tip as it is, its directions as they were taught there.
    pub torch: SeamFrame,
    /// Path length of the torch on the taught seam, mm.
    pub s_mm: f64,
    /// Where the joint is looked for from: ahead of the torch, mm, and how far aside it should be, if that is known.
    pub from: (f64, Option<f64>),
}

/// What a frame shows.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shown {
    /// Points of the joint's midline in the torch's frame, from the nearest on.
    pub points: Vec<Point>,
    /// How much higher the work lies on the beam's axis than it was taught, mm.
    pub height_mm: f64,
}

/// What shows the joint ahead of the beam.
pub trait BeamEye {
    /// A frame.
    ///
    /// # Errors
    /// A frame that cannot be had.
    fn glance(&mut self, glance: &Glance<'_>) -> Result<Shown, Error>;
}

/// Points with seeded noise, straight from where the seam is: for many welds.
pub struct Offsets<'a> {
    actual: &'a SeamLine,
    random: Random,
    /// Standard deviation of a point, mm, and of what all points of a frame share.
    pub noise_mm: [f64; 2],
    /// Part of all points that lies anywhere within 3 mm.
    pub outliers: f64,
    /// Stretches of the seam that tacks hide, mm.
    pub tacks: Vec<(f64, f64)>,
}

/// Greatest error of a height that focus finds, mm.
const HEIGHT_MM: f64 = 0.03;
/// Points of a frame: how far apart, and to where to both sides, mm.
const EVERY_MM: f64 = 1.0;
const REACH: i32 = 24;

impl<'a> Offsets<'a> {
    /// Of the `actual` seam: 0.03 mm of noise, 0.01 mm more that a frame's points share, 2 % outliers.
    #[must_use]
    pub fn new(actual: &'a SeamLine, seed: u64) -> Self {
        let random = Random::new(seed ^ 0x0ff5_e700_0000_0001);
        Self { actual, random, noise_mm: [0.03, 0.01], outliers: 0.02, tacks: Vec::new() }
    }
}

impl BeamEye for Offsets<'_> {
    fn glance(&mut self, glance: &Glance<'_>) -> Result<Shown, Error> {
        let SeamFrame { point: tip, along, lateral, .. } = glance.torch;
        let shared = self.noise_mm[1] * self.random.normal();
        let off = |way: f64| self.actual.at(way).0.point - tip;
        // The place of the seam that is so far ahead of the tip, found from another.
        let place = |from: f64, along_mm: f64| {
            let mut way = from;
            for _ in 0..6 {
                way += along_mm - off(way).dot(along);
            }
            way
        };
        let foot = self.actual.foot(tip).map_or(glance.s_mm, |foot| foot.way);
        let height_mm = off(place(foot, 0.0)).dot(glance.torch.height) + HEIGHT_MM * self.random.within(-1.0, 1.0);
        let mut points = Vec::new();
        for k in -REACH..=REACH {
            let along_mm = EVERY_MM * f64::from(k);
            let way = place(foot + along_mm, along_mm);
            if !(0.0..=self.actual.length()).contains(&way) && !self.actual.is_closed() {
                continue;
            }
            if self.tacks.iter().any(|(from, to)| (*from..*to).contains(&way)) {
                continue;
            }
            let out = self.random.chance(self.outliers);
            let error = if out { self.random.within(-3.0, 3.0) } else { self.noise_mm[0] * self.random.normal() };
            points.push(Point { along_mm, lateral_mm: off(way).dot(lateral) + error + shared, confidence: 0.95 });
        }
        Ok(Shown { points, height_mm })
    }
}

/// Real pixels: the frame that the machine's beam would see, and the midline that a follower finds in it.
pub struct Pixels<'a, M> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    table: &'a HeightTable,
    eye: Eye<'a>,
    midline: M,
}

/// How far to each side the joint is looked for where nothing is known, and in what steps, mm.
const SEARCH: (i32, f64) = (5, 1.0);
/// Rows of a midline that make a point: neighbours see the same pixels.
const ROWS: usize = 10;

impl<'a, M: Midline> Pixels<'a, M> {
    /// The machine's first camera over the `actual` seam, and what finds the joint in its frames.
    ///
    /// # Errors
    /// [`Error::NoEye`] without a camera.
    pub fn new(
        machine: &'a Machine,
        (actual, appearance): (SeamLine, Appearance),
        midline: M,
        seed: u64,
    ) -> Result<Self, Error> {
        let cameras = machine.sensors.iter().filter_map(|sensor| match &sensor.sight {
            Sight::Camera(camera) => Some((sensor, &camera.table)),
            Sight::Stripe(_) => None,
        });
        let none = || Error::NoEye { machine: machine.name.clone() };
        let (sensor, table) = cameras.into_iter().next().ok_or_else(none)?;
        let eye = Eye::new(machine, sensor, actual, appearance, seed).ok_or_else(none)?;
        Ok(Self { machine, sensor, table, eye, midline })
    }

    /// The torch's place `along` mm ahead and `aside` mm to the side, in pixels.
    fn px(&self, camera: &DAffine3, torch: &SeamFrame, height: f64, [along, aside]: [f64; 2]) -> Option<DVec2> {
        let point = torch.point + along * torch.along + aside * torch.lateral;
        let in_camera = camera.inverse().transform_point3(point);
        self.table.to_px(DVec3::new(in_camera.x, in_camera.y, height)).ok()
    }
}

impl<M: Midline> BeamEye for Pixels<'_, M> {
    fn glance(&mut self, glance: &Glance<'_>) -> Result<Shown, Error> {
        self.eye.expose(glance.t_s, glance.axes);
        let frame = self.eye.next().map_err(|e| Error::Frame(e.to_string()))?;
        let Some(frame) = frame else { return Ok(Shown::default()) };
        let picture = frame.image.frame().map_err(|e| Error::Frame(e.to_string()))?;
        let camera = self.machine.camera_frame(self.sensor, glance.axes);
        let height = frame.height_mm.unwrap_or(0.0);
        let (from, known) = glance.from;
        let (steps, step) = SEARCH;
        let asides: Vec<f64> = match known {
            Some(aside) => vec![aside],
            None => (-steps..=steps).map(|k| step * f64::from(k)).collect(),
        };
        let rows = asides.into_iter().filter_map(|aside| {
            let start = self.px(&camera, &glance.torch, height, [from, aside])?;
            let ahead = self.px(&camera, &glance.torch, height, [from + 1.0, aside])?;
            let direction = (ahead - start).try_normalize()?;
            Some(self.midline.find(&picture, &Aim { start, direction }).rows)
        });
        let sure = |rows: &Vec<seamwright_tracking::teach::Row>| rows.iter().map(|row| row.confidence).sum::<f64>();
        let rows = rows.max_by(|a, b| sure(a).total_cmp(&sure(b))).unwrap_or_default();
        let torch = &glance.torch;
        let point = |row: &seamwright_tracking::teach::Row| {
            let point = camera.transform_point3(self.table.to_point(row.px, height).ok()?);
            let off = point - torch.point;
            let (along_mm, lateral_mm) = (off.dot(torch.along), off.dot(torch.lateral));
            Some(Point { along_mm, lateral_mm, confidence: row.confidence.clamp(0.0, 1.0) })
        };
        let points = rows.iter().filter(|row| row.seen).step_by(ROWS).filter_map(point).collect();
        // The camera's z goes away from it, and begins at the torch's tip.
        let on_axis = camera.transform_point3(DVec3::Z * height) - torch.point;
        Ok(Shown { points, height_mm: on_axis.dot(torch.height) })
    }
}
