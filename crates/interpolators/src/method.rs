/// Interpolation method: the rule from one point to the next.
///
/// | method | points | speed along the seam | drift |
/// |---|---|---|---|
/// | [`Method::Exact`] | on the curve | constant | none |
/// | [`Method::EccentricAngle`] | on the curve | varies, see [`AngleRule`] | none |
/// | [`Method::PointByPoint`] | whole pulses, less than 1 pulse off an ellipse | 0.71 to 1 of nominal | none |
/// | [`Method::ComparisonIntegral`] | whole pulses, at most half a pulse off an ellipse | 1 to 1.41 of nominal | none |
/// | [`Method::Dda`] | whole pulses | that of equal angles | outwards, 2 or 3 pulses a turn |
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Equal steps along the curve: the reference of the other methods.
    Exact(EqualStep),
    /// A step of the angle computed from the wanted step along the curve (ELLIPSE-2015; for a saddle SADDLE-2020).
    /// Every point is on the curve to the rounding of its coordinates, at any speed error.
    EccentricAngle(AngleRule),
    /// Point-by-point comparison: one pulse of one axis a clock, by the sign of the deviation function. The classical
    /// rule that ELLIPSE-2015 compares with; see [`Request::pulse_mm`](crate::Request::pulse_mm).
    PointByPoint,
    /// Comparison-integral: the faster axis pulses every clock, another axis pulses in the same clock if its integral
    /// has fallen half a pulse behind. The other method that ELLIPSE-2015 compares with.
    ComparisonIntegral,
    /// Digital differential analyser: an integer accumulator per axis, whose overflows are the pulses. ELLIPSE-2015
    /// names it in its text. It has no feedback from the curve, so its error accumulates.
    Dda,
}

impl Method {
    /// True for the methods whose points are whole pulses.
    pub fn is_pulse(self) -> bool {
        matches!(self, Self::PointByPoint | Self::ComparisonIntegral | Self::Dda)
    }
}

/// Quantity that is equal for all steps of [`Method::Exact`]. The last step, which closes the path, is shorter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EqualStep {
    /// The length along the curve: constant speed. Every full step is speed times period within 1e-9 of it for paths
    /// of up to 1e5 steps, beyond that within 1e-14 times the number of steps (rounding of the angle and the length;
    /// measured 4e-10 at 2.3e6 steps).
    Arc,
    /// The straight distance from point to point: the next point is the first one along the curve at that distance, to
    /// 1e-12 of it or the rounding of the coordinates (some 1e-15 of the shape's size), whichever is more. A part of
    /// the curve that turns back within a step is skipped.
    Chord,
}

/// Rule for the step of the angle from the step `dL` (speed times period), evaluated at the step's start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AngleRule {
    /// `dt = dL / |OM|`, `|OM|` the distance of the point from the centre, as printed in ELLIPSE-2015; the printed
    /// formula takes the eccentric angle for the polar one. The speed strays from `a/b` times nominal at the ends of
    /// the b axis to `b/a` times at those of the a axis. On a saddle, where |OM| seen along the nozzle's axis is its
    /// radius r, this is equal angles `dL / r`: the uneven speed that SADDLE-2020 warns of.
    Printed,
    /// `dpsi = dL / |OM|` of the polar angle, `tan(psi) = (b/a) tan(t)`, as ELLIPSE-2015 derives it: the step across
    /// the radius is exact, the one along it is added; the speed is up to `(a/b + b/a)/2` times nominal. On a saddle,
    /// whose plan is a circle, equal to [`AngleRule::Printed`].
    Polar,
    /// `dt = dL / sqrt(a^2 sin(t)^2 + b^2 cos(t)^2)`, on a saddle `dL / |dP/dt|` (SADDLE-2020): along the tangent. The
    /// remaining error is of first order in `dL` over the shape's size and of either sign.
    Tangent,
}
