//! How sharply a way turns.

use super::axis::angle;

/// Places next to a turn that are left out (a scratch that meets another one turns at once), and those before and after that tell ...
const NEAR: usize = 5;
const ARM: usize = 25;
/// ... so many to either side in all.
pub(super) const REACH: usize = NEAR + ARM;

/// The angle between two ways, rad.
pub(super) fn turn(a: [f32; 2], b: [f32; 2]) -> f32 {
    angle(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])
}

/// By how much a way of places about evenly apart turns at place `i` beyond its bend before and behind it, rad. [`REACH`] places are
/// before it and behind it.
pub(super) fn sharpness(at: impl Fn(usize) -> [f32; 2], i: usize) -> f32 {
    let way = |from: usize, to: usize| {
        let (a, b) = (at(from), at(to));
        [b[0] - a[0], b[1] - a[1]]
    };
    let (first, last) = (i - REACH, i + REACH);
    let (before, after) = (i - NEAR - ARM / 2, i + NEAR + ARM / 2);
    let own = turn(way(first, before), way(before, i - NEAR)) + turn(way(i + NEAR, after), way(after, last));
    let between = turn(way(first, i - NEAR), way(i + NEAR, last));
    // Two halves of an arm are half an arm apart, the two arms an arm and twice the way near the place.
    (between - own * (2 * NEAR + ARM) as f32 / ARM as f32).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bend_is_not_sharp_and_a_corner_is_as_sharp_as_it_turns() {
        for (curvature, corner) in [(0.0, 0.0f32), (0.012, 0.0), (-0.02, 0.0), (0.0, 0.7), (0.0, -1.2), (0.008, 0.9)] {
            let mut at = [3.0, -7.0f32];
            let mut heading = 0.4f32;
            let places: Vec<[f32; 2]> = (0..=2 * REACH)
                .map(|k| {
                    heading += curvature + if k == REACH { corner } else { 0.0 };
                    at = [at[0] + heading.cos(), at[1] + heading.sin()];
                    at
                })
                .collect();
            let found = sharpness(|k| places[k], REACH);
            assert!((found - corner.abs()).abs() < 0.06, "{curvature} {corner}: {found}");
        }
    }
}
