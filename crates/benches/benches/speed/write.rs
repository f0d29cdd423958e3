//! Part programs to text: blocks of five axes with all words changing, a hundred thousand of them.

use crate::measure::rate;
use seamwright_machine::{Machine, shipped};
use seamwright_post::{Control, Dialect, Level, Move, PartProgram, Path, What, WriteOptions, write};
use std::hint::black_box;

const BLOCKS: u32 = 100_000;

fn program(control: &Control) -> PartProgram {
    let mut program = PartProgram::new("bench", control.channels.clone());
    let mut row = vec![0.0; control.channels.len()];
    let axes = program.axes();
    for k in 0..BLOCKS {
        for (i, value) in row[..axes].iter_mut().enumerate() {
            let angle = f64::from(k) * 1e-3 * (1.0 + 0.3 * i as f64);
            *value = (1e6 * 300.0 * angle.sin()).round() / 1e6;
        }
        let to = program.add_row(&row);
        let path = if k == 0 { Path::Rapid } else { Path::Line };
        let seconds = if k == 0 { 0.0 } else { 0.05 + 0.01 * (f64::from(k) * 0.01).sin() };
        program.push(What::Move(Move { path, row: to, seconds, level: Level::Joint, exact_stop: false }));
    }
    program
}

pub(crate) fn bench() {
    let Some(Ok(machine)) = shipped("table-tilting-xyzac").map(|s| Machine::read("m", s.text)) else { return };
    for dialect in Dialect::ALL {
        let Ok(control) = Control::new(&machine, dialect) else { return };
        let program = program(&control);
        let options = WriteOptions::default();
        rate(&format!("write/{}", dialect.name()), u64::from(BLOCKS), || {
            black_box(write(&control, &program, &options))
        });
    }
}
