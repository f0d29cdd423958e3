use crate::head::Face;
use crate::tube_intersection::{SAMPLES, check_margin, minimum};
use crate::{
    Curve, Edge, EdgePoint, Error, Foot, Head, Jet, SignedDistance, TorusIntersection, Tube, TubeIntersection,
};
use glam::DVec3;
use std::f64::consts::TAU;

/// The curve where a tube's wall leaves the [`Head`] of a vessel, parametrised by the angle about the tube's axis
/// (rad).
///
/// In each zone it is the curve on that zone's surface: the closed form on a quadric, Newton's method on a torus.
/// Point, tangent and normals are continuous from zone to zone; the second derivative jumps at the
/// [`breaks`](Curve::breaks).
#[derive(Debug, Clone, PartialEq)]
pub struct HeadIntersection {
    tube: Tube,
    head: Head,
    walls: Vec<Wall>,
    /// Where each piece begins, rad in [0, 2 pi), and its zone.
    pieces: Vec<(f64, usize)>,
}

/// The tube's wall and the surface of a zone.
#[derive(Debug, Clone, PartialEq)]
enum Wall {
    Quadric(Box<TubeIntersection>),
    Torus(TorusIntersection),
}

/// Nearer to a border than this, mm, the curve does not go beyond it.
const AT_BORDER_MM: f64 = 1e-9;
/// Pieces shorter than this, rad, within another zone are left out: beyond the border by less than a part in 1e11 of
/// their radius.
const SHORTEST: f64 = 1e-5;

impl HeadIntersection {
    /// The closed curve where `tube` leaves `head`.
    ///
    /// # Errors
    /// [`Error::TubeLargerThanBody`], [`Error::TubeBesideBody`], [`Error::NotClosed`], [`Error::Tangent`] or
    /// [`Error::BeyondHead`] if the curve does not exist, is not closed and smooth, or does not lie on the head.
    pub fn new(tube: Tube, head: Head) -> Result<Self, Error> {
        let wall = |face: &Face| match face {
            Face::Quadric(q) => Wall::Quadric(Box::new(TubeIntersection::unchecked(tube.clone(), q.0.clone()))),
            Face::Torus(torus) => Wall::Torus(TorusIntersection::on_outer_half(tube.clone(), torus.clone())),
        };
        let walls = head.faces().map(wall).collect();
        let mut curve = Self { tube, head, walls, pieces: Vec::new() };
        curve.check()?;
        curve.pieces = curve.found_pieces();
        Ok(curve)
    }

    /// The tube.
    pub fn tube(&self) -> &Tube {
        &self.tube
    }

    /// The head.
    pub fn head(&self) -> &Head {
        &self.head
    }

    /// The point at which the wall's line at `phi` leaves the head, whatever the zone.
    fn leaving(&self, phi: f64) -> Option<DVec3> {
        let foot = self.tube.wall(phi).0;
        self.head.way_out(foot, self.tube.e3).map(|h| foot + h * self.tube.e3)
    }

    fn check(&self) -> Result<(), Error> {
        let steepness = |p: DVec3| {
            let Foot { normal, .. } = self.head.foot(p);
            normal.dot(self.tube.e3).powi(2)
        };
        let axis_meets = self.head.way_out(self.tube.origin, self.tube.e3).is_some();
        check_margin(&|phi| self.leaving(phi).map_or(-1.0, steepness), axis_meets)?;
        let off_tip = |phi| self.leaving(phi).map_or(f64::NAN, |p| self.head.off_tip(p).min(1.0));
        check_margin(&off_tip, axis_meets)?;
        let left = |p| -self.head.beyond(p).last().unwrap_or(f64::NAN);
        check_margin(&|phi| self.leaving(phi).map_or(f64::NAN, left).min(1.0), axis_meets).map_err(|e| match e {
            Error::NotClosed { from, to } => Error::BeyondHead { from, to },
            Error::Tangent { at } => Error::BeyondHead { from: at, to: at },
            _ => Error::BeyondHead { from: 0.0, to: TAU },
        })
    }

    /// How far the curve is beyond each border between zones at `phi`, mm.
    fn beyond(&self, phi: f64) -> Vec<f64> {
        let borders = self.walls.len() - 1;
        self.leaving(phi).map_or(vec![f64::NAN; borders], |p| self.head.beyond(p).take(borders).collect())
    }

    /// The pieces of the curve, by where it crosses the borders.
    fn found_pieces(&self) -> Vec<(f64, usize)> {
        let step = TAU / SAMPLES as f64;
        let samples: Vec<(f64, Vec<f64>)> =
            (0..=SAMPLES).map(|i| i as f64 * step).map(|phi| (phi, self.beyond(phi))).collect();
        let mut ends: Vec<f64> = Vec::new();
        for border in 0..self.walls.len() - 1 {
            let beyond = |phi: f64| self.beyond(phi)[border];
            let mut places: Vec<(f64, f64)> = samples.iter().map(|(phi, b)| (*phi, b[border])).collect();
            places.extend(turns(&places, step, &beyond));
            places.sort_by(|a, b| a.0.total_cmp(&b.0));
            ends.extend(places.windows(2).filter_map(|w| crossing(w[0], w[1], &beyond)));
        }
        ends.sort_by(f64::total_cmp);
        let zone = |(i, &from): (usize, &f64)| {
            let to = ends.get(i + 1).copied().unwrap_or(ends[0] + TAU);
            let middle = self.beyond((0.5 * (from + to)).rem_euclid(TAU));
            (from, to - from, middle.iter().filter(|b| **b > AT_BORDER_MM).count())
        };
        let pieces: Vec<(f64, f64, usize)> = ends.iter().enumerate().map(zone).collect();
        let mut kept: Vec<(f64, usize)> = Vec::new();
        for (i, &(from, width, zone)) in pieces.iter().enumerate() {
            let around = [&pieces[(i + pieces.len() - 1) % pieces.len()], &pieces[(i + 1) % pieces.len()]];
            let tiny = width < SHORTEST && around[0].2 == around[1].2;
            if !tiny && kept.last().is_none_or(|last| last.1 != zone) {
                kept.push((from, zone));
            }
        }
        if kept.len() > 1 && kept[0].1 == kept[kept.len() - 1].1 {
            kept.remove(0);
        }
        if kept.is_empty() {
            kept.push((0.0, self.beyond(0.0).iter().filter(|b| **b > AT_BORDER_MM).count()));
        }
        kept
    }

    fn wall(&self, phi: f64) -> &Wall {
        let phi = phi.rem_euclid(TAU);
        let after = self.pieces.partition_point(|piece| piece.0 <= phi);
        // Before the first piece begins, the last goes on.
        let piece = if after == 0 { self.pieces.len() - 1 } else { after - 1 };
        &self.walls[self.pieces[piece].1]
    }
}

/// Places between samples `step` apart at which a function turns back towards 0 and may cross it, with its values.
fn turns(places: &[(f64, f64)], step: f64, f: &dyn Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let count = places.len() - 1;
    let turn = |i: usize| {
        let [l, m, r] = [(i + count - 1) % count, i, i + 1].map(|k| places[k].1);
        let sign = m.signum();
        (sign * l > 0.0 && sign * r > 0.0 && sign * m <= sign * l && sign * m <= sign * r).then(|| {
            let at = minimum(&|phi| sign * f(phi), places[i].0 - step, places[i].0 + step).rem_euclid(TAU);
            (at, f(at))
        })
    };
    (0..count).filter_map(turn).collect()
}

/// Where between two places a function crosses 0, to full precision.
fn crossing(from: (f64, f64), to: (f64, f64), f: &dyn Fn(f64) -> f64) -> Option<f64> {
    if (from.1 > AT_BORDER_MM) == (to.1 > AT_BORDER_MM) {
        return None;
    }
    let (mut below, mut above) = if to.1 > AT_BORDER_MM { (from, to.0) } else { (to, from.0) };
    // Where the curve lies along the border for a while, 0 is no place.
    let level = if below.1 <= 0.0 { 0.0 } else { AT_BORDER_MM };
    for _ in 0..60 {
        let middle = 0.5 * (below.0 + above);
        if f(middle) > level { above = middle } else { below.0 = middle }
    }
    Some((0.5 * (below.0 + above)).rem_euclid(TAU))
}

impl Curve for HeadIntersection {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    fn breaks(&self) -> Vec<f64> {
        if self.pieces.len() > 1 { self.pieces.iter().map(|piece| piece.0).collect() } else { Vec::new() }
    }
    fn jet(&self, phi: f64) -> Jet {
        match self.wall(phi) {
            Wall::Quadric(wall) => wall.jet(phi),
            Wall::Torus(wall) => wall.jet(phi),
        }
    }
    fn point(&self, phi: f64) -> DVec3 {
        match self.wall(phi) {
            Wall::Quadric(wall) => wall.point(phi),
            Wall::Torus(wall) => wall.point(phi),
        }
    }
    fn speed(&self, phi: f64) -> f64 {
        match self.wall(phi) {
            Wall::Quadric(wall) => wall.speed(phi),
            Wall::Torus(wall) => wall.speed(phi),
        }
    }
}

impl Edge for HeadIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        match self.wall(phi) {
            Wall::Quadric(wall) => wall.edge(phi),
            Wall::Torus(wall) => wall.edge(phi),
        }
    }
}
