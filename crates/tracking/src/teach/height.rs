use super::line::{RawPoint, Source, TaughtLine};
use super::note::EyeNote;
use glam::DVec3;
use nalgebra::{Matrix3, Vector3};

/// Frames within this way to both sides tell the height at a place, mm: some two steps of the crawl.
const REACH_MM: f64 = 16.0;
/// Fewest frames that do; where there are fewer the reach is widened.
const FEWEST: usize = 3;

/// `line` with its heights between frames as all frames together measured them.
///
/// A frame measures the height at one place, on its optical axis, and its points were taken as if the part lay as high
/// above its known shape all over the frame: wrong by the part's slope times the distance from the axis. Here each point
/// goes along the ray in which it was seen to the height that the frames about it tell: the parabola by way that is
/// nearest to their measurements. The operator's points stay, and where nothing was measured all do.
pub fn levelled(line: &TaughtLine, notes: &[EyeNote]) -> TaughtLine {
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

/// Where along the line the optical axis of a frame met the work.
fn way(line: &TaughtLine, note: &EyeNote) -> f64 {
    let off = line.at(note.way).map_or(DVec3::ZERO, |at| note.eye - at);
    note.way + line.direction(note.way, REACH_MM).map_or(0.0, |along| along.dot(off))
}

/// The height at `way`, of measurements (way, height) in order; none without any.
fn at(heights: &[(f64, f64)], way: f64) -> Option<f64> {
    let (first, last) = (heights.first()?, heights.last()?);
    // Beyond the first and the last it is as there.
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

/// The value at `way` of the parabola nearest to `heights`, those near it first.
fn parabola(heights: &[(f64, f64)], way: f64, reach: f64) -> f64 {
    // What two measurements leave open stays straight, what one does level.
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
    use super::super::FrameEnd;
    use super::*;

    /// A slope that frames every 8 mm measure: each point was put at its frame's height, and comes down the ray to the
    /// slope.
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
                notes.push(EyeNote { eye, raised_mm, measured, way, rows, confidence, overlap_mm, end, agrees });
                for k in 0..80 {
                    let x = way - 4.0 + 0.1 * f64::from(k);
                    // What the ray that meets the slope at x meets at the frame's height.
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
            // Where nothing was measured nothing changes.
            notes.iter_mut().for_each(|note| note.measured = false);
            assert_eq!(levelled(&line, &notes), line);
        }
    }
}
