//! Cost of the whole plan of the example (aim: 20 ms) and of one exact set-point from it (aim: 150 ns).

use crate::measure::time;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::PassMotion;
use seamwright_weld::Welding;
use std::hint::black_box;

const EXAMPLES: [(&str, &str); 4] = [
    ("saddle", include_str!("../../../../examples/saddle.toml")),
    ("head nozzle", include_str!("../../../../examples/head-nozzle.toml")),
    ("ellipse", include_str!("../../../../examples/ellipse.toml")),
    ("trunnion saddle", include_str!("../../../../examples/trunnion-saddle.toml")),
];

/// From the files' texts to the planned motion.
fn plan(name: &str, text: &str) -> PassMotion {
    let welding = Welding::read(name, text).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("machine", shipped(&program.machine).unwrap().text).unwrap();
    PassMotion::plan(&machine, &welding.path(0), &program.passes[0], 1).unwrap()
}

pub(crate) fn benches() {
    for (name, text) in EXAMPLES {
        time(&format!("whole plan, {name}"), || black_box(plan(name, black_box(text))));
    }
    for (name, text) in EXAMPLES {
        let motion = plan(name, text);
        let mut points = motion.set_points(1e-3);
        time(&format!("set-point, {name}"), || match points.next() {
            Some(point) => black_box(point.q),
            None => {
                points = motion.set_points(1e-3);
                black_box(Default::default())
            }
        });
    }
}
