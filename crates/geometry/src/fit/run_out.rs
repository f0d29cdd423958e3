use super::best_fit::{Touch, best_fit};
use super::free_motion::Motion;
use crate::error::Error;
use crate::tube::Tube;
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// Run-out of a tube that turns about its nominal axis.
#[derive(Debug, Clone, PartialEq)]
pub struct RunOut {
    /// Maps the nominal pose of the part to the true one: the smallest motion that aligns the tube's axis.
    pub correction: DAffine3,
    /// From the nominal axis to the true one at the requested position, across the nominal axis, mm.
    pub eccentricity: DVec3,
    /// Angle between the two axes, rad.
    pub tilt: f64,
    /// Unit vector across the nominal axis to which the true one leans; zero without a tilt.
    pub leans_to: DVec3,
    /// True less nominal radius, mm; none if the points do not determine it.
    pub growth: Option<f64>,
    /// Out of round: distance of each point from the fitted tube, mm.
    pub residuals: Vec<f64>,
    /// Motions that the points do not determine, beyond moves along the axis and turns about it.
    pub free: Vec<Motion>,
}

/// The run-out of a tube touched at `points` (the centre of a ball of `radius` mm, or points with 0), in the frame that
/// turns with the work; `tube` is the nominal one in that frame, and `at` (mm) the point on its axis at which the
/// eccentricity is computed.
///
/// # Errors
/// [`Error::TooFewPoints`] with fewer than three points, [`Error::NoFit`].
pub fn run_out(points: &[DVec3], radius: f64, tube: &Tube, at: DVec3) -> Result<RunOut, Error> {
    if points.len() < 3 {
        return Err(Error::TooFewPoints { what: "geometry-points-tube", given: points.len(), min: 3 });
    }
    // In the tube's own frame, so that free motions refer to its own directions.
    let frame = DAffine3::from_mat3_translation(DMat3::from_cols(tube.e1, tube.e2, tube.e3), tube.origin);
    let back = frame.inverse();
    let own = Tube { origin: DVec3::ZERO, e1: DVec3::X, e2: DVec3::Y, e3: DVec3::Z, radius: tube.radius };
    let touch = |p: &DVec3| Touch { point: back.transform_point3(*p), surface: &own, outside: radius };
    let fit = best_fit(&points.iter().map(touch).collect::<Vec<_>>(), &DAffine3::IDENTITY, true)?;
    let e = tube.e3;
    let point = frame.transform_point3(fit.transform.translation);
    let direction = frame.transform_vector3(fit.transform.matrix3.z_axis);
    // Intersection of the true axis with the plane across the nominal one.
    let cross = point + (at - point).dot(e) / direction.dot(e) * direction;
    let arc = DQuat::from_rotation_arc(e, direction.normalize());
    let leans = direction - direction.dot(e) * e;
    Ok(RunOut {
        correction: DAffine3::from_translation(cross) * DAffine3::from_quat(arc) * DAffine3::from_translation(-at),
        eccentricity: cross - at,
        tilt: leans.length().atan2(direction.dot(e)),
        leans_to: leans.try_normalize().unwrap_or(DVec3::ZERO),
        growth: fit.growth,
        free: fit.free.into_iter().map(|m| m.mapped(&frame)).filter(|m| !along_axis(m, direction)).collect(),
        residuals: fit.residuals,
    })
}

/// True for motions that leave the axis where it is.
fn along_axis(motion: &Motion, axis: DVec3) -> bool {
    let (Motion::Along(direction) | Motion::About { direction, .. }) = motion;
    direction.cross(axis).length() < 1e-2
}
