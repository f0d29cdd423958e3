use crate::lead::{Moment, SeamFrame};
use arrayvec::ArrayVec;
use glam::DVec2;

/// A place of the joint's midline in a frame, mm in the torch's frame: the beam that is not deflected is its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Ahead along the seam.
    pub along_mm: f64,
    /// To the side to which lateral corrections count.
    pub lateral_mm: f64,
    /// 0 to 1.
    pub confidence: f64,
}

/// The midline that was found in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Picture<'a> {
    /// When the frame was taken, on average, s, on the cell's clock.
    pub exposed_s: f64,
    /// By how much the work lies higher than it was taught, as focus measured it on the beam's axis, mm; 0 if nothing did:
    /// then a seam whose frame turns is seen beside where it is.
    pub height_mm: f64,
    /// From the nearest to the farthest.
    pub points: &'a [Point],
}

/// What became of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Taken {
    /// Points that are used.
    pub used: u32,
    /// Points that are not what was expected.
    pub gated: u32,
    /// Points outside of the zone or of too little confidence.
    pub left_out: u32,
    /// Why none is used at all.
    pub refused: Option<crate::lead::Refusal>,
}

/// A nominal seam by path length.
pub(super) type Course<'a> = &'a (dyn Fn(f64) -> SeamFrame + Sync);

/// Steps in which the foot of a point is found: each leaves of the error the part that its distance is of the seam's radius.
const STEPS: usize = 6;

/// Path length of the place of the nominal seam that is nearest to a point, and the seam's deviation there. The gun was
/// carried aside by `then.slide`. A frame is flat: the point is taken to be `height` mm above the nominal seam.
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

/// A place that was seen: path length, deviation, confidence.
pub(super) type Place = (f64, DVec2, f64);
/// Most places of a picture that are used.
pub(super) const PLACES: usize = 64;
/// Steepest seam against the taught one.
const STEEPEST: f64 = 0.3;
/// What a seam bends within a picture, mm.
const BEND_MM: f64 = 0.05;

/// Whether each place lies on the line that most of them lie on: within three standard deviations of `noise_mm`, and the bend
/// of a seam. None if fewer than half of them lie on one: that is no joint.
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

/// Fewest places that make a line.
const FEWEST: usize = 4;

#[cfg(test)]
mod tests {
    use super::*;
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::{Rng, SeedableRng};

    /// Of a line with outliers these are told, and anything is no line.
    #[test]
    fn most_lie_on_a_line() {
        let mut random = Pcg64Mcg::seed_from_u64(8);
        let mut number = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0;
        for case in 0..2000 {
            let (a, b, wild) = (3.0 * number(), 0.2 * number(), case % 5 == 0);
            let out = |k: usize| wild || k % 4 == case % 4;
            let places: Vec<Place> = (0..16)
                .map(|k| {
                    let line = a + b * k as f64 + 0.05 * number();
                    // A third of a millimetre away at least, unless anything goes.
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

    /// On a ring that is shifted in its plane, wherever the gun was carried: the deviation is the distance of the point from
    /// the ring, the place its angle.
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
