use glam::DVec3;

/// A line or an arc between two points of a polyline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Index of its first point.
    pub first: usize,
    /// Index of its last point; the next span starts there.
    pub last: usize,
    /// Shape of the span.
    pub shape: Shape,
    /// Maximum distance of the run's points from it, mm; at most the tolerance.
    pub max_error: f64,
}

/// Shape of a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// The straight line between its ends.
    Line,
    /// The arc between its ends (centre and radius in mm) that goes counter-clockwise about the unit `normal`.
    #[allow(missing_docs, reason = "the fields say what they are")]
    Arc { centre: DVec3, radius: f64, normal: DVec3 },
}

/// Method of cutting a polyline into runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// From the start the longest run that has a span, then the next.
    Greedy,
    /// The minimum number of spans.
    Fewest,
}

/// A polyline as spans.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduction {
    /// From the first point to the last; none for fewer than two points.
    pub spans: Vec<Span>,
    /// A proven bound: no reduction within the tolerance has fewer spans than this. [`Method::Fewest`] ends with as
    /// many spans, unless the proof would take too long: on paths of very many points whose noise is near the
    /// tolerance. With [`Method::Greedy`] 1, or 0 without spans.
    pub at_least: usize,
}

/// Maximum deviations of a reduction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerances {
    /// Maximum distance of a point from its curve, mm.
    pub path_mm: f64,
    /// Maximum deviation of a further column, in its own unit.
    pub columns: f64,
}
