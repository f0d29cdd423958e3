//! Positions at which the torch itself would have to jump: no machine's axes can follow it there.

use crate::PathRange;
use crate::finding::Finding;
use crate::torch::TorchPath;
use seamwright_geometry::Pose;
use seamwright_message::{Message, Unit};

/// Distance from a knot at which the torch pose is evaluated, mm.
const ASIDE_MM: f64 = 1e-7;
/// Changes of the tip (mm) or the direction (rad) below this are rounding.
const JUMP: f64 = 1e-6;
/// A jump is this many times the change over as long a way beside it.
const ABRUPT: f64 = 10.0;

/// Finds where the direction or the tip of a torch jumps at a knot of `path`, the path of pass `pass`.
pub fn torch_jumps(path: &dyn TorchPath, pass: usize) -> Vec<Finding> {
    let length = path.length();
    let inside = |s: &f64| *s > 3.0 * ASIDE_MM && *s < length - 3.0 * ASIDE_MM;
    let second = path.second(0.0).is_some();
    let jumps = |s: f64| {
        let mut found = jumps(|s| path.pose(s), s, pass);
        if found.is_empty() && second {
            found = jumps(|s| path.second(s).unwrap_or_else(|| path.pose(s)), s, pass);
        }
        found
    };
    path.knots().into_iter().filter(inside).flat_map(jumps).collect()
}

/// Reports jumps at `s`: of direction, tip or both.
fn jumps(pose: impl Fn(f64) -> Pose, s: f64, pass: usize) -> Vec<Finding> {
    let [far_before, before, after, far_after] = [-3.0, -1.0, 1.0, 3.0].map(|k| pose(s + k * ASIDE_MM));
    let abrupt = |change: fn(&Pose, &Pose) -> f64| {
        let beside = change(&far_before, &before).max(change(&after, &far_after));
        Some(change(&before, &after)).filter(|jump| *jump > JUMP && *jump > ABRUPT * beside)
    };
    // Of small angles, arc cosines would leave half the digits.
    let turn = abrupt(|a, b| 2.0 * (0.5 * a.direction.distance(b.direction)).min(1.0).asin()).map(|turn| {
        let message = Message::new("program-torch-direction-jumps").quantity("jump", turn.to_degrees(), Unit::Deg, 2);
        finding(message, "program-cure-direction-jumps", s, pass)
    });
    let way = abrupt(|a, b| a.point.distance(b.point)).map(|jump| {
        let message = Message::new("program-torch-tip-jumps").quantity("jump", jump, Unit::Mm, 3);
        finding(message, "program-cure-tip-jumps", s, pass)
    });
    turn.into_iter().chain(way).collect()
}

fn finding(message: Message, cure: &'static str, s: f64, pass: usize) -> Finding {
    Finding::error("turn", message.quantity("s", s, Unit::Mm, 3), pass, PathRange::at(s), Message::new(cure))
}
