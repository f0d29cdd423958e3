use crate::lead::{Moment, SeamFrame};
use arrayvec::ArrayVec;
use glam::DVec2;

/// Point of the joint's midline in a frame, mm in the torch frame; the undeflected beam is the origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Distance ahead along the seam.
    pub along_mm: f64,
    /// Lateral position, positive in the direction of lateral corrections.
    pub lateral_mm: f64,
    /// 0 to 1.
    pub confidence: f64,
}

/// Midline detected in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Picture<'a> {
    /// Mean exposure time of the frame, s, on the cell's clock.
    pub exposed_s: f64,
    /// Height of the work above the taught one, mm, as focus measured it on the beam's axis; 0 without a measurement.
    /// Then the seam is detected beside its true position if its frame rotates.
    pub height_mm: f64,
    /// Points from the nearest to the farthest.
    pub points: &'a [Point],
}

/// Result of processing a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Taken {
    /// Number of points used.
    pub used: u32,
    /// Number of points rejected as outliers.
    pub gated: u32,
    /// Number of points outside the zone, of too little confidence, or beyond the maximum number.
    pub left_out: u32,
    /// Reason for rejecting the whole picture.
    pub refused: Option<crate::lead::Refusal>,
}

/// A nominal seam by path length.
pub(super) type Course<'a> = &'a (dyn Fn(f64) -> SeamFrame + Sync);

/// Iterations of the foot-point search; each multiplies the error by the point's distance over the seam's radius.
const STEPS: usize = 6;

/// Returns the path length of the nominal seam's station nearest to a point, and the seam's deviation there. The axes
/// carried the gun aside by `then.slide`. A frame is flat: the point is assumed `height` mm above the nominal seam.
pub(super) fn located(seam: Course<'_>, then: &Moment, point: &Point, height: f64) -> (f64, DVec2) {
    let here = seam(then.s_mm);
    let at = here.point + point.along_mm * here.along + (point.lateral_mm + then.slide.x) * here.lateral;
    let mut s = then.s_mm + point.along_mm;
    let mut lateral = 0.0;
    for _ in 0..STEPS {
        let foot = seam(s);
        let off = at - foot.point - height * foot.height;
        let off = off - off.dot(here.height) * here.height;
        lateral = off.dot(foot.lateral);
        s += off.dot(foot.along);
    }
    (s, DVec2::new(lateral, 0.0))
}

/// Detected point: path length, deviation, confidence.
pub(super) type Place = (f64, DVec2, f64);
/// Maximum number of points used per picture.
pub(super) const PLACES: usize = 64;
/// Maximum slope of the seam against the taught one.
const STEEPEST: f64 = 0.3;
/// Maximum bend of a seam within a picture, mm.
const BEND_MM: f64 = 0.05;

/// Returns for each point whether it lies on the line that most of them share. The limit is three standard deviations
/// of `noise_mm` plus the bend of a seam. Returns `None` unless more than half, and at least [`FEWEST`], share one.
pub(super) fn on_one_line(places: &[Place], noise_mm: f64) -> Option<ArrayVec<bool, PLACES>> {
    let off = |a: &Place, slope: f64, p: &Place| (p.1.x - a.1.x - slope * (p.0 - a.0)).abs();
    let is_near = |a: &Place, slope: f64, p: &Place| off(a, slope, p) <= BEND_MM + 3.0 * noise_mm / p.2.max(0.1);
    let apart = (places.len() / 3).max(1);
    let mut best: Option<(usize, &Place, f64)> = None;
    for (i, a) in places.iter().enumerate() {
        for b in places.iter().skip(i + apart) {
            let slope = (b.1.x - a.1.x) / (b.0 - a.0);
            if slope.is_nan() || slope.abs() > STEEPEST {
                continue;
            }
            let count = places.iter().filter(|p| is_near(a, slope, p)).count();
            if best.is_none_or(|(most, ..)| count > most) {
                best = Some((count, a, slope));
            }
        }
    }
    let (count, a, slope) = best?;
    (2 * count > places.len() && count >= FEWEST).then(|| places.iter().map(|p| is_near(a, slope, p)).collect())
}

/// Minimum number of points of a line.
const FEWEST: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Outliers of a line are identified; random points have no line.
    #[test]
    fn most_lie_on_a_line() {
        let mut random = Random::new(8);
        let mut number = || random.within(-1.0, 1.0);
        for case in 0..2000 {
            let (a, b, wild) = (3.0 * number(), 0.2 * number(), case % 5 == 0);
            let out = |k: usize| wild || k % 4 == case % 4;
            let places: Vec<Place> = (0..16)
                .map(|k| {
                    let line = a + b * k as f64 + 0.05 * number();
                    // At least a third of a millimetre off the line, unless all points are random.
                    let far = 5.0 * number();
                    let value = if wild { far } else { line + far + 0.4 * far.signum() };
                    (k as f64, DVec2::new(if out(k) { value } else { line }, 0.0), 1.0)
                })
                .collect();
            let found = on_one_line(&places, 0.03);
            assert_eq!(found.is_none(), wild, "{case}");
            if let Some(found) = found {
                assert!(found.iter().enumerate().all(|(k, near)| *near != out(k)), "{case}: {found:?}");
            }
        }
        assert!(on_one_line(&[], 0.03).is_none());
    }
    use glam::DVec3;

    /// On a ring, for any offset of the gun: the deviation is the point's distance from the ring, the station its
    /// angle.
    #[test]
    fn beside_a_ring() {
        let radius = 150.0;
        let frame = |s: f64| SeamFrame::on_circle(radius, s);
        for i in 0..2000 {
            let t = f64::from(i);
            let (s, along_mm) = (0.2 * t, 5.0 + 15.0 * (0.7 * t).sin().abs());
            let (lateral_mm, carried) = (5.0 * (1.3 * t).sin(), DVec2::new((2.1 * t).sin(), 0.3));
            let here = frame(s);
            let at = here.point + along_mm * here.along + (lateral_mm + carried.x) * here.lateral;
            let from_centre = at - DVec3::new(0.0, radius, 0.0);
            let then = Moment { t_s: 0.0, s_mm: s, slide: carried };
            let (place, found) = located(&frame, &then, &Point { along_mm, lateral_mm, confidence: 1.0 }, 0.7);
            // Lateral is towards the centre.
            assert!((found.x - (radius - from_centre.length())).abs() < 1e-7, "{i}: {found}");
            let angle = from_centre.x.atan2(-from_centre.y);
            assert!((frame(place).point - frame(radius * angle).point).length() < 1e-6, "{i}: {place}");
            assert!(found.y == 0.0);
        }
    }
}
