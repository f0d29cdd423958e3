use super::twist::{Deviation, Seen, Twists};
use crate::error::Error;
use glam::{DAffine3, DMat3, DVec3};
use nalgebra::{DMatrix, Matrix3};

/// A rigid motion from points with nominal positions.
#[derive(Debug, Clone, PartialEq)]
pub struct PairFit {
    /// Maps nominal to measured points.
    pub transform: DAffine3,
    /// Measured less mapped nominal point, mm.
    pub residuals: Vec<DVec3>,
    /// With three points: by how much the measured triangle's sides from point 1 to 2, 2 to 3 and 3 to 1 are longer
    /// than the nominal ones, mm.
    pub sides: Option<[f64; 3]>,
    /// Standard deviations; none with three points, which leave no redundancy.
    pub deviation: Option<Deviation>,
}

/// Points whose spread across their line is smaller than this part of their spread along it define no frame.
const FLAT: f64 = 1e-3;

/// The rigid motion that maps the nominal (first) to the measured (second) points of `pairs`, mm.
///
/// Three pairs: frame to frame, exact in point 1, in the direction from 1 to 2 and in the plane of the three. More:
/// least squares of the distances (Kabsch 1976, by singular value decomposition, never a reflection).
///
/// # Errors
/// [`Error::TooFewPoints`]; [`Error::OneLine`] if either set lies nearly on one line; [`Error::NoFit`] if
/// a point is not finite.
pub fn fit_pairs(pairs: &[(DVec3, DVec3)]) -> Result<PairFit, Error> {
    if pairs.len() < 3 {
        return Err(Error::TooFewPoints { what: "geometry-points-frame", given: pairs.len(), min: 3 });
    }
    let (nominal, measured): (Vec<DVec3>, Vec<DVec3>) = pairs.iter().copied().unzip();
    spread(&nominal, "geometry-points-nominal-frame", 1)?;
    spread(&measured, "geometry-points-measured-frame", 1)?;
    let transform = match pairs {
        [_, _, _] => frame(&measured) * frame(&nominal).inverse(),
        _ => least_squares(&nominal, &measured),
    };
    let residuals: Vec<DVec3> = pairs.iter().map(|(n, m)| *m - transform.transform_point3(*n)).collect();
    let side = |p: &[DVec3], i: usize| (p[(i + 1) % 3] - p[i]).length();
    let sides = (pairs.len() == 3).then(|| std::array::from_fn(|i| side(&measured, i) - side(&nominal, i)));
    let deviation = if sides.is_some() { None } else { deviation(&measured, &residuals) };
    Ok(PairFit { transform, residuals, sides, deviation })
}

/// Checks that `points` of `what` spread in more than `dimensions` directions: 0 for more than a position, 1 for more
/// than a line. Returns their principal directions, widest first, as columns, and their mean.
pub(crate) fn spread(points: &[DVec3], what: &'static str, dimensions: usize) -> Result<(DMat3, DVec3), Error> {
    // The decomposition of a matrix that is not finite would not terminate.
    if !points.iter().all(|p| p.is_finite()) {
        return Err(Error::NoFit);
    }
    let middle = points.iter().sum::<DVec3>() / points.len() as f64;
    let matrix = DMatrix::from_fn(points.len().max(3), 3, |i, j| points.get(i).map_or(0.0, |p| (*p - middle)[j]));
    let svd = matrix.svd(false, true);
    let widths = [svd.singular_values[0], svd.singular_values[1]];
    let (width, min, error) = match dimensions {
        0 => (widths[0], FLAT, Error::OnePosition { what }),
        _ => (widths[1], FLAT * widths[0].max(FLAT), Error::OneLine { what }),
    };
    let (Some(vt), true) = (&svd.v_t, width > min) else { return Err(error) };
    let direction = |i: usize| DVec3::new(vt[(i, 0)], vt[(i, 1)], vt[(i, 2)]);
    Ok((DMat3::from_cols(direction(0), direction(1), direction(2)), middle))
}

/// Origin in point 1, x towards point 2, point 3 in the half plane of positive y.
fn frame(p: &[DVec3]) -> DAffine3 {
    let x = (p[1] - p[0]).normalize();
    let z = x.cross(p[2] - p[0]).normalize();
    DAffine3::from_mat3_translation(DMat3::from_cols(x, z.cross(x), z), p[0])
}

fn least_squares(nominal: &[DVec3], measured: &[DVec3]) -> DAffine3 {
    let middle = |p: &[DVec3]| p.iter().sum::<DVec3>() / p.len() as f64;
    let (from, to) = (middle(nominal), middle(measured));
    let mut h = Matrix3::zeros();
    for (n, m) in nominal.iter().zip(measured) {
        let (n, m) = ((*n - from).to_array(), (*m - to).to_array());
        h += Matrix3::from_fn(|i, j| m[i] * n[j]);
    }
    let svd = h.svd_unordered(true, true);
    let (Some(u), Some(vt)) = (svd.u, svd.v_t) else { return DAffine3::from_translation(to - from) };
    let mut sign = Matrix3::identity();
    if (u * vt).determinant() < 0.0 {
        let weakest = svd.singular_values.imin();
        sign[(weakest, weakest)] = -1.0;
    }
    let turn = u * sign * vt;
    let turn = DMat3::from_cols_slice(turn.as_slice());
    DAffine3::from_mat3_translation(turn, to - turn * from)
}

fn deviation(measured: &[DVec3], residuals: &[DVec3]) -> Option<Deviation> {
    let twists = Twists::about(measured.iter().copied());
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let rows: Vec<[f64; 6]> = measured.iter().flat_map(|p| axes.map(|e| twists.row(*p, -e))).collect();
    let flat: Vec<f64> = residuals.iter().flat_map(DVec3::to_array).collect();
    Seen::new(&rows).deviation(&twists, &flat)
}
