//! Blocks in which axes are polynomials of a parameter that the control chooses so that the feed is even: Sinumerik's
//! POLY.

/// Powers from 2 on that a polynomial has: 840D controls take up to the fifth.
pub const POWERS: usize = 4;

/// Parts of a block for which its length is stored.
const PARTS: usize = 16;

/// Nodes and weights of Gauss and Legendre's rule with five points on 0..1.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Position of one axis by the parameter `u` (0 at the block's start, 1 at its end). Given are its positions there and
/// the coefficients of u^2 and up; the coefficient of u follows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Polynomial {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) higher: [f64; POWERS],
}

impl Polynomial {
    /// Coefficients of u^0 and up.
    fn coefficients(&self) -> [f64; POWERS + 2] {
        let mut all = [0.0; POWERS + 2];
        all[0] = self.from;
        all[1] = self.to - self.from - self.higher.iter().sum::<f64>();
        all[2..].copy_from_slice(&self.higher);
        all
    }

    pub(crate) fn at(&self, u: f64) -> f64 {
        self.coefficients().iter().rev().fold(0.0, |sum, c| sum * u + c)
    }

    /// Derivative by the parameter.
    pub(crate) fn slope(&self, u: f64) -> f64 {
        let c = self.coefficients();
        (1..c.len()).rev().fold(0.0, |sum, k| sum * u + k as f64 * c[k])
    }
}

/// The parameter of a block by its even feed: equal times are equal ways of the axes that the feed counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evenly {
    /// Square of the way's derivative by the parameter, as coefficients of u^0 and up.
    square: [f64; 2 * POWERS + 3],
    /// Way up to the end of each part.
    ways: [f64; PARTS + 1],
}

impl Evenly {
    /// For a block in which the counted axes are these.
    pub(crate) fn new(counted: impl Iterator<Item = Polynomial>) -> Self {
        let mut square = [0.0; 2 * POWERS + 3];
        for axis in counted {
            let c = axis.coefficients();
            for i in 1..c.len() {
                for k in 1..c.len() {
                    square[i + k - 2] += (i * k) as f64 * c[i] * c[k];
                }
            }
        }
        let mut evenly = Self { square, ways: [0.0; PARTS + 1] };
        for part in 0..PARTS {
            let [a, b] = [part, part + 1].map(|k| k as f64 / PARTS as f64);
            evenly.ways[part + 1] = evenly.ways[part] + evenly.way(a, b);
        }
        evenly
    }

    /// The whole way, mm (or degrees).
    pub(crate) fn length(&self) -> f64 {
        self.ways[PARTS]
    }

    /// Derivative of the way by the parameter.
    pub(crate) fn speed(&self, u: f64) -> f64 {
        self.square.iter().rev().fold(0.0, |sum, c| sum * u + c).max(0.0).sqrt()
    }

    fn way(&self, a: f64, b: f64) -> f64 {
        (b - a) * GAUSS.iter().map(|(node, weight)| weight * self.speed(a + node * (b - a))).sum::<f64>()
    }

    /// The parameter at the part `f` of the block's time; `f` itself without counted motion.
    pub(crate) fn parameter(&self, f: f64) -> f64 {
        let wanted = f * self.length();
        if f <= 0.0 || f >= 1.0 || self.length() <= 0.0 {
            return f.clamp(0.0, 1.0);
        }
        let part = self.ways.partition_point(|way| *way <= wanted).clamp(1, PARTS) - 1;
        let begin = part as f64 / PARTS as f64;
        let (mut low, mut high) = (begin, begin + 1.0 / PARTS as f64);
        let share = (wanted - self.ways[part]) / (self.ways[part + 1] - self.ways[part]);
        let mut u = low + share * (high - low);
        // Newton's method within a bracket that shrinks.
        for _ in 0..60 {
            let off = self.ways[part] + self.way(begin, u) - wanted;
            if off > 0.0 {
                high = u;
            } else {
                low = u;
            }
            let next = u - off / self.speed(u);
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            if (next - u).abs() < 1e-14 {
                return next;
            }
            u = next;
        }
        u
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A circle's quarter by a cubic, against sums of many chords.
    #[test]
    fn equal_times_are_equal_ways() {
        let x = Polynomial { from: 0.0, to: 10.0, higher: [-4.0, 7.0, 0.0, 1.5] };
        let y = Polynomial { from: 3.0, to: -8.0, higher: [6.0, -2.0, 1.0, 0.0] };
        let evenly = Evenly::new([x, y].into_iter());
        let chords = |u: f64| -> f64 {
            let n = 20_000;
            let at = |k: usize| u * k as f64 / n as f64;
            (0..n).map(|k| (x.at(at(k + 1)) - x.at(at(k))).hypot(y.at(at(k + 1)) - y.at(at(k)))).sum()
        };
        let whole = chords(1.0);
        assert!((evenly.length() - whole).abs() < 1e-6 * whole, "{} {whole}", evenly.length());
        for k in 1..20 {
            let f = f64::from(k) / 20.0;
            let way = chords(evenly.parameter(f));
            assert!((way - f * whole).abs() < 1e-6 * whole, "{f}: {way} of {whole}");
        }
    }

    #[test]
    fn ends_and_slopes_are_those_told() {
        let x = Polynomial { from: 2.0, to: 5.0, higher: [1.0, -3.0, 0.5, 2.0] };
        assert!((x.at(0.0) - 2.0).abs() < 1e-15 && (x.at(1.0) - 5.0).abs() < 1e-14);
        for u in [0.0, 0.3, 1.0] {
            let h = 1e-6;
            assert!((x.slope(u) - (x.at(u + h) - x.at(u - h)) / (2.0 * h)).abs() < 1e-8);
        }
    }
}
