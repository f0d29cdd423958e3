use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_machine::Machine;
use std::f64::consts::TAU;

/// Points of a drawn circle.
const AROUND: u32 = 36;

/// Returns outlines of the machine's solids at home, in the base frame, mm: edges of boxes, rims and sides of round
/// shapes. Unbounded half-spaces are omitted; a mesh is shown by its bounding box.
pub(super) fn outlines(machine: &Machine) -> Vec<Vec<[f64; 3]>> {
    let motion = machine.link_frames(&machine.home());
    let base = machine.links.frame("base").map_or(DAffine3::IDENTITY, |f| motion[f.link] * f.zero);
    let to_base = base.inverse();
    let drawn = machine.solids.solids.iter().flat_map(|(link, solid)| {
        let pose = to_base * motion[*link];
        wires(solid).into_iter().map(move |line| line.iter().map(|p| pose.transform_point3(*p).to_array()).collect())
    });
    drawn.collect()
}

/// Returns the lines of one solid, in the frame in which it is given.
fn wires(solid: &Solid) -> Vec<Vec<DVec3>> {
    let local = match *solid.shape() {
        Shape::Box { size } => box_edges(0.5 * size),
        Shape::Cylinder { radius, length } => round(&[(radius, 0.0), (radius, length)]),
        Shape::Cone { radius, top_radius, length } => round(&[(radius, 0.0), (top_radius, length)]),
        Shape::Capsule { radius, length } => {
            let mut lines = round(&[(radius, radius), (radius, length - radius)]);
            for z in [radius, length - radius] {
                lines.extend(
                    ball(DVec3::splat(radius)).into_iter().map(|l| l.into_iter().map(|p| p + z * DVec3::Z).collect()),
                );
            }
            lines
        }
        Shape::Sphere { radius } => ball(DVec3::splat(radius)),
        Shape::Ellipsoid { semi_axes } => ball(semi_axes),
        Shape::Mesh(ref mesh) => {
            let (low, high) = mesh.bounds();
            let moved = |line: Vec<DVec3>| line.into_iter().map(|p| p + 0.5 * (low + high)).collect();
            box_edges(0.5 * (high - low)).into_iter().map(moved).collect()
        }
        Shape::HalfSpace => Vec::new(),
    };
    let placed = |line: Vec<DVec3>| line.into_iter().map(|p| solid.pose().transform_point3(p)).collect();
    local.into_iter().map(placed).collect()
}

fn box_edges(half: DVec3) -> Vec<Vec<DVec3>> {
    let face = |z: f64| {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0)];
        corners.map(|(x, y)| half * DVec3::new(x, y, z)).to_vec()
    };
    let (low, high) = (face(-1.0), face(1.0));
    let upright = (0..4).map(|i| vec![low[i], high[i]]);
    let mut lines: Vec<Vec<DVec3>> = upright.collect();
    lines.extend([low, high]);
    lines
}

/// Returns a point of the circle of radius 1 in the xy plane.
fn on_circle(i: u32) -> DVec3 {
    let (sin, cos) = (TAU * f64::from(i) / f64::from(AROUND)).sin_cos();
    DVec3::new(cos, sin, 0.0)
}

/// Returns rims, each given by radius and height, and four lines between them.
fn round(rims: &[(f64, f64); 2]) -> Vec<Vec<DVec3>> {
    let at = |(radius, z): (f64, f64), i: u32| radius * on_circle(i) + z * DVec3::Z;
    let mut lines: Vec<Vec<DVec3>> = rims.iter().map(|rim| (0..=AROUND).map(|i| at(*rim, i)).collect()).collect();
    lines.extend((0..4).map(|k| rims.map(|rim| at(rim, k * AROUND / 4)).to_vec()));
    lines
}

/// Returns the three great circles (ellipses) of a ball with semi-axes `r`.
fn ball(r: DVec3) -> Vec<Vec<DVec3>> {
    let turned: [fn(DVec3) -> DVec3; 3] = [|p| p, |p| DVec3::new(p.x, 0.0, p.y), |p| DVec3::new(0.0, p.x, p.y)];
    turned.map(|turn| (0..=AROUND).map(|i| r * turn(on_circle(i))).collect()).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every line lies on its solid's surface: a tiny ball on it touches the solid.
    #[test]
    fn lines_lie_on_the_shapes() {
        let pose = DAffine3::from_rotation_translation(glam::DQuat::from_rotation_x(0.7), DVec3::new(3.0, -9.0, 40.0));
        for shape in [
            Shape::Box { size: DVec3::new(10.0, 20.0, 30.0) },
            Shape::Cylinder { radius: 4.0, length: 30.0 },
            Shape::Cone { radius: 4.0, top_radius: 9.0, length: 30.0 },
            Shape::Capsule { radius: 4.0, length: 30.0 },
            Shape::Sphere { radius: 12.0 },
            Shape::Ellipsoid { semi_axes: DVec3::new(3.0, 7.0, 12.0) },
        ] {
            let solid = Solid::new("s", shape, pose).unwrap();
            for p in wires(&solid).concat() {
                let touches = |radius: f64| {
                    let ball = Solid::new("b", Shape::Sphere { radius }, DAffine3::from_translation(p)).unwrap();
                    let zero = DAffine3::IDENTITY;
                    seamwright_clearance::nearest(&ball, &zero, &solid, &zero, 9.0).is_none_or(|n| n.distance <= 0.0)
                };
                assert!(touches(1e-2), "{p} {:?}", solid.shape());
            }
        }
    }
}
