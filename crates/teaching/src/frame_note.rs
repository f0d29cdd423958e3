use crate::work_shape::FrameEnd;
use glam::DVec3;

/// Summary of a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct CameraNote {
    /// Intersection of the optical axis with the work, mm.
    pub eye: DVec3,
    /// Height of that point above the known shape, mm.
    pub raised_mm: f64,
    /// Whether the height was measured with the frame; otherwise it is that of the previous frame, or nominal.
    pub measured: bool,
    /// Distance along the line up to there, mm.
    pub way: f64,
    /// Number of confident rows.
    pub rows: usize,
    /// Their mean confidence.
    pub confidence: f64,
    /// Median distance of its midline from the previous ones in their overlap, mm; `None` without an overlap.
    pub overlap_mm: Option<f64>,
    /// Reason for the end of its midline.
    pub end: FrameEnd,
    /// Whether it was accepted.
    pub agrees: bool,
}
