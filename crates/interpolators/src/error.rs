use seamwright_message::{Message, Unit};

/// Error of an invalid interpolation request, found before any computation.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// A size, speed, period or pulse must be finite and greater than zero.
    NotPositive {
        /// The value.
        what: RequestValue,
        /// Its value.
        value: f64,
    },
    /// A coordinate or an angle is not finite.
    NotFinite {
        /// The value.
        what: RequestValue,
        /// Its value.
        value: f64,
    },
    /// A start or end point does not lie on the ellipse.
    OffEllipse {
        /// The point.
        which: EndPoint,
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
    NozzleTooLarge {
        /// Nozzle radius, mm.
        nozzle_mm: f64,
        /// Shell radius, mm.
        shell_mm: f64,
    },
    /// The sweep is zero or has too many turns.
    Sweep {
        /// Sweep given, rad.
        sweep_rad: f64,
        /// Maximum absolute sweep, rad.
        limit_rad: f64,
    },
    /// The step is not small against the path.
    StepTooLong {
        /// Speed times period, mm.
        step_mm: f64,
        /// Maximum accepted step, mm.
        limit_mm: f64,
    },
    /// The pulse is not small against the shape.
    PulseTooLarge {
        /// Pulse equivalent, mm.
        pulse_mm: f64,
        /// Maximum accepted pulse, mm.
        limit_mm: f64,
    },
    /// The number of steps or pulses exceeds the limit.
    TooManySteps {
        /// Estimate of the number of steps.
        steps: f64,
        /// The limit.
        limit: f64,
    },
    /// The curve itself cannot be constructed or measured.
    Geometry(seamwright_geometry::Error),
}

/// An end of an arc of an ellipse.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EndPoint {
    /// Its first point.
    Start,
    /// Its last point.
    End,
}

/// A value of an interpolation request.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RequestValue {
    /// Semi-axis a of the ellipse, mm.
    SemiAxisA,
    /// Semi-axis b of the ellipse, mm.
    SemiAxisB,
    /// x of a point, mm.
    X,
    /// y of a point, mm.
    Y,
    /// Radius of the nozzle, mm.
    NozzleRadius,
    /// Radius of the shell, mm.
    ShellRadius,
    /// Angle of the start, rad.
    StartAngle,
    /// Sweep, rad.
    Sweep,
    /// Speed, mm/s.
    Speed,
    /// Period, s.
    Period,
    /// Speed times period, mm.
    Step,
    /// Pulse equivalent, mm.
    Pulse,
}

impl RequestValue {
    fn message(self) -> Message {
        Message::new(match self {
            Self::SemiAxisA => "motion-value-semi-axis-a",
            Self::SemiAxisB => "motion-value-semi-axis-b",
            Self::X => "motion-value-x",
            Self::Y => "motion-value-y",
            Self::NozzleRadius => "motion-value-nozzle-radius",
            Self::ShellRadius => "motion-value-shell-radius",
            Self::StartAngle => "motion-value-start-angle",
            Self::Sweep => "motion-value-sweep",
            Self::Speed => "motion-value-speed",
            Self::Period => "motion-value-period",
            Self::Step => "motion-value-step",
            Self::Pulse => "motion-value-pulse",
        })
    }
}

impl Error {
    /// Describes the error.
    pub fn message(&self) -> Message {
        match self {
            Self::NotPositive { what, value } => Message::new("motion-value-not-positive")
                .message("what", what.message())
                .value("value", *value, Unit::One),
            Self::NotFinite { what, value } => Message::new("motion-value-not-finite")
                .message("what", what.message())
                .value("value", *value, Unit::One),
            Self::OffEllipse { which, x_mm, y_mm, distance_mm, tolerance_mm, near_x_mm, near_y_mm } => {
                let code = match which {
                    EndPoint::Start => "motion-start-off-ellipse",
                    EndPoint::End => "motion-end-off-ellipse",
                };
                Message::new(code)
                    .value("x", *x_mm, Unit::One)
                    .value("y", *y_mm, Unit::One)
                    .value("distance", *distance_mm, Unit::Mm)
                    .value("tolerance", *tolerance_mm, Unit::Mm)
                    .value("near_x", *near_x_mm, Unit::One)
                    .value("near_y", *near_y_mm, Unit::One)
            }
            Self::NozzleTooLarge { nozzle_mm, shell_mm } => Message::new("motion-nozzle-too-large")
                .value("nozzle", *nozzle_mm, Unit::Mm)
                .value("shell", *shell_mm, Unit::Mm),
            Self::Sweep { sweep_rad, limit_rad } => {
                Message::new("motion-sweep").value("sweep", *sweep_rad, Unit::Rad).value("limit", *limit_rad, Unit::Rad)
            }
            Self::StepTooLong { step_mm, limit_mm } => {
                Message::new("motion-step-too-long").value("step", *step_mm, Unit::Mm).value("max", *limit_mm, Unit::Mm)
            }
            Self::PulseTooLarge { pulse_mm, limit_mm } => Message::new("motion-pulse-too-large")
                .value("pulse", *pulse_mm, Unit::Mm)
                .value("max", *limit_mm, Unit::Mm),
            Self::TooManySteps { steps, limit } => Message::new("motion-too-many-steps")
                .text("steps", format!("{steps:.3e}"))
                .text("max", format!("{limit:.0e}")),
            Self::Geometry(error) => error.message(),
        }
    }
}

seamwright_message::display_by_message!(Error);

impl From<seamwright_geometry::Error> for Error {
    fn from(error: seamwright_geometry::Error) -> Self {
        Self::Geometry(error)
    }
}

/// Checks that a value is finite and greater than zero.
pub(crate) fn positive(what: RequestValue, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::NotPositive { what, value }) }
}

/// Checks that a value is finite.
pub(crate) fn finite(what: RequestValue, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, value }) }
}
