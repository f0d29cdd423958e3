use super::point_pairs::spread;
use crate::error::Error;
use glam::{DAffine3, DMat3, DVec3};

/// A frame from touches of three faces.
#[derive(Debug, Clone, PartialEq)]
pub struct DatumFit {
    /// Maps the part's frame to the measuring frame.
    pub transform: DAffine3,
    /// Distances of the plane's touches from the fitted plane, mm: positive outside.
    pub plane: Vec<f64>,
    /// Distances of the line's touches from the fitted line across it in the plane, mm: positive outside.
    pub line: Vec<f64>,
    /// Distances of the point's touches from their mean along x, mm: positive outside.
    pub point: Vec<f64>,
}

/// The part's frame from touches (the centre of a ball of `radius` mm, or points with 0) of three faces: `plane` in its
/// plane z = 0, `line` along its x axis (y = 0) and `point` at its origin (x = 0). The plane fixes z and two tilts, the
/// line the turn about z and y, the point x. The part lies at z < 0, y > 0 and x > 0 of these faces. z and x point as in
/// the `nominal` placement.
///
/// # Errors
/// [`Error::TooFewPoints`] with fewer than 3, 2 and 1 touches; [`Error::OneLine`] if those of the plane lie on a
/// line, [`Error::OnePosition`] if those of the line are at one position.
pub fn plane_line_point(
    plane: &[DVec3],
    line: &[DVec3],
    point: &[DVec3],
    radius: f64,
    nominal: &DAffine3,
) -> Result<DatumFit, Error> {
    for (what, given, least) in
        [("geometry-points-plane", plane, 3), ("geometry-points-line", line, 2), ("geometry-points-point", point, 1)]
    {
        if given.len() < least {
            return Err(Error::TooFewPoints { what, given: given.len(), min: least });
        }
    }
    let (directions, middle) = spread(plane, "geometry-points-plane", 1)?;
    let along = |v: DVec3, like: DVec3| if v.dot(like) < 0.0 { -v } else { v };
    let z = along(directions.z_axis, nominal.matrix3.z_axis);
    let flat: Vec<DVec3> = line.iter().map(|p| *p - (*p - middle).dot(z) * z).collect();
    let (directions, on_line) = spread(&flat, "geometry-points-line", 0)?;
    let x = along(directions.x_axis, nominal.matrix3.x_axis);
    let x = (x - x.dot(z) * z).normalize();
    let y = z.cross(x);
    // The ball's centre lies outside each face, at positive z, negative y and negative x.
    let mean = point.iter().map(|p| p.dot(x)).sum::<f64>() / point.len() as f64;
    let origin = (mean + radius) * x + (on_line.dot(y) + radius) * y + (middle.dot(z) - radius) * z;
    Ok(DatumFit {
        transform: DAffine3::from_mat3_translation(DMat3::from_cols(x, y, z), origin),
        plane: plane.iter().map(|p| (*p - middle).dot(z)).collect(),
        line: line.iter().map(|p| (on_line - *p).dot(y)).collect(),
        point: point.iter().map(|p| mean - p.dot(x)).collect(),
    })
}
