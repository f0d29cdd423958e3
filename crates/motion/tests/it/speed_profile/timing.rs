use super::check::{check, check_ends};
use super::curves::{Finely, Saddle, Spline};
use seamwright_motion::speed_profile::SpeedProfile;

/// Maximum relative slowness of a profile against the fine grid of toppra.
const WITHIN: f64 = 1e-3;

#[test]
fn without_jerk_as_fast_as_the_fine_grid_of_toppra() {
    for (spline, best) in Spline::reference(f64::INFINITY) {
        let profile = SpeedProfile::new(&spline).unwrap();
        check_ends(&spline, &profile);
        let found = check(&spline, &profile, 20);
        let slower = profile.duration() / best - 1.0;
        assert!(slower.abs() < WITHIN && found.used[0] <= 1.0 && found.used[1] <= 1.0);
        // Coarse grids are slower, but not beyond the limits either.
        for (cells, slower) in [(100, 1e-2), (400, WITHIN)] {
            let coarse = SpeedProfile::without_jerk(&spline, cells).unwrap();
            let found = check(&spline, &coarse, 20);
            assert!(coarse.duration() >= profile.duration() && coarse.duration() < (1.0 + slower) * best);
            assert!(found.used[0] <= 1.0 && found.used[1] <= 1.0, "{found:?}");
        }
    }
}

#[test]
fn with_jerk_within_limits_and_little_slower() {
    for jerk in [10.0, 1.5] {
        for (spline, best) in Spline::reference(jerk) {
            let profile = SpeedProfile::new(&spline).unwrap();
            check_ends(&spline, &profile);
            let found = check(&spline, &profile, 20);
            let slower = profile.duration() / best - 1.0;
            // Limits of jerk can only slow it.
            assert!(slower > -1e-4 && slower < if jerk > 5.0 { 0.015 } else { 0.1 });
            assert!(found.used.iter().all(|u| *u <= 1.0) && found.jump.iter().all(|j| *j < 1e-9), "{found:?}");
        }
    }
}

#[test]
fn cells_chosen_by_the_profile_lose_little_against_a_thousand() {
    let fine = Spline::reference(10.0).into_iter().map(|(spline, _)| Finely::new(spline, 1000));
    for (fine, (spline, _)) in fine.zip(Spline::reference(10.0)) {
        let (few, many) = (SpeedProfile::new(&spline).unwrap(), SpeedProfile::new(&fine).unwrap());
        check_ends(&fine, &many);
        let found = check(&fine, &many, 20);
        let slower = few.duration() / many.duration() - 1.0;
        assert!(many.cells() >= 1000 && slower > -2e-4 && slower < 1e-3);
        assert!(found.used.iter().all(|u| *u <= 1.0) && found.jump.iter().all(|j| *j < 1e-9), "{found:?}");
    }
}

#[test]
fn the_saddle_as_fast_as_by_another_method() {
    let profile = SpeedProfile::new(&Saddle::new(10.0)).unwrap();
    // By IPOPT in time, 400 steps; and by reachability without jerk.
    assert!((profile.duration() / 8.1225 - 1.0).abs() < 2e-3, "{}", profile.duration());
    let profile = SpeedProfile::new(&Saddle::new(f64::INFINITY)).unwrap();
    assert!((profile.duration() / 8.023 - 1.0).abs() < 1e-3, "{}", profile.duration());
    check_ends(&Saddle::new(f64::INFINITY), &profile);
}
