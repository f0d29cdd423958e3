//! Robust least squares of the surface to the points.

use super::surface::{AT_Y, AT_Z, Fixed, GAP, Piece, Segment, Surface, TURN, Unknowns};
use glam::DVec2;
use nalgebra::{DMatrix, DVector};

/// Steps with Tukey's weights for a comparison and for a result, then with the points within the limit.
const ROUGH_STEPS: usize = 8;
const ROBUST_STEPS: usize = 16;
const PLAIN_STEPS: usize = 3;
/// Tukey's limit in standard deviations: 95 % efficiency for normal errors.
const TUKEY: f64 = 4.685;
/// Points farther off, in standard deviations, are left out at last.
const OUTLIER: f64 = 4.0;
/// Maximum scatter of an edge as a multiple of that of all points: on a slope the noise of a stripe is larger.
const EDGE_SCATTER: f64 = 2.0;
/// Standard deviation of a normal distribution over its median deviation.
const NORMAL: f64 = 1.4826;
/// Minimum standard deviation, mm: rounding of the sizes.
const ROUNDING_MM: f64 = 1e-6;
/// Step of the derivatives, mm and rad.
const DELTA: f64 = 1e-5;
/// Minimum cosine of a piece's slope to the sensor: steeper ones are seen edge-on.
const MIN_COSINE: f64 = 0.12;
/// Points nearer to an end of the metal are not fitted, mm: a bead meets the wall in a curve.
const TOE_MM: f64 = 1.0;
/// Maximum changes in a step, mm and rad.
const MAX_STEP: [f64; 10] = [2.0, 2.0, 0.1, 0.1, 1.0, 1.0, 0.1, 1.5, 0.2, 0.05];
/// Points farther off count as this far in the comparison of fits, mm.
const FAR_MM: f64 = 1.0;
/// Minimum number of points on each face, and on edges and metal together.
const FEWEST_SEEN: usize = 6;
/// Part of the points on the groove, and their scatter (mm), of a fit that needs no search.
const GOOD: (f64, f64) = (0.75, 0.25);

/// The best unknowns for a profile.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    pub(super) unknowns: Unknowns,
    /// Part of the points on the groove.
    pub(super) share: f64,
    /// Standard deviation of the points, mm, without those on metal.
    pub(super) scatter: f64,
    free: Vec<usize>,
    covariance: DMatrix<f64>,
}

/// Groups of pieces: faces, edge of the second part, edge of the first part, metal. An edge has few points, so that its
/// scatter is estimated alone until it is fitted.
const GROUPS: usize = 4;
const METAL: usize = 3;

/// A point against its piece of the surface.
#[derive(Debug, Clone, Copy)]
struct Residual {
    at: DVec2,
    piece: Piece,
    /// Height over the piece along the sensor's z, mm.
    off: f64,
    /// Cosine of the piece's slope to the sensor: distance from the piece over height.
    cosine: f64,
    /// False near an end of the metal.
    fitted: bool,
}

impl Residual {
    fn group(&self) -> usize {
        match self.piece {
            Piece::SecondFace | Piece::FirstFace => 0,
            Piece::SecondEdge(_) => 1,
            Piece::FirstEdge(_) => 2,
            Piece::Metal(_) => METAL,
        }
    }
}

/// The point of a profile in the section's frame.
pub(super) fn to_section(u: &Unknowns, p: DVec2) -> DVec2 {
    DVec2::from_angle(u[TURN]).rotate(p - DVec2::new(u[AT_Y], u[AT_Z]))
}

/// Height of `q` over a segment along the sensor's z, and the cosine of the segment's slope.
fn off(s: &Segment, q: DVec2, y_axis: DVec2) -> (f64, f64) {
    let along = (s.to - s.from).normalize_or_zero();
    let cosine = along.dot(y_axis).max(MIN_COSINE);
    (along.perp_dot(q - s.from) / cosine, cosine)
}

fn residuals(surface: &Surface, u: &Unknowns, points: &[DVec2]) -> Vec<Residual> {
    let y_axis = DVec2::from_angle(u[TURN]);
    let seen = |s: &&Segment| {
        let line = s.to - s.from;
        line.dot(y_axis) > MIN_COSINE * line.length() && line.length() > 1e-9
    };
    let seen: Vec<&Segment> = surface.segments.iter().filter(seen).collect();
    let distance = |s: &Segment, q: DVec2| {
        let line = s.to - s.from;
        let t = ((q - s.from).dot(line) / line.length_squared()).clamp(0.0, 1.0);
        (s.from + t * line).distance_squared(q)
    };
    let one = |p: &DVec2| {
        let q = to_section(u, *p);
        let nearest = seen.iter().min_by(|a, b| distance(a, q).total_cmp(&distance(b, q)))?;
        let fitted = surface.ends.is_none_or(|ends| ends.iter().all(|end| end.distance(q) > TOE_MM));
        let (off, cosine) = off(nearest, q, y_axis);
        Some(Residual { at: *p, piece: nearest.piece, off, cosine, fitted })
    };
    points.iter().filter_map(one).collect()
}

/// Robust standard deviation of a quantity.
fn robust(of: impl Iterator<Item = f64>) -> f64 {
    let mut sizes: Vec<f64> = of.map(f64::abs).collect();
    let middle = sizes.len() / 2;
    if sizes.is_empty() { 0.0 } else { NORMAL * *sizes.select_nth_unstable_by(middle, f64::total_cmp).1 }
}

/// Robust standard deviation of a quantity of the residuals of each group.
fn scatters(all: &[Residual], of: fn(&Residual) -> f64) -> [f64; GROUPS] {
    std::array::from_fn(|group| robust(all.iter().filter(|r| r.group() == group && r.fitted).map(of)))
}

/// Normal equations.
struct Normal {
    matrix: DMatrix<f64>,
    gradient: DVector<f64>,
}

impl Fit {
    /// The fit that starts at `start`; `None` if it leaves the possible grooves.
    pub(super) fn new(fixed: &Fixed, points: &[DVec2], start: Unknowns) -> Option<Self> {
        let u = robust_fit(fixed, points, start, ROBUST_STEPS)?;
        let first = residuals(&fixed.surface(&u)?, &u, points);
        let near = Inside::new(&first);
        let kept: Vec<DVec2> = first.iter().filter(|r| near.has(r)).map(|r| r.at).collect();
        let Plain { unknowns, normal, all, scatter } = plain_fit(fixed, &kept, u, &near)?;
        let count = |seen: fn(Piece) -> bool| all.iter().filter(|r| r.fitted && seen(r.piece)).count();
        let faces = count(|p| p == Piece::SecondFace).min(count(|p| p == Piece::FirstFace));
        if faces.min(count(|p| !matches!(p, Piece::SecondFace | Piece::FirstFace))) < FEWEST_SEEN {
            return None;
        }
        let covariance = normal.matrix.try_inverse()? * correlation(&all);
        Some(Self {
            unknowns,
            share: kept.len() as f64 / points.len() as f64,
            scatter: scatter[0],
            free: fixed.free.clone(),
            covariance,
        })
    }

    /// True if the fit needs no other start.
    pub(super) fn is_good(&self) -> bool {
        self.share > GOOD.0 && self.scatter < GOOD.1
    }

    /// Standard uncertainty of a function of the unknowns, to first order.
    pub(super) fn uncertainty(&self, of: impl Fn(&Unknowns) -> Option<f64>) -> Option<f64> {
        let here = of(&self.unknowns)?;
        let slope = |i: &usize| {
            let mut near = self.unknowns;
            near[*i] += DELTA;
            of(&near).map(|value| (value - here) / DELTA)
        };
        let slopes = DVector::from_vec(self.free.iter().map(slope).collect::<Option<Vec<f64>>>()?);
        Some((slopes.transpose() * &self.covariance * &slopes)[0].max(0.0).sqrt())
    }
}

/// The unknowns after a few steps, and the mean distance of the points, far ones limited, mm.
pub(super) fn rough_fit(fixed: &Fixed, points: &[DVec2], start: Unknowns) -> Option<(f64, Unknowns)> {
    let u = robust_fit(fixed, points, start, ROUGH_STEPS)?;
    let all = residuals(&fixed.surface(&u)?, &u, points);
    Some((all.iter().map(|r| r.off.abs().min(FAR_MM)).sum::<f64>() / points.len() as f64, u))
}

/// The unknowns after steps with Tukey's weights.
fn robust_fit(fixed: &Fixed, points: &[DVec2], start: Unknowns, steps: usize) -> Option<Unknowns> {
    let mut u = start;
    for k in 0..steps {
        let all = residuals(&fixed.surface(&u)?, &u, points);
        let least = (0.6_f64).powi(k as i32).max(ROUNDING_MM);
        // Distances from the pieces: on a steep edge heights are far larger until it is found.
        let distance = |r: &Residual| r.off * r.cosine;
        let scales = scatters(&all, distance).map(|s| s.max(least));
        let weight = |r: &Residual| {
            let part = distance(r) / (TUKEY * scales[r.group()]);
            let tukey = (1.0 - part * part).max(0.0).powi(2);
            if r.fitted { tukey * (r.cosine / scales[r.group()]).powi(2) } else { 0.0 }
        };
        u = step(fixed, &u, &normal(fixed, &u, &all, weight)?)?;
    }
    Some(u)
}

/// Limits of the heights by group, mm.
struct Inside([f64; GROUPS]);

impl Inside {
    /// Limits from the residuals of the robust fit.
    fn new(all: &[Residual]) -> Self {
        let usual = robust(all.iter().filter(|r| r.group() != METAL).map(|r| r.off));
        let mut scales = scatters(all, |r| r.off);
        // An edge that scatters much more than the rest is not this edge.
        scales[..METAL].iter_mut().for_each(|s| *s = s.min(EDGE_SCATTER * usual));
        Self(scales.map(|s| OUTLIER * s.max(4.0 * ROUNDING_MM)))
    }

    fn has(&self, r: &Residual) -> bool {
        r.off.abs() <= self.0[r.group()]
    }
}

/// Result of plain least squares.
struct Plain {
    unknowns: Unknowns,
    normal: Normal,
    all: Vec<Residual>,
    scatter: [f64; 2],
}

/// Least squares of the heights of the points near the surface.
fn plain_fit(fixed: &Fixed, points: &[DVec2], start: Unknowns, near: &Inside) -> Option<Plain> {
    let mut unknowns = start;
    let mut last = None;
    for _ in 0..PLAIN_STEPS {
        let mut all = residuals(&fixed.surface(&unknowns)?, &unknowns, points);
        all.iter_mut().for_each(|r| r.fitted &= near.has(r));
        let scatter = plain_scatters(&all, fixed.free.len());
        let weight = |r: &Residual| if r.fitted { scatter[usize::from(r.group() == METAL)].powi(-2) } else { 0.0 };
        let normal = normal(fixed, &unknowns, &all, weight)?;
        unknowns = step(fixed, &unknowns, &normal)?;
        last = Some(Plain { unknowns, normal, all, scatter });
    }
    last
}

/// Standard deviations of the residuals on the parts and on metal, with the degrees of freedom of all unknowns.
fn plain_scatters(all: &[Residual], unknowns: usize) -> [f64; 2] {
    let fitted = all.iter().filter(|r| r.fitted).count() as f64;
    [false, true].map(|metal| {
        let of = || all.iter().filter(|r| (r.group() == METAL) == metal && r.fitted);
        let count = of().count() as f64;
        // Both take their part of the unknowns.
        let free = (count * (1.0 - unknowns as f64 / fitted)).max(1.0);
        (of().map(|r| r.off * r.off).sum::<f64>() / free).sqrt().max(ROUNDING_MM)
    })
}

/// Number of points over which residuals are correlated: the sum of their autocorrelation up to the first value that is
/// not significant. 1 for independent points.
fn correlation(all: &[Residual]) -> f64 {
    let off: Vec<f64> = all.iter().filter(|r| r.group() != METAL && r.fitted).map(|r| r.off).collect();
    let square: f64 = off.iter().map(|o| o * o).sum();
    if off.len() < 2 || square <= 0.0 {
        return 1.0;
    }
    let significant = 2.5 / (off.len() as f64).sqrt();
    let at = |lag: usize| off.iter().zip(&off[lag..]).map(|(a, b)| a * b).sum::<f64>() / square;
    1.0 + 2.0 * (1..off.len() / 4).map(at).take_while(|rho| *rho > significant).sum::<f64>()
}

/// Normal equations with the points' weights and the drawn sizes.
fn normal(fixed: &Fixed, u: &Unknowns, all: &[Residual], weight: impl Fn(&Residual) -> f64) -> Option<Normal> {
    let n = fixed.free.len();
    let mut rows = vec![[0.0; 10]; all.len()];
    for (j, &unknown) in fixed.free.iter().enumerate() {
        let mut near = *u;
        near[unknown] += DELTA;
        let surface = fixed.surface(&near)?;
        let y_axis = DVec2::from_angle(near[TURN]);
        for (row, r) in rows.iter_mut().zip(all) {
            // A piece that vanishes with the change has no derivative.
            let Some(s) = surface.segments.iter().find(|s| s.piece == r.piece) else { continue };
            row[j] = (off(s, to_section(&near, r.at), y_axis).0 - r.off) / DELTA;
        }
    }
    let (mut matrix, mut gradient) = (DMatrix::zeros(n, n), DVector::zeros(n));
    for (row, r) in rows.iter().zip(all) {
        let w = weight(r);
        if w <= 0.0 {
            continue;
        }
        for i in 0..n {
            gradient[i] += w * row[i] * r.off;
            for k in 0..=i {
                matrix[(i, k)] += w * row[i] * row[k];
            }
        }
    }
    for (i, &unknown) in fixed.free.iter().enumerate() {
        if let Some((drawn, tolerance)) = fixed.drawn_value(unknown) {
            matrix[(i, i)] += tolerance.powi(-2);
            gradient[i] += (u[unknown] - drawn) * tolerance.powi(-2);
        }
        for k in 0..i {
            matrix[(k, i)] = matrix[(i, k)];
        }
    }
    Some(Normal { matrix, gradient })
}

/// The unknowns after a step of Newton's method, shortened until there is a groove.
fn step(fixed: &Fixed, u: &Unknowns, normal: &Normal) -> Option<Unknowns> {
    let change = normal.matrix.clone().cholesky()?.solve(&normal.gradient);
    let mut part = 1.0;
    for _ in 0..6 {
        let mut next = *u;
        for (i, &unknown) in fixed.free.iter().enumerate() {
            next[unknown] -= part * change[i].clamp(-MAX_STEP[unknown], MAX_STEP[unknown]);
        }
        next[GAP] = next[GAP].max(0.0);
        if fixed.surface(&next).is_some() {
            return Some(next);
        }
        part *= 0.5;
    }
    None
}
