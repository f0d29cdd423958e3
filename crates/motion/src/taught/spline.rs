use crate::stretch::Stretch;
use nalgebra::SVector;
use seamwright_geometry::numeric::{Row, tridiagonal};
use seamwright_machine::{Joints, MAX_AXES};

/// A polynomial of all axes over a range of the parameter.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Piece {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Parameter at which the powers' variable is zero.
    origin: f64,
    /// Coefficients, lowest power first.
    c: [Joints; 6],
}

impl Piece {
    /// The cubic over a stretch with the positions `q` and slopes `d` by the parameter at its start and end.
    pub(crate) fn cubic(over: Stretch, q: [&Joints; 2], d: [&Joints; 2]) -> Self {
        let Stretch { from, to } = over;
        let h = to - from;
        let mut c = [Joints::default(); 6];
        for i in 0..MAX_AXES {
            let mean = (q[1][i] - q[0][i]) / h;
            c[0][i] = q[0][i];
            c[1][i] = d[0][i];
            c[2][i] = (3.0 * mean - 2.0 * d[0][i] - d[1][i]) / h;
            c[3][i] = (d[0][i] + d[1][i] - 2.0 * mean) / (h * h);
        }
        Self { from, to, origin: from, c }
    }

    /// The quintic from the end of `before` to the start of `after`, twice continuously differentiable.
    pub(crate) fn blend(before: &Self, after: &Self) -> Self {
        let over = Stretch { from: before.to, to: after.from };
        let start = |[q, d1, d2, _]: [Joints; 4]| [q, d1, d2];
        Self::quintic(over, start(before.derivatives(over.from)), start(after.derivatives(over.to)))
    }

    /// The quintic over a stretch with the positions and two derivatives `a` at its start and `b` at its end.
    pub(crate) fn quintic(over: Stretch, a: [Joints; 3], b: [Joints; 3]) -> Self {
        let Stretch { from, to } = over;
        let h = to - from;
        let mut c = [Joints::default(); 6];
        for i in 0..MAX_AXES {
            let [q0, d0, e0] = [a[0][i], a[1][i] * h, a[2][i] * h * h];
            let [q1, d1, e1] = [b[0][i], b[1][i] * h, b[2][i] * h * h];
            let rise = q1 - q0;
            let scaled = [
                q0,
                d0,
                0.5 * e0,
                10.0 * rise - 6.0 * d0 - 4.0 * d1 - 1.5 * e0 + 0.5 * e1,
                -15.0 * rise + 8.0 * d0 + 7.0 * d1 + 1.5 * e0 - e1,
                6.0 * rise - 3.0 * (d0 + d1) - 0.5 * (e0 - e1),
            ];
            (0..6).for_each(|k| c[k][i] = scaled[k] / h.powi(k as i32));
        }
        Self { from, to, origin: from, c }
    }

    pub(crate) fn derivatives(&self, u: f64) -> [Joints; 4] {
        let x = u - self.origin;
        let mut out = [Joints::default(); 4];
        let [position, first, second, third] = &mut out;
        for i in 0..MAX_AXES {
            let c = |k: usize| self.c[k][i];
            position[i] = c(0) + x * (c(1) + x * (c(2) + x * (c(3) + x * (c(4) + x * c(5)))));
            first[i] = c(1) + x * (2.0 * c(2) + x * (3.0 * c(3) + x * (4.0 * c(4) + x * 5.0 * c(5))));
            second[i] = 2.0 * c(2) + x * (6.0 * c(3) + x * (12.0 * c(4) + x * 20.0 * c(5)));
            third[i] = 6.0 * c(3) + x * (24.0 * c(4) + x * 60.0 * c(5));
        }
        out
    }
}

/// Slopes at the knots of the twice continuously differentiable cubic spline through `q` at the parameters `u` (at
/// least two). Its first two and its last two pieces are one cubic each (de Boor's "not a knot"; with fewer than four
/// knots the curvature is 0 at its ends), or its slope at the start is `first`.
pub(crate) fn slopes(u: &[f64], q: &[Joints], first: Option<&Joints>) -> Vec<Joints> {
    let row = |i: usize| match first {
        Some(slope) if i == 0 => Row::new([0.0, 1.0, 0.0], (*slope).into()),
        _ => equation(u, q, i),
    };
    tridiagonal((0..u.len()).map(row)).into_iter().map(Into::into).collect()
}

/// The equation for the slopes at knot `i` and its neighbours.
fn equation(u: &[f64], q: &[Joints], i: usize) -> Row<SVector<f64, MAX_AXES>> {
    let n = u.len();
    let width = |i: usize| u[i + 1] - u[i];
    let mean = |i: usize| (SVector::from(q[i + 1]) - SVector::from(q[i])) / width(i);
    // Of the slopes at the end and beside it, from the piece at the end and the one beside that.
    let end = |own: usize, beside: usize| {
        let (a, b) = (width(own), width(beside));
        let right = (mean(own) * ((3.0 * a + 2.0 * b) * b) + mean(beside) * (a * a)) / (a + b);
        (b, a + b, right)
    };
    match i {
        0 if n < 4 => Row::new([0.0, 2.0, 1.0], mean(0) * 3.0),
        _ if i + 1 == n && n < 4 => Row::new([1.0, 2.0, 0.0], mean(n - 2) * 3.0),
        0 => {
            let (own, other, right) = end(0, 1);
            Row::new([0.0, own, other], right)
        }
        _ if i + 1 == n => {
            let (own, other, right) = end(n - 2, n - 3);
            Row::new([other, own, 0.0], right)
        }
        _ => {
            let (a, b) = (width(i - 1), width(i));
            Row::new([b, 2.0 * (a + b), a], (mean(i - 1) * b + mean(i) * a) * 3.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64) -> Joints {
        std::array::from_fn(|i| (x * (1.0 + i as f64 * 0.2)).sin())
    }

    #[test]
    fn pieces_join_with_two_derivatives_and_follow_a_smooth_curve() {
        let u: Vec<f64> = (0..60).map(|i| 0.05 * f64::from(i) + 0.02 * f64::from(i % 3)).collect();
        let q: Vec<Joints> = u.iter().map(|u| at(*u)).collect();
        let slopes = slopes(&u, &q, None);
        let piece = |i: usize| {
            let over = Stretch { from: u[i], to: u[i + 1] };
            Piece::cubic(over, [&q[i], &q[i + 1]], [&slopes[i], &slopes[i + 1]])
        };
        for i in 1..u.len() - 1 {
            let (a, b) = (piece(i - 1).derivatives(u[i]), piece(i).derivatives(u[i]));
            for k in 0..MAX_AXES {
                assert!((0..3).all(|d| (a[d][k] - b[d][k]).abs() < 1e-10 * 10f64.powi(d as i32)));
            }
            let middle = 0.5 * (u[i] + u[i + 1]);
            if i > 10 && i < 50 {
                assert!((piece(i).derivatives(middle)[0][3] - at(middle)[3]).abs() < 1e-6);
            }
        }
        // A window that continues from a known slope is the same spline.
        let later = super::slopes(&u[20..], &q[20..], Some(&slopes[20]));
        assert!((0..40).all(|i| (0..MAX_AXES).all(|k| (later[i][k] - slopes[20 + i][k]).abs() < 1e-12)));
    }

    #[test]
    fn a_blend_goes_on_from_one_piece_into_the_other() {
        let (a, b, c) = ([0.0; MAX_AXES], [1.0; MAX_AXES], std::array::from_fn(|i| 1.0 + i as f64 * 0.1));
        let slope = |p: &Joints, q: &Joints| std::array::from_fn::<f64, MAX_AXES, _>(|i| q[i] - p[i]);
        let mut first = Piece::cubic(Stretch { from: 0.0, to: 1.0 }, [&a, &b], [&slope(&a, &b); 2]);
        let mut second = Piece::cubic(Stretch { from: 1.0, to: 2.0 }, [&b, &c], [&slope(&b, &c); 2]);
        (first.to, second.from) = (0.8, 1.2);
        let blend = Piece::blend(&first, &second);
        for (own, beside) in
            [(blend.derivatives(0.8), first.derivatives(0.8)), (blend.derivatives(1.2), second.derivatives(1.2))]
        {
            assert!((0..3).all(|d| (0..MAX_AXES).all(|k| (own[d][k] - beside[d][k]).abs() < 1e-11)));
        }
    }
}
