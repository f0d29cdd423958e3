use super::world::Placement;
use super::{Displacement, Leg, SensorModel};
use glam::{DVec2, DVec3};
use seamwright_program::{TorchPath, line_by_difference};
use seamwright_tracking::lead::SeamFrame;

/// A taught seam: the torch's frame by path length, also some way beyond both ends.
pub struct Seam {
    /// Length, mm.
    pub length_mm: f64,
    /// Frame by path length.
    pub frame: Box<dyn Fn(f64) -> SeamFrame + Send + Sync>,
    /// Circumference of a closed seam, mm: less than the length where the weld overlaps its start.
    pub round_mm: Option<f64>,
}

impl Seam {
    /// Creates a straight seam along x; lateral is y, height z.
    #[must_use]
    pub fn straight(length_mm: f64) -> Self {
        let frame = |s: f64| SeamFrame { point: DVec3::X * s, along: DVec3::X, lateral: DVec3::Y, height: DVec3::Z };
        Self { length_mm, frame: Box::new(frame), round_mm: None }
    }

    /// Creates an arc of `radius_mm` in the plane of lateral (y, towards the centre) or of height (z, `upright`).
    #[must_use]
    pub fn arc(length_mm: f64, radius_mm: f64, upright: bool) -> Self {
        let (side, other) = if upright { (DVec3::Z, DVec3::NEG_Y) } else { (DVec3::Y, DVec3::Z) };
        let frame = move |s: f64| {
            let (sin, cos) = (s / radius_mm).sin_cos();
            let along = DVec3::X * cos + side * sin;
            let inwards = side * cos - DVec3::X * sin;
            let point = radius_mm * (sin * DVec3::X + (1.0 - cos) * side);
            let (lateral, height) = if upright { (-other, inwards) } else { (inwards, other) };
            SeamFrame { point, along, lateral, height }
        };
        Self { length_mm, frame: Box::new(frame), round_mm: None }
    }

    /// Creates the seam of a torch's path, with the frame of its line every half millimetre. Height is opposite to
    /// the torch's direction, square to the way. A closed seam goes round; others continue straight beyond their
    /// ends.
    #[must_use]
    pub fn along(path: &dyn TorchPath) -> Self {
        const STEP_MM: f64 = 0.5;
        let length_mm = path.length();
        let count = (length_mm / STEP_MM).ceil().clamp(2.0, 1e6);
        let frame = |i: u32| {
            let s = length_mm * f64::from(i) / count;
            // At a corner the mean of both directions.
            let (point, along) = line_by_difference(|s| path.line(s).0, s, length_mm);
            let up = -path.pose(s).direction;
            let height = (up - up.dot(along) * along).normalize_or(along.any_orthonormal_vector());
            SeamFrame { point, along, lateral: height.cross(along), height }
        };
        let frames: Vec<SeamFrame> = (0..=count as u32).map(frame).collect();
        let round_mm = round(&frames, length_mm / count);
        let at = move |s: f64| {
            let s = round_mm.map_or(s, |round| if (0.0..=length_mm).contains(&s) { s } else { s.rem_euclid(round) });
            let place = s / length_mm * count;
            let i = (place.max(0.0) as usize).min(frames.len() - 2);
            between(&frames[i], &frames[i + 1], place - i as f64, length_mm / count)
        };
        Self { length_mm, frame: Box::new(at), round_mm }
    }
}

/// Circumference of a seam with these frames `step` mm apart, if it returns to its start.
fn round(frames: &[SeamFrame], step: f64) -> Option<f64> {
    let first = &frames[0];
    let back = |frame: &SeamFrame| {
        let off = frame.point - first.point;
        let ahead = off.dot(first.along);
        let beside = (off - ahead * first.along).length();
        (beside < 1e-2 && ahead.abs() <= 0.51 * step && frame.along.dot(first.along) > 0.999).then_some(ahead)
    };
    let half = frames.len() / 2;
    frames.iter().enumerate().skip(half.max(1)).find_map(|(i, frame)| Some(i as f64 * step - back(frame)?))
}

/// Interpolates between two frames `step` mm apart by Hermite's cubic; extrapolates straight.
fn between(a: &SeamFrame, b: &SeamFrame, part: f64, step: f64) -> SeamFrame {
    if !(0.0..=1.0).contains(&part) {
        let (end, way) = if part < 0.0 { (a, part) } else { (b, part - 1.0) };
        return SeamFrame { point: end.point + way * step * end.along, ..*end };
    }
    let (p, q) = (part, 1.0 - part);
    let point = q * q * (1.0 + 2.0 * p) * a.point
        + p * p * (1.0 + 2.0 * q) * b.point
        + step * p * q * (q * a.along - p * b.along);
    let along = a.along.lerp(b.along, p).normalize_or(a.along);
    let up = a.height.lerp(b.height, p);
    let height = (up - up.dot(along) * along).normalize_or(a.height);
    SeamFrame { point, along, lateral: height.cross(along), height }
}

/// One head in a scenario.
pub struct HeadScene {
    /// Taught seam.
    pub seam: Seam,
    /// Displacement of its seam.
    pub displacement: Displacement,
    /// Placement of its part.
    pub placement: Placement,
    /// Its sensor.
    pub sensor: SensorModel,
    /// Position of the torch from which its slide is stuck, mm.
    pub stuck_mm: Option<f64>,
}

impl HeadScene {
    /// Creates a head on a straight seam, with the usual sensor 20 mm ahead.
    #[must_use]
    pub fn straight(length_mm: f64, displacement: Displacement) -> Self {
        Self::on(Seam::straight(length_mm), displacement)
    }

    /// Creates a head on a seam, with the usual sensor 20 mm ahead.
    #[must_use]
    pub fn on(seam: Seam, displacement: Displacement) -> Self {
        let sensor = SensorModel::usual(20.0);
        Self { seam, displacement, placement: Placement::RIGHT, sensor, stuck_mm: None }
    }
}

/// A weld to be tracked.
pub struct Scenario {
    /// Name in words.
    pub name: String,
    /// Maximum speed, to which the papers' buffers are matched, mm/s.
    pub speed_mm_s: f64,
    /// Way of the torch; it starts a lead before the seam.
    pub legs: Vec<Leg>,
    /// One head or two.
    pub heads: Vec<HeadScene>,
}

impl Scenario {
    /// Creates a weld from end to end at one speed.
    #[must_use]
    pub fn steady(name: &str, speed_mm_s: f64, heads: Vec<HeadScene>) -> Self {
        let length = heads.iter().map(|h| h.seam.length_mm).fold(f64::INFINITY, f64::min);
        Self { name: name.to_owned(), speed_mm_s, legs: vec![Leg::To(length, speed_mm_s)], heads }
    }
}

/// Displaces the seams of both heads in opposite ways.
pub(super) fn opposite(displacement: &Displacement) -> [Displacement; 2] {
    let mirrored = displacement.parts.iter().map(|part| part.scaled(DVec2::new(-1.0, 0.7))).collect();
    [displacement.clone(), Displacement { parts: mirrored, tacks: displacement.tacks.clone() }]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_right_handed_and_along_is_the_way() {
        for seam in [Seam::straight(100.0), Seam::arc(100.0, 300.0, false), Seam::arc(100.0, 300.0, true)] {
            for i in -20..120 {
                let s = f64::from(i);
                let frame = (seam.frame)(s);
                assert!(frame.along.cross(frame.lateral).distance(frame.height) < 1e-12);
                let way = ((seam.frame)(s + 1e-5).point - (seam.frame)(s - 1e-5).point) / 2e-5;
                assert!(way.distance(frame.along) < 1e-8, "{way} {}", frame.along);
            }
        }
    }
}
