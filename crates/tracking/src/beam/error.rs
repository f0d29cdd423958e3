/// Invalid settings or records of beam mode.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// An invalid value.
    #[error(transparent)]
    Value(#[from] crate::lead::Error),
    /// Frames would interrupt the weld too often.
    #[error("period_s = {period_s}: the weld may be interrupted every {every_s} s; allowed is that or more")]
    TooOften {
        /// Frame period, s.
        period_s: f64,
        /// Minimum period that the weld allows, s.
        every_s: f64,
    },
    /// A frame would interrupt the weld for too long.
    #[error("scan_s = {scan_s}: the weld may be interrupted for {longest_s} s; allowed is that or less")]
    TooLong {
        /// Duration of a frame, s.
        scan_s: f64,
        /// Maximum interruption that the weld allows, s.
        longest_s: f64,
    },
    /// The detection zone lies outside the frame.
    #[error(
        "at {speed_mm_s} mm/s the joint must be seen from {from_mm:.1} to {to_mm:.1} mm ahead, and the frame ends at \
         {reach_mm:.1} mm; {}",
        allowed(.speeds_that_work)
    )]
    ZoneOutside {
        /// The speed, mm/s.
        speed_mm_s: f64,
        /// Start of the zone, mm ahead of the beam.
        from_mm: f64,
        /// End of the zone, mm ahead of the beam.
        to_mm: f64,
        /// End of the frame, mm ahead of the beam.
        reach_mm: f64,
        /// Minimum and maximum speed whose zone lies inside the frame, mm/s; `None` without such a speed.
        speeds_that_work: Option<[f64; 2]>,
    },
    /// A stored deviation that does not cover the pass.
    #[error(
        "the pass goes from {from_mm} to {to_mm} mm of the stored seam, and deviations are stored from {first_mm} to \
         {last_mm} mm"
    )]
    NotCovered {
        /// Start of the pass in stored path length, mm.
        from_mm: f64,
        /// End of the pass in stored path length, mm.
        to_mm: f64,
        /// Start of the stored range, mm.
        first_mm: f64,
        /// End of the stored range, mm.
        last_mm: f64,
    },
}

fn allowed(speeds: &Option<[f64; 2]>) -> String {
    match speeds {
        Some([slow, fast]) => format!("allowed are {slow:.1} to {fast:.1} mm/s"),
        None => "no speed works with such a frame".to_owned(),
    }
}
