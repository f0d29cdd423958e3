use super::part::{DistortedPart, Sensor, deposition};
use crate::camera_simulator::random::Random;
use seamwright_document::DocumentError;
use seamwright_weld::{Groove, GrooveScanner, SeamCurve, SeamJoint, SeamPoint, Section, SensorView, Welding};
use std::fmt::Write as _;

/// Scans of a weld.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scans {
    /// None: the drawing is welded.
    None,
    /// One before the weld.
    BeforeWeld,
    /// Before the weld and after each layer but the last.
    EveryLayer,
}

/// A finished weld of a distorted part.
#[derive(Debug, Clone, PartialEq)]
pub struct WeldedGroove {
    /// Error of the cap's height in its middle at stations all along the seam, mm; positive: too high.
    pub cap_errors: Vec<f64>,
    /// Number of layers.
    pub layers: usize,
    /// Passes in the last plan.
    pub passes: usize,
    /// Scanned profiles, and those without a result.
    pub scanned: usize,
    /// See `scanned`.
    pub failed: usize,
    /// Errors of the scanned open areas in their standard uncertainties.
    pub area_errors: Vec<f64>,
}

/// Distance of the scanned profiles, mm.
const SCAN_MM: f64 = 12.0;
/// Stations at which metal is counted.
const STATIONS: usize = 180;
/// Deviation of a weld's deposition from the plan, constant and along the seam, as parts (standard deviations): that of a
/// wire feed that is calibrated to 1.5 %. An error of the last layer stays in the cap.
const DEPOSITION: [f64; 2] = [0.015, 0.02];

/// Part of the cap that metal may fill before its layer is planned.
const FULL: f64 = 0.8;

/// A part that is being welded.
struct Weld<'a> {
    part: &'a DistortedPart,
    sensor: Sensor,
    random: Random,
    /// Metal at each station, mm^2.
    metal: Vec<f64>,
    /// Entries of `[[joint.fit_up]]` so far.
    entries: String,
    done: WeldedGroove,
}

/// Welds the job on a part layer by layer, with a simulated sensor.
///
/// # Errors
/// A job or a measured groove without a plan.
pub fn weld_layers(
    job: &str,
    part: &DistortedPart,
    sensor: Sensor,
    scans: Scans,
    seed: u64,
) -> Result<WeldedGroove, DocumentError> {
    let mut weld = Weld {
        part,
        sensor,
        random: Random::new(seed ^ 0x011a_9e35),
        metal: vec![0.0; STATIONS],
        entries: String::new(),
        done: WeldedGroove {
            cap_errors: Vec::new(),
            layers: 0,
            passes: 0,
            scanned: 0,
            failed: 0,
            area_errors: Vec::new(),
        },
    };
    let mut welding = Welding::read("job.toml", job)?;
    if scans != Scans::None {
        weld.scan(&welding, 0, 1);
        welding = Welding::read("job.toml", &format!("{job}\n{}", weld.entries))?;
    }
    let mean = 1.0 + DEPOSITION[0] * weld.random.normal();
    loop {
        let layer = weld.done.layers;
        let Some(plan) = welding.plan.as_ref().filter(|plan| layer < plan.layers.len()) else { break };
        let beads = plan.layers[layer].beads;
        let is_last = layer + 1 == plan.layers.len();
        weld.lay(&welding, layer, mean);
        weld.done.layers += 1;
        if scans == Scans::EveryLayer && !is_last {
            weld.scan(&welding, weld.done.layers, beads);
            welding = Welding::read("job.toml", &format!("{job}\n{}", weld.entries))?;
        }
    }
    weld.done.passes = welding.program.value.passes.len();
    weld.measure_cap(&welding);
    Ok(weld.done)
}

impl Weld<'_> {
    /// Brings the metal of a layer.
    fn lay(&mut self, welding: &Welding, layer: usize, mean: f64) {
        let (Some(plan), Some(seam)) = (&welding.plan, &welding.seam) else { return };
        let first: usize = plan.layers[..layer].iter().map(|l| l.beads).sum();
        for bead in first..first + plan.layers[layer].beads {
            let change = deposition(&mut self.random, DEPOSITION[1]);
            for (i, metal) in self.metal.iter_mut().enumerate() {
                let s = station(seam, i);
                if plan.is_there(layer, s) {
                    *metal += mean * change(s / seam.length()) * plan.area(bead, s).unwrap_or(0.0);
                }
            }
        }
    }

    /// Scans the groove all along the seam and adds the entries.
    fn scan(&mut self, welding: &Welding, layers: usize, beads: usize) {
        let (Some(joint), Some(seam)) = (&welding.joint, &welding.seam) else { return };
        let Some(mut scanner) = GrooveScanner::new(joint, layers > 0, SensorView::default()) else { return };
        let count = (seam.length() / SCAN_MM).ceil() as usize;
        for i in 0..count {
            let p = seam.at(seam.length() * i as f64 / count as f64);
            let Some(section) = joint.section_with(&self.part.groove(joint, seam, &p, layers)) else { continue };
            let metal = self.metal_at(seam, p.s);
            let seed = self.random.whole(0, usize::MAX) as u64;
            let points = self.sensor.profile(&section, metal, beads, seed);
            self.done.scanned += 1;
            let Ok(found) = scanner.measure(&p, &points) else {
                self.done.failed += 1;
                continue;
            };
            self.done.area_errors.push((found.remaining.value - section.area() + metal) / found.remaining.uncertainty);
            // Errors are impossible: a text takes all.
            let _ = write!(
                self.entries,
                "[[joint.fit_up]]\ns_mm = {}\nroot_gap_mm = {}\nmismatch_mm = {}\n",
                p.s,
                found.gap.value.max(0.0),
                found.mismatch.value
            );
            if let Some(angle) = found.angle {
                let _ = writeln!(self.entries, "angle_deg = {}", angle.value.to_degrees());
            }
            if layers > 0 {
                // Metal above most of the cap stays: there the last layer is as thin as it can be.
                let least = joint.section_with(&Groove::from(&found)).map_or(0.0, |section| -FULL * section.cap);
                let remaining = found.remaining.value.max(least);
                let _ = writeln!(self.entries, "after_layer = {layers}\nremaining_mm2 = {remaining}");
            }
        }
    }

    /// Metal at path length `s`, linear between stations, mm^2.
    fn metal_at(&self, seam: &SeamCurve, s: f64) -> f64 {
        let place = s / seam.length() * STATIONS as f64;
        let (i, part) = (place.floor() as usize % STATIONS, place.fract());
        self.metal[i] + part * (self.metal[(i + 1) % STATIONS] - self.metal[i])
    }

    /// Compares the cap's height with the drawing.
    fn measure_cap(&mut self, welding: &Welding) {
        let (Some(joint), Some(seam)) = (&welding.joint, &welding.seam) else { return };
        for (i, metal) in self.metal.iter().enumerate() {
            let p = seam.at(station(seam, i));
            if let Some(section) = self.true_section(joint, seam, &p) {
                // A cap is a parabola: its middle is 1.5 times its mean height.
                self.done.cap_errors.push(1.5 * (metal - section.total()) / section.chord());
            }
        }
    }

    fn true_section(&self, joint: &SeamJoint, seam: &SeamCurve, p: &SeamPoint) -> Option<Section> {
        joint.section_with(&self.part.groove(joint, seam, p, self.done.layers))
    }
}

fn station(seam: &SeamCurve, i: usize) -> f64 {
    seam.length() * i as f64 / STATIONS as f64
}
