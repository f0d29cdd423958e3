/// Settings of the crawl. The defaults suit a frame of about 50 mm at 0.1 mm per pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Maximum step from frame to frame, mm.
    pub step_mm: f64,
    /// Minimum step, mm; less counts as no progress.
    pub least_step_mm: f64,
    /// Maximum turn of the joint in one step, rad.
    pub turn: f64,
    /// Distance of a midline's start behind the camera, mm: the overlap with the previous frame.
    pub overlap_mm: f64,
    /// Maximum median distance of two frames' midlines in their overlap, mm.
    pub agree_mm: f64,
    /// Minimum confidence of a row.
    pub confidence: f64,
    /// Maximum distance between end and start of a closed joint, mm.
    pub close_mm: f64,
    /// Maximum angle between the directions at end and start of a closed joint, rad.
    pub close_angle: f64,
    /// Minimum length of a closed joint, mm.
    pub close_after_mm: f64,
    /// Minimum length of an open joint, mm; an earlier end is treated as a long tack, and the operator is asked.
    /// Infinity for a joint known to be closed.
    pub ends_after_mm: f64,
    /// Maximum length of a joint, mm.
    pub longest_mm: f64,
    /// Number of retries without a detection before the operator is asked.
    pub again: u32,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            step_mm: 8.0,
            least_step_mm: 0.5,
            turn: 0.2,
            overlap_mm: 6.0,
            agree_mm: 0.2,
            confidence: 0.5,
            close_mm: 1.5,
            close_angle: 0.26,
            close_after_mm: 40.0,
            ends_after_mm: 0.0,
            longest_mm: 50_000.0,
            again: 1,
        }
    }
}
