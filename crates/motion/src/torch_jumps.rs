//! Places at which the torch itself would have to jump: no axes can follow it there, whatever the machine.

use seamwright_geometry::Pose;
use seamwright_program::{Finding, TorchPath};

/// Distance from a knot at which the torch is looked at, mm.
const ASIDE_MM: f64 = 1e-7;
/// Changes of the tip (mm) or the direction (rad) below this are rounding.
const JUMP: f64 = 1e-6;
/// A jump is this many times the change over as long a way beside it.
const ABRUPT: f64 = 10.0;

/// A finding for every knot of `path`, the path of pass `pass`, at which the tip or the direction of a torch jumps.
pub(crate) fn torch_jumps(path: &dyn TorchPath, pass: usize) -> Vec<Finding> {
    let length = path.length();
    let inside = |s: &f64| *s > 3.0 * ASIDE_MM && *s < length - 3.0 * ASIDE_MM;
    let second = path.second(0.0).is_some();
    let knots = path.knots().into_iter().filter(inside);
    knots
        .filter_map(|s| {
            let first = jump(|s| path.pose(s), s);
            let of_second = || jump(|s| path.second(s).unwrap_or_else(|| path.pose(s)), s);
            let message = first.or_else(|| second.then(of_second).flatten())?;
            Some(finding(message, s, pass))
        })
        .collect()
}

/// What jumps at `s`, in words.
fn jump(pose: impl Fn(f64) -> Pose, s: f64) -> Option<String> {
    let [far_before, before, after, far_after] = [-3.0, -1.0, 1.0, 3.0].map(|k| pose(s + k * ASIDE_MM));
    let abrupt = |change: &dyn Fn(&Pose, &Pose) -> f64| {
        let beside = change(&far_before, &before).max(change(&after, &far_after));
        Some(change(&before, &after)).filter(|jump| *jump > JUMP && *jump > ABRUPT * beside)
    };
    // Of small angles, arc cosines would leave half the digits.
    if let Some(turn) = abrupt(&|a, b| 2.0 * (0.5 * a.direction.distance(b.direction)).min(1.0).asin()) {
        let turn = turn.to_degrees();
        return Some(format!("the torch's direction would jump by {turn:.2} degrees at the corner at s = {s:.3} mm"));
    }
    let jump = abrupt(&|a, b| a.point.distance(b.point))?;
    Some(format!("the torch's tip would jump by {jump:.3} mm at the corner at s = {s:.3} mm"))
}

fn finding(message: String, s: f64, pass: usize) -> Finding {
    Finding {
        kind: "turn",
        message,
        pass,
        from_mm: s,
        to_mm: s,
        cure: "let one pass end there and another begin after it (in a job order.parts = \"at_corners\", tacks elsewhere), \
               or round the corner in the seam"
            .to_owned(),
        allowed: false,
    }
}
