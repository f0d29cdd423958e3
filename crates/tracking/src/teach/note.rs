use super::FrameEnd;
use glam::DVec3;

/// What a frame gave.
#[derive(Debug, Clone, PartialEq)]
pub struct EyeNote {
    /// Where the optical axis met the work, mm.
    pub eye: DVec3,
    /// How far that is above the shape that was known before, mm.
    pub raised_mm: f64,
    /// Whether that was measured with the frame; otherwise it was taken as in the frame before, or nominal.
    pub measured: bool,
    /// Way along the line up to there, mm.
    pub way: f64,
    /// Confident rows.
    pub rows: usize,
    /// Their mean confidence.
    pub confidence: f64,
    /// Median distance of its midline from the ones before where they overlap, mm; none without an overlap.
    pub overlap_mm: Option<f64>,
    /// Why its midline ends.
    pub end: FrameEnd,
    /// Whether it was believed.
    pub agrees: bool,
}
