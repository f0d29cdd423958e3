use super::spline::Knot;
use seamwright_machine::{Joints, MAX_AXES};

/// The curve between two knots: the polynomial of the fifth degree with the position, speed and acceleration of both.
///
/// Inside the spline it is the spline's cubic, since that has them; at the ends it is the segment from or to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    period: f64,
    end: Knot,
    /// By powers of the part of the period.
    powers: [Joints; 6],
}

impl Segment {
    /// From one knot to the next, `period` (s) later.
    pub fn new(from: &Knot, to: &Knot, period: f64) -> Self {
        let (h, hh) = (period, period * period);
        let mut powers = [[0.0; MAX_AXES]; 6];
        for i in 0..MAX_AXES {
            let (v0, a0) = (h * from.v[i], 0.5 * hh * from.a[i]);
            // Residuals of position, speed and acceleration at the end.
            let p = to.q[i] - from.q[i] - v0 - a0;
            let v = h * to.v[i] - v0 - 2.0 * a0;
            let a = hh * to.a[i] - 2.0 * a0;
            let high = [10.0 * p - 4.0 * v + 0.5 * a, -15.0 * p + 7.0 * v - a, 6.0 * p - 3.0 * v + 0.5 * a];
            for (power, c) in powers.iter_mut().zip([from.q[i], v0, a0].into_iter().chain(high)) {
                power[i] = c;
            }
        }
        Self { period, end: *to, powers }
    }

    /// Position, speed and acceleration after the `part` of the period, 0 to 1; at 0 and 1 those of the knots, to the
    /// last bit in the position.
    pub fn at(&self, part: f64) -> Knot {
        if part >= 1.0 {
            return self.end;
        }
        let [c0, c1, c2, c3, c4, c5] = &self.powers;
        let (h, t) = (self.period, part);
        Knot {
            q: std::array::from_fn(|i| c0[i] + t * (c1[i] + t * (c2[i] + t * (c3[i] + t * (c4[i] + t * c5[i]))))),
            v: std::array::from_fn(|i| {
                (c1[i] + t * (2.0 * c2[i] + t * (3.0 * c3[i] + t * (4.0 * c4[i] + t * 5.0 * c5[i])))) / h
            }),
            a: std::array::from_fn(|i| {
                (2.0 * c2[i] + t * (6.0 * c3[i] + t * (12.0 * c4[i] + t * 20.0 * c5[i]))) / (h * h)
            }),
        }
    }
}
