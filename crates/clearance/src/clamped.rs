use crate::shape::Solid;

/// The part and fixtures of a job, in the work frame, mm.
#[derive(Debug, Clone, Default)]
pub struct Clamped {
    /// The part.
    pub part: Vec<Solid>,
    /// The fixtures that hold it.
    pub fixtures: Vec<Solid>,
    /// Minimum clearance of the machine from both, mm; greater than 0.
    pub least_mm: f64,
}
