use seamwright_message::{Message, Unit};

/// Error of an invalid interpolation request, found before any computation: its description.
#[derive(Debug, Clone, PartialEq)]
pub struct Error(pub Message);

impl From<seamwright_geometry::Error> for Error {
    fn from(error: seamwright_geometry::Error) -> Self {
        Self(error.message())
    }
}

/// Checks that the value `what`, a code of its name, is finite and greater than zero.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(invalid("motion-value-not-positive", what, value)) }
}

/// Checks that the value `what`, a code of its name, is finite.
pub(crate) fn finite(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() { Ok(value) } else { Err(invalid("motion-value-not-finite", what, value)) }
}

fn invalid(code: &'static str, what: &'static str, value: f64) -> Error {
    Error(Message::new(code).message("what", Message::new(what)).value("value", value, Unit::One))
}
