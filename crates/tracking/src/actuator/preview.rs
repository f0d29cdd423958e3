use glam::DVec2;

/// Number of samples to each side.
const PLACES: i32 = 10;

/// Slope factor: acceleration delays a slide through a jump, so a steeper curve that starts later ends earlier.
/// Measured: factor 1 gives twice the error, 0.7 three times.
const STEEP: f64 = 1.5;

/// Returns the present target of a slide that cannot jump; it starts before a jump of `target` (by time from now, s).
/// Of all curves within a slope limit, this one has the smallest maximum error within `horizon_s` to both sides. It is
/// the mean of the highest and the lowest such curve (McShane's extensions). The limit is `speed`, but at most
/// [`STEEP`] times the speed that `acceleration` reaches over the target's range there. A target that the slide can
/// follow stays unchanged.
pub(super) fn softened(target: impl Fn(f64) -> DVec2, horizon_s: f64, speed: DVec2, acceleration: DVec2) -> DVec2 {
    let times: [f64; 2 * PLACES as usize + 1] =
        std::array::from_fn(|i| horizon_s * f64::from(i as i32 - PLACES) / f64::from(PLACES));
    let values = times.map(target);
    let low = values.iter().copied().fold(DVec2::INFINITY, DVec2::min);
    let high = values.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max);
    let range = high - low;
    let reached = DVec2::new((acceleration.x * range.x).sqrt(), (acceleration.y * range.y).sqrt());
    let steep = speed.min(STEEP * reached);
    let (mut above, mut below) = (DVec2::NEG_INFINITY, DVec2::INFINITY);
    for (t, value) in times.iter().zip(values) {
        above = above.max(value - steep * t.abs());
        below = below.min(value + steep * t.abs());
    }
    0.5 * (above + below)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEED: DVec2 = DVec2::new(50.0, 20.0);
    const ACCELERATION: DVec2 = DVec2::new(400.0, 400.0);

    #[test]
    fn what_can_be_followed_is_left_as_it_is() {
        for i in 0..2000 {
            let p = f64::from(i);
            let (w, size) = (2.0 + 10.0 * (0.37 * p).sin().abs(), 1.0 + (1.3 * p).sin());
            // Keeps the target within the acceleration limit.
            let size = size.min(400.0 / (w * w));
            let target = |t: f64| DVec2::new(size * (w * t + p).sin(), 0.3 * size * (w * t - p).cos() + 2.0);
            let found = softened(target, 0.05, SPEED, ACCELERATION);
            assert!(found.distance(target(0.0)) < 1e-12, "{i}: {found} {}", target(0.0));
        }
    }

    #[test]
    fn a_step_is_begun_early_and_ended_late() {
        let step =
            |at: f64| softened(|t| DVec2::splat(if t + at < 0.0 { 0.0 } else { 1.0 }), 0.05, SPEED, ACCELERATION);
        assert!(step(-0.05).x.abs() < 1e-12 && (step(0.05).x - 1.0).abs() < 1e-12);
        let middle = step(0.0).x;
        assert!((middle - 0.5).abs() < 0.16, "{middle}");
        let steepest = (-50..50).map(|i| step(1e-3 * f64::from(i + 1)).x - step(1e-3 * f64::from(i)).x);
        assert!(steepest.fold(0.0, f64::max) < 0.16, "as fine as the places are");
    }
}
