//! Pulses of one axis a second on one core (aim: 50 million a second, 20 ns each): many and few in a period of 1 ms,
//! and three axes with their lines in the order of time.

use crate::measure::rate;
use seamwright_motion::pulses::{Generator, Lines, Timing};
use std::hint::black_box;

/// 1 ms on a timer of 10 MHz, a driver of 200 kHz.
const TIMING: Timing = Timing { period: 10_000, width: 25, spacing: 50, setup: 50, hold: 50 };
const PERIODS: u32 = 1000;

/// There and back in `PERIODS` periods, `most` pulses a period where it is fastest.
fn positions(most: f64) -> Vec<f64> {
    let angle = std::f64::consts::TAU / f64::from(PERIODS);
    (1..=PERIODS).map(|k| most / angle * (angle * f64::from(k)).sin()).collect()
}

pub(crate) fn benches() {
    for most in [195.0, 20.0] {
        let positions = positions(most);
        let count = |axis: &mut Generator| positions.iter().map(|p| axis.period(*p).unwrap().len() as u64).sum::<u64>();
        let pulses = count(&mut Generator::new(TIMING, 0.0).unwrap());
        rate(&format!("pulses of an axis/up to {most} a period"), pulses, || {
            let mut axis = Generator::new(TIMING, 0.0).unwrap();
            let mut sum = 0;
            for position in &positions {
                for tick in axis.period(*position).unwrap() {
                    sum += black_box(tick);
                }
            }
            sum
        });
    }
    let positions = positions(195.0);
    let start = [(TIMING, 0.0); 3];
    let mut lines = Lines::new(&start).unwrap();
    positions.iter().for_each(|p| lines.advance([*p, 0.7 * p, -0.3 * p]).unwrap());
    let pulses = lines.generators().map(Generator::pulses).sum();
    rate("pulses of three axes/all edges in order", pulses, || {
        let mut lines = Lines::new(&start).unwrap();
        for p in &positions {
            lines.advance([*p, 0.7 * p, -0.3 * p]).unwrap();
            while let Some(event) = lines.event() {
                black_box(event);
            }
        }
    });
}
