//! Speed of reading: a million blocks of a five-axis weld in each dialect (aim: 0.5 s).

#[path = "../../../post/tests/it/reading/mod.rs"]
mod reading;

use crate::measure::rate;
use seamwright_post::{Dialect, ReadOptions, read};
use std::fmt::Write;
use std::hint::black_box;

const BLOCKS: u32 = 1_000_000;

/// A spiral of lines, five axes and a feed in each block.
fn text(dialect: Dialect) -> String {
    let mut text = String::from(match dialect {
        Dialect::Pmac => "OPEN PROG 1 CLEAR\nABS LINEAR TA0 TS0\n",
        Dialect::Sinumerik => "G90 G71 G17 G40 G500 G64\nFGROUP(X,Y,Z,B,C1)\nG93\n",
        _ => "G21 G90 G93\n",
    });
    for i in 0..BLOCKS {
        let angle = 1e-3 * f64::from(i);
        let (x, y, z) = (200.0 * angle.cos(), 200.0 * angle.sin(), 1e-4 * f64::from(i));
        let (b, c, f, n) = (30.0 + 10.0 * (0.1 * angle).sin(), angle.to_degrees(), 300.0 + x, 10 * (i + 1));
        let _ = match dialect {
            Dialect::Sinumerik => {
                writeln!(text, "N{n} G1 X={x:.4} Y={y:.4} Z={z:.4} B={b:.4} C1={c:.4} F={f:.4}")
            }
            Dialect::Pmac => writeln!(text, "TM{:.4} X{x:.4} Y{y:.4} Z{z:.4} B{b:.4} C{c:.4}", 60e3 / f),
            _ => writeln!(text, "N{n} G1 X{x:.4} Y{y:.4} Z{z:.4} B{b:.4} C{c:.4} F{f:.4}"),
        };
    }
    text
}

pub(crate) fn reads() {
    for dialect in Dialect::ALL {
        let (control, text) = (reading::control(dialect), text(dialect));
        rate(&format!("read/a million blocks of {}", dialect.name()), u64::from(BLOCKS), || {
            black_box(read(&control, "bench", black_box(&text), &ReadOptions::default())).unwrap()
        });
    }
}
