use crate::{Curve, Jet};
use glam::{DQuat, DVec3};

/// A point of an edge: where it is, where it runs, and the outward unit normals of the two faces that meet there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgePoint {
    /// Position, mm.
    pub point: DVec3,
    /// First derivative of the curve by its parameter.
    pub d1: DVec3,
    /// Outward unit normal of the first face.
    pub n1: DVec3,
    /// Outward unit normal of the second face.
    pub n2: DVec3,
}

/// A curve along which two faces meet.
pub trait Edge: Curve {
    /// Point, first derivative and both faces' outward unit normals at parameter `u`.
    fn edge(&self, u: f64) -> EdgePoint;
}

/// How the faces' normals follow from a curve that lies in a plane or is straight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FaceRule {
    /// The curve lies in a plate with this outward unit normal and a wall rises from it along that normal: first
    /// face the wall (facing away from the curve's inside, for a counter-clockwise curve), second the plate.
    WallOnPlate {
        /// Outward unit normal of the plate.
        plate: DVec3,
    },
    /// Both faces lie in one plane with this outward unit normal (a butt joint).
    Flat {
        /// Outward unit normal of both faces.
        normal: DVec3,
    },
    /// Two flat faces with these outward unit normals.
    Fixed {
        /// First face.
        n1: DVec3,
        /// Second face.
        n2: DVec3,
    },
    /// Two faces that turn with an arc: the normals at its start, turned about its axis by the parameter.
    Turning {
        /// Unit axis of the arc.
        axis: DVec3,
        /// First face at the start.
        n1: DVec3,
        /// Second face at the start.
        n2: DVec3,
    },
}

/// A curve with a [`FaceRule`].
#[derive(Debug, Clone, PartialEq)]
pub struct CurvedEdge<C> {
    /// The curve.
    pub curve: C,
    /// Its faces.
    pub faces: FaceRule,
}

impl<C: Curve> Curve for CurvedEdge<C> {
    fn domain(&self) -> (f64, f64) {
        self.curve.domain()
    }
    fn closed(&self) -> bool {
        self.curve.closed()
    }
    fn breaks(&self) -> Vec<f64> {
        self.curve.breaks()
    }
    fn jet(&self, u: f64) -> Jet {
        self.curve.jet(u)
    }
}

impl<C: Curve> Edge for CurvedEdge<C> {
    fn edge(&self, u: f64) -> EdgePoint {
        let jet = self.curve.jet(u);
        let (n1, n2) = match self.faces {
            FaceRule::WallOnPlate { plate } => (jet.d1.cross(plate).normalize(), plate),
            FaceRule::Flat { normal } => (normal, normal),
            FaceRule::Fixed { n1, n2 } => (n1, n2),
            FaceRule::Turning { axis, n1, n2 } => {
                let turn = DQuat::from_axis_angle(axis, u);
                (turn * n1, turn * n2)
            }
        };
        EdgePoint { point: jet.point, d1: jet.d1, n1, n2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Ellipse;

    #[test]
    fn the_wall_of_a_tube_faces_outward() {
        let curve = Ellipse::new(DVec3::ZERO, DVec3::Z, DVec3::X, 20.0, 16.0).unwrap();
        let edge = CurvedEdge { curve, faces: FaceRule::WallOnPlate { plate: DVec3::Z } };
        for i in 0..50 {
            let p = edge.edge(f64::from(i) * 0.13);
            assert!(p.n1.dot(p.point) > 0.0);
            assert!(p.n1.dot(p.d1).abs() < 1e-13);
            assert!((p.n1.length() - 1.0).abs() < 1e-15);
        }
    }
}
