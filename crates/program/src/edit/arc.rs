//! Arcs as passes through points have them.

use glam::{DQuat, DVec3};
use seamwright_document::Direction;
use seamwright_geometry::{self as geometry, Curve};

/// An arc, or with a normal a helix: it turns about that through the projections of its points, and goes along it evenly.
#[derive(Debug)]
pub(super) struct ArcWay {
    arc: geometry::Arc,
    rise: f64,
}

impl ArcWay {
    /// None if the three places lie on a line.
    pub(super) fn through(start: DVec3, via: DVec3, end: DVec3, normal: Option<Direction>) -> Option<Self> {
        let normal = normal.map(Direction::unit);
        let flat = |p: DVec3| normal.map_or(p, |n| p - (p - start).dot(n) * n);
        let arc = geometry::Arc::through(start, flat(via), flat(end)).ok()?;
        let rise = (end - start).dot(arc.axis());
        Some(Self { rise: if normal.is_some() { rise } else { 0.0 }, arc })
    }

    /// The place at a part of the way from 0 to 1.
    pub(super) fn at(&self, part: f64) -> DVec3 {
        let centre = self.arc.centre();
        let (_, sweep) = self.arc.domain();
        let out = self.arc.jet(0.0).point - centre;
        centre + DQuat::from_axis_angle(self.arc.axis(), part * sweep) * out + part * self.rise * self.arc.axis()
    }

    /// The part of the way at which the arc passes nearest to `place`, by its angle.
    pub(super) fn part_of(&self, place: DVec3) -> f64 {
        let (axis, centre) = (self.arc.axis(), self.arc.centre());
        let (from, to) = (self.arc.jet(0.0).point - centre, place - centre);
        let angle = axis.dot(from.cross(to)).atan2(from.dot(to)).rem_euclid(std::f64::consts::TAU);
        angle / self.arc.domain().1
    }

    /// Direction of travel at a part of the way; not of unit length.
    pub(super) fn tangent(&self, part: f64) -> DVec3 {
        let (_, sweep) = self.arc.domain();
        let out = self.arc.jet(0.0).point - self.arc.centre();
        let across = DQuat::from_axis_angle(self.arc.axis(), part * sweep) * self.arc.axis().cross(out);
        sweep * across + self.rise * self.arc.axis()
    }

    /// Length of the way, mm.
    pub(super) fn length(&self) -> f64 {
        self.tangent(0.0).length()
    }
}
