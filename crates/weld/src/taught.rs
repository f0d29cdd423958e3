//! Taught spans: parts of a seam replaced by cubic splines through taught points (SADDLE-2020).

use crate::allowed::{at_most, by_key, rounded};
use crate::seam::SeamCurve;
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{Along, Curve, Edge, EdgePoint, End, Ends, Jet, Spline, angle_between, chord_lengths};
use seamwright_message::{Message, Unit};
use seamwright_program::{PathRange, Taught, is_before, is_beyond};
use std::sync::Arc;

/// Points nearer to each other than this are one, mm.
const APART_MM: f64 = 1e-3;
/// Maximum angle of a span against the nominal seam, degrees: beyond, its points zigzag.
const MAX_TURN_DEG: f64 = 60.0;
/// Stations of an interval of the spline that are checked for that.
const PLACES: u32 = 16;
/// Step by which the curvature's change at a join is measured, outside of the span, mm.
const STEP_MM: f64 = 0.01;

/// A taught span on the seam; path lengths in mm from the start of the weld.
#[derive(Debug, Clone, PartialEq)]
pub struct TaughtSpan {
    /// Start and end on the seam.
    pub seam: (f64, f64),
    /// The same positions on the nominal seam.
    pub nominal: (f64, f64),
    /// Positions of its points on the seam.
    pub points: Vec<f64>,
}

/// A span by parameters of the curve, in the direction of welding.
pub(crate) struct Join {
    ends: (f64, f64),
    nominal: (f64, f64),
    points: Vec<f64>,
}

impl Join {
    /// With the path lengths of its parameters.
    pub(crate) fn by_length(&self, s_at: impl Fn(f64) -> f64) -> TaughtSpan {
        let points = self.points.iter().map(|u| s_at(*u)).collect();
        TaughtSpan { seam: (s_at(self.ends.0), s_at(self.ends.1)), nominal: self.nominal, points }
    }
}

/// A nominal edge with taught spans, by the nominal one's parameter; within a span that goes evenly along the spline.
///
/// A span has the nominal seam's point, direction and curvature at both joins. So an axis that follows it needs no jump
/// in its acceleration there. Its normals are those of the nominal seam at the corresponding position between the
/// joins, made square to the span's [`Along`].
pub(crate) struct TaughtEdge {
    nominal: Arc<SeamCurve>,
    spans: Vec<Span>,
}

struct Span {
    /// Parameters of the joins, increasing; on a closed curve beyond its end if it goes over that.
    from: f64,
    to: f64,
    nominal: (f64, f64),
    curve: Spline,
    along: Along,
    /// The nominal curve's arc length that belongs to a parameter of the spline, in x.
    place: Spline,
    /// Parameters of the taught points on the spline.
    points: Vec<f64>,
}

/// Derivatives of a curve by arc length.
struct ByArc {
    point: DVec3,
    tangent: DVec3,
    curvature: DVec3,
    /// Of the curvature.
    change: DVec3,
}

impl TaughtEdge {
    /// `nominal` with the spans `taught` of a job or program.
    /// Fails with the key's address: see [`SeamCurve::with_taught`].
    pub(crate) fn new<T>(
        file: &Document<T>,
        nominal: &Arc<SeamCurve>,
        taught: &[Taught],
    ) -> Result<Self, DocumentError> {
        let mut spans = Vec::new();
        let mut end = 0.0;
        let length = nominal.weld_length().min(nominal.length());
        for (i, taught) in taught.iter().enumerate() {
            let wrong = |key: &str, code: &'static str, allowed: Message| {
                Err(file.error_at(&format!("taught[{i}].{key}"), Message::new(code), allowed))
            };
            let (from, to) = (taught.from_mm.get(), taught.to_mm.get());
            if is_before(from, end) {
                let allowed = Message::new("weld-allowed-taught-from").value("min", end, Unit::Mm);
                return wrong("from_mm", "weld-taught-spans-overlap", allowed);
            }
            if !is_beyond(to, from) {
                let allowed = by_key("weld-allowed-more-than-key", "from_mm", from);
                return wrong("to_mm", "weld-taught-span-without-length", allowed);
            }
            if is_beyond(to, length) {
                return wrong("to_mm", "weld-taught-span-beyond-seam", at_most(rounded(length), Unit::Mm));
            }
            end = to;
            spans.push(Making { file, number: i, nominal, taught }.span()?);
        }
        Ok(Self { nominal: Arc::clone(nominal), spans })
    }

    /// The spans by parameters in the direction of welding.
    pub(crate) fn joins(&self) -> Vec<Join> {
        let join = |span: &Span| {
            let mut points: Vec<f64> = span.points.iter().map(|t| span.parameter(*t)).collect();
            let mut ends = (span.from, span.to);
            if self.nominal.sense < 0.0 {
                points.reverse();
                ends = (span.to, span.from);
            }
            Join { ends, nominal: span.nominal, points }
        };
        self.spans.iter().map(join).collect()
    }

    /// The span that holds parameter `u`, and the parameter of its spline.
    fn span(&self, u: f64) -> Option<(&Span, f64)> {
        let (first, last) = self.domain();
        self.spans.iter().find_map(|span| {
            let x = if self.closed() { (u - span.from).rem_euclid(last - first) } else { u - span.from };
            let inside = x >= 0.0 && x < span.to - span.from;
            inside.then(|| (span, x * span.rate()))
        })
    }

    fn nominal(&self) -> &(dyn Edge + Send + Sync) {
        &**self.nominal.curve.curve()
    }
}

impl Span {
    /// Length along the spline's parameter by the edge's.
    fn rate(&self) -> f64 {
        self.curve.domain().1 / (self.to - self.from)
    }

    fn parameter(&self, t: f64) -> f64 {
        self.from + t / self.rate()
    }

    /// The parameter of the spline for a nominal arc length between the joins.
    fn place_of(&self, length: f64) -> f64 {
        let (mut low, mut high) = self.curve.domain();
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.place.point(middle).x < length { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

impl Curve for TaughtEdge {
    fn domain(&self) -> (f64, f64) {
        self.nominal().domain()
    }

    fn closed(&self) -> bool {
        self.nominal.closed
    }

    fn jet(&self, u: f64) -> Jet {
        let Some((span, t)) = self.span(u) else { return self.nominal().jet(u) };
        let (jet, rate) = (span.curve.jet(t), span.rate());
        Jet { point: jet.point, d1: rate * jet.d1, d2: rate * rate * jet.d2 }
    }

    fn breaks(&self) -> Vec<f64> {
        let (first, last) = self.domain();
        let mut breaks = Vec::new();
        for u in self.nominal().breaks() {
            // At a break of the nominal seam within a span, the normals of the span may break too.
            let at = self.span(u).map_or(u, |(span, _)| {
                let (length, start) = (self.nominal.curve.length_at(u), span.place.point(0.0).x);
                let turns = if self.closed() { ((start - length) / self.nominal.length()).ceil() } else { 0.0 };
                span.parameter(span.place_of(length + turns * self.nominal.length()))
            });
            breaks.push(at);
        }
        for span in &self.spans {
            breaks.extend([span.from, span.to]);
            breaks.extend(span.along.breaks().into_iter().map(|t| span.parameter(t)));
        }
        if self.closed() {
            breaks.iter_mut().for_each(|u| *u = first + (*u - first).rem_euclid(last - first));
        }
        // The ends of an open curve do not count as breaks.
        breaks.retain(|u| self.nominal.closed || (*u > first && *u < last));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}

impl Edge for TaughtEdge {
    fn edge(&self, u: f64) -> EdgePoint {
        let Some((span, t)) = self.span(u) else { return self.nominal().edge(u) };
        let jet = span.curve.jet(t);
        let along = span.along.at(t);
        let faces = self.nominal().edge(self.nominal.curve.parameter(span.place.point(t).x));
        let square = |n: DVec3| (n - n.dot(along) * along).normalize();
        EdgePoint { point: jet.point, d1: span.rate() * jet.d1, n1: square(faces.n1), n2: square(faces.n2) }
    }

    fn along(&self, u: f64, at: &EdgePoint) -> DVec3 {
        self.span(u).map_or_else(|| self.nominal().along(u, at), |(span, t)| span.along.at(t))
    }
}

/// Inputs of a span.
struct Making<'a, T> {
    file: &'a Document<T>,
    /// Number of the span, counted from 0.
    number: usize,
    nominal: &'a SeamCurve,
    taught: &'a Taught,
}

impl<T> Making<'_, T> {
    /// Error of point `i`, counted in the order of welding; it becomes an argument of `message`.
    fn wrong(&self, i: usize, message: Message, allowed: Message) -> DocumentError {
        let key = if self.taught.axes.is_empty() { "points_mm" } else { "axes" };
        let path = format!("taught[{}].{key}[{i}]", self.number);
        self.file.error_at(&path, message.text("point", (i + 1).to_string()), allowed)
    }

    fn span(&self) -> Result<Span, DocumentError> {
        let (from_mm, to_mm) = (self.taught.from_mm.get(), self.taught.to_mm.get());
        let points: Vec<DVec3> = self.taught.points_mm.iter().map(|p| p.get()).collect();
        if points.is_empty() {
            let path = format!("taught[{}]", self.number);
            let message = Message::new("weld-taught-span-without-points");
            return Err(self.file.error_at(&path, message, Message::new("weld-allowed-taught-points")));
        }
        // Path lengths on the nominal seam, then arc lengths of its curve, in its own sense.
        let feet = self.feet(&points, PathRange { from_mm, to_mm })?;
        let nominal = self.nominal;
        let (ends, forward) = ([nominal.at(from_mm).point, nominal.at(to_mm).point], nominal.sense > 0.0);
        let mut all: Vec<DVec3> = [&ends[..1], &points, &ends[1..]].concat();
        let mut lengths: Vec<f64> = [&[from_mm][..], &feet, &[to_mm]].concat();
        self.check_apart(&all)?;
        lengths.iter_mut().for_each(|s| *s = nominal.start + nominal.sense * *s);
        if !forward {
            all.reverse();
            lengths.reverse();
        }
        let (first, last) = (by_arc(nominal, lengths[0], -1.0), by_arc(nominal, lengths[lengths.len() - 1], 1.0));
        let count = all.len();
        (all[0], all[count - 1]) = (first.point, last.point);
        let span = self.build(&all, &lengths, &first, &last).map_err(|e| {
            let path = format!("taught[{}]", self.number);
            self.file.error_at(&path, e.message(), Message::new("weld-allowed-smooth-points"))
        })?;
        self.check_turns(&span)?;
        Ok(span)
    }

    fn build(
        &self,
        points: &[DVec3],
        lengths: &[f64],
        first: &ByArc,
        last: &ByArc,
    ) -> Result<Span, seamwright_geometry::Error> {
        let t = chord_lengths(points, false)?;
        let jets = |f: fn(&ByArc) -> (DVec3, DVec3)| {
            let (a, b) = (f(first), f(last));
            Ends::Open(End::Jet(a.0, a.1), End::Jet(b.0, b.1))
        };
        // Parameters are arc lengths at the joins: the first derivative is unit, the second the curvature.
        let curve = Spline::new(t.clone(), points.to_vec(), jets(|j| (j.tangent, j.curvature)))?;
        let turn = |join: &ByArc| End::Jet(join.curvature, join.change);
        let along = Along::of(&curve, (turn(first), turn(last)))?;
        let places = lengths.iter().map(|l| DVec3::X * *l).collect();
        let place = Spline::new(t.clone(), places, jets(|_| (DVec3::X, DVec3::ZERO)))?;
        let [from, to] = [lengths[0], lengths[lengths.len() - 1]].map(|l| self.nominal.curve.parameter(l));
        let points = t[1..t.len() - 1].to_vec();
        let nominal = (self.taught.from_mm.get(), self.taught.to_mm.get());
        Ok(Span { from, to, nominal, curve, along, place, points })
    }

    /// Path lengths of the nominal seam's nearest points; they must increase within `range`, between the joins.
    fn feet(&self, points: &[DVec3], range: PathRange) -> Result<Vec<f64>, DocumentError> {
        let PathRange { from_mm: from, to_mm: to } = range;
        let mut feet: Vec<f64> = Vec::new();
        for (i, p) in points.iter().enumerate() {
            let (s, away) = nearest(self.nominal, *p, range);
            let within = self.taught.within_mm.get();
            if away > within {
                let message = Message::new("weld-taught-point-far").quantity("distance", away, Unit::Mm, 3);
                return Err(self.wrong(i, message, by_key("weld-allowed-taught-within", "within_mm", within)));
            }
            let after = feet.last().copied().unwrap_or(from);
            if s <= after + APART_MM || s >= to - APART_MM {
                let message = Message::new("weld-taught-point-out-of-order").quantity("s", s, Unit::Mm, 3);
                let code = if i == 0 { "weld-allowed-taught-after-join" } else { "weld-allowed-taught-after-point" };
                let allowed = Message::new(code).quantity("min", after, Unit::Mm, 3).value("max", to, Unit::Mm);
                return Err(self.wrong(i, message, allowed));
            }
            feet.push(s);
        }
        Ok(feet)
    }

    fn check_apart(&self, all: &[DVec3]) -> Result<(), DocumentError> {
        match all.windows(2).position(|pair| pair[0].distance(pair[1]) < APART_MM) {
            Some(i) => {
                let allowed = Message::new("weld-allowed-taught-apart").value("min", APART_MM, Unit::Mm);
                Err(self.wrong(i.min(all.len() - 3), Message::new("weld-taught-point-repeated"), allowed))
            }
            None => Ok(()),
        }
    }

    /// The span must go along with the nominal seam everywhere: then it neither turns back nor crosses itself.
    fn check_turns(&self, span: &Span) -> Result<(), DocumentError> {
        let least = MAX_TURN_DEG.to_radians().cos();
        for pair in span.curve.knots().windows(2) {
            for i in 0..PLACES {
                let t = pair[0] + (pair[1] - pair[0]) * f64::from(i) / f64::from(PLACES);
                let u = self.nominal.curve.parameter(span.place.point(t).x);
                let along = self.nominal.curve.curve().jet(u).d1.normalize();
                let cosine = span.curve.jet(t).d1.normalize().dot(along);
                // Also not if not a number.
                if !cosine.is_finite() || cosine < least {
                    let count = span.points.len();
                    let before = span.points.partition_point(|p| *p <= t).min(count - 1);
                    let number = if self.nominal.sense > 0.0 { before } else { count - 1 - before };
                    let turn = cosine.clamp(-1.0, 1.0).acos().to_degrees();
                    let message = Message::new("weld-taught-curve-turns").quantity("angle", turn, Unit::Deg, 0);
                    let allowed = Message::new("weld-allowed-taught-turn").value("max", MAX_TURN_DEG, Unit::Deg);
                    return Err(self.wrong(number, message, allowed));
                }
            }
        }
        Ok(())
    }
}

/// Derivatives by arc length at `l`, as they are on the side `side` (-1 before, 1 behind).
fn by_arc(nominal: &SeamCurve, l: f64, side: f64) -> ByArc {
    let frame = |l: f64| {
        let jet = nominal.curve.curve().jet(nominal.curve.parameter(l));
        let tangent = jet.d1.normalize();
        (jet.point, tangent, (jet.d2 - jet.d2.dot(tangent) * tangent) / jet.d1.length_squared())
    };
    // An open curve ends there.
    let inside = |l: f64| nominal.closed || (0.0..=nominal.length()).contains(&l);
    let step = if inside(l + 2.0 * side * STEP_MM) { side * STEP_MM } else { -side * STEP_MM };
    let (point, tangent, curvature) = frame(l);
    let [near, far] = [1.0, 2.0].map(|k| frame(l + k * step).2);
    // One-sided, so that the inside of the span does not count.
    let change = (4.0 * near - 3.0 * curvature - far) / (2.0 * step);
    ByArc { point, tangent, curvature, change }
}

/// Path length in `range` of the nominal seam's point nearest to `p`, and the distance: the nearest of many stations,
/// then Newton steps on the foot of the perpendicular.
fn nearest(nominal: &SeamCurve, p: DVec3, range: PathRange) -> (f64, f64) {
    let PathRange { from_mm: from, to_mm: to } = range;
    let count = ((to - from).ceil() as u32).clamp(64, 4096);
    let place = |i: u32| from + (to - from) * f64::from(i) / f64::from(count);
    let away = |s: f64| nominal.at(s).point.distance(p);
    let start = (0..=count).map(|i| (away(place(i)), place(i))).min_by(|a, b| a.0.total_cmp(&b.0));
    let start = start.map_or(from, |best| best.1);
    let s = foot(nominal, p, start).clamp(from, to);
    (s, away(s))
}

/// Path length of the foot of the perpendicular from `p` near `guess`.
fn foot(nominal: &SeamCurve, p: DVec3, guess: f64) -> f64 {
    let step = |s: f64| {
        let here = nominal.at(s);
        let off = p - here.point;
        let bend = 1.0 - off.dot(nominal.curvature(s));
        s + off.dot(here.tangent) / bend.max(0.25)
    };
    (0..12).fold(guess, |s, _| step(s))
}

impl SeamCurve {
    /// The spans replaced by taught points, in the order of welding.
    pub fn taught(&self) -> &[TaughtSpan] {
        self.taught.as_ref().map_or(&[], |(_, spans)| spans)
    }

    /// The seam without its taught spans.
    pub fn nominal(&self) -> &SeamCurve {
        self.taught.as_ref().map_or(self, |(nominal, _)| nominal)
    }

    /// Curvature vector at path length `s` (mm): unit tangent by path length, 1/mm.
    pub fn curvature(&self, s: f64) -> DVec3 {
        let jet = self.curve.curve().jet(self.curve.parameter(self.start + self.sense * s));
        let along = jet.d1.normalize();
        (jet.d2 - jet.d2.dot(along) * along) / jet.d1.length_squared()
    }

    /// In span `span`, or beside it: how far the seam at path length `s` is from the nominal one (mm), and the angle
    /// between their directions (rad).
    pub fn off_nominal(&self, span: &TaughtSpan, s: f64) -> (f64, f64) {
        let nominal = self.nominal();
        let part = (s - span.seam.0) / (span.seam.1 - span.seam.0);
        let guess = match part {
            ..0.0 => span.nominal.0 + s - span.seam.0,
            0.0..=1.0 => span.nominal.0 + part * (span.nominal.1 - span.nominal.0),
            _ => span.nominal.1 + s - span.seam.1,
        };
        let here = self.at(s);
        let there = nominal.at(foot(nominal, here.point, guess));
        (here.point.distance(there.point), angle_between(here.tangent, there.tangent))
    }
}
