//! What the follower keeps on simulated frames. The gates it does not keep yet: the example `joint_gates`.

use seamwright_cell::eyes::gates::follow;
use seamwright_cell::eyes::scene::{Kind, scene};
use seamwright_vision::joint::{End, Follower, Options};

#[test]
fn blank_frames_are_lost_and_nothing_is_confident() {
    let soak = std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|v| v.parse().ok()).unwrap_or(1);
    let mut follower = Follower::new(Options::default());
    for seed in 0..8 * soak {
        let outcome = follow(&mut follower, &scene(Kind::Blank, seed, 512));
        assert_eq!((outcome.end, outcome.phantom), (End::Lost, 0), "seed {seed}");
    }
}

#[test]
fn closed_joints_close_or_are_lost_and_nothing_is_confidently_wrong() {
    let mut follower = Follower::new(Options::default());
    let mut closed = 0;
    for seed in 0..8 {
        let outcome = follow(&mut follower, &scene(Kind::Loop, seed, 512));
        assert!(matches!(outcome.end, End::Closed | End::Lost), "seed {seed}: {:?}", outcome.end);
        assert!(outcome.errors.iter().all(|(error, confident)| !confident || *error < 2.0), "seed {seed}");
        closed += u32::from(outcome.end == End::Closed);
    }
    // All should: the gate is missed.
    assert!(closed >= 4, "{closed} of 8");
}
