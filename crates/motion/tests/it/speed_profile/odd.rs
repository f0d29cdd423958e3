//! Extreme and invalid paths.

use super::check::{check, check_ends};
use super::curves::{Saddle, Spline};
use super::random::{Path, natural};
use seamwright_machine::AxisLimits;
use seamwright_motion::LimitKind;
use seamwright_motion::speed_profile::{Channels, SpeedProfile, SpeedProfileError};
use seamwright_testkit::Random;

const LIMITS: AxisLimits = AxisLimits { speed: 100.0, acceleration: 1000.0, jerk: 20_000.0 };

/// Cubic pieces by parameter with the same limits for all channels.
fn spline(knots: &[f64], pieces: Vec<[Vec<f64>; 4]>) -> Path {
    let limits = vec![LIMITS; pieces[0][0].len()];
    Path::free(Spline { knots: knots.to_vec(), pieces, limits })
}

fn holds(path: &dyn Channels) -> SpeedProfile {
    let profile = SpeedProfile::new(path).unwrap();
    check_ends(path, &profile);
    let found = check(path, &profile, 20);
    assert!(found.used.iter().all(|u| *u <= 1.0 + 1e-9), "{found:?}");
    assert!(found.jump.iter().all(|j| *j <= 1e-9), "{found:?}");
    profile
}

/// A path with stops.
struct Stopping(Path, Vec<f64>);

impl Channels for Stopping {
    fn range(&self) -> (f64, f64) {
        self.0.range()
    }

    fn limits(&self) -> &[AxisLimits] {
        self.0.limits()
    }

    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        self.0.derivatives(u, before, out)
    }

    fn asked(&self, u: f64) -> f64 {
        self.0.asked(u)
    }

    fn breaks(&self) -> Vec<f64> {
        self.0.breaks()
    }

    fn stops(&self) -> Vec<f64> {
        self.1.clone()
    }
}

#[test]
fn tiny_displacements_and_near_duplicate_way_points() {
    let mut random = Random::of_case(5);
    for case in 0..300 {
        // Way-points 1e-9 to 1e-3 apart, alone or between distant ones.
        let tiny = random.decades(1e-9, 1e-3);
        let count = 2 + random.below(6);
        let axes = 1 + random.below(7);
        let far = random.below(2) == 0;
        let mut points: Vec<Vec<f64>> = Vec::new();
        for _ in 0..axes {
            let mut at = random.within(-3.0, 3.0);
            let step = |i: usize| if far && i.is_multiple_of(2) { 1.0 } else { tiny };
            points.push(
                (0..count)
                    .map(|i| {
                        at += step(i) * random.within(-1.0, 1.0);
                        at
                    })
                    .collect(),
            );
        }
        // Knots by distance, as chord-length splines have them, or even.
        let chord = |i: usize| points.iter().map(|p| (p[i] - p[i - 1]).powi(2)).sum::<f64>().sqrt();
        let by_chord = random.below(2) == 0;
        let mut knots = vec![0.0];
        for i in 1..count {
            knots.push(knots[i - 1] + if by_chord { chord(i) } else { 1.0 });
        }
        let limits = vec![LIMITS; axes];
        let path = Path::free(natural(knots, &points, limits));
        let profile = std::panic::catch_unwind(|| holds(&path));
        assert!(profile.is_ok(), "case {case}: {tiny:e} far {far} by chord {by_chord}, {axes} axes");
        let profile = SpeedProfile::without_jerk(&path, 500).unwrap();
        check_ends(&path, &profile);
        let found = check(&path, &profile, 10);
        assert!(found.used[..2].iter().all(|u| *u <= 1.0 + 1e-9), "case {case}: {found:?}");
    }
}

#[test]
fn short_segments_take_as_long_as_the_jerk_lets_them() {
    for length in [1e-9, 1e-6, 1e-3, 1.0] {
        let zero = || vec![0.0];
        let profile = holds(&spline(&[0.0, length], vec![[zero(), zero(), vec![1.0], zero()]]));
        // Four phases of full jerk.
        let best = 4.0 * (length / (2.0 * LIMITS.jerk)).cbrt();
        assert!(
            length > 0.1 || (profile.duration() / best - 1.0).abs() < 0.01,
            "{length}: {} {best}",
            profile.duration()
        );
    }
}

#[test]
fn stations_and_breaks_next_to_each_other() {
    let zero = || vec![0.0, 0.0];
    let piece = || [zero(), zero(), vec![1.0, -0.5], zero()];
    let whole = holds(&spline(&[0.0, 10.0], vec![piece()]));
    for gap in [0.0, 1e-15, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01] {
        let path = spline(&[0.0, 4.0, 4.0 + gap, 10.0 - gap, 10.0], vec![piece(), piece(), piece(), piece()]);
        let profile = holds(&path);
        assert!(
            (profile.duration() / whole.duration() - 1.0).abs() < 3e-3,
            "{gap} {} {}",
            profile.duration(),
            whole.duration()
        );
    }
}

#[test]
fn a_rotary_that_moves_while_the_tip_stands_still() {
    // Channel 0 is the tip: it rests over the middle third, while channel 1 turns.
    let zero = |x: f64| vec![0.0, x];
    let moves = |a: f64, b: f64| [vec![a, 0.0], vec![b, 0.0], vec![0.0, 1.0], vec![0.0, 0.0]];
    let still = [zero(0.0), zero(0.0), zero(1.0), zero(0.0)];
    let mut path = spline(
        &[0.0, 10.0, 20.0, 30.0],
        vec![[vec![0.01, 0.0], vec![-0.3, 0.0], vec![3.0, 1.0], zero(0.0)], still, moves(0.01, 0.0)],
    );
    path.tip = 1;
    path.asked[0].1 = 5.0;
    let profile = holds(&path);
    // There only the rotary bounds the speed.
    assert!(profile.speed(15.0) > 10.0, "{}", profile.speed(15.0));
    assert!(profile.speed(2.0) * 1.92 < 5.0 + 1e-6);
}

#[test]
fn a_cusp_told_as_a_stop_comes_to_rest_there() {
    // q = (x^2, x^3) about its cusp at 0: all first derivatives vanish.
    let cusp = |u: f64| [vec![0.0, 1.0], vec![1.0, 3.0 * u], vec![2.0 * u, 3.0 * u * u], vec![u * u, u * u * u]];
    let path = spline(&[-2.0, 2.0], vec![cusp(-2.0)]);
    let stopping = Stopping(path, vec![0.0]);
    let profile = holds(&stopping);
    let p = profile.at(profile.time(0.0), &mut 0);
    assert!(p.s.abs() < 1e-6 && p.v < 1e-4, "{p:?}");
    assert_eq!(profile.speed(0.0), 0.0);
    // A corner: each half takes as long as alone.
    let zero = || vec![0.0; 2];
    let line = |x: f64, y: f64| [zero(), zero(), vec![x, y], zero()];
    let corner = Stopping(spline(&[0.0, 5.0, 10.0], vec![line(1.0, 0.0), line(0.0, 1.0)]), vec![5.0]);
    let half = holds(&spline(&[0.0, 5.0], vec![line(1.0, 0.0)]));
    assert!((holds(&corner).duration() / (2.0 * half.duration()) - 1.0).abs() < 1e-9);
}

#[test]
fn near_singular_poses() {
    // A rotary that turns by half a turn within a width from 1 to 1e-7 of a line: q = atan(u / width).
    struct Passing(f64, Vec<AxisLimits>);
    impl Channels for Passing {
        fn range(&self) -> (f64, f64) {
            (-10.0, 10.0)
        }
        fn limits(&self) -> &[AxisLimits] {
            &self.1
        }
        fn derivatives(&self, u: f64, _before: bool, out: &mut [[f64; 3]]) -> f64 {
            let (w, r) = (self.0, u * u + self.0 * self.0);
            out[0] = [1.0, 0.0, 0.0];
            out[1] = [w / r, -2.0 * w * u / (r * r), w * (6.0 * u * u - 2.0 * w * w) / (r * r * r)];
            1.0
        }
        fn asked(&self, _u: f64) -> f64 {
            10.0
        }
        fn breaks(&self) -> Vec<f64> {
            Vec::new()
        }
    }
    for decade in 0..8 {
        let path =
            Passing(10f64.powi(-decade), vec![LIMITS, AxisLimits { speed: 1.0, acceleration: 10.0, jerk: 200.0 }]);
        let profile = holds(&path);
        assert!(profile.duration() < 10.0, "width {}: {} s", path.0, profile.duration());
    }
}

#[test]
fn stretches_in_which_nothing_moves() {
    let zero = || vec![0.0];
    let still = || [zero(), zero(), zero(), zero()];
    // After the cubic's end the path is constant: x^2 (3 - 2 x) also ends at rest by its parameter.
    let path = spline(&[0.0, 1.0, 2.0], vec![[vec![-2.0], vec![3.0], zero(), zero()], still()]);
    let profile = SpeedProfile::new(&path);
    assert!(profile.is_ok_and(|profile| profile.duration().is_finite()));
    let nothing = spline(&[0.0, 1.0], vec![still()]);
    assert_eq!(SpeedProfile::new(&nothing).unwrap_err(), SpeedProfileError::Still { from: 0.0, to: 1.0 });
    assert_eq!(SpeedProfile::without_jerk(&nothing, 10).unwrap_err(), SpeedProfileError::Still { from: 0.0, to: 1.0 });
}

#[test]
fn bad_limits_ranges_and_derivatives_are_said() {
    for value in [0.0, -1.0, f64::NAN] {
        for what in [LimitKind::Speed, LimitKind::Acceleration, LimitKind::Jerk] {
            let mut path = Saddle::new(10.0);
            let l = &mut path.limits[3];
            *match what {
                LimitKind::Speed => &mut l.speed,
                LimitKind::Acceleration => &mut l.acceleration,
                LimitKind::Jerk => &mut l.jerk,
            } = value;
            let error = SpeedProfile::new(&path).unwrap_err();
            assert!(matches!(error, SpeedProfileError::Limit { channel: 3, kind, .. } if kind == what), "{error}");
        }
    }
    for asked in [0.0, -3.0, f64::NAN] {
        let mut path = Saddle::new(10.0);
        path.speed = asked;
        assert!(matches!(SpeedProfile::new(&path), Err(SpeedProfileError::Asked { .. })), "{asked}");
    }
    let zero = || vec![0.0];
    for (knots, slope) in [([1.0, 1.0], 1.0), ([1.0, 0.0], 1.0), ([0.0, f64::NAN], 1.0), ([0.0, f64::INFINITY], 1.0)] {
        let path = spline(&knots, vec![[zero(), zero(), vec![slope], zero()]]);
        assert!(matches!(SpeedProfile::new(&path), Err(SpeedProfileError::Range { .. })), "{knots:?}");
    }
    for bad in [f64::NAN, f64::INFINITY] {
        let path = spline(&[0.0, 1.0], vec![[vec![bad], zero(), vec![1.0], zero()]]);
        assert!(matches!(SpeedProfile::new(&path), Err(SpeedProfileError::NotSmooth { channel: 0, .. })));
    }
    // A speed above any possibility is no error: the axes bound it.
    let mut path = Saddle::new(10.0);
    path.speed = 1e9;
    assert!(holds(&path).duration() < 8.1);
}
