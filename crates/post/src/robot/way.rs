//! The way of one move: a line or an arc of the tool centre point, with orientation and external axes along it.
//!
//! On a line the orientation turns evenly about one fixed axis, and external axes go evenly. On an arc they follow the
//! [`CircularRule`] of the control.

use super::play::Station;
use super::pose::{RobotPose, shortest};
use super::program::TcpMove;
use crate::plan::arcs::{Normal, through};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// Orientation and external axes along an arc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CircularRule {
    /// The orientation turns evenly about one axis that is fixed to the path: it turns with the tangent. External axes go
    /// evenly. Those of the through-point are ignored.
    Path,
    /// The orientation turns evenly about one axis that is fixed to the work; the through-point's is ignored.
    Work,
    /// From the start to the through-point and from there to the end, orientation about a fixed axis and external axes go
    /// evenly.
    Through,
}

/// A circle with an arc on it, from the start of a way.
#[derive(Debug, Clone, PartialEq)]
struct Circle {
    centre: DVec3,
    normal: DVec3,
    radius: f64,
    sweep: f64,
    /// The through-point, and its part of the sweep.
    via: Station,
    via_part: f64,
    rule: CircularRule,
}

/// A line or an arc between two stations.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Way {
    pub(super) from: Station,
    pub(super) to: Station,
    circle: Option<Circle>,
}

impl Way {
    pub(super) fn line(from: &Station, to: &Station) -> Self {
        Self { from: from.clone(), to: to.clone(), circle: None }
    }

    /// The arc through `via`; `None` if the three points are in line.
    pub(super) fn arc(from: &Station, via: &Station, to: &Station, rule: CircularRule) -> Option<Self> {
        let [start, middle, end] = [from, via, to].map(|station| station.pose.point);
        let arc = through(start, middle, end, Normal::OfPlane)?;
        let via_part = crate::part_program::Arc::angle(start, middle, arc.centre, arc.normal) / arc.sweep;
        let radius = start.distance(arc.centre);
        let (centre, normal, sweep) = (arc.centre, arc.normal, arc.sweep);
        let circle = Circle { centre, normal, radius, sweep, via: via.clone(), via_part, rule };
        Some(Self { from: from.clone(), to: to.clone(), circle: Some(circle) })
    }

    /// The way of a move; an arc whose points are in line is a line.
    pub(super) fn of(from: &Station, step: &TcpMove, rule: CircularRule) -> Self {
        let to = Station { pose: step.to, externals: step.externals.clone() };
        let arc = step.via.as_ref().and_then(|via| {
            let via = Station { pose: via.pose, externals: via.externals.clone() };
            Self::arc(from, &via, &to, rule)
        });
        arc.unwrap_or_else(|| Self::line(from, &to))
    }

    pub(super) fn is_arc(&self) -> bool {
        self.circle.is_some()
    }

    /// Radius of its arc, mm; infinite for a line.
    pub(super) fn radius_mm(&self) -> f64 {
        self.circle.as_ref().map_or(f64::INFINITY, |circle| circle.radius)
    }

    /// Angle of its arc, rad.
    pub(super) fn sweep(&self) -> f64 {
        self.circle.as_ref().map_or(0.0, |circle| circle.sweep)
    }

    /// Way of the tool centre point, mm.
    pub(super) fn length(&self) -> f64 {
        match &self.circle {
            Some(circle) => circle.radius * circle.sweep,
            None => self.from.pose.point.distance(self.to.pose.point),
        }
    }

    /// Chord of the part `part` of the way, mm.
    pub(super) fn chord(&self, part: f64) -> f64 {
        match &self.circle {
            Some(circle) => 2.0 * circle.radius * (0.5 * part * circle.sweep).sin(),
            None => part * self.length(),
        }
    }

    /// Unit directions at its start and end; zero for a way without length.
    pub(super) fn directions(&self) -> [DVec3; 2] {
        let Some(circle) = &self.circle else {
            return [(self.to.pose.point - self.from.pose.point).normalize_or_zero(); 2];
        };
        [&self.from, &self.to].map(|end| circle.normal.cross(end.pose.point - circle.centre).normalize_or_zero())
    }

    /// Part of the way at which it is nearest to `point`.
    pub(super) fn part_of(&self, point: DVec3) -> f64 {
        let start = self.from.pose.point;
        let Some(circle) = &self.circle else {
            let chord = self.to.pose.point - start;
            return ((point - start).dot(chord) / chord.length_squared()).clamp(0.0, 1.0);
        };
        let angle = crate::part_program::Arc::angle(start, point, circle.centre, circle.normal);
        // Beyond the end, or before the start.
        if angle > 0.5 * (circle.sweep + TAU) { 0.0 } else { (angle / circle.sweep).min(1.0) }
    }

    /// Station at the part `f` of the way.
    pub(super) fn at(&self, f: f64) -> Station {
        let Some(circle) = &self.circle else { return self.from.towards(&self.to, f) };
        let mut station = circle.station(&self.from, &self.to, f);
        let round = DQuat::from_axis_angle(circle.normal, f * circle.sweep);
        // The end is on the circle to rounding only.
        let out = self.from.pose.point - circle.centre;
        station.pose.point = circle.centre + round * out;
        station
    }
}

impl Circle {
    /// Orientation and external axes at the part `f`.
    fn station(&self, from: &Station, to: &Station, f: f64) -> Station {
        match self.rule {
            CircularRule::Through if f < self.via_part => from.towards(&self.via, f / self.via_part),
            CircularRule::Through => self.via.towards(to, (f - self.via_part) / (1.0 - self.via_part)),
            CircularRule::Work => from.towards(to, f),
            CircularRule::Path => {
                let round = |angle: f64| DQuat::from_axis_angle(self.normal, angle);
                let turn = shortest(from.pose.turn, round(-self.sweep) * to.pose.turn, f);
                let turn = round(f * self.sweep) * turn;
                let straight = from.towards(to, f);
                Station { pose: RobotPose { turn, ..straight.pose }, ..straight }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::{Random, cases};

    /// A torch that turns with the path keeps its attitude by every rule on arcs below half a turn, and by that of the path
    /// beyond; points are those of the circle in closed form.
    #[test]
    fn a_torch_that_turns_with_the_path_follows_every_rule() {
        let mut random = Random::new(47);
        for case in 0..cases(300u32) {
            let (normal, centre) = (random.direction(), random.vector(200.0));
            let (out, first) = (normal.any_orthonormal_vector() * random.within(2.0, 300.0), random.direction());
            let start = DQuat::from_axis_angle(first, random.within(-3.0, 3.0));
            let sweep = random.within(0.1, if case % 2 == 0 { 3.0 } else { 5.5 });
            let at = |f: f64| {
                let round = DQuat::from_axis_angle(normal, f * sweep);
                let pose = RobotPose { point: centre + round * out, turn: round * start };
                Station { pose, externals: vec![10.0 * f] }
            };
            let rules = [CircularRule::Path, CircularRule::Work, CircularRule::Through];
            let ends = [at(0.0), at(0.4), at(1.0)];
            for rule in rules.into_iter().take(if sweep < 3.1 { 3 } else { 1 }) {
                let way = Way::arc(&ends[0], &ends[1], &ends[2], rule).unwrap();
                assert!((way.length() - sweep * out.length()).abs() < 1e-6);
                for f in [0.0, 0.2, 0.5, 0.9, 1.0] {
                    let (found, expected) = (way.at(f), at(f));
                    assert!(found.pose.point.distance(expected.pose.point) < 1e-6, "{rule:?}");
                    assert!(found.pose.angle_to(&expected.pose) < 1e-6, "{rule:?} {f}");
                    assert!((found.externals[0] - 10.0 * f).abs() < 1e-6);
                    assert!((way.part_of(expected.pose.point) - f).abs() < 1e-6);
                }
            }
        }
    }
}
