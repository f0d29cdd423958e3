use super::cells::{Cells, Weights};
use super::row_selection::{Forms, Room};
use seamwright_geometry::numeric::Pentadiagonal;
use std::ops::Range;

/// The rows that a profile's coefficients must satisfy, each as a slack that must stay positive.
///
/// The squared speed `b` by `tau` is a quadratic B-spline with coefficients `c`, the unknowns. In a cell it and its
/// derivatives follow from those at the cell's start, so every row is a form of these three: with each channel
/// divided by its limit `1 - cap b`, `1 - (q'' b + q' b' / 2)` and `1 / sqrt(b) - (q''' b + 3/2 q'' b' + 1/2 q' b'')`,
/// the last two with either sign, which share their form. Coefficients are also positive and bounded by the requested
/// speed.
pub(crate) struct Problem {
    /// Number of unknowns.
    pub(crate) unknowns: usize,
    /// Maximum of each unknown, from the requested speed; infinite if none.
    pub(super) upper: Vec<f64>,
    /// The unknowns with a maximum.
    pub(super) bounded: Vec<usize>,
    pub(super) caps: Forms,
    pub(super) accelerations: Forms,
    pub(super) jerks: Forms,
    pub(super) places: Vec<Place>,
    pub(super) groups: Vec<Group>,
    /// Quadrature points of the time: first unknown, weights in the squared speed, and quadrature weight.
    points: Vec<(usize, [f64; 3], f64)>,
    /// Time at the requested speed everywhere, s.
    cruising: f64,
    /// The room that the rows leave, and the cells that have all rows.
    pub(super) room: Room,
    /// True if the accelerations and jerks of each channel have rows in each cell that is not dense,
    pub(super) worth: Vec<[bool; 2]>,
    /// and if the speeds of any channel have rows.
    pub(super) worth_cap: Vec<bool>,
}

/// Rows of one cell.
pub(super) struct Group {
    pub(super) cell: usize,
    /// At the cell's start.
    pub(super) weights: Weights,
    /// Its caps, accelerations, and points with jerks.
    pub(super) caps: Range<usize>,
    pub(super) accelerations: Range<usize>,
    pub(super) places: Range<usize>,
}

/// A point in a cell with rows of jerks.
pub(super) struct Place {
    /// Weights of the squared speed and its derivatives at the cell's start in the squared speed here.
    pub(super) along: [f64; 3],
    pub(super) jerks: Range<usize>,
}

/// One value for each slack: of accelerations and of jerks with either sign, of caps, and of the unknowns' lower and
/// upper bounds.
pub(crate) type Lists = [Vec<f64>; 7];

/// Slopes and curvatures at a profile.
pub(crate) struct Newton {
    pub(crate) time: f64,
    /// Slopes of the time,
    pub(crate) slope: Vec<f64>,
    /// and the residual after the rows with their multipliers.
    pub(crate) left: Vec<f64>,
    /// The Newton matrix, and its part that is not convex.
    pub(crate) matrix: Pentadiagonal,
    pub(crate) concave: Pentadiagonal,
    /// Slope of `1 / sqrt(b)` by `b` at every point with jerks.
    pub(crate) steep: Vec<f64>,
}

/// Minimum lost time, as a fraction of the time at the requested speed.
const MIN_LOST: f64 = 1e-3;

fn dot(w: &[f64; 3], c: &[f64; 3]) -> f64 {
    w[0] * c[0] + w[1] * c[1] + w[2] * c[2]
}

fn three(c: &[f64], first: usize) -> [f64; 3] {
    [c[first], c[first + 1], c[first + 2]]
}

impl Group {
    fn profile(&self, c: &[f64]) -> [f64; 3] {
        let c = three(c, self.cell);
        [dot(&self.weights.value, &c), dot(&self.weights.first, &c), dot(&self.weights.second, &c)]
    }

    /// Converts slopes by the squared speed and its derivatives to slopes by the coefficients.
    fn by_coefficients(&self, by: [f64; 3]) -> [f64; 3] {
        let w = &self.weights;
        std::array::from_fn(|k| by[0] * w.value[k] + by[1] * w.first[k] + by[2] * w.second[k])
    }

    /// Adds a symmetric matrix by the squared speed and its derivatives, given by its upper triangle.
    fn add(&self, m: &Square, to: &mut Pentadiagonal) {
        let m = [[m.0[0], m.0[1], m.0[2]], [m.0[1], m.0[3], m.0[4]], [m.0[2], m.0[4], m.0[5]]];
        let half = m.map(|row| self.by_coefficients(row));
        let w = [&self.weights.value, &self.weights.first, &self.weights.second];
        let element = |i: usize, k: usize| w[0][i] * half[0][k] + w[1][i] * half[1][k] + w[2][i] * half[2][k];
        to.add_square(self.cell, &std::array::from_fn(|i| std::array::from_fn(|k| element(i, k))));
    }
}

/// Upper triangle of a symmetric matrix of three rows, row by row.
#[derive(Default, Clone, Copy)]
struct Square([f64; 6]);

/// Curvature in one cell, and its part that is not convex.
struct Curvature {
    whole: Square,
    concave: Square,
}

impl Square {
    /// Adds `factor (x y^T + y x^T) / 2`.
    fn add(&mut self, factor: f64, x: &[f64; 3], y: &[f64; 3]) {
        let half = 0.5 * factor;
        self.0[0] += factor * x[0] * y[0];
        self.0[1] += half * (x[0] * y[1] + x[1] * y[0]);
        self.0[2] += half * (x[0] * y[2] + x[2] * y[0]);
        self.0[3] += factor * x[1] * y[1];
        self.0[4] += half * (x[1] * y[2] + x[2] * y[1]);
        self.0[5] += factor * x[2] * y[2];
    }

    fn add_own(&mut self, factor: f64, x: &[f64; 3]) {
        let [a, b, c] = x.map(|x| factor * x);
        self.0[0] += a * x[0];
        self.0[1] += a * x[1];
        self.0[2] += a * x[2];
        self.0[3] += b * x[1];
        self.0[4] += b * x[2];
        self.0[5] += c * x[2];
    }
}

impl Problem {
    /// Sets the points of Simpson's rule for the time, and the time at the requested speeds.
    pub(super) fn measure(&mut self, cells: &Cells) {
        let count = cells.count();
        for i in 0..=count {
            let (cell, part) = if i < count { (i, 0) } else { (i - 1, 4) };
            let before = if i > 0 { cells.width(i - 1) } else { 0.0 };
            let own = if i < count { cells.width(i) } else { 0.0 };
            self.points.push((cell, cells.weights_at(cell, part).value, (before + own) / 6.0));
            if i < count {
                self.points.push((cell, cells.weights_at(cell, 2).value, own / 1.5));
            }
        }
        let asked = |i: usize| self.upper[i].min(self.upper[i + 1]).min(self.upper[i + 2]);
        self.cruising = (0..count).map(|i| cells.width(i) / asked(i).sqrt()).sum();
    }

    pub(super) fn bare(upper: Vec<f64>, room: Room, worth: Vec<[bool; 2]>, worth_cap: Vec<bool>) -> Self {
        Self {
            unknowns: upper.len(),
            bounded: (0..upper.len()).filter(|k| upper[*k].is_finite()).collect(),
            upper,
            caps: Forms::default(),
            accelerations: Forms::default(),
            jerks: Forms::default(),
            places: Vec::new(),
            groups: Vec::new(),
            points: Vec::new(),
            cruising: 0.0,
            room,
            worth,
            worth_cap,
        }
    }

    pub(crate) fn lists(&self, value: f64) -> Lists {
        let (accelerations, jerks) = (self.accelerations.count(), self.jerks.count());
        [accelerations, accelerations, jerks, jerks, self.caps.count(), self.unknowns, self.bounded.len()]
            .map(|count| vec![value; count])
    }

    pub(crate) fn flat(&self) -> Newton {
        let n = self.unknowns;
        Newton {
            time: 0.0,
            slope: vec![0.0; n],
            left: vec![0.0; n],
            matrix: Pentadiagonal::zero(n),
            concave: Pentadiagonal::zero(n),
            steep: vec![0.0; self.places.len()],
        }
    }

    /// Maximum common value of all coefficients that satisfies every row.
    pub(crate) fn greatest_constant(&self) -> f64 {
        let upper = self.upper.iter().copied().fold(f64::INFINITY, f64::min);
        let by_acceleration = self.accelerations.greatest_value().max(self.caps.greatest_value());
        upper.min(1.0 / by_acceleration).min(self.jerks.greatest_value().cbrt().powi(-2))
    }

    /// Time along the path, s, by Simpson's rule.
    pub(crate) fn time(&self, c: &[f64]) -> f64 {
        self.points.iter().map(|(first, w, way)| way / dot(w, &three(c, *first)).sqrt()).sum()
    }

    /// Time lost against a profile at the requested speed everywhere, s.
    pub(crate) fn lost(&self, time: f64) -> f64 {
        // Above 0, else the relative gap could never be reached.
        (time - self.cruising).max(MIN_LOST * self.cruising)
    }

    /// Computes the slacks at `c`. Returns false if the squared speed is not positive everywhere.
    pub(crate) fn slacks(&self, c: &[f64], out: &mut Lists) -> bool {
        let [faster, slower, up, down, caps, zero, upper] = out;
        for group in &self.groups {
            let profile = group.profile(c);
            self.caps.left(&group.caps, profile, caps);
            self.accelerations.both(&group.accelerations, profile, 1.0, faster, slower);
            for place in &self.places[group.places.clone()] {
                let b = dot(&place.along, &profile);
                if b.is_nan() || b <= 0.0 {
                    return false;
                }
                self.jerks.both(&place.jerks, profile, 1.0 / b.sqrt(), up, down);
            }
        }
        zero.copy_from_slice(c);
        upper.iter_mut().zip(&self.bounded).for_each(|(g, k)| *g = self.upper[*k] - c[*k]);
        true
    }

    /// Changes of the slacks with `step` at the profile of `newton`.
    pub(crate) fn change(&self, newton: &Newton, step: &[f64], out: &mut Lists) {
        let [faster, slower, up, down, caps, zero, upper] = out;
        for group in &self.groups {
            let profile = group.profile(step);
            self.caps.left(&group.caps, profile, caps);
            caps[group.caps.clone()].iter_mut().for_each(|g| *g -= 1.0);
            self.accelerations.both(&group.accelerations, profile, 0.0, faster, slower);
            for i in group.places.clone() {
                let place = &self.places[i];
                self.jerks.both(&place.jerks, profile, newton.steep[i] * dot(&place.along, &profile), up, down);
            }
        }
        zero.copy_from_slice(step);
        upper.iter_mut().zip(&self.bounded).for_each(|(g, k)| *g = -step[*k]);
    }

    /// Adds the slacks' slopes, weighted with `weight`, to `out`; `steep` is that of [`Newton`].
    pub(crate) fn weighted_slopes(&self, steep: &[f64], weight: &Lists, out: &mut [f64]) {
        for group in &self.groups {
            let by = group.by_coefficients(self.weighted(group, steep, weight));
            (0..3).for_each(|k| out[group.cell + k] += by[k]);
        }
        let [.., zero, upper] = weight;
        out.iter_mut().zip(zero).for_each(|(out, w)| *out += w);
        self.bounded.iter().zip(upper).for_each(|(k, w)| out[*k] -= w);
    }

    /// The slopes of a group's slacks by the squared speed and its derivatives, weighted with `weight`.
    fn weighted(&self, group: &Group, steep: &[f64], weight: &Lists) -> [f64; 3] {
        let [faster, slower, up, down, caps, ..] = weight;
        let mut by = [0.0; 3];
        let mut add = |w: f64, form: [f64; 3]| (0..3).for_each(|k| by[k] += w * form[k]);
        for (i, w) in group.caps.clone().zip(&caps[group.caps.start..]) {
            add(-w, self.caps.at(i));
        }
        for i in group.accelerations.clone() {
            add(slower[i] - faster[i], self.accelerations.at(i));
        }
        let places = self.places[group.places.clone()].iter();
        for (place, steep) in places.zip(&steep[group.places.clone()]) {
            let mut sum = 0.0;
            for i in place.jerks.clone() {
                sum += up[i] + down[i];
                add(down[i] - up[i], self.jerks.at(i));
            }
            add(sum * steep, place.along);
        }
        by
    }

    /// Slopes and curvatures at `c` with multipliers `z` and their quotients `ratio` by the slacks.
    pub(crate) fn newton(&self, c: &[f64], ratio: &Lists, z: &Lists, out: &mut Newton) {
        out.matrix.clear();
        out.concave.clear();
        out.slope.fill(0.0);
        out.time = 0.0;
        for (first, w, way) in &self.points {
            let by = 1.0 / dot(w, &three(c, *first)).sqrt();
            let (time, square) = (way * by, by * by);
            out.time += time;
            (0..3).for_each(|k| out.slope[first + k] -= 0.5 * time * square * w[k]);
            out.matrix.add(*first, 0.75 * time * square * square, w);
        }
        for group in &self.groups {
            let profile = group.profile(c);
            let mut curvature = Curvature { whole: self.squares(group, ratio), concave: Square::default() };
            for p in group.places.clone() {
                out.steep[p] = self.add_jerks(&self.places[p], &profile, ratio, z, &mut curvature);
            }
            group.add(&curvature.whole, &mut out.matrix);
            if !group.places.is_empty() {
                group.add(&curvature.concave, &mut out.concave);
            }
        }
        let [.., zero, upper] = ratio;
        let diagonal = &mut out.matrix.diagonals[0];
        diagonal.iter_mut().zip(zero).for_each(|(d, r)| *d += r);
        self.bounded.iter().zip(upper).for_each(|(k, r)| diagonal[*k] += r);
        out.left.iter_mut().zip(&out.slope).for_each(|(left, slope)| *left = -slope);
        self.weighted_slopes(&out.steep, z, &mut out.left);
    }

    /// The squares of the slopes of a group's caps and accelerations, weighted with `ratio`.
    fn squares(&self, group: &Group, ratio: &Lists) -> Square {
        let [faster, slower, _, _, caps, ..] = ratio;
        let mut m = Square::default();
        for (i, w) in group.caps.clone().zip(&caps[group.caps.start..]) {
            m.add_own(*w, &self.caps.at(i));
        }
        for i in group.accelerations.clone() {
            m.add_own(faster[i] + slower[i], &self.accelerations.at(i));
        }
        m
    }

    /// Adds the squares of the slopes of a point's jerks, and the curvature of `1 / sqrt(b)`. Returns the slope of
    /// `1 / sqrt(b)` by `b` there.
    fn add_jerks(&self, place: &Place, profile: &[f64; 3], ratio: &Lists, z: &Lists, curvature: &mut Curvature) -> f64 {
        let Place { along, jerks } = place;
        let ([_, _, up, down, ..], [_, _, up_z, down_z, ..]) = (ratio, z);
        let Curvature { whole, concave } = curvature;
        let b = dot(along, profile);
        let cube = 1.0 / (b * b.sqrt());
        let steep = -0.5 * cube;
        let (mut sum, mut multipliers, mut uneven) = (0.0, 0.0, [0.0; 3]);
        for i in jerks.clone() {
            let form = self.jerks.at(i);
            let both = up[i] + down[i];
            sum += both;
            multipliers += up_z[i] + down_z[i];
            (0..3).for_each(|k| uneven[k] += (down[i] - up[i]) * form[k]);
            whole.add_own(both, &form);
        }
        // (steep along - form)(..)^T and (steep along + form)(..)^T.
        whole.add_own(sum * steep * steep, along);
        whole.add(2.0 * steep, along, &uneven);
        concave.add_own(0.75 * multipliers * cube / b, along);
        steep
    }
}
