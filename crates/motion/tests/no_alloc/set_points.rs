//! A set-point in the cycle costs no allocation, and a motion of any length no memory.

use crate::allocations;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::PassMotion;
use seamwright_weld::Welding;
use std::hint::black_box;

#[test]
fn set_points_do_not_allocate() {
    let welding = Welding::read("saddle", include_str!("../../../../examples/saddle.toml")).unwrap();
    let machine = Machine::read("m", shipped("saddle-4axis").unwrap().text).unwrap();
    let motion = PassMotion::plan(&machine, &welding.path(0), &welding.program.value.passes[0], 1).unwrap();
    let allocated = allocations(|| {
        for p in motion.set_points(1e-3) {
            black_box((p.rates(&motion), machine.forward(&p.q), machine.outside(&p.q)));
            black_box(machine.inverse_near(machine.forward(&p.q), &p.q)).ok();
        }
    });
    assert_eq!(allocated, 0);
}
