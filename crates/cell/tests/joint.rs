//! What the follower keeps on simulated frames: the gates of `bench vision`.

use seamwright_cell::eyes::gates::{follow, joint_gates};
use seamwright_cell::eyes::scene::{Kind, scene};
use seamwright_cell::gate::{Gate, Limit};
use seamwright_vision::joint::{Follower, Options};

/// Frames a kind: 50, or 1000 with SEAMWRIGHT_SOAK=20.
fn frames() -> u64 {
    50 * std::env::var("SEAMWRIGHT_SOAK").ok().and_then(|v| v.parse::<u64>().ok()).unwrap_or(1).min(20)
}

/// Gates that 1000 frames a kind miss, and what holds instead; the table shows them as missed: some rows of joints in a shadow's edge
/// are wrong.
const MISSED_BY_MANY: [(&str, &str, f64); 6] = [
    ("clear", LOST, 0.002),
    ("faint", WRONG, 0.012),
    ("step", LOST, 0.008),
    ("end", "greatest end error", 4.0),
    ("cross", LOST, 0.002),
    ("shadow", WRONG, 0.02),
];
const WRONG: &str = "confident rows off by more than 2 px";
const LOST: &str = "frames lost before 95 % of the joint";

#[test]
fn gates_hold_or_are_missed_by_no_more_than_is_known() {
    let frames = frames();
    let table = joint_gates(0..frames, |_, _, _| {});
    let holds = |gate: &&Gate| {
        let known = if frames > 50 { &MISSED_BY_MANY[..] } else { &[] };
        let missed = known.iter().find(|(frames, what, _)| *frames == gate.frames && *what == gate.what);
        // Counts of frames are of all of them.
        let many = if gate.what.starts_with("frames") { frames as f64 } else { 1.0 };
        match (missed, gate.limit) {
            (Some((.., limit)), Limit::Most(_)) => gate.value <= limit * many,
            (Some((.., limit)), Limit::Least(_)) => gate.value >= *limit,
            (None, _) => gate.is_kept(),
        }
    };
    let broken: Vec<&Gate> = table.rows.iter().filter(|gate| !holds(gate)).collect();
    assert!(broken.is_empty(), "{broken:#?}");
}

/// Tacks at the edge of a shadow and joints in it, of other seeds than the gates': seen no longer in the frame as it is, they go
/// on on its top-hat. What was sure before the tack stays sure, and nothing sure is wrong.
#[test]
fn joints_go_on_where_edges_of_light_hide_them() {
    let mut follower = Follower::new(Options::default());
    let (mut sure, mut ways) = (0, 0);
    for seed in [2223, 2272, 3034, 3071, 3120, 3258, 3270, 3297] {
        let outcome = follow(&mut follower, &scene(Kind::Step, seed, 512));
        assert!(outcome.reach > 0.95, "{seed}: {}", outcome.reach);
        assert!(outcome.errors.iter().all(|(error, sure)| !sure || *error < 2.0), "{seed}");
        sure += outcome.errors.iter().filter(|(_, sure)| *sure).count();
        ways += outcome.errors.len();
    }
    assert!(6 * sure > ways, "{sure} of {ways}");
}

/// Wide joints that meet slowly: at first the other one is followed, without confidence; then straight on is.
#[test]
fn joints_go_straight_on_where_others_meet_them() {
    let mut follower = Follower::new(Options::default());
    for (kind, seed) in [(Kind::Branch, 721), (Kind::Cross, 123)] {
        let outcome = follow(&mut follower, &scene(kind, seed, 512));
        assert!(outcome.reach > 0.95, "{seed}: {}", outcome.reach);
        assert!(outcome.errors.iter().all(|(error, sure)| !sure || *error < 2.0), "{seed}");
        assert!(outcome.errors.iter().any(|(_, sure)| *sure), "{seed}");
    }
}
