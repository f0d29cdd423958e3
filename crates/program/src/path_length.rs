//! Comparison of path lengths.
//!
//! A path length is computed in several ways: arc length of the seam, sums of spans, even divisions of a pass, numbers
//! of a file. These agree only to rounding. Every decision by a comparison of two path lengths goes through this
//! module. So all parts of the program agree whether a position is on the weld.

/// Path lengths that differ by no more than this are the same position, mm.
///
/// Arc length is exact to 1e-9 mm. Doubles of a kilometre (the longest seam) have a spacing of 1e-10 mm. A number that
/// an error prints with six digits is off by half of this. A nanometre is above all rounding and far below the
/// resolution of any machine.
pub const SAME_POSITION_MM: f64 = 1e-6;

/// True if two path lengths (mm) are the same position.
pub fn is_same_position(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME_POSITION_MM
}

/// True if path length `s` lies beyond `end`, mm.
pub fn is_beyond(s: f64, end: f64) -> bool {
    s > end + SAME_POSITION_MM
}

/// True if path length `s` lies before `start`, mm.
pub fn is_before(s: f64, start: f64) -> bool {
    s < start - SAME_POSITION_MM
}

/// Number of equal parts of at most `step` mm that make up `length` mm, at least 1. Saturates at the largest integer.
pub fn parts_of(length: f64, step: f64) -> usize {
    ((length - SAME_POSITION_MM) / step).ceil().max(1.0) as usize
}

/// The path length at which part `i` of `count` equal parts of `length` mm starts. The last part ends at exactly
/// `length`: `length * count / count` may round beyond it.
pub fn part_start(length: f64, i: usize, count: usize) -> f64 {
    length * (i as f64 / count as f64)
}
