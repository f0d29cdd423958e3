/// How the crawl goes. The usual values suit a frame of some 50 mm at 0.1 mm a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Longest step from frame to frame, mm.
    pub step_mm: f64,
    /// Shortest step: less counts as none, mm.
    pub least_step_mm: f64,
    /// Greatest turn of the joint in one step, rad.
    pub turn: f64,
    /// How far behind the eye a frame's midline begins, mm: the overlap with the frame before.
    pub overlap_mm: f64,
    /// Greatest median distance of the midlines of two frames where they overlap, mm.
    pub agree_mm: f64,
    /// Least confidence of a row that counts.
    pub confidence: f64,
    /// How near the joint must come to its start to be closed, mm.
    pub close_mm: f64,
    /// How nearly it must then run as at its start, rad.
    pub close_angle: f64,
    /// Way after which it may be closed, mm.
    pub close_after_mm: f64,
    /// Length before which the joint does not end: what looks like an end is then a long tack, and the operator is asked. mm;
    /// infinity of a joint that is known to be closed.
    pub ends_after_mm: f64,
    /// Longest joint, mm.
    pub longest_mm: f64,
    /// Frames looked at again where nothing was seen, before the operator is asked.
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
