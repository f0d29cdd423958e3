use arrayvec::ArrayString;
use thiserror::Error;

/// Name of an axis, truncated to fit: commands are refused within the cycle, which must not allocate.
pub type AxisName = ArrayString<32>;

/// Error of a refused command; the axes are unchanged. Positions in the units of files.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum JogError {
    /// A target or start beyond the end of an axis.
    #[error("axis {axis} cannot be at {value} {unit}: its range is {low} to {high} {unit}")]
    Range {
        /// Name of the axis.
        axis: AxisName,
        /// The requested position.
        value: f64,
        /// Lowest position.
        low: f64,
        /// Highest position.
        high: f64,
        /// mm or deg.
        unit: &'static str,
    },
    /// A value of an axis is NaN or infinite.
    #[error("the {what} of axis {axis} is not a finite number")]
    NotFinite {
        /// Name of the value.
        what: &'static str,
        /// Name of the axis.
        axis: AxisName,
    },
    /// The requested velocity of the tip is not finite.
    #[error("the velocity of the tip is not a finite number")]
    TipNotFinite,
    /// A period, time or override is invalid.
    #[error("{what} is {value}; it must be {allowed}")]
    Setting {
        /// Name of the value.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range.
        allowed: &'static str,
    },
    /// No such axis.
    #[error("the machine has {axes} axes, and no axis {axis}")]
    NoSuchAxis {
        /// The requested index.
        axis: usize,
        /// Number of axes.
        axes: usize,
    },
    /// The start position is not clear.
    #[error("at the start {first} and {second} are {distance_mm:.3} mm apart, and {least_mm:.3} mm are asked for")]
    NotClear {
        /// Name of the one.
        first: String,
        /// Name of the other.
        second: String,
        /// Their distance, mm.
        distance_mm: f64,
        /// Required minimum distance, mm.
        least_mm: f64,
    },
    /// The jog has halted, and the halt has not been acknowledged by commanding rest.
    #[error("the jog has halted: command rest before anything else")]
    Halted,
    /// No motion was found from the present state to the target.
    #[error("no motion within the limits was found from the present state to the target")]
    NoMotion,
}
