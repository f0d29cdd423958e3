//! Simulated stripe sensors: the camera image of a laser stripe across a joint of known cross-section, with
//! disturbances. The truth comes from the cross-section alone.

mod acceptance;
mod disturbance;
mod paint;
mod section;

pub use acceptance::{STEPS_A_SEED, StripeErrors, confident_nowhere, stripe_gates, stripe_scene, stripe_task};
pub use disturbance::StripeDisturbances;
pub use section::{Placement, Section, Truth};

use super::random::Random;
use glam::DVec2;
use paint::Painter;
use seamwright_geometry::Homography;
use seamwright_vision::Image;

/// A simulated stripe sensor and the section before it.
#[derive(Debug, Clone, PartialEq)]
pub struct StripeScene {
    /// The true cross-section.
    pub section: Section,
    /// Pose of the section.
    pub placement: Placement,
    /// Other surfaces that the laser meets than those of the section, as lines of points in the sensor's frame, mm.
    pub surfaces: Option<Vec<Vec<DVec2>>>,
    /// Columns and rows of the image.
    pub size_px: [usize; 2],
    /// Map from (column, row) to (y, z), mm.
    pub to_mm: Homography,
    /// Height of the laser over the sensor's origin, mm.
    pub laser_height: f64,
}

/// Image of the sensor with its truth.
#[derive(Debug, Clone, PartialEq)]
pub struct StripeImage {
    /// The image.
    pub image: Image,
    /// True row of the stripe's centre per column; `None` where the stripe is missing or drawn elsewhere.
    pub rows: Vec<Option<f64>>,
    /// Truth of the joint.
    pub truth: Truth,
}

impl StripeScene {
    /// Creates a section before a sensor of `size_px` whose pixels are all `mm_per_px` wide and high, the laser 150
    /// mm above.
    pub fn new(section: Section, placement: Placement, size_px: [usize; 2], mm_per_px: f64) -> Self {
        let [x, y] = size_px.map(|n| mm_per_px * (n as f64 - 1.0) / 2.0);
        let to_mm = Homography::from_eight([mm_per_px, 0.0, -x, 0.0, -mm_per_px, y, 0.0, 0.0]);
        let to_mm = to_mm.unwrap_or(Homography::IDENTITY);
        Self { section, placement, surfaces: None, size_px, to_mm, laser_height: 150.0 }
    }

    /// Creates a scene of any surfaces in the sensor's frame; the truth of its images has no joint.
    pub fn of_surfaces(surfaces: Vec<Vec<DVec2>>, size_px: [usize; 2], mm_per_px: f64) -> Self {
        Self { surfaces: Some(surfaces), ..Self::new(Section::Plate, Placement::default(), size_px, mm_per_px) }
    }

    /// Returns the image under `disturbances`.
    pub fn image(&self, disturbances: &StripeDisturbances, seed: u64) -> StripeImage {
        let truth = self.section.truth(&self.placement);
        let mut painter = Painter::new(self, disturbances, Random::new(seed));
        let rows = painter.stripe(truth.dark);
        StripeImage { image: painter.finish(), rows, truth }
    }

    /// Returns the profile in mm, as from a sensor that finds the stripe itself: with noise (mm, standard deviation),
    /// a share of the columns as outliers and a share missing (NaN).
    pub fn profile(&self, noise: f64, outliers: f64, missing: f64, seed: u64) -> Vec<DVec2> {
        let random = &mut Random::new(seed);
        let lit = self.lit_rows();
        let mut place = |(column, row): (usize, &Option<f64>)| {
            if random.chance(missing) {
                return DVec2::NAN;
            }
            let at = row.and_then(|row| self.to_mm.map(DVec2::new(column as f64, row)));
            let wild = random.within(-20.0, 20.0);
            let z = if random.chance(outliers) { wild } else { noise * random.normal() };
            at.map_or(DVec2::NAN, |p| p + DVec2::new(0.0, z))
        };
        lit.iter().enumerate().map(&mut place).collect()
    }

    /// Returns the row of the stripe in each column: the highest point there that the laser reaches.
    pub fn lit_rows(&self) -> Vec<Option<f64>> {
        self.lit_at(1)
    }

    /// Returns the same at `parts` positions of every column, from left to right.
    fn lit_at(&self, parts: usize) -> Vec<Option<f64>> {
        let to_px = self.to_mm.inverse();
        let surfaces = self.surfaces.clone().unwrap_or_else(|| self.section.surfaces(&self.placement));
        let edges: Vec<[DVec2; 2]> = surfaces.iter().flat_map(|l| l.windows(2).map(|w| [w[0], w[1]])).collect();
        let seen = |e: &[DVec2; 2]| Some([to_px.map(e[0])?, to_px.map(e[1])?]);
        let seen: Vec<[DVec2; 2]> = edges.iter().filter_map(seen).collect();
        let laser = DVec2::new(0.0, self.laser_height);
        let row = |place: usize| {
            let x = (place as f64 + 0.5) / parts as f64 - 0.5;
            let hits = seen.iter().filter_map(|[a, b]| {
                let t = (x - a.x) / (b.x - a.x);
                let row = a.y + t * (b.y - a.y);
                ((0.0..=1.0).contains(&t) && (-100.0..1e5).contains(&row)).then_some(row)
            });
            let lit = hits.filter(|&row| {
                let p = self.to_mm.map(DVec2::new(x, row));
                p.is_some_and(|p| edges.iter().all(|e| !blocks(e, p, laser)))
            });
            lit.reduce(f64::min).filter(|row| (0.0..self.size_px[1] as f64 - 1.0).contains(row))
        };
        (0..parts * self.size_px[0]).map(row).collect()
    }
}

/// Returns true if the edge blocks the laser on its way to `p`.
fn blocks(edge: &[DVec2; 2], p: DVec2, laser: DVec2) -> bool {
    let (d, e) = (laser - p, edge[1] - edge[0]);
    let cross = d.perp_dot(e);
    let (t, u) = ((edge[0] - p).perp_dot(e) / cross, (edge[0] - p).perp_dot(d) / cross);
    // Excludes the edge on which `p` lies.
    t > 1e-6 && t < 1.0 && (0.0..=1.0).contains(&u)
}
