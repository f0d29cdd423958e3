use super::random::ranges;
use crate::chain::Joints;
use crate::machine::Machine;

/// Number of halvings of the step: from a quarter of a range to about 1e-11 of it.
const HALVINGS: usize = 34;
/// Rounds over all axes between two halvings.
const ROUNDS: usize = 6;

/// Climbs from `start` to a local maximum of `height` within the ranges, by Hooke and Jeeves' exploratory moves with a
/// pattern move. Stops early above `enough`.
pub(super) fn climb(machine: &Machine, start: &Joints, enough: f64, height: impl Fn(&Joints) -> f64) -> (Joints, f64) {
    let ranges = ranges(machine);
    let (mut q, mut best) = (*start, height(start));
    let mut part = 0.25;
    for _ in 0..HALVINGS {
        for _ in 0..ROUNDS {
            let (before, level) = (q, best);
            for (axis, (low, high)) in ranges.iter().enumerate() {
                for sense in [1.0, -1.0] {
                    let mut next = q;
                    next[axis] = (q[axis] + sense * part * (high - low)).clamp(*low, *high);
                    let there = height(&next);
                    if there > best {
                        (q, best) = (next, there);
                        break;
                    }
                }
            }
            if best <= level || best > enough {
                break;
            }
            // Pattern move: repeats the joint displacement of all axes.
            let mut next = q;
            for ((value, old), (low, high)) in next.iter_mut().zip(&before).zip(&ranges) {
                *value = (2.0 * *value - old).clamp(*low, *high);
            }
            let there = height(&next);
            if there > best {
                (q, best) = (next, there);
            }
        }
        if best > enough {
            break;
        }
        part *= 0.5;
    }
    (q, best)
}
