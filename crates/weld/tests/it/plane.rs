//! Seams in a plane: points, directions and lengths against closed forms of our own, in planes that lie anyhow.

use crate::jobs::{WithSeam, refused_key, vector, with_seam};
use glam::{DMat3, DVec2, DVec3};
use proptest::prelude::*;
use seamwright_program::TorchPath;
use seamwright_weld::SeamPoint;

/// A frame that lies anyhow: its axes are the columns of a rotation about `turn`.
#[derive(Debug, Clone, Copy)]
struct Frame {
    origin: DVec3,
    axes: DMat3,
}

impl Frame {
    fn at(&self, x: f64, y: f64) -> DVec3 {
        self.origin + self.axes * DVec3::new(x, y, 0.0)
    }
}

fn frame() -> impl Strategy<Value = Frame> {
    let ball = prop::array::uniform3(-1.0..1.0f64).prop_filter("has a direction", |v| DVec3::from(*v).length() > 0.1);
    (prop::array::uniform3(-500.0..500.0f64), ball, 0.0..6.2f64).prop_map(|(origin, turn, angle)| Frame {
        origin: origin.into(),
        axes: DMat3::from_axis_angle(DVec3::from(turn).normalize(), angle),
    })
}

/// The faces of a fillet with the plate below: the wall, facing `side` (1 right, -1 left), and the plate.
fn check_faces(p: &SeamPoint, plate: DVec3, side: Option<f64>) {
    assert!((p.n2 - plate).length() < 1e-12 && p.tangent.dot(plate).abs() < 1e-9);
    let n1 = side.map_or(plate, |side| side * p.tangent.cross(plate));
    assert!((p.n1 - n1).length() < 1e-9, "{p:?}");
    let bisector = (n1 + plate).normalize();
    assert!((p.bisector - bisector).length() < 1e-9 && p.towards_first.dot(p.tangent).abs() < 1e-9);
    if side.is_some() {
        // Leaning towards the wall is leaning away from its face.
        assert!((p.towards_first - (plate - n1).normalize()).length() < 1e-9);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn circles(
        f in frame(), radius in 0.5..2000.0f64, start in -400.0..400.0f64, clockwise in any::<bool>(), fillet in any::<bool>(),
    ) {
        let (direction, joint) = (if clockwise { "clockwise" } else { "counter-clockwise" }, if fillet { "fillet" } else { "butt" });
        let w = with_seam(&format!(
            "[seam.circle]\nradius_mm = {radius:?}\ncentre_mm = {}\nnormal = {}\nzero_direction = {}\njoint = \"{joint}\"\n\
             [start]\nphi_deg = {start:?}\ndirection = \"{direction}\"\noverlap_mm = {:?}",
            vector(f.origin), vector(3.0 * f.axes.z_axis), vector(f.axes.x_axis + 0.3 * f.axes.z_axis), 0.3 * radius
        ));
        let sense = if clockwise { -1.0 } else { 1.0 };
        prop_assert!((w.seam().length() - std::f64::consts::TAU * radius).abs() < 1e-9);
        for i in 0..20 {
            let s = w.seam().weld_length() * f64::from(i) / 19.0;
            let phi = start.to_radians() + sense * s / radius;
            let p = w.seam().at(s);
            prop_assert!((p.point - f.at(radius * phi.cos(), radius * phi.sin())).length() < 1e-9);
            let tangent = sense * (f.axes * DVec3::new(-phi.sin(), phi.cos(), 0.0));
            prop_assert!((p.tangent - tangent).length() < 1e-9);
            check_faces(&p, f.axes.z_axis, fillet.then_some(sense));
            prop_assert!((p.phi.unwrap() - phi).abs() < 1e-9);
        }
    }

    #[test]
    fn arcs(
        f in frame(), radius in 0.5..2000.0f64, from in 0.0..6.2f64, sweep in 0.05..6.2f64, via in 0.05..0.95f64,
        clockwise in any::<bool>(), below in any::<bool>(), joint in 0..3,
    ) {
        let sense = if clockwise { -1.0 } else { 1.0 };
        let at = |part: f64| {
            let phi = from + sense * sweep * part;
            f.at(radius * phi.cos(), radius * phi.sin())
        };
        // The plate's normal may be on either side of the plane.
        let normal = if below { -f.axes.z_axis } else { f.axes.z_axis };
        let words = ["joint = \"butt\"", "joint = \"fillet\"", "wall_faces = \"left\""][joint as usize];
        let w = with_seam(&format!(
            "[seam.arc]\nstart_mm = {}\nvia_mm = {}\nend_mm = {}\nnormal = {}\n{words}",
            vector(at(0.0)), vector(at(via)), vector(at(1.0)), vector(normal)
        ));
        // Three points near one another lose digits of the radius.
        let lost = 1e-9 * (1.0 + 1e-2 * radius / (sweep * via * (1.0 - via)).powi(2));
        prop_assert!((w.seam().length() - sweep * radius).abs() < lost, "{}", w.seam().length() - sweep * radius);
        for i in 0..20 {
            let part = f64::from(i) / 19.0;
            let p = w.seam().at(part * w.seam().length());
            prop_assert!((p.point - at(part)).length() < lost, "{}", (p.point - at(part)).length());
            check_faces(&p, normal, [None, Some(1.0), Some(-1.0)][joint as usize]);
            prop_assert!(p.phi.is_none());
        }
    }

    #[test]
    fn rectangles(
        f in frame(), size in prop::array::uniform2(1.0..400.0f64), round in 0.0..1.0f64, start in -400.0..400.0f64,
        clockwise in any::<bool>(), fillet in any::<bool>(),
    ) {
        // A third of them sharp, or as round as can be.
        let corner = (1.5 * round - 0.25).clamp(0.0, 1.0) * 0.5 * size[0].min(size[1]);
        let (direction, joint) = (if clockwise { "clockwise" } else { "counter-clockwise" }, if fillet { "fillet" } else { "butt" });
        let w = with_seam(&format!(
            "[seam.rounded_rectangle]\nwidth_mm = {:?}\nheight_mm = {:?}\ncorner_mm = {corner:?}\ncentre_mm = {}\nnormal = {}\n\
             width_direction = {}\njoint = \"{joint}\"\n[start]\nphi_deg = {start:?}\ndirection = \"{direction}\"\noverlap_mm = {:?}",
            size[0], size[1], vector(f.origin), vector(0.5 * f.axes.z_axis), vector(f.axes.x_axis - 0.2 * f.axes.z_axis), 0.5 * size[0]
        ));
        let sense = if clockwise { -1.0 } else { 1.0 };
        prop_assert!((w.seam().length() - 2.0 * (size[0] + size[1]) + (8.0 - std::f64::consts::TAU) * corner).abs() < 1e-9);
        let half = DVec2::new(0.5 * size[0], 0.5 * size[1]);
        for i in 0..20 {
            let s = w.seam().weld_length() * (f64::from(i) + 0.5) / 20.0;
            let p = w.seam().at(s);
            let d = f.axes.transpose() * (p.point - f.origin);
            // The distance from a rounded rectangle.
            let q = d.truncate().abs() - (half - corner);
            let distance = q.max(DVec2::ZERO).length() + q.max_element().min(0.0) - corner;
            prop_assert!(distance.abs() < 1e-9 && d.z.abs() < 1e-9, "{distance} {d}");
            check_faces(&p, f.axes.z_axis, fillet.then_some(sense));
            let phi = p.phi.unwrap();
            prop_assert!((DVec2::from_angle(phi).perp_dot(d.truncate())).abs() < 1e-9);
            let turned = (phi - start.to_radians()) * sense;
            prop_assert!(turned > 0.0 && turned < 2.0 * std::f64::consts::TAU, "{turned}");
            let first = if s < w.seam().length() { s } else { s - w.seam().length() };
            prop_assert!((w.seam().s_of_phi(phi).unwrap() - first).abs() < 1e-8);
        }
        // Tangents jump at sharp corners only.
        let path = w.path(0);
        let knots = path.knots();
        prop_assert!(knots.windows(2).all(|k| k[0] < k[1]) && knots.iter().all(|k| *k > 0.0 && *k < path.length()));
        // The torch angles have one where they repeat.
        let seam = w.seam();
        let near = 1e-7;
        for k in knots.into_iter().filter(|k| (k - seam.length()).abs() > 1e-6) {
            let jump = (seam.at(k - near).tangent - seam.at(k + near).tangent).length();
            // A round corner turns the tangent by no more than the way over its radius.
            if corner > 10.0 * near {
                prop_assert!(jump < 2.001 * near / corner + 1e-9, "{jump} at {k}, corner {corner}");
            } else if corner < 1e-12 {
                prop_assert!((jump - 2.0_f64.sqrt()).abs() < 1e-6, "{jump} at {k}");
            }
        }
    }

    #[test]
    fn polylines(
        f in frame(), steps in prop::collection::vec((1.0..200.0f64, -3.0..3.0f64), 2..12), closed in any::<bool>(), joint in 0..3,
    ) {
        let (mut points, mut at, mut heading) = (vec![f.at(0.0, 0.0)], DVec2::ZERO, 0.0);
        for (length, turn) in steps {
            heading += turn;
            at += length * DVec2::from_angle(heading);
            points.push(f.at(at.x, at.y));
        }
        prop_assume!(!closed || points.len() > 2 && at.length() > 1.0);
        let list: Vec<String> = points.iter().map(|p| vector(*p)).collect();
        let words = ["joint = \"butt\"", "joint = \"fillet\"", "wall_faces = \"left\""][joint as usize];
        let w = with_seam(&format!(
            "[seam.polyline]\npoints_mm = [{}]\nclosed = {closed}\nnormal = {}\n{words}", list.join(", "), vector(f.axes.z_axis)
        ));
        if closed {
            points.push(points[0]);
        }
        let (mut s, mut corners) = (0.0, Vec::new());
        for pair in points.windows(2) {
            let length = pair[0].distance(pair[1]);
            for part in [0.1, 0.5, 0.9] {
                let p = w.seam().at(s + part * length);
                prop_assert!((p.point - pair[0].lerp(pair[1], part)).length() < 1e-9);
                prop_assert!((p.tangent - (pair[1] - pair[0]) / length).length() < 1e-9);
                check_faces(&p, f.axes.z_axis, [None, Some(1.0), Some(-1.0)][joint as usize]);
                prop_assert!(p.phi.is_none());
            }
            s += length;
            corners.push(s);
        }
        prop_assert!((w.seam().length() - s).abs() < 1e-9);
        corners.pop();
        let knots = w.path(0).knots();
        prop_assert!(knots.len() == corners.len() && knots.iter().zip(&corners).all(|(a, b)| (a - b).abs() < 1e-9));
        // The torch over a fillet would turn at once at a corner; upright over a butt joint it does not.
        let turns = w.findings().iter().filter(|f| f.kind == "turn" && !f.allowed).count();
        prop_assert!(turns == if joint == 0 { 0 } else { corners.len() }, "{turns}");
    }
}

#[test]
fn a_closed_polyline_overlaps() {
    let seam = "[seam.polyline]\npoints_mm = [[30, 0, 0], [60, 0, 0], [60, 40, 0], [0, 40, 0], [0, 0, 0]]\nclosed = true\njoint = \"butt\"\n";
    let w = with_seam(&format!("{seam}[start]\noverlap_mm = 35"));
    assert!((w.seam().weld_length() - 235.0).abs() < 1e-12);
    assert!((w.seam().at(201.0).point - DVec3::new(31.0, 0.0, 0.0)).length() < 1e-12);
    // The first point is on a straight side: no corner. The last corner is in the overlap.
    let knots = w.path(0).knots();
    assert_eq!(knots.len(), 6, "{knots:?}");
    let corner = |s: f64| (w.seam().at(s - 1e-6).tangent - w.seam().at(s + 1e-6).tangent).length() > 1e-3;
    assert_eq!(knots.iter().filter(|s| corner(**s)).count(), 5);
    assert!(corner(230.0) && !corner(200.0));
}

#[test]
fn mistakes_have_an_address() {
    let rectangle = "[seam.rounded_rectangle]\nwidth_mm = 60\nheight_mm = 40\ncorner_mm = 20\n";
    with_seam(rectangle);
    assert_eq!(refused_key(&rectangle.replace("= 20", "= 20.01")), "seam.rounded_rectangle.corner_mm");
    assert_eq!(refused_key(&rectangle.replace("= 20", "= -1")), "seam.rounded_rectangle.corner_mm");
    assert_eq!(refused_key(&rectangle.replace("= 60", "= 0")), "seam.rounded_rectangle.width_mm");
    let along = format!("{rectangle}width_direction = [0, 0, 1]");
    assert_eq!(refused_key(&along), "seam.rounded_rectangle.width_direction");
    let line = "[seam.polyline]\npoints_mm = [[0, 0, 1], [60, 0, 1], [60, 40, 1]]\n";
    with_seam(line);
    assert_eq!(refused_key("[seam.polyline]\npoints_mm = [[0, 0, 1]]"), "seam.polyline.points_mm");
    assert_eq!(
        refused_key("[seam.polyline]\nclosed = true\npoints_mm = [[0, 0, 1], [60, 0, 1]]"),
        "seam.polyline.points_mm"
    );
    assert_eq!(refused_key(&line.replace("[60, 40, 1]", "[60, 40, 1.1]")), "seam.polyline.points_mm[2]");
    assert_eq!(refused_key(&line.replace("[60, 40, 1]", "[60, 0, 1]")), "seam.polyline.points_mm[2]");
    assert_eq!(
        refused_key(&line.replace("[60, 40, 1]]", "[60, 40, 1], [0, 0, 1]]\nclosed = true")),
        "seam.polyline.points_mm[3]"
    );
    assert_eq!(refused_key(&format!("{line}closed = true\n[start]\nphi_deg = 30")), "start.phi_deg");
    assert_eq!(refused_key(&format!("{line}closed = true\n[start]\ndirection = \"clockwise\"")), "start.direction");
    assert_eq!(refused_key(&format!("{line}[start]\noverlap_mm = 1")), "start.overlap_mm");

    let circle = "[seam.circle]\nradius_mm = 10\n";
    assert_eq!(refused_key(&circle.replace("10", "0")), "seam.circle.radius_mm");
    assert_eq!(refused_key(&format!("{circle}zero_direction = [0, 0, 2]")), "seam.circle.zero_direction");
    assert_eq!(refused_key(&format!("{circle}normal = [0, 0, 0]")), "seam.circle.normal");
    assert_eq!(refused_key(&format!("{circle}[start]\noverlap_mm = 63")), "start.overlap_mm");
    let arc = "[seam.arc]\nstart_mm = [10, 0, 5]\nvia_mm = [0, 10, 5]\nend_mm = [-10, 0, 5]\n";
    with_seam(arc);
    assert_eq!(refused_key(&arc.replace("via_mm = [0, 10, 5]", "via_mm = [3, 0, 5]")), "seam.arc.via_mm");
    assert_eq!(refused_key(&arc.replace("end_mm = [-10, 0, 5]", "end_mm = [10, 0, 5]")), "seam.arc.via_mm");
    assert_eq!(refused_key(&format!("{arc}normal = [0.01, 0, 1]")), "seam.arc.normal");
    assert_eq!(refused_key(&format!("{arc}[start]\nphi_deg = 10")), "start.phi_deg");
    assert_eq!(refused_key(&format!("{arc}[start]\ndirection = \"clockwise\"")), "start.direction");
}
