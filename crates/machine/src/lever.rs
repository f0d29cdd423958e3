use crate::axis::AxisKind;

/// Pitch errors change a rate by up to this factor.
pub(crate) const PITCH: f64 = 1.0 + crate::pitch_error::STEEPEST;

/// Effect of an axis on the points of a group.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lever {
    pub(crate) axis: usize,
    pub(crate) kind: AxisKind,
    /// Maximum displacement of a point per unit of the axis, mm.
    pub(crate) arm: f64,
    /// Factor of pitch errors.
    pub(crate) pitch: f64,
}

/// Maximum displacement of a point while each axis moves by up to `by`, mm.
pub(crate) fn travel(levers: &[Lever], by: impl Fn(usize) -> f64) -> f64 {
    levers.iter().fold(0.0, |moved, lever| {
        let by = by(lever.axis) * lever.pitch;
        moved
            + match lever.kind {
                AxisKind::Linear => by,
                AxisKind::Rotary => by * (lever.arm + moved),
            }
    })
}
