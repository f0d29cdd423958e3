use crate::load::Loaded;
use seamwright_cell::tracking::HeadSample;
use seamwright_cell::{Conditions, Sample};
use seamwright_program::TorchPath;

/// Columns of a trace that say where weld and joint truly are: of each head that welds, where that is simulated.
pub(super) struct HeadColumns(Vec<String>);

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

impl HeadColumns {
    pub(super) fn new(loaded: &Loaded, conditions: &Conditions<'_>) -> Self {
        if conditions.distortion.is_none() {
            return Self(Vec::new());
        }
        let pairs = loaded.paths().iter().any(|path| path.second(0.0).is_some());
        let heads = loaded.machine.heads.iter().take(if pairs { 2 } else { 1 });
        // One head needs no name.
        Self(heads.map(|head| if pairs { format!("_{}", head.name) } else { String::new() }).collect())
    }

    pub(super) fn names(&self) -> impl Iterator<Item = (String, &'static str)> + '_ {
        self.0.iter().flat_map(|head| NAMES.iter().map(move |(name, unit)| (format!("{name}{head}"), *unit)))
    }

    pub(super) fn values(&self, sample: &Sample) -> impl Iterator<Item = f64> {
        let heads = self.0.len();
        sample.heads.into_iter().take(heads).flat_map(|head| head.map_or([f64::NAN; NAMES.len()], values))
    }
}

fn values(head: HeadSample) -> [f64; NAMES.len()] {
    let HeadSample { seam, correction, miss, known } = head;
    let (sigma, sight) = known.map_or((f64::NAN, f64::NAN), |(sigma, sight)| (sigma, f64::from(sight as u8)));
    [seam.x, seam.y, correction.x, correction.y, miss.x, miss.y, sigma, sight]
}
