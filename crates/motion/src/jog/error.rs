use arrayvec::ArrayString;
use seamwright_message::{Message, Unit};

/// Name of an axis, truncated to fit: commands are refused within the cycle, which must not allocate.
pub type AxisName = ArrayString<32>;

/// Error of a refused command; the axes are unchanged. Positions in the units of files.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum JogError {
    /// A target or start beyond the end of an axis.
    Range { axis: AxisName, value: f64, low: f64, high: f64, unit: Unit },
    /// A value of an axis is NaN or infinite.
    NotFinite { what: AxisValue, axis: AxisName },
    /// The requested velocity of the tip is not finite.
    TipNotFinite,
    /// A period, time or override is invalid.
    Setting { what: JogSetting, value: f64 },
    /// No such axis.
    NoSuchAxis { axis: usize, axes: usize },
    /// The start position is not clear: two solids, their distance and the required minimum.
    NotClear { first: Message, second: Message, distance_mm: f64, least_mm: f64 },
    /// The jog has halted, and the halt has not been acknowledged by commanding rest.
    Halted,
    /// No motion was found from the present state to the target.
    NoMotion,
}

/// Value of an axis in a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxisValue {
    /// Position.
    Position,
    /// Speed.
    Speed,
}

/// Setting of a jog.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JogSetting {
    /// Period of the set-points, s.
    Period,
    /// Time without a signal after which the motion stops, s.
    Silence,
    /// Override.
    Override,
}

impl JogError {
    /// Describes the error. Allocates: not for the control cycle.
    pub fn message(&self) -> Message {
        match self {
            Self::Range { axis, value, low, high, unit } => Message::new("motion-jog-range")
                .axis("axis", axis.as_str())
                .value("value", *value, *unit)
                .value("min", *low, *unit)
                .value("max", *high, *unit),
            Self::NotFinite { what, axis } => {
                let is_speed = *what == AxisValue::Speed;
                Message::new(if is_speed { "motion-jog-speed" } else { "motion-jog-position" })
                    .axis("axis", axis.as_str())
            }
            Self::TipNotFinite => Message::new("motion-jog-tip"),
            Self::Setting { what, value } => {
                let (code, unit) = match what {
                    JogSetting::Period => ("motion-jog-period", Unit::S),
                    JogSetting::Silence => ("motion-jog-silence", Unit::S),
                    JogSetting::Override => ("motion-jog-override", Unit::One),
                };
                Message::new(code).value("value", *value, unit)
            }
            Self::NoSuchAxis { axis, axes } => {
                Message::new("motion-jog-axis").number("axis", *axis as f64, 0).count("axes", *axes)
            }
            Self::NotClear { first, second, distance_mm, least_mm } => Message::new("motion-jog-not-clear")
                .message("first", first.clone())
                .message("second", second.clone())
                .quantity("distance", *distance_mm, Unit::Mm, 3)
                .quantity("minimum", *least_mm, Unit::Mm, 3),
            Self::Halted => Message::new("motion-jog-halted"),
            Self::NoMotion => Message::new("motion-jog-no-motion"),
        }
    }
}

seamwright_message::display_by_message!(JogError);
