//! Pulses and the fine level cost no allocation in a period.

use crate::allocations;
use seamwright_machine::MAX_AXES;
use seamwright_motion::fine::{CoarseSpline, Segment};
use seamwright_motion::pulses::{Lines, Timing};
use std::hint::black_box;

#[test]
fn pulses_and_fine_set_points_do_not_allocate() {
    let timing = Timing { period: 10_000, width: 25, spacing: 50, setup: 50, hold: 50 };
    let mut lines = Lines::new(&[(timing, 0.0), (timing, 7.5)]).unwrap();
    let mut spline = CoarseSpline::new(0.01);
    let mut before = None;
    let mut events = 0u32;
    let allocated = allocations(|| {
        for k in 0..1000 {
            let position = 2000.0 * (0.05 * f64::from(k)).sin();
            lines.advance([position, 0.3 * position]).unwrap_or_default();
            while let Some(event) = lines.event() {
                black_box(event);
                events += 1;
            }
            if let Some(knot) = spline.push(&[position; MAX_AXES])
                && let Some(before) = before.replace(knot)
            {
                black_box(Segment::new(&before, &knot, 0.01).at(0.3));
            }
        }
    });
    assert!(allocated == 0 && events > 100_000);
}
