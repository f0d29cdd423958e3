//! Channels in groups for SIMD instructions.

/// Number of channels in a group.
pub(super) const LANES: usize = 4;

/// A group of channels at one point; the channels that fill up the last group never move.
pub(super) struct Lanes {
    /// First derivatives by the channels' accelerations.
    pub(super) first: [f64; LANES],
    /// The second ones likewise.
    pub(super) second: [f64; LANES],
    /// The slabs `|a - slope x| <= half`: their half heights,
    pub(super) half: [f64; LANES],
    /// and their slopes.
    pub(super) slope: [f64; LANES],
}

impl Lanes {
    /// Builds the bounds of channels with these derivatives; `along` is twice the distance from the start of the cell.
    /// Also returns the maximum second derivative of channels that do not bound the acceleration.
    #[inline(always)]
    pub(super) fn new(first: [f64; LANES], second: [f64; LANES], along: f64) -> (Self, f64) {
        let mut lanes = Self { first, second, half: [f64::INFINITY; LANES], slope: [0.0; LANES] };
        let mut steepest = [0.0; LANES];
        for k in 0..LANES {
            // |q'' (x + along a) + q' a| <= 1; if that does not depend on a, it bounds x.
            let a = first[k] + along * second[k];
            let by = 1.0 / a;
            let bounds = a.abs() > 1e-12 * (along * second[k]).abs();
            lanes.half[k] = if bounds { by.abs() } else { f64::INFINITY };
            lanes.slope[k] = if bounds { -second[k] * by } else { 0.0 };
            steepest[k] = if bounds { 0.0 } else { second[k].abs() };
        }
        (lanes, steepest.into_iter().fold(0.0, larger))
    }
}

/// The smaller of two numbers, neither of them NaN.
pub(super) fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The larger of two numbers, neither of them NaN: unlike `max` one instruction, also for several lanes.
pub(super) fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
