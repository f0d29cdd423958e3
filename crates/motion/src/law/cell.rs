use super::cells::Cells;
use super::rest::RestToRest;
use super::speed_law::LawPoint;

/// A cell of a law: `d2 tau / dt2 = a + w tau` from its start on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// Where it begins and ends, by `tau`.
    pub(super) tau: f64,
    end: f64,
    /// When it begins and how long it takes, s: the difference of two instants would have lost digits.
    pub(super) t: f64,
    pub(super) time: f64,
    /// Speed and acceleration by `tau` at its start.
    pub(super) v: f64,
    pub(super) a: f64,
    pub(super) w: f64,
    /// True if the tip cruises at the asked speed all through it, see [`Cells::cruises`].
    pub(super) cruises: bool,
    /// The squared speed at its start and end as parts of the asked one; nothing if none is asked.
    pub(super) parts: [f64; 2],
}

impl Cell {
    /// The cell between these `tau` that begins at time `t`, with the squared speed and its derivatives at its start,
    /// and the squared speeds asked at its ends.
    pub(super) fn new((tau, end): (f64, f64), t: f64, [b, d, e]: [f64; 3], (cruises, asked): (bool, [f64; 2])) -> Self {
        let width = end - tau;
        let b_end = b + width * (d + 0.5 * width * e);
        let v_end = b_end.max(0.0).sqrt();
        let (v, a, w) = (b.max(0.0).sqrt(), 0.5 * d, 0.5 * e);
        let parts = [b / asked[0], b_end / asked[1]];
        Self { tau, end, t, time: crossing(w, width / (v + v_end)), v, a, w, cruises, parts }
    }

    /// Cell `i` of a law with coefficients `c` in `cells`, beginning at time `t`.
    pub(super) fn of_spline(cells: &Cells, c: &[f64], i: usize, t: f64) -> Self {
        let w = cells.weights(i);
        let dot = |w: &[f64; 3]| w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2];
        let cruises = cells.cruises(c, i);
        // All coefficients alike: no rounding is to change the speed.
        let constant = cruises && (i..i + 3).all(|k| c[k].to_bits() == c[i].to_bits());
        let law = if constant { [c[i], 0.0, 0.0] } else { [dot(&w.value), dot(&w.first), dot(&w.second)] };
        let asked = cells.asked(i);
        Self::new((cells.tau[i], cells.tau[i + 1]), t, law, (cruises, [asked[0], asked[asked.len() - 1]]))
    }

    /// Speed by `tau` there: the squared speed is `v^2 + 2 a x + w x^2`.
    pub(super) fn speed(&self, tau: f64) -> f64 {
        let x = tau - self.tau;
        (self.v * self.v + x * (2.0 * self.a + self.w * x)).max(0.0).sqrt()
    }

    /// Time at which `tau` in it is passed with the speed `v`.
    pub(super) fn passed(&self, tau: f64, v: f64) -> f64 {
        if tau > self.tau { self.t + crossing(self.w, (tau - self.tau) / (self.v + v)) } else { self.t }
    }

    /// The law `t` after the cell's start, `map` being that of its piece; at a border of the map from the side
    /// `before`.
    pub(super) fn point(&self, map: &RestToRest, t: f64, before: bool) -> LawPoint {
        let (travelled, v) = self.after(t);
        let (a, j) = (self.a + self.w * travelled, self.w * v);
        let [u, m1, m2, m3] = map.at((self.tau + travelled).min(self.end), before);
        LawPoint { s: u, v: m1 * v, a: m2 * v * v + m1 * a, j: m3 * v * v * v + 3.0 * m2 * v * a + m1 * j }
    }

    /// How far it has gone `t` after its start, and how fast it is then.
    fn after(&self, t: f64) -> (f64, f64) {
        let x = self.w * t * t;
        // sinh(sqrt(x)) / sqrt(x) and (cosh(sqrt(x)) - 1) / x, for either sign of x.
        let (s, c) = if x.abs() < 1e-2 {
            let s = 1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0 * (1.0 + x / 72.0)));
            (s, 0.5 + x / 24.0 * (1.0 + x / 30.0 * (1.0 + x / 56.0 * (1.0 + x / 90.0))))
        } else if x > 0.0 {
            let r = x.sqrt();
            (r.sinh() / r, (r.cosh() - 1.0) / x)
        } else {
            let r = (-x).sqrt();
            (r.sin() / r, (r.cos() - 1.0) / x)
        };
        (t * (self.v * s + self.a * t * c), (self.v * (1.0 + x * c) + self.a * t * s).max(0.0))
    }
}

/// Time over a cell whose width is `mean` times the sum of the speeds at its ends, where the acceleration grows by
/// `w` a unit of way: both ways of moving, `sinh` and `cosh` about its middle, cover `tanh(sqrt(w) t / 2) / sqrt(w)`
/// a unit of that sum.
fn crossing(w: f64, mean: f64) -> f64 {
    let x = w * mean * mean;
    if x.abs() < 1e-4 {
        // atanh(y) / y with y^2 = x.
        2.0 * mean * (1.0 + x * (1.0 / 3.0 + x * (0.2 + x / 7.0)))
    } else if x > 0.0 {
        // Below 1, where rounding leaves it: a speed next to nothing beside a great one.
        2.0 * x.sqrt().min(1.0 - f64::EPSILON).atanh() / w.sqrt()
    } else {
        2.0 * (-x).sqrt().atan() / (-w).sqrt()
    }
}
