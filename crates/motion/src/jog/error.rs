use arrayvec::ArrayString;
use thiserror::Error;

/// Name of an axis, as much of it as fits: a command is refused within the cycle, where nothing may allocate.
pub type AxisName = ArrayString<32>;

/// Why a command is not taken; the axes stay as they are. Positions in the units of files.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum JogError {
    /// A target or start beyond the end of an axis.
    #[error("axis {axis} cannot be at {value} {unit}: its range is {low} to {high} {unit}")]
    Range {
        /// Name of the axis.
        axis: AxisName,
        /// The position asked for.
        value: f64,
        /// Lowest position.
        low: f64,
        /// Highest position.
        high: f64,
        /// mm or deg.
        unit: &'static str,
    },
    /// A value of an axis that is no number, or infinite.
    #[error("the {what} of axis {axis} is not a finite number")]
    NotFinite {
        /// What it is.
        what: &'static str,
        /// Name of the axis.
        axis: AxisName,
    },
    /// The tip is to move at what is no velocity.
    #[error("the velocity of the tip is not a finite number")]
    TipNotFinite,
    /// A period, time or override that cannot be.
    #[error("{what} is {value}; it must be {allowed}")]
    Setting {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// No such axis.
    #[error("the machine has {axes} axes, and no axis {axis}")]
    NoSuchAxis {
        /// The index asked for.
        axis: usize,
        /// Number of axes.
        axes: usize,
    },
    /// Where it should begin is not clear.
    #[error("at the start {first} and {second} are {distance_mm:.3} mm apart, and {least_mm:.3} mm are asked for")]
    NotClear {
        /// Name of the one.
        first: String,
        /// Name of the other.
        second: String,
        /// Their distance, mm.
        distance_mm: f64,
        /// What is asked for, mm.
        least_mm: f64,
    },
    /// The jog has halted, and the halt has not been acknowledged by commanding rest.
    #[error("the jog has halted: command rest before anything else")]
    Halted,
    /// No motion was found from the present state to the target.
    #[error("no motion within the limits was found from the present state to the target")]
    NoMotion,
}
