//! Lines and corners as a robot control plays them.
//!
//! Between two poses the tool centre point goes along the straight line in the work frame at the programmed speed. The
//! orientation turns evenly about one fixed axis, and external axes go evenly, both in proportion to the way. A moving
//! positioner carries the work frame: the line is straight on the work (coordinated motion).
//!
//! A corner begins on the line before it and ends on the line behind it, both at the zone's radius from the programmed
//! point. The radius counts up to half of the shorter line. Between them the path is
//!
//! - a parabola that the control passes in the time that the two parts of the lines would take, or
//! - an arc that touches both lines, passed at the programmed speed (Universal Robots).

use super::pose::RobotPose;
use super::program::LineMove;
use glam::{DQuat, DVec3};

/// Shape of the path round a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BlendShape {
    /// A parabola.
    Parabola,
    /// An arc.
    Circle,
}

/// Angle between lines below which a corner is straight, rad.
const STRAIGHT: f64 = 1e-9;

/// A pose with positions of the external axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// The tool centre point in the work frame.
    pub pose: RobotPose,
    /// External axes, mm or degrees.
    pub externals: Vec<f64>,
}

impl Station {
    /// The station at the fraction `f` of the way to `other`.
    pub fn towards(&self, other: &Self, f: f64) -> Self {
        let externals = self.externals.iter().zip(&other.externals).map(|(a, b)| a + f * (b - a)).collect();
        Self { pose: self.pose.towards(&other.pose, f), externals }
    }
}

/// A part of a played path: the middle of a line, or a corner.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotPiece {
    /// Time at its start, s.
    pub begin_s: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Index of the line that it belongs to; a corner belongs to the line before it.
    pub line: usize,
    from: Station,
    /// The programmed point of a corner.
    corner: Option<Station>,
    to: Station,
    shape: BlendShape,
}

/// A sequence of lines as played.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotPlay {
    /// Its parts in time.
    pub pieces: Vec<RobotPiece>,
    /// Duration, s.
    pub seconds: f64,
}

/// A line with what the play needs of it.
struct Line {
    from: Station,
    to: Station,
    length: f64,
    speed: f64,
    /// Radii of the corners at both ends.
    radii: [f64; 2],
}

impl RobotPlay {
    /// Plays `lines` from `start` on.
    pub fn new(start: &Station, lines: &[&LineMove], shape: BlendShape) -> Self {
        let mut play = Self { pieces: Vec::new(), seconds: 0.0 };
        let lines = measured(start, lines);
        for (i, line) in lines.iter().enumerate() {
            let [first, last] = line.radii;
            let at = |way: f64| line.from.towards(&line.to, if line.length > 0.0 { way / line.length } else { 1.0 });
            let middle = (line.length - first - last).max(0.0);
            if middle > 0.0 {
                let piece = (at(first), None, at(line.length - last));
                play.add(i, middle / line.speed, piece, shape);
            }
            let Some(next) = lines.get(i + 1).filter(|_| last > 0.0) else { continue };
            let end = next.from.towards(&next.to, last / next.length);
            let time = corner_seconds(line, next, shape);
            play.add(i, time, (at(line.length - last), Some(line.to.clone()), end), shape);
        }
        play
    }

    fn add(&mut self, line: usize, seconds: f64, way: (Station, Option<Station>, Station), shape: BlendShape) {
        let (from, corner, to) = way;
        self.pieces.push(RobotPiece { begin_s: self.seconds, seconds, line, from, corner, to, shape });
        self.seconds += seconds;
    }
}

fn measured(start: &Station, lines: &[&LineMove]) -> Vec<Line> {
    let mut from = start.clone();
    let mut all: Vec<Line> = Vec::new();
    for line in lines {
        let to = Station { pose: line.to, externals: line.externals.clone() };
        let length = from.pose.point.distance(to.pose.point);
        all.push(Line { from, to: to.clone(), length, speed: line.speed_mm_s, radii: [0.0; 2] });
        from = to;
    }
    for i in 1..all.len() {
        let half = 0.5 * all[i - 1].length.min(all[i].length);
        let radius = lines[i - 1].zone_mm.min(half);
        all[i - 1].radii[1] = radius;
        all[i].radii[0] = radius;
    }
    all
}

/// Angle by which the path turns from `line` to `next`, rad.
fn bend(line: &Line, next: &Line) -> f64 {
    let direction = |line: &Line| (line.to.pose.point - line.from.pose.point) / line.length;
    let (a, b) = (direction(line), direction(next));
    a.cross(b).length().atan2(a.dot(b))
}

/// Part by which an arc round a corner is shorter than the two parts of the lines that it replaces.
pub(super) fn shortening(angle: f64) -> f64 {
    if angle > STRAIGHT { 1.0 - 0.5 * angle / (0.5 * angle).tan() } else { 0.0 }
}

fn corner_seconds(line: &Line, next: &Line, shape: BlendShape) -> f64 {
    let radius = line.radii[1];
    let along_lines = radius / line.speed + radius / next.speed;
    match shape {
        BlendShape::Circle => along_lines * (1.0 - shortening(bend(line, next))),
        BlendShape::Parabola => along_lines,
    }
}

impl RobotPiece {
    /// Station at the fraction `f` of its time.
    pub fn at(&self, f: f64) -> Station {
        let Some(corner) = &self.corner else { return self.from.towards(&self.to, f) };
        let (before, after) = (self.from.towards(corner, f), corner.towards(&self.to, f));
        let mut station = before.towards(&after, f);
        if self.shape == BlendShape::Circle {
            station.pose.point = on_arc([&self.from, corner, &self.to].map(|s| s.pose.point), f);
        }
        station
    }
}

/// Point at the fraction `f` of the arc that touches the lines from `a` to `corner` and from there to `b`, which are
/// equally long.
fn on_arc([a, corner, b]: [DVec3; 3], f: f64) -> DVec3 {
    let (first, second) = ((corner - a).normalize_or_zero(), (b - corner).normalize_or_zero());
    let axis = first.cross(second);
    let angle = axis.length().atan2(first.dot(second));
    let Some(axis) = axis.try_normalize().filter(|_| angle > STRAIGHT) else { return a.lerp(b, f) };
    let radius = a.distance(corner) / (0.5 * angle).tan();
    let centre = a + radius * axis.cross(first);
    centre + DQuat::from_axis_angle(axis, f * angle) * (a - centre)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn line(point: [f64; 3], speed_mm_s: f64, zone_mm: f64) -> LineMove {
        let to = RobotPose { point: DVec3::from_array(point), turn: DQuat::IDENTITY };
        LineMove { to, externals: Vec::new(), configuration: Vec::new(), speed_mm_s, zone_mm }
    }

    fn start() -> Station {
        Station { pose: RobotPose::IDENTITY, externals: Vec::new() }
    }

    /// A square corner: the parabola passes at a quarter of the diagonal of the zone's square, the arc on its circle.
    #[test]
    fn corners_have_their_closed_forms() {
        let lines = [line([10.0, 0.0, 0.0], 5.0, 2.0), line([10.0, 10.0, 0.0], 5.0, 0.0)];
        let lines: Vec<&LineMove> = lines.iter().collect();
        let play = RobotPlay::new(&start(), &lines, BlendShape::Parabola);
        assert_eq!(play.pieces.len(), 3);
        assert!((play.seconds - 4.0).abs() < 1e-12);
        let middle = play.pieces[1].at(0.5).pose.point;
        assert!((middle - DVec3::new(9.5, 0.5, 0.0)).length() < 1e-12);
        let play = RobotPlay::new(&start(), &lines, BlendShape::Circle);
        assert!((play.seconds - (16.0 + 2.0 * FRAC_PI_2) / 5.0).abs() < 1e-12);
        for f in [0.0, 0.3, 0.5, 1.0] {
            let point = play.pieces[1].at(f).pose.point;
            assert!((point.distance(DVec3::new(8.0, 2.0, 0.0)) - 2.0).abs() < 1e-12);
        }
        assert!((play.pieces[1].at(1.0).pose.point - DVec3::new(10.0, 2.0, 0.0)).length() < 1e-12);
    }

    /// A zone counts up to half of the shorter line; a zone of 0 is a stop at the point.
    #[test]
    fn zones_end_in_the_middle_of_lines() {
        let lines =
            [line([1.0, 0.0, 0.0], 5.0, 50.0), line([1.0, 4.0, 0.0], 5.0, 0.0), line([1.0, 4.0, 9.0], 5.0, 0.0)];
        let lines: Vec<&LineMove> = lines.iter().collect();
        let play = RobotPlay::new(&start(), &lines, BlendShape::Parabola);
        assert!((play.pieces[0].at(1.0).pose.point - DVec3::new(0.5, 0.0, 0.0)).length() < 1e-12);
        assert!((play.pieces[1].at(1.0).pose.point - DVec3::new(1.0, 0.5, 0.0)).length() < 1e-12);
        assert_eq!(play.pieces.len(), 4);
        assert!((play.seconds - 14.0 / 5.0).abs() < 1e-12);
    }

    #[test]
    fn orientations_turn_evenly_about_one_axis() {
        let mut turned = line([10.0, 0.0, 0.0], 10.0, 0.0);
        turned.to.turn = DQuat::from_rotation_z(0.9 * PI);
        turned.externals = vec![30.0];
        let start = Station { externals: vec![10.0], ..start() };
        let play = RobotPlay::new(&start, &[&turned], BlendShape::Parabola);
        let at = play.pieces[0].at(0.25);
        assert!(at.pose.angle_to(&RobotPose { turn: DQuat::from_rotation_z(0.225 * PI), ..at.pose }) < 1e-9);
        assert!((at.externals[0] - 15.0).abs() < 1e-12);
    }
}
