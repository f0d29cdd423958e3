use glam::DVec3;

/// One interpolated point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Time since the start, s.
    pub t_s: f64,
    /// Angle of the point, rad, not wrapped: the eccentric angle of an ellipse, the angle about the nozzle's axis of a
    /// saddle. For a pulse method, whose points lie beside the curve, it is that of the nearest point of the curve.
    pub u_rad: f64,
    /// Position, mm.
    pub position: DVec3,
}
