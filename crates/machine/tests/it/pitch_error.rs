//! Pitch-error tables: forward with the error, inverse without it, mistakes with an address.

use crate::common::{random_joints, refusal};
use seamwright_machine::{Joints, Machine, shipped};
use seamwright_testkit::Random;

const TABLES: &str = "
[pitch_error.x]
at_mm = [-400, -150, 0, 200, 400]
error_mm = [0.05, 0.02, 0, -0.03, 0.01]
[pitch_error.a]
at_deg = [-110, 0, 110]
error_deg = [0.01, 0, -0.02]
[pitch_error.c]
at_deg = [0, 90, 180, 270]
error_deg = [0.004, -0.006, 0.002, 0.001]
";

fn plain() -> String {
    shipped("table-tilting-xyzac").unwrap().text.to_owned()
}

#[test]
fn the_same_chain_knows_the_error() {
    let exact = Machine::read("m", &plain()).unwrap();
    let machine = Machine::read("m", &(plain() + TABLES)).unwrap();
    let (x, a, c) = (machine.axis("x").unwrap(), machine.axis("a").unwrap(), machine.axis("c").unwrap());
    // At the table's positions the error is that of the table.
    let mut q = Joints::default();
    (q[x], q[a], q[c]) = (200.0, 110f64.to_radians(), (720.0f64 + 90.0).to_radians());
    let t = machine.true_positions(&q);
    assert!((t[x] - 199.97).abs() < 1e-12);
    assert!((t[a].to_degrees() - 109.98).abs() < 1e-10 && (t[c].to_degrees() - 809.994).abs() < 1e-9);
    let mut random = Random::new(3);
    for _ in 0..20_000 {
        let q = random_joints(&machine, &mut random);
        let pose = machine.forward(&q);
        let truly = exact.forward(&machine.true_positions(&q));
        assert!((pose.point - truly.point).length() < 1e-12);
        let back = machine.inverse_near(pose, &q).unwrap();
        if q[a].sin().abs() > 1e-3 {
            let worst = back.joints.iter().zip(&q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(worst < 1e-9, "{worst:e}");
        }
        let h = 1e-4;
        for (i, column) in machine.jacobian(&q).iter().enumerate().take(machine.axes.len()) {
            let (mut l, mut r) = (q, q);
            (l[i], r[i]) = (q[i] - h, q[i] + h);
            let difference = (machine.forward(&r).point - machine.forward(&l).point) / (2.0 * h);
            assert!((difference - column.0).length() < 1e-5 * column.0.length().max(1.0));
        }
    }
}

#[test]
fn mistakes_have_an_address() {
    let wrong = |from: &str, to: &str| refusal(&(plain() + TABLES), from, to).key;
    assert_eq!(wrong("[pitch_error.x]", "[pitch_error.w]"), "pitch_error.w");
    assert_eq!(wrong("at_mm = [-400, -150, 0, 200, 400]", "at_mm = [-400, 0, -150, 200, 400]"), "pitch_error.x.at_mm");
    assert_eq!(wrong("at_mm = [-400, -150, 0, 200, 400]", "at_mm = [-400]"), "pitch_error.x.error_mm");
    assert_eq!(
        wrong("error_mm = [0.05, 0.02, 0, -0.03, 0.01]", "error_mm = [0, 30, -30, 0, 0]"),
        "pitch_error.x.error_mm"
    );
    assert_eq!(wrong("at_deg = [-110, 0, 110]", "at_mm = [-110, 0, 110]"), "pitch_error.a");
    assert_eq!(wrong("at_deg = [0, 90, 180, 270]", "at_deg = [0, 90, 180, 360]"), "pitch_error.c.at_deg");
    assert_eq!(wrong("error_deg = [0.01, 0, -0.02]", "error_deg = [0.01, nan, -0.02]"), "pitch_error.a.error_deg[1]");
}

/// An axis of several turns with a non-periodic table: every turn has its own error.
#[test]
fn turns_of_a_limited_axis_are_not_alike() {
    let text = plain().replacen("continuous = true", "range_deg = [-720, 720]", 1)
        + "[pitch_error.c]\nat_deg = [-720, 0, 720]\nerror_deg = [-0.2, 0, 0.3]\n";
    let machine = Machine::read("m", &text).unwrap();
    let a = machine.axis("a").unwrap();
    let mut random = Random::new(8);
    for _ in 0..5000 {
        let q = random_joints(&machine, &mut random);
        if q[a].sin().abs() < 1e-2 {
            continue;
        }
        let pose = machine.forward(&q);
        let near = machine.inverse_near(pose, &q).unwrap();
        let worst = near.joints.iter().zip(&q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9, "{worst:e}");
        for s in machine.reach(pose, &q).unwrap() {
            assert!((machine.forward(&s.joints).point - pose.point).length() < 1e-9);
            assert!(machine.outside(&s.joints).is_none());
        }
    }
    // Too steep at the periodic joint of a continuous axis' table.
    let steep = plain() + "[pitch_error.c]\nat_deg = [0, 350]\nerror_deg = [0, 2]\n";
    assert_eq!(Machine::read("m", &steep).unwrap_err().key, "pitch_error.c.error_deg");
}
