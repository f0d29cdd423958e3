use super::channels::Channels;
use super::error::SpeedProfileError;
use super::rest_to_rest::RestToRest;
use crate::stretch::Stretch;
use seamwright_machine::AxisLimits;

/// Sample points of the path in each cell, as fractions of its width.
pub(crate) const PARTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Relative tolerance of a cruise in a cell in which the requested speed by the parameter changes.
pub(crate) const NEARLY: f64 = 3e-3;

/// Minimum fraction of the requested speed at which the profile counts as near it.
const NEAR: f64 = 0.9;

/// Weights of a cell's three coefficients in the squared speed, its first and its second derivative by `tau`.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Weights {
    pub(crate) value: [f64; 3],
    pub(crate) first: [f64; 3],
    pub(crate) second: [f64; 3],
}

/// A piece of path from rest to rest, divided into cells, with the derivatives of all channels by `tau` in them.
pub(crate) struct Cells {
    pub(crate) map: RestToRest,
    /// Stations between cells, from 0 to the map's length.
    pub(crate) tau: Vec<f64>,
    pub(crate) limits: Vec<AxisLimits>,
    /// Channels' derivatives at [`PARTS`] of every cell.
    derivatives: Vec<[f64; 3]>,
    /// Requested squared speed by `tau` at the same points.
    asked: Vec<f64>,
    /// Maximum squared speed by `tau` that the channels' speeds allow at the same points.
    caps: Vec<f64>,
}

impl Cells {
    /// The piece of `path` that `map` covers, with stations at `tau`, which must contain the map's borders and the
    /// path's breaks.
    pub(crate) fn new(
        path: &dyn Channels,
        map: RestToRest,
        tau: Vec<f64>,
        limits: Vec<AxisLimits>,
    ) -> Result<Self, SpeedProfileError> {
        let (channels, cells) = (limits.len(), tau.len() - 1);
        let mut derivatives = vec![[0.0; 3]; cells * PARTS.len() * channels];
        let mut asked = Vec::with_capacity(cells * PARTS.len());
        for (i, row) in derivatives.chunks_exact_mut(channels).enumerate() {
            let (cell, part) = (i / PARTS.len(), PARTS[i % PARTS.len()]);
            let here = place(path, &map, Stretch { from: tau[cell], to: tau[cell + 1] }, part, row);
            if here.is_nan() || row.iter().flatten().any(|d| !d.is_finite()) {
                return Err(broken(path, map.at(tau[cell] + part * (tau[cell + 1] - tau[cell]), part > 0.5)[0], row));
            }
            asked.push(here);
        }
        let cap = |row: &[[f64; 3]]| {
            let ratio = row.iter().zip(&limits).map(|(d, l)| d[0].abs() / l.speed).fold(0.0, f64::max);
            1.0 / (ratio * ratio)
        };
        let caps = derivatives.chunks_exact(channels).map(cap).collect();
        let built = Self { map, tau, limits, derivatives, asked, caps };
        let moves = built.derivatives.iter().any(|d| d[0] != 0.0) || built.asked.iter().any(|a| a.is_finite());
        if moves { Ok(built) } else { Err(SpeedProfileError::Still { from: map.from, to: map.to }) }
    }

    pub(crate) fn count(&self) -> usize {
        self.tau.len() - 1
    }

    pub(crate) fn stretch(&self, i: usize) -> Stretch {
        Stretch { from: self.tau[i], to: self.tau[i + 1] }
    }

    pub(crate) fn width(&self, i: usize) -> f64 {
        self.tau[i + 1] - self.tau[i]
    }

    pub(crate) fn derivatives(&self, cell: usize, part: usize) -> &[[f64; 3]] {
        let n = self.limits.len();
        &self.derivatives[(cell * PARTS.len() + part) * n..][..n]
    }

    /// Maximum squared speed by `tau` that the channels' speeds allow there, also bounded by the requested one unless
    /// that is constant in the cell.
    pub(crate) fn speed_cap(&self, cell: usize, part: usize) -> f64 {
        let asked = if self.is_steady(cell) { f64::INFINITY } else { self.asked(cell)[part] };
        asked.min(self.caps[cell * PARTS.len() + part])
    }

    /// Requested squared speeds by `tau` at [`PARTS`] of `cell`; infinite if none.
    pub(crate) fn asked(&self, cell: usize) -> &[f64] {
        &self.asked[cell * PARTS.len()..][..PARTS.len()]
    }

    /// True if the requested squared speed by `tau` is constant in `cell`.
    pub(crate) fn is_steady(&self, cell: usize) -> bool {
        let asked = self.asked(cell);
        asked[0].is_finite() && asked.iter().all(|a| (a - asked[0]).abs() <= 1e-9 * asked[0])
    }

    /// True if the profile with coefficients `c` has the requested speed in all of `cell`: exactly if the requested
    /// speed by the parameter is constant there, else within [`NEARLY`]. A cell near rest with a changing speed never
    /// cruises, since the map changes there.
    pub(crate) fn cruises(&self, c: &[f64], cell: usize) -> bool {
        if self.is_steady(cell) {
            return (cell..cell + 3).all(|k| c[k] >= self.upper(k));
        }
        if self.is_near_rest(cell) {
            return false;
        }
        let least = (1.0 - NEARLY) * (1.0 - NEARLY);
        PARTS.iter().zip(self.asked(cell)).all(|(part, asked)| self.profile(c, cell, *part)[0] >= least * asked)
    }

    /// True in the zones at rest, in which the map changes.
    pub(crate) fn is_near_rest(&self, cell: usize) -> bool {
        let [up, down] = self.map.borders();
        self.tau[cell] < up || self.tau[cell + 1] > down
    }

    /// Delay (s) over `cell` of the profile with coefficients `c` against the requested speed, if that changes there
    /// and the profile is near it; else 0.
    pub(crate) fn late(&self, c: &[f64], cell: usize) -> f64 {
        if self.is_near_rest(cell) || self.is_steady(cell) || self.cruises(c, cell) {
            return 0.0;
        }
        let ratio = |(part, asked): (&f64, &f64)| (self.profile(c, cell, *part)[0] / asked).sqrt();
        let ratios = PARTS.iter().zip(self.asked(cell)).map(ratio);
        let least = ratios.fold(1.0, f64::min);
        if least < NEAR { 0.0 } else { (1.0 - least) * self.width(cell) / c[cell + 1].sqrt() }
    }

    /// Upper bound of coefficient `k` from the requested speed in cells in which it is constant: a squared speed never
    /// exceeds the maximum of its coefficients.
    pub(crate) fn upper(&self, k: usize) -> f64 {
        let cells = (k.saturating_sub(2)..=k.min(self.count() - 1)).filter(|cell| self.is_steady(*cell));
        cells.flat_map(|cell| self.asked(cell)).copied().fold(f64::INFINITY, f64::min)
    }

    /// Weights at the start of `cell`: of the squared speed and its derivatives by `tau`.
    pub(crate) fn weights(&self, cell: usize) -> Weights {
        let last = self.count() - 1;
        let width = |i: usize| self.width(i.min(last));
        let (before, own, after) = (width(cell.saturating_sub(1)), width(cell), width(cell + 1));
        let (left, right) = (before + own, own + after);
        let (first_left, first_right) = ([-2.0 / left, 2.0 / left, 0.0], [0.0, -2.0 / right, 2.0 / right]);
        Weights {
            value: [own / left, before / left, 0.0],
            first: first_left,
            second: std::array::from_fn(|i| (first_right[i] - first_left[i]) / own),
        }
    }

    /// Squared speed and its derivatives by `tau` at the `part` of `cell`, with coefficients `c`.
    pub(crate) fn profile(&self, c: &[f64], cell: usize, part: f64) -> [f64; 3] {
        let w = self.weights(cell);
        let dot = |w: &[f64; 3]| w[0] * c[cell] + w[1] * c[cell + 1] + w[2] * c[cell + 2];
        let (x, [b, d, e]) = (part * self.width(cell), [dot(&w.value), dot(&w.first), dot(&w.second)]);
        [b + x * (d + 0.5 * x * e), d + x * e, e]
    }

    /// Weights at [`PARTS`]`[part]` of `cell`.
    pub(crate) fn weights_at(&self, cell: usize, part: usize) -> Weights {
        let (w, x) = (self.weights(cell), PARTS[part] * self.width(cell));
        Weights {
            value: std::array::from_fn(|i| w.value[i] + x * (w.first[i] + 0.5 * x * w.second[i])),
            first: std::array::from_fn(|i| w.first[i] + x * w.second[i]),
            second: w.second,
        }
    }
}

impl Cells {
    /// Stations after halving every cell for which `split` is true.
    pub(crate) fn halved(&self, split: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut tau = vec![self.tau[0]];
        for (i, w) in self.tau.windows(2).enumerate() {
            if split(i) {
                tau.push(0.5 * (w[0] + w[1]));
            }
            tau.push(w[1]);
        }
        tau
    }

    /// Stations after merging pairs of neighbouring cells, but not across the map's borders.
    pub(crate) fn merged(&self) -> Vec<f64> {
        let borders = self.map.borders();
        let mut tau = vec![self.tau[0]];
        let mut odd = false;
        for t in &self.tau[1..] {
            let is_border = borders.contains(t) || *t >= self.map.length();
            if odd || is_border {
                tau.push(*t);
            }
            odd = !odd && !is_border;
        }
        tau
    }

    /// Converts the coefficients `c` in these cells to coefficients in `finer` ones, which divide a range of these and
    /// count `tau` from `offset`. Each is the blossom of the spline's piece at the two stations beside it.
    pub(crate) fn carried(&self, c: &[f64], finer: &Self, offset: f64) -> Vec<f64> {
        let last = finer.count();
        let mut cell = 0;
        let coefficient = |k: usize| {
            // Stations k - 1 and k; outside the first and last station as wide as the neighbouring cell.
            let (left, right) = match k {
                0 => (finer.tau[0] - finer.width(0), finer.tau[0]),
                _ if k > last => (finer.tau[last], finer.tau[last] + finer.width(last - 1)),
                _ => (finer.tau[k - 1], finer.tau[k]),
            };
            // The piece over the finer cell between them, at the ends over the neighbouring one.
            let inside = offset + 0.5 * (finer.tau[k.clamp(1, last) - 1] + finer.tau[k.clamp(1, last)]);
            while cell + 1 < self.count() && self.tau[cell + 1] <= inside {
                cell += 1;
            }
            if c[cell].to_bits() == c[cell + 1].to_bits() && c[cell].to_bits() == c[cell + 2].to_bits() {
                return c[cell];
            }
            let w = self.weights(cell);
            let dot = |w: &[f64; 3]| w[0] * c[cell] + w[1] * c[cell + 1] + w[2] * c[cell + 2];
            let (x, y) = (left + offset - self.tau[cell], right + offset - self.tau[cell]);
            dot(&w.value) + 0.5 * dot(&w.first) * (x + y) + 0.5 * dot(&w.second) * x * y
        };
        (0..finer.count() + 2).map(coefficient).collect()
    }
}

/// Writes the channels' derivatives by `tau` at the `part` of a cell, which lies over a stretch of `tau`, to `row`.
/// Returns the requested squared speed there: infinite if none, NaN if invalid.
pub(crate) fn place(path: &dyn Channels, map: &RestToRest, cell: Stretch, part: f64, row: &mut [[f64; 3]]) -> f64 {
    let Stretch { from, to } = cell;
    let before = part > 0.5;
    let tau = if part >= 1.0 { to } else { from + part * (to - from) };
    // A part inside a cell may round to its end.
    let [u, m1, m2, m3] = map.at(tau, before);
    let middle = map.at(0.5 * (from + to), before)[0];
    // Rounding must not cross a break: the third derivative differs on the other side.
    let inside = 1e-9 * (middle - u).abs() + 4.0 * f64::EPSILON * u.abs().max(middle.abs());
    let u = u + inside.min((middle - u).abs()) * (middle - u).signum();
    let tip = path.derivatives(u, before, row) * m1;
    for d in row.iter_mut() {
        let [q1, q2, q3] = *d;
        *d = [q1 * m1, q2 * m1 * m1 + q1 * m2, q3 * m1 * m1 * m1 + 3.0 * q2 * m1 * m2 + q1 * m3];
    }
    let asked = path.asked(u);
    if !(asked > 0.0 && tip.is_finite()) {
        return f64::NAN;
    }
    let speed = asked / tip.abs();
    if speed.is_nan() { f64::INFINITY } else { speed * speed }
}

/// Error of the path at `u`, at which the channels have the derivatives `row`.
pub(crate) fn broken(path: &dyn Channels, u: f64, row: &[[f64; 3]]) -> SpeedProfileError {
    match row.iter().position(|d| d.iter().any(|d| !d.is_finite())) {
        Some(channel) => SpeedProfileError::NotSmooth { channel, at: u },
        None => SpeedProfileError::Asked { at: u, value: path.asked(u) },
    }
}
