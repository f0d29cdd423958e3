//! Division of a path into the cells of a speed profile.

use super::channels::Channels;
use super::rest_to_rest::RestToRest;
use crate::stretch::Stretch;
use seamwright_machine::AxisLimits;

/// Number of cells of a path without breaks, if evenly spaced.
const CELLS: f64 = 60.0;
/// Cells of the acceleration and of the deceleration phase.
const CELLS_AT_REST: usize = 6;
/// Neighbouring cells grow by this factor away from rest.
const GROWTH: f64 = 1.4;
/// Minimum number of cells between two breaks.
const CELLS_BETWEEN_BREAKS: f64 = 1.0;
/// Minimum and maximum length of an acceleration or deceleration phase, as a fraction of the path.
const PART_AT_REST: (f64, f64) = (1e-6, 0.25);

/// Stations closer than this fraction of the path are merged.
const SAME: f64 = 1e-9;

/// The map and the first stations (by `tau`) of the `piece` of `path` between two stops.
pub(crate) fn stations(path: &dyn Channels, limits: &[AxisLimits], piece: Stretch) -> (RestToRest, Vec<f64>) {
    let Stretch { from, to } = piece;
    let length = to - from;
    let [least, most] = [PART_AT_REST.0 * length, PART_AT_REST.1 * length];
    let breaks = path.breaks();
    let zone = |u: f64, before: bool| {
        let zone = (0.5 * run_up(path, limits, u, before)).clamp(least, most);
        // A break very near the border becomes the border.
        let near = breaks.iter().map(|b| (b - u).abs()).find(|away| (away - zone).abs() < SAME * length);
        near.unwrap_or(zone)
    };
    let map = RestToRest::new(from, to, zone(from, false), zone(to, true));
    let [up, down] = map.borders();
    // A break this near to rest is passed so slowly that it is negligible.
    let near = 1e-7 * length;
    let inside = breaks.iter().filter(|u| **u > from + near && **u < to - near).map(|u| map.tau(*u));
    // The map changes exactly at its borders: breaks must not replace them.
    let at_border = |tau: f64| (tau - up).abs() < SAME * map.length() || (tau - down).abs() < SAME * map.length();
    let mut fixed: Vec<f64> = inside.filter(|tau| !at_border(*tau)).collect();
    fixed.extend([0.0, up, down, map.length()]);
    fixed.sort_by(f64::total_cmp);
    fixed.dedup_by(|a, b| *a - *b < SAME * map.length());
    if let Some(last) = fixed.last_mut() {
        *last = map.length();
    }
    let widest = length / CELLS;
    let finest = [up, map.length() - down].map(|zone| zone / CELLS_AT_REST as f64);
    let own = path.bends().into_iter().filter(|bend| bend.at > from && bend.at < to);
    let bends: Vec<(f64, f64)> = own.map(|bend| (map.tau(bend.at), bend.rounded_over)).collect();
    let width = |tau: f64| {
        let near = |away: f64, finest: f64| finest + (GROWTH - 1.0) * away.max(0.0);
        let ends = near(tau - up, finest[0]).min(near(down - tau, finest[1])).min(widest);
        bends.iter().fold(ends, |least, (bend, finest)| least.min(near((tau - bend).abs(), *finest)))
    };
    let mut tau = vec![0.0];
    for w in fixed.windows(2) {
        let stretch = Stretch { from: w[0], to: w[1] };
        divide(&mut tau, stretch, |t| width(t).min((w[1] - w[0]) / CELLS_BETWEEN_BREAKS));
    }
    (map, tau)
}

/// Adds stations after the start of a stretch up to its end, about `width` apart.
fn divide(tau: &mut Vec<f64>, stretch: Stretch, width: impl Fn(f64) -> f64) {
    let Stretch { from, to } = stretch;
    let begin = tau.len();
    let mut at = from;
    while at < to {
        let step = width(at);
        let step = step.min(width(at + step) * GROWTH).max((to - from) * 1e-6);
        at += step;
        tau.push(at);
    }
    // The last station is beyond the end: all are scaled down.
    let last = tau.len() - 1;
    let scale = (to - from) / (tau[last] - from);
    tau[begin..].iter_mut().for_each(|t| *t = from + scale * (*t - from));
    tau[last] = to;
}

/// Distance to reach the maximum speed at `u` from rest, with the path's derivatives of `u` throughout.
fn run_up(path: &dyn Channels, limits: &[AxisLimits], u: f64, before: bool) -> f64 {
    let mut derivatives = vec![[0.0; 3]; limits.len()];
    let tip = path.derivatives(u, before, &mut derivatives);
    let (from, to) = path.range();
    let inside = u + 1e-6 * if before { from - to } else { to - from };
    let mut least = AxisLimits { speed: path.asked(inside) / tip.abs(), ..AxisLimits::NONE };
    for ([q1, ..], l) in derivatives.iter().zip(limits) {
        least = least.min(l.divided(q1.abs()));
    }
    let AxisLimits { speed, acceleration, jerk } = least;
    let time = if speed * jerk > acceleration * acceleration {
        speed / acceleration + acceleration / jerk
    } else {
        2.0 * (speed / jerk).sqrt()
    };
    let distance = 0.5 * speed * time;
    if distance.is_nan() { f64::INFINITY } else { distance }
}
