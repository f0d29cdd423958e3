/// Deflection of a beam on the work, equal in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamDeflection {
    /// Maximum deflection, mm.
    pub range_mm: f64,
    /// Maximum speed, mm/s.
    pub speed: f64,
    /// Latency from the command to the deflection, s.
    pub latency_s: f64,
    /// Distance from the work to the point about which the beam is deflected, mm.
    pub pivot_mm: f64,
}
