//! Acceptance tests of stripe reading, measured on simulated stripes whose truth is known.

use super::{Placement, Section, StripeDisturbances, StripeImage, StripeScene};
use crate::acceptance::{Gate, Table};
use crate::camera_simulator::random::Random;
use glam::DVec2;
use seamwright_vision::Image;
use seamwright_vision::stripe::{Features, JointKind, NoFeatures, Quantity, StripeReader, StripeTask};
use std::ops::Range;
use std::time::Instant;

/// Size of the scenes in pixels, and their scale.
const SIZE_PX: [usize; 2] = [1024, 512];
const MM_PER_PX: f64 = 0.05;

/// A joint point farther off than this is wrong, mm.
const WRONG_MM: f64 = 0.5;

/// Creates the scene of case `seed`: a random section in a random pose, every other one mirrored.
pub fn stripe_scene(section: Section, seed: u64) -> StripeScene {
    let random = &mut Random::new(seed ^ 0x91ac_e000);
    let at = DVec2::new(random.within(-4.0, 4.0), random.within(-4.0, 0.0));
    let placement = Placement { at, turn: random.within(-0.1, 0.1), mirrored: seed % 2 == 1 };
    StripeScene::new(section, placement, SIZE_PX, MM_PER_PX)
}

/// Returns the task for a section; the thickness of its upper sheet is known.
pub fn stripe_task(kind: JointKind, section: &Section) -> StripeTask {
    let task = StripeTask::in_mm(kind);
    if let Section::Lap { thickness, .. } = section { task.with_thickness(*thickness) } else { task }
}

fn read(
    reader: &mut StripeReader,
    scene: &StripeScene,
    image: &StripeImage,
    kind: JointKind,
) -> Result<Features, NoFeatures> {
    let frame = image.image.frame().map_err(|_| NoFeatures::NoStripe)?;
    reader.read_image(&frame, Some(&scene.to_mm), &stripe_task(kind, &scene.section))
}

/// Errors of one kind of joint under one kind of disturbance.
#[derive(Debug, Clone, Default)]
pub struct StripeErrors {
    /// Distances of confident joint points from the truth, mm.
    pub joint: Vec<f64>,
    /// Errors of confident gaps, mm.
    pub gap: Vec<f64>,
    /// Errors of the stripe's rows away from corners and ends, pixels.
    pub centre: Vec<f64>,
    /// Cases.
    pub cases: u64,
}

impl StripeErrors {
    /// Measures the scenes of these seeds of `kind` under `how`; calls `done` after each.
    pub fn measure(kind: JointKind, how: &StripeDisturbances, seeds: Range<u64>, mut done: impl FnMut()) -> Self {
        let mut reader = StripeReader::new();
        let mut errors = Self { cases: seeds.end.saturating_sub(seeds.start), ..Self::default() };
        for seed in seeds {
            done();
            let scene = stripe_scene(Section::random(kind, seed), seed);
            let image = scene.image(how, seed);
            let found = read(&mut reader, &scene, &image, kind);
            errors.centres(&reader, &scene.lit_rows(), &image.rows);
            let (Ok(features), Some(truth)) = (found, image.truth.joint()) else { continue };
            if !features.is_confident() {
                continue;
            }
            errors.joint.push(features.joint().distance(truth));
            let gap = image.truth.values.iter().find(|v| v.0 == Quantity::Gap);
            if let (Some(found), Some((_, gap))) = (features.value(Quantity::Gap), gap) {
                errors.gap.push((found - gap).abs());
            }
        }
        errors
    }

    /// Adds rows where the stripe is straight for 8 columns to both sides.
    fn centres(&mut self, reader: &StripeReader, lit: &[Option<f64>], rows: &[Option<f64>]) {
        for p in reader.chain() {
            let c = p.at.x as usize;
            let (Some(Some(row)), true) = (rows.get(c), c >= 8 && c + 8 < lit.len()) else { continue };
            let (Some(a), Some(b)) = (lit[c - 8], lit[c + 8]) else { continue };
            let steep = (b - a).abs() > 16.0;
            if !steep && (a + b - 2.0 * row).abs() < 1e-6 && (p.at.y - row).abs() < 5.0 {
                self.centre.push(p.at.y - row);
            }
        }
    }

    /// Returns the number of cases with a wrong confident joint point.
    pub fn wrong(&self) -> usize {
        self.joint.iter().filter(|e| **e > WRONG_MM).count()
    }

    /// Returns the share of cases without a confident result.
    pub fn silent(&self) -> f64 {
        1.0 - self.joint.len() as f64 / self.cases as f64
    }
}

/// Root of the mean square; NaN for an empty slice.
fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// Returns the 95th percentile.
fn most(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted.get((sorted.len() * 95 / 100).min(sorted.len().saturating_sub(1))).copied().unwrap_or(f64::NAN)
}

/// Disturbances of the cases, in turns.
const LEVELS: [StripeDisturbances; 3] =
    [StripeDisturbances::USUAL, StripeDisturbances::HOLED, StripeDisturbances::ROUGH];

/// Number of calls of `done` in [`stripe_gates`] for every seed.
pub const STEPS_A_SEED: u64 = (LEVELS.len() * JointKind::ALL.len()) as u64 + 1;

/// Runs all acceptance tests on the scenes of these seeds of each kind; calls `done` [`STEPS_A_SEED`] times for each
/// seed. Times are those of this build on this machine.
pub fn stripe_gates(seeds: Range<u64>, mut done: impl FnMut()) -> Table {
    let mut rows = Vec::new();
    let mut centres = Vec::new();
    for kind in JointKind::ALL {
        let [usual, holed, rough] = LEVELS.map(|how| StripeErrors::measure(kind, &how, seeds.clone(), &mut done));
        centres.extend_from_slice(&usual.centre);
        let name = format!("{kind:?}").to_lowercase();
        let mut gate = |what, value, limit, unit| rows.push(Gate::at_most(&name, what, value, limit, unit));
        gate("joint point, RMS", rms(&usual.joint), 0.05, "mm");
        gate("gap, 95 %", most(&usual.gap), 0.05, "mm");
        gate("no confident result", 100.0 * usual.silent(), 25.0, "%");
        gate("joint point with 10 % outliers and 20 % missing, RMS", rms(&holed.joint), 0.1, "mm");
        gate("confident and wrong beside the arc", rough.wrong() as f64, 0.0, "cases");
        gate("no confident result beside the arc", 100.0 * rough.silent(), 50.0, "%");
    }
    rows.insert(0, Gate::at_most("all", "centre of the stripe, RMS", rms(&centres), 0.1, "px"));
    let nowhere = confident_nowhere(seeds, &mut done).len() as f64;
    rows.push(Gate::at_most("all", "confident where there is no such joint", nowhere, 0.0, "cases"));
    for (frames, height, limit) in [("2048 x 256", 256, 1.0), ("2048 x 512", 512, 1.0), ("2048 x 1024", 1024, 2.0)] {
        rows.push(Gate::at_most(frames, "time, median", time_ms([2048, height]), limit, "ms"));
    }
    Table { title: "The joint in a laser stripe".to_owned(), rows }
}

/// Returns confident results on blank frames, plates, outside corners, and joints of other kinds: the case, the true
/// section, and the result. Calls `done` after each seed.
pub fn confident_nowhere(seeds: Range<u64>, mut done: impl FnMut()) -> Vec<(u64, Section, Features)> {
    let mut reader = StripeReader::new();
    let mut confident = Vec::new();
    for seed in seeds {
        done();
        let how = LEVELS[(seed % 3) as usize];
        let others = JointKind::ALL.map(|kind| (Some(kind), Section::random(kind, seed)));
        let ridge = Section::Ridge { angle: 2.0 + (seed % 10) as f64 * 0.1 };
        let scenes = others.into_iter().chain([(None, Section::Plate), (None, ridge)]);
        for (is, section) in scenes {
            let scene = stripe_scene(section, seed);
            let image = scene.image(&how, seed);
            for kind in JointKind::ALL.into_iter().filter(|k| Some(*k) != is) {
                let mut task = scene.clone();
                // The sheet's thickness is unknown for other joints.
                task.section = Section::Plate;
                let found = read(&mut reader, &task, &image, kind).ok().filter(Features::is_confident);
                confident.extend(found.map(|f| (seed, section, f)));
            }
        }
        let blank = StripeDisturbances { peak: 0.0, ghosts: 0, ..how };
        let scene = stripe_scene(Section::Plate, seed);
        let image = scene.image(&blank, seed);
        for kind in JointKind::ALL {
            let found = read(&mut reader, &scene, &image, kind).ok().filter(Features::is_confident);
            confident.extend(found.map(|f| (seed, Section::Plate, f)));
        }
    }
    confident
}

/// Median time to read a V groove in an image of that size, ms.
fn time_ms(size_px: [usize; 2]) -> f64 {
    let section = Section::V { bevels: [0.5; 2], depth: 0.012 * size_px[1] as f64, gap: 1.5, mismatch: 0.2 };
    let placement = Placement { at: DVec2::new(1.0, -0.006 * size_px[1] as f64), ..Placement::default() };
    let scene = StripeScene::new(section, placement, size_px, MM_PER_PX);
    let StripeImage { image, .. } = scene.image(&StripeDisturbances::USUAL, 1);
    let mut reader = StripeReader::new();
    let Image::U8 { width, height, pixels } = &image else { return f64::NAN };
    let mut times: Vec<f64> = Vec::new();
    for _ in 0..21 {
        let start = Instant::now();
        let frame = seamwright_vision::Frame::new(*width, *height, seamwright_vision::Pixels::U8(pixels));
        let found = frame.map(|f| reader.read_image(&f, Some(&scene.to_mm), &StripeTask::in_mm(JointKind::V)));
        if !matches!(found, Ok(Ok(_))) {
            return f64::NAN;
        }
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}
