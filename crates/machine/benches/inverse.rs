//! Cost of one closed-form inverse, all branches and the choice of the nearest. Aim: 200 ns.

#![allow(missing_docs, reason = "the benchmark macros make public items")]

use criterion::{Criterion, criterion_group, criterion_main};
use seamwright_machine::{Machine, SHIPPED};
use std::hint::black_box;

fn inverse(c: &mut Criterion) {
    for shipped in SHIPPED {
        let machine = Machine::read(shipped.name, shipped.text).unwrap();
        let poses: Vec<_> = (0..997)
            .map(|i| {
                let mut q = machine.home();
                for (k, q) in q.iter_mut().enumerate() {
                    *q += (f64::from(i) * 0.37 + k as f64).sin() * 0.7;
                }
                (machine.forward(&q), q)
            })
            .collect();
        let mut i = 0;
        c.bench_function(&format!("inverse, {}", shipped.name), |b| {
            b.iter(|| {
                i = (i + 1) % poses.len();
                black_box(machine.inverse_near(black_box(&poses[i].0), &poses[i].1))
            });
        });
    }
}

criterion_group!(benches, inverse);
criterion_main!(benches);
