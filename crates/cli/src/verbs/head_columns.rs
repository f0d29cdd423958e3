use crate::load::Loaded;
use seamwright_cell::tracking::HeadSample;
use seamwright_cell::{Conditions, Sample};
use seamwright_program::TorchPath;

/// Columns of a trace that say where weld and joint truly are: of each head that welds, where that is simulated.
pub(super) struct HeadColumns {
    /// What ends the names of each head's columns.
    heads: Vec<String>,
    /// The torch is a beam that corrects.
    beam: bool,
}

/// Each with its unit.
const NAMES: [(&str, &str); 8] = [
    ("seam_lateral_mm", "mm"),
    ("seam_height_mm", "mm"),
    ("correction_lateral_mm", "mm"),
    ("correction_height_mm", "mm"),
    ("miss_lateral_mm", "mm"),
    ("miss_height_mm", "mm"),
    ("sigma_mm", "mm"),
    ("sight", "1"),
];

/// And of a beam.
const BEAM_NAMES: [(&str, &str); 2] = [("deflection_mm", "mm"), ("beam_on_weld", "1")];
const MOST: usize = NAMES.len() + BEAM_NAMES.len();

impl HeadColumns {
    pub(super) fn new(loaded: &Loaded, conditions: &Conditions<'_>) -> Self {
        if conditions.distortion.is_none() && !conditions.tracking {
            return Self { heads: Vec::new(), beam: false };
        }
        let pairs = loaded.paths().iter().any(|path| path.second(0.0).is_some());
        let heads = loaded.machine.heads.iter().take(if pairs { 2 } else { 1 });
        // One head needs no name.
        let heads = heads.map(|head| if pairs { format!("_{}", head.name) } else { String::new() }).collect();
        Self { heads, beam: loaded.machine.deflection.is_some() && conditions.tracking }
    }

    pub(super) fn names(&self) -> impl Iterator<Item = (String, &'static str)> + '_ {
        let names = NAMES.iter().chain(self.beam.then_some(&BEAM_NAMES).into_iter().flatten());
        self.heads.iter().flat_map(move |head| names.clone().map(move |(name, unit)| (format!("{name}{head}"), *unit)))
    }

    pub(super) fn values(&self, sample: &Sample) -> impl Iterator<Item = f64> {
        let (heads, count) = (self.heads.len(), NAMES.len() + if self.beam { BEAM_NAMES.len() } else { 0 });
        let heads = sample.heads.into_iter().take(heads);
        heads.flat_map(move |head| head.map_or([f64::NAN; MOST], values).into_iter().take(count))
    }
}

fn values(head: HeadSample) -> [f64; MOST] {
    let HeadSample { seam, correction, miss, known, beam } = head;
    let (sigma, sight) = known.map_or((f64::NAN, f64::NAN), |(sigma, sight)| (sigma, f64::from(sight as u8)));
    let (deflection, welds) =
        beam.map_or((f64::NAN, f64::NAN), |beam| (beam.deflection_mm, f64::from(u8::from(beam.welds))));
    [seam.x, seam.y, correction.x, correction.y, miss.x, miss.y, sigma, sight, deflection, welds]
}
