use thiserror::Error;

/// Why a command or a value is refused. Nothing has changed when one of these comes back.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PaceError {
    /// The override is outside what can be played.
    #[error("the override must be between 0 and {greatest}, not {value}{}", if *.greatest < 1.5 {
        " (up to 1.5 with a law planned for that speed)" } else { "" })]
    Override {
        /// The value given.
        value: f64,
        /// Greatest override that the laws handed in allow.
        greatest: f64,
    },
    /// A limit of an axis is no limit.
    #[error("the {what} limit of axis {axis} must be greater than 0, not {value}")]
    Limit {
        /// Number of the axis, from 0.
        axis: usize,
        /// "speed", "acceleration" or "jerk".
        what: &'static str,
        /// The value given.
        value: f64,
    },
    /// More axes than a machine may have.
    #[error("at most {most} axes are allowed, not {axes}")]
    TooManyAxes {
        /// Axes given.
        axes: usize,
        /// Axes allowed.
        most: usize,
    },
    /// The period of the set-points.
    #[error("the period must be between 0.00025 and 0.004 s, not {value}")]
    Period {
        /// The value given, s.
        value: f64,
    },
    /// A path length outside the path.
    #[error("the path length must be between 0 and {length} mm, not {value}")]
    Place {
        /// The value given, mm.
        value: f64,
        /// Length of the path, mm.
        length: f64,
    },
    /// The factor for which the faster law is planned.
    #[error("the faster law must be planned for more than 1 and at most 1.5 times the speed, not {value}")]
    Faster {
        /// The value given.
        value: f64,
    },
    /// A step to a place that is welded already, or off the path.
    #[error("a step must end beyond {welded} mm, where the seam is welded to, and at most at {length} mm, not {value}")]
    StepTo {
        /// The value given, mm.
        value: f64,
        /// Path length welded to, mm.
        welded: f64,
        /// Length of the path, mm.
        length: f64,
    },
    /// Going on with an override of 0.
    #[error("the override is 0: set one above 0 before going on")]
    Zero,
    /// Nothing moves although it should: the law's rates are no numbers there, or not within the limits.
    #[error("the motion cannot go on at {s} mm: what the law asks for there is not within the axes' limits")]
    Stuck {
        /// Where it stands, mm.
        s: f64,
    },
}
