/// Error of a path without a speed profile.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum LawError {
    /// A limit is not a positive number.
    #[error(
        "the {what} limit of channel {channel} is {value}: it must be a finite number above zero (a jerk may be infinite)"
    )]
    Limit {
        /// The channel's number, from 0.
        channel: usize,
        /// `speed`, `acceleration` or `jerk`.
        what: &'static str,
        /// The limit.
        value: f64,
    },
    /// The requested speed is not a positive number.
    #[error("the speed asked for at {at} is {value}: it must be above zero")]
    Asked {
        /// The path's parameter.
        at: f64,
        /// The speed, mm/s.
        value: f64,
    },
    /// The path has no length.
    #[error("the path goes from {from} to {to}: its end must be a finite number beyond its start")]
    Range {
        /// First parameter.
        from: f64,
        /// Last parameter.
        to: f64,
    },
    /// A derivative is not a finite number.
    #[error("channel {channel} has a derivative at {at} that is not a finite number: the path is not smooth there")]
    NotSmooth {
        /// The channel's number, from 0.
        channel: usize,
        /// The path's parameter.
        at: f64,
    },
    /// No channel moves between two stops.
    #[error("nothing moves between {from} and {to}: no limit bounds the speed there")]
    Still {
        /// First parameter of the piece.
        from: f64,
        /// Last parameter of the piece.
        to: f64,
    },
}
