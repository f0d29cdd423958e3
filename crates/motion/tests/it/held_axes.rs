//! Redundant axes that are held, or have almost no range.

use crate::planning;
use crate::planning::{plan_weld, read, read_machine};
use seamwright_machine::{Clamped, Machine};
use seamwright_motion::PassMotion;
use seamwright_motion::redundancy::holding;
use seamwright_program::{Finding, SpareAxes};
use seamwright_weld::Welding;

const JOB: &str = include_str!("../../../../tests/data/field-trial/g8.toml");
/// x y z and a wrist of c and b above turning rolls r.
const GANTRY: &str = include_str!("../../../../tests/data/field-trial/gantry.toml");
/// The same with next to no range of r.
const NARROWED: &str = include_str!("../../../../tests/data/field-trial/gantryL.toml");
/// The same without r.
const WITHOUT: &str = include_str!("../../../../tests/data/field-trial/gantry5.toml");
/// With a slide e along x, and a table of u and w instead of r.
const EIGHT: &str = include_str!("../../../../tests/data/field-trial/gantry8.toml");
/// A six-axis arm beside a table that tilts and turns.
const ARM: &str = include_str!("../../../../tests/data/field-trial/ur10e-pos.toml");

fn holding_job(hold: &str) -> Welding {
    read(&format!("{JOB}\n[spare_axes]\nhold = {{ {hold} }}\n"))
}

fn plan(machine: &Machine, hold: &str) -> Result<PassMotion, Vec<Finding>> {
    planning::plan(machine, &holding_job(hold))
}

fn wishes(hold: &[(&str, f64)]) -> SpareAxes {
    let mut wishes = SpareAxes::default();
    for (name, value) in hold {
        wishes.hold.insert((*name).to_owned(), seamwright_document::Finite::new(*value).unwrap());
    }
    wishes
}

/// With its rolls held the gantry moves as one that has none.
#[test]
fn a_redundant_axis_that_the_pose_would_decide_can_be_held() {
    let gantry = read_machine(GANTRY);
    let held = plan(&gantry, "r = 0").unwrap_or_else(|f| panic!("{f:#?}"));
    let without = read_machine(WITHOUT);
    let expected = plan(&without, "").unwrap_or_else(|f| panic!("{f:#?}"));
    assert!((held.profile.duration() - expected.profile.duration()).abs() < 1e-6 * expected.profile.duration());
    let [r, axes] = [vec!["r"], vec!["x", "y", "z", "c", "b"]];
    for i in 0..=500 {
        let s = held.path.length() * f64::from(i) / 500.0;
        let (q, p) = (held.path.at(s), expected.path.at(s));
        assert!(r.iter().all(|name| q[gantry.axis(name).unwrap()].abs() < 1e-12));
        for name in &axes {
            let (a, b) = (q[gantry.axis(name).unwrap()], p[without.axis(name).unwrap()]);
            assert!((a - b).abs() < 1e-8, "{name} at {s}: {a} {b}");
        }
    }
}

/// A pose must not decide an axis that has no range to follow it.
#[test]
fn an_axis_with_next_to_no_range_is_used_within_it() {
    let machine = read_machine(NARROWED);
    let motion = plan(&machine, "").unwrap_or_else(|f| panic!("{f:#?}"));
    let places = (0..=1000).map(|i| motion.path.at(motion.path.length() * f64::from(i) / 1000.0));
    assert!(places.into_iter().all(|q| machine.outside(&q).is_none()));
}

#[test]
fn as_many_axes_as_are_redundant_can_be_held_and_others_say_why_not() {
    let eight = read_machine(EIGHT);
    for hold in [vec![("u", 0.0)], vec![("w", 30.0), ("e", 0.0)], vec![("u", 0.0), ("w", 0.0), ("e", 10.0)]] {
        let freed = holding(&eight, &wishes(&hold)).unwrap();
        assert!(hold.iter().all(|(name, _)| freed.free().has(eight.axis(name).unwrap())), "{hold:?}");
        assert_eq!(freed.free().iter().count(), 3);
    }
    let four = wishes(&[("u", 0.0), ("w", 0.0), ("e", 0.0), ("c", 0.0)]);
    let refused = |machine: &Machine, wishes: &SpareAxes| holding(machine, wishes).unwrap_err();
    let few = refused(&eight, &four);
    assert!(few.message.code == "motion-hold-too-few" && few.allowed.to_string().contains('3'), "{few:?}");
    // Without z the others stay in a plane, at every rotation of the level table.
    let flat = wishes(&[("z", 1200.0), ("u", 0.0), ("b", 20.0)]);
    assert_eq!(refused(&eight, &flat).message.code, "motion-hold-too-few");
    let none = wishes(&[("tilt", 0.0)]);
    assert_eq!(refused(&eight, &none).message.code, "motion-hold-unknown");
    let five = read_machine(WITHOUT);
    assert_eq!(refused(&five, &wishes(&[("c", 0.0)])).message.code, "motion-hold-decided");
    let freed = holding(&read_machine(ARM), &wishes(&[("tilt", 0.0)])).unwrap().into_owned();
    assert!(freed.free().has(freed.axis("tilt").unwrap()));
}

/// Retract and approach too.
#[test]
fn a_held_axis_stands_still_before_and_after_the_weld() {
    let gantry = read_machine(GANTRY);
    let motion = plan_weld(&gantry, &holding_job("r = 25"), &Clamped::default()).unwrap_or_else(|f| panic!("{f:#?}"));
    let r = gantry.axis("r").unwrap();
    let retract = motion.transfers[1].legs.first().unwrap();
    assert!(motion.transfers[1].retracts && (retract.start()[r] - retract.end()[r]).abs() < 1e-9);
}
