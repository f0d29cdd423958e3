use crate::path::Path;
use crate::point::Point;
use crate::spread::{Moments, Spread};

const BETWEEN: usize = 7;

/// Statistics of an interpolation; the same for every method, for comparison.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// Number of steps: points less one.
    pub steps: u64,
    /// Straight distance from each point to the next, relative to the wanted step (pulse methods: to the mean). The
    /// shorter step that closes the path is left out. For a pulse method it only shows the number of axes that moved
    /// together; see `per_period` for its speed.
    pub step: Spread,
    /// Straight distance travelled in each whole period, from the positions at its start and end; a pulse method rests
    /// between two pulses. Divided by the period it is the speed along the seam. It has the same reference as `step`;
    /// for the other methods also the same distances. With few pulses a period, single pulses show in it.
    pub per_period: Spread,
    /// Largest normal distance of a point from the true curve, mm.
    pub deviation_max_mm: f64,
    /// Root of the mean square of these distances, mm.
    pub deviation_rms_mm: f64,
    /// Maximum distance of a point of the true curve from the straight step over it, mm: the chord error. The curve is
    /// sampled at seven points between the nearest points of the step's ends, and the maximum of them improved by a
    /// parabola.
    pub chord_error_max_mm: f64,
    /// Sum of all steps, the closing one included, mm.
    pub length_mm: f64,
    /// Length of the true curve, mm.
    pub true_length_mm: f64,
    /// Distance of the last point from the true end, mm.
    pub end_error_mm: f64,
    /// Time of the last point, s.
    pub duration_s: f64,
}

/// Gathers [`Statistics`] from points given one by one; constant memory.
#[derive(Debug, Clone)]
pub struct Tally {
    path: Path,
    true_length: f64,
    period: f64,
    /// Wanted step; none for pulse methods.
    wanted: Option<f64>,
    points: u64,
    last: Option<Point>,
    /// The last step: it counts only once another follows, unless it took a whole period.
    pending: Option<f64>,
    step: Moments,
    /// Period to be sampled next, and the last sample.
    sample: u64,
    sampled: Option<Point>,
    per_period: Moments,
    deviation_max: f64,
    deviation_squares: f64,
    chord_error: f64,
    length: f64,
}

impl Tally {
    pub(crate) fn new(path: Path, true_length: f64, period: f64, wanted: Option<f64>) -> Self {
        Self {
            path,
            true_length,
            period,
            wanted,
            points: 0,
            last: None,
            pending: None,
            step: Moments::default(),
            sample: 0,
            sampled: None,
            per_period: Moments::default(),
            deviation_max: 0.0,
            deviation_squares: 0.0,
            chord_error: 0.0,
            length: 0.0,
        }
    }

    /// Takes in the next point.
    pub fn add(&mut self, point: &Point) {
        self.points += 1;
        // A pulse method's angle is already that of the nearest point; the others' is checked.
        let off = match self.wanted {
            Some(_) => self.path.nearest(point.position).distance_mm,
            None => self.path.point(point.u_rad).distance(point.position),
        };
        self.deviation_max = self.deviation_max.max(off);
        self.deviation_squares += off * off;
        if let Some(last) = self.last {
            // Periods that ended before this point ended at the last one.
            self.sample_until(&last, point.t_s - 1e-6 * self.period);
            let chord = last.position.distance(point.position);
            self.length += chord;
            self.chord_error = self.chord_error.max(chord_error(&self.path, &last, point));
            if let Some(step) = self.pending.take() {
                self.step.add(step);
            }
            if self.wanted.is_none() || point.t_s - last.t_s > (1.0 - 1e-6) * self.period {
                self.step.add(chord);
            } else {
                self.pending = Some(chord);
            }
        }
        self.last = Some(*point);
    }

    /// Samples at `last` the periods that end before `t`.
    fn sample_until(&mut self, last: &Point, t: f64) {
        while self.sample as f64 * self.period < t {
            if let Some(before) = self.sampled {
                self.per_period.add(before.position.distance(last.position));
            }
            self.sampled = Some(*last);
            self.sample += 1;
        }
    }

    /// The statistics of all points so far, as if the last one were the end.
    pub fn finish(mut self) -> Statistics {
        let Some(last) = self.last else {
            return self.result(0.0, 0.0);
        };
        self.sample_until(&last, last.t_s + 1e-6 * self.period);
        self.result(last.position.distance(self.path.point(self.path.end_rad())), last.t_s)
    }

    fn result(&self, end_error_mm: f64, duration_s: f64) -> Statistics {
        Statistics {
            steps: self.points.saturating_sub(1),
            step: self.step.spread(self.wanted),
            per_period: self.per_period.spread(self.wanted),
            deviation_max_mm: self.deviation_max,
            deviation_rms_mm: (self.deviation_squares / self.points.max(1) as f64).sqrt(),
            chord_error_max_mm: self.chord_error,
            length_mm: self.length,
            true_length_mm: self.true_length,
            end_error_mm,
            duration_s,
        }
    }
}

/// Largest distance of the curve between the points' angles from the straight step between the points, mm.
fn chord_error(path: &Path, from: &Point, to: &Point) -> f64 {
    let step = to.position - from.position;
    let square = step.length_squared();
    let distance = |i: usize| {
        let u = from.u_rad + (to.u_rad - from.u_rad) * i as f64 / (BETWEEN + 1) as f64;
        let off = path.point(u) - from.position;
        let along = if square > 0.0 { (off.dot(step) / square).clamp(0.0, 1.0) } else { 0.0 };
        (off - along * step).length()
    };
    let at: [f64; BETWEEN + 2] = std::array::from_fn(distance);
    let best = (1..=BETWEEN).max_by(|l, r| at[*l].total_cmp(&at[*r])).unwrap_or(1);
    let (before, peak, after) = (at[best - 1], at[best], at[best + 1]);
    let bend = 2.0 * peak - before - after;
    if peak >= before && peak >= after && bend > 0.0 { peak + (after - before).powi(2) / (8.0 * bend) } else { peak }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::{AngleRule, EqualStep, Method};
    use crate::request::Request;
    use crate::shape::Shape;
    use glam::DVec2;

    fn statistics(method: Method) -> Statistics {
        Request { method, ..Request::default() }.statistics().unwrap()
    }

    #[test]
    fn the_papers_example_exactly() {
        let s = statistics(Method::Exact(EqualStep::Arc));
        assert_eq!(s.steps, 568);
        assert_eq!(s.step.count, 567);
        assert_eq!(s.per_period.count, 567);
        // Chords are shorter than their arcs by (k dL)^2 / 24; k is at most a / b^2.
        assert!(s.step.max_percent < 0.0 && s.step.min_percent > -1e-4, "{:?}", s.step);
        let sagitta = 0.05f64.powi(2) / 8.0 * 20.0 / 256.0;
        assert!((s.chord_error_max_mm / sagitta - 1.0).abs() < 1e-3, "{}", s.chord_error_max_mm);
        assert!(s.deviation_max_mm < 1e-14 && s.end_error_mm < 1e-14);
        assert!((s.duration_s - 28.361_667_888_974_5 / 5.0).abs() < 1e-12);
        let s = statistics(Method::Exact(EqualStep::Chord));
        assert!(s.step.max_percent.abs().max(s.step.min_percent.abs()) < 1e-10, "{:?}", s.step);
    }

    #[test]
    fn a_step_and_its_period_are_one_without_pulses() {
        for rule in [AngleRule::Printed, AngleRule::Polar, AngleRule::Tangent] {
            let s = statistics(Method::EccentricAngle(rule));
            assert_eq!(s.step, s.per_period);
        }
    }

    #[test]
    fn speed_of_the_pulse_methods() {
        let s = statistics(Method::PointByPoint);
        assert!((s.step.max_mm - 0.001).abs() < 1e-12 && (s.step.min_mm - 0.001).abs() < 1e-12);
        assert!((s.duration_s - 36.0 / 5.0).abs() < 1e-9, "{}", s.duration_s);
        assert!(s.per_period.max_mm <= 0.0501 && s.per_period.min_mm > 0.034, "{:?}", s.per_period);
        let s = statistics(Method::ComparisonIntegral);
        assert!(s.per_period.max_mm < 0.0711 && s.per_period.min_mm >= 0.0499, "{:?}", s.per_period);
        let s = statistics(Method::Dda);
        assert!((s.duration_s - 28.361_667_888_974_5 / 5.0).abs() < 0.02);
    }

    #[test]
    fn chord_error_of_a_coarse_circle_is_its_sagitta() {
        let shape =
            Shape::Ellipse { a_mm: 10.0, b_mm: 10.0, start_mm: DVec2::new(10.0, 0.0), end_mm: None, clockwise: false };
        let method = Method::Exact(EqualStep::Arc);
        let request = Request { shape, method, speed_mm_s: 5.0, period_s: 1.0, ..Request::default() };
        let s = request.statistics().unwrap();
        assert!((s.chord_error_max_mm - 10.0 * (1.0 - 0.25f64.cos())).abs() < 1e-5, "{}", s.chord_error_max_mm);
    }

    #[test]
    fn nothing_and_one_point() {
        let tally = Request::default().tally().unwrap();
        assert_eq!(tally.clone().finish().steps, 0);
        let mut tally = tally;
        tally.add(&Request::default().interpolate().unwrap().next().unwrap());
        let s = tally.finish();
        assert_eq!((s.steps, s.step.count), (0, 0));
        assert!(s.step.mean_mm.is_nan());
    }
}
