use crate::part_program::Level;

/// Options that convert a weld into a part program.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Level at which the control interpolates.
    pub level: Level,
    /// Maximum distance of the blocks' path from the planned one of the tip, mm.
    pub tolerance_mm: f64,
    /// Maximum deviation of the tip's speed from the planned one inside blocks between the acceleration and
    /// deceleration phases, percent. The control's block rate limits it: see [`BRIEFEST_S`]. Passes that weave are
    /// exempt.
    pub speed_percent: f64,
    /// Kind of blocks. LinuxCNC and grblHAL have lines and arcs alone, Sinumerik polynomials too.
    pub interpolation: Interpolation,
}

impl Default for Options {
    fn default() -> Self {
        // Welding procedures leave speeds about ten times as much.
        Self { level: Level::Joint, tolerance_mm: 0.01, speed_percent: 1.0, interpolation: Interpolation::Pvt }
    }
}

/// Minimum duration of blocks cut for the sake of the tip's speed, s: all of the controls pass a hundred blocks a
/// second without slowing down.
pub const BRIEFEST_S: f64 = 0.01;
/// Part of the tolerance that is left to the control for rounding corners (LinuxCNC's G64 P).
pub(super) const ROUNDING: f64 = 0.1;

impl Options {
    /// Tolerance left to a control that rounds corners between blocks, mm.
    pub fn rounding_mm(&self) -> f64 {
        ROUNDING * self.tolerance_mm
    }
}

/// Kind of blocks on controls that have more than lines and arcs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// Cubics in time, with speeds: PVT.
    Pvt,
    /// Splines with equal times: SPLINE1.
    Spline1,
    /// Lines and arcs: LINEAR and CIRCLE.
    Linear,
    /// Sinumerik: polynomials of the third degree, POLY.
    Poly,
}
