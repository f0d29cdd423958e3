use crate::actuator::{Deflection, Slide, SlideLimits};
use crate::lead::Error;
use glam::DVec2;
use seamwright_machine::BeamDeflection;

/// Fraction of the deflection's range that is used before the axes carry the gun.
const RESERVE: f64 = 0.8;
/// Anticipation of the axes that carry the gun, s; the deflection compensates meanwhile.
pub(super) const SOON_S: f64 = 0.3;
/// Error (mm) and its duration (s) from which a correction exceeds both actuators: axes need some time.
const SHORT_MM: f64 = 0.1;
const SHORT_S: f64 = 0.3;

/// Splits corrections: the beam's deflection within its range, the excess by the axes that carry the gun.
///
/// The axes move only as far as necessary, so a seam within 80 % of the deflection's range leaves them at rest. The
/// deflection compensates their following error, so it does not reach the weld.
#[derive(Debug, Clone)]
pub(super) struct BeamAuthority {
    deflection: Deflection,
    axes: Slide,
    range_mm: f64,
    /// Target of the axes, mm.
    target: f64,
    short_since: Option<f64>,
}

/// Lateral correction in two parts, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Shares {
    pub(super) deflection: f64,
    /// Set-point of the axes.
    pub(super) carried: f64,
    /// The axes carry a part.
    pub(super) carries: bool,
    /// The target exceeds 80 % of the axes' stroke.
    pub(super) near_stroke: bool,
    /// Both together do not reach the seam.
    pub(super) short: bool,
}

impl BeamAuthority {
    pub(super) fn new(deflection: BeamDeflection, axes: SlideLimits, cycle_s: f64) -> Result<Self, Error> {
        let range_mm = deflection.range_mm;
        let (deflection, axes) = (Deflection::new(deflection, cycle_s)?, Slide::new(axes, cycle_s)?);
        Ok(Self { deflection, axes, range_mm, target: 0.0, short_since: None })
    }

    /// Returns the time from a command to its effect, s.
    pub(super) fn lag_s(&self) -> f64 {
        self.deflection.lag_s()
    }

    /// Returns the set-points that bring the beam to `to` while the axes actually carry the gun by `carried`. After
    /// [`SOON_S`] the beam has to reach `soon`. A non-finite target is ignored as unknown.
    pub(super) fn step(&mut self, [to, soon]: [f64; 2], carried: f64, t_s: f64) -> Shares {
        let reserve = RESERVE * self.range_mm;
        for wanted in [to, soon].into_iter().filter(|wanted| wanted.is_finite()) {
            self.target = self.target.clamp(wanted - reserve, wanted + reserve);
        }
        let set = self.axes.step(self.target);
        let deflection = self.deflection.step(DVec2::new(0.0, to - carried)).y;
        if to.is_nan() || (carried + deflection - to).abs() <= SHORT_MM {
            self.short_since = None;
        } else if self.short_since.is_none() {
            self.short_since = Some(t_s);
        }
        Shares {
            deflection,
            carried: set,
            carries: self.target != 0.0,
            near_stroke: self.target.abs() > RESERVE * self.axes.limits().stroke_mm,
            short: self.short_since.is_some_and(|since| t_s - since >= SHORT_S),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::AxisLimits;

    const BEAM: BeamDeflection = BeamDeflection { range_mm: 2.0, speed: 2000.0, latency_s: 75e-6, pivot_mm: 400.0 };
    const AXES: SlideLimits =
        SlideLimits { stroke_mm: 5.0, motion: AxisLimits { speed: 20.0, acceleration: 200.0, jerk: 3000.0 } };

    /// With late, shaking axes the beam stays on the seam, and they move only by the excess over the range.
    #[test]
    fn together_they_are_on_the_seam() {
        let mut authority = BeamAuthority::new(BEAM, AXES, 1e-3).unwrap();
        let (mut carried, mut most) = (0.0f64, 0.0f64);
        for i in 0..60_000 {
            let t = 1e-3 * f64::from(i);
            // Up to 5 mm, at most 2 mm/s.
            let seam = 5.0 * (0.4 * t).sin();
            let shares = authority.step([seam, f64::NAN], carried, t);
            assert!((carried + shares.deflection - seam).abs() < 1e-9, "{i}");
            assert!(!shares.short && shares.carries == (t > (1.6f64 / 5.0).asin() / 0.4));
            carried += 0.02 * (shares.carried + 0.1 * (30.0 * t).sin() - carried);
            most = most.max(shares.carried.abs());
        }
        assert!((most - 3.4).abs() < 0.01, "{most}");
    }

    /// A jump beyond the range is followed at once if it is known in advance.
    #[test]
    fn a_jump_that_is_known() {
        let mut authority = BeamAuthority::new(BEAM, AXES, 1e-3).unwrap();
        let (mut carried, mut worst) = (0.0f64, 0.0f64);
        let seam = |t: f64| if t < 2.0 { 1.5 } else { 2.4 };
        for i in 0..4000 {
            let t = 1e-3 * f64::from(i);
            let shares = authority.step([seam(t), seam(t + SOON_S)], carried, t);
            worst = worst.max((carried + shares.deflection - seam(t)).abs());
            carried = shares.carried;
        }
        assert!(worst < 1e-9 && (carried - 0.8).abs() < 0.01, "{worst} {carried}");
    }

    /// A target beyond both ranges is reported as `short`; NaN targets are ignored.
    #[test]
    fn beyond_both() {
        let mut authority = BeamAuthority::new(BEAM, AXES, 1e-3).unwrap();
        let mut carried = 0.0;
        let mut last = None;
        for i in 0..8300 {
            let to = if i % 700 == 3 { f64::NAN } else { 1e-3 * f64::from(i) };
            let shares = authority.step([to, to], carried, 1e-3 * f64::from(i));
            carried = shares.carried;
            assert!(shares.deflection.abs() <= 2.0 && shares.carried.abs() <= 5.0);
            assert!(!shares.short || i > 7100, "{i}");
            last = Some(shares);
        }
        let last = last.unwrap();
        assert!(last.short && last.near_stroke && last.carries);
    }
}
