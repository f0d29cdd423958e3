use crate::frame_note::CameraNote;
use crate::taught_line::{RawPoint, Source, TaughtLine};
use glam::DVec3;
use nalgebra::{Matrix3, Vector3};

/// Reach to both sides for the height at a position, mm: about two steps of the crawl.
const REACH_MM: f64 = 16.0;
/// Minimum number of frames in reach; with fewer the reach is widened.
const FEWEST: usize = 3;

/// Returns `line` with heights between frames fitted to the measurements of all frames.
///
/// A frame measures the height only on its optical axis. Its points assume the same height above the known shape all
/// over the frame, wrong by the part's slope times the distance from the axis. Each point is moved along its viewing
/// ray to the height of the least-squares parabola through the frames around it. The operator's points stay, and
/// without measured heights all points do.
pub fn levelled(line: &TaughtLine, notes: &[CameraNote]) -> TaughtLine {
    let measured = notes.iter().filter(|note| note.measured && note.agrees);
    let mut heights: Vec<(f64, f64)> = measured.map(|note| (way(line, note), note.raised_mm)).collect();
    heights.sort_by(|a, b| a.0.total_cmp(&b.0));
    let to = |way: f64, p: &RawPoint| match (p.source, notes.get(p.frame), at(&heights, way)) {
        (Source::Eye, Some(note), Some(height)) => {
            let slope = p.ray.dot(p.normal).min(-0.2);
            p.point + (height - note.raised_mm) / slope * p.ray
        }
        _ => p.point,
    };
    line.moved(to)
}

/// Returns the distance along the line at which a frame's optical axis met the work, mm.
fn way(line: &TaughtLine, note: &CameraNote) -> f64 {
    let off = line.at(note.way).map_or(DVec3::ZERO, |at| note.eye - at);
    note.way + line.direction(note.way, REACH_MM).map_or(0.0, |along| along.dot(off))
}

/// Returns the height at `way` from sorted measurements (way, height); `None` without any.
fn at(heights: &[(f64, f64)], way: f64) -> Option<f64> {
    let (first, last) = (heights.first()?, heights.last()?);
    // Beyond the first and the last the height is constant.
    let way = way.clamp(first.0, last.0);
    let mut reach = REACH_MM;
    loop {
        let from = heights.partition_point(|h| h.0 <= way - reach);
        let to = heights.partition_point(|h| h.0 < way + reach);
        if to - from >= FEWEST || to - from == heights.len() {
            return Some(parabola(&heights[from..to], way, reach));
        }
        reach *= 1.5;
    }
}

/// Returns the value at `way` of the least-squares parabola through `heights`, weighted by nearness.
fn parabola(heights: &[(f64, f64)], way: f64, reach: f64) -> f64 {
    // Regularised: two measurements give a straight line, one a constant.
    let mut normal = Matrix3::from_diagonal(&Vector3::new(0.0, 1e-9, 1e-9));
    let (mut right, mut sum, mut weights) = (Vector3::zeros(), 0.0, 0.0);
    for (at, height) in heights {
        let u = (at - way) / reach;
        let weight = (1.0 - u * u).max(1e-6).powi(2);
        let basis = Vector3::new(1.0, u, u * u);
        normal += weight * basis * basis.transpose();
        right += weight * *height * basis;
        (sum, weights) = (sum + weight * height, weights + weight);
    }
    normal.cholesky().map_or(sum / weights, |c| c.solve(&right)[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::work_shape::FrameEnd;

    /// On a slope measured every 8 mm, points placed at their frame's height move along the ray onto the slope.
    #[test]
    fn points_between_frames_come_to_the_slope() {
        for (slope, bend, lean) in [(0.05, 0.0, 0.0), (-0.08, 0.0, 0.3), (0.02, 0.0005, -0.2)] {
            let height = |x: f64| 0.4 + slope * x + bend * x * x;
            let ray = DVec3::new(0.0, lean, -1.0).normalize();
            let (mut line, mut notes) = (TaughtLine::default(), Vec::new());
            for frame in 0..8 {
                let (way, raised_mm) = (8.0 * frame as f64, height(8.0 * frame as f64));
                let eye = DVec3::new(way, 0.0, raised_mm);
                let (confidence, overlap_mm, end) = (1.0, None, FrameEnd::LeftImage);
                let (rows, measured, agrees) = (80, frame != 3, true);
                notes.push(CameraNote { eye, raised_mm, measured, way, rows, confidence, overlap_mm, end, agrees });
                for k in 0..80 {
                    let x = way - 4.0 + 0.1 * f64::from(k);
                    // Intersection of the frame's height with the ray that meets the slope at x.
                    let point = DVec3::new(x, 0.0, height(x)) + (height(x) - raised_mm) / ray.z.abs() * ray;
                    let source = if k == 7 { Source::Operator } else { Source::Eye };
                    line.push(RawPoint { point, normal: DVec3::Z, ray, confidence, frame, source }, Some(DVec3::X));
                }
            }
            let level = levelled(&line, &notes);
            for (before, p) in line.points().iter().zip(level.points()) {
                let away = (p.point.z - height(p.point.x)).abs() + p.point.y.abs();
                let inside = (0.0..=56.0).contains(&p.point.x);
                assert!(p.source == Source::Operator || !inside || away < 2e-3, "{slope}: {} {away}", p.point);
                assert!(p.source == Source::Eye || p.point == before.point);
            }
            // Without measured heights the line is unchanged.
            notes.iter_mut().for_each(|note| note.measured = false);
            assert_eq!(levelled(&line, &notes), line);
        }
    }
}
