//! True distance of a taught line from the seam, known only in a simulation.

use seamwright_teaching::{LinePoint, SeamLine};

/// Deviations of a taught line from the actual seam, mm.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Truth {
    /// RMS on the surface, across the seam.
    pub across_rms: f64,
    /// Maximum on the surface, across the seam.
    pub across_max: f64,
    /// RMS out of the surface: the error of the measured or assumed height.
    pub height_rms: f64,
    /// Maximum out of the surface.
    pub height_max: f64,
    /// Maximum distance from the seam on bridged stretches, which were not seen.
    pub bridged_max: f64,
    /// Length of the bridged stretches.
    pub bridged: f64,
    /// Distance of the line's start from the seam's start; 0 for a closed seam.
    pub start: f64,
    /// Distance of the line's end from the seam's end; for a closed seam, from the line's start.
    pub end: f64,
}

/// Measures a taught line against the seam.
pub fn truth(actual: &SeamLine, line: &[LinePoint]) -> Truth {
    let mut t = Truth::default();
    let (mut seen, mut far) = (0u32, f64::INFINITY);
    for (i, p) in line.iter().enumerate() {
        let Some(foot) = actual.foot(p.point) else {
            far = 0.0;
            continue;
        };
        let off = p.point - foot.at.point;
        let across = off.dot(foot.at.normal.cross(foot.along)).abs();
        let height = off.dot(foot.at.normal).abs();
        if p.confidence > 0.0 {
            seen += 1;
            t.across_rms += across * across;
            t.height_rms += height * height;
            (t.across_max, t.height_max) = (t.across_max.max(across), t.height_max.max(height));
        } else {
            t.bridged_max = t.bridged_max.max(off.length());
            t.bridged += i.checked_sub(1).map_or(0.0, |k| p.way - line[k].way);
        }
    }
    let mean = |sum: f64| (sum / f64::from(seen.max(1))).sqrt();
    (t.across_rms, t.height_rms) = (mean(t.across_rms), mean(t.height_rms));
    if far < f64::INFINITY || seen == 0 {
        // A point far from the seam invalidates the result.
        (t.across_max, t.bridged_max) = (f64::INFINITY, f64::INFINITY);
    }
    if let (Some(first), Some(last)) = (line.first(), line.last()) {
        let ends = [0.0, actual.length()].map(|way| actual.at(way).0.point);
        (t.start, t.end) = match actual.is_closed() {
            true => (0.0, first.point.distance(last.point)),
            false => (first.point.distance(ends[0]), last.point.distance(ends[1])),
        };
    }
    t
}
