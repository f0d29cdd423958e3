//! Sharpness of the turns of a path.

use super::axis::angle;

/// Points next to a turn that are left out (crossing scratches turn at once), and points of an arm before and after
/// them.
const NEAR: usize = 5;
const ARM: usize = 25;
/// Points to either side of a turn in all.
pub(super) const REACH: usize = NEAR + ARM;

/// Returns the angle between two directions, rad.
pub(super) fn turn(a: [f32; 2], b: [f32; 2]) -> f32 {
    angle(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])
}

/// Returns the turn of a path of about evenly spaced points at point `i`, beyond its bend before and behind, rad.
/// [`REACH`] points must lie before and behind it.
pub(super) fn sharpness(at: impl Fn(usize) -> [f32; 2], i: usize) -> f32 {
    let way = |from: usize, to: usize| {
        let (a, b) = (at(from), at(to));
        [b[0] - a[0], b[1] - a[1]]
    };
    let (first, last) = (i - REACH, i + REACH);
    let (before, after) = (i - NEAR - ARM / 2, i + NEAR + ARM / 2);
    let own = turn(way(first, before), way(before, i - NEAR)) + turn(way(i + NEAR, after), way(after, last));
    let between = turn(way(first, i - NEAR), way(i + NEAR, last));
    // The halves of an arm are half an arm apart; the two arms are an arm and twice the distance `NEAR` apart.
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
