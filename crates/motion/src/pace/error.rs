use thiserror::Error;

/// Error of a refused command or value. The state is then unchanged.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum PaceError {
    /// The override is out of range.
    #[error("the override must be between 0 and {greatest}, not {value}{}", if *.greatest < 1.5 {
        " (up to 1.5 with a law planned for that speed)" } else { "" })]
    Override {
        /// The value given.
        value: f64,
        /// Maximum override of the given profiles.
        greatest: f64,
    },
    /// A limit of an axis is invalid.
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
    /// The factor of the faster profile is out of range.
    #[error("the faster law must be planned for more than 1 and at most 1.5 times the speed, not {value}")]
    Faster {
        /// The value given.
        value: f64,
    },
    /// A step to a path length that is welded already, or off the path.
    #[error("a step must end beyond {welded} mm, where the seam is welded to, and at most at {length} mm, not {value}")]
    StepTo {
        /// The value given, mm.
        value: f64,
        /// Path length welded to, mm.
        welded: f64,
        /// Length of the path, mm.
        length: f64,
    },
    /// An order to move with an override of 0.
    #[error("the override is 0: set one above 0 before going on")]
    Zero,
    /// The motion is stuck: the profile's rates are not finite there, or exceed the limits.
    #[error("the motion cannot go on at {s} mm: what the law asks for there is not within the axes' limits")]
    Stuck {
        /// Path length at which it is stuck, mm.
        s: f64,
    },
}
