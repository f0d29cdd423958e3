use crate::curve::{Curve, Jet};
use crate::edge::{Edge, EdgePoint};
use crate::error::Error;
use crate::parallel_surface::ParallelIntersection;
use crate::pieces::{AT_BORDER_MM, Pieces};
use crate::signed_distance::{Foot, SignedDistance};
use crate::torus_intersection::TorusIntersection;
use crate::tube::Tube;
use crate::tube_intersection::{TubeIntersection, check_margin};
use crate::vessel_head::{Face, Head};
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
    pieces: Pieces,
}

/// The tube's wall and the surface of a zone.
#[derive(Debug, Clone, PartialEq)]
enum Wall {
    Quadric(Box<TubeIntersection>),
    Torus(TorusIntersection),
    Parallel(Box<ParallelIntersection>),
}

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
            Face::Parallel(body) => {
                Wall::Parallel(Box::new(ParallelIntersection::unchecked(tube.clone(), (**body).clone())))
            }
        };
        let walls = head.faces().map(wall).collect();
        let mut curve = Self { tube, head, walls, pieces: Pieces::whole(0) };
        curve.check()?;
        let zone = |phi| curve.beyond(phi).iter().filter(|b| **b > AT_BORDER_MM).count();
        let pieces = Pieces::new(curve.walls.len() - 1, &|phi| curve.beyond(phi), &zone);
        curve.pieces = pieces;
        Ok(curve)
    }

    /// The tube.
    pub fn tube(&self) -> &Tube {
        &self.tube
    }

    /// The point at which the wall's line at `phi` leaves the head, in any zone.
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

    /// Distance of the curve beyond each border between zones at `phi`, mm.
    fn beyond(&self, phi: f64) -> Vec<f64> {
        let borders = self.walls.len() - 1;
        self.leaving(phi).map_or(vec![f64::NAN; borders], |p| self.head.beyond(p).take(borders).collect())
    }

    fn wall(&self, phi: f64) -> &dyn Edge {
        match &self.walls[self.pieces.zone(phi)] {
            Wall::Quadric(wall) => &**wall,
            Wall::Torus(wall) => wall,
            Wall::Parallel(wall) => &**wall,
        }
    }
}

impl Curve for HeadIntersection {
    fn domain(&self) -> (f64, f64) {
        (0.0, TAU)
    }
    fn closed(&self) -> bool {
        true
    }
    fn breaks(&self) -> Vec<f64> {
        self.pieces.breaks()
    }
    fn jet(&self, phi: f64) -> Jet {
        self.wall(phi).jet(phi)
    }
    fn point(&self, phi: f64) -> DVec3 {
        self.wall(phi).point(phi)
    }
    fn speed(&self, phi: f64) -> f64 {
        self.wall(phi).speed(phi)
    }
}

impl Edge for HeadIntersection {
    fn edge(&self, phi: f64) -> EdgePoint {
        self.wall(phi).edge(phi)
    }
}
