use seamwright_message::{Message, Unit, display_by_message};

/// Error in the construction of a geometric object. Angles are in rad, those of a wall about the tube's
/// axis; lengths in mm. Names of sizes, directions and
/// sets of points are codes of messages.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Error {
    /// A size must be finite and greater than zero.
    Size { what: &'static str, value: f64 },
    /// A size must lie between two others, mm.
    Range { what: &'static str, value: f64, min: f64, max: f64 },
    /// A direction has no length or is not finite.
    Direction { what: &'static str },
    /// Two directions that span a plane are parallel.
    Parallel { first: &'static str, second: &'static str },
    /// Every line of the tube's wall misses the body although its axis meets it.
    TubeLargerThanBody,
    /// The tube passes beside the body.
    TubeBesideBody,
    /// Part of the tube's wall misses the body, between these angles: the curve is not closed.
    NotClosed { from: f64, to: f64 },
    /// Part of the tube's wall leaves a head over the end of its flange, between these angles.
    BeyondHead { from: f64, to: f64 },
    /// The wall touches the body tangentially at this angle: the curve has a corner there.
    Tangent { at: f64 },
    /// The tube's wall passes beside a body that trims it, above the body that it stands on: the curve would jump.
    Beside { at: f64 },
    /// The tube's direction points into the body and never leaves it.
    NeverLeaves,
    /// The length of a curve cannot be measured to the requested accuracy; subdivision stopped at this parameter.
    ArcLength { accuracy_mm: f64, at: f64 },
    /// Fewer points than a fit needs.
    TooFewPoints { what: &'static str, given: usize, min: usize },
    /// Points too close to one position to define the result.
    OnePosition { what: &'static str },
    /// Points too close to one line to define the result.
    OneLine { what: &'static str },
    /// A circle touched over too small an angle.
    ShortArc { touched: f64, min: f64 },
    /// Attitudes too similar to determine the touched point: `apart` is the largest angle between two of them.
    Alike { apart: f64 },
    /// A search for a rigid motion did not converge.
    NoFit,
    /// A column with another number of values than there are points.
    Column { values: usize, points: usize },
    /// The point of this index is not finite or too large.
    Place { index: usize },
    /// A piece of a chain, counted from 0, does not start at the end of the one before.
    Gap { piece: usize },
    /// A direction turns too sharply between neighbouring points.
    Turn { what: &'static str },
    /// Knots of a spline must increase strictly: the first index that does not.
    Knots { index: usize },
}

display_by_message!(Error);

impl Error {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        match *self {
            Self::Size { what, value } => named("geometry-size", what).value("value", value, Unit::One),
            Self::Range { what, value, min, max } => range(what, value, min, max),
            Self::Direction { what } => named("geometry-direction", what),
            Self::Parallel { first, second } => {
                Message::new("geometry-parallel").message("first", name(first)).message("second", name(second))
            }
            Self::TubeLargerThanBody => Message::new("geometry-tube-larger-than-body"),
            Self::TubeBesideBody => Message::new("geometry-tube-beside-body"),
            Self::NotClosed { from, to } => angles("geometry-not-closed", from, to),
            Self::BeyondHead { from, to } => angles("geometry-beyond-head", from, to),
            Self::Tangent { at } => angle("geometry-tangent", "angle", at, 3),
            Self::Beside { at } => angle("geometry-beside-trimming-tube", "angle", at, 3),
            Self::NeverLeaves => Message::new("geometry-never-leaves"),
            Self::ArcLength { accuracy_mm, at } => {
                Message::new("geometry-arc-length").value("accuracy", accuracy_mm, Unit::Mm).number("parameter", at, 6)
            }
            Self::TooFewPoints { what, given, min } => {
                named("geometry-too-few-points", what).count("given", given).count("min", min)
            }
            Self::OnePosition { what } => named("geometry-points-in-one-position", what),
            Self::OneLine { what } => named("geometry-points-on-one-line", what),
            Self::ShortArc { touched, min } => {
                angle("geometry-short-arc", "touched", touched, 0).quantity("min", min.to_degrees(), Unit::Deg, 0)
            }
            Self::Alike { apart } => angle("geometry-attitudes-alike", "angle", apart, 1),
            Self::NoFit => Message::new("geometry-no-fit"),
            Self::Column { values, points } => {
                Message::new("geometry-column").count("values", values).count("points", points)
            }
            Self::Place { index } => Message::new("geometry-point").text("index", index.to_string()),
            Self::Gap { piece } => Message::new("geometry-gap").text("piece", piece.to_string()),
            Self::Turn { what } => named("geometry-sharp-turn", what),
            Self::Knots { index } => Message::new("geometry-knots").text("index", index.to_string()),
        }
    }
}

/// The name of a size, a direction or a set of points.
fn name(what: &'static str) -> Message {
    Message::new(what)
}

fn named(code: &'static str, what: &'static str) -> Message {
    Message::new(code).message("what", name(what))
}

/// An error of a size, mm, that must lie between `min` and `max`; `max` may be infinite.
fn range(what: &'static str, value: f64, min: f64, max: f64) -> Message {
    let code = if max.is_finite() { "geometry-range" } else { "geometry-too-small" };
    let message = named(code, what).value("value", value, Unit::Mm).value("min", min, Unit::Mm);
    if max.is_finite() { message.value("max", max, Unit::Mm) } else { message }
}

fn angle(code: &'static str, name: &'static str, angle: f64, decimals: u8) -> Message {
    Message::new(code).quantity(name, angle.to_degrees(), Unit::Deg, decimals)
}

/// An error between two angles, rad.
fn angles(code: &'static str, from: f64, to: f64) -> Message {
    angle(code, "from", from, 3).quantity("to", to.to_degrees(), Unit::Deg, 3)
}

/// Rejects sizes that are not finite and positive.
pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, Error> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(Error::Size { what, value }) }
}

pub(crate) fn unit(what: &'static str, v: glam::DVec3) -> Result<glam::DVec3, Error> {
    v.try_normalize().filter(|u| u.is_finite()).ok_or(Error::Direction { what })
}
