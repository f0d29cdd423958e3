use super::layers::{Scans, WeldedGroove, weld_layers};
use super::part::{DistortedPart, Sensor};
use crate::camera_simulator::random::Random;
use seamwright_document::DocumentError;
use std::fmt;
use std::ops::Range;

/// Returns the job of a random set-on nozzle: on the shell's axis (a saddle) for an even seed, beside it (a hillside)
/// for an odd one.
pub fn nozzle_job(seed: u64) -> String {
    let random = &mut Random::new(seed ^ 0x5add_1e00);
    let radius = random.within(50.0, 110.0);
    let shell = radius * random.within(2.6, 3.6);
    // A hillside's bevel is cut to one groove angle, a saddle's at one angle from the tube's end.
    let (beside, angle) = if seed % 2 == 1 {
        ((shell - radius) * random.within(0.1, 0.3), format!("angle_deg = {}", random.within(40.0, 52.0)))
    } else {
        (0.0, format!("cut_deg = {}", random.within(36.0, 44.0)))
    };
    let thickness = random.within(9.0, 16.0);
    let (gap, leg) = (random.within(1.8, 3.0), random.within(4.0, 7.0));
    format!(
        "schema = 1\ntitle = \"nozzle {seed}\"\nmachine = \"torch-5axis\"\n\
         [seam.nozzle]\nradius_mm = {radius}\norigin_mm = [0, {beside}, 0]\n\
         [seam.nozzle.body.cylinder]\nradius_mm = {shell}\naxis = [1, 0, 0]\n\
         [joint]\ncap_mm = 1.5\n[joint.preparation.t_bevel]\nprepared = \"first\"\nthickness_mm = {thickness}\n\
         {angle}\nroot_gap_mm = {gap}\nroot_face_mm = 1\nleg_mm = {leg}\n\
         [beads]\nwire_mm = 1.2\nstagger_mm = 0\n\
         root = {{ speed_mm_s = 5, process = {{ wire_feed_m_min = 4 }}, layer_mm = 4 }}\n\
         fill = {{ layer_mm = 3.5 }}\ncap = {{ speed_mm_s = 7.5, layer_mm = 3 }}\n\
         [weld]\nspeed_mm_s = 6.5\n[weld.process]\nwire_feed_m_min = 8\n"
    )
}

/// Results of one part.
#[derive(Debug, Clone, PartialEq)]
pub struct CampaignRow {
    /// Seed of job and part.
    pub seed: u64,
    /// The weld as drawn, with one scan before it, and with scans between layers.
    pub welds: [WeldedGroove; 3],
}

/// Welds of distorted saddle and hillside nozzles with and without scans.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Campaign {
    /// By seed.
    pub rows: Vec<CampaignRow>,
}

impl Campaign {
    /// Welds the parts of these seeds.
    ///
    /// # Errors
    /// A job or a measured groove without a plan.
    pub fn run(seeds: Range<u64>) -> Result<Self, DocumentError> {
        let one = |seed: u64| {
            let (job, part) = (nozzle_job(seed), DistortedPart::new(seed));
            let weld = |scans| weld_layers(&job, &part, Sensor::USUAL, scans, seed);
            let welds = [weld(Scans::None)?, weld(Scans::BeforeWeld)?, weld(Scans::EveryLayer)?];
            Ok(CampaignRow { seed, welds })
        };
        seeds.map(one).collect::<Result<_, _>>().map(|rows| Self { rows })
    }

    /// Returns the 95th percentile of the cap's errors of all parts, mm: as drawn, with one scan, with scans between
    /// layers.
    pub fn p95(&self) -> [f64; 3] {
        [0, 1, 2].map(|k| p95(self.rows.iter().flat_map(|row| &row.welds[k].cap_errors)))
    }
}

fn p95<'a>(errors: impl Iterator<Item = &'a f64>) -> f64 {
    let mut sizes: Vec<f64> = errors.map(|e| e.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() * 95 / 100).copied().unwrap_or(f64::NAN)
}

impl fmt::Display for Campaign {
    /// A table: a row a part, then all of them.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "cap height error, mm, 95 % of the stations (and the largest)")?;
        writeln!(f, "seed  kind      layers  passes  as drawn       one scan       every layer    profiles  failed")?;
        for row in &self.rows {
            let kind = if row.seed % 2 == 1 { "hillside" } else { "saddle" };
            let [drawn, once, every] = &row.welds;
            let cell = |weld: &WeldedGroove| {
                let largest = weld.cap_errors.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
                format!("{:5.2} ({:5.2})", p95(weld.cap_errors.iter()), largest)
            };
            let planned = |of: fn(&WeldedGroove) -> usize| format!("{}>{}", of(drawn), of(every));
            writeln!(
                f,
                "{:4}  {kind:8}  {:6}  {:6}  {}  {}  {}  {:8}  {:6}",
                row.seed,
                planned(|w| w.layers),
                planned(|w| w.passes),
                cell(drawn),
                cell(once),
                cell(every),
                every.scanned,
                every.failed
            )?;
        }
        let [drawn, once, every] = self.p95();
        write!(f, "all parts, p95: as drawn {drawn:.2}, one scan {once:.2}, every layer {every:.2}")
    }
}
