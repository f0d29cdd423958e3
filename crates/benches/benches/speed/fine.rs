//! A fine set-point of all axes: ten in a coarse period, with the spline's own cost.

use crate::measure::time;
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_motion::fine::{CoarseSpline, Segment};
use std::hint::black_box;

const PARTS: u32 = 10;

pub(crate) fn benches() {
    let points: Vec<Joints> = (0..1000).map(|k| [100.0 * (0.01 * f64::from(k)).sin(); MAX_AXES]).collect();
    let mut spline = CoarseSpline::new(0.01);
    let mut before = None;
    let (mut k, mut part) = (0, PARTS);
    let mut segment: Option<Segment> = None;
    time("fine set-point, 12 axes, 10 a period", || {
        if part == PARTS {
            part = 0;
            k = (k + 1) % points.len();
            if let Some(knot) = spline.push(&points[k]) {
                segment = before.replace(knot).map(|before| Segment::new(&before, &knot, 0.01));
            }
        }
        part += 1;
        segment.map(|s| black_box(s.at(f64::from(part - 1) / f64::from(PARTS))))
    });
}
