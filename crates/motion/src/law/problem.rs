use super::cells::{Cells, PARTS, Weights};
use super::jerk_limited::Room;
use super::pentadiagonal::Pentadiagonal;

/// The rows that a law's coefficients must satisfy, each as a slack that is to stay positive.
///
/// The squared speed `b` by `tau` is a quadratic B-spline with coefficients `c`, the unknowns. At every site, with
/// `b`, `b'` and `b''` weighted sums of three of them (derivatives by `tau`, each channel divided by its limit, with
/// either sign): `1 - cap b`, `1 - (q'' b + q' b' / 2)`, and `1 / sqrt(b) - (q''' b + 3/2 q'' b' + 1/2 q' b'')`.
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

/// How much of a limit a law known before must use in a cell or near it for its rows to be imposed on the next one.
const WORTH_A_ROW: f64 = 0.3;
/// Rows of jerk are always imposed on channels that move this part of the fastest one, by their limits.
const STIFF: f64 = 0.5;
/// Cells before and after that count as near.
const NEAR: usize = 3;

/// Part of the time that counts as lost at least.
const LEAST_LOST: f64 = 1e-3;

impl Problem {
    /// The rows of `cells`, within the `room` of each. With the
    /// coefficients `near` of a law near to the one wanted, rows that it is far from are left out of the other cells.
    pub(crate) fn new(cells: &Cells, room: &Room, near: Option<&[f64]>) -> Self {
        let unknowns = cells.count() + 2;
        let upper = (0..unknowns).map(|k| cells.upper(k)).collect();
        let simpson = (0..cells.count())
            .map(|i| (cells.width(i), [0, 2, 4].map(|part| cells.weights_at(i, part).value)))
            .collect();
        let mut built =
            Self { unknowns, upper, sites: Vec::new(), acceleration: Vec::new(), jerk: Vec::new(), slacks: 0, simpson };
        let channels = cells.limits.len();
        let used = near.map(|c| uses(cells, c));
        let mut worth = vec![[true; 2]; channels];
        for cell in 0..cells.count() {
            let last = cell + 1 == cells.count();
            if let Some(used) = &used {
                let around = cell.saturating_sub(NEAR)..(cell + NEAR + 1).min(cells.count());
                let stiffness =
                    |channel: usize| cells.derivatives(cell, 2)[channel][0].abs() / cells.limits[channel].jerk;
                let stiffest = (0..channels).map(stiffness).fold(0.0, f64::max);
                let stiff = |channel: usize| stiffness(channel) > STIFF * stiffest;
                for (channel, worth) in worth.iter_mut().enumerate() {
                    let most = |k: usize| around.clone().map(|i| used[i * channels + channel][k]).fold(0.0, f64::max);
                    *worth = [0, 1].map(|k| room.dense[cell] || most(k) > WORTH_A_ROW);
                    // Those that bound the change of acceleration are always needed.
                    worth[1] |= stiff(channel);
                }
            }
            for part in 0..PARTS.len() {
                // Acceleration is continuous between cells, jerk is not.
                let (begin, end) = (part == 0, part + 1 == PARTS.len());
                let dense = room.dense[cell];
                if begin || end || dense || part == 2 {
                    // Speed is bounded in the middle too: else the law would bulge there.
                    let wanted = [begin || dense || (end && last), begin || end || dense];
                    built.add(cells, (cell, part), room.part[cell], wanted, &worth);
                }
            }
        }
        built
    }

    fn add(
        &mut self,
        cells: &Cells,
        (cell, part): (usize, usize),
        room: f64,
        [accelerations, jerks]: [bool; 2],
        worth: &[[bool; 2]],
    ) {
        let begin = (self.acceleration.len(), self.jerk.len());
        let mut site = Site {
            cell,
            weights: cells.weights_at(cell, part),
            cap: 1.0 / (cells.speed_cap(cell, part) * room * room),
            acceleration: begin,
            jerk: begin,
            slack: self.slacks,
        };
        let channels = cells.derivatives(cell, part).iter().zip(&cells.limits).zip(worth);
        for (([q1, q2, q3], limits), worth) in channels {
            if accelerations && worth[0] && (*q1 != 0.0 || *q2 != 0.0) {
                let scale = 1.0 / (room * limits.acceleration);
                let row = [q2 * scale, 0.5 * q1 * scale];
                self.acceleration.extend([row, row.map(|x| -x)]);
            }
            if jerks && worth[1] && limits.jerk.is_finite() && (*q1 != 0.0 || *q2 != 0.0 || *q3 != 0.0) {
                let scale = 1.0 / (room * limits.jerk);
                let row = [q3 * scale, 1.5 * q2 * scale, 0.5 * q1 * scale];
                self.jerk.extend([row, row.map(|x| -x)]);
            }
        }
        site.acceleration = (begin.0, self.acceleration.len());
        site.jerk = (begin.1, self.jerk.len());
        self.slacks += 1 + self.acceleration.len() - begin.0 + self.jerk.len() - begin.1;
        self.sites.push(site);
    }

    /// A site's rows and, of a list of one value a slack, those of its cap, its accelerations and its jerks.
    fn rows<'a>(&'a self, site: &Site, values: &'a [f64]) -> Rows<'a> {
        let acceleration = &self.acceleration[site.acceleration.0..site.acceleration.1];
        let jerk = &self.jerk[site.jerk.0..site.jerk.1];
        let (own, rest) = values[site.slack..].split_at(1);
        let (of_acceleration, rest) = rest.split_at(acceleration.len());
        Rows { acceleration, jerk, values: (own[0], of_acceleration, &rest[..jerk.len()]) }
    }

    /// The greatest constant for all coefficients that satisfies every row.
    pub(crate) fn greatest_constant(&self) -> f64 {
        let upper = self.upper.iter().copied().fold(f64::INFINITY, f64::min);
        let by_cap = self.sites.iter().map(|s| s.cap).fold(0.0, f64::max);
        let by_acceleration = self.acceleration.iter().map(|a| a[0].abs()).fold(by_cap, f64::max);
        let by_jerk = self.jerk.iter().map(|j| j[0].abs()).fold(0.0, f64::max);
        upper.min(1.0 / by_acceleration).min(by_jerk.cbrt().powi(-2))
    }

    /// Time along the path, s, by Simpson's rule.
    pub(crate) fn time(&self, c: &[f64]) -> f64 {
        let cell = |(i, (width, at)): (usize, &(f64, [[f64; 3]; 3]))| {
            let v = at.map(|w| 1.0 / dot(&w, &c[i..i + 3]).sqrt());
            width / 6.0 * (v[0] + 4.0 * v[1] + v[2])
        };
        self.simpson.iter().enumerate().map(cell).sum()
    }

    /// The part of the time that is lost against a law that is everywhere as fast as asked, s.
    pub(crate) fn lost(&self, c: &[f64]) -> f64 {
        let asked = |i: usize| self.upper[i].min(self.upper[i + 1]).min(self.upper[i + 2]);
        let cruising: f64 = self.simpson.iter().enumerate().map(|(i, (width, _))| width / asked(i).sqrt()).sum();
        // Never nothing, or no law would be near enough to it.
        (self.time(c) - cruising).max(LEAST_LOST * cruising)
    }

    /// The slacks at `c`; false if the squared speed is not positive somewhere.
    pub(crate) fn slacks(&self, c: &[f64], out: &mut [f64]) -> bool {
        for site in &self.sites {
            let law = site.law(c);
            if law[0].is_nan() || law[0] <= 0.0 {
                return false;
            }
            self.left(site, law, [1.0, 1.0, 1.0 / law[0].sqrt()], out);
        }
        true
    }

    /// How the slacks change with `step` at `c`.
    pub(crate) fn change(&self, c: &[f64], step: &[f64], out: &mut [f64]) {
        for site in &self.sites {
            let ([b, ..], change) = (site.law(c), site.law(step));
            self.left(site, change, [0.0, 0.0, -0.5 * change[0] / (b * b.sqrt())], out);
        }
    }

    /// `room` of cap, accelerations and jerks, less what the squared speed and its derivatives use.
    fn left(&self, site: &Site, [b, d, e]: [f64; 3], room: [f64; 3], out: &mut [f64]) {
        let (own, rest) = out[site.slack..].split_at_mut(1);
        own[0] = room[0] - site.cap * b;
        let acceleration = &self.acceleration[site.acceleration.0..site.acceleration.1];
        let (of_acceleration, rest) = rest.split_at_mut(acceleration.len());
        for (a, out) in acceleration.iter().zip(of_acceleration) {
            *out = room[1] - (a[0] * b + a[1] * d);
        }
        for (j, out) in self.jerk[site.jerk.0..site.jerk.1].iter().zip(rest) {
            *out = room[2] - (j[0] * b + j[1] * d + j[2] * e);
        }
    }

    /// Adds the slacks' slopes at `c`, weighted with `weight`, to `out`.
    pub(crate) fn weighted_slopes(&self, c: &[f64], weight: &[f64], out: &mut [f64]) {
        for site in &self.sites {
            let [b, ..] = site.law(c);
            let Rows { acceleration, jerk, values: (own, of_acceleration, of_jerk) } = self.rows(site, weight);
            let mut by = [-site.cap * own, 0.0, 0.0];
            for (a, w) in acceleration.iter().zip(of_acceleration) {
                by[0] -= w * a[0];
                by[1] -= w * a[1];
            }
            let mut sum = 0.0;
            for (j, w) in jerk.iter().zip(of_jerk) {
                sum += w;
                (0..3).for_each(|k| by[k] -= w * j[k]);
            }
            by[0] -= 0.5 * sum / (b * b.sqrt());
            let w = &site.weights;
            for k in 0..3 {
                out[site.cell + k] += by[0] * w.value[k] + by[1] * w.first[k] + by[2] * w.second[k];
            }
        }
    }

    /// Slopes of the time at `c`.
    pub(crate) fn slopes(&self, c: &[f64], out: &mut [f64]) {
        out.iter_mut().for_each(|x| *x = 0.0);
        for (i, (width, at)) in self.simpson.iter().enumerate() {
            for (w, part) in at.iter().zip([1.0, 4.0, 1.0]) {
                let b = dot(w, &c[i..i + 3]);
                let by = part * width / (12.0 * b * b.sqrt());
                (0..3).for_each(|k| out[i + k] -= by * w[k]);
            }
        }
    }

    /// Slopes and curvatures at `c` with multipliers `z` and their quotients `ratio` by the slacks.
    pub(crate) fn newton(&self, c: &[f64], ratio: &[f64], z: &[f64], out: &mut Newton) {
        self.slopes(c, &mut out.slope);
        out.matrix.clear();
        out.concave.clear();
        for (i, (width, at)) in self.simpson.iter().enumerate() {
            for (w, part) in at.iter().zip([1.0, 4.0, 1.0]) {
                let b = dot(w, &c[i..i + 3]);
                out.matrix.add(i, 0.125 * part * width / (b * b * b.sqrt()), w);
            }
        }
        for site in &self.sites {
            let [b, ..] = site.law(c);
            let m = self.squares(site, b, ratio);
            let w = &site.weights;
            let parts = [&w.value, &w.first, &w.second];
            // By coefficients: of the rows' weights first, then of both.
            let half: [[f64; 3]; 3] =
                m.map(|m| std::array::from_fn(|k| m[0] * parts[0][k] + m[1] * parts[1][k] + m[2] * parts[2][k]));
            let by_coefficient = |i: usize, k: usize| (0..3).map(|j| parts[j][i] * half[j][k]).sum::<f64>();
            out.matrix.add_square(site.cell, &std::array::from_fn(|i| std::array::from_fn(|k| by_coefficient(i, k))));
            let multipliers: f64 = self.rows(site, z).values.2.iter().sum();
            out.concave.add(site.cell, 0.75 * multipliers / (b * b * b.sqrt()), &w.value);
        }
    }

    /// The squares of a site's rows' slopes by the squared speed and its derivatives, weighted with `ratio`.
    fn squares(&self, site: &Site, b: f64, ratio: &[f64]) -> [[f64; 3]; 3] {
        let Rows { acceleration, jerk, values: (own, of_acceleration, of_jerk) } = self.rows(site, ratio);
        let mut m = [[0.0; 3]; 3];
        m[0][0] = site.cap * site.cap * own;
        for (a, w) in acceleration.iter().zip(of_acceleration) {
            m[0][0] += w * a[0] * a[0];
            m[0][1] += w * a[0] * a[1];
            m[1][1] += w * a[1] * a[1];
        }
        let slope = 0.5 / (b * b.sqrt());
        for (j, w) in jerk.iter().zip(of_jerk) {
            let j = [j[0] + slope, j[1], j[2]];
            for k in 0..3 {
                (k..3).for_each(|l| m[k][l] += w * j[k] * j[l]);
            }
        }
        [[m[0][0], m[0][1], m[0][2]], [m[0][1], m[1][1], m[1][2]], [m[0][2], m[1][2], m[2][2]]]
    }
}

/// Rows of a site, and one value for its cap, each acceleration and each jerk.
struct Rows<'a> {
    acceleration: &'a [[f64; 2]],
    jerk: &'a [[f64; 3]],
    values: (f64, &'a [f64], &'a [f64]),
}

/// The part of its acceleration and jerk that each channel uses in each cell, at the cell's ends and middle.
fn uses(cells: &Cells, c: &[f64]) -> Vec<[f64; 2]> {
    let mut used = Vec::with_capacity(cells.count() * cells.limits.len());
    for cell in 0..cells.count() {
        let laws = [0, 2, 4].map(|part| {
            let w = cells.weights_at(cell, part);
            (part, [&w.value, &w.first, &w.second].map(|w| dot(w, &c[cell..cell + 3])))
        });
        for (channel, limits) in cells.limits.iter().enumerate() {
            let mut most: [f64; 2] = [0.0; 2];
            for (part, [b, d, e]) in laws {
                let [q1, q2, q3] = cells.derivatives(cell, part)[channel];
                let jerk = b.max(0.0).sqrt() * (q3 * b + 1.5 * q2 * d + 0.5 * q1 * e);
                most = [
                    most[0].max((q2 * b + 0.5 * q1 * d).abs() / limits.acceleration),
                    most[1].max(jerk.abs() / limits.jerk),
                ];
            }
            used.push(most);
        }
    }
    used
}
