use crate::sample::Sample;
use glam::DVec3;
use seamwright_geometry::{Pose, angle_between};
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_motion::corners::foot_in_blend;
use seamwright_program::{PathRange, TorchPath};

/// Finds the planned path's nearest point to the true tip, and the distance of the tip from the seam.
pub(super) fn measure(machine: &Machine, path: &dyn TorchPath, planned: &PassMotion, sample: &mut Sample) {
    let tip = machine.forward(&sample.q);
    let whole = PathRange::up_to(path.length());
    // In blends the planned path differs from the seam, on which the nearest point would jump at the corner.
    let s = match planned.path.blends().is_empty() {
        // The tip may stop or turn back while the axes move on: their positions define the point.
        _ if path.points().is_some() => planned.path.foot(machine, &sample.q, sample.set.profile.s),
        true => path.foot(tip.point, sample.set.profile.s, whole),
        false => planned.tip_path(machine).foot(tip.point, sample.set.profile.s, whole),
    };
    sample.tip_s = s;
    let along = path.line(s).1;
    let woven = planned.path.is_woven();
    let errors = |tip: &Pose, pose: &dyn Fn(f64) -> Pose| match foot_in_blend(&planned.path, pose, tip.point, s) {
        _ if path.points().is_some() => {
            (tip.point.distance(pose(s).point), angle_between(tip.direction, pose(s).direction))
        }
        Some(foot) => (tip.point.distance(pose(foot).point), angle_between(tip.direction, pose(foot).direction)),
        None if woven => {
            let foot = nearest(|s| pose(s).point, tip.point, sample.set.profile.s, path.length());
            (tip.point.distance(pose(foot).point), angle_between(tip.direction, pose(foot).direction))
        }
        None => {
            let off = tip.point - pose(s).point;
            ((off - off.dot(along) * along).length(), angle_between(tip.direction, pose(s).direction))
        }
    };
    (sample.path_error, sample.attitude_error) = errors(&tip, &|s| path.pose(s));
    // With two torches the larger error counts.
    if path.second(s).is_some() {
        let second = errors(&machine.forward_of(1, &sample.q), &|s| path.second(s).unwrap_or_else(|| path.pose(s)));
        sample.path_error = sample.path_error.max(second.0);
        sample.attitude_error = sample.attitude_error.max(second.1);
    }
}

/// Finds the path length near `guess`, from 0 to `length_mm`, at which the path `place` is nearest to `point`. Searches
/// both ways from `guess` while the distance falls. Steps start in proportion to the distance and grow; thirds refine
/// the result. The distance found is never below the true minimum.
fn nearest(place: impl Fn(f64) -> DVec3, point: DVec3, guess: f64, length_mm: f64) -> f64 {
    let away = |s: f64| place(s).distance_squared(point);
    let start = away(guess);
    let mut best = (start, guess, start.sqrt() / 16.0);
    for sense in [-1.0, 1.0] {
        let (mut s, mut step, mut last) = (guess, start.sqrt() / 16.0, start);
        while let next = (s + sense * step).clamp(0.0, length_mm)
            && (next - s).abs() > 0.0
            && away(next) < last
        {
            (s, last) = (next, away(next));
            if last < best.0 {
                best = (last, s, step);
            }
            step *= 1.5;
        }
    }
    let (mut low, mut high) = ((best.1 - best.2).max(0.0), (best.1 + 1.5 * best.2).min(length_mm));
    if best.1 < guess {
        (low, high) = ((best.1 - 1.5 * best.2).max(0.0), (best.1 + best.2).min(length_mm));
    }
    for _ in 0..24 {
        let [a, b] = [low + (high - low) * 0.4, low + (high - low) * 0.6];
        if away(a) < away(b) { high = b } else { low = a }
    }
    let found = 0.5 * (low + high);
    if away(found) < best.0 { found } else { best.1 }
}
