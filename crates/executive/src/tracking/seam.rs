use glam::DVec3;
use seamwright_program::{TorchPath, line_by_difference};
use seamwright_tracking::beam::DeviationRecord;
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
            let (point, along) = line_by_difference(|s| path.line_point(s), s, length_mm);
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

/// Position of a pass on its seam.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PassPosition {
    /// Start of the pass on the seam, mm.
    pub begin_mm: f64,
    /// True if the pass runs against the seam.
    pub reverse: bool,
    /// Circumference of a closed seam, mm: beyond it the seam repeats.
    pub round_mm: Option<f64>,
}

impl PassPosition {
    /// Returns the position on the seam at path length `s` of the pass, mm.
    #[must_use]
    pub fn place(&self, s: f64) -> f64 {
        let place = self.begin_mm + if self.reverse { -s } else { s };
        self.round_mm.map_or(place, |round| place.rem_euclid(round))
    }

    /// Converts deviations found by a pass to the seam's path length.
    #[must_use]
    pub fn on_seam(&self, found: &DeviationRecord) -> DeviationRecord {
        if self.reverse { found.turned(self.begin_mm) } else { found.moved(self.begin_mm) }
    }

    /// Converts deviations of a seam to the path length of a pass.
    #[must_use]
    pub fn of_pass(&self, stored: &DeviationRecord) -> DeviationRecord {
        if self.reverse { stored.turned(self.begin_mm) } else { stored.moved(-self.begin_mm) }
    }
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
