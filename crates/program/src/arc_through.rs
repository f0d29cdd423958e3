use glam::{DQuat, DVec3};
use seamwright_geometry::{Arc, Curve};
use std::f64::consts::TAU;

/// Number of parts of a way in the computation of its tip's length.
const PARTS: u32 = 16;

/// An arc through three points, or a helix through their projections.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArcThrough {
    /// A point on its axis, at the height of its start, mm.
    pub centre: DVec3,
    /// Unit vector along the axis, about which it turns by the right-hand rule.
    pub axis: DVec3,
    /// From the centre to the start, mm.
    pub out: DVec3,
    /// Angle it turns by, rad, in (0, 2 pi).
    pub sweep: f64,
    /// Way along the axis from start to end, mm; 0 for an arc.
    pub rise: f64,
}

impl ArcThrough {
    /// The arc from `start` through `via` to `end`; about `normal` through their projections, if that is given. `None`
    /// if they lie on a line, or two of them coincide.
    pub fn new(start: DVec3, via: DVec3, end: DVec3, normal: Option<DVec3>) -> Option<Self> {
        let flat = |p: DVec3| normal.map_or(p, |n| p - (p - start).dot(n) * n);
        let arc = Arc::through(start, flat(via), flat(end)).ok()?;
        let (centre, axis) = (arc.centre(), arc.axis());
        let (_, sweep) = arc.domain();
        Some(Self { centre, axis, out: start - centre, sweep, rise: (end - start).dot(axis) })
    }

    /// Length of the way, mm.
    pub fn length(&self) -> f64 {
        self.tangent(0.0).length()
    }

    /// Direction of travel at the part `f` of the way; not of unit length.
    pub fn tangent(&self, f: f64) -> DVec3 {
        let across = DQuat::from_axis_angle(self.axis, f * self.sweep) * self.axis.cross(self.out);
        self.sweep * across + self.rise * self.axis
    }

    /// The part of the way at which it passes nearest to `place`, by its angle.
    pub fn part_of(&self, place: DVec3) -> f64 {
        let to = place - self.centre;
        self.axis.dot(self.out.cross(to)).atan2(self.out.dot(to)).rem_euclid(TAU) / self.sweep
    }

    /// The position at the part `f` of the way.
    pub fn at(&self, f: f64) -> DVec3 {
        self.centre + f * self.rise * self.axis + DQuat::from_axis_angle(self.axis, f * self.sweep) * self.out
    }
}

/// Length of a way whose tip is at `tip(f)` at its part `f`, mm: by chords, with their shortfall estimated from half as
/// many.
pub fn tip_way(tip: impl Fn(f64) -> DVec3) -> f64 {
    let tips: Vec<DVec3> = (0..=PARTS).map(|k| tip(f64::from(k) / f64::from(PARTS))).collect();
    let chords = |step: usize| -> f64 {
        let ends = tips.iter().step_by(step);
        ends.clone().zip(ends.skip(1)).map(|(a, b)| a.distance(*b)).sum()
    };
    (4.0 * chords(1) - chords(2)) / 3.0
}
