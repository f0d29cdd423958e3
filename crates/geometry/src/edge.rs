use crate::curve::{Curve, Jet};
use glam::{DQuat, DVec3};

/// A point of an edge: position, first derivative, and the outward unit normals of the two faces that meet there.
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

    /// Unit direction square to both faces at parameter `u`, at the edge point `at`: the tangent, or a smoother one
    /// near it if the tangent's second derivative jumps.
    fn along(&self, _u: f64, at: &EdgePoint) -> DVec3 {
        at.d1.normalize()
    }
}

/// Rule for the faces' normals of a curve that lies in a plane, on a cylinder or is straight. All directions are unit
/// vectors, normals point outward, and `about` is a point on the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum FaceRule {
    /// The curve lies in a plate with this normal and a wall rises from it along that normal: first face the wall,
    /// second the plate. The wall faces to the right of the curve with the plate below (away from the inside of a
    /// counter-clockwise curve), or to the `left`.
    WallOnPlate { plate: DVec3, left: bool },
    /// The curve lies on a cylinder and both faces are its outside (a butt joint).
    Cylinder { about: DVec3, axis: DVec3 },
    /// The curve lies on a cylinder and a wall stands on it, square to it: first face the wall, second the cylinder.
    /// The wall faces to the right of the curve with the cylinder below, or to the `left`.
    WallOnCylinder { about: DVec3, axis: DVec3, left: bool },
    /// Two flat faces with these normals, which are equal for a butt joint in one plane.
    Fixed { n1: DVec3, n2: DVec3 },
    /// Two faces that turn with an arc: the normals at its start, turned about its axis by the parameter.
    Turning { axis: DVec3, n1: DVec3, n2: DVec3 },
}

/// A curve with a [`FaceRule`].
#[derive(Debug, Clone, PartialEq)]
pub struct CurvedEdge<C> {
    /// The curve.
    pub curve: C,
    /// Its faces.
    pub faces: FaceRule,
}

/// The face of a wall along `d1` with the face of normal `below` under it: to the right, or to the left.
fn wall(d1: DVec3, below: DVec3, left: bool) -> DVec3 {
    let right = d1.cross(below).normalize();
    if left { -right } else { right }
}

/// Unit vector out of a cylinder at a point, seen from a point of its axis.
fn out_of_cylinder(point: DVec3, axis: DVec3) -> DVec3 {
    (point - point.dot(axis) * axis).normalize()
}

impl<C: Curve> Curve for CurvedEdge<C> {
    fn domain(&self) -> (f64, f64) {
        self.curve.domain()
    }
    fn closed(&self) -> bool {
        self.curve.closed()
    }
    fn jet(&self, u: f64) -> Jet {
        self.curve.jet(u)
    }
    fn breaks(&self) -> Vec<f64> {
        self.curve.breaks()
    }
}

impl<C: Curve> Edge for CurvedEdge<C> {
    fn edge(&self, u: f64) -> EdgePoint {
        let jet = self.curve.jet(u);
        let (n1, n2) = match self.faces {
            FaceRule::WallOnPlate { plate, left } => (wall(jet.d1, plate, left), plate),
            FaceRule::Cylinder { about, axis } => {
                let out = out_of_cylinder(jet.point - about, axis);
                (out, out)
            }
            FaceRule::WallOnCylinder { about, axis, left } => {
                let out = out_of_cylinder(jet.point - about, axis);
                (wall(jet.d1, out, left), out)
            }
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
    use crate::ellipse::Ellipse;

    #[test]
    fn the_wall_of_a_tube_faces_outward() {
        let curve = Ellipse::new(DVec3::ZERO, DVec3::Z, DVec3::X, 20.0, 16.0).unwrap();
        let edge = CurvedEdge { curve, faces: FaceRule::WallOnPlate { plate: DVec3::Z, left: false } };
        for i in 0..50 {
            let p = edge.edge(f64::from(i) * 0.13);
            assert!(p.n1.dot(p.point) > 0.0);
            assert!(p.n1.dot(p.d1).abs() < 1e-13);
            assert!((p.n1.length() - 1.0).abs() < 1e-15);
        }
    }
}
