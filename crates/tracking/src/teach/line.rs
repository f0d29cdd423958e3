use glam::DVec3;

/// A gap of the line that is longer has no points of its own, mm.
pub(super) const GAP_MM: f64 = 1.0;

/// Farther from the line a point is not beside it: it is beside another stretch, round a bend, mm.
const BESIDE_MM: f64 = 5.0;

/// Where a point comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Seen in a frame.
    Eye,
    /// Given by the operator.
    Operator,
}

/// A point of the joint as it was found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RawPoint {
    /// In the work frame, mm.
    pub point: DVec3,
    /// The surface's unit normal there, out of the work.
    pub normal: DVec3,
    /// Unit direction in which the eye saw it; of an operator's point against the normal.
    pub ray: DVec3,
    /// 0 to 1.
    pub confidence: f64,
    /// The frame that it was taken from, counted from 0; of an operator's point the one before.
    pub frame: usize,
    /// Where it comes from.
    pub source: Source,
}

/// The joint found so far, point after point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaughtLine {
    points: Vec<RawPoint>,
    /// Way along the points up to each, mm.
    ways: Vec<f64>,
}

impl TaughtLine {
    /// The points in order.
    pub fn points(&self) -> &[RawPoint] {
        &self.points
    }

    /// Way along the points up to each of them, mm.
    pub fn ways(&self) -> &[f64] {
        &self.ways
    }

    /// Way along all points, mm.
    pub fn length(&self) -> f64 {
        self.ways.last().copied().unwrap_or(0.0)
    }

    /// True without points.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Adds a point; `along` is the joint's unit direction there, if it is known: the way is counted along it, so that noise
    /// makes the line no longer.
    pub(super) fn push(&mut self, point: RawPoint, along: Option<DVec3>) {
        let way = self.points.last().map_or(0.0, |last| {
            let step = point.point - last.point;
            self.length() + along.filter(|_| step.length() < GAP_MM).map_or(step.length(), |d| step.dot(d).max(0.0))
        });
        self.points.push(point);
        self.ways.push(way);
    }

    /// The same line with each point moved to where `to` (its way and itself) says; ways stay those that were counted.
    pub(super) fn moved(&self, to: impl Fn(f64, &RawPoint) -> DVec3) -> Self {
        let points = self.ways.iter().zip(&self.points).map(|(way, p)| RawPoint { point: to(*way, p), ..*p }).collect();
        Self { points, ways: self.ways.clone() }
    }

    /// Forgets the last point.
    pub(super) fn pop(&mut self) {
        self.points.pop();
        self.ways.pop();
    }

    /// Forgets the points beyond `way`.
    pub(super) fn cut(&mut self, way: f64) {
        let keep = self.ways.partition_point(|w| *w <= way);
        self.points.truncate(keep);
        self.ways.truncate(keep);
    }

    /// Unit direction about `way`, from the points within `reach` mm to both sides; none of a line that is too short.
    pub(super) fn direction(&self, way: f64, reach: f64) -> Option<DVec3> {
        let first = self.ways.partition_point(|w| *w < way - reach);
        let last = self.ways.partition_point(|w| *w <= way + reach).max(1) - 1;
        let span = self.points.get(last)?.point - self.points.get(first)?.point;
        (span.length() > 0.2 * reach).then(|| span.normalize())
    }

    /// The point at `way`, between the points next to it.
    pub(super) fn at(&self, way: f64) -> Option<DVec3> {
        let next = self.ways.partition_point(|w| *w < way);
        let Some(b) = self.points.get(next) else { return self.points.last().map(|p| p.point) };
        let Some(before) = next.checked_sub(1) else { return Some(b.point) };
        let part = (way - self.ways[before]) / (self.ways[next] - self.ways[before]).max(f64::MIN_POSITIVE);
        Some(self.points[before].point.lerp(b.point, part))
    }

    /// Distance of `point` from the line beyond `from` (way) on the surface, that is without what it is above or below the
    /// line, where it is beside a piece without a gap; none beyond its ends.
    pub(super) fn distance(&self, point: &RawPoint, from: f64) -> Option<f64> {
        let first = self.ways.partition_point(|w| *w < from);
        let pieces = self.points[first.min(self.points.len())..].windows(2);
        let beside = pieces.filter_map(|w| {
            let (a, b) = (w[0].point, w[1].point);
            let (along, off) = (b - a, point.point - a);
            let part = off.dot(along) / along.length_squared();
            let inside = along.length() <= GAP_MM && (0.0..=1.0).contains(&part);
            inside
                .then(|| (off - part * along).reject_from_normalized(point.normal).length())
                .filter(|d| *d < BESIDE_MM)
        });
        beside.min_by(f64::total_cmp)
    }
}
