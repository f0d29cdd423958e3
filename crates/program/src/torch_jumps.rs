//! Positions at which the torch itself would have to jump: no machine's axes can follow it there.

use crate::{Finding, TorchPath};
use seamwright_geometry::Pose;

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
        let turn = turn.to_degrees();
        let message = format!("the torch's direction would jump by {turn:.2} degrees at the corner at s = {s:.3} mm");
        let cure = "let one pass end there and another begin after it (in a job order.parts = \"at_corners\", tacks \
                    elsewhere); or round the corner in the seam; in a butt joint weld without work and travel angle";
        finding((message, cure), s, pass)
    });
    let way = abrupt(|a, b| a.point.distance(b.point)).map(|jump| {
        let message = format!("the torch's tip would jump by {jump:.3} mm at the corner at s = {s:.3} mm");
        let cure = "let one pass end there and another begin after it (in a job order.parts = \"at_corners\", tacks \
                    elsewhere), or round the corner in the seam";
        finding((message, cure), s, pass)
    });
    turn.into_iter().chain(way).collect()
}

fn finding((message, cure): (String, &str), s: f64, pass: usize) -> Finding {
    Finding {
        kind: "turn",
        message: message.into(),
        pass,
        from_mm: s,
        to_mm: s,
        cure: Some(cure.into()),
        allowed: false,
    }
}
