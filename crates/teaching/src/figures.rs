use crate::outcome::Outcome;
use crate::program::{Curves, Reduced};
use crate::seam_line::{SeamLine, Station};
use crate::taught_line::Source;
use glam::DVec3;
use seamwright_geometry::reduce::{Shape, Span};
use seamwright_geometry::{Arc, Curve, Spline};
use std::f64::consts::TAU;

/// Minimum distance between reported raw points along the line, mm.
const RAW_SPACING_MM: f64 = 0.5;
/// The reduced path is measured by points so far apart, mm.
const STEP_MM: f64 = 0.5;

/// A point of the line as it was seen.
#[derive(Debug, Clone, PartialEq)]
pub struct TaughtPoint {
    /// Way along the line, mm.
    pub way: f64,
    /// In the work frame, mm.
    pub point: DVec3,
    /// 0 to 1.
    pub confidence: f64,
    /// The frame that it was seen in, from 0.
    pub frame: usize,
    /// The operator gave it.
    pub operator: bool,
    /// Distance from the program's lines and arcs, mm.
    pub from_program: f64,
    /// Across the nominal seam and above it, mm; not known far away from it.
    pub from_nominal: Option<(f64, f64)>,
}

/// Figures of a taught line and its program.
#[derive(Debug, Clone, PartialEq)]
pub struct Figures {
    /// Points of the line as it was seen.
    pub raw: Vec<TaughtPoint>,
    /// Points of the program's path, close to each other.
    pub path: Vec<DVec3>,
}

impl Figures {
    /// Figures of the teaching `outcome` along the `nominal` seam, and of its reduced path.
    pub fn new(nominal: &SeamLine, outcome: &Outcome, reduced: &Reduced) -> Self {
        let points = match &reduced.curves {
            Curves::Arcs(arcs) => along_arcs(outcome, &arcs.spans),
            Curves::Spline(reduction) => along_spline(&reduction.spline),
        };
        let station = |point: &DVec3| Station { point: *point, normal: DVec3::Z };
        let path = SeamLine::through(points.iter().map(station).collect(), false);
        let mut raw: Vec<TaughtPoint> = Vec::new();
        for (p, way) in outcome.line.points().iter().zip(outcome.line.ways()) {
            if raw.last().is_some_and(|last| way - last.way < RAW_SPACING_MM) && p.source == Source::Eye {
                continue;
            }
            let from_program = path.foot(p.point).map_or(f64::NAN, |foot| foot.at.point.distance(p.point));
            let from_nominal = from_nominal(nominal, p.point);
            let operator = p.source == Source::Operator;
            let (point, confidence, frame) = (p.point, p.confidence, p.frame);
            raw.push(TaughtPoint { way: *way, point, confidence, frame, operator, from_program, from_nominal });
        }
        Self { raw, path: points }
    }

    /// Maximum distance of a raw point from the program, mm.
    pub fn raw_error(&self) -> Option<f64> {
        self.raw.iter().map(|p| p.from_program).reduce(f64::max)
    }
}

/// Distance of a point across the nominal seam and above it, mm; `None` far away from it.
pub fn from_nominal(nominal: &SeamLine, point: DVec3) -> Option<(f64, f64)> {
    let foot = nominal.foot(point)?;
    let off = point - foot.at.point;
    Some((off.dot(foot.at.normal.cross(foot.along)), off.dot(foot.at.normal)))
}

/// Length of unseen stretches, mm.
pub fn bridged(outcome: &Outcome) -> f64 {
    outcome.line.ways().windows(2).map(|w| w[1] - w[0]).filter(|gap| *gap > 1.0).sum()
}

fn along_spline(spline: &Spline) -> Vec<DVec3> {
    let (from, to) = spline.domain();
    // By chord length: near to mm.
    let count = ((to - from) / STEP_MM).ceil().max(1.0);
    (0..=count as u32).map(|k| spline.point(from + (to - from) * f64::from(k) / count)).collect()
}

fn along_arcs(outcome: &Outcome, spans: &[Span]) -> Vec<DVec3> {
    let mut points = Vec::new();
    for span in spans {
        let (start, end) = (outcome.smooth[span.first].point, outcome.smooth[span.last].point);
        let arc = match span.shape {
            Shape::Arc { centre, normal, .. } => {
                let (from, to) = (start - centre, end - centre);
                let sweep = normal.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(TAU);
                Arc::new(centre, normal, start, sweep).ok().map(|arc| (arc, sweep, sweep * from.length()))
            }
            Shape::Line => None,
        };
        let length = arc.as_ref().map_or(start.distance(end), |a| a.2);
        let steps = (length / STEP_MM).ceil().max(1.0);
        points.extend((0..steps as u32).map(|k| {
            let part = f64::from(k) / steps;
            arc.as_ref().map_or_else(|| start.lerp(end, part), |(arc, sweep, _)| arc.point(part * sweep))
        }));
    }
    points.extend(outcome.smooth.last().map(|p| p.point));
    points
}
