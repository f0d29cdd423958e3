//! Seams against the reference, torch angles by their definition, and every mistake with its address.

use crate::jobs::{WithSeam, changed, read, refusal};
use glam::DVec3;
use seamwright_document::DocumentError;
use seamwright_program::TorchPath;
use seamwright_weld::{SeamSurfaces, Welding};
use serde_json::Value;

fn vector(v: &Value) -> DVec3 {
    let a: Vec<f64> = v.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    DVec3::new(a[0], a[1], a[2])
}

/// A job for a case of the reference file.
fn job_of(case: &Value) -> String {
    let (n, b) = (&case["spec"]["nozzle"], &case["spec"]["body"]);
    let body = match b["kind"].as_str().unwrap() {
        "cylinder" => format!("cylinder = {{ radius_mm = {}, axis = [1, 0, 0] }}", b["radius"]),
        "sphere" => format!("sphere = {{ radius_mm = {} }}", b["radius"]),
        "ellipsoid" => format!("ellipsoid = {{ semi_axes_mm = {} }}", b["semi"]),
        _ => format!("plane = {{ normal = {}, point_mm = {} }}", b["normal"], b["point"]),
    };
    format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = {}\norigin_mm = {}\ndirection = {}\n\
         zero_direction = {}\nbody.{body}\n[weld]\nspeed_mm_s = 5\n",
        n["radius_mm"], n["origin_mm"], n["direction"], n["phi_zero_direction"]
    )
}

#[test]
fn seams_agree_with_the_reference() {
    let data: Value = serde_json::from_str(include_str!("../../../../tests/data/intersections.json")).unwrap();
    for case in data["cases"].as_array().unwrap() {
        let name = case["name"].as_str().unwrap();
        let welding = Welding::read(name, &job_of(case)).unwrap_or_else(|e| panic!("{e}"));
        assert!((welding.seam().length() - case["length_mm"].as_f64().unwrap()).abs() <= 1e-8);
        for row in case["rows"].as_array().unwrap() {
            let p = welding.seam().at(welding.seam().s_of_phi(row["phi_deg"].as_f64().unwrap().to_radians()).unwrap());
            assert!((p.point - vector(&row["point_mm"])).length() <= 1e-9, "{name}");
            for (found, key) in
                [(p.tangent, "tangent"), (p.n1, "nozzle_normal"), (p.n2, "body_normal"), (p.bisector, "bisector")]
            {
                assert!((found - vector(&row[key])).length() <= 1e-9, "{name} {key}");
            }
            assert!((p.dihedral.to_degrees() - row["dihedral_deg"].as_f64().unwrap()).abs() <= 1e-8, "{name}");
        }
    }
}

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");

#[test]
fn torch_angles_are_what_they_say() {
    let text = SADDLE
        .replace("work_angle_deg = 0 ", "work_angle_deg = 12 ")
        .replace("travel_angle_deg = 0 ", "travel_angle_deg = -10 ");
    let w = read(&text);
    for i in 0..100 {
        let p = w.seam().at(f64::from(i) * 16.0);
        let axis = w.path(0).along_seam().unwrap().attitude.leaning(&p, 0.0, 1.0);
        // Travel angle: asin of the axis along the direction of welding; positive drags, this one pushes.
        assert!((axis.dot(p.tangent).asin().to_degrees() + 10.0).abs() < 1e-9);
        // Work angle: in the plane across the seam, from the bisector towards the nozzle's wall.
        let across = (axis - axis.dot(p.tangent) * p.tangent).normalize();
        let wall = p.n2 - p.n2.dot(p.n1) * p.n1;
        let from_wall = across.dot(wall.normalize()).acos().to_degrees();
        assert!((from_wall - (0.5 * p.dihedral.to_degrees() - 12.0)).abs() < 1e-6, "{from_wall}");
        // The path points from the torch to the work, in the placed frame.
        let pose = w.path(0).pose(p.s);
        assert!((pose.direction + axis).length() < 1e-12);
        assert!((pose.point - (p.point + DVec3::new(0.0, 0.0, -800.0))).length() < 1e-12);
    }
}

#[test]
fn clockwise_is_the_mirror_image() {
    let (ccw, cw) = (read(SADDLE), read(&SADDLE.replace("\"counter-clockwise\"", "\"clockwise\"")));
    let length = ccw.seam().length();
    for i in 0..50 {
        let s = length * f64::from(i) / 50.0;
        let (a, b) = (ccw.seam().at(s), cw.seam().at(length - s));
        assert!((a.point - b.point).length() < 1e-9 && (a.tangent + b.tangent).length() < 1e-9);
        assert!((a.towards_first - b.towards_first).length() < 1e-9);
        let phi = a.phi.unwrap().to_degrees();
        assert!((phi - 20.0 - 360.0 * s / length).abs() < 12.0 && (cw.seam().at(s).phi.unwrap() <= 20f64.to_radians()));
    }
}

#[test]
fn parts_and_overlaps() {
    let part = read(&SADDLE.replace("overlap_mm = 20 ", "end_phi_deg = 110 "));
    assert!(!part.seam().all_round());
    assert!((part.seam().at(part.seam().weld_length()).phi.unwrap().to_degrees() - 110.0).abs() < 1e-9);
    let whole = read(SADDLE);
    assert!((whole.seam().weld_length() - whole.seam().length() - 20.0).abs() < 1e-12 && whole.seam().all_round());
    let overlap = whole.seam().at(whole.seam().length() + 7.0).point - whole.seam().at(7.0).point;
    assert!(overlap.length() < 1e-9);
}

#[test]
fn a_program_welds_like_its_job() {
    let job = read(include_str!("../../../../examples/trunnion-saddle.toml"));
    let program = read(&job.program.value.to_toml().unwrap());
    assert_eq!(job.program.value, program.program.value);
    for i in 0..40 {
        let s = f64::from(i) * 10.0;
        assert_eq!(job.path(0).pose(s), program.path(0).pose(s));
    }
}

#[test]
fn a_line_between_two_plates() {
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [300, 0, 0]\n\
        first_normal = [0, 1, 0]\nsecond_normal = [0, 0, 1]\n[torch]\nwork_angle_deg = 5\n[weld]\nspeed_mm_s = 5\n";
    let w = read(text);
    let p = w.seam().at(100.0);
    assert!((p.bisector - DVec3::new(0.0, 0.5f64.sqrt(), 0.5f64.sqrt())).length() < 1e-12);
    // Leaning towards the first part (whose face looks along y) lifts the torch off the second.
    assert!(w.path(0).along_seam().unwrap().attitude.leaning(&p, 0.0, 1.0).z > p.bisector.z && p.phi.is_none());
    let back = text.replace("[0, 0, 0]", "[300.0, 0, 0]").replace("[300, 0, 0]", "[0, 0, 0]");
    assert!(
        (read(&back).path(0).along_seam().unwrap().attitude.leaning(&read(&back).seam().at(1.0), 0.0, 1.0).z
            - w.path(0).along_seam().unwrap().attitude.leaning(&p, 0.0, 1.0).z)
            .abs()
            < 1e-12
    );
}

fn wrong(from: &str, to: &str) -> DocumentError {
    refusal(&changed(SADDLE, &[(from, to)]))
}

#[test]
fn mistakes_have_an_address() {
    let key = |from, to| wrong(from, to).key;
    assert_eq!(key("radius_mm = 250", "radius_mm = 900"), "seam.nozzle.radius_mm");
    assert_eq!(key("radius_mm = 250", "radius_mm = 800"), "seam.nozzle.radius_mm");
    assert_eq!(key("radius_mm = 250", "radius_mm = -250"), "seam.nozzle.radius_mm");
    assert_eq!(key("origin_mm = [0, 0, 0]", "origin_mm = [0, 2000, 0]"), "seam.nozzle.origin_mm");
    assert_eq!(key("direction = [0, 0, 1]", "direction = [1, 0, 0]"), "seam.nozzle.zero_direction");
    assert_eq!(key("axis = [1, 0, 0]", "axis = [0, 0, 1]"), "seam.nozzle.direction");
    assert_eq!(key("[seam.nozzle.body.cylinder]", "[seam.nozzle.body.cilinder]"), "seam.nozzle.body.cilinder");
    assert_eq!(key("overlap_mm = 20", "overlap_mm = 2000"), "start.overlap_mm");
    assert_eq!(key("overlap_mm = 20", "overlap_mm = 20\nend_phi_deg = 90"), "start.overlap_mm");
    assert_eq!(key("overlap_mm = 20 ", "end_phi_deg = 10 "), "start.end_phi_deg");
    assert_eq!(key("travel_angle_deg = 0 ", "travel_angle_deg = 80"), "torch.travel_angle_deg");
    assert_eq!(key("work_angle_deg = 0", "work_angle_deg = 95"), "torch.work_angle_deg");
    assert_eq!(key("current_a = 240", "current_a = -240"), "weld.process.current_a");
    assert_eq!(key("current_a = 240", "\"Current\" = 240"), "weld.process.Current");
    assert_eq!(key("speed_mm_s = 10", "speed_mm_s = inf"), "weld.speed_mm_s");
    let help = |from, to| wrong(from, to).help.unwrap();
    assert!(help("radius_mm = 250", "radius_in = 10").to_string().contains("given in mm"));
    assert!(help("speed_mm_s = 10", "speed_mm_min = 600").to_string().contains("given in mm/s"));
    assert!(help("overlap_mm", "overlapp_mm").to_string().contains("`overlap_mm`"));
    let table = |at: &str| wrong("work_angle_deg = 0 ", &format!("{at}\n#")).key;
    assert_eq!(table("at = [{ s_mm = 10 }, { s_mm = 5 }]"), "torch.at[1].s_mm");
    assert_eq!(table("at = [{ s_mm = 1600 }]"), "torch.at[0].s_mm");
}

#[test]
fn a_torch_inside_a_wall_is_found() {
    let w = read(&SADDLE.replace("work_angle_deg = 0 ", "work_angle_deg = 50 "));
    let findings = w.findings();
    // Half the dihedral angle is below 50 degrees near both crown points.
    assert!(findings.len() >= 2 && findings.iter().all(|f| f.kind == "access" && !f.allowed), "{findings:#?}");
    assert!(read(SADDLE).findings().is_empty());
}

#[test]
fn seams_lie_on_their_surfaces_with_their_normals() {
    let ellipse = include_str!("../../../../examples/ellipse.toml");
    let line = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [1, 2, 3]\nend_mm = [11, 2, 3]\n\
        first_normal = [0, 1, 1]\nsecond_normal = [0, -1, 3]\n[weld]\nspeed_mm_s = 5\n";
    let head = include_str!("../../../../examples/head-nozzle.toml");
    for (text, nozzle) in [
        (SADDLE, true),
        (head, true),
        (ellipse, false),
        (&ellipse.replace("\"butt\"", "\"fillet\""), false),
        (line, false),
    ] {
        let welding = read(text);
        let surfaces = SeamSurfaces::new(&welding.program, welding.program.value.seam.as_ref().unwrap()).unwrap();
        assert_eq!(surfaces.nozzle.is_some(), nozzle);
        for i in 0..100 {
            let p = welding.seam().at(welding.seam().weld_length() * f64::from(i) / 99.0);
            let (first, second) = (surfaces.first.foot(p.point), surfaces.second.foot(p.point));
            assert!(first.distance.abs() < 1e-9 && second.distance.abs() < 1e-9, "{first:?} {second:?}");
            assert!((second.normal - p.n2).length() < 1e-9);
            // In a butt joint both faces of the seam are the plate's, and the ellipse's wall stands across them.
            let butt = p.n1 == p.n2;
            assert!(butt || (first.normal - p.n1).length() < 1e-9);
            assert!(!butt || first.normal.dot(p.n1).abs() < 1e-9);
        }
    }
}

#[test]
fn an_offset_moves_the_whole_path() {
    let offset =
        "offset = \"table\"\noffsets.table = { move_mm = [5, 6, 7], turn = [0, 1, 1], angle_deg = 20 }\n[placement]";
    let (plain, moved) = (read(SADDLE), read(&SADDLE.replacen("[placement]", offset, 1)));
    let by = moved.program.value.work_offset();
    let (plain, moved) = (plain.path(0), moved.path(0));
    for i in 0..50 {
        let s = plain.length() * f64::from(i) / 49.0;
        let (a, b) = (plain.pose(s), moved.pose(s));
        assert!((by.transform_point3(a.point) - b.point).length() < 1e-11);
        assert!((by.transform_vector3(a.direction) - b.direction).length() < 1e-12);
    }
    let e = wrong("[placement]", "offset = \"table\"\n[placement]");
    assert!(e.key == "offset" && e.allowed.unwrap().to_string().contains("[offsets.table]"));
}

const GIRTH: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.girth]\nradius_mm = 90\norigin_mm = [10, -5, 30]\n\
    direction = [1, 2, 2]\nzero_direction = [2, 1, -2]\ncut_normal = [1, 1, 1]\n[weld]\nspeed_mm_s = 5\n";

/// An ellipse's perimeter by the arithmetic-geometric mean.
fn perimeter(a: f64, b: f64) -> f64 {
    let (mut x, mut y, mut power, mut sum) = (a, b, 0.5, a * a - 0.5 * (a * a - b * b));
    while (x - y).abs() > 1e-13 * a {
        let half = 0.5 * (x - y);
        (x, y, power) = (0.5 * (x + y), (x * y).sqrt(), 2.0 * power);
        sum -= power * half * half;
    }
    2.0 * std::f64::consts::PI * sum / x
}

#[test]
fn a_girth_is_an_ellipse_with_the_tubes_normals() {
    let w = read(GIRTH);
    let (axis, cut) = (DVec3::new(1.0, 2.0, 2.0) / 3.0, DVec3::ONE.normalize());
    let zero = DVec3::new(2.0, 1.0, -2.0) / 3.0;
    let centre = DVec3::new(10.0, -5.0, 30.0);
    // Semi-axes: the radius across, longer by the cosine of the cut along.
    assert!((w.seam().length() - perimeter(90.0 / axis.dot(cut), 90.0)).abs() < 1e-8);
    for i in 0..500 {
        let p = w.seam().at(w.seam().length() * f64::from(i) / 500.0);
        let phi = p.phi.unwrap();
        let out = phi.cos() * zero + phi.sin() * axis.cross(zero);
        let foot = centre + 90.0 * out;
        let expected = foot - (foot - centre).dot(cut) / axis.dot(cut) * axis;
        assert!((p.point - expected).length() < 1e-9);
        assert!((p.n1 - out).length() + (p.n2 - out).length() + (p.bisector - out).length() < 1e-12);
        assert!((p.dihedral - std::f64::consts::PI).abs() < 1e-12);
        // The first part is where the tube's direction points; the torch leans there along the surface.
        assert!(p.towards_first.dot(axis) > 0.1 && p.towards_first.dot(out).abs() < 1e-12);
        assert!(p.towards_first.dot(p.tangent).abs() < 1e-12 && (p.towards_first.length() - 1.0).abs() < 1e-12);
        assert!(p.tangent.dot(axis.cross(out)) > 0.0);
    }
    // The sign of the cut's normal and the default of a square cut.
    let back = read(&GIRTH.replace("cut_normal = [1, 1, 1]", "cut_normal = [-1, -1, -1]"));
    assert_eq!(back.seam().at(50.0), w.seam().at(50.0));
    let square = read(&GIRTH.replace("cut_normal = [1, 1, 1]\n", ""));
    assert!((square.seam().length() - 180.0 * std::f64::consts::PI).abs() < 1e-9);
    let clockwise = read(&(GIRTH.to_owned() + "[start]\ndirection = \"clockwise\"\n"));
    assert!(clockwise.seam().at(10.0).towards_first.dot(axis) > 0.1);
}

#[test]
fn girths_that_cannot_be_have_an_address() {
    let error = |from: &str, to: &str| refusal(&GIRTH.replace(from, to));
    let along = error("cut_normal = [1, 1, 1]", "cut_normal = [0, 1, -1]");
    assert_eq!((along.key.as_str(), along.line), ("seam.girth.cut_normal", 9));
    assert!(along.message.to_string().contains("90.0° off the axis"));
    assert_eq!(error("zero_direction = [2, 1, -2]", "zero_direction = [1, 2, 2]").key, "seam.girth.zero_direction");
    assert_eq!(error("radius_mm = 90", "radius_mm = 0").key, "seam.girth.radius_mm");
}

/// Across the knuckle's border only rates jump, and only there.
#[test]
fn knots_are_where_the_faces_turn_at_another_rate() {
    let knuckle = include_str!("../../../../examples/knuckle-nozzle.toml");
    let clockwise = knuckle.replace("[start]", "[start]\ndirection = \"clockwise\"");
    let around = knuckle.replace("phi_deg = 180 ", "phi_deg = 40 ").replace("overlap_mm = 15", "overlap_mm = 60");
    let part = knuckle.replace("overlap_mm = 15", "end_phi_deg = 330");
    for (text, expected) in [(knuckle, 2), (&clockwise, 2), (&around, 3), (&part, 1)] {
        let w = read(text);
        let path = w.path(0);
        let knots = w.seam().knots();
        assert_eq!(knots.len(), expected, "{knots:?}");
        assert!(knots.iter().all(|s| path.knots().contains(s)));
        assert!(knots.windows(2).all(|k| k[0] < k[1]));
        let h = 1e-4;
        let rate = |s: f64| (path.pose(s + h).direction - path.pose(s - h).direction) / (2.0 * h);
        for s in knots {
            let (before, after) = (w.seam().at(s - 1e-10), w.seam().at(s + 1e-10));
            assert!((after.tangent - before.tangent).length() < 1e-9 && (after.n2 - before.n2).length() < 1e-9);
            assert!((after.point - before.point).length() < 1e-9);
            assert!((rate(s + 2.0 * h) - rate(s - 2.0 * h)).length() > 1e-3, "no jump at {s}");
            // Crown: inside radius 800 mm and 8 mm of wall; knuckle 80 and 8: they touch this far from the axis.
            let border = 808.0 * 312.0 / 720.0;
            let p = w.seam().at(s).point;
            assert!((p.x.hypot(p.y) - border).abs() < 1e-9);
        }
    }
    assert!(read(SADDLE).seam().knots().is_empty());
}

/// The standards' radii count unless others are given, and are those of the inside.
#[test]
fn standard_heads_have_their_radii() {
    let top = |keys: &str| {
        let text = format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 50\n\
             [seam.nozzle.body.torispherical_head]\nouter_diameter_mm = 1000\n{keys}[weld]\nspeed_mm_s = 5\n"
        );
        read(&text).seam().at(0.0).point.z
    };
    // A nozzle on the axis: height of the crown's arc over the end of the knuckle.
    let arc = |crown: f64, knuckle: f64, t: f64| {
        let (crown, knuckle) = (crown + t, knuckle + t);
        (crown * crown - 2500.0).sqrt() - ((crown - knuckle).powi(2) - (500.0 - knuckle).powi(2)).sqrt()
    };
    let close = |keys: &str, z: f64| assert!((top(keys) - z).abs() < 1e-9, "{keys}: {} {z}", top(keys));
    close("thickness_mm = 10\nstandard = \"din_28011\"\n", arc(1000.0, 100.0, 10.0));
    close("thickness_mm = 10\nstandard = \"din_28013\"\n", arc(800.0, 154.0, 10.0));
    close("thickness_mm = 10\nstandard = \"asme_fd\"\n", arc(1000.0, 60.0, 10.0));
    close("thickness_mm = 30\nstandard = \"asme_fd\"\n", arc(1000.0, 90.0, 30.0));
    close("thickness_mm = 10\nstandard = \"asme_fd\"\ncrown_radius_mm = 900\n", arc(900.0, 60.0, 10.0));
    close("thickness_mm = 10\ncrown_radius_mm = 900\nknuckle_radius_mm = 120\n", arc(900.0, 120.0, 10.0));
}

#[test]
fn a_girth_from_inside_has_the_air_in_the_tube_and_the_same_first_part() {
    let axis = DVec3::new(1.0, 2.0, 2.0) / 3.0;
    let (inside, outside) = (read(&GIRTH.replace("radius_mm = 90", "radius_mm = 90\ninside = true")), read(GIRTH));
    for i in 0..200 {
        let s = inside.seam().length() * f64::from(i) / 200.0;
        let (p, q) = (inside.seam().at(s), outside.seam().at(s));
        assert!((p.point - q.point).length() < 1e-12 && (p.bisector + q.bisector).length() < 1e-12);
        assert!((p.dihedral - std::f64::consts::PI).abs() < 1e-12);
        // The first part still lies where the tube's direction points.
        assert!(p.towards_first.dot(axis) > 0.1 && p.towards_first.dot(q.towards_first) > 0.999);
    }
    let error = SeamSurfaces::new(&inside.program, inside.program.value.seam.as_ref().unwrap()).unwrap_err();
    assert_eq!(error.key, "seam.girth.inside");
}

/// A cover on a tube: the plate is the second part, the wall below it the first.
#[test]
fn an_outside_corner_has_its_air_around_the_edge() {
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\nradius_mm = 100\njoint = \"corner\"\n\
                [joint.preparation.corner]\nthickness_mm = 6\n[weld]\nspeed_mm_s = 5\n";
    let w = read(text);
    for i in 0..100 {
        let p = w.seam().at(6.0 * f64::from(i));
        let out = (p.point / 100.0).normalize();
        assert!((p.dihedral.to_degrees() - 270.0).abs() < 1e-9 && (p.n1 - out).length() < 1e-12);
        assert!((p.bisector - (out + DVec3::Z).normalize()).length() < 1e-12);
        // Down the wall, away from the cover.
        assert!((p.towards_first - (out - DVec3::Z).normalize()).length() < 1e-12, "{}", p.towards_first);
        // The groove's edges lie in their own parts: on the tube's wall below the cover, and on the cover.
        let section = w.joint.as_ref().unwrap().section(&p).unwrap();
        let place = |c: &glam::DVec2| p.point + c.x * p.towards_first + c.y * p.bisector;
        let [wall, cover] = [&section.first, &section.second].map(|edge| place(edge.last().unwrap()) - p.point);
        assert!((wall + 6.0 * DVec3::Z).length() < 1e-9 && (cover + 6.0 * out).length() < 1e-9);
    }
    let wrong = refusal(&text.replace("joint = \"corner\"", "joint = \"fillet\""));
    assert_eq!(wrong.key, "joint.preparation.corner");
}

#[test]
fn nozzles_are_set_into_ellipsoidal_heads() {
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 84.15\nwall_mm = 7.1\n\
                mount = \"set_in\"\norigin_mm = [380, 60, 0]\nbody.ellipsoidal_head = { outer_diameter_mm = 1200, \
                thickness_mm = 16, flange_mm = 40 }\n[weld]\nspeed_mm_s = 5\n";
    let toe = read(text);
    let root = read(&text.replace("mount = ", "curve = \"inner_root\"\nmount = "));
    let outside = SeamSurfaces::new(&toe.program, toe.program.value.seam.as_ref().unwrap()).unwrap().second;
    for i in 0..300 {
        let part = f64::from(i) / 300.0;
        let [on_outside, on_inside] = [&toe, &root].map(|w| w.seam().at(part * w.seam().length()));
        assert!(outside.foot(on_outside.point).distance.abs() < 1e-9);
        assert!((outside.foot(on_inside.point).distance + 16.0).abs() < 1e-9);
        // Into the vessel.
        assert!((on_inside.n2 + outside.foot(on_inside.point).normal).length() < 1e-9);
    }
    let thick = refusal(&text.replace("thickness_mm = 16", "thickness_mm = 151"));
    assert_eq!(thick.key, "seam.nozzle.body.ellipsoidal_head");
    assert_eq!(refusal(&text.replace("thickness_mm = 16, ", "")).key, "seam.nozzle.body.ellipsoidal_head.thickness_mm");
}

/// Finds the findings against the joint itself.
fn joint_findings(text: &str) -> Vec<String> {
    let findings = read(text).findings();
    findings.iter().filter(|f| f.kind == "joint").map(|f| f.message.to_string()).collect()
}

#[test]
fn joints_beside_their_standard_are_warnings() {
    let head = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[weld]\nspeed_mm_s = 5\n";
    let pipe = |preparation: &str| {
        format!("{head}[seam.girth]\nradius_mm = 100\n[joint]\nstandard = \"iso_9692_1\"\n{preparation}")
    };
    let v = "preparation.single_v = { thickness_mm = 8, angle_deg = 60, root_gap_mm = 2, root_face_mm = 1 }\n";
    assert!(joint_findings(&pipe(v)).is_empty());
    let thick = joint_findings(&pipe(&v.replace("thickness_mm = 8", "thickness_mm = 25")));
    assert_eq!(thick.len(), 1);
    assert!(thick[0].starts_with("the thickness is 25.0 mm") && thick[0].contains("3.0 mm to 10.0 mm"), "{thick:?}");
    let steep = "preparation.single_v = { thickness_mm = 25, angle_deg = 12, root_gap_mm = 7 }\n";
    assert!(joint_findings(&pipe(steep)).is_empty());
    let x = "preparation.double_v = { thickness_mm = 40, angle_deg = 30, root_gap_mm = 2 }\n";
    assert!(joint_findings(&pipe(x))[0].starts_with("the groove angle is 30.0°"));
    // Of a branch at 45 degrees: a groove of one angle fits no detail at heel and toe.
    let branch = |more: &str| {
        format!(
            "{head}[seam.branch]\nradius_mm = 84.15\nchord_radius_mm = 161.95\nangle_deg = 45\n[joint]\n\
             standard = \"aws_d1_1\"\n[joint.preparation.t_bevel]\nthickness_mm = 7.1\nangle_deg = 43\n\
             root_gap_mm = 3\n{more}"
        )
    };
    let constant = joint_findings(&branch(""));
    assert!(constant.iter().any(|f| f.contains("AWS D1.1") && f.contains("groove angle")), "{constant:?}");
    let rows = [(30, 16), (50, 30), (75, 40), (120, 45), (180, 60)];
    let rows = rows
        .map(|(dihedral, angle)| format!("[[joint.at_dihedral]]\ndihedral_deg = {dihedral}\nangle_deg = {angle}\n"));
    let following = joint_findings(&branch(&rows.concat()));
    assert!(following.is_empty(), "{following:?}");
    assert_eq!(refusal(&pipe(v).replace("iso_9692_1", "aws_d1_1")).key, "joint.standard");
    // The cover fillet of a nozzle: at least 0.7 of the wall.
    let nozzle = |leg: f64| {
        format!(
            "{head}[seam.nozzle]\nradius_mm = 100\nwall_mm = 8\nbody.plane = {{ normal = [0, 0, 1], thickness_mm = 20 }}\n\
             [joint]\nstandard = \"asme_uw_16\"\npreparation.fillet = {{ leg_mm = {leg} }}\n"
        )
    };
    assert!(joint_findings(&nozzle(8.0)).is_empty());
    let thin = joint_findings(&nozzle(7.0));
    assert!(thin.len() == 1 && thin[0].contains("5.6 mm or more"), "{thin:?}");
}

#[test]
fn joints_that_contradict_themselves_have_an_address() {
    let job = |joint: &str| {
        format!(
            "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[weld]\nspeed_mm_s = 5\n[seam.girth]\nradius_mm = 100\n[joint]\n{joint}"
        )
    };
    let x = "preparation.double_v = { thickness_mm = 40, angle_deg = 60, root_face_mm = 2 }\n";
    let cases = [
        (x.replace("root_face_mm = 2", "root_face_mm = 2, depth_mm = 38"), "joint.preparation.double_v.depth_mm"),
        (
            x.replace("angle_deg = 60", "angle_deg = 60, back_angle_deg = 175"),
            "joint.preparation.double_v.back_angle_deg",
        ),
        (format!("gouge = {{ depth_mm = 4 }}\n{x}"), "joint.gouge"),
        (format!("side = \"back\"\ngouge = {{ depth_mm = 21 }}\n{x}"), "joint.gouge.depth_mm"),
        (format!("side = \"back\"\ngouge = {{ depth_mm = 5, angle_deg = 88 }}\n{x}"), "joint.gouge.angle_deg"),
        ("side = \"back\"\npreparation.single_v = { thickness_mm = 9, angle_deg = 60 }\n".to_owned(), "joint.side"),
        (
            "preparation.double_u = { thickness_mm = 30, angle_deg = 10, radius_mm = 19 }\n".to_owned(),
            "joint.preparation.double_u.radius_mm",
        ),
        ("preparation.lap = { thickness_mm = 5, leg_mm = 6 }\n".to_owned(), "joint.preparation.lap.leg_mm"),
        ("preparation.fillet = { leg_mm = 500 }\n".to_owned(), "joint.preparation.fillet.leg_mm"),
        ("cap_mm = 400\npreparation.fillet = { leg_mm = 6 }\n".to_owned(), "joint.cap_mm"),
        (format!("{x}[[joint.at_dihedral]]\ndihedral_deg = 90\nangle_deg = 40\n"), "joint.at_dihedral"),
    ];
    for (joint, key) in cases {
        assert_eq!(refusal(&job(&joint)).key, key, "{joint}");
    }
    let back = read(&job(&format!("side = \"back\"\ngouge = {{ depth_mm = 6 }}\n{x}")));
    let section = back.joint.as_ref().unwrap().section(&back.seam().at(0.0)).unwrap();
    assert!((section.up.dot(section.first[0]) + 19.0 + 6.0).abs() < 1e-9);
}
