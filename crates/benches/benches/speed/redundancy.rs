//! Cost of resolving the redundant axes of a whole seam, at 1,000 stations (aim: 150 ms).

use crate::measure::time;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::redundancy::resolve;
use seamwright_weld::Welding;
use std::hint::black_box;

pub(crate) fn benches() {
    let welding = Welding::read("job", include_str!("../../../../examples/oblique-girth.toml")).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("machine", shipped(&program.machine).unwrap().text).unwrap();
    let (path, wishes) = (welding.path(0), &program.passes[0].spare_axes);
    time("axes to spare, 1000 stations", || resolve(&machine, black_box(&path), 10.0, wishes, None, 1).unwrap());
}
