//! Deviation of a span from the points of its run.

use super::run::Run;
use super::track::Track;
use glam::DVec3;

/// Maximum radius of an arc, mm: beyond it a printed centre no longer determines the arc.
pub(super) const MAX_RADIUS_MM: f64 = 1e7;

/// A line or an arc from the origin of a run to its other end.
#[derive(Debug, Clone, Copy)]
pub(super) enum Course {
    Line,
    Arc(Bow),
}

/// An arc, in the frame of a run.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bow {
    /// Unit tangent at the origin.
    tangent: DVec3,
    /// Unit vector from the origin to the centre.
    pub(super) inward: DVec3,
    /// Unit normal about which it goes counter-clockwise from the origin.
    pub(super) normal: DVec3,
    /// mm.
    pub(super) radius: f64,
    /// rad.
    sweep: f64,
}

impl Bow {
    /// The arc along the run that starts in this direction; none if it is nearly straight.
    pub(super) fn new(run: &Run, tangent: DVec3) -> Option<Self> {
        let across = tangent.cross(run.way);
        let sine = across.length();
        let radius = 0.5 * run.length / sine;
        // False for a NaN radius too.
        (radius <= MAX_RADIUS_MM).then(|| {
            let normal = across / sine;
            let sweep = 2.0 * sine.atan2(tangent.dot(run.way));
            Self { tangent, inward: normal.cross(tangent), normal, radius, sweep }
        })
    }

    /// The point at an angle from the origin, from the origin.
    fn point(&self, angle: f64) -> DVec3 {
        let half = 0.5 * angle;
        2.0 * self.radius * half.sin() * (half.cos() * self.tangent + half.sin() * self.inward)
    }
}

/// The point of a span nearest to a given point: path length from the origin, and the distance (mm).
#[derive(Debug, Clone, Copy)]
struct Foot {
    at: f64,
    away: f64,
}

impl Course {
    fn length(&self, run: &Run) -> f64 {
        match self {
            Self::Line => run.length,
            Self::Arc(bow) => bow.radius * bow.sweep,
        }
    }

    fn foot(&self, run: &Run, x: DVec3) -> Foot {
        match self {
            Self::Line => {
                let at = x.dot(run.way).clamp(0.0, run.length);
                Foot { at, away: (x - at * run.way).length() }
            }
            Self::Arc(bow) => {
                let (along, inward) = (x.dot(bow.tangent), x.dot(bow.inward));
                let angle = along.atan2(bow.radius - inward);
                let angle = if angle < 0.0 { angle + std::f64::consts::TAU } else { angle };
                if angle <= bow.sweep {
                    // The distance from the circle without the difference of two large numbers.
                    let out = (along * along + inward * (inward - 2.0 * bow.radius))
                        / (along.hypot(bow.radius - inward) + bow.radius);
                    return Foot { at: bow.radius * angle, away: out.hypot(x.dot(bow.normal)) };
                }
                let (from_start, from_end) = (x.length(), (x - run.length * run.way).length());
                if from_start <= from_end {
                    Foot { at: 0.0, away: from_start }
                } else {
                    Foot { at: self.length(run), away: from_end }
                }
            }
        }
    }
}

/// Reason why a span does not represent its run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Fault {
    /// A point is too far away, or the span bulges too far between two points.
    Far,
    /// The points turn back from this one on.
    Back(usize),
    /// A further column leaves its tolerance.
    Axis,
}

/// Maximum distance (mm) of the run's points from the span. Succeeds if the span keeps all conditions of the module's
/// documentation.
pub(super) fn measure(track: &Track, run: &Run, course: &Course) -> Result<f64, Fault> {
    let near = track.near * (1.0 + 1e-12);
    let whole = course.length(run);
    let (mut greatest, mut furthest) = (0.0f64, (0.0, run.first));
    let mut before = Foot { at: 0.0, away: 0.0 };
    track.add_work(2 * (run.last - run.first));
    for t in run.first..run.last {
        let (k, next) = if run.flipped {
            let next = run.first + run.last - 1 - t;
            (next, next)
        } else {
            (t, t + 1)
        };
        let ends = next == run.first || next == run.last;
        let foot = if ends { Foot { at: whole, away: 0.0 } } else { course.foot(run, track.points[next] - run.origin) };
        if foot.away > near || bulges(track, run, course, k, before, foot) {
            return Err(Fault::Far);
        }
        if foot.at < furthest.0 - near {
            return Err(Fault::Back(next.min(furthest.1)));
        }
        if foot.at >= furthest.0 {
            furthest = (foot.at, next);
        }
        if !track.axes.is_empty() && !ends {
            let part = foot.at / whole;
            let part = if run.flipped { 1.0 - part } else { part };
            if track.axis_error(run.first, run.last, next, part) > track.axis_near * (1.0 + 1e-12) {
                return Err(Fault::Axis);
            }
        }
        greatest = greatest.max(foot.away);
        before = foot;
    }
    Ok(greatest)
}

/// Whether an arc between two feet leaves the chord `k` between their points too far.
fn bulges(track: &Track, run: &Run, course: &Course, k: usize, one: Foot, other: Foot) -> bool {
    let Course::Arc(bow) = course else { return false };
    let (from, to) = (one.at / bow.radius, other.at / bow.radius);
    let over = 2.0 * bow.radius * (0.25 * (to - from)).sin().powi(2);
    // Along a chord between the feet the distance from the chord between the points is at most that of an end.
    if one.away.max(other.away) + over <= track.near {
        return false;
    }
    let (a, b) = (track.points[k] - run.origin, track.points[k + 1] - run.origin);
    let away = |angle: f64| {
        let p = bow.point(angle);
        let square = (b - a).length_squared();
        let part = if square > 0.0 { ((p - a).dot(b - a) / square).clamp(0.0, 1.0) } else { 0.0 };
        p.distance(a + part * (b - a))
    };
    let (width, near) = ((to - from) / 16.0, track.near * (1.0 + 1e-9));
    let at = |i: i32| from + f64::from(i) * width;
    let furthest = (1..16).max_by(|i, j| away(at(*i)).total_cmp(&away(at(*j)))).unwrap_or(8);
    greatest_between(away, at(furthest - 1), at(furthest + 1)) > near
}

/// Maximum of a unimodal function, by golden section.
fn greatest_between(value: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    const PART: f64 = 0.381_966_011_250_105_1;
    let mut most = f64::max(value(low), value(high));
    for _ in 0..24 {
        let (a, b) = (low + PART * (high - low), high - PART * (high - low));
        let (at_a, at_b) = (value(a), value(b));
        most = most.max(at_a).max(at_b);
        if at_a > at_b { high = b } else { low = a }
    }
    most
}
