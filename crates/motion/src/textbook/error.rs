use thiserror::Error;

/// Error of an invalid interpolation request, found before any computation.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum Error {
    /// A size, speed, period or pulse must be finite and greater than zero.
    #[error("{what} must be a finite number greater than 0, not {value}")]
    NotPositive {
        /// Name of the value.
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// A coordinate or an angle is not finite.
    #[error("{what} must be a finite number, not {value}")]
    NotFinite {
        /// Name of the value.
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// A start or end point does not lie on the ellipse.
    #[error(
        "the {which} point ({x_mm}, {y_mm}) lies {distance_mm} mm off the ellipse; at most {tolerance_mm} mm is \
         accepted, the nearest point on it is ({near_x_mm}, {near_y_mm})"
    )]
    OffEllipse {
        /// "start" or "end".
        which: &'static str,
        /// Given x, mm.
        x_mm: f64,
        /// Given y, mm.
        y_mm: f64,
        /// Distance from the ellipse, mm.
        distance_mm: f64,
        /// Maximum accepted distance, mm.
        tolerance_mm: f64,
        /// x of the nearest point on the ellipse, mm.
        near_x_mm: f64,
        /// y of the nearest point on the ellipse, mm.
        near_y_mm: f64,
    },
    /// The nozzle does not fit the shell: the seam is not one closed curve around the nozzle.
    #[error("the nozzle radius {nozzle_mm} mm must be smaller than the shell radius {shell_mm} mm")]
    NozzleTooLarge {
        /// Nozzle radius, mm.
        nozzle_mm: f64,
        /// Shell radius, mm.
        shell_mm: f64,
    },
    /// The sweep is zero or has too many turns.
    #[error("the sweep must be other than 0 and at most {limit_rad} rad either way, not {sweep_rad}")]
    Sweep {
        /// Sweep given, rad.
        sweep_rad: f64,
        /// Maximum absolute sweep, rad.
        limit_rad: f64,
    },
    /// The step is not small against the path.
    #[error(
        "a step of {step_mm} mm (speed times period) is too long for this path: at most {limit_mm} mm (the path's \
         length, or an eighth of a full turn's)"
    )]
    StepTooLong {
        /// Speed times period, mm.
        step_mm: f64,
        /// Maximum accepted step, mm.
        limit_mm: f64,
    },
    /// The pulse is not small against the shape.
    #[error("a pulse of {pulse_mm} mm is too large for this shape: at most {limit_mm} mm")]
    PulseTooLarge {
        /// Pulse equivalent, mm.
        pulse_mm: f64,
        /// Maximum accepted pulse, mm.
        limit_mm: f64,
    },
    /// The number of steps or pulses exceeds the limit.
    #[error("this needs about {steps:.3e} steps or pulses; the limit is {limit:.0e}")]
    TooManySteps {
        /// Estimate of the number of steps.
        steps: f64,
        /// The limit.
        limit: f64,
    },
    /// The curve itself cannot be constructed or measured.
    #[error(transparent)]
    Geometry(#[from] seamwright_geometry::Error),
}

/// Checks that a value is finite and greater than zero.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::NotPositive { what, value }) }
}

/// Checks that a value is finite.
pub(super) fn finite(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, value }) }
}
