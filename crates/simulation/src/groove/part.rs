use crate::camera_simulator::random::Random;
use crate::camera_simulator::stripe::{StripeDisturbances, StripeScene};
use glam::DVec2;
use seamwright_vision::Image;
use seamwright_weld::{Groove, SeamCurve, SeamJoint, SeamPoint, Section};
use std::f64::consts::{PI, TAU};

/// Extent of the faces beyond the toes, mm.
const FACE_MM: f64 = 60.0;
/// Points of the metal's surface.
const METAL_POINTS: u32 = 60;
/// Smallest root gap of a tacked part, mm.
const MIN_GAP_MM: f64 = 0.2;

/// A deviation along a closed seam: constant, tilted (once around), oval (twice around) and at tacks.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Wave {
    mean: f64,
    tilt: [f64; 2],
    oval: [f64; 2],
    /// At each tack.
    tack: f64,
}

impl Wave {
    fn random(random: &mut Random, mean: f64, tilt: f64, oval: f64, tack: f64) -> Self {
        let mut pair = |size: f64| {
            let (size, phase) = (random.within(0.3 * size, size), random.within(0.0, TAU));
            [size * phase.cos(), size * phase.sin()]
        };
        let (tilt, oval) = (pair(tilt), pair(oval));
        Self { mean: random.within(-mean, mean), tilt, oval, tack: -random.within(0.3 * tack, tack) }
    }

    /// The deviation at a part of the turn.
    fn at(&self, turn: f64, tacks: f64) -> f64 {
        let [once, twice] = [TAU * turn, 2.0 * TAU * turn].map(f64::sin_cos);
        // A tack draws the parts together over about an eighth of the way to the next one.
        let near = (0.5 + 0.5 * (TAU * tacks * turn).cos()).powi(8);
        self.mean
            + self.tilt[0] * once.1
            + self.tilt[1] * once.0
            + self.oval[0] * twice.1
            + self.oval[1] * twice.0
            + self.tack * near
    }
}

/// A part whose groove differs from the drawing along the seam: by tacks, by an oval or tilted tube, by the cut.
#[derive(Debug, Clone, PartialEq)]
pub struct DistortedPart {
    gap: Wave,
    mismatch: Wave,
    angle: Wave,
    dihedral: Wave,
    tacks: f64,
    /// Shrinkage of the gap by each layer, mm.
    shrinkage: f64,
}

impl DistortedPart {
    /// Creates the part of a seed. Gaps differ by up to about 2.5 mm from the drawing and the groove angle by up to
    /// about 4 degrees, as a shop that cuts by hand and tacks without a fixture leaves them.
    pub fn new(seed: u64) -> Self {
        let random = &mut Random::new(seed ^ 0x9700_b0e5);
        Self {
            gap: Wave::random(random, 0.9, 0.8, 0.7, 0.5),
            mismatch: Wave::random(random, 0.4, 0.4, 0.5, 0.0),
            angle: Wave::random(random, 0.04, 0.02, 0.015, 0.0),
            dihedral: Wave::random(random, 0.01, 0.02, 0.005, 0.0),
            tacks: random.whole(3, 7) as f64,
            shrinkage: random.within(0.05, 0.25),
        }
    }

    /// Returns the true groove at a station after so many layers.
    pub fn groove(&self, joint: &SeamJoint, seam: &SeamCurve, p: &SeamPoint, layers: usize) -> Groove {
        let turn = p.s / seam.length();
        let at = |wave: &Wave| wave.at(turn, self.tacks);
        let drawn = joint.groove(p);
        let butt = joint.joint().preparation.is_butt();
        // Each layer pulls less than the one before.
        let pulled = self.shrinkage * (1.0 - 0.5_f64.powi(layers as i32)) * 2.0;
        Groove {
            dihedral: drawn.dihedral + at(&self.dihedral),
            gap: (joint.joint().preparation.root_gap_mm() + at(&self.gap) - pulled).max(MIN_GAP_MM),
            mismatch: if butt { at(&self.mismatch) } else { 0.0 },
            angle: drawn.angle.map(|angle| angle + at(&self.angle)),
        }
    }
}

/// A simulated stripe sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensor {
    /// Scale, mm.
    pub mm_per_px: f64,
    /// Columns and rows.
    pub size_px: [usize; 2],
    /// Standard deviation of a point's height, mm.
    pub noise_mm: f64,
    /// Part of the columns with spatter.
    pub spatter: f64,
    /// Part of the columns without a point.
    pub missing: f64,
}

impl Sensor {
    /// A sensor of a shop on ground steel.
    pub const USUAL: Self = Self { mm_per_px: 0.1, size_px: [640, 640], noise_mm: 0.06, spatter: 0.04, missing: 0.05 };

    /// Returns the scene of a section with `metal` (mm^2) in it, whose surface has `beads` waves.
    fn scene(&self, section: &Section, metal: f64, beads: usize, random: &mut Random) -> StripeScene {
        let view = section.view();
        let turn = view.x.atan2(view.y) + random.within(-0.08, 0.08);
        let middle = 0.5 * (section.toes()[0] + section.toes()[1]);
        let at = DVec2::new(random.within(-2.0, 2.0), random.within(-2.0, 2.0));
        let to_sensor = DVec2::from_angle(turn);
        let place = |q: &DVec2| to_sensor.rotate(*q - middle) + at;
        let lines = surfaces(section, metal, beads, random.within(0.0, 0.35));
        let lines = lines.iter().map(|line| line.iter().map(place).collect()).collect();
        StripeScene::of_surfaces(lines, self.size_px, self.mm_per_px)
    }

    /// Returns the profile (y, z), mm, of a section with `metal` (mm^2) of `beads` beads at the top; y runs from the
    /// second part to the first. Missing points are not a number.
    pub fn profile(&self, section: &Section, metal: f64, beads: usize, seed: u64) -> Vec<DVec2> {
        let scene = self.scene(section, metal, beads, &mut Random::new(seed));
        scene.profile(self.noise_mm, self.spatter, self.missing, seed ^ 0x51)
    }

    /// Returns the image instead, on ground steel with speckle.
    pub fn image(&self, section: &Section, metal: f64, beads: usize, seed: u64) -> Image {
        let scene = self.scene(section, metal, beads, &mut Random::new(seed));
        scene.image(&StripeDisturbances::USUAL, seed ^ 0x51).image
    }
}

/// Surfaces of the parts from below the root to the far end of their faces, and of the metal.
fn surfaces(section: &Section, metal: f64, beads: usize, wave: f64) -> Vec<Vec<DVec2>> {
    let (sin, cos) = (0.5 * section.dihedral).sin_cos();
    let part = |edge: &[DVec2], along: DVec2| {
        let toe = edge.last().copied().unwrap_or_default();
        let root = edge.first().copied().unwrap_or_default();
        let below = root - 4.0 * section.up;
        std::iter::once(below).chain(edge.iter().copied()).chain([toe + FACE_MM * along]).collect::<Vec<_>>()
    };
    let mut lines = vec![part(&section.second, DVec2::new(-sin, cos)), part(&section.first, DVec2::new(sin, cos))];
    if metal > 0.0 {
        lines.push(surface_of_metal(section, metal, beads, wave));
    }
    lines
}

/// The surface of the metal: level in the groove, a parabola over the toes; with a wave for each bead whose mean is 0.
fn surface_of_metal(section: &Section, metal: f64, beads: usize, wave: f64) -> Vec<DVec2> {
    let level = section.slices.height_of(metal);
    let (left, right) = section.slices.edges(level - 1e-6);
    let width = right - left;
    let crown = 1.5 * (metal - section.area()).max(0.0) / width;
    let beads = beads.max(1) as f64;
    let at = |k: u32| {
        let part = f64::from(k) / f64::from(METAL_POINTS);
        let crown = crown * 4.0 * part * (1.0 - part);
        // Each bead is high in its middle; the cosine's mean over whole beads is 0.
        let wave = -wave.min(0.1 * width) * (TAU * beads * part).cos();
        section.place(left + width * part, level + crown + wave)
    };
    (0..=METAL_POINTS).map(at).collect()
}

/// Slow change of the deposition along the seam: part of the metal.
pub(super) fn deposition(random: &mut Random, size: f64) -> impl Fn(f64) -> f64 + use<> {
    let waves: Vec<(f64, f64, f64)> =
        (1..=5).map(|k| (f64::from(k), random.within(0.0, TAU), size * random.normal() / 5f64.sqrt())).collect();
    move |turn| 1.0 + waves.iter().map(|(k, phase, size)| size * (2.0 * PI * k * turn + phase).sin()).sum::<f64>()
}
