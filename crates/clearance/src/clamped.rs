use crate::Solid;

/// What a job puts into a machine, in the work frame, mm.
#[derive(Debug, Clone, Default)]
pub struct Clamped {
    /// The part.
    pub part: Vec<Solid>,
    /// What holds it.
    pub fixtures: Vec<Solid>,
    /// Least distance of the machine from both, mm; greater than 0.
    pub least_mm: f64,
}
