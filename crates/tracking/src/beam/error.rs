/// What cannot work in beam mode.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A value that cannot be.
    #[error(transparent)]
    Value(#[from] crate::lead::Error),
    /// Frames would interrupt the weld too often.
    #[error("period_s = {period_s}: the weld may be interrupted every {every_s} s; allowed is that or more")]
    TooOften {
        /// From frame to frame, s.
        period_s: f64,
        /// What the weld allows, s.
        every_s: f64,
    },
    /// A frame would interrupt the weld for too long.
    #[error("scan_s = {scan_s}: the weld may be interrupted for {longest_s} s; allowed is that or less")]
    TooLong {
        /// Time that a frame takes, s.
        scan_s: f64,
        /// What the weld allows, s.
        longest_s: f64,
    },
    /// What would have to be looked at lies outside of the frame.
    #[error(
        "at {speed_mm_s} mm/s the joint must be seen from {from_mm:.1} to {to_mm:.1} mm ahead, and the frame ends at \
         {reach_mm:.1} mm; {}",
        allowed(.speeds_that_work)
    )]
    ZoneOutside {
        /// The speed, mm/s.
        speed_mm_s: f64,
        /// Where the zone would begin, mm ahead of the beam.
        from_mm: f64,
        /// Where it would end.
        to_mm: f64,
        /// Where the frame ends.
        reach_mm: f64,
        /// The slowest and the fastest speed whose zone lies inside, mm/s; none if no speed's does.
        speeds_that_work: Option<[f64; 2]>,
    },
    /// A stored deviation that does not cover the pass.
    #[error(
        "the pass goes from {from_mm} to {to_mm} mm of the stored seam, and deviations are stored from {first_mm} to \
         {last_mm} mm"
    )]
    NotCovered {
        /// Begin of the pass by the stored path length, mm.
        from_mm: f64,
        /// Its end.
        to_mm: f64,
        /// What is stored.
        first_mm: f64,
        /// To here.
        last_mm: f64,
    },
}

fn allowed(speeds: &Option<[f64; 2]>) -> String {
    match speeds {
        Some([slow, fast]) => format!("allowed are {slow:.1} to {fast:.1} mm/s"),
        None => "no speed works with such a frame".to_owned(),
    }
}
