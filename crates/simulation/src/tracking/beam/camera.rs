use crate::camera_simulator::{Appearance, CameraSimulator, Random};
use crate::error::Error;
use crate::tracking::world::World;
use glam::{DAffine3, DVec2, DVec3};
use seamwright_executive::tracking;
use seamwright_frames::FrameSource;
use seamwright_geometry::HeightTable;
use seamwright_machine::{Joints, Machine, Sensor};
use seamwright_teaching::{Aim, Midline, SeamLine};
use seamwright_tracking::beam::Point;
use seamwright_tracking::lead::SeamFrame;

/// Position from which a frame is taken.
#[derive(Debug, Clone, Copy)]
pub struct Glance<'a> {
    /// Time, s.
    pub t_s: f64,
    /// Positions of the axes.
    pub axes: &'a Joints,
    /// The torch's frame: true tip, taught directions.
    pub torch: SeamFrame,
    /// Path length of the torch on the taught seam, mm.
    pub s_mm: f64,
    /// Start of the search for the joint: ahead of the torch, mm, and the expected distance aside, if known.
    pub from: (f64, Option<f64>),
}

/// Content of a frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shown {
    /// Points of the joint's midline in the torch's frame, from the nearest on.
    pub points: Vec<Point>,
    /// Height of the work on the beam's axis above the taught one, mm.
    pub height_mm: f64,
}

/// Shows the joint ahead of the beam.
pub trait BeamCamera {
    /// Takes a frame into `shown`, which is empty before. Errors: a frame that is not available.
    fn glance(&mut self, glance: &Glance<'_>, shown: &mut Shown) -> Result<(), Error>;
}

/// True position of a seam, hidden from tracking.
pub(crate) trait Hidden {
    /// Intersects the seam with the plane square to the torch's way, `along_mm` ahead of the tip. Returns lateral and
    /// height from there, mm, and whether a joint is visible; `None` without an intersection within reach.
    fn crossing(&self, glance: &Glance<'_>, along_mm: f64) -> Option<(DVec2, bool)>;
}

/// Seeded measurement errors.
#[derive(Debug, Clone)]
pub struct Noise {
    random: Random,
    /// Standard deviations, mm: of a point, and of the error that all points of a frame share.
    pub noise_mm: [f64; 2],
    /// Share of points that lie anywhere within 3 mm.
    pub outliers: f64,
}

/// Maximum error of a height found by focus, mm.
const HEIGHT_MM: f64 = 0.03;
/// Spacing of the points of a frame, and their reach to both sides, mm.
const EVERY_MM: f64 = 1.0;
const REACH: i32 = 24;
/// Maximum number of points of a frame.
pub(super) const POINTS: usize = 2 * REACH as usize + 1;
/// Error that all points of a frame share, relative to a point's own noise.
const SHARED: f64 = 1.0 / 3.0;

impl Noise {
    /// Creates noise of each point (mm), a third as much that a frame's points share, and 2 % outliers.
    pub(crate) fn new(noise_mm: f64, seed: u64) -> Self {
        let random = Random::new(seed ^ 0x0ff5_e700_0000_0001);
        Self { random, noise_mm: [noise_mm, SHARED * noise_mm], outliers: 0.02 }
    }

    /// Writes a frame of a hidden seam into `shown`.
    pub(crate) fn show(&mut self, seam: &dyn Hidden, glance: &Glance<'_>, shown: &mut Shown) {
        let shared = self.noise_mm[1] * self.random.normal();
        let height = HEIGHT_MM * self.random.within(-1.0, 1.0);
        shown.height_mm = seam.crossing(glance, 0.0).map_or(0.0, |(off, _)| off.y) + height;
        for k in -REACH..=REACH {
            let along_mm = EVERY_MM * f64::from(k);
            let Some((off, true)) = seam.crossing(glance, along_mm) else { continue };
            let out = self.random.chance(self.outliers);
            let error = if out { self.random.within(-3.0, 3.0) } else { self.noise_mm[0] * self.random.normal() };
            shown.points.push(Point { along_mm, lateral_mm: off.x + error + shared, confidence: 0.95 });
        }
    }
}

/// Points with noise, directly from the true seam: for many welds.
pub struct Offsets<'a> {
    actual: &'a SeamLine,
    /// Stretches of the seam that tacks hide, mm.
    pub tacks: Vec<(f64, f64)>,
    /// Errors of the points.
    pub noise: Noise,
}

impl<'a> Offsets<'a> {
    /// Creates points of the `actual` seam: 0.03 mm of noise, 0.01 mm more that a frame's points share, 2 % outliers.
    #[must_use]
    pub fn new(actual: &'a SeamLine, seed: u64) -> Self {
        Self { actual, tacks: Vec::new(), noise: Noise::new(0.03, seed) }
    }
}

impl BeamCamera for Offsets<'_> {
    fn glance(&mut self, glance: &Glance<'_>, shown: &mut Shown) -> Result<(), Error> {
        self.noise.show(&Line { actual: self.actual, tacks: &self.tacks }, glance, shown);
        Ok(())
    }
}

/// A seam given by its stations.
struct Line<'a> {
    actual: &'a SeamLine,
    tacks: &'a [(f64, f64)],
}

impl Hidden for Line<'_> {
    fn crossing(&self, glance: &Glance<'_>, along_mm: f64) -> Option<(DVec2, bool)> {
        let SeamFrame { point: tip, along, lateral, height } = glance.torch;
        let off = |way: f64| self.actual.at(way).0.point - tip;
        let mut way = self.actual.foot(tip).map_or(glance.s_mm, |foot| foot.way) + along_mm;
        for _ in 0..6 {
            way += along_mm - off(way).dot(along);
        }
        let there = (0.0..=self.actual.length()).contains(&way) || self.actual.is_closed();
        let tacked = self.tacks.iter().any(|(from, to)| (*from..*to).contains(&way));
        Some((DVec2::new(off(way).dot(lateral), off(way).dot(height)), there && !tacked))
    }
}

/// The world's seam while the pool is at the torch.
impl Hidden for World<'_> {
    fn crossing(&self, glance: &Glance<'_>, along_mm: f64) -> Option<(DVec2, bool)> {
        let taught = (self.taught)(glance.s_mm);
        let off = glance.torch.point - taught.point;
        let (seam, place) = World::crossing(self, glance.s_mm, along_mm + off.dot(taught.along), glance.s_mm)?;
        let beside = DVec2::new(off.dot(taught.lateral), off.dot(taught.height));
        Some((seam - beside, self.has(place) && !self.displacement.is_tacked(self.along.place(place))))
    }
}

/// Real pixels: the frame that the machine's beam would see, and the midline that a follower finds in it.
pub struct Pixels<'a, M> {
    machine: &'a Machine,
    sensor: &'a Sensor,
    table: &'a HeightTable,
    camera: CameraSimulator<'a>,
    midline: M,
}

/// Number of search steps to each side if the position is unknown, and their length, mm.
const SEARCH: (i32, f64) = (5, 1.0);
/// Rows of a midline per point: neighbours see the same pixels.
const ROWS: usize = 10;

impl<'a, M: Midline> Pixels<'a, M> {
    /// Creates the machine's first camera over the `actual` seam, and the finder of the joint in its frames.
    ///
    /// # Errors
    /// [`tracking::Error::NoCamera`] without a camera.
    pub fn new(
        machine: &'a Machine,
        actual: SeamLine,
        appearance: Appearance,
        midline: M,
        seed: u64,
    ) -> Result<Self, Error> {
        let none = || tracking::Error::NoCamera { machine: machine.name.clone() };
        let (sensor, table) = machine.cameras().next().ok_or_else(none)?;
        let camera = CameraSimulator::new(machine, sensor, actual, appearance, seed).ok_or_else(none)?;
        Ok(Self { machine, sensor, table, camera, midline })
    }

    /// Returns the point `along` mm ahead of the torch and `aside` mm to the side, in pixels.
    fn px(&self, camera: &DAffine3, torch: &SeamFrame, height: f64, [along, aside]: [f64; 2]) -> Option<DVec2> {
        let point = torch.point + along * torch.along + aside * torch.lateral;
        let in_camera = camera.inverse().transform_point3(point);
        self.table.to_px(DVec3::new(in_camera.x, in_camera.y, height)).ok()
    }
}

impl<M: Midline> BeamCamera for Pixels<'_, M> {
    fn glance(&mut self, glance: &Glance<'_>, shown: &mut Shown) -> Result<(), Error> {
        self.camera.expose(glance.t_s, glance.axes);
        let frame = self.camera.next().map_err(|e| Error::Frame(e.message()))?;
        let Some(frame) = frame else { return Ok(()) };
        let picture = frame.image.frame().map_err(|e| Error::Frame(e.message()))?;
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
            Some(self.midline.find(&picture, &Aim { start, direction, by_hand: false }).rows)
        });
        let sure = |rows: &Vec<seamwright_teaching::Row>| rows.iter().map(|row| row.confidence).sum::<f64>();
        let rows = rows.max_by(|a, b| sure(a).total_cmp(&sure(b))).unwrap_or_default();
        let torch = &glance.torch;
        let point = |row: &seamwright_teaching::Row| {
            let point = camera.transform_point3(self.table.to_point(row.px, height).ok()?);
            let off = point - torch.point;
            let (along_mm, lateral_mm) = (off.dot(torch.along), off.dot(torch.lateral));
            Some(Point { along_mm, lateral_mm, confidence: row.confidence.clamp(0.0, 1.0) })
        };
        shown.points.extend(rows.iter().filter(|row| row.seen).step_by(ROWS).filter_map(point));
        // The camera's z points away from it and starts at the torch's tip.
        let on_axis = camera.transform_point3(DVec3::Z * height) - torch.point;
        shown.height_mm = on_axis.dot(torch.height);
        Ok(())
    }
}
