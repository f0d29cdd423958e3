use crate::course::Course;

/// Comparison-integral: the faster axis makes a pulse every clock, the others follow in the same clock.
///
/// On the ellipse the integrals of `b^2 x dx` and of `-a^2 y dy` from the start are equal. A pulse from x to x + s
/// adds the trapezoid `b^2 (x s + 1/2)`, which is the exact integral. The faster axis is x if `b^2 |x| < a^2 |y|`
/// (tangent at most 45 degrees from x), else y. Each clock it makes one pulse. The slower axis makes one too if its
/// integral half a pulse ahead would not exceed that of the faster axis. In the deviation function, twice the sum of
/// both integrals, that is the sign of F half a pulse ahead on the slower axis. It is computed from the position in
/// integers, so no error accumulates.
///
/// An axis more than half a pulse behind before the clock catches up alone first. That happens next to the start, at a
/// change of the faster axis and at an end of the ellipse that is sharper than a pulse.
///
/// Guarantee: the slower axis is exact within half a pulse, since the ellipse moves by at most one pulse on it in a
/// clock. So every point is at most half a pulse from the ellipse, with two exceptions. Start and end are the lattice
/// points nearest to the path's (at most 0.71 pulse; the pulses to them less than 1). At a radius of curvature below
/// some pulses the distance is less than 1.
///
/// Saddle: x and y as above on their circle; z by a third comparison against the faster axis, see
/// `Grid::height_pulse`, in the same clock. z also moves by at most one pulse for one of the faster axis and is exact
/// within half a pulse: at most 0.71 pulse in space.
///
/// Weakness: along a diagonal both axes move, so that the speed along the seam rises to 1.41 of the clock's.
pub(crate) fn pulse(course: &Course) -> Option<[i64; 3]> {
    let at = course.at;
    let (open_x, open_y) = course.open();
    let (sx, sy) = course.signs();
    let grid = &course.grid;
    let x_first = match (open_x, open_y) {
        (false, false) => return course.closing_pulse(),
        (true, true) => grid.x_is_faster(at),
        (x, _) => x,
    };
    let [x, y, z] = at;
    let x_lags = |y: i64| lags(grid.deviation_at_half_pulses(2 * x + sx, 2 * y), 2 * x + sx, sx);
    let y_lags = |x: i64| lags(grid.deviation_at_half_pulses(2 * x, 2 * y + sy), 2 * y + sy, sy);
    let pulse = |lags: bool, sign: i64| if lags { sign } else { 0 };
    // An axis half a pulse behind catches up before the faster axis continues.
    let behind = if x_first { [0, pulse(open_y && y_lags(x), sy)] } else { [pulse(open_x && x_lags(y), sx), 0] };
    let height = grid.height_pulse([x + behind[0], y + behind[1], z]);
    if behind != [0, 0] || height != 0 {
        return Some([behind[0], behind[1], height]);
    }
    let (px, py) =
        if x_first { (sx, pulse(open_y && y_lags(x + sx), sy)) } else { (pulse(open_x && x_lags(y + sy), sx), sy) };
    Some([px, py, grid.height_pulse([x + px, y + py, z])])
}

/// True if the slower axis, half a pulse ahead of its position in the direction `sign`, is still behind the ellipse.
fn lags(deviation: i128, half_pulses: i64, sign: i64) -> bool {
    let outwards = half_pulses * sign > 0;
    if outwards { deviation < 0 } else { deviation > 0 }
}

#[cfg(test)]
mod tests {
    use crate::method::Method;
    use crate::path::Path;
    use crate::point::Point;
    use crate::request::Request;
    use crate::shape::Shape;
    use crate::testing::{Random, pulses};
    use glam::DVec2;

    fn request(shape: Shape, pulse_mm: f64) -> Request {
        pulses(Method::ComparisonIntegral, shape, pulse_mm)
    }

    fn assert_ends(path: &Path, points: &[Point], pulse: f64) {
        let end = (path.point(path.end_rad()) / pulse).round() * pulse;
        assert!(points[points.len() - 1].position.distance(end) < 1e-9, "{path:?} {pulse}");
    }

    #[test]
    fn at_most_half_a_pulse_off_the_papers_ellipse() {
        for pulse in [1.0, 0.1, 0.01, 0.001] {
            let s = request(Shape::ELLIPSE_2015, pulse).statistics().unwrap();
            assert!(s.deviation_max_mm <= 0.5 * pulse * (1.0 + 1e-9), "{pulse} {}", s.deviation_max_mm);
            assert!(s.end_error_mm < 1e-12);
        }
    }

    /// From an octant of a small circle the points are those nearest to it.
    #[test]
    fn a_small_circle() {
        let (start_mm, end_mm) = (DVec2::new(0.0, 6.0), Some(DVec2::new(6.0, 0.0)));
        let shape = Shape::Ellipse { a_mm: 6.0, b_mm: 6.0, start_mm, end_mm, clockwise: true };
        let points: Vec<_> =
            request(shape, 1.0).interpolate().unwrap().map(|p| (p.position.x as i32, p.position.y as i32)).collect();
        assert_eq!(points, [(0, 6), (1, 6), (2, 6), (3, 5), (4, 4), (5, 3), (6, 2), (6, 1), (6, 0)]);
    }

    #[test]
    fn at_most_half_a_pulse_off_every_ellipse() {
        let mut random = Random::new(8);
        for _ in 0..400 {
            let shape = random.ellipse(0.5, 20.0);
            let pulse = random.log(0.002, 0.1);
            let Ok(run) = request(shape, pulse).interpolate() else { continue };
            let path = run.path().clone();
            let (a, b) = path.plan_axes();
            let sharp = a.min(b).powi(2) / a.max(b) < 4.0 * pulse;
            let points: Vec<Point> = run.collect();
            let n = points.len();
            for (i, p) in points.iter().enumerate() {
                let off = path.nearest(p.position).distance_mm / pulse;
                let bound = if sharp || i < 2 || i + 3 >= n { 1.0 } else { 0.5 };
                assert!(off < bound + 1e-3, "{shape:?} {pulse}: {off} at {i} of {n}");
            }
            for w in points.windows(2) {
                let step = (w[1].position - w[0].position) / pulse;
                assert!((step.abs().max_element() - 1.0).abs() < 1e-9, "{shape:?}");
            }
            assert_ends(&path, &points, pulse);
        }
    }

    #[test]
    fn off_a_saddle() {
        let mut random = Random::new(9);
        for i in 0..150 {
            let shape = random.saddle(2.0, 20.0, if i % 2 == 0 { 0.8 } else { 0.999 });
            let pulse = random.log(0.005, 0.1);
            let run = request(shape, pulse).interpolate().unwrap();
            let path = run.path().clone();
            let points: Vec<Point> = run.collect();
            let n = points.len();
            for (i, p) in points.iter().enumerate() {
                let off = path.nearest(p.position).distance_mm / pulse;
                if i >= 3 && i + 5 < n {
                    assert!(off < 0.7072, "{shape:?} {pulse}: {off} at {i} of {n}");
                }
            }
            assert_ends(&path, &points, pulse);
        }
    }
}
