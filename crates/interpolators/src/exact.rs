use crate::error::Error;
use crate::method::EqualStep;
use crate::path::Path;
use crate::point::Point;
use glam::DVec3;
use seamwright_geometry::{ByLength, Curve};

/// Minimum remainder that gets its own step, as a fraction of a step.
const NO_REMAINDER: f64 = 1e-10;

/// Maximum number of approaches to the next point; more than a few dozen are needed only if the curve touches the
/// distance without crossing it.
const APPROACHES: usize = 10_000;

/// Equal steps along the path; see [`EqualStep`].
pub(crate) struct Exact {
    path: ByLength<Path>,
    equal: EqualStep,
    step: f64,
    period: f64,
    /// Number of the last point and its distance along the path; none before the start and after the end.
    last: Option<(u64, f64, DVec3)>,
    started: bool,
}

impl Exact {
    pub(crate) fn new(path: &Path, equal: EqualStep, step: f64, period: f64) -> Result<Self, Error> {
        let by_length = path.by_length((1e-11 * step).min(seamwright_geometry::DEFAULT_ACCURACY_MM))?;
        Ok(Self { path: by_length, equal, step, period, last: None, started: false })
    }

    fn point(&self, periods: f64, travelled: f64) -> Point {
        let path = self.path.curve();
        let u_rad = path.angle(travelled);
        Point { t_s: periods * self.period, u_rad, position: path.point(u_rad) }
    }

    /// Distance along the path and travelled angle of the next point; none if the end is nearer.
    fn next_by_arc(&self, number: u64) -> Option<(f64, f64)> {
        let along = (number + 1) as f64 * self.step;
        (along < self.path.length() - NO_REMAINDER * self.step).then(|| (along, self.path.parameter(along)))
    }

    /// Distance along the path and travelled angle of the first point a step away from the last one at `from`.
    ///
    /// The distance of the curve from a point never grows faster than the length along it. So advancing by the missing
    /// distance never passes the first point at the wanted distance. The missing distance shrinks each time, by a
    /// factor of 1 - cos(angle between curve and chord).
    fn next_by_chord(&self, along: f64, from: DVec3) -> Option<(f64, f64)> {
        let path = self.path.curve();
        let end = self.path.length() - NO_REMAINDER * self.step;
        let enough = (1e-13 * self.step).max(2.0 * f64::EPSILON * path.size());
        let mut along = along + self.step;
        for _ in 0..APPROACHES {
            if along >= end {
                return None;
            }
            let missing = self.step - Curve::point(path, self.path.parameter(along)).distance(from);
            if missing <= enough {
                break;
            }
            along += missing;
        }
        // The inverse of the length has its own rounding: two steps of Newton's method on the angle itself.
        let mut travelled = self.path.parameter(along);
        for _ in 0..2 {
            let jet = path.jet(travelled);
            let chord = jet.point - from;
            let growth = chord.dot(jet.d1) / chord.length();
            let change = (self.step - chord.length()) / growth;
            let small = 1e-6 * self.step / jet.d1.length();
            if growth > 0.0 && change.abs() < small {
                travelled += change;
            }
        }
        Some((along, travelled))
    }
}

impl Iterator for Exact {
    type Item = Point;

    fn next(&mut self) -> Option<Point> {
        if !self.started {
            self.started = true;
            let start = self.point(0.0, 0.0);
            self.last = Some((0, 0.0, start.position));
            return Some(start);
        }
        let (number, along, from) = self.last.take()?;
        let next = match self.equal {
            EqualStep::Arc => self.next_by_arc(number),
            EqualStep::Chord => self.next_by_chord(along, from),
        };
        let Some((along_next, travelled)) = next else {
            let end = self.point(0.0, self.path.curve().span_rad());
            let rest = match self.equal {
                EqualStep::Arc => self.path.length() - along,
                EqualStep::Chord => end.position.distance(from),
            };
            let t_s = self.period * (number as f64 + (rest / self.step).min(1.0));
            return Some(Point { t_s, ..end });
        };
        let point = self.point((number + 1) as f64, travelled);
        self.last = Some((number + 1, along_next, point.position));
        Some(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Method;
    use crate::request::Request;
    use crate::shape::Shape;
    use crate::testing::{Random, arc};
    use glam::DVec2;

    fn points(shape: Shape, equal: EqualStep, step: f64) -> (Path, Vec<Point>) {
        let request = Request {
            shape,
            method: Method::Exact(equal),
            speed_mm_s: step / 0.01,
            period_s: 0.01,
            pulse_mm: f64::NAN,
        };
        let run = request.interpolate().unwrap_or_else(|e| panic!("{shape:?} {step}: {e:?}"));
        (run.path().clone(), run.collect())
    }

    /// A shape with a valid step, mostly short but sometimes of maximum length.
    fn case(random: &mut Random) -> (Shape, f64) {
        loop {
            let shape = if random.unit() < 0.5 { random.ellipse(0.5, 50.0) } else { random.saddle(5.0, 100.0, 0.98) };
            let path = shape.path().unwrap();
            let length = path.length_mm().unwrap();
            let limit = length.min(length / path.span_rad() * std::f64::consts::TAU / 8.0);
            let step = random.log(3e-3, 1.0) * limit;
            if length / step < 3000.0 {
                return (shape, step);
            }
        }
    }

    #[test]
    fn every_full_step_has_the_same_length() {
        let mut random = Random::new(3);
        for _ in 0..150 {
            let (shape, step) = case(&mut random);
            let (path, points) = points(shape, EqualStep::Arc, step);
            let travelled = |p: &Point| path.direction() * (p.u_rad - path.start_rad());
            let lengths: Vec<f64> = points.windows(2).map(|w| arc(&path, travelled(&w[0]), travelled(&w[1]))).collect();
            let (last, full) = lengths.split_last().unwrap();
            for length in full {
                assert!((length / step - 1.0).abs() < 1e-9, "{shape:?} {step}: {length}");
            }
            assert!(*last > 0.0 && *last < step * (1.0 + 1e-9));
            let whole = arc(&path, 0.0, path.span_rad());
            assert!((lengths.iter().sum::<f64>() / whole - 1.0).abs() < 1e-12);
            assert!(points[points.len() - 1].position.distance(path.point(path.end_rad())) < 1e-15);
            assert!((points[points.len() - 1].t_s - whole / (step / 0.01)).abs() < 1e-9);
        }
    }

    #[test]
    fn steps_of_a_long_path() {
        // 2.3 million steps of 0.05 mm around a large part.
        let shape = Shape::Ellipse {
            a_mm: 20_000.0,
            b_mm: 16_000.0,
            start_mm: DVec2::new(0.0, 16_000.0),
            end_mm: None,
            clockwise: false,
        };
        let request = Request { shape, ..Request::default() };
        let run = request.interpolate().unwrap();
        let path = run.path().clone();
        let mut worst: f64 = 0.0;
        let mut last: Option<Point> = None;
        let mut steps = 0.0;
        for p in run.take(300_000) {
            steps += 1.0;
            if let Some(l) = last {
                worst =
                    worst.max((arc(&path, l.u_rad - path.start_rad(), p.u_rad - path.start_rad()) / 0.05 - 1.0).abs());
            }
            last = Some(p);
        }
        assert!(steps > 1e5 && worst < 1e-14 * 2.27e6, "{worst}");
    }

    #[test]
    fn every_full_chord_is_the_same() {
        let mut random = Random::new(4);
        for _ in 0..300 {
            let (shape, step) = case(&mut random);
            let (path, points) = points(shape, EqualStep::Chord, step);
            let bound = 1e-12 + 1e-15 * path.size() / step;
            let chords: Vec<f64> = points.windows(2).map(|w| w[0].position.distance(w[1].position)).collect();
            let (last, full) = chords.split_last().unwrap();
            for chord in full {
                assert!((chord / step - 1.0).abs() < bound, "{shape:?} {step}: {}", chord / step - 1.0);
            }
            assert!(*last < step * (1.0 + 1e-9), "{shape:?} {step}: {last}");
            assert!(points[points.len() - 1].position.distance(path.point(path.end_rad())) < 1e-15);
            // Points of the curve between two points are less than a step away: each point is the first at the
            // distance.
            for w in points.windows(2) {
                for i in 1..50 {
                    let u = w[0].u_rad + (w[1].u_rad - w[0].u_rad) * f64::from(i) / 50.0;
                    assert!(path.point(u).distance(w[0].position) < step * (1.0 + 1e-9), "{shape:?} {step}");
                }
            }
        }
    }

    #[test]
    fn chords_past_an_end_sharper_than_the_step() {
        // The radius of curvature at (20, 0) is 5 um, the step 50 um.
        let shape =
            Shape::Ellipse { a_mm: 20.0, b_mm: 0.01, start_mm: DVec2::new(0.0, 0.01), end_mm: None, clockwise: true };
        let (path, points) = points(shape, EqualStep::Chord, 0.05);
        assert_eq!(points.len(), 1 + (path.length_mm().unwrap() / 0.05).ceil() as usize);
        for w in points[..points.len() - 1].windows(2) {
            assert!((w[0].position.distance(w[1].position) / 0.05 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_length_of_whole_steps_has_no_empty_last_step() {
        let path = Shape::ELLIPSE_2015.path().unwrap();
        let step = path.length_mm().unwrap() / 500.0;
        for equal in [EqualStep::Arc, EqualStep::Chord] {
            let (_, points) = points(Shape::ELLIPSE_2015, equal, step);
            let last = points[500].position.distance(points[499].position);
            assert_eq!(points.len(), 501);
            assert!(last > 0.99 * step && last <= step);
        }
    }
}
