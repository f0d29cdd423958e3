//! A cycle of ten axes costs no allocation: set-point, inverse kinematics, position loops.

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use seamwright_machine::{Machine, Target, shipped};
use seamwright_motion::PassMotion;
use seamwright_servo::{Gains, PositionLoop, SetPoint};
use seamwright_weld::Welding;
use std::hint::black_box;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

#[test]
fn cycles_do_not_allocate() {
    let welding = Welding::read("t-joint", include_str!("../../../examples/t-joint.toml")).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("machine", shipped(&program.machine).unwrap().text).unwrap();
    let motion = PassMotion::plan(&machine, &welding.path(0), &program.passes[0], 1).unwrap();
    let mut axes = vec![PositionLoop::new(Gains::suggested(60.0, 1e-3), 1e-3, 60.0).unwrap(); machine.axes.len()];
    let mut points = motion.set_points(1e-3);
    assert_no_alloc(|| {
        for point in points.by_ref().take(2000) {
            let [first, second] = [0, 1].map(|head| machine.forward_of(head, &point.q));
            let found = machine.inverse_near(Target::new(first, Some(second)), &point.q);
            let joints = found.map_or(point.q, |solution| solution.joints);
            for (axis, q) in axes.iter_mut().zip(joints) {
                black_box(axis.update(SetPoint { position: q, velocity: 0.0, acceleration: 0.0 }, q - 1e-3));
            }
        }
    });
    assert_eq!(violation_count(), 0);
    // Checks the counter itself.
    assert_no_alloc(|| black_box(vec![1]));
    assert!(violation_count() > 0);
}
