use crate::course::Course;

/// Point-by-point comparison: every clock one axis makes one pulse.
///
/// Plan: if `F = b^2 x^2 + a^2 y^2 - a^2 b^2 >= 0` the pulse goes inwards along the axis on which the path, in this
/// quadrant, approaches the centre; if `F < 0` it goes outwards along the other one. F is computed from the position in
/// integers, so no error accumulates and all quadrants are alike.
///
/// Guarantee: a pulse either stays on its side of the ellipse and comes nearer to it, or crosses it and ends less than
/// a pulse from the crossing. So after the start every point is less than one pulse from the ellipse.
///
/// Saddle: x and y as above on their circle; z by a third comparison, see `Grid::height_pulse`, whose pulses come
/// first. After its own clocks z is exact within half a pulse; after a pulse of x or y it lags by at most one more. In
/// space every point is less than two pulses from the saddle (measured: 1.26).
///
/// Weakness: pulses along one axis at a time, so that along a diagonal the torch makes 1.41 pulses per pulse of path
/// length: the speed along the seam falls to 0.71 of the clock's (lower while z moves).
pub(crate) fn pulse(course: &Course) -> Option<[i64; 3]> {
    let at = course.at;
    let open = course.open();
    if open == (false, false) {
        return course.closing_pulse();
    }
    let height = course.grid.height_pulse(at);
    if height != 0 {
        return Some([0, 0, height]);
    }
    let (sx, sy) = course.signs();
    let outside = course.grid.deviation(at) >= 0;
    // In quadrants 0 and 2 of counter-clockwise motion x comes nearer to the centre and y goes away from it.
    let x_goes_inwards = sx != sy;
    let x = match open {
        (true, true) => outside == x_goes_inwards,
        (x, _) => x,
    };
    Some(if x { [sx, 0, 0] } else { [0, sy, 0] })
}

#[cfg(test)]
mod tests {
    use crate::method::Method;
    use crate::request::Request;
    use crate::shape::Shape;
    use crate::testing::{Random, pulses};
    use glam::DVec2;
    use std::f64::consts::TAU;

    fn request(shape: Shape, pulse_mm: f64) -> Request {
        pulses(Method::PointByPoint, shape, pulse_mm)
    }

    /// The textbooks' arc of radius 6 from (0, 6) clockwise to (6, 0), pulse for pulse.
    #[test]
    fn the_textbook_arc() {
        let (start_mm, end_mm) = (DVec2::new(0.0, 6.0), Some(DVec2::new(6.0, 0.0)));
        let shape = Shape::Ellipse { a_mm: 6.0, b_mm: 6.0, start_mm, end_mm, clockwise: true };
        let points: Vec<_> = request(shape, 1.0).interpolate().unwrap().map(|p| p.position).collect();
        let moves: String = points
            .windows(2)
            .map(|w| match (w[1].x - w[0].x, w[1].y - w[0].y) {
                (1.0, 0.0) => 'x',
                (0.0, -1.0) => 'y',
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(moves, "yxxxxyxyxyyy");
    }

    #[test]
    fn less_than_a_pulse_off_every_ellipse() {
        let mut random = Random::new(6);
        for _ in 0..400 {
            let shape = random.ellipse(0.5, 20.0);
            let pulse = random.log(0.002, 0.1);
            let Ok(run) = request(shape, pulse).interpolate() else { continue };
            let path = run.path().clone();
            let (mut last, mut reach): (Option<crate::Point>, f64) = (None, 0.0);
            for p in run {
                let off = path.nearest(p.position).distance_mm / pulse;
                assert!(off < 1.0 + 1e-3, "{shape:?} {pulse}: {off}");
                if let Some(l) = last {
                    assert!((l.position.distance(p.position) / pulse - 1.0).abs() < 1e-9);
                }
                reach = reach.max(path.direction() * (p.u_rad - path.start_rad()));
                last = Some(p);
            }
            let end = (path.point(path.end_rad()) / pulse).round() * pulse;
            let last = last.unwrap();
            assert!(last.position.distance(end) < 1e-9, "{shape:?} {pulse}: {last:?} {end}");
            let slack = 3.0 * pulse / path.plan_axes().0.min(path.plan_axes().1);
            assert!((reach - path.span_rad()).abs() < slack, "{shape:?} {pulse} {reach}");
        }
    }

    #[test]
    fn less_than_two_pulses_off_a_saddle() {
        let mut random = Random::new(7);
        for i in 0..150 {
            let shape = random.saddle(2.0, 20.0, if i % 2 == 0 { 0.8 } else { 0.999 });
            let pulse = random.log(0.005, 0.1);
            let run = request(shape, pulse).interpolate().unwrap();
            let path = run.path().clone();
            let mut last = None;
            for p in run {
                let off = path.nearest(p.position).distance_mm / pulse;
                assert!(off < 2.0, "{shape:?} {pulse}: {off} at {p:?}");
                last = Some(p);
            }
            let last = last.unwrap();
            let end = (path.point(path.end_rad()) / pulse).round() * pulse;
            assert!(last.position.distance(end) < 1e-9, "{shape:?} {pulse}");
            assert!((last.u_rad - path.end_rad()).abs() < 5.0 * pulse / path.plan_axes().0, "{shape:?}");
        }
    }

    #[test]
    fn a_full_turn_repeats_without_drift() {
        let off = |sweep_rad| {
            let shape = Shape::Saddle { nozzle_radius_mm: 5.0, shell_radius_mm: 8.0, start_rad: 0.3, sweep_rad };
            request(shape, 0.01).statistics().unwrap().deviation_max_mm
        };
        assert!((off(10.0 * TAU) - off(TAU)).abs() < 1e-12);
    }
}
