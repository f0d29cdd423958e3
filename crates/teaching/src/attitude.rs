use crate::smoothing::LinePoint;
use glam::DVec3;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Reach to both sides for the line's direction, mm; at an end twice as far to one side. Heights are noisier than
/// positions, and a torch that follows their noise trembles.
const REACH_MM: f64 = 6.0;

/// Torch angles at a station of the joint (`Torch` of a program).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Lean {
    /// Work angle from the surface's normal towards the first part, rad.
    pub work: f64,
    /// Travel angle, rad: positive is a drag angle.
    pub travel: f64,
    /// The first part lies on the side of normal x direction.
    pub first_is_left: bool,
}

/// Returns unit vectors from the joint to the torch at each point of a taught line. The surface normal is made
/// perpendicular to the line as measured, so it follows the measured heights, and then rotated by the angles of `lean`.
pub fn torch_axes(line: &[LinePoint], lean: &dyn Fn(&LinePoint) -> Lean) -> Vec<DVec3> {
    let axis = |(i, p): (usize, &LinePoint)| {
        let Some(along) = direction(line, i) else { return p.normal };
        let normal = p.normal.reject_from_normalized(along).try_normalize().unwrap_or(p.normal);
        let Lean { work, travel, first_is_left } = lean(p);
        let left = normal.cross(along);
        let towards_first = if first_is_left { left } else { -left };
        let across = work.cos() * normal + work.sin() * towards_first;
        travel.cos() * across + travel.sin() * along
    };
    line.iter().enumerate().map(axis).collect()
}

/// Returns the line's unit direction at point `i`, from the least-squares parabola through the points around it.
fn direction(line: &[LinePoint], i: usize) -> Option<DVec3> {
    let (way, end) = (line[i].way, line.last()?.way);
    let (low, high) = ((way - REACH_MM).max(0.0), (way + REACH_MM).min(end));
    let (low, high) = ((high - 2.0 * REACH_MM).min(low), (low + 2.0 * REACH_MM).max(high));
    let from = line.partition_point(|p| p.way < low);
    let points = &line[from..line.partition_point(|p| p.way <= high)];
    // Slightly regularised, so that two points make a line.
    let mut normal = Matrix3::from_diagonal(&Vector3::new(1e-12, 1e-12, 1e-9));
    let mut right = SMatrix::<f64, 3, 3>::zeros();
    for p in points {
        let u = (p.way - way) / REACH_MM;
        let basis = Vector3::new(1.0, u, u * u);
        normal += basis * basis.transpose();
        right += basis * Vector3::from((p.point - line[i].point).to_array()).transpose();
    }
    let found = normal.cholesky()?.solve(&right);
    DVec3::new(found[(1, 0)], found[(1, 1)], found[(1, 2)]).try_normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a circle on a cone the torch axes have the given angles, at the ends too.
    #[test]
    fn angles_are_those_of_the_surface_and_the_line() {
        let radius = 80.0;
        let at = |way: f64| DVec3::new((way / radius).cos(), (way / radius).sin(), 0.0);
        let tilt = 0.4f64;
        // The nominal normal is tilted along the line, as of a part that rises along it.
        let point = |k: u32| {
            let way = 0.5 * f64::from(k);
            let (out, along) = (at(way), DVec3::Z.cross(at(way)));
            let normal = (tilt.cos() * out + tilt.sin() * DVec3::Z + 0.01 * along).normalize();
            LinePoint { way, point: radius * out, normal, confidence: 1.0 }
        };
        let line: Vec<LinePoint> = (0..=400).map(point).collect();
        for (work, travel, first_is_left) in [(0.0, 0.0, true), (0.2, -0.1, true), (-0.3, 0.25, false)] {
            let axes = torch_axes(&line, &|_| Lean { work, travel, first_is_left });
            for (p, axis) in line.iter().zip(&axes) {
                let out = p.point / radius;
                let along = DVec3::Z.cross(out);
                let normal = tilt.cos() * out + tilt.sin() * DVec3::Z;
                let side = normal.cross(along) * if first_is_left { 1.0 } else { -1.0 };
                assert!((axis.length() - 1.0).abs() < 1e-12);
                assert!((axis.dot(along) - travel.sin()).abs() < 2e-3, "{}: {}", p.way, axis.dot(along));
                assert!((axis.dot(side) - travel.cos() * work.sin()).abs() < 2e-3, "{}", p.way);
                assert!((axis.dot(normal) - travel.cos() * work.cos()).abs() < 2e-3, "{}", p.way);
            }
        }
        // Two points define a direction; a single point keeps the surface normal.
        assert!((torch_axes(&line[..2], &|_| Lean::default())[0].dot(line[1].point - line[0].point)).abs() < 1e-4);
        assert_eq!(torch_axes(&line[..1], &|_| Lean::default()), [line[0].normal]);
    }
}
