//! Tests of machine files on themselves: what ships passes, planted mistakes are found, reach against closed forms.

use seamwright_document::Document;
use seamwright_machine::check::{Check, CheckOptions, Remark};
use seamwright_machine::{Machine, MachineFile, SHIPPED, shipped};
use std::f64::consts::PI;

fn checked(text: &str, poses: u32) -> Check {
    let machine = Machine::read("m.toml", text).unwrap();
    let file = Document::<MachineFile>::read("m.toml", text).unwrap();
    let mut steps = 0;
    let options = CheckOptions { seed: 3, poses };
    let check = Check::run(&file, &machine, &options, &mut || steps += 1);
    assert!(steps <= Check::steps(&machine, &options) && steps >= u64::from(poses));
    check
}

#[test]
fn machines_that_ship_pass_without_remarks() {
    for s in SHIPPED {
        let started = std::time::Instant::now();
        let check = checked(s.text, 5000);
        println!("{} {:?}", s.name, started.elapsed());
        println!("{:#?} {:#?} {:#?} {:?}", check.heads, check.pair, check.remarks, check.failures);
        assert!(check.passed, "{:?}", check.failures);
    }
}
