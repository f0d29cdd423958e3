use crate::smoothing::LinePoint;
use glam::{DAffine3, DQuat, DVec3};
use seamwright_document::{Direction, Finite, Point, Positive};
use seamwright_geometry::Error;
use seamwright_geometry::reduce::{
    Method, Reduction, Shape, Span, SplineReduction, Tolerances, reduce, reduce_to_spline,
};
use seamwright_program::{
    Along, AtCorner, OnLimit, POSE_COLUMNS, Pass, PointSpan, Points, Program, SPEED_COLUMN, Torch,
};
use std::f64::consts::TAU;

/// Kind of curves to which a taught line is reduced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Lines and arcs (EBW-2004).
    Arcs(Method),
    /// One cubic B-spline through few of its points (DUALBEAM-2013).
    Spline,
}

/// Curves that represent a taught line, by indices of its points.
#[derive(Debug, Clone, PartialEq)]
pub enum Curves {
    /// Lines and arcs.
    Arcs(Reduction),
    /// A spline.
    Spline(SplineReduction),
}

impl Curves {
    /// Returns the maximum distance of a point from its curve, mm.
    pub fn max_error(&self) -> f64 {
        match self {
            Self::Arcs(reduction) => reduction.spans.iter().map(|s| s.max_error).fold(0.0, f64::max),
            Self::Spline(reduction) => reduction.max_error,
        }
    }

    /// Returns the numbers of lines, of arcs, and of pieces of a spline.
    pub fn counts(&self) -> [usize; 3] {
        match self {
            Self::Arcs(Reduction { spans, .. }) => {
                let lines = spans.iter().filter(|s| s.shape == Shape::Line).count();
                [lines, spans.len() - lines, 0]
            }
            Self::Spline(reduction) => [0, 0, reduction.kept.len() - 1],
        }
    }
}

/// A taught line as a program.
#[derive(Debug, Clone, PartialEq)]
pub struct Reduced {
    /// The program: one pass through the curves' ends, poses of the torch in the frame of the nominal seam.
    pub program: Program,
    /// Curves that represent the line, in the machine's work frame.
    pub curves: Curves,
}

/// Tolerances of a taught line's reduction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReductionTolerances {
    /// Distance of the points from the curves, mm.
    pub path_mm: f64,
    /// Deviation of the torch's direction, rad.
    pub attitude_rad: f64,
}

/// Reduces a taught line to curves, and the torch's direction with it, within the tolerances. The new program copies
/// from `like` its machine, title, seam, part and fixtures (the machine keeps clear of them). From the first pass of
/// `like` it takes speed, process, sequence and redundant axes. `torch` holds unit vectors from the joint to the torch,
/// one per point.
///
/// # Errors
/// Those of [`reduce`] and [`reduce_to_spline`]; [`Error::TooFewPoints`] with fewer than two points, or for a program
/// without passes.
pub fn to_program(
    line: &[LinePoint],
    torch: &[DVec3],
    like: &Program,
    tolerances: ReductionTolerances,
    kind: Kind,
) -> Result<Reduced, Error> {
    let ReductionTolerances { path_mm: tolerance, attitude_rad: attitude } = tolerances;
    let few = || Error::TooFewPoints { what: "geometry-points-taught-line", given: line.len(), min: 2 };
    let points: Vec<DVec3> = line.iter().map(|p| p.point).collect();
    let directions = [0, 1, 2].map(|i| torch.iter().map(|axis| -axis[i]).collect::<Vec<f64>>());
    let tolerances = Tolerances { path_mm: tolerance, columns: attitude };
    let curves = match kind {
        Kind::Arcs(method) => Curves::Arcs(reduce(&points, &directions, tolerances, method)?),
        Kind::Spline => Curves::Spline(reduce_to_spline(&points, &directions, tolerances)?),
    };
    let (Some(pass), [_, _, ..]) = (like.passes.first(), line) else { return Err(few()) };
    let writer = Writer::new(pass, torch, like.seam_in_work().inverse());
    let taught = Points {
        columns: writer.columns(),
        arc: true,
        stepped: Vec::new(),
        start: writer.row(line, 0, 0.0),
        events: Vec::new(),
        spans: writer.spans(line, &curves),
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
        placement: like.copies.first().map_or(like.placement, |copy| copy.placement),
        copies: Vec::new(),
        joint: None,
        taught: Vec::new(),
        passes: vec![pass],
        ..like.clone()
    };
    Ok(Reduced { program, curves })
}

/// Builds the rows of the program.
struct Writer<'a> {
    torch: &'a [DVec3],
    process: Vec<(String, f64)>,
    speed: f64,
    /// Transform from the machine's work frame to the seam frame, which program points use.
    to_seam: DAffine3,
}

/// Speed if the template's pass has none, mm/s.
const USUAL_SPEED: f64 = 5.0;

impl<'a> Writer<'a> {
    fn new(pass: &Pass, torch: &'a [DVec3], to_seam: DAffine3) -> Self {
        let first = pass.spans.first();
        let process = first.map(|s| s.process.iter().map(|(name, value)| (name.clone(), value.ends().0)).collect());
        let speed = first.map_or(USUAL_SPEED, |s| s.speed_mm_s.ends().0);
        Self { torch, process: process.unwrap_or_default(), speed, to_seam }
    }

    fn columns(&self) -> Vec<String> {
        let poses = POSE_COLUMNS.iter().map(|name| (*name).to_owned());
        poses.chain(self.process.iter().map(|p| p.0.clone())).chain([SPEED_COLUMN.to_owned()]).collect()
    }

    fn row(&self, line: &[LinePoint], index: usize, speed: f64) -> Vec<Finite> {
        let point = self.to_seam.transform_point3(line[index].point);
        let pose = point.to_array().into_iter().chain(self.to_seam.transform_vector3(-self.torch[index]).to_array());
        let values = pose.chain(self.process.iter().map(|p| p.1)).chain([speed]);
        values.map(|v| Finite::new(v).unwrap_or_default()).collect()
    }

    fn spans(&self, line: &[LinePoint], curves: &Curves) -> Vec<PointSpan> {
        match curves {
            Curves::Arcs(reduction) => self.arcs(line, &reduction.spans),
            Curves::Spline(reduction) => {
                // Program speeds are those along chords.
                let points = reduction.kept.windows(2).zip(reduction.spline.knots().windows(2)).map(|(kept, way)| {
                    let chord = line[kept[0]].point.distance(line[kept[1]].point);
                    self.row(line, kept[1], self.speed * chord / (way[1] - way[0]))
                });
                vec![span(Along::Spline, None, points.collect())]
            }
        }
    }

    /// Joins consecutive lines to one span; every arc is its own.
    fn arcs(&self, line: &[LinePoint], spans: &[Span]) -> Vec<PointSpan> {
        let mut out: Vec<PointSpan> = Vec::new();
        for s in spans {
            let row = self.row(line, s.last, self.speed);
            match (s.shape, out.last_mut()) {
                (Shape::Line, Some(run)) if run.along == Along::Line => run.points.push(row),
                (shape, _) => {
                    let via_mm = match shape {
                        Shape::Line => None,
                        Shape::Arc { centre, normal, .. } => {
                            let via = via(line[s.first].point, line[s.last].point, centre, normal);
                            Point::new(self.to_seam.transform_point3(via))
                        }
                    };
                    out.push(span(if via_mm.is_some() { Along::Arc } else { Along::Line }, via_mm, vec![row]));
                }
            }
        }
        out
    }
}

fn span(along: Along, via_mm: Option<Point>, points: Vec<Vec<Finite>>) -> PointSpan {
    PointSpan { along, stops: false, via_mm, normal: None::<Direction>, speeds: Vec::new(), points }
}

/// Returns the middle of the arc from `first` to `last` counter-clockwise about `normal` through `centre`.
fn via(first: DVec3, last: DVec3, centre: DVec3, normal: DVec3) -> DVec3 {
    let (a, b) = (first - centre, last - centre);
    let sweep = normal.dot(a.cross(b)).atan2(a.dot(b)).rem_euclid(TAU);
    centre + DQuat::from_axis_angle(normal, 0.5 * sweep) * a
}
