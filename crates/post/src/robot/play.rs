//! Lines, arcs and corners as a robot control plays them.
//!
//! Between two poses the tool centre point goes along the straight line, or the arc through a point between them, in the
//! work frame at the programmed speed. Orientation and external axes are those of the `way` module, in proportion to
//! the way. A moving positioner carries the work frame: the line is straight on the work (coordinated motion).
//!
//! A corner begins on the move before it and ends on the move behind it, both at a way of the zone's radius from the
//! programmed point. The radius counts up to half of the shorter move. Between them the motions of both moves are mixed
//! evenly, in the time that their parts would take: between lines a parabola. Universal Robots: between lines an arc that
//! touches both, passed at the programmed speed.

use super::language::RobotLanguage;
use super::pose::RobotPose;
use super::program::TcpMove;
use super::way::{CircularRule, Way};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// Shape of the path round a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BlendShape {
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

/// A part of a played path: the middle of a move, or a corner.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotPiece {
    /// Time at its start, s.
    pub begin_s: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Index of the move that it belongs to; a corner belongs to the move before it.
    pub line: usize,
    course: PieceCourse,
}

#[derive(Debug, Clone, PartialEq)]
enum PieceCourse {
    /// Parts of a way from one to another.
    Middle { way: Arc<Way>, from: f64, to: f64 },
    /// The end of a way from a part on, and the start of the next one up to a part.
    Corner { before: Arc<Way>, from: f64, after: Arc<Way>, to: f64, shape: BlendShape },
}

/// A sequence of moves as played.
#[derive(Debug, Clone, PartialEq)]
pub struct RobotPlay {
    /// Its parts in time.
    pub pieces: Vec<RobotPiece>,
    /// Duration, s.
    pub seconds: f64,
}

/// A move with what the play needs of it.
struct Line {
    way: Arc<Way>,
    length: f64,
    speed: f64,
    /// Radii of the corners at both ends.
    radii: [f64; 2],
}

impl Line {
    /// Part of the way after `mm`.
    fn part(&self, mm: f64) -> f64 {
        if self.length > 0.0 { mm / self.length } else { 1.0 }
    }
}

impl RobotPlay {
    /// Plays `moves` from `start` on by the rules of `language`.
    pub fn new(start: &Station, moves: &[&TcpMove], language: RobotLanguage) -> Self {
        let mut play = Self { pieces: Vec::new(), seconds: 0.0 };
        let shape = language.blend_shape();
        let lines = measured(start, moves, language.circular_rule());
        for (i, line) in lines.iter().enumerate() {
            let [first, last] = line.radii;
            let middle = (line.length - first - last).max(0.0);
            let end = line.part(line.length - last);
            if middle > 0.0 {
                let course = PieceCourse::Middle { way: line.way.clone(), from: line.part(first), to: end };
                play.add(i, middle / line.speed, course);
            }
            let Some(next) = lines.get(i + 1).filter(|_| last > 0.0) else { continue };
            let seconds = corner_seconds(line, next, shape);
            let (before, after) = (line.way.clone(), next.way.clone());
            play.add(i, seconds, PieceCourse::Corner { before, from: end, after, to: next.part(last), shape });
        }
        play
    }

    fn add(&mut self, line: usize, seconds: f64, course: PieceCourse) {
        self.pieces.push(RobotPiece { begin_s: self.seconds, seconds, line, course });
        self.seconds += seconds;
    }
}

fn measured(start: &Station, moves: &[&TcpMove], rule: CircularRule) -> Vec<Line> {
    let mut from = start.clone();
    let mut all: Vec<Line> = Vec::new();
    for step in moves {
        let way = Arc::new(Way::of(&from, step, rule));
        from = way.to.clone();
        all.push(Line { length: way.length(), way, speed: step.speed_mm_s, radii: [0.0; 2] });
    }
    for i in 1..all.len() {
        let half = 0.5 * all[i - 1].length.min(all[i].length);
        let radius = moves[i - 1].zone_mm.min(half);
        all[i - 1].radii[1] = radius;
        all[i].radii[0] = radius;
    }
    all
}

/// Angle by which the path turns from one way to the next, rad.
pub(super) fn bend(way: &Way, next: &Way) -> f64 {
    let (a, b) = (way.directions()[1], next.directions()[0]);
    a.cross(b).length().atan2(a.dot(b))
}

/// Length by which a corner of `radius` between two ways is shorter than the parts of them that it replaces, on either
/// side.
pub(super) fn corner_cut(way: &Way, next: &Way, shape: BlendShape, radius: f64) -> f64 {
    let is_circle = shape == BlendShape::Circle && !way.is_arc() && !next.is_arc();
    if is_circle { radius * shortening(bend(way, next)) } else { 0.0 }
}

/// Part by which an arc round a corner is shorter than the two parts of the lines that it replaces.
fn shortening(angle: f64) -> f64 {
    if angle > STRAIGHT { 1.0 - 0.5 * angle / (0.5 * angle).tan() } else { 0.0 }
}

fn corner_seconds(line: &Line, next: &Line, shape: BlendShape) -> f64 {
    let radius = line.radii[1];
    let way = radius - corner_cut(&line.way, &next.way, shape, radius);
    way / line.speed + way / next.speed
}

impl RobotPiece {
    /// Station at the fraction `f` of its time.
    pub fn at(&self, f: f64) -> Station {
        match &self.course {
            PieceCourse::Middle { way, from, to } => way.at(from + f * (to - from)),
            PieceCourse::Corner { before, from, after, to, shape } => {
                let mut station = before.at(from + f * (1.0 - from)).towards(&after.at(f * to), f);
                if *shape == BlendShape::Circle && !before.is_arc() && !after.is_arc() {
                    let ends = [before.at(*from), before.to.clone(), after.at(*to)];
                    station.pose.point = on_arc(ends.map(|s| s.pose.point), f);
                }
                station
            }
        }
    }

    /// True if an arc is part of it.
    pub fn is_arc(&self) -> bool {
        match &self.course {
            PieceCourse::Middle { way, .. } => way.is_arc(),
            PieceCourse::Corner { before, after, .. } => before.is_arc() || after.is_arc(),
        }
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
    use crate::robot::program::ThroughPoint;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn line(point: [f64; 3], speed_mm_s: f64, zone_mm: f64) -> TcpMove {
        let to = RobotPose { point: DVec3::from_array(point), turn: DQuat::IDENTITY };
        TcpMove { via: None, to, externals: Vec::new(), configuration: Vec::new(), speed_mm_s, zone_mm }
    }

    fn start() -> Station {
        Station { pose: RobotPose::IDENTITY, externals: Vec::new() }
    }

    /// A square corner: the parabola passes at a quarter of the diagonal of the zone's square, the arc on its circle.
    #[test]
    fn corners_have_their_closed_forms() {
        let lines = [line([10.0, 0.0, 0.0], 5.0, 2.0), line([10.0, 10.0, 0.0], 5.0, 0.0)];
        let lines: Vec<&TcpMove> = lines.iter().collect();
        let play = RobotPlay::new(&start(), &lines, RobotLanguage::Rapid);
        assert_eq!(play.pieces.len(), 3);
        assert!((play.seconds - 4.0).abs() < 1e-12);
        let middle = play.pieces[1].at(0.5).pose.point;
        assert!((middle - DVec3::new(9.5, 0.5, 0.0)).length() < 1e-12);
        let play = RobotPlay::new(&start(), &lines, RobotLanguage::Urscript);
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
        let lines: Vec<&TcpMove> = lines.iter().collect();
        let play = RobotPlay::new(&start(), &lines, RobotLanguage::Rapid);
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
        let play = RobotPlay::new(&start, &[&turned], RobotLanguage::Rapid);
        let at = play.pieces[0].at(0.25);
        assert!(at.pose.angle_to(&RobotPose { turn: DQuat::from_rotation_z(0.225 * PI), ..at.pose }) < 1e-9);
        assert!((at.externals[0] - 15.0).abs() < 1e-12);
    }

    /// A quarter circle between two lines that touch it: the corners stay within the sagitta of the zone, and the time is
    /// that of the whole way.
    #[test]
    fn arcs_join_lines() {
        let via = ThroughPoint {
            pose: RobotPose {
                point: DVec3::new(10.0 + 20.0 * 0.5f64.sqrt(), 20.0 - 20.0 * 0.5f64.sqrt(), 0.0),
                ..RobotPose::IDENTITY
            },
            externals: Vec::new(),
            configuration: Vec::new(),
        };
        let arc = TcpMove { via: Some(via), ..line([30.0, 20.0, 0.0], 5.0, 1.0) };
        let lines = [line([10.0, 0.0, 0.0], 5.0, 1.0), arc, line([30.0, 40.0, 0.0], 5.0, 0.0)];
        let play = RobotPlay::new(&start(), &lines.iter().collect::<Vec<_>>(), RobotLanguage::Rapid);
        assert!((play.seconds - (30.0 + 20.0 * FRAC_PI_2) / 5.0).abs() < 1e-9);
        assert_eq!(play.pieces.iter().map(RobotPiece::is_arc).collect::<Vec<_>>(), [false, true, true, true, false]);
        for f in [0.0, 0.25, 0.5, 1.0] {
            let point = play.pieces[2].at(f).pose.point;
            assert!((point.distance(DVec3::new(10.0, 20.0, 0.0)) - 20.0).abs() < 1e-9);
            let off = play.pieces[1].at(f).pose.point.y;
            assert!((0.0..1.0 / 40.0).contains(&off), "{off}");
        }
    }
}
