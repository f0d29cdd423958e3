use glam::DVec3;

/// Distance between neighbouring points from which they enclose a gap, mm.
pub(super) const GAP_MM: f64 = 1.0;

/// Maximum distance of a point beside the line, mm; a farther one is beside another stretch, round a bend.
const BESIDE_MM: f64 = 5.0;

/// Source of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Source {
    /// Detected in a frame.
    Eye,
    /// Given by the operator.
    Operator,
}

/// A point of the joint as measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RawPoint {
    /// In the work frame, mm.
    pub point: DVec3,
    /// The surface's unit normal there, out of the work.
    pub normal: DVec3,
    /// Unit viewing direction of the camera; the negative normal for an operator's point.
    pub ray: DVec3,
    /// 0 to 1.
    pub confidence: f64,
    /// Index of its frame, counted from 0; the previous frame for an operator's point.
    pub frame: usize,
    /// Source of the point.
    pub source: Source,
}

/// The joint found so far, point by point.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TaughtLine {
    points: Vec<RawPoint>,
    /// Distance along the points up to each, mm.
    ways: Vec<f64>,
}

impl TaughtLine {
    /// Returns the points in order.
    pub fn points(&self) -> &[RawPoint] {
        &self.points
    }

    /// Returns the distance along the points up to each of them, mm.
    pub fn ways(&self) -> &[f64] {
        &self.ways
    }

    /// Returns the length along all points, mm.
    pub fn length(&self) -> f64 {
        self.ways.last().copied().unwrap_or(0.0)
    }

    /// Returns whether the line has no points.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Adds a point. The distance counts along `along`, the joint's unit direction there if known, so that noise does
    /// not lengthen the line.
    pub(super) fn push(&mut self, point: RawPoint, along: Option<DVec3>) {
        let way = self.points.last().map_or(0.0, |last| {
            let step = point.point - last.point;
            self.length() + along.filter(|_| step.length() < GAP_MM).map_or(step.length(), |d| step.dot(d).max(0.0))
        });
        self.points.push(point);
        self.ways.push(way);
    }

    /// Returns the line with each point moved to `to` (its distance and itself); the counted distances stay.
    pub(super) fn moved(&self, to: impl Fn(f64, &RawPoint) -> DVec3) -> Self {
        let points = self.ways.iter().zip(&self.points).map(|(way, p)| RawPoint { point: to(*way, p), ..*p }).collect();
        Self { points, ways: self.ways.clone() }
    }

    /// Removes the last point.
    pub(super) fn pop(&mut self) {
        self.points.pop();
        self.ways.pop();
    }

    /// Removes the points beyond `way`.
    pub(super) fn cut(&mut self, way: f64) {
        let keep = self.ways.partition_point(|w| *w <= way);
        self.points.truncate(keep);
        self.ways.truncate(keep);
    }

    /// Returns the unit direction at `way` from the points within `reach` mm to both sides; `None` if they are too
    /// close.
    pub(super) fn direction(&self, way: f64, reach: f64) -> Option<DVec3> {
        let first = self.ways.partition_point(|w| *w < way - reach);
        let last = self.ways.partition_point(|w| *w <= way + reach).max(1) - 1;
        let span = self.points.get(last)?.point - self.points.get(first)?.point;
        (span.length() > 0.2 * reach).then(|| span.normalize())
    }

    /// Returns the point at `way`, interpolated between its neighbours.
    pub(super) fn at(&self, way: f64) -> Option<DVec3> {
        let next = self.ways.partition_point(|w| *w < way);
        let Some(b) = self.points.get(next) else { return self.points.last().map(|p| p.point) };
        let Some(before) = next.checked_sub(1) else { return Some(b.point) };
        let part = (way - self.ways[before]) / (self.ways[next] - self.ways[before]).max(f64::MIN_POSITIVE);
        Some(self.points[before].point.lerp(b.point, part))
    }

    /// Returns the distance in the surface, without the height component, of `point` from the line beyond `from`. Only
    /// pieces without a gap count; `None` beyond the ends.
    pub(super) fn distance(&self, point: &RawPoint, from: f64) -> Option<f64> {
        let first = self.ways.partition_point(|w| *w < from);
        let beside = self.points[first.min(self.points.len())..].windows(2).filter_map(|w| {
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
