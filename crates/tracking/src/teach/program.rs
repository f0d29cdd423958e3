use super::LinePoint;
use glam::{DQuat, DVec3};
use seamwright_document::{Direction, Finite, Point, Positive, Transform};
use seamwright_geometry::Error;
use seamwright_geometry::reduce::{Method, Shape, Span, reduce};
use seamwright_program::{
    Along, AtCorner, OnLimit, POSE_COLUMNS, Part, Pass, PointSpan, Points, Program, SPEED_COLUMN, SeamStart, Torch,
};
use std::f64::consts::TAU;

/// A taught line as a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduced {
    /// The program: one pass through the spans' ends, poses of the torch in the machine's work frame.
    pub program: Program,
    /// Lines and arcs, by indices of the points they stand for.
    pub spans: Vec<Span>,
    /// Proven: fewer spans do not hold the tolerance.
    pub at_least: usize,
}

impl Reduced {
    /// Greatest distance of a point from its span, mm.
    pub fn max_error(&self) -> f64 {
        self.spans.iter().map(|s| s.max_error).fold(0.0, f64::max)
    }

    /// Number of arcs.
    pub fn arcs(&self) -> usize {
        self.spans.iter().filter(|s| matches!(s.shape, Shape::Arc { .. })).count()
    }
}

/// Reduces a taught line to lines and arcs within `tolerance` (mm), the torch's direction carried along within
/// `attitude` (rad), and puts them into a program like `like`: its machine, title, fixtures and what its first pass says of
/// speed, process, sequence and axes to spare. The torch stands square to the surface.
///
/// # Errors
/// Those of [`reduce`]; [`Error::Size`] with fewer than two points.
pub fn to_program(
    line: &[LinePoint],
    like: &Program,
    (tolerance, attitude): (f64, f64),
    method: Method,
) -> Result<Reduced, Error> {
    let few = || Error::Size { what: "the number of points", value: line.len() as f64 };
    let points: Vec<DVec3> = line.iter().map(|p| p.point).collect();
    let directions = [0, 1, 2].map(|i| line.iter().map(|p| -p.normal[i]).collect::<Vec<f64>>());
    let reduction = reduce(&points, &directions, (tolerance, attitude), method)?;
    let (Some(_), Some(first)) = (reduction.spans.first(), line.first()) else { return Err(few()) };
    let pass = like.passes.first().ok_or_else(few)?;
    let writer = Writer::new(pass);
    let taught = Points {
        columns: writer.columns(),
        arc: true,
        stepped: Vec::new(),
        start: writer.row(first, false),
        events: Vec::new(),
        spans: writer.spans(line, &reduction.spans),
    };
    let tolerance = Positive::new(tolerance).unwrap_or(pass.tolerance.path_mm);
    let pass = Pass {
        on_limit: OnLimit::Slow,
        corner: AtCorner::BlendMm(if tolerance < pass.tolerance.path_mm { tolerance } else { pass.tolerance.path_mm }),
        torch: Torch::default(),
        bead: None,
        weave: None,
        oscillation: None,
        least_speed_mm_s: None,
        begin_mm: Default::default(),
        reverse: false,
        copy: 0,
        points: Some(taught),
        spans: Vec::new(),
        ..pass.clone()
    };
    let program = Program {
        placement: Transform::default(),
        offset: None,
        copies: Vec::new(),
        seam: None,
        start: SeamStart::default(),
        joint: None,
        taught: Vec::new(),
        part: Part::default(),
        passes: vec![pass],
        ..like.clone()
    };
    Ok(Reduced { program, spans: reduction.spans, at_least: reduction.at_least })
}

/// What a row of the program holds beside the pose.
struct Writer {
    process: Vec<(String, f64)>,
    speed: f64,
}

/// Speed where the pass that the program is like has none, mm/s.
const USUAL_SPEED: f64 = 5.0;

impl Writer {
    fn new(pass: &Pass) -> Self {
        let first = pass.spans.first();
        let process = first.map(|s| s.process.iter().map(|(name, value)| (name.clone(), value.ends().0)).collect());
        Self { process: process.unwrap_or_default(), speed: first.map_or(USUAL_SPEED, |s| s.speed_mm_s.ends().0) }
    }

    fn columns(&self) -> Vec<String> {
        let poses = POSE_COLUMNS.iter().map(|name| (*name).to_owned());
        poses.chain(self.process.iter().map(|p| p.0.clone())).chain([SPEED_COLUMN.to_owned()]).collect()
    }

    fn row(&self, at: &LinePoint, moves: bool) -> Vec<Finite> {
        let direction = -at.normal;
        let pose = at.point.to_array().into_iter().chain(direction.to_array());
        let speed = if moves { self.speed } else { 0.0 };
        let values = pose.chain(self.process.iter().map(|p| p.1)).chain([speed]);
        values.map(|v| Finite::new(v).unwrap_or_default()).collect()
    }

    /// Runs of lines, and arcs.
    fn spans(&self, line: &[LinePoint], spans: &[Span]) -> Vec<PointSpan> {
        let mut out: Vec<PointSpan> = Vec::new();
        for span in spans {
            let row = self.row(&line[span.last], true);
            match (span.shape, out.last_mut()) {
                (Shape::Line, Some(run)) if run.along == Along::Line => run.points.push(row),
                (shape, _) => {
                    let via_mm = match shape {
                        Shape::Line => None,
                        Shape::Arc { centre, normal, .. } => {
                            Point::new(via(line[span.first].point, line[span.last].point, centre, normal))
                        }
                    };
                    let along = if via_mm.is_some() { Along::Arc } else { Along::Line };
                    out.push(PointSpan {
                        along,
                        stops: false,
                        via_mm,
                        normal: None::<Direction>,
                        speeds: Vec::new(),
                        points: vec![row],
                    });
                }
            }
        }
        out
    }
}

/// The middle of the arc from `first` to `last` counter-clockwise about `normal` through `centre`.
fn via(first: DVec3, last: DVec3, centre: DVec3, normal: DVec3) -> DVec3 {
    let (a, b) = (first - centre, last - centre);
    let sweep = normal.dot(a.cross(b)).atan2(a.dot(b)).rem_euclid(TAU);
    centre + DQuat::from_axis_angle(normal, 0.5 * sweep) * a
}
