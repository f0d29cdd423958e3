//! Cost of a period: while nothing changes (aim: a few microseconds) and while the pace changes (aim: tens).

#![allow(missing_docs, reason = "the benchmark macros make public items")]

#[path = "../tests/pace_law/mod.rs"]
mod pace_law;

use criterion::{Criterion, criterion_group, criterion_main};
use pace_law::{Case, Uniform};
use seamwright_motion::pace::{Command, Pace};
use std::hint::black_box;

fn benches(c: &mut Criterion) {
    let case = Case::random(&mut Uniform::new(4));
    let fresh = || {
        let mut pace = Pace::new(&case.limits(), 1e-3, &case.base).unwrap();
        pace.command(Command::Resume).unwrap();
        pace
    };
    let mut pace = fresh();
    c.bench_function("period, pace steady", |b| {
        b.iter(|| {
            if pace.at_end() {
                pace = fresh();
            }
            black_box(pace.step())
        });
    });
    let mut pace = fresh();
    let mut periods = 0u32;
    c.bench_function("period, commands every 20", |b| {
        b.iter(|| {
            if pace.at_end() {
                pace = fresh();
            }
            periods += 1;
            if periods.is_multiple_of(20) {
                pace.command(if periods.is_multiple_of(40) { Command::Resume } else { Command::Hold }).unwrap();
            }
            black_box(pace.step())
        });
    });
}

criterion_group!(group, benches);
criterion_main!(group);
