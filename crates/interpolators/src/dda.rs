use crate::grid::Grid;
use crate::path::Path;
use seamwright_geometry::Curve;

/// Fraction bits of a saddle's z integrand, which is a quotient.
const QUOTIENT_BITS: u32 = 20;

/// Digital differential analyser: one integer accumulator per axis; each clock adds its integrand, and each overflow of
/// the register is a pulse.
///
/// Integrands of the ellipse, counter-clockwise: `-a^2 y` for x and `b^2 x` for y, with x and y the pulses made so
/// far: the solution of `dx/du = -(a/b) y, dy/du = (b/a) x`. Saddle: `-y`, `x` and `-x y / z` (rounded to 2^-20 pulse).
///
/// - Width: w bits, the minimum for two pulses more than the largest integrand; so at most one overflow per axis and
///   clock while the drift is below two pulses.
/// - Pre-load: half of 2^w, which makes the truncation of the pulses a rounding.
/// - Rate: a clock is a step of `du = a b / 2^w` (saddle `2^20 / 2^w`) of the eccentric angle; an axis makes between
///   half a pulse and one per clock at its maximum speed. The number of clocks is the path's span divided by du,
///   rounded. Their frequency gives the whole path the time length / nominal speed. The speed varies as that of equal
///   angles.
/// - Start: the lattice point nearest to the path's start; its rounding is never corrected.
///
/// Weakness: the method has no feedback from the curve. The x and y before the clock are used for both axes (Euler's
/// method), so the path spirals outwards: at a radius of n pulses by `n u du / 2` after the angle u. That is 1.6 to 3.1
/// pulses per turn of a circle (2 or 3 with the rounding of the pulses). On a long ellipse the rounding of the start on
/// the short axis is added, enlarged by the ratio of the axes. Neither the end nor the start of a full turn is met.
/// This error belongs to the method and is not corrected.
pub(crate) struct Dda {
    pub(crate) grid: Grid,
    saddle: bool,
    /// Integrand of x by -y and of y by x.
    by_y: i128,
    by_x: i128,
    range: i128,
    register: [i128; 3],
    at: [i64; 3],
    clock: u64,
    /// Clocks for the whole path.
    pub(crate) clocks: u64,
    started: bool,
}

impl Dda {
    pub(crate) fn new(path: &Path, pulse_mm: f64) -> Self {
        let grid = Grid::new(path, pulse_mm);
        let saddle = matches!(&path.base, crate::path::Base::Saddle { .. });
        let (by_y, by_x) = if saddle { (1 << QUOTIENT_BITS, 1 << QUOTIENT_BITS) } else { grid.squares() };
        let (a, b) = path.plan_axes();
        let largest = |mm: f64| (mm / pulse_mm).ceil() as i128 + 2;
        let range = 1i128 << needed_bits((by_y * largest(b)).max(by_x * largest(a)));
        let du = (by_y as f64 * by_x as f64).sqrt() / range as f64;
        let clocks = (path.domain().1 / du).round().max(1.0) as u64;
        let at = grid.start;
        Self { grid, saddle, by_y, by_x, range, register: [range / 2; 3], at, clock: 0, clocks, started: false }
    }

    fn integrands(&self) -> [i128; 3] {
        let [x, y, z] = self.at.map(i128::from);
        let height = if self.saddle {
            // Prevents division by zero for a drift larger than z itself, next to a tangent nozzle.
            let z = z.max(1);
            (-self.by_x * x * y + z / 2).div_euclid(z).clamp(-self.range, self.range)
        } else {
            0
        };
        [-self.by_y * y, self.by_x * x, height]
    }
}

/// Minimum number of bits w with `value <= 2^w`.
fn needed_bits(value: i128) -> u32 {
    128 - (value - 1).leading_zeros()
}

impl Iterator for Dda {
    type Item = (u64, [i64; 3]);

    fn next(&mut self) -> Option<Self::Item> {
        if !self.started {
            self.started = true;
            return Some((0, self.at));
        }
        while self.clock < self.clocks {
            self.clock += 1;
            let before = self.at;
            let integrands = self.integrands();
            for (i, integrand) in integrands.into_iter().enumerate() {
                let sum = self.register[i] + integrand;
                self.at[i] += sum.div_euclid(self.range) as i64;
                self.register[i] = sum.rem_euclid(self.range);
            }
            if self.at != before {
                return Some((self.clock, self.at));
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Method;
    use crate::shape::Shape;
    use crate::testing::{Random, pulses};
    use glam::DVec2;

    fn circle(radius: f64) -> Shape {
        let start_mm = DVec2::new(radius, 0.0);
        Shape::Ellipse { a_mm: radius, b_mm: radius, start_mm, end_mm: None, clockwise: false }
    }

    #[test]
    fn bits() {
        assert_eq!([1, 2, 3, 4, 5, 1024, 1025].map(needed_bits), [0, 1, 2, 2, 3, 10, 11]);
    }

    #[test]
    fn a_circle_spirals_outwards_as_derived() {
        for n in [300.0f64, 500.0, 510.0, 1000.0, 1020.0, 4000.0, 20000.0, 32700.0] {
            let last = pulses(Method::Dda, circle(n), 1.0).interpolate().unwrap().last().unwrap();
            let range = ((n + 2.0).log2().ceil()).exp2();
            let drift = last.position.length() - n;
            let derived = std::f64::consts::PI * n / range;
            assert!((-0.2..1.2).contains(&(drift - derived)), "{n}: {drift} {derived}");
        }
    }

    #[test]
    fn every_ellipse_and_saddle_within_the_drift() {
        let mut random = Random::new(10);
        let (mut worst, mut worst_saddle) = (0.0f64, 0.0f64);
        for i in 0..300 {
            let saddle = i % 3 == 0;
            let shape = if saddle { random.saddle(2.0, 20.0, 0.9) } else { random.ellipse(0.5, 20.0) };
            let pulse = random.log(0.005, 0.1);
            let Ok(run) = pulses(Method::Dda, shape, pulse).interpolate() else { continue };
            let path = run.path().clone();
            let duration = path.length_mm().unwrap() / 0.1;
            let worst = if saddle { &mut worst_saddle } else { &mut worst };
            let mut last: Option<crate::Point> = None;
            for p in run {
                *worst = worst.max(path.nearest(p.position).distance_mm / pulse);
                if let Some(l) = last {
                    let step = (p.position - l.position) / pulse;
                    assert!((step.abs().max_element() - 1.0).abs() < 1e-9, "{shape:?} {pulse} {step}");
                }
                last = Some(p);
            }
            let last = last.unwrap();
            let off = last.position.distance(path.point(path.end_rad())) / pulse;
            assert!(off < 25.0, "{shape:?} {pulse}: {off}");
            assert!(last.t_s <= duration * (1.0 + 1e-12));
        }
        assert!(worst < 8.0 && worst_saddle < 15.0);
    }
}
