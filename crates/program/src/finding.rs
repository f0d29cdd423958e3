use serde::Serialize;

/// Something that keeps a weld from being made as asked, where on the seam, and what would cure it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// Short kind, stable for programs: `reach`, `range`, `speed`, `attitude`, `access`, `singular`, `jump`, `hold`,
    /// `pulses`, `steps`, `pace`, `stop`, `blend`, `least_speed`, `turn`, `bead`, `procedure`.
    pub kind: &'static str,
    /// What is wrong, with the value found and the value allowed.
    pub message: String,
    /// Pass, counted from 1.
    pub pass: usize,
    /// Path length at which it begins and ends, mm.
    pub from_mm: f64,
    /// See `from_mm`.
    pub to_mm: f64,
    /// What would cure it.
    pub cure: String,
    /// True if the weld can be made nevertheless (it was asked to slow down, or the shortcoming is only reported).
    pub allowed: bool,
}
