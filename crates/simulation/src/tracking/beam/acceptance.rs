//! Rows of beam mode against limits.

use super::camera::{BeamCamera, Offsets, Pixels};
use super::scene::{BeamScene, placed_wrong};
use super::weld::{BeamOutcome, weld};
use crate::acceptance::{Gate, Limit};
use crate::camera_simulator::Appearance;
use crate::error::Error;
use glam::DVec3;
use seamwright_executive::tracking::{BeamHead, Seam};
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::TorchPath;
use seamwright_teaching::{JointFollower, SeamLine, Station};
use seamwright_tracking::beam::{
    Allowed, BeamReplay, BeamTracking, DeviationRecord, Misfit, Replay, ReplaySettings, Settings,
};

/// A pass to be welded by beam, and the same seam started elsewhere.
pub struct BeamJob<'a> {
    /// Machine whose axes carry the gun.
    pub machine: &'a Machine,
    /// The whole taught seam.
    pub nominal: &'a SeamLine,
    /// Path and motion of the first pass.
    pub first: (&'a dyn TorchPath, &'a PassMotion),
    /// Path and motion of a later pass over the same seam, which starts at another position.
    pub later: (&'a dyn TorchPath, &'a PassMotion),
    /// Speed, mm/s.
    pub speed_mm_s: f64,
}

/// Limits of the distance from the seam, and of a replay from the tracked pass.
const TRACKED_MM: f64 = 0.05;
const REPLAYED_MM: f64 = 0.02;
/// Displacement of a part between passes so that the stored deviations no longer fit, mm.
pub const MOVED_MM: f64 = 0.4;
/// Maximum length of a tack, pixels.
const GAP_PX: f64 = 60.0;

impl BeamJob<'_> {
    fn scene(&self, later: bool, actual: &SeamLine) -> BeamScene<'_> {
        let (path, motion) = if later { self.later } else { self.first };
        BeamScene::new(self.machine, path, motion, actual.clone())
    }

    /// Returns a misplaced seam: shifted, turned, oval over its length.
    #[must_use]
    pub fn placed_wrong(&self, seed: u64) -> SeamLine {
        placed_wrong(self.nominal, self.nominal.length(), seed)
    }

    /// Welds the first pass with tracking; also returns its distances without correction.
    ///
    /// # Errors
    /// Those of [`weld`].
    pub fn tracked(
        &self,
        actual: &SeamLine,
        camera: &mut dyn BeamCamera,
        seed: u64,
    ) -> Result<(BeamOutcome, Vec<f64>), Error> {
        let scene = self.scene(false, actual);
        let settings = Settings::usual(self.speed_mm_s);
        let head = BeamTracking::new(settings, &*scene.taught.frame, scene.deflection, scene.axes)?;
        let mut uncorrected = scene.uncorrected();
        uncorrected.sort_by(f64::total_cmp);
        Ok((weld(&scene, camera, BeamHead::Tracking(Box::new(head)), settings.noise_mm, seed)?, uncorrected))
    }

    /// Welds the later pass with the deviations that the first one found. Also returns its start on the first one's
    /// path length, mm.
    ///
    /// # Errors
    /// Those of [`weld`]; a record that does not cover the pass.
    pub fn replayed(
        &self,
        record: DeviationRecord,
        actual: &SeamLine,
        camera: &mut dyn BeamCamera,
        seed: u64,
    ) -> Result<(BeamOutcome, f64), Error> {
        let scene = self.scene(true, actual);
        let shift = foot(&Seam::along(self.first.0), (scene.taught.frame)(0.0).point);
        let noise_mm = Settings::usual(self.speed_mm_s).noise_mm;
        let replay = Replay::new(record, shift, scene.taught.length_mm, noise_mm)?;
        let head = BeamReplay::new(ReplaySettings::USUAL, replay, &*scene.taught.frame, scene.deflection, scene.axes)?;
        Ok((weld(&scene, camera, BeamHead::Replay(Box::new(head)), noise_mm, seed)?, shift))
    }
}

/// Path length of the position of `seam` nearest to `point`, to 0.1 um.
fn foot(seam: &Seam, point: DVec3) -> f64 {
    let away = |s: f64| (seam.frame)(s).point.distance_squared(point);
    let places = (0..=seam.length_mm as u32).map(f64::from);
    let mut s = places.min_by(|a, b| away(*a).total_cmp(&away(*b))).unwrap_or(0.0);
    for _ in 0..20 {
        let frame = (seam.frame)(s);
        s += (point - frame.point).dot(frame.along);
    }
    s
}

/// Maximum lateral distance between two welds of one seam, mm, where both exist; the second one's path length starts
/// at `shift` of the first one's.
fn apart(first: &[(f64, f64)], second: &[(f64, f64)], shift: f64) -> f64 {
    let at = |s: f64| {
        let after = first.partition_point(|p| p.0 < s).clamp(1, first.len().max(2) - 1);
        let (a, b) = (first.get(after - 1)?, first.get(after)?);
        let part = (s - a.0) / (b.0 - a.0);
        (0.0..=1.0).contains(&part).then_some(a.1 + part * (b.1 - a.1))
    };
    second.iter().filter_map(|(s, lateral)| Some((lateral - at(s + shift)?).abs())).fold(0.0, f64::max)
}

/// Welds a misplaced part with a tracking beam, then again with the deviations found: with real pixels once, and with
/// points and noise for `seeds` seeds, of which the worst counts.
///
/// # Errors
/// Those of [`weld`].
pub fn beam_rows(name: &str, job: &BeamJob<'_>, seeds: u64) -> Result<Vec<Gate>, Error> {
    let mut rows = Vec::new();
    let actual = job.placed_wrong(0);
    let seen = Appearance { tacks: vec![(150.0, 155.0)], ..Appearance::default() };
    let mut camera = Pixels::new(job.machine, actual.clone(), seen, JointFollower::new(GAP_PX), 0)?;
    rows.extend(pass_rows(&format!("{name}, from pixels"), job, &actual, &mut camera, 0)?);
    let mut worst: Vec<Gate> = Vec::new();
    for seed in 1..=seeds {
        let actual = job.placed_wrong(seed);
        let mut camera = Offsets::new(&actual, seed);
        camera.tacks = vec![(150.0, 155.0), (300.0, 304.0)];
        let found = pass_rows(&format!("{name}, {seeds} seeds of points"), job, &actual, &mut camera, seed)?;
        if worst.is_empty() {
            worst = found;
        } else {
            for (row, new) in worst.iter_mut().zip(found) {
                row.value = match row.limit {
                    Limit::Most(_) => row.value.max(new.value),
                    Limit::Least(_) => row.value.min(new.value),
                };
            }
        }
    }
    rows.extend(worst);
    Ok(rows)
}

fn pass_rows(
    weld: &str,
    job: &BeamJob<'_>,
    actual: &SeamLine,
    camera: &mut dyn BeamCamera,
    seed: u64,
) -> Result<Vec<Gate>, Error> {
    let (tracked, uncorrected) = job.tracked(actual, camera, seed)?;
    let without = uncorrected.get(uncorrected.len() * 99 / 100).copied().unwrap_or(f64::INFINITY);
    let Allowed { every_s, longest_s } = Allowed::EBW_2004;
    let missing = job.first.0.length() - tracked.welded_mm - tracked.away.0 * job.first.0.length();
    let most = |what, value, limit, unit| Gate::at_most(weld, what, value, limit, unit);
    let mut rows = vec![
        Gate {
            frames: weld.to_owned(),
            what: "untracked, 99 % within",
            value: without,
            limit: Limit::Least(0.1),
            unit: "mm",
        },
        most("tracked, 99 % within", tracked.p99_mm, TRACKED_MM, "mm"),
        most("not welded", missing.abs(), 1.0, "mm"),
        most("beam away from the weld", 100.0 * tracked.away.0, 100.0 * longest_s / every_s + 0.05, "%"),
        most("longest interruption", 1e3 * tracked.away.1, 1e3 * longest_s + 1e-6, "ms"),
        most("deflected by", tracked.used_mm[0], 2.0, "mm"),
        most("gun carried by", tracked.used_mm[1], 5.0, "mm"),
    ];
    let Some(record) = tracked.record else { return Ok(rows) };
    // Through its file, as it is stored with the program.
    let record = DeviationRecord::from_csv("stored", &record.to_csv()).map_err(|e| Error::Frame(e.message()))?;
    let (again, shift) = job.replayed(record.clone(), actual, camera, seed + 1000)?;
    rows.push(most("replayed, 99 % within", again.p99_mm, TRACKED_MM, "mm"));
    rows.push(most(
        "replayed beside the tracked pass",
        apart(&tracked.places, &again.places, shift),
        REPLAYED_MM,
        "mm",
    ));
    Ok(rows)
}

/// Replays deviations on a part that has moved since. Returns the displacement that the refused replay reports, mm;
/// infinite if it is not refused.
///
/// # Errors
/// Those of [`weld`].
pub fn moved_since(job: &BeamJob<'_>, seed: u64) -> Result<f64, Error> {
    let actual = job.placed_wrong(seed);
    let (tracked, _) = job.tracked(&actual, &mut Offsets::new(&actual, seed), seed)?;
    let Some(record) = tracked.record else { return Ok(f64::INFINITY) };
    let side = {
        let (station, along) = job.nominal.at(30.0);
        station.normal.cross(along).normalize_or_zero()
    };
    let stations = actual.stations().iter().map(|s| Station { point: s.point + MOVED_MM * side, ..*s }).collect();
    let moved = SeamLine::through(stations, actual.is_closed());
    let (again, _) = job.replayed(record, &moved, &mut Offsets::new(&moved, seed), seed)?;
    match again.fit {
        Some(Err(Misfit::Moved { median_mm, .. })) => Ok(median_mm.abs()),
        _ => Ok(f64::INFINITY),
    }
}
