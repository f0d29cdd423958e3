//! Nozzles with a wall: toe and root against the bodies' own functions, the air that the torch comes through, the part,
//! and mistakes.

use crate::jobs::{WithSeam, job};
use crate::part::{NO_STL, distance};
use glam::DVec3;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::Edge;
use seamwright_program::Seam;
use seamwright_testkit::{Random, cases};
use seamwright_weld::{Cut, Job, NozzleEdges, SeamSurfaces, Welding};
use std::f64::consts::TAU;

fn document(seam: &str) -> Document<Job> {
    Job::read("job.toml", &job(seam)).unwrap_or_else(|e| panic!("{e}"))
}

/// A random nozzle with a wall on a body, and its properties computed without the library.
struct Case {
    /// Keys of the nozzle but mount and curve, and the body's table.
    nozzle: String,
    body: String,
    radius: f64,
    wall: f64,
    thickness: f64,
    origin: DVec3,
    direction: DVec3,
    zero: DVec3,
    /// Distance from the body's outside: negative within.
    level: Box<dyn Fn(DVec3) -> f64>,
}

impl Case {
    fn random(random: &mut Random, kind: usize) -> Self {
        let (axis, at, size) = (random.direction(), 500.0 * random.direction(), random.within(100.0, 800.0));
        let thickness = size * random.within(0.01, 0.15);
        let across = random.direction().reject_from_normalized(axis).normalize();
        let list = |v: DVec3| format!("{:?}", v.to_array());
        let radius = size * random.within(0.05, 0.4);
        let thick = format!("thickness_mm = {thickness}\n");
        let (body, level, foot, out): (String, Box<dyn Fn(DVec3) -> f64>, DVec3, DVec3) = match kind {
            0 => (
                format!("cylinder]\nradius_mm = {size}\npoint_mm = {}\naxis = {}\n{thick}", list(at), list(axis)),
                Box::new(move |p| (p - at).cross(axis).length() - size),
                at + random.within(-300.0, 300.0) * axis,
                across,
            ),
            1 => (
                format!("sphere]\nradius_mm = {size}\ncentre_mm = {}\n{thick}", list(at)),
                Box::new(move |p| p.distance(at) - size),
                at,
                across,
            ),
            2 => (
                format!("plane]\npoint_mm = {}\nnormal = {}\n{thick}", list(at), list(axis)),
                Box::new(move |p| (p - at).dot(axis)),
                at + random.within(-300.0, 300.0) * across,
                axis,
            ),
            3 => {
                let half = random.within(20.0, 50.0f64);
                let (sin, cos) = half.to_radians().sin_cos();
                (
                    format!("cone]\nhalf_angle_deg = {half}\napex_mm = {}\naxis = {}\n{thick}", list(at), list(axis)),
                    Box::new(move |p| {
                        let q = p - at;
                        q.cross(axis).length() * cos - q.dot(axis) * sin
                    }),
                    at + size / half.to_radians().tan() * axis,
                    across,
                )
            }
            _ => {
                let ring = size * random.within(1.5, 4.0);
                (
                    format!(
                        "torus]\nbend_radius_mm = {ring}\nradius_mm = {size}\ncentre_mm = {}\naxis = {}\n{thick}",
                        list(at),
                        list(axis)
                    ),
                    Box::new(move |p| {
                        let q = p - at;
                        (q.cross(axis).length() - ring).hypot(q.dot(axis)) - size
                    }),
                    at + ring * across,
                    across,
                )
            }
        };
        let direction = (out + random.within(0.0, 0.3) * random.direction()).normalize();
        let zero = random.direction().reject_from_normalized(direction).normalize();
        let wall = radius * random.within(0.02, 0.5);
        let nozzle = format!(
            "[seam.nozzle]\nradius_mm = {radius}\nwall_mm = {wall}\norigin_mm = {}\ndirection = {}\nzero_direction = {}\n",
            list(foot),
            list(direction),
            list(zero)
        );
        let body = format!("[seam.nozzle.body.{body}");
        Self { nozzle, body, radius, wall, thickness, origin: foot, direction, zero, level }
    }

    fn seam(&self, mount: &str, curve: &str) -> String {
        format!("{}mount = \"{mount}\"\ncurve = \"{curve}\"\n{}", self.nozzle, self.body)
    }

    /// Distance from the nozzle's axis.
    fn rho(&self, p: DVec3) -> f64 {
        (p - self.origin).cross(self.direction).length()
    }

    fn gradient(&self, p: DVec3) -> DVec3 {
        let h = 1e-4;
        DVec3::from_array(DVec3::AXES.map(|e| ((self.level)(p + h * e) - (self.level)(p - h * e)) / (2.0 * h)))
            .normalize()
    }

    /// True in the air at a root.
    fn air(&self, set_in: bool, p: DVec3) -> bool {
        match set_in {
            true => (self.level)(p) < -self.thickness && self.rho(p) > self.radius,
            false => (self.level)(p) > 0.0 && self.rho(p) < self.radius - self.wall,
        }
    }
}

fn edges(seam: &str) -> Result<NozzleEdges, DocumentError> {
    let file = document(seam);
    let Seam::Nozzle(nozzle) = &file.value.seam else { panic!() };
    NozzleEdges::new(&file, nozzle)
}

/// Checks a curve's point: at this radius and depth below the body's outside, at this angle.
fn on(case: &Case, edge: &dyn Edge, phi: f64, radius: f64, depth: f64) {
    let e = edge.edge(phi);
    assert!((case.rho(e.point) - radius).abs() < 1e-9, "{}", case.rho(e.point) - radius);
    assert!(((case.level)(e.point) + depth).abs() < 1e-9, "{}", (case.level)(e.point) + depth);
    let out = (e.point - case.origin).reject_from_normalized(case.direction).normalize();
    let angle = case.direction.dot(case.zero.cross(out)).atan2(case.zero.dot(out));
    assert!(((angle - phi).sin()).abs() < 1e-12 && (angle - phi).cos() > 0.0);
    // It is the way out along the nozzle: beyond it the body is below this depth.
    for i in 1..60 {
        let beyond = e.point + 0.05 * radius * f64::from(i) * case.direction;
        assert!((case.level)(beyond) > -depth - 1e-9, "{}", case.body);
    }
}

#[test]
fn toe_and_root_lie_on_their_surfaces_and_face_the_air() {
    let mut random = Random::new(71);
    let mut made = [0; 2];
    for i in 0..cases(1000) {
        let case = Case::random(&mut random, i % 5);
        for (k, mount) in ["set_on", "set_in"].into_iter().enumerate() {
            let set_in = k == 1;
            // A nozzle that is too wide is refused; that is tested elsewhere.
            let Ok(pair) = edges(&case.seam(mount, "outer_toe")) else { continue };
            made[k] += 1;
            for _ in 0..3 {
                let phi = random.within(0.0, TAU);
                on(&case, pair.outer_toe.as_ref(), phi, case.radius, 0.0);
                let root_radius = if set_in { case.radius } else { case.radius - case.wall };
                on(&case, pair.inner_root.as_ref(), phi, root_radius, if set_in { case.thickness } else { 0.0 });
                let (toe, root) = (pair.outer_toe.edge(phi), pair.inner_root.edge(phi));
                let away = (root.point - case.origin).reject_from_normalized(case.direction).normalize();
                let (n1, n2) =
                    if set_in { (away, -case.gradient(root.point)) } else { (-away, case.gradient(root.point)) };
                assert!((root.n1 - n1).length() < 1e-8 && (root.n2 - n2).length() < 1e-7, "{}", case.body);
                assert!((toe.n1 - away).length() < 1e-8 && (toe.n2 - case.gradient(toe.point)).length() < 1e-7);
                // Just before the joint there is air, just behind it metal.
                let bisector = (root.n1 + root.n2).normalize();
                let step = 1e-4 * (case.radius - case.wall) * (root.n1 + root.n2).length();
                assert!(case.air(set_in, root.point + step * bisector), "{}", case.body);
                assert!(!case.air(set_in, root.point - step * bisector));
                // Out of a bore the torch leans to its axis and up; in a vessel away from the nozzle and inwards.
                assert!(root.n1.dot(bisector) > 0.0 && root.n2.dot(bisector) > 0.0);
            }
        }
    }
    println!("{made:?} nozzles");
    assert!(made.iter().all(|m| *m > cases(600)), "{made:?}");
}

#[test]
fn the_seam_is_the_curve_asked_for() {
    let mut random = Random::new(72);
    let mut made = 0;
    for i in 0..cases(200) {
        let case = Case::random(&mut random, i % 5);
        for mount in ["set_on", "set_in"] {
            let Ok(pair) = edges(&case.seam(mount, "outer_toe")) else { continue };
            let welded = |curve: &str| Welding::read("job.toml", &job(&case.seam(mount, curve))).unwrap();
            for (welding, edge) in [(welded("outer_toe"), &pair.outer_toe), (welded("inner_root"), &pair.inner_root)] {
                made += 1;
                let p = welding.seam().at(random.within(0.0, 1.0) * welding.seam().length());
                let e = edge.edge(p.phi.unwrap());
                assert!(p.point.distance(e.point) < 1e-9);
                assert!((p.dihedral - (std::f64::consts::PI - e.n1.angle_between(e.n2))).abs() < 1e-7);
                // Towards the first part: off its air, along its normal backwards, whichever way the curve runs.
                assert!(p.towards_first.dot(p.n1) <= 1e-9 && p.towards_first.dot(p.n2) >= -1e-9);
                assert!((p.towards_first - (e.n2 - e.n1).normalize()).length() < 1e-6);
            }
            assert_eq!(welded("outer_toe").cut.is_some(), mount == "set_on");
        }
    }
    assert!(made > cases(400), "{made}");
}

const HEADS: [&str; 5] = [
    "torispherical_head]\nouter_diameter_mm = 1000\nthickness_mm = 12\nstandard = \"din_28011\"\nflange_mm = 40\n",
    "torispherical_head]\nouter_diameter_mm = 1000\nthickness_mm = 8\nstandard = \"din_28013\"\nflange_mm = 40\n",
    "hemispherical_head]\nouter_diameter_mm = 1000\nthickness_mm = 20\nflange_mm = 100\n",
    "flat_head]\nouter_diameter_mm = 1000\nthickness_mm = 15\nknuckle_radius_mm = 90\nflange_mm = 100\n",
    "conical_head]\nouter_diameter_mm = 1000\nthickness_mm = 10\nhalf_angle_deg = 50\nknuckle_radius_mm = 80\n",
];

/// The inside of a head is everywhere its thickness from the outside.
#[test]
fn roots_in_heads_are_a_thickness_below_the_outside() {
    let mut random = Random::new(73);
    let mut made = 0;
    for i in 0..cases(150) {
        let body = HEADS[i % HEADS.len()];
        let thickness: f64 = body.split("thickness_mm = ").nth(1).unwrap().split('\n').next().unwrap().parse().unwrap();
        let (x, y, tilt) = (random.within(-330.0, 330.0), random.within(-150.0, 150.0), random.within(-0.3, 0.3));
        let seam = format!(
            "[seam.nozzle]\nradius_mm = {}\nmount = \"set_in\"\norigin_mm = [{x}, {y}, 0]\ndirection = [{tilt}, 0, 1]\n\
             [seam.nozzle.body.{body}",
            random.within(20.0, 100.0)
        );
        let Ok(pair) = edges(&seam) else { continue };
        made += 1;
        let file = document(&seam);
        let outside = SeamSurfaces::new(&file, &file.value.seam).unwrap().second;
        for _ in 0..8 {
            let e = pair.inner_root.edge(random.within(0.0, TAU));
            let foot = outside.foot(e.point);
            assert!((foot.distance + thickness).abs() < 1e-9, "{} {seam}", foot.distance);
            assert!((foot.normal + e.n2).length() < 1e-9);
        }
    }
    assert!(made > cases(120), "{made}");
}

/// The air at a root is free in the part made from it, and the metal behind it is solid.
#[test]
fn the_part_is_hollow_around_a_root() {
    let nozzle = |mount: &str| {
        format!(
            "[seam.nozzle]\nradius_mm = 60\nwall_mm = 8\nmount = \"{mount}\"\ncurve = \"inner_root\"\norigin_mm = [20, 10, 0]\n"
        )
    };
    let mut bodies: Vec<String> = HEADS.map(str::to_owned).to_vec();
    bodies.extend(
        [
            "cylinder]\nradius_mm = 300\nthickness_mm = 12\n",
            "sphere]\nradius_mm = 300\nthickness_mm = 12\n",
            "plane]\nnormal = [0, 0.2, 1]\nthickness_mm = 12\n",
            "cone]\nhalf_angle_deg = 30\nthickness_mm = 12\napex_mm = [-500, 0, 0]\naxis = [1, 0, 0]\n",
        ]
        .map(str::to_owned),
    );
    for mount in ["set_on", "set_in"] {
        for body in &bodies {
            let text = job(&format!("{}[seam.nozzle.body.{body}", nozzle(mount)));
            let welding = Welding::read("job.toml", &text).unwrap_or_else(|e| panic!("{e}"));
            let part = welding.clamped(NO_STL).unwrap_or_else(|e| panic!("{e}")).part;
            assert_eq!(part.len(), 2);
            for i in 0..16 {
                let p = welding.seam().at(welding.seam().length() * f64::from(i) / 16.0);
                assert!(distance(&part, p.point) < 0.15, "{body}");
                for d in [1.0, 4.0] {
                    let (free, wide) = (distance(&part, p.point + d * p.bisector), d * (0.5 * p.dihedral).sin());
                    assert!((free - wide).abs() < 0.16 + 0.02 * d * d, "{free} for {wide}: {mount} {body}");
                }
                assert!(distance(&part, p.point - 1.0 * p.bisector) < 2e-3, "{mount} {body}");
            }
            // A long way up the bore, or in the middle of the vessel, there is air.
            let middle = DVec3::new(20.0, 10.0, if mount == "set_on" { 1.0 } else { 0.0 });
            let heights = (0..90).map(|i| welding.seam().at(welding.seam().length() * f64::from(i) / 90.0).point.z);
            let high = heights.fold(f64::NEG_INFINITY, f64::max) + 30.0;
            let at = if mount == "set_on" { middle.with_z(high) } else { DVec3::new(250.0, 0.0, -60.0) };
            let room = distance(&part, at);
            let inside_vessel = mount == "set_in" && !body.starts_with("cone") && !body.starts_with("sphere");
            assert!(mount == "set_in" && !inside_vessel || room > 10.0, "{room} {mount} {body}");
        }
    }
}

#[test]
fn unrolled_ends_roll_back_onto_the_seam() {
    let mut random = Random::new(74);
    let mut made = 0;
    for i in 0..cases(100) {
        let case = Case::random(&mut random, i % 5);
        let file = document(&case.seam("set_on", "outer_toe"));
        let Ok(Some(cut)) = Cut::new(&file, &file.value.seam) else { continue };
        made += 1;
        let inside = cut.inside.unwrap();
        assert!((inside.radius - (case.radius - case.wall)).abs() < 1e-12 * case.radius);
        for side in [&cut.outside, &inside] {
            assert_eq!(side.points.len(), 361);
            for p in &side.points {
                let phi = p.around / side.radius;
                let y = case.direction.cross(case.zero);
                let at =
                    case.origin + side.radius * (phi.cos() * case.zero + phi.sin() * y) + p.height * case.direction;
                assert!((case.level)(at).abs() < 1e-8, "{}", (case.level)(at));
                let away = (phi.cos() * case.zero + phi.sin() * y).normalize();
                let between = std::f64::consts::PI - away.angle_between(case.gradient(at));
                assert!((p.dihedral - between).abs() < 1e-6);
            }
        }
    }
    assert!(made > cases(60), "{made}");
}

/// The error of a nozzle with these keys: its key, and the allowed values.
fn error(keys: &str, body: &str) -> (String, String, String) {
    let text = job(&format!("[seam.nozzle]\nradius_mm = 50\n{keys}[seam.nozzle.body.{body}"));
    let e = Welding::read("job.toml", &text).unwrap_err();
    assert!(e.line > 0 && e.to_string().contains("allowed: "), "{e}");
    (e.key.clone(), e.value.clone(), e.allowed.unwrap().to_string())
}

#[test]
fn mistakes_have_an_address_and_a_cure() {
    let cylinder = "cylinder]\nradius_mm = 200\n";
    let check = |keys: &str, body: &str, key: &str, allowed: &str| {
        let found = error(keys, body);
        assert_eq!(found.0, key, "{found:?}");
        assert!(found.2.contains(allowed), "{found:?}");
        found.1
    };
    for wall in ["50", "80"] {
        for keys in [format!("wall_mm = {wall}\n"), format!("wall_mm = {wall}\ncurve = \"inner_root\"\n")] {
            assert_eq!(check(&keys, cylinder, "seam.nozzle.wall_mm", "less than radius_mm = 50"), wall);
        }
    }
    check("curve = \"inner_root\"\n", cylinder, "seam.nozzle.wall_mm", "less than radius_mm = 50");
    check("mount = \"on_top\"\n", cylinder, "seam.nozzle.mount", "set_on");
    check("curve = \"middle\"\n", cylinder, "seam.nozzle.curve", "inner_root");
    let set_in = "mount = \"set_in\"\n";
    let thick = "seam.nozzle.body.cylinder.thickness_mm";
    check(set_in, cylinder, thick, "less than radius_mm = 200");
    for thickness in ["200", "250.5"] {
        let body = format!("{cylinder}thickness_mm = {thickness}\n");
        assert_eq!(check(set_in, &body, thick, "less than radius_mm = 200"), thickness);
    }
    check(set_in, "plane]\nnormal = [0, 0, 1]\n", "seam.nozzle.body.plane.thickness_mm", "more than 0");
    check(set_in, "sphere]\nradius_mm = 200\nthickness_mm = 201\n", "seam.nozzle.body.sphere.thickness_mm", "200");
    let bend = "torus]\nbend_radius_mm = 500\nradius_mm = 200\naxis = [1, 0, 0]\n";
    check(set_in, bend, "seam.nozzle.body.torus.thickness_mm", "radius_mm = 200");
    let cone = "cone]\nhalf_angle_deg = 30\naxis = [1, 0, 0]\napex_mm = [-600, 0, 0]\n";
    check(set_in, cone, "seam.nozzle.body.cone.thickness_mm", "more than 0");
    let half = "hemispherical_head]\nouter_diameter_mm = 400\n";
    let key = "seam.nozzle.body.hemispherical_head.thickness_mm";
    check(set_in, half, key, "half of outer_diameter_mm = 400");
    check(set_in, &format!("{half}thickness_mm = 200\n"), key, "half of outer_diameter_mm = 400");
    // The wall takes so much that the nozzle no longer fits inside.
    check(set_in, &format!("{cylinder}thickness_mm = 155\n"), "seam.nozzle.radius_mm", "inside of the wall");
    for body in ["ellipsoid]\nsemi_axes_mm = [300, 300, 150]\n", "ellipsoidal_head]\nouter_diameter_mm = 600\n"] {
        let (kind, _) = body.split_once(']').unwrap();
        let key = format!("seam.nozzle.body.{kind}.thickness_mm");
        check(
            set_in,
            body,
            &key,
            if kind == "ellipsoid" { "more than 0 mm" } else { "half of outer_diameter_mm = 600" },
        );
        // Set on, its root is on the outside.
        let text =
            format!("[seam.nozzle]\nradius_mm = 50\nwall_mm = 5\ncurve = \"inner_root\"\n[seam.nozzle.body.{body}");
        assert!(edges(&text).is_ok());
    }
    // Errors of required keys list the allowed values, too.
    check(
        "",
        "flat_head]\nouter_diameter_mm = 400\nknuckle_radius_mm = 30\n",
        "seam.nozzle.body.flat_head.thickness_mm",
        "thickness_mm",
    );
}
