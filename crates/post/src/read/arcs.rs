//! Arcs from the words of programs. All turn about `normal` by the right-hand rule; the opposite sense has the opposite
//! normal.

use crate::part_program::Arc;
use glam::DVec3;
use seamwright_geometry::Curve;
use std::f64::consts::TAU;

/// Maximum error of an arc's end or radius that a control accepts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tolerance {
    /// Off by less is always taken, mm.
    pub(super) least: f64,
    /// Off by less than this part of the radius is taken.
    pub(super) relative: f64,
    /// Off by more is never taken, mm.
    pub(super) most: f64,
    /// A radius may be shorter by this than half the way to the end, mm.
    pub(super) radius: f64,
    /// An arc of less is a full circle more, rad.
    pub(super) least_angle: f64,
    /// Code of the rule's name.
    pub(super) rule: &'static str,
}

impl Tolerance {
    /// Maximum distance of the end from a circle of this radius, mm.
    pub(super) fn off(&self, radius: f64) -> f64 {
        self.least.max(self.relative * radius).min(self.most)
    }
}

/// Distances of `start` and `end` from the axis through `centre`.
pub(super) fn radii(start: DVec3, end: DVec3, centre: DVec3, normal: DVec3) -> (f64, f64) {
    let radius = |p: DVec3| (p - centre).reject_from_normalized(normal).length();
    (radius(start), radius(end))
}

/// The arc about `centre` from `start` to `end`, with `turns` full turns more.
pub(super) fn about(start: DVec3, end: DVec3, centre: DVec3, normal: DVec3, turns: u32, least_angle: f64) -> Arc {
    let angle = Arc::angle(start, end, centre, normal);
    let angle = if angle < least_angle { angle + TAU } else { angle };
    Arc { centre, normal, sweep: angle + f64::from(turns) * TAU }
}

/// Centre of the arc of this radius: of at most half a circle, or of more if the radius is negative. `None` without a
/// way, or if half the way from `start` to `end` exceeds the radius by more than `slack`.
pub(super) fn by_radius(start: DVec3, end: DVec3, radius: f64, normal: DVec3, slack: f64) -> Option<DVec3> {
    let chord = (end - start).reject_from_normalized(normal);
    let half = 0.5 * chord.length();
    if half - radius.abs() > slack || half <= 0.0 {
        return None;
    }
    let aside = (radius * radius - half * half).max(0.0).sqrt().copysign(radius);
    Some(start + 0.5 * chord + aside * normal.cross(chord / (2.0 * half)))
}

/// Centre of the arc that turns by `angle` (rad, more than 0 and less than a full turn).
pub(super) fn by_angle(start: DVec3, end: DVec3, angle: f64, normal: DVec3) -> Option<DVec3> {
    let chord = (end - start).reject_from_normalized(normal);
    if chord.length() <= 0.0 {
        return None;
    }
    Some(start + 0.5 * chord + 0.5 / (0.5 * angle).tan() * normal.cross(chord))
}

pub(super) fn turned(start: DVec3, centre: DVec3, angle: f64, normal: DVec3) -> DVec3 {
    Arc { centre, normal, sweep: angle }.at(start, start, 1.0)
}

/// The arc from `start` through `middle` to `end`. `None` if the three are on a line.
pub(super) fn through(start: DVec3, middle: DVec3, end: DVec3) -> Option<Arc> {
    let arc = seamwright_geometry::Arc::through(start, middle, end).ok()?;
    let (_, sweep) = arc.domain();
    Some(Arc { centre: arc.centre(), normal: arc.axis(), sweep })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_through_three_points_goes_through_them() {
        let (a, b, c) = (DVec3::new(1.0, 0.0, 0.0), DVec3::new(0.0, 1.0, 0.0), DVec3::new(0.0, -1.0, 0.0));
        let arc = through(a, b, c).unwrap();
        assert!((arc.sweep - 0.75 * TAU).abs() < 1e-12 && arc.centre.length() < 1e-12);
        assert!((arc.at(a, c, 1.0 / 3.0) - b).length() < 1e-12);
        assert!(through(a, 2.0 * a, 3.0 * a).is_none());
    }

    #[test]
    fn a_radius_has_a_short_arc_and_a_long_one() {
        let (a, b) = (DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0));
        for (radius, part) in [(2f64.sqrt(), 0.25), (-(2f64.sqrt()), 0.75)] {
            let centre = by_radius(a, b, radius, DVec3::Z, 0.0).unwrap();
            assert!((about(a, b, centre, DVec3::Z, 0, 1e-6).sweep - part * TAU).abs() < 1e-12);
        }
        assert!(by_radius(a, b, 0.9, DVec3::Z, 0.01).is_none());
        assert!(by_radius(a, a, 0.9, DVec3::Z, 0.01).is_none());
    }

    #[test]
    fn an_angle_gives_its_centre() {
        let (a, b) = (DVec3::ZERO, DVec3::new(2.0, 0.0, 1.0));
        for degrees in [1.0f64, 90.0, 179.0, 181.0, 300.0] {
            let centre = by_angle(a, b, degrees.to_radians(), DVec3::Z).unwrap();
            assert!((about(a, b, centre, DVec3::Z, 0, 1e-6).sweep.to_degrees() - degrees).abs() < 1e-9);
        }
    }
}
