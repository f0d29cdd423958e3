use super::cells::{Cells, PARTS, Weights};
use super::pentadiagonal::Pentadiagonal;

/// The rows that a law's coefficients must satisfy, each as a slack that is to stay positive.
///
/// The squared speed `b` by `tau` is a quadratic B-spline with coefficients `c`, the unknowns. At every site, with `b`, `b'`
/// and `b''` weighted sums of three of them (derivatives by `tau`, each channel divided by its limit):
/// `1 - cap b`, `1 -+ (q'' b + q' b' / 2)`, and `1 / sqrt(b) -+ (q''' b + 3/2 q'' b' + 1/2 q' b'')`.
pub(crate) struct Problem {
    /// Number of unknowns.
    pub(crate) unknowns: usize,
    /// Highest value of each unknown, from the asked speed.
    pub(crate) upper: Vec<f64>,
    sites: Vec<Site>,
    acceleration: Vec<[f64; 2]>,
    jerk: Vec<[f64; 3]>,
    /// Number of slacks.
    pub(crate) slacks: usize,
    /// Widths of the cells and weights of the squared speed at their starts, middles and ends, for the time.
    simpson: Vec<(f64, [[f64; 3]; 3])>,
}

/// A place in a cell where rows are imposed.
struct Site {
    cell: usize,
    weights: Weights,
    cap: f64,
    /// First and last of its rows of accelerations and of jerks.
    acceleration: (usize, usize),
    jerk: (usize, usize),
    /// Its first slack.
    slack: usize,
}

impl Site {
    /// The squared speed and its derivatives.
    fn law(&self, c: &[f64]) -> [f64; 3] {
        let c = &c[self.cell..self.cell + 3];
        [dot(&self.weights.value, c), dot(&self.weights.first, c), dot(&self.weights.second, c)]
    }
}

fn dot(w: &[f64; 3], c: &[f64]) -> f64 {
    w[0] * c[0] + w[1] * c[1] + w[2] * c[2]
}

/// Slopes of the time, the rows' part of the Newton matrix, and its part that is not convex.
pub(crate) struct Newton {
    pub(crate) slope: Vec<f64>,
    pub(crate) matrix: Pentadiagonal,
    pub(crate) concave: Pentadiagonal,
}

impl Problem {
    /// The rows of `cells`, limits in each cell multiplied by `room`; cells with `dense` get rows at more places.
    pub(crate) fn new(cells: &Cells, room: &[f64], dense: &[bool]) -> Self {
        let unknowns = cells.count() + 2;
        let upper = (0..unknowns).map(|k| cells.upper(k)).collect();
        let simpson = (0..cells.count())
            .map(|i| (cells.width(i), [0, 2, 4].map(|part| cells.weights_at(i, part).value)))
            .collect();
        let mut built =
            Self { unknowns, upper, sites: Vec::new(), acceleration: Vec::new(), jerk: Vec::new(), slacks: 0, simpson };
        for cell in 0..cells.count() {
            let last = cell + 1 == cells.count();
            for part in 0..PARTS.len() {
                // Acceleration is continuous between cells, jerk is not.
                let (begin, end) = (part == 0, part + 1 == PARTS.len());
                if begin || end || dense[cell] {
                    built.add(cells, (cell, part), room[cell], begin || dense[cell] || (end && last));
                }
            }
        }
        built
    }

    fn add(&mut self, cells: &Cells, (cell, part): (usize, usize), room: f64, accelerations: bool) {
        let (first_acceleration, first_jerk) = (self.acceleration.len(), self.jerk.len());
        for ([q1, q2, q3], limits) in cells.derivatives(cell, part).iter().zip(&cells.limits) {
            if accelerations && (*q1 != 0.0 || *q2 != 0.0) {
                let scale = 1.0 / (room * limits.acceleration);
                self.acceleration.push([q2 * scale, 0.5 * q1 * scale]);
            }
            if limits.jerk.is_finite() && (*q1 != 0.0 || *q2 != 0.0 || *q3 != 0.0) {
                let scale = 1.0 / (room * limits.jerk);
                self.jerk.push([q3 * scale, 1.5 * q2 * scale, 0.5 * q1 * scale]);
            }
        }
        let site = Site {
            cell,
            weights: cells.weights_at(cell, part),
            cap: 1.0 / (cells.speed_cap(cell, part) * room * room),
            acceleration: (first_acceleration, self.acceleration.len()),
            jerk: (first_jerk, self.jerk.len()),
            slack: self.slacks,
        };
        self.slacks += 1 + 2 * (self.acceleration.len() - first_acceleration + self.jerk.len() - first_jerk);
        self.sites.push(site);
    }

    fn rows(&self, site: &Site) -> (&[[f64; 2]], &[[f64; 3]]) {
        (&self.acceleration[site.acceleration.0..site.acceleration.1], &self.jerk[site.jerk.0..site.jerk.1])
    }

    /// The greatest constant for all coefficients that satisfies every row.
    pub(crate) fn greatest_constant(&self) -> f64 {
        let mut k = self.upper.iter().copied().fold(f64::INFINITY, f64::min);
        for site in &self.sites {
            let (acceleration, jerk) = self.rows(site);
            let by_acceleration = acceleration.iter().map(|a| a[0].abs()).fold(site.cap, f64::max);
            let by_jerk = jerk.iter().map(|j| j[0].abs()).fold(0.0, f64::max);
            k = k.min(1.0 / by_acceleration).min(by_jerk.cbrt().powi(-2));
        }
        k
    }

    /// Time along the path, s, by Simpson's rule.
    pub(crate) fn time(&self, c: &[f64]) -> f64 {
        let cell = |(i, (width, at)): (usize, &(f64, [[f64; 3]; 3]))| {
            let v = at.map(|w| 1.0 / dot(&w, &c[i..i + 3]).sqrt());
            width / 6.0 * (v[0] + 4.0 * v[1] + v[2])
        };
        self.simpson.iter().enumerate().map(cell).sum()
    }

    /// The slacks at `c`; false if the squared speed is not positive somewhere.
    pub(crate) fn slacks(&self, c: &[f64], out: &mut [f64]) -> bool {
        for site in &self.sites {
            let [b, d, e] = site.law(c);
            if b.is_nan() || b <= 0.0 {
                return false;
            }
            let (acceleration, jerk) = self.rows(site);
            let (own, rest) = out[site.slack..].split_at_mut(1);
            own[0] = 1.0 - site.cap * b;
            let (plus, rest) = rest.split_at_mut(acceleration.len());
            let (minus, rest) = rest.split_at_mut(acceleration.len());
            for ((a, p), m) in acceleration.iter().zip(plus).zip(minus) {
                let used = a[0] * b + a[1] * d;
                (*p, *m) = (1.0 - used, 1.0 + used);
            }
            let (plus, rest) = rest.split_at_mut(jerk.len());
            let room = 1.0 / b.sqrt();
            for ((j, p), m) in jerk.iter().zip(plus).zip(&mut rest[..jerk.len()]) {
                let used = j[0] * b + j[1] * d + j[2] * e;
                (*p, *m) = (room - used, room + used);
            }
        }
        true
    }

    /// How the slacks change with `step` at `c`.
    pub(crate) fn change(&self, c: &[f64], step: &[f64], out: &mut [f64]) {
        for site in &self.sites {
            let [b, ..] = site.law(c);
            let [db, dd, de] = site.law(step);
            let (acceleration, jerk) = self.rows(site);
            let (own, rest) = out[site.slack..].split_at_mut(1);
            own[0] = -site.cap * db;
            let (plus, rest) = rest.split_at_mut(acceleration.len());
            let (minus, rest) = rest.split_at_mut(acceleration.len());
            for ((a, p), m) in acceleration.iter().zip(plus).zip(minus) {
                let used = a[0] * db + a[1] * dd;
                (*p, *m) = (-used, used);
            }
            let (plus, rest) = rest.split_at_mut(jerk.len());
            let room = -0.5 * db / (b * b.sqrt());
            for ((j, p), m) in jerk.iter().zip(plus).zip(&mut rest[..jerk.len()]) {
                let used = j[0] * db + j[1] * dd + j[2] * de;
                (*p, *m) = (room - used, room + used);
            }
        }
    }

    /// Adds the slacks' slopes at `c`, weighted with `weight`, to `out`.
    pub(crate) fn weighted_slopes(&self, c: &[f64], weight: &[f64], out: &mut [f64]) {
        for site in &self.sites {
            let [b, ..] = site.law(c);
            let (acceleration, jerk) = self.rows(site);
            let y = &weight[site.slack..];
            let (mut by_value, mut by_first, mut by_second) = (-site.cap * y[0], 0.0, 0.0);
            let (n, m) = (acceleration.len(), jerk.len());
            for (i, a) in acceleration.iter().enumerate() {
                let w = y[1 + n + i] - y[1 + i];
                by_value += w * a[0];
                by_first += w * a[1];
            }
            let y = &y[1 + 2 * n..];
            let mut both = 0.0;
            for (i, j) in jerk.iter().enumerate() {
                let w = y[m + i] - y[i];
                both += y[m + i] + y[i];
                by_value += w * j[0];
                by_first += w * j[1];
                by_second += w * j[2];
            }
            by_value -= 0.5 * both / (b * b.sqrt());
            let w = &site.weights;
            for k in 0..3 {
                out[site.cell + k] += by_value * w.value[k] + by_first * w.first[k] + by_second * w.second[k];
            }
        }
    }

    /// Slopes and curvatures at `c` with slacks `g` and their multipliers `z`.
    pub(crate) fn newton(&self, c: &[f64], g: &[f64], z: &[f64], out: &mut Newton) {
        out.slope.iter_mut().for_each(|x| *x = 0.0);
        out.matrix.clear();
        out.concave.clear();
        for (i, (width, at)) in self.simpson.iter().enumerate() {
            for (w, part) in at.iter().zip([1.0, 4.0, 1.0]) {
                let b = dot(w, &c[i..i + 3]);
                let root = part * width / 6.0 / (b * b.sqrt());
                (0..3).for_each(|k| out.slope[i + k] -= 0.5 * root * w[k]);
                out.matrix.add(i, 0.75 * root / b, w, w);
            }
        }
        for site in &self.sites {
            let [b, ..] = site.law(c);
            let (m, concave) = self.curvature(site, b, g, z);
            let w = &site.weights;
            let parts = [&w.value, &w.first, &w.second];
            for i in 0..3 {
                for j in i..3 {
                    out.matrix.add(site.cell, if i == j { m[i][j] } else { 2.0 * m[i][j] }, parts[i], parts[j]);
                }
            }
            out.concave.add(site.cell, concave, &w.value, &w.value);
        }
    }

    /// The weighted squares of the rows' slopes by (b, b', b''), and the curvature of `1 / sqrt(b)` that works against
    /// them.
    fn curvature(&self, site: &Site, b: f64, g: &[f64], z: &[f64]) -> ([[f64; 3]; 3], f64) {
        let (acceleration, jerk) = self.rows(site);
        let (g, z) = (&g[site.slack..], &z[site.slack..]);
        let mut m = [[0.0; 3]; 3];
        m[0][0] = site.cap * site.cap * z[0] / g[0];
        let n = acceleration.len();
        for (i, a) in acceleration.iter().enumerate() {
            let w = z[1 + i] / g[1 + i] + z[1 + n + i] / g[1 + n + i];
            m[0][0] += w * a[0] * a[0];
            m[0][1] += w * a[0] * a[1];
            m[1][1] += w * a[1] * a[1];
        }
        let (g, z, n) = (&g[1 + 2 * n..], &z[1 + 2 * n..], jerk.len());
        let slope = -0.5 / (b * b.sqrt());
        let (mut sum, mut multipliers, mut cross) = (0.0, 0.0, [0.0; 3]);
        for (i, j) in jerk.iter().enumerate() {
            let (plus, minus) = (z[i] / g[i], z[n + i] / g[n + i]);
            let (w, difference) = (plus + minus, plus - minus);
            multipliers += z[i] + z[n + i];
            sum += w;
            for k in 0..3 {
                cross[k] += difference * j[k];
                for l in k..3 {
                    m[k][l] += w * j[k] * j[l];
                }
            }
        }
        m[0][0] += sum * slope * slope - 2.0 * slope * cross[0];
        m[0][1] -= slope * cross[1];
        m[0][2] -= slope * cross[2];
        (m, 0.75 * multipliers / (b * b * b.sqrt()))
    }
}
