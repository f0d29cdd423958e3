use schemars::JsonSchema;
use serde::Serialize;
use ts_rs::TS;

/// Certificate of a pass: its speeds and their limits, as `tools motion --certificate` writes them.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct CertificateView {
    /// Part of the path's length on which the tip is as fast as asked, %.
    pub at_asked_percent: f64,
    /// A speed of the tip that every axis can hold everywhere, mm/s.
    pub everywhere_mm_s: f64,
    /// Stretches of the path in order, each with what bounds its speed.
    pub bounds: Vec<BoundView>,
    /// The maximum use of each axis' limits over the whole path; after the axes the torch tip's, if it has limits.
    pub uses: Vec<UseView>,
}

/// A stretch of a pass with one bound.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct BoundView {
    /// Path length at which it begins, mm.
    pub from_mm: f64,
    /// Path length at which it ends, mm.
    pub to_mm: f64,
    /// Minimum planned speed of the tip in it, mm/s.
    pub least_speed_mm_s: f64,
    /// False in the acceleration and deceleration phases.
    pub between: bool,
    /// `asked` (nothing else binds), `speed`, `acceleration` or `jerk`.
    pub what: String,
    /// The axis whose limit binds; none: the torch tip's, or nothing.
    pub axis: Option<String>,
    /// The limit that binds, in mm or degrees per s, s^2 or s^3.
    pub limit: Option<f64>,
    /// Its unit.
    pub unit: Option<String>,
}

/// The maximum use of the limits of an axis or of the torch tip; of speed, acceleration and jerk, none where there is no limit.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct UseView {
    /// The axis; none: the torch tip.
    pub axis: Option<String>,
    /// `mm` or `deg`.
    pub unit: String,
    /// Of each limit, %.
    pub percent: [Option<f64>; 3],
    /// The limits, in mm or degrees per s, s^2 and s^3.
    pub limit: [Option<f64>; 3],
}
