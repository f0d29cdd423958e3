use thiserror::Error;

/// Error in the construction of a geometric object. Angles are in rad, lengths in mm.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// A size must be finite and greater than zero.
    #[error("{what} must be a finite number greater than 0, not {value}")]
    Size {
        /// Name of the size.
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// A size must lie between two others.
    #[error("{what} must be more than {least} and less than {most} mm, not {value}")]
    Range {
        /// Name of the size.
        what: &'static str,
        /// The value given, mm.
        value: f64,
        /// It must be more than this, mm.
        least: f64,
        /// It must be less than this, mm.
        most: f64,
    },
    /// A direction has no length or is not finite.
    #[error("{what} must be a finite vector with a length greater than 0")]
    Direction {
        /// Name of the direction.
        what: &'static str,
    },
    /// Two directions that span a plane are parallel.
    #[error("{first} and {second} are parallel")]
    Parallel {
        /// First direction.
        first: &'static str,
        /// Second direction.
        second: &'static str,
    },
    /// Every line of the tube's wall misses the body although its axis meets it.
    #[error("the tube is larger than the body: its wall misses the body at every angle")]
    TubeLargerThanBody,
    /// The tube passes beside the body.
    #[error("the tube passes beside the body and does not meet it")]
    TubeBesideBody,
    /// Part of the tube's wall misses the body: the curve is not closed.
    #[error(
        "the tube's wall misses the body between phi = {:.3} and {:.3} degrees: the curve does not close",
        from.to_degrees(),
        to.to_degrees()
    )]
    NotClosed {
        /// Start of the angle range that misses, rad.
        from: f64,
        /// End of the angle range that misses, rad, greater than `from`.
        to: f64,
    },
    /// Part of the tube's wall leaves a head over the end of its flange.
    #[error(
        "the tube's wall is beyond the end of the head's flange between phi = {:.3} and {:.3} degrees",
        from.to_degrees(),
        to.to_degrees()
    )]
    BeyondHead {
        /// Start of the angle range beyond the end, rad.
        from: f64,
        /// End of the angle range, rad, greater than `from`.
        to: f64,
    },
    /// The wall touches the body tangentially: the curve has a corner there.
    #[error(
        "the tube's wall is tangent to the body at phi = {:.3} degrees: the curve has no tangent there",
        at.to_degrees()
    )]
    Tangent {
        /// Angle about the tube's axis, rad.
        at: f64,
    },
    /// The tube's wall passes beside a body that trims it, above the body that it stands on: the curve would jump.
    #[error("the tube's wall begins to pass beside the one that trims it at phi = {:.3} degrees", at.to_degrees())]
    Beside {
        /// Angle about the tube's axis, rad.
        at: f64,
    },
    /// The tube's direction points into the body and never leaves it.
    #[error("the tube's direction points into the body: it never leaves it along +direction")]
    NeverLeaves,
    /// The length of a curve cannot be measured to the requested accuracy.
    #[error("the curve's length cannot be found to {accuracy_mm} mm near parameter {at}")]
    ArcLength {
        /// Requested accuracy, mm.
        accuracy_mm: f64,
        /// Parameter where subdivision stopped.
        at: f64,
    },
    /// Fewer points than a fit needs.
    #[error("too few points of {what}: {given}, and at least {least} are needed")]
    TooFewPoints {
        /// Name of the set of points.
        what: &'static str,
        /// Number of points given.
        given: usize,
        /// Number needed.
        least: usize,
    },
    /// Points too close to one position or one line to define the result.
    #[error("the points of {what} lie nearly {on}: they do not define it")]
    Gathered {
        /// Name of the set of points.
        what: &'static str,
        /// The position or line on which they lie.
        on: &'static str,
    },
    /// Attitudes too similar to determine the touched point.
    #[error(
        "the attitudes are {:.1} degrees apart at most: they do not tell where the tip is",
        apart.to_degrees()
    )]
    Alike {
        /// Largest angle between two of them, rad.
        apart: f64,
    },
    /// A search for a rigid motion did not converge.
    #[error("no place was found at which the part fits the points")]
    NoFit,
    /// A point that is not finite or too large.
    #[error("point {index} has a value that is not finite or too large")]
    Place {
        /// Its index.
        index: usize,
    },
    /// A piece of a chain does not start at the end of the one before.
    #[error("piece {piece} of the chain does not begin where the one before it ends")]
    Gap {
        /// Index of the piece, counted from 0.
        piece: usize,
    },
    /// A direction turns too sharply between neighbouring points.
    #[error("{what} turns by 90 degrees or more from one point to the next")]
    Turn {
        /// Name of the direction.
        what: &'static str,
    },
    /// Knots of a spline must increase strictly.
    #[error("the positions of a spline's values must increase strictly (value {index})")]
    Knots {
        /// First index that does not increase.
        index: usize,
    },
}

/// Rejects sizes that are not finite and positive.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::Size { what, value }) }
}

/// Unit vector along `v`.
pub(crate) fn unit(what: &'static str, v: glam::DVec3) -> Result<glam::DVec3, Error> {
    v.try_normalize().filter(|u| u.is_finite()).ok_or(Error::Direction { what })
}
