use seamwright_project::load::Loaded;
use seamwright_project::run_rows::head_names;
use seamwright_simulation::tracking::HeadSample;
use seamwright_simulation::{Conditions, Sample};

/// Columns of a trace with the true positions of weld and joint: of each head that welds, in a simulation.
pub(super) struct HeadColumns {
    /// Suffixes of each head's columns.
    heads: Vec<String>,
    /// The torch is a beam that corrects.
    beam: bool,
}

/// Each with its unit.
const NAMES: [(&str, &str); 11] = [
    ("seam_lateral_mm", "mm"),
    ("seam_height_mm", "mm"),
    ("correction_lateral_mm", "mm"),
    ("correction_height_mm", "mm"),
    ("miss_lateral_mm", "mm"),
    ("miss_height_mm", "mm"),
    ("sigma_mm", "mm"),
    ("sight", "1"),
    ("deviation_lateral_mm", "mm"),
    ("deviation_height_mm", "mm"),
    ("confidence", "1"),
];

/// And of a beam.
const BEAM_NAMES: [(&str, &str); 2] = [("deflection_mm", "mm"), ("beam_on_weld", "1")];
const MAX_COLUMNS: usize = NAMES.len() + BEAM_NAMES.len();

impl HeadColumns {
    pub(super) fn new(loaded: &Loaded, conditions: &Conditions<'_>) -> Self {
        if conditions.distortion.is_none() && !conditions.tracking {
            return Self { heads: Vec::new(), beam: false };
        }
        let heads = head_names(loaded);
        Self { heads, beam: loaded.machine.deflection.is_some() && conditions.tracking }
    }

    pub(super) fn names(&self) -> impl Iterator<Item = (String, &'static str)> + '_ {
        let names = NAMES.iter().chain(self.beam.then_some(&BEAM_NAMES).into_iter().flatten());
        self.heads.iter().flat_map(move |head| names.clone().map(move |(name, unit)| (format!("{name}{head}"), *unit)))
    }

    pub(super) fn values(&self, sample: &Sample) -> impl Iterator<Item = f64> {
        let (heads, count) = (self.heads.len(), NAMES.len() + if self.beam { BEAM_NAMES.len() } else { 0 });
        let heads = sample.heads.into_iter().take(heads);
        heads.flat_map(move |head| head.map_or([f64::NAN; MAX_COLUMNS], values).into_iter().take(count))
    }
}

fn values(head: HeadSample) -> [f64; MAX_COLUMNS] {
    let HeadSample { seam, correction, miss, tracked, beam } = head;
    let [sigma, sight, lateral, height, confidence] = tracked.map_or([f64::NAN; 5], |t| {
        [t.sigma_mm, f64::from(t.sight as u8), t.deviation_mm[0], t.deviation_mm[1], t.confidence]
    });
    let (deflection, welds) =
        beam.map_or((f64::NAN, f64::NAN), |beam| (beam.deflection_mm, f64::from(u8::from(beam.welds))));
    [
        seam.x,
        seam.y,
        correction.x,
        correction.y,
        miss.x,
        miss.y,
        sigma,
        sight,
        lateral,
        height,
        confidence,
        deflection,
        welds,
    ]
}
