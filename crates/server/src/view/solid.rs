use crate::wire::{ShapeView, SolidView};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};

/// Returns a frame row by row, 3 x 4.
pub(crate) fn rows(frame: &DAffine3) -> [f64; 12] {
    let m = frame.matrix3;
    let t = frame.translation;
    [
        m.x_axis.x, m.y_axis.x, m.z_axis.x, t.x, m.x_axis.y, m.y_axis.y, m.z_axis.y, t.y, m.x_axis.z, m.y_axis.z,
        m.z_axis.z, t.z,
    ]
}

pub(super) fn solid(solid: &Solid, link: usize) -> SolidView {
    SolidView { name: solid.name().to_owned(), shape: shape(solid.shape()), frame: rows(solid.pose()), link }
}

fn shape(shape: &Shape) -> ShapeView {
    match *shape {
        Shape::Box { size } => ShapeView::Box { size: size.to_array() },
        Shape::Sphere { radius } => ShapeView::Sphere { radius },
        Shape::Cylinder { radius, length } => ShapeView::Cone { radius, top_radius: radius, length },
        Shape::Cone { radius, top_radius, length } => ShapeView::Cone { radius, top_radius, length },
        Shape::Capsule { radius, length } => ShapeView::Capsule { radius, length },
        Shape::Ellipsoid { semi_axes } => ShapeView::Ellipsoid { semi_axes: semi_axes.to_array() },
        Shape::HalfSpace => ShapeView::HalfSpace {},
        Shape::Mesh(ref mesh) => {
            let corners = mesh.triangles().iter().flatten();
            ShapeView::Mesh { triangles: corners.flat_map(|p: &DVec3| p.as_vec3().to_array()).collect() }
        }
    }
}
